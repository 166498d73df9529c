// flashbvh check: proves that an image is well-formed, and that it is a certain mesh.
//
// An image is a mesh if, rounded with the image's cell, triangle by triangle in the order of the
// file, the mesh has the same corners as the image. The image may lack what `bake --drop` leaves
// out.
#include <iostream>
#include <memory>
#include <set>

#include "bake/quantise.hpp"
#include "bake/surface.hpp"
#include "cli/commands.hpp"
#include "cli/mesh_warnings.hpp"
#include "image/image_file.hpp"
#include "image/output_name.hpp"
#include "mesh/defects.hpp"
#include "mesh/import.hpp"
#include "mesh/units.hpp"
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

/// What an image may lack: triangles that `bake --drop` leaves out.
struct LeftOut {
  std::size_t degenerate = 0;
  std::size_t duplicate = 0;
};

/// Compares an image with a mesh, both in the order of the source.
class Comparison {
 public:
  Comparison(const ImageFile& image, const InputMesh& input)
      : vertices_(vertices_of(image.tree())),
        rounded_(bake::round_to_lattice(input.mesh, image.cell())) {
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

  /// The image's corners may be turned: `bake --deformable` does.
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

/// UserError unless the image says of its shells, and whether they are closed, what its triangles
/// say: the library doesn't look for the one, and tells the other by a sum.
void check_surface(const ImageFile& image, const bake::LatticeMesh& mesh) {
  const bake::Surface surface = bake::surface_of(mesh);
  const bool is_closed = (image.header().flags & kImageIsClosed) != 0;
  const bool same_shells = std::visit(
      [&](const auto& tree) {
        return std::equal(surface.shell_vertices.begin(), surface.shell_vertices.end(),
                          tree.shell_vertices, tree.shell_vertices + tree.shell_count);
      },
      image.tree());
  if (!same_shells || surface.is_closed != is_closed) {
    throw UserError(image.path(), "is invalid: ",
                    same_shells ? "its surface is not closed or open as it says"
                                : "its vertices of shells are not those that its triangles make",
                    "; bake it again");
  }
}

/// What the image's own surface is like.
void warn_of_surface(const ImageFile& image, const bake::LatticeMesh& mesh) {
  MeshDefects defects;
  defects.duplicates = duplicate_triangles(mesh.triangles);
  defects.edges = edge_defects(mesh.triangles, defects.duplicates);
  defects.inside_out = defects.edges.none() && is_inside_out(mesh, defects.duplicates);
  Warnings warnings;
  warn_of_surface(defects, image.path(), warnings);
  warnings.print();
}

struct CheckArguments {
  std::string image;
  std::string mesh;
  std::string body;
  std::vector<std::string> units;
};

/// As `bake` reads it.
InputMesh read_mesh_or_body(const CheckArguments& arguments) {
  const Units units(arguments.units, {arguments.mesh});
  Warnings warnings;
  InputMesh input;
  if (arguments.body.empty()) {
    input = read_mesh(arguments.mesh, units, warnings);
  } else {
    std::vector<InputMesh> bodies = read_bodies(arguments.mesh, units, warnings);
    const std::vector<OutputName> names = body_names(arguments.mesh, bodies);
    std::string known;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (names[i].stem == arguments.body) {
        input = std::move(bodies[i]);
      }
      known += (i == 0 ? "" : ", ") + names[i].stem;
    }
    if (input.mesh.triangles.empty()) {
      throw UserError("--body " + arguments.body, "is none of ", arguments.mesh, "; it has ",
                      known);
    }
  }
  warnings.print();
  return input;
}

/// The mesh against the image: sets the exit code, returns the verdict.
std::string compare(const CheckArguments& arguments, const ImageFile& image,
                    const std::vector<SourceTriangle>& triangles, ExitCode& exit_code) {
  const InputMesh input = read_mesh_or_body(arguments);
  exit_code = kCheckFailed;
  const std::string but_not = ", but not " + input.path + ": ";
  if (!bake::fits(input.mesh, image.cell())) {
    return but_not + "the mesh is too large for the image's cell";
  }
  Comparison comparison(image, input);
  const std::string found = comparison.difference(triangles);
  if (!found.empty()) {
    return but_not + found;
  }
  exit_code = kSuccess;
  const LeftOut& left_out = comparison.left_out();
  if (left_out.degenerate + left_out.duplicate == 0) {
    return ", equal to " + input.path;
  }
  return concat(", equal to ", input.path, " without ", left_out.degenerate, " degenerate and ",
                left_out.duplicate, " duplicate triangles");
}

ExitCode check(const CheckArguments& arguments) {
  const ImageFile image(arguments.image);
  const std::vector<SourceTriangle> triangles = source_triangles(image);
  const bake::LatticeMesh mesh = mesh_of(image, triangles);
  check_surface(image, mesh);
  std::string verdict = concat("well-formed, ", triangles.size(), " triangles, ",
                               image.header().node_count, " nodes");
  ExitCode exit_code = kSuccess;
  if (arguments.mesh.empty() && !arguments.body.empty()) {
    throw UserError("--body " + arguments.body, "names a body of no file; give --mesh, too");
  }
  if (!arguments.mesh.empty()) {
    verdict += compare(arguments, image, triangles, exit_code);
  }
  warn_of_surface(image, mesh);
  std::cout << image.name() << ": " << verdict << "\n";
  return exit_code;
}

}  // namespace

void add_check(CLI::App& app, ExitCode& exit_code) {
  const auto arguments = std::make_shared<CheckArguments>();
  CLI::App* const command = app.add_subcommand(
      "check",
      "Prove that an image is well-formed and, with --mesh, that it is this mesh.\n"
      "Exits with 1 if it is another one.");
  command->add_option("IMAGE", arguments->image, "Image (.fbvh)")->required();
  command->add_option("--mesh", arguments->mesh, "The mesh file that it was baked from");
  command->add_option("--body", arguments->body,
                      "The body of that file alone, as `bake --split` names it");
  add_unit_option(*command, arguments->units);
  command->callback([arguments, &exit_code] { exit_code = check(*arguments); });
}

}  // namespace flashbvh::tool
