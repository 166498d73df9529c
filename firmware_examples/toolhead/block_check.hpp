// The check of one block before it is queued: each moving body against each obstacle.
#pragma once

#include <flashbvh/contact.hpp>
#include <flashbvh/first_contact.hpp>
#include <flashbvh/triangle.hpp>

#include "block.hpp"
#include "scene.hpp"

/// Bodies nearer than this count as touching: belts stretch, blocks' ends are rounded to 5 um, and
/// meshes are inexact.
constexpr int32_t kMargin = 250;  // micrometres

constexpr int32_t kCell = 10;  // in micrometres
static_assert(head_CELLS_PER_UNIT == 1000.0f / kCell);
constexpr int32_t cells(int32_t micrometres) {
  return (micrometres + (micrometres < 0 ? -kCell / 2 : kCell / 2)) / kCell;
}

/// Checks in slices, between which the firmware does other work. Each block starts where the last
/// one ended: a head that is outside all obstacles cannot get inside one without touching it.
class BlockCheck {
 public:
  explicit BlockCheck(const Block& block)
      : block_(block), pair_(0), motion_(motion()), query_(query()), answer_() {}

  BlockCheck(const BlockCheck&) = delete;  // the query refers to the motion

  /// Runs one slice; true if it was the last one.
  bool run(uint32_t work) {
    answer_ = query_.run(work);
    if (answer_.status == flashbvh::Status::suspended) {
      return false;
    }
    if (!pair_is_free() || ++pair_ == kPairCount) {
      return true;
    }
    motion_ = motion();
    query_ = query();
    return false;
  }

  // Valid after the last slice:

  /// An error is no permission to move.
  bool is_free() const { return pair_ == kPairCount; }
  bool has_error() const { return answer_.status != flashbvh::Status::done; }

  const Body& body() const { return kBodies[pair_ / kObstacleCount]; }
  const Obstacle& obstacle() const { return kObstacles[pair_ % kObstacleCount]; }

  /// The part of the block's length that is certified free, from 0 to 1.
  float free_part() const {
    return static_cast<float>(answer_.from) / static_cast<float>(flashbvh::kMotionEnd);
  }

  /// A point of contact on the obstacle, where one of possibly several pairs of triangles touches.
  bool get_touched(Place& touched) const {
    flashbvh::Triangle of_obstacle;
    flashbvh::Triangle of_body;
    if (!flashbvh::transform_pair(obstacle().mesh, body().mesh, motion_.pose_at(answer_.to),
                                  answer_.triangles, of_obstacle, of_body)) {
      return false;
    }
    const flashbvh::FinePoint at = flashbvh::nearest_points_of(of_obstacle, of_body).point_a;
    touched = {{micrometres(at.x) + 1000 * obstacle().x, micrometres(at.y) + 1000 * obstacle().y,
                micrometres(at.z)}};
    return true;
  }

 private:
  static constexpr int kPairCount = kBodyCount * kObstacleCount;

  static int32_t micrometres(int64_t fine) { return static_cast<int32_t>(fine * kCell >> 8); }

  bool pair_is_free() const {
    return answer_.status == flashbvh::Status::done &&
           answer_.outcome == flashbvh::ContactOutcome::free;
  }

  /// The body's pose in the obstacle's frame.
  flashbvh::Pose pose(const Place& nozzle) const {
    const int32_t x = body().goes_along_x ? nozzle.axis[0] : 1000 * kMiddle;
    return flashbvh::Pose::translated(cells(x - 1000 * obstacle().x),
                                      cells(nozzle.axis[1] - 1000 * obstacle().y),
                                      cells(nozzle.axis[2]));
  }
  flashbvh::BodyMotion motion() const {
    return flashbvh::BodyMotion::between(pose(block_.from), pose(block_.to));
  }
  flashbvh::FirstContact query() const {
    constexpr flashbvh::FineLength margin = {(kMargin * 256 + kCell - 1) / kCell};
    return {obstacle().mesh, body().mesh, motion_, margin};
  }

  Block block_;
  int pair_;
  flashbvh::BodyMotion motion_;
  flashbvh::FirstContact query_;
  flashbvh::FirstContactAnswer answer_;
};
