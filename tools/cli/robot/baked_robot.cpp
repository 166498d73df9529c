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

/// Part of the time until pairs have to be decided: the rest is for what is baked of them.
constexpr double kPartForPairs = 0.8;

/// Proofs hold for firmware's own kinematics.
MatrixOptions matrix_options(const Model& model, const std::vector<Mesh>& meshes, double cell,
                             const AllDistances& distances, const Reaches& reaches) {
  MatrixOptions options;
  options.stop = distances.usual.stop / cell;
  options.warn = distances.usual.warn / cell;
  for (const GuardedPair& pair : distances.own) {
    options.stops.push_back({pair.a, pair.b, pair.stop / cell, pair.warn / cell});
  }
  const FixedRobot robot(model, meshes, cell, {}, reaches);
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
  ++made.model.part_count;
  return made.model.links.size() - 1;
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
  check_counts(made.model, arguments.urdf);
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

double steps_of(const Model& model) {
  const auto count = static_cast<double>(model.links.size());
  return kBakingWeight * (count + 1) + count * (count - 1) / 2;
}

/// All but what firmware holds.
BakedRobot decided(Model model, const AllDistances& distances, const RobotArguments& arguments,
                   Progress& progress, Warnings& warnings) {
  const Clock::time_point began = Clock::now();
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
  made.reaches = all_reaches(made.model, made.cell);
  made.options = matrix_options(made.model, meshes, made.cell, distances, made.reaches);
  if (arguments.time) {
    made.options.deadline = in_seconds(began, kPartForPairs * seconds(*arguments.time));
    made.deadline = in_seconds(began, seconds(*arguments.time));
  }
  progress.begin("joint zones", kBakingWeight);
  made.zones = joint_zones(made.model, meshes, made.cell, made.options, radii);
  made.pairs = decide_pairs(made.model, meshes, made.zones, made.reaches, made.cell, made.options,
                            [&](std::size_t pair, std::size_t pairs) {
                              progress.begin(concat("pair ", pair, " of ", pairs), 1);
                            });
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
  return decided(std::move(model), distances, arguments, progress, warnings);
}

BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings) {
  const AllDistances distances = all_distances(model, arguments);
  Progress progress(steps_of(model), arguments.progress);
  BakedRobot made = decided(std::move(model), distances, arguments, progress, warnings);
  check_disabled(made.model, made.pairs, arguments.srdf, warnings);
  add_parts(arguments, made);
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
