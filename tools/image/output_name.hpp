// The names of a baked mesh's files, and of identifiers in them.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace flashbvh::tool {

struct OutputName {
  std::string stem;  ///< of the files: stem.fbvh, stem.fbvh.h, stem.fbvh.c
  std::string word;  ///< the stem as an identifier, with which all names in the files begin
};

/// Names the output after the mesh file, or after `chosen` if that is not empty: "meshes/base
/// link.STL" gives the stem "base link" and the word base_link. UserError if `chosen` is no word.
OutputName output_name(const std::string& mesh_path, const std::string& chosen);

/// The names of one call's outputs so far. No two may differ in case alone, since some file systems
/// ignore case.
class TakenOutputs {
 public:
  /// UserError, naming `mesh` and ending with the `fix`, if the name is taken.
  void add(const OutputName& name, const std::string& mesh, const char* fix);

 private:
  std::map<std::string, std::string> words_;  ///< by lower-case name
  std::map<std::string, std::string> stems_;  ///< by lower-case name
};

/// Words for names, none of them empty; numbered from 2 on if they are equal but for their case.
std::vector<OutputName> distinct_names(const std::vector<std::string>& names);

}  // namespace flashbvh::tool
