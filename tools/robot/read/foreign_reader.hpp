// Runs the programs that read robots of forms other than URDF.
#pragma once

#include <string>

namespace flashbvh::tool {

/// The end of messages about files that can't be read.
constexpr const char* kForeignFix = "; correct it, or convert it to a URDF";

struct ForeignForm {
  const char* root;  ///< its outermost element
  const char* name;
  const char* reader;  ///< the program
};

/// The output of the form's reader for the file. UserError if the reader is missing or fails.
std::string text_of_reader(const ForeignForm& form, const std::string& path);

}  // namespace flashbvh::tool
