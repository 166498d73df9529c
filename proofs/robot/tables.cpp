// Each byte of a distance table, by its own joint box.
#include <mutex>

#include "checks.hpp"

namespace robot_check {
namespace {

/// The joint boxes of a joint: their width is the least power of two that gives at most 32.
struct Axis {
  std::string name;
  double lower, width, unit;
  double upper;
  std::size_t count;

  explicit Axis(const Joint& joint) : name(joint.name), unit(joint.unit()) {
    const std::int64_t first = joint.is_free() ? -(1 << 27) : joint.lower;
    const std::int64_t last = joint.is_free() ? (1 << 27) - 1 : joint.upper;
    int shift = 0;
    while ((last - first) >> shift >= 32) {
      ++shift;
    }
    lower = static_cast<double>(first);
    upper = static_cast<double>(joint.is_free() ? last + 1 : last);
    width = std::ldexp(1, shift);
    count = static_cast<std::size_t>((last - first) >> shift) + 1;
  }

  /// The range of a joint box, enlarged by a coordinate on each side.
  Range range(std::size_t box) const {
    const double from = lower + static_cast<double>(box) * width;
    return {(from - 1) * unit, (std::min(from + width, upper) + 1) * unit};
  }
};

/// The distance of a table's byte, in cells.
double distance_of(std::uint8_t byte) {
  return byte == 0 ? 0 : std::ldexp(16 + byte % 16, byte / 16);
}

struct Table {
  const Pair* pair;
  std::vector<Axis> axes;
  std::size_t first;
  std::size_t size;
};

std::vector<Table> tables_of(const Robot& robot) {
  std::vector<Table> tables;
  std::size_t first = 0;
  for (const Pair& pair : robot.pairs) {
    Robot::Between between = robot.between(pair.a, pair.b);
    between.a.insert(between.a.end(), between.b.begin(), between.b.end());
    Table table{&pair, {}, first, 1};
    bool has_mimic = false;
    for (const std::uint32_t joint : between.a) {
      table.axes.emplace_back(robot.joints[joint]);
      table.size *= table.axes.back().count;
      has_mimic = has_mimic || robot.joints[joint].shift != 0;
    }
    if (!has_mimic && !table.axes.empty() && table.axes.size() <= 2) {
      tables.push_back(table);
      first += table.size;
    }
  }
  return tables;
}

}  // namespace

void check_tables(const Robot& robot, const Bodies& bodies, std::size_t most_boxes,
                  Report& report) {
  const std::vector<Table> tables = tables_of(robot);
  const std::size_t size = tables.empty() ? 0 : tables.back().first + tables.back().size;
  if (!robot.tables.empty() && robot.tables.size() != size) {
    report.refuse(
        text("distance tables: ", robot.tables.size(), " bytes, but the pairs' have ", size));
  }
  std::mutex mutex;
  double nearest = HUGE_VAL;
  std::size_t known = 0;
  for_each_row(robot.tables.size() == size ? tables.size() : 0, [&](std::size_t i) {
    const Table& table = tables[i];
    const Pair& pair = *table.pair;
    PairSpace space(robot, pair.a, bodies[pair.a], pair.b, bodies[pair.b]);
    for (std::size_t place = 0; place < table.size; ++place) {
      const double stored = distance_of(robot.tables[table.first + place]);
      if (stored == 0) {
        continue;
      }
      Box box(table.axes.size());  // in the space's order: a's own first, b's own last
      std::size_t rest = place;
      for (std::size_t axis = box.size(); axis-- != 0; rest /= table.axes[axis].count) {
        const bool is_mirrored = pair.joints_b == 2;
        box[is_mirrored ? 1 - axis : axis] = table.axes[axis].range(rest % table.axes[axis].count);
      }
      const Answer answer = space.prove(box, stored, stored - 0.001, most_boxes);
      const std::lock_guard<std::mutex> lock(mutex);
      ++known;
      nearest = std::min(nearest, answer.nearest - stored);
      const std::string row = text("table of ", robot.pair_name(pair.a, pair.b), ", byte ", place,
                                   ": ", stored, " cells");
      if (answer.found == Found::near) {
        report.refuse(text(row, ", but ", answer.nearest, " at ", space.text(answer.at),
                           ": a guard looks again too late"));
      } else if (answer.found == Found::undecided) {
        report.doubt(text(row, ", not proven about ", space.text(answer.at)));
      }
    }
  });
  report.end("tables", text(tables.size(), " tables, ", known, " bytes that are not 0 hold; ",
                            nearest_text(nearest, "cells or less")));
}

}  // namespace robot_check
