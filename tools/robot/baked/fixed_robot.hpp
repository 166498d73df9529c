// A model in fixed point: what firmware holds of it, in memory.
//
// Distance tables of the pairs that have one or two joints between their links: what a guard knows
// of them without testing a mesh (lib/src/robot/distance_table.hpp has the layout).
//
// A cell's distance is proven as the matrix proves: at the middle of a part of it, the links are as
// far apart as the exact query says; nothing in the part is nearer by more than the joints move the
// links in it. Parts are halved until that is most of the least distance seen in the cell.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/robot/robot.hpp"
#include "robot/matrix/baked_part.hpp"
#include "robot/matrix/deadline.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/model.hpp"

namespace flashbvh::tool {

/// Two links that are to be guarded. Distances in metres.
struct GuardedPair {
  std::size_t a;
  std::size_t b;
  double stop;
  double warn;
};

/// A unit of a joint's coordinate, in radians or metres.
double unit_of_coordinate(JointType type, double cell);

Mount fixed_mount(const ModelMount& mount, double cell);

class FixedRobot {
 public:
  /// `wholes`, `meshes`: the links' as pairs are decided on them, and as firmware gets them; of the
  /// same number, baked with `cell`, in metres. A link's sphere holds both. `meshes` outlive the
  /// robot; if there are none, it has no meshes, no hash and no distance tables. `reaches`: of the
  /// first links; those of others are worked out. `deviations`: of the meshes from what the URDF
  /// has, in metres; without any that of the wholes. UserError if the robot has more joints or
  /// links than firmware takes, or is larger, or moves any of the pairs too far; says with which
  /// cell it would do.
  FixedRobot(const Model& model, const std::vector<WholeMesh>& wholes,
             const std::vector<Mesh>& meshes, double cell, const std::vector<GuardedPair>& pairs,
             const Reaches& reaches = {}, const std::vector<double>& deviations = {});

  /// Adds distance_tables_of() it.
  void set_distance_tables(std::vector<std::uint8_t> distance_tables);

  /// A view of it.
  const Robot& robot() const { return robot_; }

  FixedRobot(const FixedRobot&) = delete;
  FixedRobot& operator=(const FixedRobot&) = delete;

  const std::vector<RobotJoint>& joints() const { return joints_; }
  /// Of all pairs together: how many joints are between their links.
  std::uint32_t pair_joint_count() const { return pair_joint_count_; }

 private:
  void add_joint(const Model& model, std::size_t joint);
  void add_link(const Model& model, std::size_t link, const WholeMesh& whole,
                const std::vector<double>& reaches, double deviation);
  void add_pair(const Model& model, const GuardedPair& pair);
  double reach_of(const RobotPair& pair) const;
  void check_reach() const;
  double extent_of(const Model& model, std::size_t link) const;
  void check_size(const Model& model) const;
  std::uint32_t slack(const Model& model) const;

  double cell_;
  std::vector<RobotJoint> joints_;
  std::vector<RobotLink> links_;
  std::vector<double> deviations_;  ///< of each, in cells
  std::vector<RobotPair> pairs_;
  std::vector<std::uint32_t> reaches_;
  std::vector<double> wide_reaches_;  ///< the same, also where they are too large
  double most_reach_ = 0;             ///< of a pair
  std::vector<std::uint8_t> distance_tables_;
  std::vector<Mesh> meshes_;
  std::uint32_t pair_joint_count_ = 0;
  Robot robot_{};
};

/// `robot`: of the model. On all processors. What there is no time for is not known: a 0.
std::vector<std::uint8_t> distance_tables_of(const Model& model, const Robot& robot,
                                             const Deadline& deadline = {});

}  // namespace flashbvh::tool
