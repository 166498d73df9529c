// An image and what a page says of it.
#ifndef FLASHBVH_TOOLS_REPORT_SUBJECT_HPP
#define FLASHBVH_TOOLS_REPORT_SUBJECT_HPP

#include <string>
#include <vector>

#include "image/image_file.hpp"
#include "report/raster.hpp"
#include "report/tree_shape.hpp"

namespace flashbvh::tool {

struct Subject {
  /// `number`: counts the page's images; `name`: without folder, unlike those of the others.
  Subject(const ImageFile& file, std::size_t place, std::string unique_name);

  const ImageFile& image;
  std::size_t number;
  std::string name;
  TreeShape shape;
  TriangleSoup triangles;
  detail::Box box;
  /// What is odd about the lattice mesh: a sentence each, as HTML.
  std::vector<std::string> warnings;
};

/// Names of the image files, numbered where they are the same.
std::vector<std::string> unique_names(const std::vector<std::string>& paths);

}  // namespace flashbvh::tool

#endif
