// The parts of a robot's image, for tests that change them.
#pragma once

#include "flashbvh/detail/robot/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/robot/image.hpp"
#include "golden/exercise.hpp"
#include "support/arms/arm_images.hpp"
#include "support/arms/exercise_robot.hpp"

namespace flashbvh::test {

using Words = std::vector<std::uint32_t>;

inline std::size_t size_of(const Words& words) {
  return words.size() * sizeof words[0];
}

/// The parts of an image, given as words.
struct Parts {
  explicit Parts(Words& words)
      : header(*reinterpret_cast<RobotImageHeader*>(words.data())),
        joints(reinterpret_cast<RobotJoint*>(&header + 1)),
        links(reinterpret_cast<RobotLink*>(joints + header.joint_count)),
        pairs(reinterpret_cast<RobotPair*>(links + header.link_count)),
        reaches(reinterpret_cast<std::uint32_t*>(pairs + header.pair_count)),
        mounts(reinterpret_cast<Mount*>(reaches + header.reach_count)),
        unguarded(reinterpret_cast<RobotUnguarded*>(mounts + header.mount_count)),
        distance_tables(reinterpret_cast<std::uint8_t*>(unguarded + header.unguarded_count)),
        names(reinterpret_cast<char*>(distance_tables + header.distance_table_bytes)),
        meshes(reinterpret_cast<unsigned char*>(words.data()) +
               detail::robot_meshes_offset(header)) {}

  /// The header of the first mesh.
  ImageHeader& mesh() const { return *reinterpret_cast<ImageHeader*>(meshes); }

  RobotImageHeader& header;
  RobotJoint* joints;
  RobotLink* links;
  RobotPair* pairs;
  std::uint32_t* reaches;
  Mount* mounts;
  RobotUnguarded* unguarded;
  std::uint8_t* distance_tables;
  char* names;
  unsigned char* meshes;
};

/// exercise_robot() with the same numbers in each run of a seed.
inline RobotVerdict exercise_any(const void* bytes, std::size_t size) {
  Random random(test_seed());
  return exercise_robot(bytes, size,
                        [&] { return static_cast<std::uint32_t>(random.next() >> 32); });
}

}  // namespace flashbvh::test
