#include "robot/pipeline/prepare.hpp"

#include <algorithm>
#include <iterator>

#include "robot/kinematics.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// A link with fewer cells along its longest side loses its shape.
constexpr double kFewCellsOfLink = 20;

/// The size in the link's own frame.
Size size_in_link(const Model& model, const ModelLink& link, std::vector<Vector3> vertices) {
  const auto mount = std::find_if(model.mounts.begin(), model.mounts.end(),
                                  [&](const ModelMount& of) { return of.name == link.name; });
  if (mount != model.mounts.end()) {
    const Transform to_link = inverse(mount->transform);
    for (Vector3& vertex : vertices) {
      vertex = placed(to_link, vertex);
    }
  }
  bake::SourceMesh mesh;
  mesh.vertices = std::move(vertices);
  return bake::extent_of(mesh).size();
}

/// The largest distance of a joint from its parent, or range of a prismatic joint, in metres.
double longest_joint(const Model& model) {
  double most = 0;
  for (const ModelJoint& joint : model.joints) {
    const Vector3& t = joint.fixed.translation;
    most = std::max(
        {most, length_of(t), joint.type == JointType::prismatic ? joint.upper - joint.lower : 0});
  }
  return most;
}

/// The cause of a large cell: the largest link, or the joints' distances and ranges.
std::string cause_of(const Model& model, const std::vector<Size>& sizes) {
  const auto largest = std::max_element(
      sizes.begin(), sizes.end(),
      [](const Size& u, const Size& v) { return longest_side(u) < longest_side(v); });
  const std::size_t link = static_cast<std::size_t>(largest - sizes.begin());
  const double joint = longest_joint(model);
  return joint > longest_side(*largest)
             ? concat("a joint lies or slides ", significant(joint, 3), " m far")
             : concat("link '", model.links[link].name, "' is ", size_text(*largest, "m"));
}

void warn_of_units(const Prepared& robot, const std::string& path, Warnings& warnings) {
  const Model& model = robot.model;
  const std::vector<Size>& sizes = robot.sizes;
  for (const OddSize& odd : odd_sizes(sizes)) {
    warnings.add(at_element(path, "link", model.links[odd.which].name),
                 concat("is ", size_text(sizes[odd.which], "m"), ", ", odd_size_text(odd, "links"),
                        odd.times > 1
                            ? "; URDF is in metres: if its mesh is in millimetres, give its <mesh> "
                              "scale=\"0.001 0.001 0.001\""
                            : "; if its mesh is in metres, leave out the scale of its <mesh>"));
  }
}

/// The smallest stop distance above 0; 0 if there is none.
double least_stop(const AllDistances& distances) {
  double least = distances.stop;
  for (const GuardedPair& pair : distances.own) {
    least = least == 0 || (pair.stop > 0 && pair.stop < least) ? pair.stop : least;
  }
  return least;
}

void warn_of_cell(const Prepared& robot, const RobotRequest& request, Warnings& warnings) {
  const Model& model = robot.model;
  const std::vector<Size>& sizes = robot.sizes;
  const double cell = robot.cell;
  const double stop = least_stop(robot.distances);
  const std::string place = request.cell ? "--cell " + *request.cell : request.urdf;
  const std::string remedy = request.cell
                                 ? "; give a finer one"
                                 : concat(", since ", cause_of(model, sizes), "; narrow that");
  if (stop > 0 && cell > stop / 10) {
    warnings.add(place, concat("makes a cell of ", significant(cell, 3),
                               " m, coarser than a tenth of the stop distance, ", shortest(stop),
                               " m", remedy, ", or a guard stops up to some cells too early"));
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (longest_side(sizes[i]) < kFewCellsOfLink * cell) {
      warnings.add(place, concat("makes a cell of ", significant(cell, 3), " m for link '",
                                 model.links[i].name, "' of ", size_text(sizes[i], "m"), remedy));
    }
  }
}

}  // namespace

std::vector<Size> link_sizes(const Model& model) {
  std::vector<Size> sizes;
  for (const ModelLink& link : model.links) {
    sizes.push_back(size_in_link(model, link, link.mesh.vertices));
  }
  return sizes;
}

std::vector<Size> link_sizes(const Model& model, const Mesh* meshes, double cell) {
  std::vector<Size> sizes;
  for (const ModelLink& link : model.links) {
    std::vector<Vector3> vertices = vertices_of(meshes[sizes.size()]);
    for (Vector3& vertex : vertices) {
      vertex = {vertex[0] * cell, vertex[1] * cell, vertex[2] * cell};
    }
    sizes.push_back(size_in_link(model, link, std::move(vertices)));
  }
  return sizes;
}

void warn_of_sizes(const Prepared& robot, const RobotRequest& request, Warnings& warnings) {
  warn_of_units(robot, request.urdf, warnings);
  warn_of_cell(robot, request, warnings);
}

}  // namespace flashbvh::tool
