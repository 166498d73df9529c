#include "evaluate/poses.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "flashbvh/float.hpp"
#include "reference/transformed_coordinate.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"
#include "text/tokens.hpp"

namespace flashbvh::tool {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

double determinant(const Matrix& r) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    sum += r[0][i] * (r[1][j] * r[2][k] - r[1][k] * r[2][j]);
  }
  return sum;
}

/// The largest entry of R^T R - 1 and of R R^T - 1.
double defect(const Matrix& r) {
  double worst = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t k = 0; k <= j; ++k) {
      double columns = j == k ? -1 : 0;
      double rows = columns;
      for (std::size_t i = 0; i < 3; ++i) {
        columns += r[i][j] * r[i][k];
        rows += r[j][i] * r[k][i];
      }
      worst = std::max({worst, std::fabs(columns), std::fabs(rows)});
    }
  }
  return worst;
}

[[noreturn]] void refuse_rotation(const Matrix& rotation, const std::string& place) {
  const double most = static_cast<double>(kRotationTolerance) / kRotationOne;
  if (defect(rotation) <= 2 * most && determinant(rotation) < 0) {
    throw UserError(place,
                    "the matrix mirrors; a rotation has the determinant 1, not -1: turn the sign "
                    "of one row, or mirror the mesh and bake it");
  }
  throw UserError(place,
                  "the first 9 numbers are no rotation: their rows and columns must have length 1 "
                  "and be perpendicular within ",
                  shortest(most), ", and are off by ", shortest(defect(rotation)),
                  "; write the rotation row by row, then the translation, unscaled and with at "
                  "least 5 decimals");
}

[[noreturn]] void refuse_translation(double length, double cell, const std::string& place) {
  throw UserError(place, "the pose translates B by ", shortest(length), ", the most is ",
                  shortest(kMaxTranslation * cell), " (", kMaxTranslation, " cells)");
}

/// Cells, and what is left of them in 1/65,536.
struct AxisTranslation {
  std::int32_t cells;
  std::int16_t fraction;
};

AxisTranslation axis_translation(double length, double cell, const std::string& place) {
  const double fractions = std::round(length / cell * 65536);
  const double cells = std::floor((fractions + 32768) / 65536);
  if (!(std::fabs(cells) <= kMaxTranslation)) {
    refuse_translation(length, cell, place);
  }
  return {static_cast<std::int32_t>(cells), static_cast<std::int16_t>(fractions - cells * 65536)};
}

template <class Tree>
std::vector<LatticePoint> rotated_vertices(const Tree& b, const Pose& pose) {
  std::vector<LatticePoint> vertices;
  for (std::uint32_t i = 0; i < b.vertex_count; ++i) {
    const auto along = [&](int axis) {
      return std::int64_t{transformed_coordinate(b.origin, b.vertices[i], pose, axis)};
    };
    vertices.push_back({along(0), along(1), along(2)});
  }
  return vertices;
}

}  // namespace

RigidPose parse_pose(std::string_view text, const std::string& place) {
  const std::vector<std::string_view> words = words_of(text);
  if (words.size() != 12) {
    throw UserError(place, "has ", words.size(),
                    " numbers; a pose has 12: the rotation row by row, then the translation");
  }
  std::array<double, 12> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto number = parse_number(words[i]);
    if (!number) {
      throw UserError(place, quoted(words[i]), " is no finite number; a pose has 12 of them");
    }
    numbers[i] = *number;
  }
  RigidPose pose{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      pose.rotation[row][column] = numbers[3 * row + column];
    }
    pose.translation[row] = numbers[9 + row];
  }
  return pose;
}

std::vector<PoseAtLine> read_poses(const std::string& path) {
  const std::string text = read_file(path);
  std::vector<PoseAtLine> poses;
  for (Lines lines(text); lines.next_content();) {
    const std::string place = concat(path, ":", lines.number());
    poses.push_back({parse_pose(lines.line(), place), place});
  }
  if (poses.empty()) {
    throw UserError(path, "has no poses; write 12 numbers a line");
  }
  return poses;
}

Pose lattice_pose(const RigidPose& pose, double cell, const std::string& place) {
  std::int32_t rotation[3][3] = {};
  std::int32_t cells[3] = {};
  std::int16_t fraction[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double entry = pose.rotation[i][j];
      if (!(std::fabs(entry) < 1.5)) {
        refuse_rotation(pose.rotation, place);
      }
      rotation[i][j] = static_cast<std::int32_t>(std::round(entry * kRotationOne));
    }
    const AxisTranslation along = axis_translation(pose.translation[i], cell, place);
    cells[i] = along.cells;
    fraction[i] = along.fraction;
  }
  const Pose on_lattice = Pose::rigid(rotation, cells, fraction);
  if (on_lattice.status() != Status::done) {
    refuse_rotation(pose.rotation, place);
  }
  return on_lattice;
}

Pose pose_of_floats(const RigidPose& pose, double cell, const std::string& place) {
  float rotation[3][3] = {};
  float translation[3] = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rotation[i][j] = static_cast<float>(pose.rotation[i][j]);
    }
    translation[i] = static_cast<float>(pose.translation[i]);
  }
  std::uint64_t cell_bits = 0;
  std::memcpy(&cell_bits, &cell, sizeof cell_bits);
  const Pose made = flashbvh::pose_of(rotation, translation, cells_per_unit(cell_bits));
  if (made.status() == Status::not_a_rotation) {
    refuse_rotation(pose.rotation, place);
  }
  if (made.status() != Status::done) {
    const auto& t = pose.translation;
    refuse_translation(
        *std::max_element(t.begin(), t.end(),
                          [](double u, double v) { return std::fabs(u) < std::fabs(v); }),
        cell, place);
  }
  return made;
}

std::vector<Pose> read_lattice_poses(const std::string& path, double cell, bool as_floats) {
  std::vector<Pose> poses;
  for (const PoseAtLine& pose : read_poses(path)) {
    poses.push_back(as_floats ? pose_of_floats(pose.pose, cell, pose.place)
                              : lattice_pose(pose.pose, cell, pose.place));
  }
  return poses;
}

std::vector<LatticePoint> transformed_vertices(const AnyTree& b, const Pose& pose) {
  if (!pose.is_translation()) {
    return std::visit([&](const auto& tree) { return rotated_vertices(tree, pose); }, b);
  }
  std::vector<LatticePoint> vertices = vertices_of(b);
  for (LatticePoint& point : vertices) {
    for (int axis = 0; axis < 3; ++axis) {
      point[static_cast<std::size_t>(axis)] += pose.translation(axis);
    }
  }
  return vertices;
}

}  // namespace flashbvh::tool
