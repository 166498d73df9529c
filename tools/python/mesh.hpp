// Meshes as Python holds them: to be baked, and baked.
#pragma once

#include <memory>
#include <optional>

#include "image/image_file.hpp"
#include "mesh/import.hpp"

namespace flashbvh::python {

/// A mesh to be baked.
struct Mesh {
  tool::InputMesh input;
  std::optional<double> cell;  ///< that it is to be baked with
};

/// A baked one.
using Baked = tool::ImageFile;

}  // namespace flashbvh::python
