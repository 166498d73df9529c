#include "robot/kinematics.hpp"

#include "bake/length.hpp"

namespace flashbvh::tool {

Transform transform_of_quaternion(const std::array<double, 4>& quaternion,
                                  const Vector3& translation) {
  const auto [w, x, y, z] = quaternion;
  return {{{{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}}},
          translation};
}

Vector3 rotated(const Transform& transform, const Vector3& vector) {
  const auto& [x, y, z] = transform.rotation;
  const auto dot = [&](const Vector3& row) {
    return row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2];
  };
  return {dot(x), dot(y), dot(z)};
}

Vector3 rotated_back(const Transform& transform, const Vector3& vector) {
  Vector3 sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      sum[j] += transform.rotation[i][j] * vector[i];
    }
  }
  return sum;
}

double length_of(const Vector3& vector) {
  return bake::length(vector[0], vector[1], vector[2]);
}

Vector3 placed(const Transform& transform, const Vector3& point) {
  Vector3 sum = rotated(transform, point);
  for (std::size_t i = 0; i < 3; ++i) {
    sum[i] += transform.translation[i];
  }
  return sum;
}

Transform composed(const Transform& outer, const Transform& inner) {
  Transform made;
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3 column =
        rotated(outer, {inner.rotation[0][j], inner.rotation[1][j], inner.rotation[2][j]});
    for (std::size_t i = 0; i < 3; ++i) {
      made.rotation[i][j] = column[i];
    }
  }
  made.translation = placed(outer, inner.translation);
  return made;
}

Transform inverse(const Transform& transform) {
  Transform made;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      made.rotation[i][j] = transform.rotation[j][i];
    }
  }
  const Vector3 back = rotated_back(transform, transform.translation);
  made.translation = {-back[0], -back[1], -back[2]};
  return made;
}

}  // namespace flashbvh::tool
