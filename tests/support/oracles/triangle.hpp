// The oracle for triangle against triangle: a linear program whose answer comes with a proof.
//
// Any two closed triangles a and b intersect if and only if
//   sum l_i a_i = sum m_j b_j,  sum l_i = sum m_j = 1,  l, m >= 0
// has a solution. Phase one of the simplex method decides this in exact integers (Edmonds' integer
// pivoting: the tableau times the determinant of its basis). Bland's rule makes it terminate.
//
// The simplex need not be trusted: each answer has a certificate, checked separately.
// - intersects: weights l and m, that is, a common point
// - disjoint: a direction n with n.a_i < n.b_j for all i, j, that is, a plane strictly in between
// Exactly one of the two exists (Farkas' lemma). The oracle uses no determinant of the library, no
// case for coplanar or degenerate input, and no candidate axes.
//
// Range: coordinate differences below 2^20. A tableau entry is a minor of the system, which row
// operations reduce to a 3x3 determinant of differences, at most 4 * 2^60; the cost row sums three.
// A pivot takes the difference of two products, at most 2 * 3 * 2^62 * 2^62 < 2^127.
#pragma once

#if defined(__SIZEOF_INT128__)

#include "flashbvh/detail/predicates/triangle.hpp"

namespace flashbvh::test {

__extension__ typedef __int128 Wide;

/// The answer and its certificate.
struct Verdict {
  bool intersects;
  Wide weight_a[3];   ///< if they intersect: weights of a common point, times a positive number
  Wide weight_b[3];   ///< the weights in b of the common point, with an equal sum
  Wide direction[3];  ///< if they are disjoint: all of a lies strictly before all of b along it
};

/// A tableau of the simplex method: columns l0 l1 l2, m0 m1 m2, other variables, three artificial
/// ones, right side. Rows: coordinates, the sums of l and m, others.
template <int rows, int variables>
struct Tableau {
  static constexpr int kRows = rows;
  static constexpr int kVariables = variables;
  static constexpr int kRight = variables + 3;

  Wide entry[rows + 1][kRight + 1];  ///< the last row holds the reduced costs
  Wide scale;                        ///< all entries are integers over this, scale > 0
  int basis[rows];                   ///< the variable that each row solves for
  int sign[3];                       ///< the factors by which the coordinate rows were multiplied

  const Wide* cost() const { return entry[rows]; }
};

inline Wide along(const Point& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// The rows of two triangles, with l0 = m0 = 1 as start: coordinate row k reads
/// sum l_i (a_i - a_0) - sum m_j (b_j - b_0) + artificial = b_0 - a_0.
template <class AnyTableau>
AnyTableau start(const Triangle& a, const Triangle& b) {
  AnyTableau t = {};
  t.scale = 1;
  for (int k = 0; k < 3; ++k) {
    const Wide right = along(b.corner[0], k) - along(a.corner[0], k);
    t.sign[k] = right < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
      t.entry[k][i] = t.sign[k] * (along(a.corner[i], k) - along(a.corner[0], k));
      t.entry[k][3 + i] = t.sign[k] * (along(b.corner[0], k) - along(b.corner[i], k));
    }
    t.entry[k][AnyTableau::kVariables + k] = 1;
    t.entry[k][AnyTableau::kRight] = t.sign[k] * right;
    t.basis[k] = AnyTableau::kVariables + k;
  }
  for (int i = 0; i < 3; ++i) {
    t.entry[3][i] = 1;
    t.entry[4][3 + i] = 1;
  }
  t.entry[3][AnyTableau::kRight] = t.entry[4][AnyTableau::kRight] = 1;
  t.basis[3] = 0;
  t.basis[4] = 3;
  return t;
}

/// The row that limits the entering variable: least ratio, then, by Bland, least variable. There is
/// always one, since the objective cannot fall below zero.
template <class AnyTableau>
int leaving_row(const AnyTableau& t, int entering) {
  constexpr int right = AnyTableau::kRight;
  int best = -1;
  for (int row = 0; row < AnyTableau::kRows; ++row) {
    if (t.entry[row][entering] <= 0) {
      continue;
    }
    const Wide order = best < 0 ? -1
                                : t.entry[row][right] * t.entry[best][entering] -
                                      t.entry[best][right] * t.entry[row][entering];
    if (order < 0 || (order == 0 && t.basis[row] < t.basis[best])) {
      best = row;
    }
  }
  return best;
}

template <class AnyTableau>
void pivot(AnyTableau& t, int pivot_row, int entering) {
  const Wide by = t.entry[pivot_row][entering];
  for (int row = 0; row <= AnyTableau::kRows; ++row) {
    if (row == pivot_row) {
      continue;
    }
    const Wide factor = t.entry[row][entering];
    for (int column = 0; column <= AnyTableau::kRight; ++column) {
      t.entry[row][column] =
          (t.entry[row][column] * by - factor * t.entry[pivot_row][column]) / t.scale;
    }
  }
  t.basis[pivot_row] = entering;
  t.scale = by;
}

/// Pivots until no reduced cost is negative.
template <class AnyTableau>
void minimise(AnyTableau& t) {
  for (int column = 0; column < AnyTableau::kVariables;) {
    if (t.cost()[column] >= 0) {
      ++column;
      continue;
    }
    pivot(t, leaving_row(t, column), column);
    column = 0;
  }
}

/// Phase one: minimises the sum of the artificial variables; returns whether it is 0.
template <class AnyTableau>
bool is_feasible(AnyTableau& t) {
  for (int column = 0; column <= AnyTableau::kRight; ++column) {
    const bool is_artificial = column >= AnyTableau::kVariables && column < AnyTableau::kRight;
    for (int k = 0; k < 3 && !is_artificial; ++k) {
      t.entry[AnyTableau::kRows][column] -= t.entry[k][column];
    }
  }
  minimise(t);
  return t.cost()[AnyTableau::kRight] == 0;
}

/// Gets the weights of a point of a and of one of b, times the scale.
template <class AnyTableau>
void get_weights(const AnyTableau& t, Wide (&weight_a)[3], Wide (&weight_b)[3]) {
  for (int row = 0; row < AnyTableau::kRows; ++row) {
    const int variable = t.basis[row];
    if (variable < 6) {
      (variable < 3 ? weight_a[variable] : weight_b[variable - 3]) =
          t.entry[row][AnyTableau::kRight];
    }
  }
}

/// Gets the dual variables of the coordinate rows. `cost`: the cost of each artificial variable.
template <class AnyTableau>
void get_direction(const AnyTableau& t, Wide cost, Wide (&direction)[3]) {
  for (int k = 0; k < 3; ++k) {
    direction[k] = t.sign[k] * (cost * t.scale - t.cost()[AnyTableau::kVariables + k]);
  }
}

/// Whether two triangles intersect, with the certificate. Check it with is_proven().
inline Verdict decide(const Triangle& a, const Triangle& b) {
  auto t = start<Tableau<5, 6>>(a, b);
  Verdict verdict = {};
  verdict.intersects = is_feasible(t);
  get_weights(t, verdict.weight_a, verdict.weight_b);
  get_direction(t, 1, verdict.direction);
  return verdict;
}

/// Whether weights describe one point of a and of b, which is moved by `way` / the weights' sum.
inline bool is_common_point(const Wide (&weight_a)[3], const Wide (&weight_b)[3], const Triangle& a,
                            const Triangle& b, const Wide (&way)[3]) {
  Wide sum_a = 0;
  Wide sum_b = 0;
  Wide gap[3] = {way[0], way[1], way[2]};
  for (int i = 0; i < 3; ++i) {
    if (weight_a[i] < 0 || weight_b[i] < 0) {
      return false;
    }
    sum_a += weight_a[i];
    sum_b += weight_b[i];
    for (int k = 0; k < 3; ++k) {
      gap[k] += weight_b[i] * (along(b.corner[i], k) - along(a.corner[0], k)) -
                weight_a[i] * (along(a.corner[i], k) - along(a.corner[0], k));
    }
  }
  return sum_a > 0 && sum_a == sum_b && gap[0] == 0 && gap[1] == 0 && gap[2] == 0;
}

inline Wide along(const Wide (&direction)[3], const Point& p) {
  return direction[0] * p.x + direction[1] * p.y + direction[2] * p.z;
}

/// The least lead of a corner of b over a corner of a along a direction.
inline Wide ahead(const Wide (&direction)[3], const Triangle& a, const Triangle& b) {
  Wide least = along(direction, b.corner[0]) - along(direction, a.corner[0]);
  for (const Point& p : a.corner) {
    for (const Point& q : b.corner) {
      const Wide apart = along(direction, q) - along(direction, p);
      least = apart < least ? apart : least;
    }
  }
  return least;
}

/// Whether the certificate proves the verdict.
inline bool is_proven(const Verdict& v, const Triangle& a, const Triangle& b) {
  return v.intersects ? is_common_point(v.weight_a, v.weight_b, a, b, {0, 0, 0})
                      : ahead(v.direction, a, b) > 0;
}

}  // namespace flashbvh::test

#endif  // __SIZEOF_INT128__
