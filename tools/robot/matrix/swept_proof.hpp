// A proof that spares the joints next to the two links: where what a link sweeps in a full turn
// about such a joint meets nothing, the joint's angle does not matter.
//
// A link that turns about its own axis by a large range makes many cells and hardly moves. Its
// solid of revolution is as near to all else whatever the angle, so a dimension is gone.
#ifndef FLASHBVH_TOOLS_ROBOT_MATRIX_SWEPT_PROOF_HPP
#define FLASHBVH_TOOLS_ROBOT_MATRIX_SWEPT_PROOF_HPP

#include <cstdint>
#include <functional>

#include "robot/matrix/matrix.hpp"

namespace flashbvh::tool {

/// Whether the links are proven never to come within `distance` cells, or to meet, by their solids
/// of revolution or that of one of them. False says nothing. `cells` is increased by those looked
/// at. `cell`: with which their meshes are baked.
bool is_proven_swept(const Model& model, std::size_t a, std::size_t b, double cell,
                     const MatrixOptions& options, const std::function<void(double)>& progress,
                     std::uint64_t& cells, double distance = 0);

}  // namespace flashbvh::tool

#endif
