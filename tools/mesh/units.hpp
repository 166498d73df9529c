// Units of length: what the numbers in a mesh file mean.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::tool {

/// What --unit says of some mesh files. "U" is the unit of everything: of all results and lengths,
/// and of each file that "FILE=U" does not give another one; such a file is converted.
class Units {
 public:
  /// The names of all units, for messages.
  static constexpr const char* kNames = "nm, um, mm, cm, m, mil, in or ft";

  /// No unit is given.
  Units() = default;
  /// `given`: the words of each --unit. UserError if a unit or a file is unknown, if a file has two
  /// units, or if there are units of files but no common one to convert them to.
  Units(const std::vector<std::string>& given, const std::vector<std::string>& files);

  /// Converts the mesh in `file`, one of the files.
  void convert(bake::SourceMesh& mesh, const std::string& file) const;
  /// A length of that mesh.
  double converted(double length, const std::string& file) const;

  /// The name of the common unit; empty if none was given: then no file is converted.
  const std::string& common() const { return common_; }
  Unit unit() const;
  /// `length`, which is in the common unit, with the unit's name if there is one.
  std::string with_unit(double length) const;

 private:
  void set_common(const std::string& unit);
  struct Ratio;
  Ratio ratio_of(const std::string& file) const;
  void set_own(const std::string& name, const std::string& unit,
               const std::vector<std::string>& files);

  std::string common_;
  std::map<std::string, std::string> own_;  ///< by file
};

/// As it is given; empty for none.
std::string unit_name(Unit unit);

}  // namespace flashbvh::tool
