// An image and its data for a page.
#pragma once

#include <string>
#include <vector>

#include "image/image_file.hpp"
#include "live/live_section.hpp"
#include "report/html.hpp"

namespace flashbvh::tool {

/// A box of a tree in cells of the mesh's frame.
struct NodeBox {
  LatticePoint lower;
  LatticePoint upper;
};

/// The box of a tree's root.
NodeBox root_box(const AnyTree& any);

/// A defect of the lattice mesh.
struct Warning {
  LiveMarks marks;   ///< its lines in the page
  std::string text;  ///< a sentence
};

struct Subject {
  /// `place`: the image's index in the page; `unique_name`: without folder, unique in the page.
  Subject(const ImageFile& file, std::size_t place, std::string unique_name);

  const ImageFile& image;
  std::size_t number;
  std::string name;
  std::uint64_t flash;  ///< size of the image in bytes
  NodeBox box;          ///< of the whole mesh
  std::vector<Warning> warnings;
  std::size_t left_out;  ///< triangles that `bake --drop` left out, except trailing ones
};

Measure measure_of(const ImageFile& image);

/// Names of the image files; equal names get numbers.
std::vector<std::string> unique_names(const std::vector<std::string>& paths);

}  // namespace flashbvh::tool
