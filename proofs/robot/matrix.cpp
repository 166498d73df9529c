// Two links that a joint moves against each other and that are in neither array never collide.
#include <mutex>
#include <set>

#include "checks.hpp"

namespace robot_check {
namespace {

/// The share of a pair's boxes that is tried before the search for contact: 1 in 40.
constexpr std::size_t kFirst = 40;
constexpr int kStarts = 16;

std::set<std::pair<std::uint32_t, std::uint32_t>> named_pairs(const Robot& robot) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> named;
  for (const Pair& pair : robot.pairs) {
    named.emplace(pair.a, pair.b);
  }
  for (const Unguarded& pair : robot.unguarded) {
    named.emplace(pair.a, pair.b);
  }
  return named;
}

/// A part of a link outside a joint zone lies on the link, so it meets only what the link meets.
void check_parts(const Robot& robot, const Bodies& bodies, Report& report) {
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    const std::uint32_t whole = robot.whole_of(i);
    const double allowed = (robot.links[i].deviation + robot.links[whole].deviation) / 256.0 + 0.01;
    for (const Vec& vertex : robot.links[i].mesh.vertices) {
      const double off = whole == i ? 0 : bodies[whole].distance(vertex);
      if (off > allowed) {
        report.refuse(text("mesh of link ", robot.link_name(i), ": a vertex lies ", off,
                           " cells off the link that it is a part of, at most ", allowed,
                           " are in their deviations"));
        break;
      }
    }
  }
}

/// Decides with few boxes first, then searches for contact, then uses all boxes.
Answer decide(PairSpace& space, double need, std::size_t most_boxes) {
  Answer answer = space.prove(space.limits(), need, 0, most_boxes / kFirst);
  if (answer.found != Found::undecided) {
    return answer;
  }
  std::vector<double> at = space.find_contact(kStarts);
  return at.empty() ? space.prove(space.limits(), need, 0, most_boxes)
                    : Answer{Found::near, std::move(at), 0, answer.boxes};
}

}  // namespace

void check_matrix(const Robot& robot, const Bodies& bodies, std::size_t most_boxes, Moment end,
                  Report& report) {
  check_parts(robot, bodies, report);
  const auto named = named_pairs(robot);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rows;
  for (std::uint32_t a = 0; a < robot.links.size(); ++a) {
    for (std::uint32_t b = a + 1; b < robot.links.size(); ++b) {
      if (robot.links[a].joint != robot.links[b].joint && robot.whole_of(a) == a &&
          robot.whole_of(b) == b && named.count({a, b}) == 0) {
        rows.emplace_back(a, b);
      }
    }
  }
  std::mutex mutex;
  double nearest = HUGE_VAL;
  std::size_t boxes = 0;
  for_each_row(rows.size(), [&](std::size_t i) {
    const auto [a, b] = rows[i];
    const double need = (robot.links[a].deviation + robot.links[b].deviation) / 256.0;
    const std::string row = text("pair ", robot.pair_name(a, b), ", in no array");
    PairSpace space(robot, a, bodies[a], b, bodies[b]);
    const Moment now = std::chrono::steady_clock::now();
    space.end_at(now + (end - now) / (rows.size() - i));  // shares the time that earlier rows leave
    const Answer answer = decide(space, need, most_boxes);
    const std::lock_guard<std::mutex> lock(mutex);
    boxes += answer.boxes;
    nearest = std::min(nearest, answer.nearest - need);
    if (answer.found == Found::near) {
      report.refuse(
          text(row, ": they collide at ", space.text(answer.at), ": no guard looks at them"));
    } else if (answer.found == Found::undecided) {
      report.doubt(text(row, ": after ", answer.boxes, " boxes not proven apart about ",
                        space.text(answer.at)));
    }
  });
  report.end("matrix", text(rows.size(), " pairs in no array never collide, in ", boxes, " boxes; ",
                            nearest_text(nearest, "cells or less")));
}

}  // namespace robot_check
