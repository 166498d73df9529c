#include "cli/robot/baked_robot.hpp"
#include "cli/commands.hpp"

#include <algorithm>
#include <limits>

#include "cli/progress.hpp"
#include "flashbvh/clearance.hpp"
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

/// Proofs hold for firmware's own kinematics.
std::vector<PairVerdict> decide(const Model& model, const std::vector<Mesh>& meshes, double cell,
                                const AllDistances& distances, Progress& progress) {
  MatrixOptions options;
  options.stop = distances.usual.stop / cell;
  options.warn = distances.usual.warn / cell;
  for (const GuardedPair& pair : distances.own) {
    options.stops.push_back({pair.a, pair.b, pair.stop / cell, pair.warn / cell});
  }
  const FixedRobot robot(model, meshes, cell, {});
  options.slack = std::max(options.slack, kPlacing + robot.robot().slack / double{kFineOne});
  std::size_t begun = 0;
  return decide_pairs(model, meshes, cell, options,
                      [&](std::size_t pair, std::size_t pairs, double) {
                        if (pair == begun) {
                          progress.begin(concat("pair ", ++begun, " of ", pairs), 1);
                        }
                      });
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

std::vector<GuardedPair> guarded(const std::vector<PairVerdict>& pairs,
                                 const AllDistances& distances) {
  std::vector<GuardedPair> guarded;
  for (const PairVerdict& pair : pairs) {
    if (pair.is_guarded) {
      const GuardedPair* const own = find_pair(distances.own, pair.a, pair.b);
      const Distances of = own != nullptr ? Distances{own->stop, own->warn} : distances.usual;
      guarded.push_back({pair.a, pair.b, of.stop, of.warn});
    }
  }
  return guarded;
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
    const Distances of = own != nullptr ? Distances{own->stop, own->warn} : distances.usual;
    const double distance = pair.is_stopped ? of.stop : of.warn;
    const char* const word = pair.is_stopped ? "stop" : "warn";
    warnings.add(
        arguments.urdf,
        concat("links '", robot.model.links[pair.a].name, "' and '", robot.model.links[pair.b].name,
               "' are nowhere found farther apart than the ", word, " distance, ",
               shortest(distance), " m, so a guard would ",
               pair.is_stopped ? "always say stop; " : "never say free; ",
               distance != 0    ? concat("lower it (--", word, ", --pair), or ")
               : own != nullptr ? "leave out its --pair, or "
                                : "",
               "disable the pair in an SRDF",
               pair.verdict == MatrixVerdict::never
                   ? ""
                   : concat(" and name it by --believe ", robot.model.links[pair.a].name, ",",
                            robot.model.links[pair.b].name)));
  }
}

double steps_of(const Model& model) {
  const auto count = static_cast<double>(model.links.size());
  return kBakingWeight * count + count * (count - 1) / 2;
}

/// All but what firmware holds.
BakedRobot decided(Model model, const AllDistances& distances, const RobotArguments& arguments,
                   Progress& progress, Warnings& warnings) {
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
  made.pairs = decide(made.model, meshes_of(made.links), made.cell, distances, progress);
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
  made.unguarded = unguarded_pairs(made.pairs);
  warn_of_unguarded(made, arguments.urdf, warnings);
  warn_of_fixed(made, distances, arguments.urdf, warnings);
  warn_of_near(made, distances, arguments, warnings);
  made.fixed = std::make_unique<FixedRobot>(made.model, meshes_of(made.links), made.cell,
                                            guarded(made.pairs, distances));
  made.fixed->set_distance_tables(distance_tables_of(
      made.model, made.robot(),
      [&](std::size_t pair) { progress.begin(concat("distance table of pair ", pair + 1), 0); }));
  return made;
}

BakedRobot opened_robot(const std::string& path, const CLI::App& command, Warnings& warnings) {
  for (const char* const option :
       {"--package", "--joint-limits", "--visual-too", "--srdf", "--believe", "--cell",
        "--leaf-size", "--stop", "--warn", "--pair"}) {
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
