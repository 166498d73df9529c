// Vectors of three numbers of any type, for oracles.
#pragma once

#include <array>
#include <cmath>

namespace flashbvh::test {

template <class Number>
using Vector = std::array<Number, 3>;
using FloatVector = Vector<double>;

/// The coordinates of a point, a vertex or a normal.
template <class Number, class Any>
Vector<Number> vector_of(const Any& p) {
  return {Number(p.x), Number(p.y), Number(p.z)};
}

template <class Number>
Vector<Number> minus(const Vector<Number>& u, const Vector<Number>& v) {
  return {u[0] - v[0], u[1] - v[1], u[2] - v[2]};
}
template <class Number>
Vector<Number> times(const typename Vector<Number>::value_type& n, const Vector<Number>& v) {
  return {n * v[0], n * v[1], n * v[2]};
}
/// u + share * v.
template <class Number>
Vector<Number> plus(const Vector<Number>& u, const typename Vector<Number>::value_type& share,
                    const Vector<Number>& v) {
  return {u[0] + share * v[0], u[1] + share * v[1], u[2] + share * v[2]};
}
template <class Number>
Number dot(const Vector<Number>& u, const Vector<Number>& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}
template <class Number>
Vector<Number> cross(const Vector<Number>& u, const Vector<Number>& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline double length_of(const FloatVector& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace flashbvh::test
