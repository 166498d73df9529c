// The oracle for triangle against triangle: a linear program whose answer proves itself.
//
// Closed triangles a and b, of whatever shape, intersect if and only if
//   sum l_i a_i = sum m_j b_j,  sum l_i = sum m_j = 1,  l, m >= 0
// has a solution. Phase one of the simplex method decides that in exact integers (Edmonds' integer
// pivoting: the tableau times the determinant of its basis) and, with Bland's rule, ends always.
//
// There is no need to trust the simplex: each answer comes with a certificate, checked on its own.
// - intersects: weights l and m, that is, a common point
// - disjoint: a direction n with n.a_i < n.b_j for all i, j, that is, a plane strictly in between
// One of both exists (Farkas' lemma), never both. No determinant of the library's, no case for
// coplanar or degenerate input, no candidate axes.
//
// Range: coordinate differences below 2^20. A tableau entry is a minor of the system, which row
// operations reduce to a 3x3 determinant of differences, at most 4 * 2^60; the cost row sums three.
// A pivot takes the difference of two products, at most 2 * 3 * 2^62 * 2^62 < 2^127.
#pragma once

#if defined(__SIZEOF_INT128__)

#include <initializer_list>

#include "flashbvh/detail/predicates/triangle.hpp"

namespace flashbvh::test {

__extension__ typedef __int128 Wide;

/// The answer and its certificate.
struct Verdict {
  bool intersects;
  Wide weight_a[3];   ///< where it intersects: a common point of both, times a positive number
  Wide weight_b[3];   ///< the weights of the same point in b, with the same sum
  Wide direction[3];  ///< where it doesn't: all of a lies strictly before all of b along it
};

/// The tableau of phase one: columns l0 l1 l2, m0 m1 m2, three artificial variables, right side.
struct Tableau {
  static constexpr int kRows = 5;
  static constexpr int kVariables = 6;
  static constexpr int kRight = 9;

  Wide entry[kRows + 1][kRight + 1];  ///< the last row holds the reduced costs
  Wide scale;                         ///< all entries are integers over this, scale > 0
  int basis[kRows];                   ///< the variable that each row solves for
  int sign[3];                        ///< by which the coordinate rows were multiplied
};

inline Wide along(const Point& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// The program with l0 = m0 = 1 as start: coordinate row k reads
/// sum l_i (a_i - a_0) - sum m_j (b_j - b_0) + artificial = b_0 - a_0.
inline Tableau start(const Triangle& a, const Triangle& b) {
  Tableau t = {};
  t.scale = 1;
  for (int k = 0; k < 3; ++k) {
    const Wide right = along(b.corner[0], k) - along(a.corner[0], k);
    t.sign[k] = right < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
      t.entry[k][i] = t.sign[k] * (along(a.corner[i], k) - along(a.corner[0], k));
      t.entry[k][3 + i] = t.sign[k] * (along(b.corner[0], k) - along(b.corner[i], k));
    }
    t.entry[k][6 + k] = 1;
    t.entry[k][Tableau::kRight] = t.sign[k] * right;
    t.basis[k] = 6 + k;
    for (int column : {0, 1, 2, 3, 4, 5, Tableau::kRight}) {
      t.entry[Tableau::kRows][column] -= t.entry[k][column];
    }
  }
  for (int i = 0; i < 3; ++i) {
    t.entry[3][i] = 1;
    t.entry[4][3 + i] = 1;
  }
  t.entry[3][Tableau::kRight] = t.entry[4][Tableau::kRight] = 1;
  t.basis[3] = 0;
  t.basis[4] = 3;
  return t;
}

/// The row that limits the entering variable: least ratio, then, by Bland, least variable.
/// There is always one, since the sum of the artificial variables can't fall below zero.
inline int leaving_row(const Tableau& t, int entering) {
  int best = -1;
  for (int row = 0; row < Tableau::kRows; ++row) {
    if (t.entry[row][entering] <= 0) {
      continue;
    }
    const Wide order = best < 0 ? -1
                                : t.entry[row][Tableau::kRight] * t.entry[best][entering] -
                                      t.entry[best][Tableau::kRight] * t.entry[row][entering];
    if (order < 0 || (order == 0 && t.basis[row] < t.basis[best])) {
      best = row;
    }
  }
  return best;
}

inline void pivot(Tableau& t, int pivot_row, int entering) {
  const Wide by = t.entry[pivot_row][entering];
  for (int row = 0; row <= Tableau::kRows; ++row) {
    if (row == pivot_row) {
      continue;
    }
    const Wide factor = t.entry[row][entering];
    for (int column = 0; column <= Tableau::kRight; ++column) {
      t.entry[row][column] =
          (t.entry[row][column] * by - factor * t.entry[pivot_row][column]) / t.scale;
    }
  }
  t.basis[pivot_row] = entering;
  t.scale = by;
}

/// Whether two triangles intersect, with the certificate. Check it with is_proven().
inline Verdict decide(const Triangle& a, const Triangle& b) {
  Tableau t = start(a, b);
  const Wide* const cost = t.entry[Tableau::kRows];
  for (int column = 0; column < Tableau::kVariables;) {
    if (cost[column] >= 0) {
      ++column;
      continue;
    }
    pivot(t, leaving_row(t, column), column);
    column = 0;
  }
  Verdict verdict = {};
  verdict.intersects = cost[Tableau::kRight] == 0;
  for (int row = 0; row < Tableau::kRows; ++row) {
    const int variable = t.basis[row];
    if (variable < Tableau::kVariables) {
      (variable < 3 ? verdict.weight_a[variable] : verdict.weight_b[variable - 3]) =
          t.entry[row][Tableau::kRight];
    }
  }
  for (int k = 0; k < 3; ++k) {
    verdict.direction[k] = t.sign[k] * (t.scale - cost[6 + k]);  // the dual variable of row k
  }
  return verdict;
}

/// Whether the weights of the verdict describe one point of a and of b.
inline bool is_common_point(const Verdict& v, const Triangle& a, const Triangle& b) {
  Wide sum_a = 0;
  Wide sum_b = 0;
  Wide gap[3] = {};
  for (int i = 0; i < 3; ++i) {
    if (v.weight_a[i] < 0 || v.weight_b[i] < 0) {
      return false;
    }
    sum_a += v.weight_a[i];
    sum_b += v.weight_b[i];
    for (int k = 0; k < 3; ++k) {
      gap[k] += v.weight_a[i] * (along(a.corner[i], k) - along(a.corner[0], k)) -
                v.weight_b[i] * (along(b.corner[i], k) - along(a.corner[0], k));
    }
  }
  return sum_a > 0 && sum_a == sum_b && gap[0] == 0 && gap[1] == 0 && gap[2] == 0;
}

/// Whether the direction of the verdict has each corner of a strictly before each corner of b.
inline bool is_separating(const Verdict& v, const Triangle& a, const Triangle& b) {
  for (const Point& p : a.corner) {
    for (const Point& q : b.corner) {
      Wide ahead = 0;
      for (int k = 0; k < 3; ++k) {
        ahead += v.direction[k] * (along(q, k) - along(p, k));
      }
      if (ahead <= 0) {
        return false;
      }
    }
  }
  return true;
}

/// Whether the certificate proves the verdict.
inline bool is_proven(const Verdict& v, const Triangle& a, const Triangle& b) {
  return v.intersects ? is_common_point(v, a, b) : is_separating(v, a, b);
}

}  // namespace flashbvh::test

#endif  // __SIZEOF_INT128__
