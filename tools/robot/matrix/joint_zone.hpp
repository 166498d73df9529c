// Joint zones. Two links that a joint holds together touch about it, wherever it stands. What of
// them lies outside a zone about the joint is decided, and guarded, as any pair is; what lies
// inside is not looked at, and said not to be.
//
// The zone is as small as what touches, over the joint's range: where it grows towards a limit, a
// real collision may be there. Shells of a link that touch the other link at some values alone (a
// post on a table) have no zone: they are looked at everywhere.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/zone_side.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// What of one link is not to meet what of the other, in the links' frames, in metres.
struct ZoneBodies {
  bake::SourceMesh mesh_a;  ///< triangles are cut at the zone
  bake::SourceMesh mesh_b;
  BakedPart a;
  BakedPart b;
};

struct JointZone {
  std::size_t a;  ///< links, a below b
  std::size_t b;
  std::size_t joint;  ///< the only one between
  ZoneShape shape;
  /// All that is not in the zone: what lies outside it of the shells that touch; other shells and
  /// the other link. Empty: nothing is left of one of the two.
  std::vector<ZoneBodies> bodies;
};

/// "0.126 m about elbow".
std::string zone_text(const Model& model, const JointZone& zone);
std::string radius_text(const Model& model, double radius, std::size_t joint);

/// The joint between two neighbours, if it is the only one.
std::optional<std::size_t> joint_of_neighbours(const Model& model, std::size_t a, std::size_t b);
/// Whether it is the only one between two neighbours with meshes.
bool is_between_neighbours(const Model& model, std::size_t joint);

/// Radii that the user chose, in metres, by joints; 0: no zone.
using ZoneRadii = std::map<std::size_t, double>;

/// Of all neighbours that touch wherever their joint stands; and of those whose joint has a radius.
/// As many as there is time for: a zone that is not measured to its end is none.
/// `meshes`: the links', baked with `cell`, in metres. In the order of pairs.
std::vector<JointZone> joint_zones(const Model& model, const std::vector<WholeMesh>& meshes,
                                   double cell, const MatrixOptions& options,
                                   const ZoneRadii& radii);

/// What of two bodies may come within the stop distance, slack included: what a guard needs of
/// them.
struct ZoneParts {
  bake::SourceMesh a;
  bake::SourceMesh b;
};
/// Of all the zone's bodies that may.
std::vector<ZoneParts> zone_parts(const Model& model, const JointZone& zone, double cell,
                                  const MatrixOptions& options);

}  // namespace flashbvh::tool
