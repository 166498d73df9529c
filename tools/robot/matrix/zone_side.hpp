// One of the two links at a joint: its shells, and what it has outside the joint's zone.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "robot/matrix/baked_part.hpp"
#include "robot/matrix/zone_cut.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

class ZoneSide {
 public:
  /// `frame`: the joint's frame at coordinate 0, in the link's.
  ZoneSide(const ModelLink& link, const Transform& frame);

  const bake::SourceMesh& mesh() const { return mesh_; }
  /// From the link's frame to the joint's at coordinate 0.
  const Transform& to_joint() const { return to_joint_; }
  /// A shell consists of connected triangles of one source; numbered from 0.
  std::uint32_t shell_of(std::uint32_t triangle) const { return shells_[triangle]; }
  std::uint32_t shell_count() const { return shell_count_; }

  /// Of some shells.
  bake::SourceMesh part(const std::vector<bool>& shells) const;
  /// Of some shells, what they have outside the zone (ZoneCut).
  bake::SourceMesh outside(const std::vector<bool>& shells, const ZoneShape& shape,
                           double edge) const;

 private:
  bake::SourceMesh mesh_;  ///< in the link's frame
  Transform to_joint_;
  std::vector<std::uint32_t> shells_;  ///< of each triangle
  std::uint32_t shell_count_ = 0;
};

/// Two links at one value of their joint.
struct ZoneLook {
  std::size_t number;
  Transform frame;                                     ///< b's in a's
  std::vector<std::array<std::uint32_t, 2>> contacts;  ///< triangles of both sides
};

/// The shells of both sides that touch at half of the looks or more. Leaves out other contacts.
std::array<std::vector<bool>, 2> take_touching_shells(const std::array<ZoneSide, 2>& sides,
                                                      std::vector<ZoneLook>& looks);

}  // namespace flashbvh::tool
