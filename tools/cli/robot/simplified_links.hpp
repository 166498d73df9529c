// What firmware gets of a robot's links: all their triangles, or fewer, as --simplify or --fit say.
#pragma once

#include <optional>
#include <vector>

#include "cli/robot/baked_robot.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

class SimplifiedLinks {
 public:
  /// Before anything is decided. UserError if links can't be simplified so.
  SimplifiedLinks(const Model& model, double cell, const RobotArguments& arguments);

  /// In metres, how much earlier than requested a guard may stop two links: simplified ones may be
  /// nearer by both deviations than the URDF's, and its slack counts these once more. Zones are
  /// chosen so.
  double early() const;

  /// All links, and parts, for firmware. `own_bytes`: of the image, without its meshes. UserError
  /// if --fit is too little, or firmware can't hold a link.
  std::vector<BakedLink> baked(const Model& model, std::size_t own_bytes);
  /// How far it came with --fit was more than early() has room for.
  bool is_late() const;

  double length() const { return length_; }  ///< in metres; 0: not simplified
  std::uint32_t leaf_size() const { return leaf_size_; }

 private:
  void add(const Model& model);
  void fit(const Model& model, double most);

  const RobotArguments& arguments_;
  double cell_;
  double length_ = 0;
  double expected_ = 0;
  std::uint32_t leaf_size_;
  std::vector<simplify::Coarsening> meshes_;  ///< empty: nothing is to be simplified
};

/// Lengths and what they would cost, of all links and parts together. `own_bytes`: as above.
std::vector<simplify::LengthRow> link_lengths(const BakedRobot& robot,
                                              const RobotArguments& arguments,
                                              std::size_t own_bytes);
std::vector<std::uint32_t> shown_leaf_sizes(const RobotArguments& arguments);

}  // namespace flashbvh::tool
