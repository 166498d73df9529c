// Embree: rtcCollide() finds pairs of boxes in two scenes. The caller tests the triangles, as in
// Embree's tutorial, by Moeller's intervals (float_triangles.hpp).
#include <embree3/rtcore.h>

#include <array>
#include <stdexcept>

#include "comparison.hpp"
#include "firmware/float_triangles.hpp"
#include "units.hpp"

using flashbvh::Mesh;

namespace compare {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<RTCDeviceTy, Release>;

/// Triangles in their final position, their planes, and Embree's tree of their boxes.
class Scene {
 public:
  Scene(const Device& device, std::vector<Flat> triangles)
      : triangles_(std::move(triangles)), scene_(rtcNewScene(device.get())) {
    RTCGeometry boxes = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(boxes, static_cast<unsigned>(triangles_.size()));
    rtcSetGeometryUserData(boxes, &triangles_);
    rtcSetGeometryBoundsFunction(boxes, set_bounds, nullptr);
    rtcCommitGeometry(boxes);
    rtcAttachGeometry(get(), boxes);
    rtcReleaseGeometry(boxes);
    rtcSetSceneBuildQuality(get(), RTC_BUILD_QUALITY_HIGH);
    rtcCommitScene(get());
  }
  Scene(Scene&&) = delete;  // Embree refers to its triangles

  RTCScene get() const { return scene_.get(); }
  const Flat& triangle(std::uint32_t i) const { return triangles_[i]; }

 private:
  static void set_bounds(const RTCBoundsFunctionArguments* of) {
    const auto& triangles = *static_cast<const std::vector<Flat>*>(of->geometryUserPtr);
    const Vec(&c)[3] = triangles[of->primID].corner;
    RTCBounds& box = *of->bounds_o;
    box.lower_x = least(c[0].x, least(c[1].x, c[2].x));
    box.lower_y = least(c[0].y, least(c[1].y, c[2].y));
    box.lower_z = least(c[0].z, least(c[1].z, c[2].z));
    box.upper_x = most(c[0].x, most(c[1].x, c[2].x));
    box.upper_y = most(c[0].y, most(c[1].y, c[2].y));
    box.upper_z = most(c[0].z, most(c[1].z, c[2].z));
  }

  std::vector<Flat> triangles_;
  std::unique_ptr<RTCSceneTy, Release> scene_;
};

bool intersect(const Flat& a, const Flat& b) {
  const Heights of_b(a.normal, a.offset, b.corner);
  if (of_b.are_on_one_side()) {
    return false;
  }
  const Heights of_a(b.normal, b.offset, a.corner);
  return !of_a.are_on_one_side() &&
         crossing_intersect(a.corner, b.corner, a.normal, b.normal, of_a, of_b);
}

/// A mesh's triangles at a pose.
std::vector<Flat> triangles_of(const Mesh& mesh, const flashbvh::Pose& pose) {
  std::vector<Vec> vertices;
  for (const auto& p : vertices_of<double, std::array<double, 3>>(mesh)) {
    const auto along = [&](int row) {
      return static_cast<float>(rotation_of(pose, row, 0) * p[0] +
                                rotation_of(pose, row, 1) * p[1] +
                                rotation_of(pose, row, 2) * p[2] + translation_of(pose, row));
    };
    vertices.push_back({along(0), along(1), along(2)});
  }
  std::vector<Flat> triangles;
  for (const auto& [p, q, r] : corners_of<std::array<std::uint16_t, 3>>(mesh)) {
    triangles.push_back(flat_of(vertices[p], vertices[q], vertices[r]));
  }
  return triangles;
}

/// One thread, like all other libraries.
Device new_device() {
  Device device(rtcNewDevice("threads=1"));
  if (device == nullptr) {
    throw std::runtime_error("Embree has no device");
  }
  return device;
}

class WithEmbree : public Collider {
 public:
  WithEmbree(const Mesh& a, const Mesh& b)
      : mesh_a_(&a),
        mesh_b_(&b),
        device_(new_device()),
        a_(device_, triangles_of(a, flashbvh::Pose::translated(0, 0, 0))) {}

  /// Makes a scene of B for each pose.
  void set_poses(const std::vector<Placed>& poses) override {
    placed_.clear();
    for (const Placed& placed : poses) {
      placed_.push_back(std::make_unique<Scene>(device_, triangles_of(*mesh_b_, placed.pose)));
    }
  }

  std::size_t query_all(Wanted /*wanted*/) override {
    std::size_t count = 0;
    for (const auto& scene : placed_) {
      query(*scene);
      count += found_.size();
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    query(*placed_[pose]);
    std::vector<Pair> all;
    for (const Pair& pair : found_) {
      all.emplace_back(mesh_a_->triangle_ids[pair.first], mesh_b_->triangle_ids[pair.second]);
    }
    return all;
  }

 private:
  void query(const Scene& b) {
    found_.clear();
    b_ = &b;
    rtcCollide(a_.get(), b.get(), test_pairs, this);
  }

  static void test_pairs(void* with, RTCCollision* pairs, unsigned count) {
    WithEmbree& self = *static_cast<WithEmbree*>(with);
    for (unsigned i = 0; i < count; ++i) {
      const RTCCollision& pair = pairs[i];
      if (intersect(self.a_.triangle(pair.primID0), self.b_->triangle(pair.primID1))) {
        self.found_.emplace_back(pair.primID0, pair.primID1);
      }
    }
  }

  const Mesh* mesh_a_;
  const Mesh* mesh_b_;
  Device device_;
  Scene a_;
  std::vector<std::unique_ptr<Scene>> placed_;
  const Scene* b_ = nullptr;
  std::vector<Pair> found_;
};

}  // namespace

std::unique_ptr<Collider> with_embree(const Mesh& a, const Mesh& b) {
  return std::make_unique<WithEmbree>(a, b);
}

}  // namespace compare
