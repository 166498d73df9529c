// Replaces foreign_reader.cpp in programs that are built without readers.
#include "robot/read/foreign_reader.hpp"

#include "text/messages.hpp"

namespace flashbvh::tool {

std::string text_of_reader(const ForeignForm& form, const std::string& path) {
  throw UserError(path, "is ", form.name, "; this build of flashbvh reads no ", form.name,
                  ": convert the file to a URDF, or install flashbvh on Debian");
}

}  // namespace flashbvh::tool
