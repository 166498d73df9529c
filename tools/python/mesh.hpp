// Meshes of the Python package, before and after baking.
#pragma once

#include <memory>
#include <optional>

#include "image/image_file.hpp"
#include "mesh/import.hpp"

namespace flashbvh::python {

/// A mesh before baking.
struct Mesh {
  tool::InputMesh input;
  std::optional<double> cell;  ///< for baking
};

/// A baked mesh.
using Baked = tool::ImageFile;

}  // namespace flashbvh::python
