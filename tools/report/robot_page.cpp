#include "report/robot_page.hpp"

#include <algorithm>
#include <cmath>

#include "flashbvh/robot/motion.hpp"
#include "live/live_section.hpp"
#include "report/html.hpp"
#include "report/links.hpp"
#include "robot/baked/robot_writer.hpp"
#include "robot/matrix/rarity.hpp"
#include "robot/model.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A verdict's style, name and meaning.
constexpr const char* kMeanings[][3] = {
    {"never", "never", "proven to collide nowhere"},
    {"never", "never outside zone", "they touch about their joint, proven to collide nowhere else"},
    {"can", "can", "collide at this share of random configurations"},
    {"undecided", "undecided", "neither proven nor found to collide"},
    {"fixed", "fixed", "no joint moves them"},
    {"believed", "believed", "disabled in the SRDF, not guarded"}};

/// A short text for a cell: a share, or the reason.
std::string short_reason(const PairVerdict& pair, const std::string& share) {
  return pair.verdict == MatrixVerdict::can        ? share
         : pair.verdict == MatrixVerdict::believed ? "not guarded"
         : pair.verdict == MatrixVerdict::fixed
             ? escaped(pair.reason.substr(pair.reason.rfind(' ') + 1))  // apart, intersecting
             : counted(pair.joint_boxes, "joint box", "joint boxes") +
                   (pair.is_guarded ? ", guarded" : "");
}

std::string cell(const PairVerdict& pair, const std::string& share) {
  return concat("<td class=is-", name_of(pair.verdict), shown_values(pair.witness), ">",
                name_of(pair), "<small>", short_reason(pair, share), "</small></td>");
}

std::string matrix_of(const DecidedRobot& decided, const std::vector<std::string>& shares) {
  Cells names;
  for (std::size_t i = 0; i < decided.model.link_count(); ++i) {
    names.push_back(escaped(decided.model.links[i].name));
  }
  std::vector<Cells> cells(names.size(), Cells(names.size(), "<td>&ndash;</td>"));
  for (std::size_t i = 0; i < decided.pairs.size(); ++i) {
    const PairVerdict& pair = decided.pairs[i];
    cells[pair.a][pair.b] = cells[pair.b][pair.a] = cell(pair, shares[i]);
  }
  return matrix("pairs", "", names, [&](std::size_t a, std::size_t b) { return cells[a][b]; });
}

std::string keys() {
  std::string html = "<p class=keys>";
  for (const auto& [style, name, meaning] : kMeanings) {
    html += key(concat("is-", style), concat("<b>", name, "</b>: ", meaning));
  }
  return html + "</p>\n";
}

std::string words(const DecidedRobot& decided) {
  std::vector<Cells> rows;
  for (const PairVerdict& pair : decided.pairs) {
    rows.push_back({links_of(decided.model, pair.a, pair.b), name_of(pair),
                    pair.is_guarded ? "guarded" : "&ndash;", grouped(pair.joint_boxes),
                    escaped(pair.reason)});
  }
  return "<div class=words>\n" +
         table(
             "Each pair, how many joint boxes were looked at in all, and what it was "
             "decided by",
             {"links", "collide", "guard", "#joint boxes in all", "reason"}, rows) +
         "</div>\n";
}

constexpr std::uint32_t kConfigurations = 20000;  ///< random
/// The usual number of samples for a collision matrix.
constexpr std::uint32_t kUsualSamples = 10000;

/// The bytes of a MotionStateOf of the robot.
std::size_t motion_ram_bytes(const Robot& robot) {
  return sizeof(MotionCore) +
         std::max<std::size_t>(robot.variable_count, 1) * 3 * sizeof(JointCoordinate) +
         std::max<std::size_t>(robot.joint_count, 1) *
             (sizeof(JointCoordinate) + sizeof(flashbvh::Frame));
}

std::string facts_section(const DecidedRobot& decided) {
  const Robot& robot = decided.robot();
  const double cell = cell_of(robot);
  const std::size_t flash = decided.image.size() * sizeof decided.image[0];
  const std::size_t meshes = image_bytes(decided.links);
  return section(
      "", "What firmware holds",
      facts(fact("flash", grouped(flash) + " bytes",
                 grouped(meshes) + " of meshes, " + grouped(flash - meshes) +
                     " of joints, links and pairs") +
            fact("RAM of a guard",
                 grouped(robot_ram_bytes(robot, decided.fixed.pair_joint_count())) + " bytes",
                 "its state, all that it needs") +
            fact("RAM of a motion query", grouped(motion_ram_bytes(robot)) + " bytes",
                 "where motions are certified") +
            fact("pairs that are guarded",
                 concat(static_cast<int>(robot.pair_count), " of ", decided.pairs.size()),
                 concat(counted(robot.link_count, "link", "links"), ", ",
                        counted(robot.joint_count, "joint", "joints"), ", ",
                        counted(robot.variable_count, "value", "values"), " a period")) +
            fact("stop, warn", escaped(decided.stop) + " m, " + escaped(decided.warn) + " m",
                 "links nearer than this stop, are warned of") +
            fact("cell", significant(cell, 4) + " m", "of all meshes") +
            fact("slack", significant(robot.slack * cell / kFineOne, 4) + " m",
                 "what rounding and arithmetic can be wrong by")));
}

std::string guarded_decision(const DecidedRobot& decided) {
  const std::size_t guarded = decided.robot().pair_count;
  const auto can =
      std::count_if(decided.pairs.begin(), decided.pairs.end(),
                    [](const PairVerdict& pair) { return pair.verdict == MatrixVerdict::can; });
  return decision_section(
      "", unguarded_decisions(decided.model, decided.unguarded) +
              decision("v0",
                       concat("Guarded: ", guarded, " of ",
                              counted(decided.pairs.size(), "pair", "pairs"), " of links"),
                       concat(can, " can collide; ", grouped(decided.pairs.size() - guarded),
                              " never collide outside zones, are fixed, or believed")));
}

std::vector<LiveZone> live_zones(const DecidedRobot& decided) {
  std::vector<LiveZone> zones;
  for (const JointZone& zone : decided.zones) {
    std::array<double, 3> middle = zone.shape.middle;
    for (double& along : middle) {
      along /= cell_of(decided.robot());
    }
    zones.push_back({zone.joint, middle, zone.shape.radius});
  }
  return zones;
}

std::string part_text(double part) {
  return part < 1e-4 ? "&lt; 0.01 %" : significant(100 * part, 2) + " %";
}

/// "0.42 %", or "&lt; 0.015 %" for an upper bound.
std::string share_text(const Share& share) {
  return (share.is_bound ? "&lt; " : "") + significant(100 * share.part, 2) + " %";
}

std::string missed_text(const Share& share) {
  return (share.is_bound ? "&gt; " : "") + part_text(missed_by(kUsualSamples, share));
}

/// The pairs that can collide, rarest first.
std::vector<std::size_t> rarest(const DecidedRobot& decided,
                                const std::vector<Collisions>& collisions) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < decided.pairs.size(); ++i) {
    if (decided.pairs[i].verdict == MatrixVerdict::can) {
      order.push_back(i);
    }
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return share_of(collisions[i]).part < share_of(collisions[j]).part;
  });
  return order;
}

std::string rarity_table(const DecidedRobot& decided, const std::vector<std::size_t>& order,
                         const std::vector<Collisions>& collisions) {
  std::vector<Cells> rows;
  for (const std::size_t i : order) {
    const Share share = share_of(collisions[i]);
    rows.push_back({links_of(decided.model, decided.pairs[i].a, decided.pairs[i].b),
                    grouped(collisions[i].count), grouped(collisions[i].of), share_text(share),
                    missed_text(share)});
  }
  return table("Of configurations drawn at random, so many collide",
               {"links", "#collide", "#of", "#share", "#missed"}, rows) +
         note("Missed: how likely " + grouped(kUsualSamples) +
              " random configurations, usual for such a matrix, find none that collides. Where "
              "none of "
              "those here does, the share is below that bound with a confidence of 95 %.");
}

std::string witness_section(const DecidedRobot& decided, const std::vector<std::size_t>& order,
                            const std::vector<Collisions>& collisions) {
  return order.empty()
             ? ""
             : section("witnesses", "Collisions, the rarest first",
                       rarity_table(decided, order, collisions) +
                           (has_live_section() ? note("A cell of the matrix that can collide shows "
                                                      "where, in the robot above.")
                                               : ""));
}

std::string parts_section(const DecidedRobot& decided) {
  const Model& model = decided.model;
  std::vector<Cells> links;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const ModelLink& link = model.links[i];
    links.push_back({escaped(link.name), escaped(joint_name(model, link.joint, "base")),
                     grouped(decided.links[i].tree.triangles.size()),
                     grouped(decided.links[i].image_bytes()), joined(link.sources, escaped)});
  }
  std::vector<Cells> joints;
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const ModelJoint& joint = model.joints[i];
    joints.push_back({escaped(joint.name), escaped(joint_name(model, joint.parent, "base")),
                      type_name(joint.type), escaped(moves_of(model, i))});
  }
  return section(
      "", "Links and joints",
      table("Links", {"link", "joint", "#triangles", "#bytes of flash", "sources"}, links) +
          (joints.empty() ? "" : table("Joints", {"joint", "parent", "type", "moves"}, joints)));
}

/// The section of all pairs, as a matrix and in words. `shares`: texts of the share of
/// configurations at which each pair collides, in the pairs' order.
std::string matrix_section(const DecidedRobot& decided, const std::vector<std::string>& shares) {
  if (decided.pairs.empty()) {
    return "";
  }
  return section("matrix", "What can collide",
                 keys() + matrix_of(decided, shares) + words(decided));
}

}  // namespace

std::string robot_page(const DecidedRobot& decided, const OnStep& step) {
  step("drawing configurations at random", 1);
  const std::vector<Collisions> collisions =
      collisions_of(decided.model, decided.wholes.data(), cell_of(decided.robot()), decided.pairs,
                    kConfigurations);
  std::vector<std::string> shares;
  shares.reserve(collisions.size());
  for (const Collisions& found : collisions) {
    shares.push_back(share_text(share_of(found)));
  }
  return page(
      escaped(decided.model.name), "robot", "what of a robot can collide",
      guarded_decision(decided) + live_section(decided.image, live_zones(decided)) +
          facts_section(decided) + matrix_section(decided, shares) +
          witness_section(decided, rarest(decided, collisions), collisions) +
          (decided.simplified.meshes.empty() ? "" : simplified_section(decided.simplified)) +
          parts_section(decided) + footer());
}

}  // namespace flashbvh::tool
