// Names of statuses, in a file of its own: firmware that never prints them does not link the text.
#include "flashbvh/status.hpp"

using namespace flashbvh;

#define FLASHBVH_CASE(name, NAME) \
  case Status::name:              \
    return #name;

// No default case, so that the compiler reports a status without a name.
const char* flashbvh_status_name(flashbvh_status status) {
  switch (static_cast<Status>(status)) { FLASHBVH_FOR_EACH_STATUS(FLASHBVH_CASE) }
  return "unknown";
}
