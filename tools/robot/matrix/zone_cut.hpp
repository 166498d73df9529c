// Parts of triangles: outside a joint zone, and near another triangle.
#pragma once

#include <map>
#include <vector>

#include "robot/kinematics.hpp"
#include "simplify/nearest.hpp"

namespace flashbvh::tool {

using simplify::PointTriangle;

/// A solid that the joint moves into itself: a ball about a point of its axis. For a prismatic
/// joint, it is an infinite cylinder round a line along the axis.
struct ZoneShape {
  bool is_cylinder = false;
  Vector3 middle{};  ///< in the joint's frame, metres
  double radius = 0;

  /// From the middle, or from the nearest point of the line.
  Vector3 from_middle(const Vector3& point) const {
    return {point[0] - middle[0], point[1] - middle[1], is_cylinder ? 0 : point[2] - middle[2]};
  }
  double distance_of(const Vector3& point) const { return length_of(from_middle(point)); }
};

PointTriangle placed_triangle(const Transform& transform, const PointTriangle& triangle);

/// The radius of the smallest zone of this shape outside of which the two are not within
/// `distance`, a little too large; or `least` if that is more.
double radius_between(const ZoneShape& shape, const PointTriangle& p, const PointTriangle& q,
                      double distance, double least);

/// Collects what triangles have outside a zone. All of that is kept. Kept triangles reach into the
/// zone by less than edge^2 / (6 radius), unless they are very many.
class ZoneCut {
 public:
  /// `to_joint`: from the triangles' frame to the zone's.
  ZoneCut(const ZoneShape& shape, const Transform& to_joint, double edge)
      : shape_(shape), to_joint_(to_joint), edge_(edge) {}

  void add(const PointTriangle& triangle);
  const bake::SourceMesh& mesh() const { return mesh_; }

 private:
  bool cut(const PointTriangle& triangle, std::vector<PointTriangle>& pieces) const;
  bool clip(const PointTriangle& triangle, std::vector<PointTriangle>& pieces) const;
  Vector3 crossing(const Vector3& inside, const Vector3& outside) const;
  Vector3 from_middle(const Vector3& point) const {
    return shape_.from_middle(placed(to_joint_, point));
  }

  ZoneShape shape_;
  Transform to_joint_;
  double edge_;
  bake::SourceMesh mesh_;
  std::size_t pieces_ = 0;
  std::map<Vector3, std::uint32_t> vertices_;
};

}  // namespace flashbvh::tool
