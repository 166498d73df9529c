#include "support/compiled_queries.hpp"

namespace flashbvh {

FLASHBVH_COMPILED_QUERIES(, uint16_t);
FLASHBVH_COMPILED_QUERIES(, uint32_t);

}  // namespace flashbvh
