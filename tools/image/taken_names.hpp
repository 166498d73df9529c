// Names that a namespace of the user can't have, whatever the firmware includes before it.
#ifndef FLASHBVH_TOOLS_IMAGE_TAKEN_NAMES_HPP
#define FLASHBVH_TOOLS_IMAGE_TAKEN_NAMES_HPP

#include <string>

namespace flashbvh::tool {

/// Whether C or C++ takes `name`, an identifier, for itself in some way: keywords, macros, and what
/// headers of C and POSIX declare outside the namespace std.
bool is_taken(const std::string& name);

}  // namespace flashbvh::tool

#endif
