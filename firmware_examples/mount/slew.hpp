// A slew of an equatorial mount: from one pair of angles to another, both axes at constant speed.
#pragma once

#include <flashbvh/first_contact.hpp>
#include <flashbvh/image.hpp>

#include "tripod.fbvh.h"
#include "tube.fbvh.h"
#include "weights.fbvh.h"

/// Angles of the axes; flashbvh::kFullTurn is a full turn. At 0 the weights point down and the tube
/// points at the pole.
struct Angles {
  int32_t hour;         ///< of the polar axis
  int32_t declination;  ///< of the axis that the polar axis carries
};

constexpr int32_t kHalfTurn = flashbvh::kFullTurn / 2;

constexpr Angles degrees(double hour, double declination) {
  return {static_cast<int32_t>(hour * flashbvh::kFullTurn / 360),
          static_cast<int32_t>(declination * flashbvh::kFullTurn / 360)};
}

const flashbvh::Mesh tripod = flashbvh::view_unchecked<flashbvh::Mesh>(tripod_image);
const flashbvh::Mesh tube = flashbvh::view_unchecked<flashbvh::Mesh>(tube_image);
const flashbvh::Mesh weights = flashbvh::view_unchecked<flashbvh::Mesh>(weights_image);

/// A body that moves with the first axis or with both. All meshes' origins lie where the axes meet.
struct Body {
  const char* name;
  const flashbvh::Mesh& mesh;
  uint32_t axes;
};
const Body kBodies[] = {{"tube", tube, 2}, {"weights", weights, 1}};

/// The moves of both axes; constant once constructed, because queries read them.
class Slew {
 public:
  Slew(const Angles& from, const Angles& to) : from_(from), to_(to) {
    const flashbvh::Pose carried = pose({from.hour, 0}, 1);
    moves_[0] = about(0, 0, flashbvh::kRotationOne, to.hour - from.hour);
    // A move's axis is given for the motion's start: the polar axis has already turned this one.
    moves_[1] =
        about(carried.rotation(0, 0), carried.rotation(1, 0), 0, to.declination - from.declination);
  }

  /// The motion of a body that `axes` axes move, in the tripod's frame: z is the polar axis.
  flashbvh::BodyMotion motion(uint32_t axes) const { return {pose(from_, axes), moves_, axes}; }

  Angles at(uint32_t time) const {
    return {from_.hour + part(to_.hour - from_.hour, time),
            from_.declination + part(to_.declination - from_.declination, time)};
  }

 private:
  static constexpr flashbvh::Pose kHome = flashbvh::Pose::translated(0, 0, 0);

  static flashbvh::Move about(int32_t x, int32_t y, int32_t z, int32_t turn) {
    return {{0, 0, 0}, {x, y, z}, turn, {0, 0, 0}};
  }
  /// Forward kinematics: turns the body from its home pose by the angles.
  static flashbvh::Pose pose(const Angles& angles, uint32_t axes) {
    const flashbvh::Move moves[2] = {about(0, 0, flashbvh::kRotationOne, angles.hour),
                                     about(flashbvh::kRotationOne, 0, 0, angles.declination)};
    return flashbvh::BodyMotion(kHome, moves, axes).to();
  }
  static int32_t part(int32_t turn, uint32_t time) {
    return static_cast<int32_t>(int64_t{turn} * time / flashbvh::kMotionEnd);
  }

  Angles from_;
  Angles to_;
  flashbvh::Move moves_[2];
};
