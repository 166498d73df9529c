#include "robot/pipeline/request.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "image/fine_length.hpp"

namespace flashbvh::tool {
namespace {

/// `place`: the option and its value. `name`: of a length that is a part of the value.
double metres(const std::string& place, const std::string& text, const std::string& name = "") {
  const std::optional<double> length = parse_number(text);
  if (!length || *length < 0 || !is_coordinate(*length)) {
    throw UserError(place, name, "is no length; give a number from 0, in metres");
  }
  return *length;
}

/// A part of an option's value.
double metres_in(const std::string& place, const std::string& text) {
  return metres(place, text, tool::quoted(text) + " ");
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

/// The texts before and after the first `mark`; none if one of them is empty.
std::optional<std::pair<std::string, std::string>> halves(const std::string& text, char mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos || at == 0 || at + 1 == text.size()) {
    return std::nullopt;
  }
  return std::pair(text.substr(0, at), text.substr(at + 1));
}

/// LINK,LINK=STOP[,WARN]
GuardedPair own_distances(const Model& model, const std::string& given) {
  const std::string place = "--pair " + given;
  const auto sides = halves(given, '=');
  if (!sides) {
    throw UserError(place, "is no LINK,LINK=STOP[,WARN]; give two links and their distances");
  }
  const auto [a, b] = links_of(model, place, sides->first);
  const auto both = halves(sides->second, ',');
  const double stop = metres_in(place, both ? both->first : sides->second);
  const double warn = both ? metres_in(place, both->second) : stop;
  if (warn < stop) {
    throw UserError(place, "warns nearer than it stops; warn from further off");
  }
  return {a, b, stop, warn};
}

}  // namespace

void check_length(double length, std::uint32_t most, const std::string& place, double cell) {
  if (fine_length_rounded_up(length, cell).count > most) {
    throw UserError(place, "is out of range: 0 to ", significant(most * cell / kFineOne, 6), " m, ",
                    most / kFineOne, " cells; lengths are in metres: ", shortest(length), " mm is ",
                    shortest(length / 1000));
  }
}

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
  const std::string place = "--cell " + *request.cell;
  const double cell = metres(place, *request.cell);
  if (cell < static_cast<double>(std::numeric_limits<float>::min())) {
    throw UserError(place, "is no length; give a positive number, in metres");
  }
  return cell;
}

double simplify_length(const RobotRequest& request) {
  const std::string place = "--simplify " + *request.simplify;
  const double length = metres(place, *request.simplify);
  if (length == 0) {
    throw UserError(place, "simplifies nothing; give a positive number, in metres");
  }
  return length;
}

Packages packages_of(const std::vector<std::string>& given) {
  Packages packages;
  for (const std::string& option : given) {
    const auto named = halves(option, '=');
    if (!named) {
      throw UserError("--package " + option,
                      "is no NAME=DIR; give a package's name and its folder");
    }
    if (!packages.insert(*named).second) {
      throw UserError("--package " + option, "is a second folder of ", named->first,
                      "; give it one");
    }
  }
  return packages;
}

AllDistances usual_distances(const RobotRequest& request) {
  const std::string warn = request.warn.value_or(request.stop);
  AllDistances distances = {metres("--stop " + request.stop, request.stop),
                            metres("--warn " + warn, warn)};
  if (distances.warn < distances.stop) {
    throw UserError("--warn " + warn, "is nearer than --stop ", request.stop,
                    "; warn from further off");
  }
  return distances;
}

std::pair<std::size_t, std::size_t> links_of(const Model& model, const std::string& place,
                                             const std::string& names) {
  const auto both = halves(names, ',');
  if (!both) {
    throw UserError(place, "does not name LINK,LINK; give two links");
  }
  const std::pair links(link_of(model, place, both->first), link_of(model, place, both->second));
  if (links.first == links.second) {
    throw UserError(place, "names one link twice; give two");
  }
  return links;
}

AllDistances all_distances(const Model& model, const RobotRequest& request) {
  AllDistances all = usual_distances(request);
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

ZoneRadii zone_radii(const Model& model, const std::vector<std::string>& given, double cell) {
  ZoneRadii radii;
  for (const std::string& option : given) {
    const std::string place = "--zone " + option;
    const auto sides = halves(option, '=');
    if (!sides) {
      throw UserError(place, "is no JOINT=LENGTH; give a joint and the zone's radius, in metres");
    }
    const std::string& name = sides->first;
    const auto joint = std::find_if(model.joints.begin(), model.joints.end(),
                                    [&](const ModelJoint& of) { return of.name == name; });
    const auto number = static_cast<std::size_t>(joint - model.joints.begin());
    if (joint == model.joints.end() || !is_between_neighbours(model, number)) {
      throw UserError(place, "names '", name,
                      "', which is no moving joint between two links that collide; without --zone "
                      "the tables name such joints");
    }
    const double radius = metres_in(place, sides->second);
    check_length(radius, UINT32_MAX - 1, place, cell);
    if (!radii.emplace(number, radius).second) {
      throw UserError(place, "is a second zone of ", name, "; give it one");
    }
  }
  return radii;
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
