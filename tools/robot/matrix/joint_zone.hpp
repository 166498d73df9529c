// Joint zones. Two links that a joint holds together touch about it, wherever it stands. What of them
// lies outside a zone about the joint is decided, and guarded, as any pair is; what lies inside is
// not looked at, and said not to be.
//
// The zone is as small as what touches, over the joint's range: where it grows towards a limit, a
// real collision may be there. Parts of a link that touch the other one only at some values (a post
// on a table) have no zone.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "flashbvh/mesh.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/zone_side.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// What of a link lies outside.
struct OutsideZone {
  bake::SourceMesh mesh;            ///< in metres, in the link's frame; triangles are cut at the zone
  std::optional<BakedPart> baked;  ///< none if nothing lies outside
};

struct JointZone {
  std::size_t a;  ///< links, a below b
  std::size_t b;
  std::size_t joint;  ///< the only one between
  ZoneShape shape;
  OutsideZone outside_a;
  OutsideZone outside_b;

  /// Whether anything of both lies outside.
  bool has_outside() const { return outside_a.baked && outside_b.baked; }
};

/// "0.126 m about elbow".
std::string zone_text(const Model& model, const JointZone& zone);
std::string radius_text(const Model& model, double radius, std::size_t joint);

/// Whether it is the only one between two neighbours with meshes.
bool is_between_neighbours(const Model& model, std::size_t joint);

/// Radii that the user chose, in metres, by joints; 0: no zone.
using ZoneRadii = std::map<std::size_t, double>;

/// Of all neighbours that touch wherever their joint stands; and of those whose joint has a radius.
/// `meshes`: the links', baked with `cell`, in metres. In the order of pairs.
std::vector<JointZone> joint_zones(const Model& model, const std::vector<Mesh>& meshes, double cell,
                                   const MatrixOptions& options, const ZoneRadii& radii);

/// What of the zone's outsides may come within the stop distance, slack included, as two meshes in
/// the links' frames: what a guard needs of them. Both are empty, or none.
struct ZoneParts {
  bake::SourceMesh a;
  bake::SourceMesh b;
};
ZoneParts zone_parts(const Model& model, const JointZone& zone, double cell,
                     const MatrixOptions& options);

}  // namespace flashbvh::tool
