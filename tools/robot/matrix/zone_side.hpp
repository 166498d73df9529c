// One of the two links at a joint: its triangles by their distance from the middle of the joint's
// zone.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/matrix/baked_part.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// A solid that the joint moves into itself: a ball about a point of its axis. For a prismatic
/// joint, it is an infinite cylinder round a line along the axis.
struct ZoneShape {
  bool is_cylinder = false;
  std::array<double, 3> middle{};  ///< in the joint's frame, metres
  double radius = 0;

  /// The distance from the middle, or from the line.
  double distance_of(const std::array<double, 3>& point) const;
};

class ZoneSide {
 public:
  /// `frame`: the joint's frame at coordinate 0, in the link's.
  ZoneSide(const ModelLink& link, const Transform& frame);

  const bake::SourceMesh& mesh() const { return mesh_; }
  /// A shell consists of connected triangles of one source; numbered from 0.
  std::uint32_t shell_of(std::uint32_t triangle) const { return shells_[triangle]; }
  std::uint32_t shell_count() const { return shell_count_; }
  /// In the joint's frame.
  std::array<double, 3> corner(std::uint32_t triangle, std::size_t i) const;

  /// Cuts the triangles of these shells that reach into the shape until no edge is longer than
  /// `edge`, or there are very many triangles.
  void cut(const std::vector<bool>& shells, const ZoneShape& shape, double edge);
  /// A mesh of these triangles alone. Where all pieces of a triangle are among them, it is whole.
  bake::SourceMesh part(const std::vector<std::uint32_t>& triangles) const;
  /// The largest distance of each triangle from the shape's middle.
  std::vector<double> farthest(const ZoneShape& shape) const;

 private:
  void number_shells(const ModelLink& link);

  bake::SourceMesh mesh_;  ///< in the link's frame
  Transform to_joint_;
  std::vector<std::uint32_t> shells_;         ///< of each triangle
  std::vector<std::uint32_t> origins_;        ///< the link's triangle that each is a piece of
  std::vector<bake::TriangleCorners> whole_;  ///< the link's triangles
  std::uint32_t shell_count_ = 0;
};

}  // namespace flashbvh::tool
