#include "robot/read/urdf.hpp"

#include "robot/read/kinematic_tree.hpp"
#include "robot/read/link_mesh.hpp"
#include "robot/read/srdf.hpp"
#include "robot/read/urdf_document.hpp"
#include "robot/read/xml_file.hpp"

namespace flashbvh::tool {
namespace {

bool are_neighbours(const Model& model, std::size_t a, std::size_t b) {
  const std::size_t joint_a = model.links[a].joint;
  const std::size_t joint_b = model.links[b].joint;
  const auto hangs_on = [&](std::size_t joint, std::size_t other) {
    return joint != kNoJoint && model.joints[joint].parent == other;
  };
  return joint_a == joint_b || hangs_on(joint_a, joint_b) || hangs_on(joint_b, joint_a);
}

void add_links(const UrdfRobot& robot, const KinematicTree& tree, const std::string& path,
               const Packages& packages, Model& model, Warnings& warnings) {
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const UrdfLink& link = robot.links[i];
    model.mounts.push_back({link.name, tree.links[i].joint, tree.links[i].transform});
    if (link.collisions.empty()) {
      if (link.has_visual) {
        warnings.add(at_element(path, "link", link.name),
                     "has a <visual> but no <collision>: it collides with nothing");
      }
      continue;
    }
    model.links.emplace_back();
    model.links.back().name = link.name;
    model.links.back().joint = tree.links[i].joint;
    add_link_mesh(link, tree.links[i].transform, path, packages, model.links.back(), warnings);
  }
  if (model.links.empty()) {
    throw UserError(path, "has no link with a <collision>; give those that can collide one");
  }
}

std::vector<std::string> names_of(const std::vector<UrdfLink>& links) {
  std::vector<std::string> names;
  names.reserve(links.size());
  for (const UrdfLink& link : links) {
    names.push_back(link.name);
  }
  return names;
}

}  // namespace

Model read_urdf(const std::string& path, const Packages& packages, const std::string& srdf,
                Warnings& warnings) {
  const UrdfRobot robot = read_urdf_document(path);
  KinematicTree tree = kinematic_tree(robot, path, warnings);
  if (!robot.soft_limits.empty()) {
    warnings.add(path,
                 concat("has a <safety_controller> whose soft limits do not count, the <limit> "
                        "does, of ",
                        joined(robot.soft_limits, [](const std::string& name) { return name; }),
                        "; if the machine keeps the soft limits, make them the <limit>"));
  }
  Model model;
  model.name = robot.name;
  model.path = path;
  add_links(robot, tree, path, packages, model, warnings);
  model.joints = std::move(tree.joints);
  model.variables = std::move(tree.variables);
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      if (are_neighbours(model, a, b)) {
        model.neighbours.emplace_back(a, b);
      }
    }
  }
  if (!srdf.empty()) {
    model.disabled = read_srdf(srdf, model, names_of(robot.links), warnings);
  }
  return model;
}

}  // namespace flashbvh::tool
