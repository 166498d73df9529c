#include "cli/baked_robot.hpp"

#include <algorithm>
#include <limits>

#include "cli/mesh_warnings.hpp"
#include "cli/progress.hpp"
#include "flashbvh/clearance.hpp"
#include "robot/urdf.hpp"

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

std::optional<double> cell_of(const RobotArguments& arguments) {
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

std::vector<PostMesh> meshes_of(const std::vector<BakedLink>& links) {
  std::vector<PostMesh> meshes;
  meshes.reserve(links.size());
  for (const BakedLink& link : links) {
    meshes.push_back(link.mesh());
  }
  return meshes;
}

/// Proofs hold for firmware's own kinematics.
std::vector<PairVerdict> decide(const Model& model, const std::vector<PostMesh>& meshes,
                                double cell, double stop, Progress& progress) {
  MatrixOptions options;
  options.stop = stop / cell;
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

struct Distances {
  double stop;
  double warn;
};

Distances distances_of(const RobotArguments& arguments) {
  const double stop = metres("--stop", arguments.stop);
  const double warn = arguments.warn ? metres("--warn", *arguments.warn) : stop;
  if (warn < stop) {
    throw UserError("--warn " + *arguments.warn, "is nearer than --stop ", arguments.stop,
                    "; warn from further off");
  }
  return {stop, warn};
}

/// UserError if firmware can't tell distances so large.
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
                                 const Distances& distances) {
  std::vector<GuardedPair> guarded;
  for (const PairVerdict& pair : pairs) {
    if (pair.is_guarded) {
      guarded.push_back({pair.a, pair.b, distances.stop, distances.warn});
    }
  }
  return guarded;
}

void warn_of_stopped(const BakedRobot& robot, const RobotArguments& arguments, Warnings& warnings) {
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.is_stopped) {
      warnings.add(arguments.urdf,
                   concat("links '", robot.model.links[pair.a].name, "' and '",
                          robot.model.links[pair.b].name,
                          "' are nowhere found farther apart than the stop distance, ",
                          arguments.stop, " m, so a guard would always say stop; ",
                          metres("--stop", arguments.stop) == 0 ? "" : "lower --stop, or ",
                          "disable the pair in an SRDF"));
    }
  }
}

}  // namespace

void add_robot_options(CLI::App& command, const std::string& name, RobotArguments& arguments) {
  command.add_option(name, arguments.urdf, "The robot (URDF)")->required();
  command
      .add_option("--package", arguments.packages,
                  "Folder of the package NAME, for meshes at package://NAME/...; may be repeated. "
                  "\nDefault: the first folder of that name beside the URDF or above it")
      ->type_name("NAME=DIR")
      ->type_size(1)
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command.add_option("--srdf", arguments.srdf, "Pairs of links that shall not be looked at")
      ->type_name("FILE");
  command
      .add_option("--cell", arguments.cell,
                  "Size of a lattice cell; default: the finest that all the links fit")
      ->type_name("LENGTH");
  command.add_option("--leaf-size", arguments.leaf_size, "Most triangles in a leaf")
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  command.add_option("--stop", arguments.stop, "Links nearer than this must stop")
      ->type_name("LENGTH")
      ->capture_default_str();
  command
      .add_option("--warn", arguments.warn, "Links nearer than this are warned of; default: --stop")
      ->type_name("LENGTH");
  command.add_flag("--progress", arguments.progress,
                   "Show a progress bar at once; default: on a terminal, after a second");
}

Model described_robot(const RobotArguments& arguments, Warnings& warnings) {
  (void)distances_of(arguments);
  Model model =
      read_urdf(arguments.urdf, packages_of(arguments.packages), arguments.srdf, warnings);
  check_counts(model, arguments.urdf);
  return model;
}

BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings) {
  const Distances distances = distances_of(arguments);
  BakedRobot made;
  made.model = std::move(model);
  made.cell = robot_cell(made.model, cell_of(arguments), arguments.urdf);
  check_range(distances, made.cell);
  const auto count = static_cast<double>(made.model.links.size());
  Progress progress(kBakingWeight * count + count * (count - 1) / 2, arguments.progress);
  made.links = bake_links(made.model, made.cell, arguments, progress, warnings);
  const std::vector<PostMesh> meshes = meshes_of(made.links);
  made.pairs = decide(made.model, meshes, made.cell, distances.stop, progress);
  warn_of_stopped(made, arguments, warnings);
  made.fixed =
      std::make_unique<FixedRobot>(made.model, meshes, made.cell, guarded(made.pairs, distances));
  return made;
}

}  // namespace flashbvh::tool
