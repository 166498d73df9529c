// An image as a page shows it: with its defects marked.
#pragma once

#include <string>
#include <vector>

#include "image/image_file.hpp"
#include "viewer/live_section.hpp"

namespace flashbvh::tool {

/// A mesh of a page and its odd triangles and edges.
struct Subject {
  explicit Subject(const ImageFile& image);

  std::vector<LiveMarks> marks;
  std::vector<std::string> warnings;  ///< without the image's name
};

}  // namespace flashbvh::tool
