// Firmware's links of a robot: with all triangles, or fewer as --simplify or --fit request.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "robot/pipeline/baked_robot.hpp"
#include "simplify/fit.hpp"

namespace flashbvh::tool {

class SimplifiedLinks {
 public:
  /// Call before pairs are decided. UserError if links can't be simplified as requested.
  SimplifiedLinks(const Model& model, double cell, const RobotRequest& request);

  /// How much earlier than requested a guard may stop two links, in metres. Simplified links may be
  /// nearer than the URDF's by both deviations, and the slack counts both again. Zones are chosen
  /// for this value.
  double early() const { return kEarlyByDeviation * expected_; }

  /// Bakes all links, and parts, for firmware. `own_bytes`: size of the image without its meshes.
  /// UserError if --fit is too small or not reached in time, or firmware can't hold a link.
  std::vector<BakedLink> baked(const Model& model, std::size_t own_bytes, const Deadline& deadline,
                               const Told& told);
  /// The links that have too many triangles since time was up.
  std::set<std::string> unfinished(const Model& model) const;
  /// True if --fit needed a larger deviation than early() allows for.
  bool exceeds_expected() const { return length_ > expected_; }

  double length() const { return length_; }  ///< in metres; 0: not simplified
  std::uint32_t leaf_size() const { return leaf_size_; }

 private:
  void add(const Model& model, const Deadline& deadline, const Told& told);
  void fit(const Model& model, double most, const Deadline& deadline);

  const RobotRequest& request_;
  double cell_;
  double length_ = 0;
  double expected_ = 0;
  std::uint32_t leaf_size_;
  std::vector<simplify::Coarsening> meshes_;  ///< empty: no link is simplified
};

}  // namespace flashbvh::tool
