// An image and its data for a page.
#pragma once

#include <string>
#include <vector>

#include "image/image_file.hpp"
#include "live/live_section.hpp"
#include "report/html.hpp"

namespace flashbvh::tool {

/// A box of the tree in cells of the mesh's frame.
struct NodeBox {
  LatticePoint lower;
  LatticePoint upper;
};

/// The box of a node of a tree.
template <class Tree>
NodeBox node_box(const Tree& tree, std::uint32_t node) {
  const std::int64_t x = tree.origin[0];
  const std::int64_t y = tree.origin[1];
  const std::int64_t z = tree.origin[2];
  const auto box = unpack(tree.nodes[node].box);
  return {{x + box.lower.x, y + box.lower.y, z + box.lower.z},
          {x + box.upper.x, y + box.upper.y, z + box.upper.z}};
}

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
