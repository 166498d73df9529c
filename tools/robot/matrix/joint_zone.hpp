// Joint zones. Two links that a joint connects touch about it, at all of its values. Outside a zone
// about the joint, the links are decided and guarded like any pair; inside, they are not checked,
// and messages say so.
//
// The zone is as small as the contacts over the middle three quarters of the joint's range: where
// they grow towards a limit, a real collision may be there. Shells of a link that touch the other
// link at some values alone (a post on a table) have no zone: they are checked everywhere.
#pragma once

#include <map>
#include <set>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/zone_side.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// Parts of two links that must not collide, in the links' frames, in metres.
struct ZoneBodies {
  bake::SourceMesh mesh_a;  ///< cut at the zone
  bake::SourceMesh mesh_b;
  BakedPart a;
  BakedPart b;
};

struct JointZone {
  std::size_t a;  ///< links, a below b
  std::size_t b;
  std::size_t joint;  ///< the only joint between
  ZoneShape shape;
  /// The share of the joint's range in which the zone hides contacts that it was grown for.
  double hidden;
  /// Everything outside the zone: the touching shells outside it; other shells and the other link.
  /// Empty if nothing is left of one link.
  std::vector<ZoneBodies> bodies;
};

/// "0.126 m about elbow".
std::string radius_text(const Model& model, double radius, std::size_t joint);

/// Radii that the user chose, in metres, by joint; 0: no zone.
using ZoneRadii = std::map<std::size_t, double>;

struct FoundZones {
  std::vector<JointZone> zones;       ///< in the order of pairs
  std::set<std::size_t> late_joints;  ///< whose search for a zone ran out of time
};

/// The zones of neighbours that touch at all values of their joint, and of joints with a radius.
/// `meshes`: of the links, baked with `cell`, in metres.
FoundZones joint_zones(const Model& model, const std::vector<WholeMesh>& meshes, double cell,
                       const MatrixOptions& options, const ZoneRadii& radii);

/// The parts of two bodies that may come within the stop distance and slack. A guard tests only
/// these.
struct ZoneParts {
  bake::SourceMesh a;
  bake::SourceMesh b;
};
/// For all bodies of the zone that may come so near.
std::vector<ZoneParts> zone_parts(const Model& model, const JointZone& zone, double cell,
                                  const MatrixOptions& options);

}  // namespace flashbvh::tool
