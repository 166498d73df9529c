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

/// Coarsens within `length`, source by source, shell by shell. None if the link has few triangles,
/// `length` is only a few cells, or the number of shells changes.
std::optional<Approximation> approximation(const ModelLink& link, double cell, double length);

/// For links next to joints, within a part of the distance that counts as contact, while time
/// lasts.
std::vector<std::optional<Approximation>> approximations(const Model& model, double cell,
                                                         const MatrixOptions& options);

}  // namespace flashbvh::tool
