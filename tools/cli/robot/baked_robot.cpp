#include "cli/robot/baked_robot.hpp"
#include "cli/commands.hpp"

#include <algorithm>

#include "cli/progress.hpp"
#include "cli/robot/robot_arguments.hpp"
#include "flashbvh/clearance.hpp"
#include "robot/matrix/parallel.hpp"
#include "robot/read/urdf.hpp"

namespace flashbvh::tool {
namespace {

/// Of a link, in pairs decided.
constexpr double kBakingWeight = 0.1;

std::vector<BakedLink> bake_links(const Model& model, double cell, const RobotArguments& arguments,
                                  Progress& progress, Warnings& warnings) {
  std::vector<BakedLink> links;
  for (const ModelLink& link : model.links) {
    progress.begin("baking " + link.name, kBakingWeight);
    links.push_back(bake_link(link, cell, arguments.leaf_size, arguments.urdf));
    const InputMesh input = link_input(link, arguments.urdf);
    warn_of_precision(input, cell, warnings);
    warn_of_place(links.back().tree.origin, input.path, warnings);
  }
  return links;
}

/// Parts of the time until when stages have to be done; what one leaves is the next one's. Without
/// its zone a joint's links are guarded all over, so zones get most.
constexpr double kPartForReaches = 0.1;
constexpr double kPartForZones = 0.6;
constexpr double kPartForPairs = 0.8;
constexpr double kPartForParts = 0.9;
constexpr double kPartForTables = 1;

/// Gives stages their time.
class StageTimes {
 public:
  explicit StageTimes(const RobotArguments& arguments) {
    if (arguments.time) {
      seconds_ = seconds(*arguments.time);
    }
  }

  Deadline until(double part) const {
    return seconds_ ? in_seconds(began_, part * *seconds_) : Deadline{};
  }

 private:
  Clock::time_point began_ = Clock::now();
  std::optional<double> seconds_;
};

/// All that a joint moves and that may be guarded.
std::vector<GuardedPair> moved_pairs(const Model& model) {
  std::vector<GuardedPair> pairs;
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      const DisabledPair* const disabled = find_pair(model.disabled, a, b);
      if (model.links[a].joint != model.links[b].joint &&
          (disabled == nullptr || !disabled->is_believed)) {
        pairs.push_back({a, b, 0, 0});
      }
    }
  }
  return pairs;
}

/// Proofs hold for firmware's own kinematics. UserError if firmware cannot hold the robot so fine.
MatrixOptions matrix_options(const Model& model, const std::vector<Mesh>& meshes, double cell,
                             const AllDistances& distances, const Reaches& reaches) {
  MatrixOptions options;
  options.stop = distances.usual.stop / cell;
  options.warn = distances.usual.warn / cell;
  for (const GuardedPair& pair : distances.own) {
    options.stops.push_back({pair.a, pair.b, pair.stop / cell, pair.warn / cell});
  }
  const FixedRobot robot(model, meshes, cell, moved_pairs(model), reaches);
  options.slack = std::max(options.slack, kPlacing + robot.robot().slack / double{kFineOne});
  return options;
}

/// UserError if firmware cannot hold distances so large.
void check_range(const Distances& distances, double cell) {
  const double most = kMaxDistance * cell / kFineOne;
  if (distances.warn > most) {
    throw UserError(concat("--", distances.stop > most ? "stop " : "warn ",
                           shortest(distances.stop > most ? distances.stop : distances.warn)),
                    "is out of range: 0 to ", significant(most, 6),
                    " m, 32,767 cells; use a larger --cell to look further");
  }
}

/// What is always within its warn distance is not warned of: neighbours next to their zone, and
/// pairs for which the user has not requested it.
std::vector<GuardedPair> guarded(const std::vector<PairVerdict>& pairs,
                                 const AllDistances& distances) {
  std::vector<GuardedPair> guarded;
  for (const PairVerdict& pair : pairs) {
    if (pair.is_guarded) {
      const auto [stop, warn] = distances_of(distances, pair);
      const bool is_near = pair.is_warned && find_pair(distances.own, pair.a, pair.b) == nullptr;
      for (const auto& [a, b] : pair.bodies) {
        guarded.push_back({a, b, stop, pair.zone || is_near ? stop : warn});
      }
    }
  }
  std::sort(guarded.begin(), guarded.end(), [](const GuardedPair& p, const GuardedPair& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return guarded;
}

/// A part of a link, as a link.
std::size_t add_part(std::size_t of, bake::SourceMesh mesh, const std::string& where,
                     const RobotArguments& arguments, BakedRobot& made) {
  ModelLink part;
  part.name = made.model.links[of].name;
  part.joint = made.model.links[of].joint;
  part.mesh = std::move(mesh);
  part.sources = {concat("outside ", where)};
  part.source_begins = {0};
  part.precision = made.model.links[of].precision;
  made.links.push_back(bake_link(part, made.cell, arguments.leaf_size, arguments.urdf));
  made.model.links.push_back(std::move(part));
  made.wholes.push_back(of);
  ++made.model.part_count;
  return made.model.links.size() - 1;
}

/// UserError if the links and their parts are more than firmware holds.
void check_parts(const Model& model, const std::string& path) {
  if (model.links.size() > kMaxLinks) {
    throw UserError(path, "has ", model.links.size() - model.part_count,
                    " links with a <collision> and ", model.part_count,
                    " parts of them to guard next to joint zones, firmware holds ", kMaxLinks,
                    " of both; give more --time, or joints a larger --zone");
  }
}

/// What a guard looks at of neighbours.
void add_parts(const RobotArguments& arguments, BakedRobot& made) {
  std::vector<std::vector<ZoneParts>> parts(made.pairs.size());
  for_each_in_parallel(parts.size(), [&](std::size_t i) {
    const PairVerdict& pair = made.pairs[i];
    if (pair.zone && pair.is_guarded) {
      parts[i] = zone_parts(made.model, made.zones[*pair.zone], made.cell, made.options);
    }
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PairVerdict& pair = made.pairs[i];
    if (!pair.zone || !pair.is_guarded) {
      continue;
    }
    if (parts[i].empty()) {
      pair.is_guarded = false;
      pair.is_stopped = false;
      pair.verdict = MatrixVerdict::never;
      pair.reason += "; proven by triangles";
    }
    const std::string where = zone_text(made.model, made.zones[*pair.zone]);
    pair.bodies.clear();
    for (ZoneParts& part : parts[i]) {
      const std::size_t a = add_part(pair.a, std::move(part.a), where, arguments, made);
      pair.bodies.emplace_back(a, add_part(pair.b, std::move(part.b), where, arguments, made));
    }
  }
  made.sizes = link_sizes(made.model);
  check_parts(made.model, arguments.urdf);
}

/// Of the parts; no looser than those of the whole links.
void add_reaches(BakedRobot& made) {
  const std::size_t first = made.reaches.size();
  made.reaches.resize(made.model.links.size());
  for_each_in_parallel(made.reaches.size() - first, [&](std::size_t i) {
    std::vector<double>& reaches = made.reaches[first + i];
    reaches = reaches_of(made.model, first + i, made.cell, made.options.deadline);
    const std::vector<double>& whole = made.reaches[made.wholes[i]];
    std::transform(reaches.begin(), reaches.end(), whole.begin(), reaches.begin(),
                   [](double part, double all) { return std::min(part, all); });
  });
}

void warn_of_fixed(const BakedRobot& robot, const AllDistances& distances, const std::string& path,
                   Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.verdict == MatrixVerdict::fixed &&
        find_pair(distances.own, pair.a, pair.b) != nullptr) {
      warnings.add(path, concat("links '", robot.model.links[pair.a].name, "' and '",
                                robot.model.links[pair.b].name,
                                "' have a --pair, but no joint moves them; leave it out"));
    }
  }
}

void warn_of_unguarded(const BakedRobot& robot, const std::string& path, Warnings& warnings) {
  for (const std::string& warning : unguarded_warnings(robot.model, robot.unguarded)) {
    warnings.add(path, warning);
  }
}

/// Pairs of which a guard would say the same wherever the robot stands.
void warn_of_near(const BakedRobot& robot, const AllDistances& distances,
                  const RobotArguments& arguments, Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (!pair.is_stopped && !pair.is_warned) {
      continue;
    }
    const GuardedPair* const own = find_pair(distances.own, pair.a, pair.b);
    const auto [stop, warn] = distances_of(distances, pair);
    const std::string names =
        concat(robot.model.links[pair.a].name, ",", robot.model.links[pair.b].name);
    const std::string links =
        concat("links '", robot.model.links[pair.a].name, "' and '", robot.model.links[pair.b].name,
               "'", pair.zone ? " outside their joint's zone" : "",
               " are nowhere found farther apart than the ", pair.is_stopped ? "stop" : "warn",
               " distance, ", shortest(pair.is_stopped ? stop : warn), " m, so ");
    if (!pair.is_stopped && own == nullptr) {
      warnings.add(arguments.urdf,
                   concat(links, "they are not warned of; --pair ", names, "=STOP,WARN warns"));
      continue;
    }
    const char* const word = pair.is_stopped ? "stop" : "warn";
    warnings.add(
        arguments.urdf,
        concat(links, "a guard would ", pair.is_stopped ? "always say stop; " : "never say free; ",
               pair.zone ? "give the joint a larger --zone, or " : "",
               (pair.is_stopped ? stop : warn) != 0 ? concat("lower it (--", word, ", --pair), or ")
               : own != nullptr                     ? "leave out its --pair, or "
                                                    : "",
               "disable the pair in an SRDF",
               pair.verdict == MatrixVerdict::never ? ""
                                                    : concat(" and name it by --believe ", names)));
  }
}

std::vector<std::size_t> late_joints(const BakedRobot& robot, const ZoneRadii& radii) {
  std::vector<std::size_t> joints;
  if (!robot.options.is_late()) {
    return joints;
  }
  for (std::size_t joint = 0; joint < robot.model.joints.size(); ++joint) {
    const auto given = radii.find(joint);
    const bool is_wanted =
        is_between_neighbours(robot.model, joint) && (given == radii.end() || given->second != 0);
    const bool is_found = std::any_of(robot.zones.begin(), robot.zones.end(),
                                      [&](const JointZone& zone) { return zone.joint == joint; });
    if (is_wanted && !is_found) {
      joints.push_back(joint);
    }
  }
  return joints;
}

/// `then`: what becomes of the links.
void warn_of_late_zones(const BakedRobot& robot, const std::string& path, const std::string& then,
                        Warnings& warnings) {
  std::string joints;
  for (const std::size_t joint : robot.late_joints) {
    joints += concat(joints.empty() ? "" : ", ", robot.model.joints[joint].name);
  }
  if (!joints.empty()) {
    warnings.add(path, concat("no time was left to find a zone about ", joints,
                              ": links that touch there are ", then, "; give more --time"));
  }
}

double steps_of(const Model& model) {
  const auto count = static_cast<double>(model.links.size());
  return kBakingWeight * (count + 1) + count * (count - 1) / 2;
}

/// All but what firmware holds.
BakedRobot decided(Model model, const AllDistances& distances, const RobotArguments& arguments,
                   Progress& progress, Warnings& warnings) {
  const StageTimes times(arguments);
  const ZoneRadii radii = zone_radii(model, arguments.zones);
  BakedRobot made;
  made.model = std::move(model);
  made.cell = robot_cell(made.model, given_cell(arguments), arguments.urdf);
  check_range(distances.usual, made.cell);
  for (const GuardedPair& pair : distances.own) {
    check_range({pair.stop, pair.warn}, made.cell);
  }
  made.sizes = link_sizes(made.model);
  warn_of_sizes(made.model, made.sizes, arguments.urdf, warnings);
  warn_of_cell(made.model, made.sizes, made.cell, least_stop(distances),
               arguments.cell ? concat("--cell ", *arguments.cell) : arguments.urdf, warnings);
  made.links = bake_links(made.model, made.cell, arguments, progress, warnings);
  const std::vector<Mesh> meshes = meshes_of(made.links);
  made.reaches = all_reaches(made.model, made.cell, times.until(kPartForReaches));
  made.options = matrix_options(made.model, meshes, made.cell, distances, made.reaches);
  progress.begin("joint zones", kBakingWeight);
  made.options.deadline = times.until(kPartForZones);
  made.zones = joint_zones(made.model, meshes, made.cell, made.options, radii);
  made.late_joints = late_joints(made, radii);
  made.options.deadline = times.until(kPartForPairs);
  made.pairs = decide_pairs(made.model, meshes, made.zones, made.reaches, made.cell, made.options,
                            [&](std::size_t pair, std::size_t pairs) {
                              progress.begin(concat("pair ", pair, " of ", pairs), 1);
                            });
  made.options.deadline = times.until(kPartForParts);
  made.deadline = times.until(kPartForTables);
  return made;
}

}  // namespace

std::set<std::string> files_read(const RobotArguments& arguments, const Model& model) {
  std::set<std::string> read = {arguments.urdf};
  for (const std::string& file : {arguments.srdf, arguments.joint_limits}) {
    if (!file.empty()) {
      read.insert(file);
    }
  }
  read.insert(model.files.begin(), model.files.end());
  for (const ModelLink& link : model.links) {
    read.insert(link.files.begin(), link.files.end());
  }
  return read;
}

Model described_robot(const RobotArguments& arguments, Warnings& warnings) {
  (void)usual_distances(arguments);
  Model model = read_urdf(arguments.urdf, packages_of(arguments.packages), arguments.srdf, warnings,
                          arguments.joint_limits, arguments.visual_too);
  check_counts(model, arguments.urdf);
  for (const std::string& names : arguments.believed) {
    const std::string place = "--believe " + names;
    const auto [a, b] = links_of(model, place, names);
    believe(a, b, place, model);
  }
  return model;
}

std::vector<Mesh> meshes_of(const std::vector<BakedLink>& links) {
  std::vector<Mesh> meshes;
  meshes.reserve(links.size());
  for (const BakedLink& link : links) {
    meshes.push_back(link.mesh());
  }
  return meshes;
}

BakedRobot decided_robot(Model model, const RobotArguments& arguments, Warnings& warnings) {
  const AllDistances distances = all_distances(model, arguments);
  Progress progress(steps_of(model), arguments.progress);
  BakedRobot made = decided(std::move(model), distances, arguments, progress, warnings);
  warn_of_late_zones(made, arguments.urdf, "undecided", warnings);
  return made;
}

BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings) {
  const AllDistances distances = all_distances(model, arguments);
  Progress progress(steps_of(model), arguments.progress);
  BakedRobot made = decided(std::move(model), distances, arguments, progress, warnings);
  warn_of_late_zones(made, arguments.urdf, "guarded all over, and a guard would always say stop",
                     warnings);
  check_disabled(made.model, made.pairs, arguments.srdf, warnings);
  add_parts(arguments, made);
  add_reaches(made);
  made.unguarded = unguarded_pairs(made.pairs, made.zones);
  warn_of_unguarded(made, arguments.urdf, warnings);
  warn_of_fixed(made, distances, arguments.urdf, warnings);
  warn_of_near(made, distances, arguments, warnings);
  made.fixed = std::make_unique<FixedRobot>(made.model, meshes_of(made.links), made.cell,
                                            guarded(made.pairs, distances), made.reaches);
  progress.begin("distance tables", 0);
  made.fixed->set_distance_tables(distance_tables_of(made.model, made.robot(), made.deadline));
  return made;
}

BakedRobot opened_robot(const std::string& path, const CLI::App& command, Warnings& warnings) {
  for (const char* const option :
       {"--package", "--joint-limits", "--visual-too", "--srdf", "--believe", "--cell",
        "--leaf-size", "--stop", "--warn", "--pair", "--zone", "--time"}) {
    if (command.count(option) != 0) {
      throw UserError(path, "is baked already, ", option,
                      " is for a URDF; leave it out, or bake again with `flashbvh robot`");
    }
  }
  BakedRobot made;
  made.file = std::make_unique<RobotFile>(path);
  made.model = made.file->model();
  made.cell = made.file->cell();
  made.sizes = link_sizes(made.model, made.robot().meshes, made.cell);
  made.unguarded = made.file->unguarded();
  warn_of_unguarded(made, path, warnings);
  return made;
}

}  // namespace flashbvh::tool
