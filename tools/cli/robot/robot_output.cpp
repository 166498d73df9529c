#include "cli/robot/robot_output.hpp"

#include <iostream>

#include "cli/table.hpp"
#include "image/c_writer.hpp"
#include "robot/baked/robot_writer.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Size of a Mesh on a 32-bit core.
constexpr std::size_t kMeshViewBytes = 64;

Json name_of_joint(const Model& model, std::size_t joint) {
  return joint == kNoJoint ? Json() : Json(model.joints[joint].name);
}

Json joints_json(const Model& model) {
  Json all = Json::array();
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const ModelJoint& joint = model.joints[i];
    all.push_back({{"name", joint.name},
                   {"type", type_name(joint.type)},
                   {"parent", name_of_joint(model, joint.parent)},
                   {"lower", joint.lower},
                   {"upper", joint.upper},
                   {"variable", joint.variable}});
    if (is_mimic(model, i)) {
      all.back().update({{"multiplier", joint.multiplier}, {"offset", joint.offset}});
    }
  }
  return all;
}

/// The links of a robot or an image.
Json links_json(const Model& model, const Robot& robot, const std::vector<Size>& sizes) {
  Json all = Json::array();
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    all.push_back({{"name", model.links[i].name},
                   {"joint", name_of_joint(model, model.links[i].joint)},
                   {"triangles", robot.meshes[i].triangle_count},
                   {"size", sizes[i]}});
  }
  return all;
}

Json links_json(const BakedRobot& robot) {
  Json all = links_json(robot.model, robot.robot(), robot.sizes);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const ModelLink& link = robot.model.links[i];
    all[i].update({{"flash_bytes", bake::image_size(robot.links[i])},
                   {"deviation", robot.links[i].deviation},
                   {"source_triangles", link.mesh.triangles.size()},
                   {"sources", link.sources}});
  }
  return all;
}

Json pairs_json(const Model& model, const std::vector<PairVerdict>& pairs) {
  Json all = Json::array();
  for (const PairVerdict& pair : pairs) {
    all.push_back({{"a", model.links[pair.a].name},
                   {"b", model.links[pair.b].name},
                   {"verdict", name_of(pair)},
                   {"reason", pair.reason},
                   {"witness", witness_json(model, pair)},
                   {"cells", pair.joint_boxes},
                   {"guarded", pair.is_guarded}});
  }
  return all;
}

/// The joint zones, in metres in their joints' frames, with shares of the joints' ranges.
Json zones_json(const BakedRobot& robot) {
  Json all = Json::array();
  for (const PairVerdict& pair : robot.pairs) {
    if (pair.zone) {
      const JointZone& zone = robot.zones[*pair.zone];
      all.push_back({{"joint", robot.model.joints[zone.joint].name},
                     {"a", robot.model.links[pair.a].name},
                     {"b", robot.model.links[pair.b].name},
                     {"middle", zone.shape.middle},
                     {"radius", zone.shape.radius},
                     {"hides", zone.hidden},
                     {"stops", pair.share()}});
    }
  }
  return all;
}

/// The facts of an image.
Json file_json(const RobotFile& file, const Model& model) {
  const Robot& robot = file.robot();
  Json pairs = Json::array();
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    const RobotPair& pair = robot.pairs[i];
    pairs.push_back({{"a", model.links[pair.a].name},
                     {"b", model.links[pair.b].name},
                     {"stop", unit_length(pair.stop, file.cell())},
                     {"warn", unit_length(pair.warn, file.cell())}});
  }
  return {{"name", model.name},
          {"format_version", file.header().version},
          {"bytes", file.header().byte_count},
          {"ram_bytes", robot_ram_bytes(robot)},
          {"cell", file.cell()},
          {"slack", unit_length(robot.slack, file.cell())},
          {"hash", robot.hash},
          {"not_guarded", unguarded_json(model, file.unguarded())},
          {"links", links_json(model, robot, link_sizes(model, robot.meshes, file.cell()))},
          {"joints", joints_json(model)},
          {"pairs", std::move(pairs)}};
}

/// A column of joints, or of the base.
Column joint_column(const char* heading, const char* field) {
  return {heading, [field](const Json& row) {
            return row[field].is_null() ? "base" : row[field].get<std::string>();
          }};
}

/// The links of a robot or an image, then its joints.
void print_links(const Model& model, const Json& robot, bool is_image) {
  std::vector<Column> columns = {word_column("link", "name"), joint_column("joint", "joint"),
                                 number_column("triangles", "triangles")};
  if (!is_image) {
    columns.push_back(number_column("bytes", "flash_bytes"));
  }
  columns.push_back({"size", [](const Json& row) { return size_text(row["size"], "m"); }});
  if (!is_image) {
    columns.push_back(word_column("sources", "sources"));
  }
  print_table(robot["links"], columns);
  std::cout << (model.joints.empty() ? "" : "\n");
  // For example "-1 to 1.5 rad, as left by -0.5".
  const auto moves = [&](const Json& row) {
    const std::string range =
        concat(significant(row["lower"], 6), " to ", significant(row["upper"], 6),
               row["type"] == "prismatic" ? " m" : " rad");
    const ModelJoint& master = model.joints[model.variables[row["variable"].get<std::size_t>()]];
    return concat(row["type"] == "continuous" ? "on and on" : range,
                  row.contains("multiplier")
                      ? concat(", as ", master.name, " by ", significant(row["multiplier"], 6))
                      : "");
  };
  print_table(robot["joints"], {word_column("joint", "name"),
                                joint_column("parent", "parent"),
                                word_column("type", "type"),
                                {"moves", moves}});
}

/// Prints a line at the top with the pairs that no guard tests.
void print_unguarded(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  if (!unguarded.empty()) {
    std::cout << "not guarded: " << names_of(model, unguarded) << "\n\n";
  }
}

/// The effect of simplifying firmware's links.
std::string simplified_text(const BakedRobot& robot) {
  std::size_t before = 0;
  std::size_t after = 0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    before += robot.model.links[i].mesh.triangles.size();
    after += robot.links[i].triangles.size();
  }
  return concat("simplified: ", before, " triangles -> ", after, ", leaves of ",
                bake::most_in_leaf(robot.leaf_size), "; ",
                early_text(links_deviation(robot.robot())),
                "; pairs are decided with all triangles\n");
}

}  // namespace

double links_deviation(const Robot& robot) {
  std::uint32_t most = 0;
  for (std::size_t i = 0; i < robot.link_count; ++i) {
    most = std::max<std::uint32_t>(most, robot.links[i].deviation);
  }
  return unit_length(most, cell_of(robot));
}

std::string early_text(double deviation) {
  return concat("firmware's links and the URDF's lie within ", metres(deviation, 3),
                " of each other, so a guard stops up to ", metres(kEarlyByDeviation * deviation, 3),
                " earlier");
}

Json witness_json(const Model& model, const PairVerdict& pair) {
  Json witness = Json::object();
  for (std::size_t i = 0; i < pair.witness.size(); ++i) {
    witness[model.joints[model.variables[i]].name] = pair.witness[i];
  }
  return witness;
}

Json robot_json(const BakedRobot& robot, std::size_t bytes) {
  double most = 0;
  for (const BakedLink& link : robot.links) {
    most = std::max(most, link.deviation);
  }
  return {{"name", robot.model.name},
          {"not_guarded", unguarded_json(robot.model, robot.unguarded)},
          {"zones", zones_json(robot)},
          {"pairs", pairs_json(robot.model, robot.pairs)},
          {"links", links_json(robot)},
          {"joints", joints_json(robot.model)},
          {"cell", robot.cell},
          {"deviation", most},
          {"simplified", robot.simplified},
          {"leaf_size", bake::most_in_leaf(robot.leaf_size)},
          {"flash_bytes", bytes},
          {"ram_bytes", robot_ram_bytes(robot.robot())}};
}

void print_robot(const BakedRobot& robot, const Json& json) {
  print_unguarded(robot.model, robot.unguarded);
  print_links(robot.model, json, false);
  if (!json["zones"].empty()) {
    std::cout
        << "\nlinks may touch inside a zone; what it hides or stops: shares of the joint's range\n";
  }
  const auto share = [](const char* field) {
    return Column{
        field,
        [field](const Json& row) { return significant(100 * row[field].get<double>(), 2) + " %"; },
        true};
  };
  print_table(json["zones"], {word_column("zone about", "joint"),
                              pair_column("pair"),
                              {"middle",
                               [](const Json& row) {
                                 const Json& at = row["middle"];
                                 return concat(significant(at[0], 3), " ", significant(at[1], 3),
                                               " ", significant(at[2], 3));
                               }},
                              number_column("radius", "radius", 4),
                              share("hides"),
                              share("stops")});
  std::cout << (robot.pairs.empty() ? "" : "\n");
  const auto reason = [](const Json& row) {
    return row["reason"].get<std::string>() +
           (row["verdict"] == "never" && row["guarded"] ? "; guarded: may come within --stop" : "");
  };
  print_table(json["pairs"],
              {pair_column("pair"), word_column("collide", "verdict"), {"reason", reason}});
  std::cout << "\ncell " << metres(robot.cell, 6) << ", largest deviation "
            << metres(links_deviation(robot.robot()), 3) << "; " << json["flash_bytes"]
            << " bytes of flash, " << json["ram_bytes"] << " bytes of RAM for a guard\n";
  if (robot.simplified > 0) {
    std::cout << simplified_text(robot);
  }
}

void print_robot_file(const RobotFile& file, bool is_json) {
  const Model model = file.model();
  const Json json = file_json(file, model);
  if (is_json) {
    print_object(json);
    return;
  }
  std::cout << file.name() << ": well-formed, a robot\nrobot " << model.name << ", format version "
            << json["format_version"] << ": " << json["bytes"] << " bytes of flash; "
            << json["ram_bytes"] << " bytes of RAM for a guard, "
            << kMeshViewBytes * model.links.size() << " for views of its meshes\ncell "
            << metres(file.cell(), 6) << "; slack " << metres(json["slack"], 4) << "; variables "
            << model.variables.size() << "; hash " << hex(file.robot().hash, 8) << "\n\n";
  print_unguarded(model, file.unguarded());
  print_links(model, json, true);
  std::cout << (json["pairs"].empty() ? "" : "\npairs that can collide: stop, warn in m\n");
  print_table(json["pairs"], {pair_column("pair"), number_column("stop", "stop", 4),
                              number_column("warn", "warn", 4)});
}

}  // namespace flashbvh::tool
