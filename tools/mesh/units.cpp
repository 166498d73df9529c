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

/// 0 if there is no such unit.
std::uint64_t nanometres_in(std::string_view name) {
  const Unit unit = unit_of(name, &Measure::name);
  return unit == Unit::none ? 0 : kUnits[static_cast<std::size_t>(unit) - 1].nanometres;
}

/// "part.stl" also names meshes/part.stl.
bool is_meant(const std::string& name, const std::string& file) {
  return name == file || name == std::filesystem::path(file).filename().string();
}

[[noreturn]] void refuse_second_unit(const std::string& place, const std::string& file,
                                     const std::string& known) {
  throw UserError(place, file, " is in ", known, " already; give it one unit");
}

}  // namespace

Units::Units(const std::vector<std::string>& given, const std::vector<std::string>& files) {
  for (const std::string& option : given) {
    const std::size_t equals = option.rfind('=');
    const std::string unit = equals == std::string::npos ? option : option.substr(equals + 1);
    if (nanometres_in(unit) == 0) {
      throw UserError("--unit " + option, "'", unit, "' is no unit; give ", kNames);
    }
    if (equals == std::string::npos) {
      set_common(unit);
    } else {
      set_own(option.substr(0, equals), unit, files);
    }
  }
  if (common_.empty() && !own_.empty()) {
    throw UserError("--unit " + given[0],
                    "says nothing of the unit of the results; add it, such as --unit mm");
  }
}

void Units::set_common(const std::string& unit) {
  if (!common_.empty() && common_ != unit) {
    throw UserError("--unit " + unit, "the unit is ", common_,
                    " already; give a file's own unit as --unit FILE=", unit);
  }
  common_ = unit;
}

void Units::set_own(const std::string& name, const std::string& unit,
                    const std::vector<std::string>& files) {
  const std::string place = "--unit " + name + "=" + unit;
  bool found = false;
  for (const std::string& file : files) {
    if (is_meant(name, file)) {
      const std::string& known = own_.emplace(file, unit).first->second;
      if (known != unit) {
        refuse_second_unit(place, file, known);
      }
      found = true;
    }
  }
  if (!found) {
    throw UserError(place, "no mesh '", name,
                    "' is given; name one as it is given, or by its name without folders");
  }
}

/// In lowest terms: a conversion from mm to m rounds each length once, by the division.
struct Units::Ratio {
  double numerator = 1;
  double denominator = 1;

  double of(double length) const { return length * numerator / denominator; }
};

Units::Ratio Units::ratio_of(const std::string& file, Unit says) const {
  const auto own = own_.find(file);
  const std::string unit = own == own_.end() ? unit_name(says) : own->second;
  if (common_.empty() || unit.empty()) {
    return {};
  }
  const std::uint64_t from = nanometres_in(unit);
  const std::uint64_t to = nanometres_in(common_);
  const std::uint64_t common_part = std::gcd(from, to);
  const std::uint64_t numerator = from / common_part;
  const std::uint64_t denominator = to / common_part;
  return {static_cast<double>(numerator), static_cast<double>(denominator)};
}

void Units::convert(bake::SourceMesh& mesh, const std::string& file, Unit says) const {
  const Ratio ratio = ratio_of(file, says);
  for (auto& vertex : mesh.vertices) {
    for (double& coordinate : vertex) {
      coordinate = ratio.of(coordinate);
    }
  }
}

Unit Units::unit() const {
  return unit_of(common_, &Measure::name);
}

std::string unit_name(Unit unit) {
  return unit == Unit::none ? "" : std::string(kUnits[static_cast<std::size_t>(unit) - 1].name);
}

Unit unit_of_3mf(std::string_view name) {
  return unit_of(name, &Measure::name_in_3mf);
}

double Units::converted(double length, const std::string& file, Unit says) const {
  return ratio_of(file, says).of(length);
}

std::string Units::contradiction(const std::string& file, Unit says) const {
  const auto own = own_.find(file);
  if (says == Unit::none || own == own_.end() || own->second == unit_name(says)) {
    return "";
  }
  return concat("carries the unit ", unit_name(says), ", but --unit FILE=", own->second,
                " takes its numbers for ", own->second);
}

std::string Units::with_unit(double length) const {
  return shortest(length) + (common_.empty() ? "" : " " + common_);
}

}  // namespace flashbvh::tool
