#include <stdexcept>

#include "comparison.hpp"
#include "flashbvh/clearance.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/query.hpp"
#include "units.hpp"

using namespace flashbvh;

namespace compare {
namespace {

constexpr std::uint32_t kMost = 1u << 16;
PairQuery::Pair found[kMost];

/// The rotation of `placed` with the translation `cells`.
Pose pose_of(const Placed& placed, const std::int32_t (&cells)[3]) {
  return placed.pose.is_translation() ? Pose::translated(cells[0], cells[1], cells[2])
                                      : Pose::rigid(placed.rotation.entry, cells);
}

class Flashbvh : public Collider {
 public:
  Flashbvh(const Mesh& a, const Mesh& b, PoseMade pose_made)
      : a_(&a), b_(&b), pose_made_(pose_made) {}

  void set_poses(const std::vector<Placed>& poses) override {
    poses_ = poses;
    rows_ = converted(poses, rows_of);
  }

  std::size_t query_all(Wanted wanted) override {
    const std::uint32_t capacity = wanted == Wanted::first ? 1 : kMost;
    std::size_t count = 0;
    if (pose_made_ == PoseMade::before) {
      for (const Placed& placed : poses_) {
        count += query(placed.pose, capacity);
      }
    } else {
      for (const Rows& rows : rows_) {
        count += query(made_of(rows), capacity);
      }
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    const std::uint32_t count = pose_made_ == PoseMade::before ? query(poses_[pose].pose, kMost)
                                                               : query(made_of(rows_[pose]), kMost);
    if (count == kMost) {
      throw std::runtime_error("more pairs than are counted");
    }
    std::vector<Pair> all;
    for (std::uint32_t i = 0; i < count; ++i) {
      all.emplace_back(found[i].a, found[i].b);
    }
    return all;
  }

 private:
  /// A pose in the form that the other libraries get: binary32, in units.
  struct Rows {
    float entry[3][4];
  };

  static Rows rows_of(const Pose& pose) {
    Rows rows{};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        rows.entry[row][column] = static_cast<float>(rotation_of(pose, row, column));
      }
      rows.entry[row][3] = static_cast<float>(translation_of(pose, row));
    }
    return rows;
  }
  static Pose made_of(const Rows& rows) {
    return flashbvh::pose_of(rows.entry, static_cast<float>(kCellsOfUnit));
  }

  std::uint32_t query(const Pose& pose, std::uint32_t capacity) {
    PairQuery query(*a_, *b_, pose);
    return query.run(UINT32_MAX, found, capacity).count;
  }

  const Mesh* a_;
  const Mesh* b_;
  PoseMade pose_made_;
  std::vector<Placed> poses_;
  std::vector<Rows> rows_;  ///< the poses in this form
};

/// B's movement since the last pose, in cells, as in tests/figures/clearance.cpp.
constexpr std::int32_t kStep = 10;

/// B's pose one step earlier.
Pose last_pose(const Placed& placed) {
  const std::int32_t cells[3] = {placed.cells[0] + kStep, placed.cells[1], placed.cells[2]};
  return pose_of(placed, cells);
}

class FlashbvhDistances : public DistanceMeter {
 public:
  FlashbvhDistances(const Mesh& a, const Mesh& b, Hint hint) : a_(&a), b_(&b), hint_(hint) {}

  void set_poses(const std::vector<Placed>& poses) override {
    queries_.clear();
    for (const Placed& placed : poses) {
      Witness<std::uint16_t> hint;
      if (hint_ == Hint::last_pose) {
        hint = distance(*a_, *b_, last_pose(placed)).witness;
      }
      queries_.push_back({placed.pose, hint});
    }
  }

  std::size_t query_all(Wanted /*wanted*/) override {
    std::size_t sum = 0;
    for (const PoseAndHint& query : queries_) {
      sum += distance(*a_, *b_, query.pose, query.hint).lower;
    }
    return sum;
  }

  Length length(std::size_t pose) override {
    const PoseAndHint& query = queries_[pose];
    const auto known = distance(*a_, *b_, query.pose, query.hint);
    return {known.lower / 256.0, known.upper / 256.0};
  }

 private:
  struct PoseAndHint {
    Pose pose;
    Witness<std::uint16_t> hint;
  };

  const Mesh* a_;
  const Mesh* b_;
  Hint hint_;
  std::vector<PoseAndHint> queries_;
};

class FlashbvhRayCaster : public RayCaster {
 public:
  explicit FlashbvhRayCaster(const Mesh& mesh) : mesh_(&mesh) {}

  double nearest(const Segment& segment) override {
    const auto answer = nearest_hit(*mesh_, segment);
    if (answer.status != Status::done) {
      throw std::runtime_error("flashbvh refused a ray");
    }
    const SegmentShare& along = answer.hit.along;
    return answer.yes ? static_cast<double>(along.above) / static_cast<double>(along.below)
                      : kNoHit;
  }

 private:
  const Mesh* mesh_;
};

}  // namespace

std::unique_ptr<Collider> with_flashbvh(const Mesh& a, const Mesh& b, PoseMade pose_made) {
  return std::make_unique<Flashbvh>(a, b, pose_made);
}

std::unique_ptr<DistanceMeter> distances_of_flashbvh(const Mesh& a, const Mesh& b, Hint hint) {
  return std::make_unique<FlashbvhDistances>(a, b, hint);
}

std::unique_ptr<RayCaster> ray_caster_of_flashbvh(const Mesh& mesh) {
  return std::make_unique<FlashbvhRayCaster>(mesh);
}

}  // namespace compare
