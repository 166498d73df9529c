#include "cli/robot/baked_robot.hpp"
#include "cli/commands.hpp"

#include <algorithm>
#include <limits>

#include "cli/progress.hpp"
#include "flashbvh/clearance.hpp"
#include "robot/matrix/parallel.hpp"
#include "robot/read/urdf.hpp"

namespace flashbvh::tool {
namespace {

/// Of a link, in pairs decided.
constexpr double kBakingWeight = 0.1;

double metres(const std::string& option, const std::string& text) {
  const std::optional<double> length = parse_number(text);
  if (!length || *length < 0 || !is_coordinate(*length)) {
    throw UserError(option + " " + text, "is no length; give a number from 0, in metres");
  }
  return *length;
}

double seconds(const std::string& text) {
  const std::optional<double> time = parse_number(text);
  if (!time || !(*time > 0 && *time < 1e6)) {
    throw UserError("--time " + text, "is no time; give a number of seconds above 0");
  }
  return *time;
}

std::optional<double> given_cell(const RobotArguments& arguments) {
  if (!arguments.cell) {
    return std::nullopt;
  }
  const double cell = metres("--cell", *arguments.cell);
  if (cell < static_cast<double>(std::numeric_limits<float>::min())) {
    throw UserError("--cell " + *arguments.cell, "is no length; give a positive number, in metres");
  }
  return cell;
}

Packages packages_of(const std::vector<std::string>& given) {
  Packages packages;
  for (const std::string& option : given) {
    const std::size_t equals = option.find('=');
    const std::string name = option.substr(0, equals);
    if (equals == std::string::npos || name.empty() || equals + 1 == option.size()) {
      throw UserError("--package " + option,
                      "is no NAME=DIR; give a package's name and its folder");
    }
    if (!packages.emplace(name, option.substr(equals + 1)).second) {
      throw UserError("--package " + option, "is a second folder of ", name, "; give it one");
    }
  }
  return packages;
}

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

struct Distances {
  double stop;
  double warn;
};

/// All that are guarded alike, and pairs with their own.
struct AllDistances {
  Distances usual;
  std::vector<GuardedPair> own;
};

/// `place`: the options that say so.
Distances distances_of(const std::string& stop_place, const std::string& stop,
                       const std::string& warn_place, const std::string& warn) {
  const Distances distances = {metres(stop_place, stop), metres(warn_place, warn)};
  if (distances.warn < distances.stop) {
    throw UserError(warn_place + " " + warn, "is nearer than ", stop_place, " ", stop,
                    "; warn from further off");
  }
  return distances;
}

Distances usual_distances(const RobotArguments& arguments) {
  return distances_of("--stop", arguments.stop, "--warn", arguments.warn.value_or(arguments.stop));
}

std::size_t link_of(const Model& model, const std::string& place, const std::string& name) {
  const auto link = std::find_if(model.links.begin(), model.links.end(),
                                 [&](const ModelLink& of) { return of.name == name; });
  if (link == model.links.end()) {
    throw UserError(place, "names '", name, "', which is no link that collides; these are ",
                    joined(
                        model.links, [](const ModelLink& of) { return of.name; }, ","));
  }
  return static_cast<std::size_t>(link - model.links.begin());
}

/// LINK,LINK
std::pair<std::size_t, std::size_t> links_of(const Model& model, const std::string& place,
                                             const std::string& names) {
  const std::size_t comma = names.find(',');
  if (comma == std::string::npos) {
    throw UserError(place, "does not name LINK,LINK; give two links");
  }
  const std::pair<std::size_t, std::size_t> links = {
      link_of(model, place, names.substr(0, comma)),
      link_of(model, place, names.substr(comma + 1))};
  if (links.first == links.second) {
    throw UserError(place, "names one link twice; give two");
  }
  return links;
}

/// LINK,LINK=STOP[,WARN]
GuardedPair own_distances(const Model& model, const std::string& given) {
  const std::string place = "--pair " + given;
  const std::size_t comma = given.find(',');
  const std::size_t equals = given.find('=');
  if (comma == std::string::npos || equals == std::string::npos || comma > equals) {
    throw UserError(place, "is no LINK,LINK=STOP[,WARN]; give two links and their distances");
  }
  const std::string lengths = given.substr(equals + 1);
  const std::size_t split = lengths.find(',');
  const std::string stop = lengths.substr(0, split);
  const Distances distances =
      distances_of(place + ":", stop, place + ":",
                   split == std::string::npos ? stop : lengths.substr(split + 1));
  const auto [a, b] = links_of(model, place, given.substr(0, equals));
  return {a, b, distances.stop, distances.warn};
}

AllDistances all_distances(const Model& model, const RobotArguments& arguments) {
  AllDistances all = {usual_distances(arguments), {}};
  for (const std::string& given : arguments.pairs) {
    const GuardedPair pair = own_distances(model, given);
    if (find_pair(all.own, pair.a, pair.b) != nullptr) {
      throw UserError("--pair " + given, "says it of these links a second time; say it once");
    }
    const DisabledPair* const disabled = find_pair(model.disabled, pair.a, pair.b);
    if (disabled != nullptr && disabled->is_believed) {
      throw UserError("--pair " + given, "guards what --believe leaves out; give one of the two");
    }
    all.own.push_back(pair);
  }
  return all;
}

/// The least one above 0; 0 if there is none.
double least_stop(const AllDistances& distances) {
  double least = distances.usual.stop;
  for (const GuardedPair& pair : distances.own) {
    least = least == 0 || (pair.stop > 0 && pair.stop < least) ? pair.stop : least;
  }
  return least;
}

/// JOINT=LENGTH, each of a joint between two links that collide.
ZoneRadii zone_radii(const Model& model, const std::vector<std::string>& given) {
  ZoneRadii radii;
  for (const std::string& option : given) {
    const std::string place = "--zone " + option;
    const std::size_t equals = option.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UserError(place, "is no JOINT=LENGTH; give a joint and the zone's radius, in metres");
    }
    const std::string name = option.substr(0, equals);
    const auto joint = std::find_if(model.joints.begin(), model.joints.end(),
                                    [&](const ModelJoint& of) { return of.name == name; });
    const auto number = static_cast<std::size_t>(joint - model.joints.begin());
    if (joint == model.joints.end() || !is_between_neighbours(model, number)) {
      throw UserError(place, "names '", name,
                      "', which is no moving joint between two links that collide");
    }
    if (!radii.emplace(number, metres(place + ":", option.substr(equals + 1))).second) {
      throw UserError(place, "is a second zone of ", name, "; give it one");
    }
  }
  return radii;
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

/// Of two links, `own` heeded.
Distances distances_of(const AllDistances& distances, const PairVerdict& pair) {
  const GuardedPair* const own = find_pair(distances.own, pair.a, pair.b);
  return own != nullptr ? Distances{own->stop, own->warn} : distances.usual;
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

void add_described_options(CLI::App& command, const std::string& name, RobotArguments& arguments) {
  command.add_option(name, arguments.urdf, "The robot (URDF, MJCF or SDF)")->required();
  repeated(
      add_option(command, "--package", arguments.packages, "NAME=DIR",
                 "Folder of the package NAME, for meshes at package://NAME/...; may be repeated. "
                 "\nDefault: the first folder of that name next to the robot's file or above it"));
  add_option(command, "--joint-limits", arguments.joint_limits, "FILE",
             "MoveIt's joint_limits.yaml, whose position limits narrow the robot's");
  command.add_flag("--visual-too", arguments.visual_too,
                   "Links with visual shapes alone collide by them; without it, with nothing");
}

void add_robot_options(CLI::App& command, const std::string& name, RobotArguments& arguments) {
  add_described_options(command, name, arguments);
  add_option(command, "--srdf", arguments.srdf, "FILE",
             "Pairs of links that need no guard; those that can collide are an error");
  repeated(
      add_option(command, "--believe", arguments.believed, "LINK,LINK",
                 "Two links that --srdf disables and that can collide: don't guard them; may be "
                 "repeated"));
  add_option(command, "--cell", arguments.cell, "LENGTH",
             "Size of a lattice cell; default: the finest that all the links fit");
  command.add_option("--leaf-size", arguments.leaf_size, "Most triangles in a leaf")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  add_option(command, "--stop", arguments.stop, "LENGTH", "Links nearer than this must stop")
      ->capture_default_str();
  add_option(command, "--warn", arguments.warn, "LENGTH",
             "Links nearer than this are warned of; default: --stop");
  repeated(
      add_option(command, "--pair", arguments.pairs, "LINK,LINK=STOP[,WARN]",
                 "Distances of two links for which --stop and --warn don't hold; may be repeated"));
  repeated(add_option(command, "--zone", arguments.zones, "JOINT=LENGTH",
                      "Two links may touch so far about the joint between them; 0: nowhere; may be "
                      "repeated. \nDefault: as far as they do"));
  add_option(
      command, "--time", arguments.time, "SECONDS",
      "What is not decided by then is undecided, and guarded. \nDefault: as long as it takes");
  add_progress(command, arguments.progress);
}

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
