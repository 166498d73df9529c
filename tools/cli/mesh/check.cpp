// flashbvh check: proves that an image is well-formed, and that it represents a given mesh.
//
// An image represents a mesh if both have the same corners, triangle by triangle in the file's
// order, after rounding with the image's cell. The image may omit triangles that `bake --drop`
// leaves out.
#include <algorithm>
#include <array>
#include <iostream>

#include "bake/quantise.hpp"
#include "bake/surface.hpp"
#include "cli/commands.hpp"
#include "cli/table.hpp"
#include "image/image_file.hpp"
#include "image/mesh_warnings.hpp"
#include "mesh/defects.hpp"
#include "mesh/import.hpp"
#include "mesh/units.hpp"
#include "robot/baked/robot_file.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string text_of(const LatticePoint& point) {
  return concat("(", point[0], " ", point[1], " ", point[2], ")");
}

/// How an image differs from a mesh; `left_out`: triangles that it may lack.
struct Comparison {
  std::string difference;  ///< the first one; empty if there is none
  std::size_t left_out_degenerate = 0;
  std::size_t left_out_duplicate = 0;
};

/// Allows rotated corners, since `bake --deformable` rotates them. Empty if there is no difference.
std::string difference_of(std::uint32_t number, const std::array<LatticePoint, 3>& found,
                          const std::array<LatticePoint, 3>& wanted) {
  std::array<LatticePoint, 3> turned = found;
  for (int turns = 0; turns < 3; ++turns) {
    if (turned == wanted) {
      return "";
    }
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
  }
  const std::size_t corner = found[0] != wanted[0] ? 0 : found[1] != wanted[1] ? 1 : 2;
  return concat("corner ", corner, " of triangle ", number, " lies at ", text_of(found[corner]),
                " in the image, at ", text_of(wanted[corner]), " in the mesh");
}

/// `triangles`: of the image, in the mesh's order.
Comparison comparison(const ImageFile& image, const std::vector<SourceTriangle>& triangles,
                      const InputMesh& input) {
  Comparison found;
  if (!bake::fits(input.extent, image.cell())) {
    found.difference = "the mesh is too large for the image's cell";
    return found;
  }
  const std::vector<LatticePoint> vertices = vertices_of(image.tree());
  const bake::LatticeMesh rounded = bake::round_to_lattice(input.mesh, input.extent, image.cell());
  const MeshDefects defects = defects_of(input.mesh, rounded, input.degenerate);
  auto at = triangles.begin();
  for (std::uint32_t number = 0; number < rounded.triangles.size(); ++number) {
    const auto is_in = [&](const TriangleIds& ids) {
      return std::binary_search(ids.begin(), ids.end(), number);
    };
    if (at != triangles.end() && at->number == number) {
      std::array<LatticePoint, 3> in_image{};
      std::array<LatticePoint, 3> in_mesh{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        in_image[corner] = vertices[at->vertices[corner]];
        in_mesh[corner] =
            lattice_point(rounded.vertices[rounded.triangles[number][corner]], rounded.origin);
      }
      found.difference = difference_of(number, in_image, in_mesh);
      ++at;
    } else if (is_in(defects.degenerate) || is_in(defects.collapsed)) {
      ++found.left_out_degenerate;
    } else if (is_in(defects.duplicates)) {
      ++found.left_out_duplicate;
    } else {
      found.difference = concat("the image lacks triangle ", number);
    }
    if (!found.difference.empty()) {
      return found;
    }
  }
  if (at != triangles.end()) {
    found.difference = concat("the image has a triangle ", at->number, ", the mesh only ",
                              rounded.triangles.size());
  }
  return found;
}

/// UserError unless the shells that the image stores, and whether they are closed, agree with its
/// triangles. The library does not test the shells, and tests closedness by a sum. `of`: the mesh
/// of the image, for the message.
template <class Tree>
void check_surface(const Tree& tree, const bake::LatticeMesh& mesh, const std::string& path,
                   const std::string& of) {
  const bake::Surface surface = bake::surface_of(mesh);
  const bool same_shells = std::equal(surface.shell_vertices.begin(), surface.shell_vertices.end(),
                                      tree.shell_vertices, tree.shell_vertices + tree.shell_count);
  if (!same_shells || surface.is_closed != tree.is_closed) {
    throw UserError(path, "is invalid: ", of,
                    same_shells ? "its surface is not closed or open as it says"
                                : "its vertices of shells are not those that its triangles make",
                    "; bake it again");
  }
}

/// UserError unless the image's deviation in cells is its deviation in the unit, rounded up. The
/// library does not divide by the cell.
void check_deviation(const ImageFile& image) {
  if (image.header().deviation_sixteenths !=
      bake::sixteenths_above(image.deviation(), image.cell())) {
    throw UserError(image.path(),
                    "is invalid: its deviation in cells is not that in its unit; bake it again");
  }
}

struct CheckArguments {
  std::string image;
  std::string mesh;
  std::vector<std::string> units;
  bool json = false;
};

/// The results for a well-formed image.
struct CheckResult {
  std::string text;
  Json facts;
  bool is_equal = true;  ///< to the mesh, if one is given
};

/// Adds the result of comparing the mesh with the image.
void compare(const CheckArguments& arguments, const ImageFile& image,
             const std::vector<SourceTriangle>& triangles, CheckResult& result,
             Warnings& warnings) {
  const InputMesh input =
      read_mesh(arguments.mesh, Units(arguments.units, {arguments.mesh}), warnings);
  const auto [difference, degenerate, duplicate] = comparison(image, triangles, input);
  result.is_equal = difference.empty();
  result.facts.update({{"mesh", input.path}, {"equal", result.is_equal}});
  if (!result.is_equal) {
    result.text += ", but not " + input.path + ": " + difference;
    result.facts["difference"] = difference;
    return;
  }
  result.facts.update({{"left_out_degenerate", degenerate}, {"left_out_duplicate", duplicate}});
  result.text += ", equal to " + input.path;
  if (degenerate + duplicate != 0) {
    result.text +=
        concat(" without ", degenerate, " degenerate and ", duplicate, " duplicate triangles");
  }
}

CheckResult check_mesh(const CheckArguments& arguments, Warnings& warnings) {
  const ImageFile image(arguments.image);
  const std::vector<SourceTriangle> triangles = source_triangles(image);
  const bake::LatticeMesh mesh = mesh_of(image, triangles);
  std::visit([&](const auto& tree) { check_surface(tree, mesh, image.path(), ""); }, image.tree());
  check_deviation(image);
  const std::uint32_t nodes = image.header().node_count;
  CheckResult result = {
      concat(image.name(), ": well-formed, ", triangles.size(), " triangles, ", nodes, " nodes"),
      {{"kind", "mesh"}, {"triangles", triangles.size()}, {"nodes", nodes}}};
  if (!arguments.mesh.empty()) {
    compare(arguments, image, triangles, result, warnings);
  }
  warn_of_surface(surface_defects(mesh), image.path(), warnings);
  return result;
}

/// A mesh for check_surface(), with the triangles in any order.
bake::LatticeMesh mesh_of(const Mesh& link) {
  bake::LatticeMesh mesh;
  mesh.vertices.assign(link.vertices, link.vertices + link.vertex_count);
  for (std::uint32_t i = 0; i < link.triangle_count; ++i) {
    const auto& corner = link.triangles[i].corner;
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
  return mesh;
}

CheckResult check_robot(const CheckArguments& arguments) {
  if (!arguments.mesh.empty()) {
    throw UserError(arguments.image,
                    "is a robot's image, which --mesh can't be compared to; leave --mesh out");
  }
  const RobotFile file(arguments.image);
  const Robot& robot = file.robot();
  std::size_t triangles = 0;
  for (std::uint32_t i = 0; i < robot.link_count; ++i) {
    const Mesh& link = robot.meshes[i];
    check_surface(link, mesh_of(link), arguments.image, concat("of link ", i, ": "));
    if (robot.links[i].deviation + 15 < 16u * link.deviation_sixteenths) {
      throw UserError(arguments.image, "is invalid: link ", i,
                      " deviates by less than its mesh; bake it again");
    }
    triangles += link.triangle_count;
  }
  return {concat(file.name(), ": well-formed, a robot of ", robot.joint_count, " joints, ",
                 robot.link_count, " links with ", triangles, " triangles, ", robot.pair_count,
                 " pairs of links that can collide"),
          {{"kind", "robot"},
           {"joints", robot.joint_count},
           {"links", robot.link_count},
           {"triangles", triangles},
           {"pairs", robot.pair_count}}};
}

ExitCode check_and_print(const CheckArguments& arguments) {
  Warnings warnings;
  const CheckResult result = is_robot_file_name(arguments.image) ? check_robot(arguments)
                                                                 : check_mesh(arguments, warnings);
  warnings.print();
  if (arguments.json) {
    Json line = {{"image", arguments.image}, {"ok", result.is_equal}};
    line.update(result.facts);
    line["warnings"] = json_of(warnings);
    print_object(line);
  } else {
    std::cout << result.text << "\n";
  }
  return result.is_equal ? kSuccess : kCheckFailed;
}

ExitCode check(const CheckArguments& arguments) {
  try {
    return check_and_print(arguments);
  } catch (const UserError& error) {
    if (arguments.json) {
      print_object({{"image", arguments.image}, {"ok", false}, {"wrong", error.what()}});
    }
    throw;
  }
}

}  // namespace

void add_check(CLI::App& app) {
  auto [command, a] = add_command<CheckArguments>(
      app, "check",
      "Prove that an image of a mesh or a robot is well-formed and, with --mesh, that it is this "
      "mesh.\nPrints what it holds; exits with 1 if it is another mesh.",
      check);
  add_option(command, "IMAGE", a.image, "FILE", "Image (.fbvh, .robot)")->required();
  add_option(command, "--mesh", a.mesh, "FILE", "The mesh file that it was baked from");
  add_unit_option(command, a.units);
  command.add_flag("--json", a.json,
                   "Print one JSON object, of an image that is not well-formed, too");
  add_example(command, "check baked/plate.fbvh --mesh plate.obj",
              "prints whether the image is plate.obj");
}

}  // namespace flashbvh::tool
