// Random poses, the same on every machine.
#ifndef FLASHBVH_TOOLS_REPORT_SAMPLE_POSES_HPP
#define FLASHBVH_TOOLS_REPORT_SAMPLE_POSES_HPP

#include <cstdint>

#include "flashbvh/pose.hpp"
#include "image/image_file.hpp"
#include "report/view.hpp"

namespace flashbvh::report {

/// The splitmix64 generator (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number
/// Generators", OOPSLA 2014), always from the same start.
class Random {
 public:
  /// From -most to most.
  std::int64_t within(std::int64_t most);

 private:
  std::uint64_t next();

  std::uint64_t state_ = 1;
};

/// B turned by any rotation, each as likely as the other, and moved so that the middle of its box
/// lies in any direction from the middle of A's, at any distance from 0 to the sum of half their
/// boxes' diagonals: from there on their boxes are apart however they are turned. Always the same
/// poses for the same trees.
class PoseSampler {
 public:
  PoseSampler(const tool::AnyTree& a, const tool::AnyTree& b);

  /// Not `done` where a mesh lies too far from its origin.
  Pose next();

 private:
  /// A root's box, in half cells of the mesh's frame.
  struct Place {
    Vector middle;
    std::int64_t diagonal;  ///< half of it
  };
  static Place place_of(const tool::AnyTree& any);

  Random random_;
  Place a_;
  Place b_;
};

}  // namespace flashbvh::report

#endif
