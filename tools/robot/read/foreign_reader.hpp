// The programs that read robots of forms other than URDF.
#pragma once

#include <string>

namespace flashbvh::tool {

struct ForeignForm {
  const char* root;  ///< its outermost element
  const char* name;
  const char* reader;  ///< the program
};

/// What the form's reader prints of the file. UserError if there is no reader, or if it fails.
std::string text_of_reader(const ForeignForm& form, const std::string& path);

}  // namespace flashbvh::tool
