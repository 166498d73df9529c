#include "mesh/units.hpp"

#include <array>
#include <filesystem>
#include <numeric>
#include <string_view>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct Measure {
  std::string_view name;
  std::uint64_t nanometres;
  std::string_view name_in_3mf = {};
};

/// In the order of flashbvh::Unit, from nm on.
constexpr std::array<Measure, kUnitCount - 1> kUnits = {{{"nm", 1},
                                                         {"um", 1'000, "micron"},
                                                         {"mm", 1'000'000, "millimeter"},
                                                         {"cm", 10'000'000, "centimeter"},
                                                         {"m", 1'000'000'000, "meter"},
                                                         {"mil", 25'400},
                                                         {"in", 25'400'000, "inch"},
                                                         {"ft", 304'800'000, "foot"}}};

/// Unit::none if no unit has this name.
Unit unit_of(std::string_view name, std::string_view Measure::*member) {
  for (std::size_t i = 0; i < kUnits.size(); ++i) {
    if (!name.empty() && kUnits[i].*member == name) {
      return static_cast<Unit>(i + 1);
    }
  }
  return Unit::none;
}

std::uint64_t nanometres_in(Unit unit) {
  return kUnits[static_cast<std::size_t>(unit) - 1].nanometres;
}

/// "part.stl" also names meshes/part.stl.
bool is_meant(const std::string& name, const std::string& file) {
  return name == file || name == std::filesystem::path(file).filename().string();
}

}  // namespace

Units::Units(const std::vector<std::string>& given, const std::vector<std::string>& files) {
  for (const std::string& option : given) {
    const std::string place = "--unit " + option;
    const std::size_t equals = option.rfind('=');
    const std::string name = equals == std::string::npos ? option : option.substr(equals + 1);
    const Unit unit = unit_of(name, &Measure::name);
    if (unit == Unit::none) {
      throw UserError(place, "'", name, "' is no unit; give ", kNames);
    }
    if (equals != std::string::npos) {
      set_own(place, option.substr(0, equals), unit, files);
      continue;
    }
    if (common_ != Unit::none && common_ != unit) {
      throw UserError(place, "the unit is ", common(),
                      " already; give a file's own unit as --unit FILE=", name);
    }
    common_ = unit;
  }
  if (common_ == Unit::none && !own_.empty()) {
    throw UserError("--unit " + given[0],
                    "says nothing of the unit of the results; add it, such as --unit mm");
  }
}

void Units::set_own(const std::string& place, const std::string& name, Unit unit,
                    const std::vector<std::string>& files) {
  bool found = false;
  for (const std::string& file : files) {
    if (is_meant(name, file)) {
      found = true;
      if (const Unit known = own_.emplace(file, unit).first->second; known != unit) {
        throw UserError(place, file, " is in ", unit_name(known), " already; give it one unit");
      }
    }
  }
  if (!found) {
    throw UserError(place, "no mesh '", name,
                    "' is given; name one as it is given, or by its name without folders");
  }
}

Unit Units::unit_of_file(const std::string& file, Unit says) const {
  const auto own = own_.find(file);
  return own == own_.end() ? says : own->second;
}

double Units::converted(double length, const std::string& file, Unit says) const {
  const Unit own = unit_of_file(file, says);
  if (common_ == Unit::none || own == Unit::none) {
    return length;
  }
  const std::uint64_t from = nanometres_in(own);
  const std::uint64_t to = nanometres_in(common_);
  const std::uint64_t both = std::gcd(from, to);
  // In lowest terms, a conversion from mm to m rounds each length once, by the division.
  const std::uint64_t times = from / both;
  const std::uint64_t parts = to / both;
  return length * static_cast<double>(times) / static_cast<double>(parts);
}

void Units::convert(bake::SourceMesh& mesh, const std::string& file, Unit says) const {
  for (auto& vertex : mesh.vertices) {
    for (double& coordinate : vertex) {
      coordinate = converted(coordinate, file, says);
    }
  }
}

std::string unit_name(Unit unit) {
  return unit == Unit::none ? "" : std::string(kUnits[static_cast<std::size_t>(unit) - 1].name);
}

Unit unit_of_3mf(std::string_view name) {
  return unit_of(name, &Measure::name_in_3mf);
}

std::string Units::contradiction(const std::string& file, Unit says) const {
  const Unit own = unit_of_file(file, says);
  return own == says || says == Unit::none
             ? ""
             : concat("carries the unit ", unit_name(says), ", but --unit FILE=", unit_name(own),
                      " takes its numbers for ", unit_name(own));
}

std::string Units::with_unit(double length) const {
  return concat(shortest(length), common_ == Unit::none ? "" : " ", common());
}

}  // namespace flashbvh::tool
