// A model in fixed point, in memory, as firmware holds it.
//
// Pairs with one or two joints between their links have distance tables: a guard reads bounds from
// them without testing a mesh (flashbvh/robot/distance_table.hpp has the layout).
//
// A table cell's distance is proven as in the matrix. The exact query measures the links' distance
// at the middle of a part of it. In the part, it shrinks by at most the links' motion. Parts are
// halved until the bound is a large enough share of the least distance seen in the table cell.
#pragma once

#include <cstdint>
#include <vector>

#include "flashbvh/robot/robot.hpp"
#include "robot/matrix/baked_part.hpp"
#include "robot/matrix/matrix_options.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/model.hpp"
#include "text/deadline.hpp"

namespace flashbvh::tool {

/// A unit of a joint's coordinate, in radians or metres.
double unit_of_coordinate(JointType type, double cell);

/// UserError if a joint has limits that no coordinate keeps.
void check_limits(const Model& model, double cell);

class FixedRobot {
 public:
  /// `wholes`: the links' meshes on which pairs are decided; `meshes`: firmware's meshes of them.
  /// Both have one for each link, baked with `cell`, in metres; a link's sphere holds both.
  /// `meshes` outlive the robot; if empty, the robot has no meshes, a hash of 1 and no distance
  /// tables. `reaches`: of the first links; further ones are computed. `deviations`: of the meshes
  /// from the URDF, in metres; if empty, those of the wholes. UserError if the robot has more
  /// joints or links than firmware takes, or moves a pair too far; names a cell that would do. Also
  /// if its links deviate by more than firmware's slack holds.
  FixedRobot(const Model& model, const std::vector<WholeMesh>& wholes,
             const std::vector<Mesh>& meshes, double cell, const std::vector<GuardedPair>& pairs,
             const Reaches& reaches = {}, const std::vector<double>& deviations = {});

  /// Adds the result of distance_tables_of().
  void set_distance_tables(std::vector<std::uint8_t> distance_tables);

  /// A view of this object.
  const Robot& robot() const { return robot_; }

  FixedRobot(const FixedRobot&) = delete;
  FixedRobot& operator=(const FixedRobot&) = delete;

 private:
  void add_joint(const Model& model, std::size_t joint);
  void add_link(const Model& model, std::size_t link, const WholeMesh& whole,
                const std::vector<double>& reaches, double deviation);
  void add_pair(const Model& model, const GuardedPair& pair);
  double reach_of(const RobotPair& pair) const;
  double extent_of(const Model& model, std::size_t link) const;
  std::uint32_t checked_slack(const Model& model) const;

  double cell_;
  std::vector<RobotJoint> joints_;
  std::vector<RobotLink> links_;
  std::vector<RobotPair> pairs_;
  std::vector<std::uint32_t> reaches_;
  std::vector<double> wide_reaches_;  ///< reaches_ before clamping to 32 bits
  double most_reach_ = 0;             ///< of all pairs
  std::vector<std::uint8_t> distance_tables_;
  std::vector<Mesh> meshes_;
  Robot robot_{};
};

/// The tables of `robot`, which is made of `model`. Uses all processors. Entries that the deadline
/// leaves open are 0: unknown.
std::vector<std::uint8_t> distance_tables_of(const Model& model, const Robot& robot,
                                             const Deadline& deadline = {});

}  // namespace flashbvh::tool
