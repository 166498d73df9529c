// Units of length of the numbers in mesh files.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::tool {

/// The unit's name as in --unit; empty for none.
std::string unit_name(Unit unit);

/// The --unit options for some mesh files. "U" is the unit of all results and lengths, and of each
/// file without a unit of its own. "FILE=U" gives a file its own unit, whatever the file says.
/// Files with a unit are converted.
class Units {
 public:
  /// The names of all units, for messages.
  static constexpr const char* kNames = "nm, um, mm, cm, m, mil, in or ft";

  /// No unit is given.
  Units() = default;
  /// `given`: the arguments of each --unit. UserError for an unknown unit or file, a file with two
  /// units, or units of files without a common unit to convert to.
  Units(const std::vector<std::string>& given, const std::vector<std::string>& files);

  /// Converts the mesh in `file`, one of the files. `says`: the unit that the file carries, if any.
  void convert(bake::SourceMesh& mesh, const std::string& file, Unit says) const;
  /// Converts a length of that mesh.
  double converted(double length, const std::string& file, Unit says) const;
  /// A warning if --unit FILE=U contradicts what the file says; else empty.
  std::string contradiction(const std::string& file, Unit says) const;

  /// The name of the common unit; if none was given, it is empty and no file is converted.
  std::string common() const { return unit_name(common_); }
  Unit unit() const { return common_; }
  /// `length`, in the common unit, with the unit's name if there is one.
  std::string with_unit(double length) const;

 private:
  Unit unit_of_file(const std::string& file, Unit says) const;
  void set_own(const std::string& place, const std::string& name, Unit unit,
               const std::vector<std::string>& files);

  Unit common_ = Unit::none;
  std::map<std::string, Unit> own_;  ///< by file
};

/// By its name in 3MF; Unit::none if there is none.
Unit unit_of_3mf(std::string_view name);

}  // namespace flashbvh::tool
