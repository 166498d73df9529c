// Output of all commands: JSON, its fields in order and an object a line, and tables for people,
// made of it.
#pragma once

#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "flashbvh/contact.hpp"
#include "robot/matrix/unguarded.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

using Json = nlohmann::ordered_json;

/// Prints a line on standard output; replaces bytes that are not valid UTF-8.
inline void print_object(const Json& object) {
  std::cout << object.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
}

inline Json json_of(const Warnings& warnings) {
  Json all = Json::array();
  for (const PlacedWarning& warning : warnings.all()) {
    all.push_back({{"place", warning.place}, {"warning", warning.what}});
  }
  return all;
}

/// Converts a length in 1/256 cell to the unit of the cell.
inline double unit_length(std::int64_t fine, double cell) {
  return static_cast<double>(fine) * cell / kFineOne;
}

inline Json point_json(const FinePoint& point, double cell) {
  return {unit_length(point.x, cell), unit_length(point.y, cell), unit_length(point.z, cell)};
}

inline Json unguarded_json(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  auto json = Json::array();
  for (const UnguardedPair& pair : unguarded) {
    json.push_back({{"a", model.links[pair.a].name},
                    {"b", model.links[pair.b].name},
                    {"reason", reason_of(model, pair)}});
    if (pair.why == WhyUnguarded::zone) {
      json.back()["joint"] = model.joints[pair.joint].name;
      json.back()["radius"] = pair.radius;
    }
  }
  return json;
}

/// A column: its heading, and the text of a row. Numbers are aligned on the right.
struct Column {
  std::string heading;
  std::function<std::string(const Json& row)> text;
  bool is_number = false;
};

/// A field that is a word or null, which is "-"; an array's elements are joined by commas.
Column word_column(const char* heading, const char* field);
/// A field that is a number, times `scale` if it has a fraction, with at most `digits` significant
/// digits; null is "-".
Column number_column(const char* heading, const char* field, int digits = 6, double scale = 1);

/// "upper - fore": the links `a` and `b` of a row.
std::string pair_text(const Json& row);
Column pair_column(const char* heading);

/// Prints columns as wide as their widest cell, to standard output; nothing if there are no rows.
void print_table(const Json& rows, const std::vector<Column>& columns);

/// Prints an object a line with --json; else a line with the heading, and a table.
void print_answers(bool json, const Json& rows, const std::string& heading,
                   const std::vector<Column>& columns);

}  // namespace flashbvh::tool
