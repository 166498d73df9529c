#include "support.hpp"

namespace robot_check {
namespace {

/// The steps of an edge of the octahedron |x| + |y| + |z| = 1.
constexpr int kSteps = 72;
/// The parts of a whole turn into which arcs are divided.
constexpr double kParts = 128;

/// The index of the direction with x and y in steps; `face` has the signs of x, y and z as bits.
std::size_t place_of(int face, int x, int y) {
  const int row = face * (kSteps + 1) + x;
  return static_cast<std::size_t>(row) * (kSteps + 1) + static_cast<std::size_t>(y);
}

/// A factor of x and y and a turn about z that give the corners of a polygon around an arc.
struct Corner {
  double c, s;

  Vec operator()(const Vec& v) const { return {c * v.x - s * v.y, s * v.x + c * v.y, v.z}; }
};

std::vector<Corner> corners_round(const Range& arc) {
  const int count = std::max(1, static_cast<int>(kParts * (arc.upper - arc.lower) / (2 * M_PI)));
  const double part = (arc.upper - arc.lower) / count;
  const double out = 1 / std::cos(part / 2);
  std::vector<Corner> corners = {{std::cos(arc.lower), std::sin(arc.lower)},
                                 {std::cos(arc.upper), std::sin(arc.upper)}};
  for (int i = 0; i < count; ++i) {
    const double angle = arc.lower + (i + 0.5) * part;
    corners.push_back({out * std::cos(angle), out * std::sin(angle)});
  }
  return corners;
}

}  // namespace

Range range_of(const Joint& joint) {
  const bool is_whole =
      joint.is_free() || (!joint.slides() && 1.0 * joint.upper - joint.lower >= 1 << 28);
  return is_whole ? Range{-M_PI, M_PI}
                  : Range{joint.lower * joint.unit(), joint.upper * joint.unit()};
}

template <class Function>
Support::Support(const Function& value) : values_(place_of(8, 0, 0), 0.0) {
  for (int face = 0; face < 8; ++face) {
    for (int x = 0; x <= kSteps; ++x) {
      for (int y = 0; y <= kSteps - x; ++y) {
        const double z = kSteps - x - y;
        values_[place_of(face, x, y)] =
            value(1.0 / kSteps *
                  Vec{(face & 1) != 0 ? -x : 1.0 * x, (face & 2) != 0 ? -y : 1.0 * y,
                      (face & 4) != 0 ? -z : z});
      }
    }
  }
}

Support::Support(const Body& body)
    : Support([&](const Vec& direction) {
        double most = -HUGE_VAL;
        for (const Triangle& t : body.triangles()) {
          most = std::max({most, dot(direction, t[0]), dot(direction, t[1]), dot(direction, t[2])});
        }
        return most;
      }) {}

double Support::operator()(const Vec& u) const {
  const double size = std::fabs(u.x) + std::fabs(u.y) + std::fabs(u.z);
  if (size == 0) {
    return 0;
  }
  const int face = (u.x < 0 ? 1 : 0) + (u.y < 0 ? 2 : 0) + (u.z < 0 ? 4 : 0);
  const double at_x = std::fabs(u.x) / size * kSteps;
  const double at_y = std::fabs(u.y) / size * kSteps;
  const int x = std::min(static_cast<int>(at_x), kSteps - 1);
  const int y = std::min(static_cast<int>(at_y), kSteps - 1 - x);
  const double part_x = at_x - x;
  const double part_y = at_y - y;
  const double on_x = values_[place_of(face, x + 1, y)];
  const double on_y = values_[place_of(face, x, y + 1)];
  const double sum = part_x + part_y;
  return size * (sum <= 1
                     ? (1 - sum) * values_[place_of(face, x, y)] + part_x * on_x + part_y * on_y
                     : (sum - 1) * values_[place_of(face, x + 1, y + 1)] + (1 - part_y) * on_x +
                           (1 - part_x) * on_y);
}

Support Support::swept(const Joint& joint) const {
  const Range range = range_of(joint);
  const Frame& fixed = joint.fixed;
  if (joint.slides()) {
    return Support([&](const Vec& u) {
      const Vec v = fixed.turned_back(u);
      return (*this)(v) + std::max(range.lower * v.z, range.upper * v.z) + dot(u, fixed.origin);
    });
  }
  const std::vector<Corner> back = corners_round({-range.upper, -range.lower});
  return Support([&](const Vec& u) {
    const Vec v = fixed.turned_back(u);
    double most = -HUGE_VAL;
    for (const Corner& corner : back) {
      most = std::max(most, (*this)(corner(v)));
    }
    return most + dot(u, fixed.origin);
  });
}

double Support::from_axis() const {
  double most = 0;
  for (const Corner& corner : corners_round({-M_PI, M_PI})) {
    most = std::max(most, (*this)(corner({1, 0, 0})));
  }
  return most;
}

}  // namespace robot_check
