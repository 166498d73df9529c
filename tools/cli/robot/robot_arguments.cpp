#include "cli/robot/robot_arguments.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "image/fine_length.hpp"

namespace flashbvh::tool {
namespace {

/// `place`, `name`: of the length, for the message.
double parsed_length(const std::string& text, const std::string& place, const std::string& name) {
  const std::optional<double> length = parse_number(text);
  if (!length || *length < 0 || !is_coordinate(*length)) {
    throw UserError(place, name, "is no length; give a number from 0, in metres");
  }
  return *length;
}

/// The option's whole value.
double metres(const std::string& option, const std::string& text) {
  return parsed_length(text, option + " " + text, "");
}

/// A part of an option's value.
double metres_in(const std::string& place, const std::string& text) {
  return parsed_length(text, place, tool::quoted(text) + " ");
}

std::size_t link_of(const Model& model, const std::string& place, const std::string& name) {
  const std::size_t link = find_link(model, name);
  if (link == kNoLink) {
    throw UserError(place, "names '", name, "', which is no link that collides; these are ",
                    joined(
                        model.links, [](const ModelLink& of) { return of.name; }, ","));
  }
  return link;
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
  const std::string warn = split == std::string::npos ? stop : lengths.substr(split + 1);
  const Distances distances = {metres_in(place, stop), metres_in(place, warn)};
  if (distances.warn < distances.stop) {
    throw UserError(place, "warns nearer than it stops; warn from further off");
  }
  const auto [a, b] = links_of(model, place, given.substr(0, equals));
  return {a, b, distances.stop, distances.warn};
}

/// UserError if firmware cannot hold the radius.
double zone_radius(const std::string& place, const std::string& text, double cell) {
  constexpr std::uint32_t kMostCells = UINT32_MAX / kFineOne;
  const double radius = metres_in(place, text);
  if (fine_length_rounded_up(radius, cell).count == UINT32_MAX) {
    throw UserError(place, "is out of range: 0 to ", significant(kMostCells * cell, 6), " m, ",
                    kMostCells, " cells; lengths are in metres: ", shortest(radius), " mm is ",
                    shortest(radius / 1000));
  }
  return radius;
}

}  // namespace

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

double simplify_length(const RobotArguments& arguments) {
  const double length = metres("--simplify", *arguments.simplify);
  if (length == 0) {
    throw UserError("--simplify " + *arguments.simplify,
                    "simplifies nothing; give a positive number, in metres");
  }
  return length;
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

Distances usual_distances(const RobotArguments& arguments) {
  const std::string warn = arguments.warn.value_or(arguments.stop);
  const Distances distances = {metres("--stop", arguments.stop), metres("--warn", warn)};
  if (distances.warn < distances.stop) {
    throw UserError("--warn " + warn, "is nearer than --stop ", arguments.stop,
                    "; warn from further off");
  }
  return distances;
}

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

double least_stop(const AllDistances& distances) {
  double least = distances.usual.stop;
  for (const GuardedPair& pair : distances.own) {
    least = least == 0 || (pair.stop > 0 && pair.stop < least) ? pair.stop : least;
  }
  return least;
}

ZoneRadii zone_radii(const Model& model, const std::vector<std::string>& given, double cell) {
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
    if (!radii.emplace(number, zone_radius(place, option.substr(equals + 1), cell)).second) {
      throw UserError(place, "is a second zone of ", name, "; give it one");
    }
  }
  return radii;
}

Distances distances_of(const AllDistances& distances, const PairVerdict& pair) {
  const GuardedPair* const own = find_pair(distances.own, pair.a, pair.b);
  return own != nullptr ? Distances{own->stop, own->warn} : distances.usual;
}

std::vector<std::string> files_read(const RobotArguments& arguments, const Model& model) {
  std::set<std::string> read = {arguments.urdf};
  if (!arguments.srdf.empty()) {
    read.insert(arguments.srdf);
  }
  for (const ModelLink& link : model.links) {
    read.insert(link.files.begin(), link.files.end());
  }
  return {read.begin(), read.end()};
}

void add_described_options(CLI::App& command, const std::string& name, RobotArguments& arguments) {
  add_option(command, name.c_str(), arguments.urdf, "FILE", "The robot (URDF)")->required();
  repeated(
      add_option(command, "--package", arguments.packages, "NAME=DIR",
                 "Folder of the package NAME, for meshes at package://NAME/...; may be repeated. "
                 "\nDefault: the first folder of that name next to the robot's file or above it"));
  command.add_flag("--visual-too", arguments.visual_too,
                   "Links with visual shapes alone collide by them; without it, with nothing");
}

void add_time(CLI::App& command, RobotArguments& arguments, const std::string& late) {
  add_option(command, "--time", arguments.time, "SECONDS",
             late + ". \nDefault: as long as it takes");
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
      ->capture_default_str()
      ->each([&arguments](const std::string&) { arguments.has_leaf_size = true; });
  add_option(
      command, "--simplify", arguments.simplify, "LENGTH",
      "Firmware gets fewer triangles, within LENGTH of the links', proven; what can collide is "
      "decided\nwith all triangles. A guard stops earlier by up to four times LENGTH");
  add_option(
      command, "--fit", arguments.fit, "BYTES",
      "Simplify as little as it takes for the image to be no larger, and choose --leaf-size");
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
  add_time(command, arguments, "What is not decided by then is undecided, and guarded");
  add_progress(command, arguments.progress);
}

}  // namespace flashbvh::tool
