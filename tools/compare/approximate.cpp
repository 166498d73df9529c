// Approximations of meshes: a capsule, spheres, a convex hull, a distance field. Each decides
// whether B collides with A at poses with a known exact answer of flashbvh. None has a margin.
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cstdio>
#include <numeric>
#include <stdexcept>

#include "bullet_mesh.hpp"
#include "comparison.hpp"
#include "eigen_mesh.hpp"
#include "flashbvh/solid.hpp"

using Eigen::Vector3d;
using flashbvh::Mesh;

namespace compare {
namespace {

/// A triangle's corners.
std::array<Vector3d, 3> triangle_of(const Mesh& mesh, std::uint32_t triangle) {
  std::array<Vector3d, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    double point[3];
    set_vertex(mesh, mesh.triangles[triangle].corner[i], point);
    corners[i] = {point[0], point[1], point[2]};
  }
  return corners;
}

/// Decides whether B, in A's frame, collides with A.
class Approximation {
 public:
  virtual ~Approximation() = default;
  virtual bool collide(const flashbvh::Pose& pose) = 0;
  virtual std::size_t bytes() const = 0;  ///< size of A's approximation
};

/// Distance of two segments, by Lumelsky's clamps (Ericson, Real-Time Collision Detection, 5.1.9).
double segments_apart(const Vector3d& p, const Vector3d& along_p, const Vector3d& q,
                      const Vector3d& along_q) {
  const Vector3d r = p - q;
  const double a = along_p.squaredNorm(), e = along_q.squaredNorm(), f = along_q.dot(r);
  const double c = along_p.dot(r), b = along_p.dot(along_q), below = a * e - b * b;
  double s = below > 1e-12 ? std::clamp((b * f - c * e) / below, 0.0, 1.0) : 0;
  double t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = std::clamp((t * b - c) / a, 0.0, 1.0);
  }
  return (p + s * along_p - q - t * along_q).norm();
}

/// A capsule along the axis of the largest vertex spread, with the smallest radius for that axis.
class Capsules : public Approximation {
 public:
  Capsules(const Mesh& a, const Mesh& b) : a_(around(a)), b_(around(b)) {}
  bool collide(const flashbvh::Pose& pose) override {
    const Eigen::Isometry3d frame = isometry_of(pose);
    return segments_apart(a_.from, a_.along, frame * b_.from, frame.linear() * b_.along) <=
           a_.radius + b_.radius;
  }
  std::size_t bytes() const override { return 7 * sizeof(float); }

 private:
  struct Capsule {
    Vector3d from;
    Vector3d along;
    double radius;
  };
  static Capsule around(const Mesh& mesh) {
    const std::vector<Vector3d> vertices = points_of(mesh);
    Vector3d middle = Vector3d::Zero();
    for (const Vector3d& v : vertices) {
      middle += v / static_cast<double>(vertices.size());
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector3d& v : vertices) {
      spread += (v - middle) * (v - middle).transpose();
    }
    const Vector3d axis =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    double radius = 0;
    for (const Vector3d& v : vertices) {
      radius = std::max(radius, (v - middle - axis * axis.dot(v - middle)).norm());
    }
    // The shortest segment that the caps allow.
    double first = 1e9, last = -1e9;
    for (const Vector3d& v : vertices) {
      const double at = axis.dot(v - middle);
      const double off = (v - middle - axis * at).squaredNorm();
      const double cap = std::sqrt(std::max(0.0, radius * radius - off));
      first = std::min(first, at + cap);
      last = std::max(last, at - cap);
    }
    last = std::max(first, last);
    return {middle + axis * first, axis * (last - first) + axis * 1e-9, radius};
  }
  Capsule a_, b_;
};

/// Spheres around parts of the mesh. The largest sphere is divided until there are `kCount`.
class Spheres : public Approximation {
 public:
  static constexpr std::size_t kCount = 32;
  Spheres(const Mesh& a, const Mesh& b) : a_(around(a)), b_(around(b)) {}
  bool collide(const flashbvh::Pose& pose) override {
    const Eigen::Isometry3d frame = isometry_of(pose);
    return std::any_of(b_.begin(), b_.end(), [&](const Sphere& of_b) {
      const Vector3d middle = frame * of_b.middle;
      return std::any_of(a_.begin(), a_.end(), [&](const Sphere& of_a) {
        return (middle - of_a.middle).norm() <= of_a.radius + of_b.radius;
      });
    });
  }
  std::size_t bytes() const override { return a_.size() * 4 * sizeof(float); }

 private:
  struct Sphere {
    Vector3d middle;
    double radius;
    std::vector<std::uint32_t> triangles;
  };
  static Sphere about(const Mesh& mesh, std::vector<std::uint32_t> triangles) {
    Eigen::AlignedBox3d box;
    std::vector<Vector3d> corners;
    for (const std::uint32_t triangle : triangles) {
      for (const Vector3d& corner : triangle_of(mesh, triangle)) {
        corners.push_back(corner);
        box.extend(corner);
      }
    }
    double radius = 0;
    for (const Vector3d& corner : corners) {
      radius = std::max(radius, (corner - box.center()).norm());
    }
    return {box.center(), radius, std::move(triangles)};
  }
  /// Divides the largest sphere's triangles along their longest side.
  static std::vector<Sphere> around(const Mesh& mesh) {
    std::vector<std::uint32_t> all(mesh.triangle_count);
    std::iota(all.begin(), all.end(), 0u);
    std::vector<Sphere> spheres = {about(mesh, all)};
    while (spheres.size() < kCount) {
      const auto largest =
          std::max_element(spheres.begin(), spheres.end(), [](const Sphere& x, const Sphere& y) {
            return (x.triangles.size() > 1 ? x.radius : 0) <
                   (y.triangles.size() > 1 ? y.radius : 0);
          });
      std::vector<std::uint32_t> triangles = largest->triangles;
      if (triangles.size() < 2) {
        break;
      }
      const auto middle = [&mesh](std::uint32_t triangle) -> Vector3d {
        const auto [p, q, r] = triangle_of(mesh, triangle);
        return p + q + r;  // three times
      };
      Eigen::AlignedBox3d box;
      for (const std::uint32_t t : triangles) {
        box.extend(middle(t));
      }
      int axis = 0;
      box.sizes().maxCoeff(&axis);
      const auto half = triangles.begin() + static_cast<std::ptrdiff_t>(triangles.size() / 2);
      std::nth_element(
          triangles.begin(), half, triangles.end(),
          [&](std::uint32_t x, std::uint32_t y) { return middle(x)[axis] < middle(y)[axis]; });
      *largest = about(mesh, {triangles.begin(), half});
      spheres.push_back(about(mesh, {half, triangles.end()}));
    }
    return spheres;
  }
  std::vector<Sphere> a_, b_;
};

/// The convex hull of all vertices, with Bullet's GJK.
class Hulls : public Approximation {
 public:
  Hulls(const Mesh& a, const Mesh& b) {
    fill(a, a_);
    fill(b, b_);
  }
  bool collide(const flashbvh::Pose& pose) override {
    btGjkPairDetector detector(&a_, &b_, &simplex_, &penetration_);
    btGjkPairDetector::ClosestPointInput input;
    input.m_transformA.setIdentity();
    input.m_transformB = transform_of(pose);
    btPointCollector nearest;
    detector.getClosestPoints(input, nearest, nullptr);
    return nearest.m_hasResult && nearest.m_distance <= 0;
  }
  /// The size of the hull's vertices, the only data that GJK reads.
  std::size_t bytes() const override { return vertices_ * 3 * sizeof(float); }

 private:
  void fill(const Mesh& mesh, btConvexHullShape& hull) {
    for (const Vector3d& v : points_of(mesh)) {
      hull.addPoint({static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])},
                    false);
    }
    hull.optimizeConvexHull();
    hull.recalcLocalAabb();
    hull.setMargin(0);
    vertices_ = vertices_ == 0 ? static_cast<std::size_t>(hull.getNumPoints()) : vertices_;
  }
  btConvexHullShape a_, b_;
  btVoronoiSimplexSolver simplex_;
  btGjkEpaPenetrationDepthSolver penetration_;
  std::size_t vertices_ = 0;
};

/// Signed distances from A at the points of a grid, 16 bits each, looked up at B's vertices.
class Field : public Approximation {
 public:
  static constexpr int kSide = 24;
  Field(const Mesh& a, const Mesh& b) : b_(points_of(b)) {
    for (const Vector3d& v : points_of(a)) {
      box_.extend(v);
    }
    const Vector3d edge = box_.sizes() / (kSide - 3);
    box_.min() -= edge;
    box_.max() += edge;
    for (int i = 0; i < kSide * kSide * kSide; ++i) {
      const Vector3d at(i % kSide, i / kSide % kSide, i / kSide / kSide);
      distances_.push_back(
          distance_from(a, box_.min() + at.cwiseProduct(box_.sizes()) / (kSide - 1)));
    }
  }
  bool collide(const flashbvh::Pose& pose) override {
    const Eigen::Isometry3d frame = isometry_of(pose);
    return std::any_of(b_.begin(), b_.end(),
                       [&](const Vector3d& v) { return looked_up(frame * v) <= 0; });
  }
  std::size_t bytes() const override { return distances_.size() * sizeof(std::int16_t); }

 private:
  static double distance_from(const Mesh& mesh, const Vector3d& units) {
    const Vector3d cells = (units * kCellsOfUnit).array().round();
    const flashbvh::Point point = {static_cast<std::int32_t>(cells[0]),
                                   static_cast<std::int32_t>(cells[1]),
                                   static_cast<std::int32_t>(cells[2])};
    const auto is_inside = flashbvh::inside(mesh, point);
    const double distance = distance_to(mesh, point);
    if (is_inside.status != flashbvh::Status::done) {
      throw std::runtime_error("a field of distances needs a closed mesh");
    }
    return is_inside.side == flashbvh::PointSide::inside ? -distance : distance;
  }
  /// The smallest distance to all triangles (Ericson, 5.1.5).
  static double distance_to(const Mesh& mesh, const flashbvh::Point& point) {
    const Vector3d p = Vector3d(point.x, point.y, point.z) / kCellsOfUnit;
    double least = 1e30;
    for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
      const auto [a, b, c] = triangle_of(mesh, i);
      least = std::min(least, square_to(p, a, b, c));
    }
    return std::sqrt(least);
  }
  static double square_to(const Vector3d& p, const Vector3d& a, const Vector3d& b,
                          const Vector3d& c) {
    const Vector3d normal = (b - a).cross(c - a);
    const auto beyond = [&](const Vector3d& u, const Vector3d& v) {
      return normal.cross(v - u).dot(p - u) < 0;
    };
    const auto to_edge = [&](const Vector3d& u, const Vector3d& v) {
      const double length = (v - u).squaredNorm();
      const double t = length == 0 ? 0 : std::clamp((p - u).dot(v - u) / length, 0.0, 1.0);
      return (u + t * (v - u) - p).squaredNorm();
    };
    if (normal.squaredNorm() > 0 && !beyond(a, b) && !beyond(b, c) && !beyond(c, a)) {
      const double height = normal.dot(p - a);
      return height * height / normal.squaredNorm();
    }
    return std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
  }
  /// Interpolates between the eight grid points around it; 1 outside the grid.
  double looked_up(const Vector3d& units) const {
    if (!box_.contains(units)) {
      return 1;
    }
    const Vector3d at =
        ((units - box_.min()).array() / box_.sizes().array() * (kSide - 1)).matrix();
    int low[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(static_cast<int>(at[axis]), kSide - 2);
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      double weight = 1;
      int index[3];
      for (int axis = 0; axis < 3; ++axis) {
        const int up = corner >> axis & 1;
        const double share = at[axis] - low[axis];
        weight *= up == 1 ? share : 1 - share;
        index[axis] = low[axis] + up;
      }
      sum += weight *
             distances_[static_cast<std::size_t>((index[2] * kSide + index[1]) * kSide + index[0])];
    }
    return sum;
  }
  std::vector<Vector3d> b_;
  Eigen::AlignedBox3d box_;
  std::vector<double> distances_;
};

}  // namespace

void compare_approximations(const PairOfMeshes& meshes) {
  const Mesh& a = *meshes.queried.a;
  const Mesh& b = *meshes.queried.b;
  const std::pair<const char*, std::unique_ptr<Approximation>> all[] = {
      {"capsule", std::make_unique<Capsules>(a, b)},
      {"spheres", std::make_unique<Spheres>(a, b)},
      {"hull", std::make_unique<Hulls>(a, b)},
      {"field", std::make_unique<Field>(a, b)}};
  for (const bool rotated : {false, true}) {
    figures::PoseSearch search(meshes.searched, meshes.queried, kSeed);
    for (std::uint32_t i = 0; i < figures::kProximities; ++i) {
      std::size_t alarms[4] = {0, 0, 0, 0};
      for (std::size_t pose = 0; pose < kPoses; ++pose) {
        const Placed placed = placed_of(search.next(static_cast<figures::Proximity>(i), rotated));
        for (std::size_t of = 0; of < 4; ++of) {
          alarms[of] += all[of].second->collide(placed.pose) ? 1 : 0;
        }
      }
      for (std::size_t of = 0; of < 4; ++of) {
        std::printf("approximation %s %s %s %s %zu %zu %zu\n", meshes.name.c_str(),
                    name_of_motion(rotated), figures::kProximityNames[i], all[of].first, kPoses,
                    alarms[of], all[of].second->bytes());
      }
    }
  }
}

}  // namespace compare
