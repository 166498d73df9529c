// Contacts against exact rationals, on the host.
#include "flashbvh/contact.hpp"
#include "support/oracles/contact.hpp"
#include "support/test.hpp"
#include "support/triangle_pairs.hpp"

namespace flashbvh::test {
namespace {

const uint32_t kPairs = rounds(4000u, 20000u);

/// The documented bound, in hundredths of 1/256 cell.
constexpr Wide kBound = 53;

/// A contact and the exact intersection, in one frame.
struct Judge {
  Triangle a;
  Triangle b;
  Contact contact;
  std::vector<Rational> corners;

  Judge(const Triangle& t, const Triangle& u)
      : a(t), b(u), contact(contact_of(t, u)), corners(common_corners(t, u)) {}

  Wide end(int i, int axis) const {
    const FinePoint& p = contact.ends[i];
    return (axis == 0 ? p.x : axis == 1 ? p.y : p.z) - Wide{kFineOne} * along(a.corner[0], axis);
  }

  /// Whether each coordinate of the end is within the bound of the corner's.
  bool is_near(int i, const Rational& corner) const {
    for (int axis = 0; axis < 3; ++axis) {
      const Wide off =
          kFineOne * corner.at[static_cast<std::size_t>(axis)] - end(i, axis) * corner.by;
      if (100 * (off < 0 ? -off : off) > kBound * corner.by) {
        return false;
      }
    }
    return true;
  }

  bool ends_are_corners() const {
    const auto is_corner = [&](int i) {
      return std::any_of(corners.begin(), corners.end(),
                         [&](const Rational& corner) { return is_near(i, corner); });
    };
    return is_corner(0) && is_corner(1);
  }

  /// The largest difference of the ends along an axis.
  Wide reach() const {
    Wide most = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Wide between = end(1, axis) - end(0, axis);
      const Wide size = between < 0 ? -between : between;
      most = size > most ? size : most;
    }
    return most;
  }

  /// Whether no two corners are farther apart along an axis than the ends, up to the bound.
  bool ends_are_farthest() const {
    for (const Rational& p : corners) {
      for (const Rational& q : corners) {
        for (std::size_t k = 0; k < 3; ++k) {
          // Products of numerators below 2^71 would overflow: in 1/2^16 of 1/256 cell, rounded.
          const Wide one = Wide{1} << 16;
          const Wide between = p.at[k] * kFineOne * one / p.by - q.at[k] * kFineOne * one / q.by;
          if (100 * between > (100 * reach() + 2 * kBound) * one + 200) {
            return false;
          }
        }
      }
    }
    return true;
  }

  bool is_point() const {
    for (const Rational& p : corners) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (p.at[k] * corners[0].by != corners[0].at[k] * p.by) {
          return false;
        }
      }
    }
    return true;
  }

  bool point_is_point() const { return !is_point() || same(contact.ends[0], contact.ends[1]); }
  bool is_ordered() const {
    const FinePoint& p = contact.ends[0];
    const FinePoint& q = contact.ends[1];
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z <= q.z;
  }
  bool kind_is_right() const {
    const WideVector of_a = WideTriangle(a, a.corner[0]).normal();
    const WideTriangle wide_b(b, a.corner[0]);
    const WideVector of_b = wide_b.normal();
    const bool thin = of_a == WideVector{} || of_b == WideVector{};
    const bool flat = cross(of_a, of_b) == WideVector{} && test::dot(of_a, wide_b.corner[0]) == 0;
    return contact.kind == (thin   ? ContactKind::degenerate
                            : flat ? ContactKind::coplanar
                                   : ContactKind::segment);
  }
  bool normals_are_right() const {
    return vector_of<Wide>(contact.normal_a) == WideTriangle(a, a.corner[0]).normal() &&
           vector_of<Wide>(contact.normal_b) == WideTriangle(b, a.corner[0]).normal();
  }
};

/// Whether the contact of two triangles fulfils the header's promises, if they intersect.
bool is_right(const Triangle& a, const Triangle& b) {
  const Judge judge(a, b);
  CAPTURE(judge.corners.size());
  CHECK(detail::triangles_intersect(a, b) == !judge.corners.empty());
  if (judge.corners.empty()) {
    return true;
  }
  const bool right = judge.ends_are_corners() && judge.ends_are_farthest() &&
                     judge.point_is_point() && judge.is_ordered() && judge.kind_is_right() &&
                     judge.normals_are_right();
  if (!right) {
    UNSCOPED_INFO("corners " << judge.ends_are_corners() << ", farthest "
                             << judge.ends_are_farthest() << ", point " << judge.point_is_point()
                             << ", order " << judge.is_ordered() << ", kind "
                             << judge.kind_is_right() << ", normals " << judge.normals_are_right());
  }
  return right;
}

}  // namespace

TEST_CASE("contact: small triangles agree with exact rationals", "[contact][oracle]") {
  for_rounds(2 * kPairs, [&](Random& random, uint32_t) {
    const int32_t size = random.between(1, 4);
    const TransformedPair pair = {triangle_within(random, size), triangle_within(random, size)};
    REQUIRE(is_right(pair.a, pair.b));
  });
}

TEST_CASE("contact: triangles of every kind agree with exact rationals", "[contact][oracle]") {
  uint32_t intersecting[3] = {};
  for_rounds(3 * kPairs, [&](Random& random, uint32_t) {
    const TransformedPair pair = translated_anywhere(random, any_pair(random));
    if (!detail::triangles_intersect(pair.a, pair.b)) {
      return;
    }
    ++intersecting[static_cast<unsigned>(contact_of(pair.a, pair.b).kind)];
    REQUIRE(is_right(pair.a, pair.b));
  });
  CHECK(intersecting[0] > kPairs / 4);
  CHECK(intersecting[1] > kPairs / 16);
  CHECK(intersecting[2] > kPairs / 16);
}

}  // namespace flashbvh::test
