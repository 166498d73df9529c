#include "evaluate/poses.hpp"

#include <algorithm>
#include <cmath>

#include "flashbvh/float.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

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

using Words = std::vector<std::string_view>;

/// The words of a line, which must be so many. `what`, such as "a ray has 6"; `such`: a whole line.
Words words_in(std::string_view line, std::size_t count, const std::string& what, const char* such,
               const std::string& place) {
  Words words = words_of(line);
  if (words.size() != count) {
    throw UserError(place, "has ", words.size(), " numbers; ", what,
                    ", separated by blanks, without a header, such as ", such);
  }
  return words;
}

std::int32_t cells_of(std::string_view word, double cell, const std::string& place) {
  const double number = number_of(word, place);
  const double cells = std::round(number / cell);
  if (!(std::fabs(cells) <= kMaxTranslation)) {
    throw UserError(place, "the point lies at ", shortest(number), ", the most is ",
                    shortest(kMaxTranslation * cell), " (", kMaxTranslation, " cells)");
  }
  return static_cast<std::int32_t>(cells);
}

/// The point of three words, from `first` on.
Point point_of(const Words& words, std::size_t first, double cell, const std::string& place) {
  return {cells_of(words[first], cell, place), cells_of(words[first + 1], cell, place),
          cells_of(words[first + 2], cell, place)};
}

Transform parse_pose(std::string_view text, const std::string& place) {
  const Words words =
      words_in(text, 12, "a pose has 12: the rotation row by row, then the translation",
               "1 0 0 0 1 0 0 0 1 0 0 5", place);
  Transform pose{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    (i < 9 ? pose.rotation[i / 3][i % 3] : pose.translation[i - 9]) =
        number_of(words[i], place, "; a pose has 12 of them");
  }
  return pose;
}

}  // namespace

Pose lattice_pose(const Transform& pose, double cell, const std::string& place) {
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
    const double parts = std::round(pose.translation[i] / cell * 65536);
    const double whole = std::floor((parts + 32768) / 65536);
    if (!(std::fabs(whole) <= kMaxTranslation)) {
      refuse_translation(pose.translation[i], cell, place);
    }
    cells[i] = static_cast<std::int32_t>(whole);
    fraction[i] = static_cast<std::int16_t>(parts - whole * 65536);
  }
  const Pose on_lattice = Pose::rigid(rotation, cells, fraction);
  if (on_lattice.status() != Status::done) {
    refuse_rotation(pose.rotation, place);
  }
  return on_lattice;
}

Pose read_lattice_pose(std::string_view text, double cell, const std::string& place) {
  return lattice_pose(parse_pose(text, place), cell, place);
}

std::vector<Pose> read_lattice_poses(const std::string& path, double cell) {
  return read_lines<Pose>(path, "has no poses; write 12 numbers",
                          [&](std::string_view line, const std::string& place) {
                            return read_lattice_pose(line, cell, place);
                          });
}

std::array<double, 12> pose_numbers(const Pose& pose, double cell) {
  std::array<double, 12> numbers{};
  for (int i = 0; i < 12; ++i) {
    numbers[static_cast<std::size_t>(i)] =
        i < 9 ? static_cast<double>(pose.rotation(i / 3, i % 3)) / kRotationOne
              : (pose.translation(i - 9) + pose.fraction(i - 9) / 65536.0) * cell;
  }
  return numbers;
}

std::vector<Point> read_lattice_points(const std::string& path, double cell) {
  return read_lines<Point>(path, "is empty; write 3 numbers",
                           [&](std::string_view line, const std::string& place) {
                             const Words words = words_in(line, 3, "a point has 3", "0 0 5", place);
                             return point_of(words, 0, cell, place);
                           });
}

std::vector<Segment> read_lattice_rays(const std::string& path, double cell) {
  return read_lines<Segment>(
      path, "is empty; write 6 numbers",
      [&](std::string_view line, const std::string& place) -> Segment {
        const Words words = words_in(line, 6, "a ray has 6, from and to", "0 0 5 0 0 -5", place);
        return {point_of(words, 0, cell, place), point_of(words, 3, cell, place)};
      });
}

}  // namespace flashbvh::tool
