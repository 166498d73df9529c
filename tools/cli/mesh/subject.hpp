// An image as a page shows it: with its defects marked.
#pragma once

#include <string>
#include <vector>

#include "cli/json.hpp"
#include "image/image_file.hpp"

namespace flashbvh::tool {

/// A mesh of a page and its odd triangles and edges.
struct Subject {
  explicit Subject(const ImageFile& image);

  Json marks =
      Json::array();  ///< of each a colour of the page, and vertices, of which two make a line
  std::vector<std::string> warnings;  ///< without the image's name
};

}  // namespace flashbvh::tool
