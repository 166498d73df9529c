#include "cli/robot/robot_output.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/json.hpp"
#include "cli/robot/baked_robot.hpp"
#include "image/c_writer.hpp"
#include "robot/baked/bake_links.hpp"
#include "robot/baked/robot_writer.hpp"
#include "robot/model.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Size of a Mesh on a 32-bit core.
constexpr std::size_t kMeshViewBytes = 64;

template <class Rows, class NameOf>
int width_of(const Rows& rows, const char* heading, const NameOf& name_of) {
  std::size_t widest = std::string(heading).size();
  for (const auto& row : rows) {
    widest = std::max(widest, std::string(name_of(row)).size());
  }
  return static_cast<int>(widest) + 2;
}

void print_links(const BakedRobot& robot) {
  const Model& model = robot.model;
  const std::vector<BakedLink>& links = robot.links;
  const int sizes = width_of(robot.sizes, "size", [](const Size& s) { return size_text(s, "m"); });
  const int width = width_of(model.links, "link", [](const ModelLink& l) { return l.name; });
  const int joints = width_of(model.joints, "joint", [](const ModelJoint& j) { return j.name; });
  std::cout << std::left << std::setw(width) << "link" << std::setw(joints) << "joint"
            << "triangles     bytes  " << std::setw(sizes) << "size"
            << "sources\n";
  for (std::size_t i = 0; i < links.size(); ++i) {
    const ModelLink& link = model.links[i];
    std::cout << std::left << std::setw(width) << link.name << std::setw(joints)
              << joint_name(model, link.joint, "base") << std::right << std::setw(9)
              << links[i].tree.triangles.size() << std::setw(10) << links[i].image_bytes() << "  "
              << std::left << std::setw(sizes) << size_text(robot.sizes[i], "m")
              << joined(link.sources, [](const std::string& source) { return source; }) << "\n";
  }
}

void print_joints(const Model& model) {
  if (model.joints.empty()) {
    return;
  }
  const int width = width_of(model.joints, "joint", [](const ModelJoint& j) { return j.name; });
  std::cout << "\n"
            << std::left << std::setw(width) << "joint" << std::setw(width) << "parent"
            << std::setw(12) << "type"
            << "moves\n";
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    const ModelJoint& joint = model.joints[i];
    std::cout << std::left << std::setw(width) << joint.name << std::setw(width)
              << joint_name(model, joint.parent, "base") << std::setw(12) << type_name(joint.type)
              << moves_of(model, i) << "\n";
  }
}

void print_pairs(const Model& model, const std::vector<PairVerdict>& pairs) {
  if (pairs.empty()) {
    return;
  }
  const auto links_of = [&](const PairVerdict& pair) {
    return model.links[pair.a].name + " - " + model.links[pair.b].name;
  };
  const int width = width_of(pairs, "pair", links_of);
  const int verdicts =
      width_of(pairs, "collide", [](const PairVerdict& pair) { return name_of(pair); });
  std::cout << "\n"
            << std::left << std::setw(width) << "pair" << std::setw(verdicts) << "collide"
            << "reason\n";
  for (const PairVerdict& pair : pairs) {
    std::cout << std::left << std::setw(width) << links_of(pair) << std::setw(verdicts)
              << name_of(pair) << pair.reason
              << (pair.verdict == MatrixVerdict::never && pair.is_guarded
                      ? "; guarded: may come within --stop"
                      : "")
              << "\n";
  }
}

/// Prints a line at the top with the pairs that no guard tests.
void print_unguarded(const Model& model, const std::vector<UnguardedPair>& unguarded) {
  if (!unguarded.empty()) {
    std::cout << "not guarded: " << names_of(model, unguarded) << "\n\n";
  }
}

Json pair_json(const Model& model, const PairVerdict& pair) {
  Json witness = Json::object();
  for (std::size_t i = 0; i < pair.witness.size(); ++i) {
    witness[model.joints[model.variables[i]].name] = pair.witness[i];
  }
  return {{"a", model.links[pair.a].name}, {"b", model.links[pair.b].name},
          {"verdict", name_of(pair)},      {"reason", pair.reason},
          {"witness", std::move(witness)}, {"cells", pair.joint_boxes},
          {"guarded", pair.is_guarded}};
}

double deviation_of(const BakedRobot& robot) {
  double most = 0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    most = std::max(most, robot.links[i].tree.deviation);
  }
  return most;
}

/// The effect of simplifying firmware's links.
std::string simplified_text(const BakedRobot& robot) {
  std::size_t before = 0;
  std::size_t after = 0;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    before += robot.model.links[i].mesh.triangles.size();
    after += robot.links[i].tree.triangles.size();
  }
  return concat("simplified: ", before, " triangles -> ", after, ", leaves of ", robot.leaf_size,
                "; firmware's links and the URDF's lie within ", shortest(robot.simplified),
                " m of each other, so a guard stops up to ",
                shortest(kEarlyByDeviation * robot.simplified),
                " m earlier; pairs are decided with all triangles\n");
}

Json joint_name_json(const Model& model, std::size_t joint) {
  return joint == kNoJoint ? Json() : Json(model.joints[joint].name);
}

Json link_json(const Model& model, const ModelLink& link, const BakedLink& baked,
               const Size& size) {
  return {{"name", link.name},
          {"joint", joint_name_json(model, link.joint)},
          {"triangles", baked.tree.triangles.size()},
          {"flash_bytes", baked.image_bytes()},
          {"size", size},
          {"deviation", baked.tree.deviation},
          {"source_triangles", link.mesh.triangles.size()},
          {"sources", link.sources}};
}

Json joint_json(const Model& model, std::size_t number) {
  const ModelJoint& joint = model.joints[number];
  Json json = {{"name", joint.name},
               {"type", type_name(joint.type)},
               {"parent", joint_name_json(model, joint.parent)},
               {"lower", joint.lower},
               {"upper", joint.upper},
               {"variable", joint.variable}};
  if (is_mimic(model, number)) {
    json["multiplier"] = joint.multiplier;
    json["offset"] = joint.offset;
  }
  return json;
}

}  // namespace

void print_robot(const BakedRobot& robot, const RobotFlash& flash) {
  print_unguarded(robot.model, robot.unguarded);
  print_links(robot);
  print_joints(robot.model);
  print_pairs(robot.model, robot.pairs);
  std::cout << "\ncell " << shortest(robot.cell) << " m, largest deviation "
            << significant(deviation_of(robot), 3) << " m; " << flash.bytes << " bytes of flash, "
            << robot_ram_bytes(robot.robot(), robot.fixed->pair_joint_count())
            << " bytes of RAM for a guard\n";
  if (robot.simplified > 0) {
    std::cout << simplified_text(robot);
  }
  if (flash.smaller) {
    std::cout << "--leaf-size " << kLargeLeaf << ": " << *flash.smaller
              << " bytes of flash; queries take up to three times the work\n";
  }
}

Json robot_json(const BakedRobot& robot, const RobotFlash& flash) {
  const Model& model = robot.model;
  Json json = {{"name", model.name},
               {"not_guarded", unguarded_json(model, robot.unguarded)},
               {"pairs", Json::array()},
               {"links", Json::array()},
               {"joints", Json::array()}};
  for (const PairVerdict& pair : robot.pairs) {
    json["pairs"].push_back(pair_json(model, pair));
  }
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    json["links"].push_back(link_json(model, model.links[i], robot.links[i], robot.sizes[i]));
  }
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    json["joints"].push_back(joint_json(model, i));
  }
  json["cell"] = robot.cell;
  json["deviation"] = deviation_of(robot);
  json["simplified"] = robot.simplified;
  json["leaf_size"] = robot.leaf_size;
  json["flash_bytes"] = flash.bytes;
  if (flash.smaller) {
    json["flash_bytes_leaf_size_5"] = *flash.smaller;
  }
  json["ram_bytes"] = robot_ram_bytes(robot.robot(), robot.fixed->pair_joint_count());
  return json;
}

void print_robot_file(const RobotFile& file) {
  const Model model = file.model();
  const Robot& robot = file.robot();
  const RobotImageHeader& header = file.header();
  std::cout << "robot " << model.name << ", format version " << header.version << ": "
            << header.byte_count << " bytes of flash; "
            << robot_ram_bytes(robot, header.pair_joint_count) << " bytes of RAM for a guard, "
            << kMeshViewBytes * header.link_count << " for views of its meshes\ncell "
            << shortest(file.cell()) << " m; slack "
            << significant(unit_length(robot.slack, file.cell()), 4) << " m; variables "
            << int{robot.variable_count} << "; hash " << hex(robot.hash, 8) << "\n\n";
  print_unguarded(model, file.unguarded());
  const int width = width_of(model.links, "link", [](const ModelLink& l) { return l.name; });
  const int joints = width_of(model.joints, "joint", [](const ModelJoint& j) { return j.name; });
  const std::vector<Size> sizes = link_sizes(model, robot.meshes, file.cell());
  std::cout << std::left << std::setw(width) << "link" << std::setw(joints) << "joint"
            << "triangles  size\n";
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    std::cout << std::left << std::setw(width) << model.links[i].name << std::setw(joints)
              << joint_name(model, model.links[i].joint, "base") << std::right << std::setw(9)
              << robot.meshes[i].triangle_count << "  " << size_text(sizes[i], "m") << "\n";
  }
  print_joints(model);
  std::cout << (robot.pair_count == 0 ? "" : "\npairs that can collide: stop, warn in m\n");
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    const RobotPair& pair = robot.pairs[i];
    std::cout << model.links[pair.a].name << " - " << model.links[pair.b].name << "  "
              << significant(unit_length(pair.stop, file.cell()), 4) << ", "
              << significant(unit_length(pair.warn, file.cell()), 4) << "\n";
  }
}

void print_robot_file_json(const RobotFile& file) {
  const Model model = file.model();
  const Robot& robot = file.robot();
  Json json = {{"name", model.name},
               {"format_version", file.header().version},
               {"bytes", file.header().byte_count},
               {"ram_bytes", robot_ram_bytes(robot, file.header().pair_joint_count)},
               {"cell", file.cell()},
               {"slack", unit_length(robot.slack, file.cell())},
               {"hash", robot.hash},
               {"not_guarded", unguarded_json(model, file.unguarded())},
               {"links", Json::array()},
               {"joints", Json::array()},
               {"pairs", Json::array()}};
  const std::vector<Size> sizes = link_sizes(model, robot.meshes, file.cell());
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    json["links"].push_back({{"name", model.links[i].name},
                             {"joint", joint_name_json(model, model.links[i].joint)},
                             {"triangles", robot.meshes[i].triangle_count},
                             {"size", sizes[i]}});
  }
  for (std::size_t i = 0; i < model.joints.size(); ++i) {
    json["joints"].push_back(joint_json(model, i));
  }
  for (std::size_t i = 0; i < robot.pair_count; ++i) {
    const RobotPair& pair = robot.pairs[i];
    json["pairs"].push_back({{"a", model.links[pair.a].name},
                             {"b", model.links[pair.b].name},
                             {"stop", unit_length(pair.stop, file.cell())},
                             {"warn", unit_length(pair.warn, file.cell())}});
  }
  print_object(json);
}

}  // namespace flashbvh::tool
