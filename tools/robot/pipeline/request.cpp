#include "robot/pipeline/request.hpp"

#include <algorithm>
#include <limits>
#include <set>

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
  constexpr std::uint32_t kMostRadius = UINT32_MAX / kFineOne;
  const double radius = metres_in(place, text);
  if (fine_length_rounded_up(radius, cell).count == UINT32_MAX) {
    throw UserError(place, "is out of range: 0 to ", significant(kMostRadius * cell, 6), " m, ",
                    kMostRadius, " cells; lengths are in metres: ", shortest(radius), " mm is ",
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

std::optional<double> given_cell(const RobotRequest& request) {
  if (!request.cell) {
    return std::nullopt;
  }
  const double cell = metres("--cell", *request.cell);
  if (cell < static_cast<double>(std::numeric_limits<float>::min())) {
    throw UserError("--cell " + *request.cell, "is no length; give a positive number, in metres");
  }
  return cell;
}

double simplify_length(const RobotRequest& request) {
  const double length = metres("--simplify", *request.simplify);
  if (length == 0) {
    throw UserError("--simplify " + *request.simplify,
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

Distances usual_distances(const RobotRequest& request) {
  const std::string warn = request.warn.value_or(request.stop);
  const Distances distances = {metres("--stop", request.stop), metres("--warn", warn)};
  if (distances.warn < distances.stop) {
    throw UserError("--warn " + warn, "is nearer than --stop ", request.stop,
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

AllDistances all_distances(const Model& model, const RobotRequest& request) {
  AllDistances all = {usual_distances(request), {}};
  for (const std::string& given : request.pairs) {
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

std::vector<std::string> files_read(const RobotRequest& request, const Model& model) {
  std::set<std::string> read = {request.urdf};
  if (!request.srdf.empty()) {
    read.insert(request.srdf);
  }
  for (const ModelLink& link : model.links) {
    read.insert(link.files.begin(), link.files.end());
  }
  return {read.begin(), read.end()};
}

}  // namespace flashbvh::tool
