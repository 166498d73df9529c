// A coarser link in place of one with very many triangles, where no more is wanted than about where
// it touches: which zone is chosen, not what is proven.
#pragma once

#include <optional>

#include "robot/matrix/baked_part.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

struct StandIn {
  ModelLink link;
  BakedPart baked;
  double length = 0;  ///< in metres, within which it lies of the link's mesh
};

/// Within `length`, source by source, shell by shell. None if the link has few triangles, the cell
/// is hardly finer than that, or shells would not be the same ones.
std::optional<StandIn> stand_in(const ModelLink& link, double cell, double length);

/// Of links next to joints, within a part of the distance at which they touch; as long as there is
/// time.
std::vector<std::optional<StandIn>> stand_ins(const Model& model, double cell,
                                              const MatrixOptions& options);

}  // namespace flashbvh::tool
