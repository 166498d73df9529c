// Coarser versions of links with very many triangles. They choose joint zones and are used in no
// proof.
#pragma once

#include <optional>

#include "robot/matrix/baked_part.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

struct Approximation {
  ModelLink link;
  BakedPart baked;
  double length = 0;  ///< largest distance from the link's mesh, in metres
};

/// For links next to joints with many triangles, within a part of the distance that counts as
/// contact, while time lasts.
std::vector<std::optional<Approximation>> approximations(const Model& model, double cell,
                                                         const MatrixOptions& options);

}  // namespace flashbvh::tool
