// A baked image as source: a constant array of words, and a header of constants for firmware's
// compiler. Both are C99 and C++; an image has the same text on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "image/output_name.hpp"

namespace flashbvh::tool {

struct SourceFiles {
  std::string header;  ///< NAME.fbvh.h
  std::string source;  ///< NAME.fbvh.c
};

/// `unit`: the name of the unit of length; empty if unknown. All names in the text begin with the
/// mesh's, but the include guard's holds it. Names of two meshes never coincide: no name's rest
/// ends in '_' and another's rest.
SourceFiles mesh_in_c(const std::vector<std::uint32_t>& image, const OutputName& name,
                      const std::string& unit);

/// "0x00ffu" for 255 and four digits.
std::string hex(std::uint64_t value, unsigned digits);

/// "#define WORD_NAME VALUE /* COMMENT */".
struct Count {
  const char* name;
  std::size_t value;
  const char* comment;
};
std::string count_macros(const std::string& word, const std::vector<Count>& counts);

/// Two macros. `unit`: as for mesh_in_c().
std::string cell_macros(const std::string& word, double cell, const std::string& unit);

/// The frame of a text about an image.
struct SourceFrame {
  const char* command;    ///< the command that writes it
  std::string extension;  ///< of the image, as in ".fbvh"
  std::string array;      ///< its name
  std::string array_comment;
};
/// `about`: the header's text.
SourceFiles image_in_c(const std::vector<std::uint32_t>& image, const OutputName& name,
                       const SourceFrame& frame, const std::string& about);

}  // namespace flashbvh::tool
