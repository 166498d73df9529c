// flashbvh check: proves that an image is well-formed, and that it represents a given mesh.
//
// An image represents a mesh if both have the same corners, triangle by triangle in the file's
// order, after rounding with the image's cell. The image may omit triangles that `bake --drop`
// leaves out.
#include <iostream>
#include <set>

#include "bake/quantise.hpp"
#include "bake/surface.hpp"
#include "cli/commands.hpp"
#include "cli/json.hpp"
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

LatticePoint point_of(const bake::LatticeMesh& mesh, std::uint32_t vertex) {
  const Vertex& v = mesh.vertices[vertex];
  return {std::int64_t{v.x} + mesh.origin[0], std::int64_t{v.y} + mesh.origin[1],
          std::int64_t{v.z} + mesh.origin[2]};
}

/// Counts of missing triangles, as `bake --drop` leaves them out.
struct LeftOut {
  std::size_t degenerate = 0;
  std::size_t duplicate = 0;
};

/// Compares an image with a mesh, both in the source's order of triangles.
class Comparison {
 public:
  Comparison(const ImageFile& image, const InputMesh& input)
      : vertices_(vertices_of(image.tree())),
        rounded_(bake::round_to_lattice(input.mesh, input.extent, image.cell()).mesh) {
    const MeshDefects defects = defects_of(input.mesh, rounded_, input.degenerate);
    for (const TriangleIds& numbers : {defects.degenerate, defects.collapsed}) {
      degenerate_.insert(numbers.begin(), numbers.end());
    }
    duplicates_.insert(defects.duplicates.begin(), defects.duplicates.end());
  }

  /// The first difference; empty if there is none.
  std::string difference(const std::vector<SourceTriangle>& triangles) {
    const std::size_t count = rounded_.triangles.size();
    auto at = triangles.begin();
    for (std::uint32_t number = 0; number < count; ++number) {
      if (at == triangles.end() || at->number != number) {
        if (!may_lack(number)) {
          return concat("the image lacks triangle ", number);
        }
        continue;
      }
      std::string moved = difference(*at++);
      if (!moved.empty()) {
        return moved;
      }
    }
    return at == triangles.end()
               ? ""
               : concat("the image has a triangle ", at->number, ", the mesh only ", count);
  }

  const LeftOut& left_out() const { return left_out_; }

 private:
  bool may_lack(std::uint32_t triangle) {
    if (degenerate_.count(triangle) != 0) {
      ++left_out_.degenerate;
      return true;
    }
    left_out_.duplicate += duplicates_.count(triangle);
    return duplicates_.count(triangle) != 0;
  }

  /// Allows rotated corners, since `bake --deformable` rotates them.
  std::string difference(const SourceTriangle& triangle) const {
    std::string first;
    for (std::size_t turns = 0; turns < 3; ++turns) {
      const std::string turned = difference(triangle, turns);
      if (turned.empty()) {
        return "";
      }
      first = turns == 0 ? turned : first;
    }
    return first;
  }
  std::string difference(const SourceTriangle& triangle, std::size_t turns) const {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const LatticePoint& found = vertices_[triangle.vertices[(corner + turns) % 3]];
      const LatticePoint wanted = point_of(rounded_, rounded_.triangles[triangle.number][corner]);
      if (found != wanted) {
        return concat("corner ", corner, " of triangle ", triangle.number, " lies at ",
                      text_of(found), " in the image, at ", text_of(wanted), " in the mesh");
      }
    }
    return {};
  }

  std::vector<LatticePoint> vertices_;
  bake::LatticeMesh rounded_;
  std::set<std::uint32_t> degenerate_;
  std::set<std::uint32_t> duplicates_;
  LeftOut left_out_;
};

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

/// Warns of defects of the image's own surface.
void warn_of_surface(const ImageFile& image, const bake::LatticeMesh& mesh, Warnings& warnings) {
  MeshDefects defects;
  defects.duplicates = duplicate_triangles(mesh.triangles);
  defects.edges = edge_defects(mesh.triangles, defects.duplicates);
  set_orientation(mesh, defects);
  warn_of_surface(defects, image.path(), warnings);
}

struct CheckArguments {
  std::string image;
  std::string mesh;
  std::vector<std::string> units;
  bool json = false;
};

/// The results for a well-formed image.
struct CheckResult {
  std::string name;
  std::string text;  ///< without the name
  ExitCode exit_code = kSuccess;
};

/// Adds the result of comparing the mesh with the image.
void compare(const CheckArguments& arguments, const ImageFile& image,
             const std::vector<SourceTriangle>& triangles, CheckResult& result, Json& facts,
             Warnings& warnings) {
  const InputMesh input =
      read_mesh(arguments.mesh, Units(arguments.units, {arguments.mesh}), warnings);
  const bool is_small = bake::fits(input.extent, image.cell());
  std::string difference = "the mesh is too large for the image's cell";
  LeftOut left_out;
  if (is_small) {
    Comparison comparison(image, input);
    difference = comparison.difference(triangles);
    left_out = comparison.left_out();
  }
  facts.update({{"mesh", input.path}, {"equal", difference.empty()}});
  if (!difference.empty()) {
    result.exit_code = kCheckFailed;
    result.text += ", but not " + input.path + ": " + difference;
    facts["difference"] = difference;
    return;
  }
  facts.update(
      {{"left_out_degenerate", left_out.degenerate}, {"left_out_duplicate", left_out.duplicate}});
  result.text += ", equal to " + input.path;
  if (left_out.degenerate + left_out.duplicate != 0) {
    result.text += concat(" without ", left_out.degenerate, " degenerate and ", left_out.duplicate,
                          " duplicate triangles");
  }
}

/// Checks an image of a mesh; adds its properties to `facts`.
CheckResult check_mesh(const CheckArguments& arguments, Json& facts, Warnings& warnings) {
  const ImageFile image(arguments.image);
  const std::vector<SourceTriangle> triangles = source_triangles(image);
  const bake::LatticeMesh mesh = mesh_of(image, triangles);
  std::visit([&](const auto& tree) { check_surface(tree, mesh, image.path(), ""); }, image.tree());
  check_deviation(image);
  CheckResult result;
  result.name = image.name();
  result.text = concat("well-formed, ", triangles.size(), " triangles, ", image.header().node_count,
                       " nodes");
  facts = {{"kind", "mesh"}, {"triangles", triangles.size()}, {"nodes", image.header().node_count}};
  if (!arguments.mesh.empty()) {
    compare(arguments, image, triangles, result, facts, warnings);
  }
  warn_of_surface(image, mesh, warnings);
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

/// Checks an image of a robot; adds its properties to `facts`.
CheckResult check_robot(const CheckArguments& arguments, Json& facts) {
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
  CheckResult result;
  result.name = file.name();
  result.text = concat("well-formed, a robot of ", robot.joint_count, " joints, ", robot.link_count,
                       " links with ", triangles, " triangles, ", robot.pair_count,
                       " pairs of links that can collide");
  facts = {{"kind", "robot"},
           {"joints", robot.joint_count},
           {"links", robot.link_count},
           {"triangles", triangles},
           {"pairs", robot.pair_count}};
  return result;
}

ExitCode check_and_print(const CheckArguments& arguments) {
  Warnings warnings;
  Json facts;
  const CheckResult result = is_robot_file_name(arguments.image)
                                 ? check_robot(arguments, facts)
                                 : check_mesh(arguments, facts, warnings);
  warnings.print();
  if (!arguments.json) {
    std::cout << result.name << ": " << result.text << "\n";
    return result.exit_code;
  }
  Json line = {{"image", arguments.image}, {"ok", result.exit_code == kSuccess}};
  line.update(facts);
  line["warnings"] = json_of(warnings);
  print_object(line);
  return result.exit_code;
}

ExitCode check(const CheckArguments& arguments) {
  try {
    return check_and_print(arguments);
  } catch (const UserError& error) {
    if (arguments.json) {
      const Json line = {{"image", arguments.image}, {"ok", false}, {"wrong", error.what()}};
      print_object(line);
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
  add_image(command, a.image, "FILE", "Image (.fbvh, .robot)");
  add_option(command, "--mesh", a.mesh, "FILE", "The mesh file that it was baked from");
  add_unit_option(command, a.units);
  add_json(command, a.json, "Print one JSON object, of an image that is not well-formed, too");
  add_example(command, "check baked/plate.fbvh --mesh plate.obj",
              "prints whether the image is plate.obj");
}

}  // namespace flashbvh::tool
