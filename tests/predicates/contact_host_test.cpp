// Contacts against exact rationals, and against their own symmetries.
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

Normal opposite(const Normal& n) {
  return {-n.x, -n.y, -n.z};
}

/// Whether another order of the corners, and of the arguments, gives this contact. The last three
/// orders reverse the winding.
bool order_gives(const Contact& expected, const Triangle& a, const Triangle& b, int of_a,
                 int of_b) {
  const Contact c = contact_of(ordered(a, of_a), ordered(b, of_b));
  const Contact d = contact_of(ordered(b, of_b), ordered(a, of_a));
  const Normal normal_a = of_a < 3 ? expected.normal_a : opposite(expected.normal_a);
  const Normal normal_b = of_b < 3 ? expected.normal_b : opposite(expected.normal_b);
  return same_place(c, expected) && same_place(d, expected) && same(c.normal_a, normal_a) &&
         same(d.normal_b, normal_a) && same(c.normal_b, normal_b) && same(d.normal_a, normal_b);
}

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
    const Triangle a = triangle_within(random, size);
    const Triangle b = triangle_within(random, size);
    REQUIRE(is_right(a, b));
  });
}

TEST_CASE("contact: triangles of every kind agree with exact rationals", "[contact][oracle]") {
  uint32_t intersecting[3] = {};
  for_rounds(3 * kPairs, [&](Random& random, uint32_t) {
    const TransformedPair pair = translated_anywhere(random, any_pair(random));
    if (!detail::triangles_intersect(pair.a, pair.b)) {
      return;
    }
    const Contact contact = contact_of(pair.a, pair.b);
    ++intersecting[static_cast<unsigned>(contact.kind)];
    REQUIRE(is_right(pair.a, pair.b));
    for (int i = 0; i < 36; i += 1 + static_cast<int>(random.below(12))) {
      CAPTURE(i);
      REQUIRE(order_gives(contact, pair.a, pair.b, i % 6, i / 6));
    }
  });
  CHECK(intersecting[0] > kPairs / 4);
  CHECK(intersecting[1] > kPairs / 16);
  CHECK(intersecting[2] > kPairs / 16);
}

TEST_CASE("contact: the order of arguments moves no point where long edges cross") {
  uint32_t intersecting = 0;
  for_rounds(20 * kPairs, [&](Random& random, uint32_t) {
    Triangle t[2];
    for (Triangle& u : t) {
      u = triangle_within(random, kMaxContactSpan);
      u.corner[2] = u.corner[1];
      for (Point& corner : u.corner) {
        corner.z = corner.x;
      }
    }
    if (detail::triangles_intersect(t[0], t[1])) {
      ++intersecting;
      REQUIRE(same_place(contact_of(t[0], t[1]), contact_of(t[1], t[0])));
    }
  });
  CHECK(intersecting > kPairs / 4);
}

TEST_CASE("contact: disjoint triangles do no harm, and their normals are right") {
  for_rounds(5 * kPairs, [&](Random& random, uint32_t) {
    const Triangle a = any_pair(random).a;
    const Triangle b = any_pair(random).b;
    const Triangle far_a = translated_anywhere(random, {a, a}).a;
    const Triangle far_b = translated_anywhere(random, {b, b}).b;
    const Contact disjoint = contact_of(far_a, far_b);
    REQUIRE(same(disjoint.normal_a, contact_of(a, a).normal_a));
    REQUIRE(same(disjoint.normal_b, contact_of(b, b).normal_b));
  });
}

}  // namespace flashbvh::test
