// flashbvh export: writes the lattice mesh as OBJ, for viewers and for programs that check answers.
#include <optional>

#include "cli/commands.hpp"
#include "evaluate/poses.hpp"
#include "image/image_file.hpp"
#include "mesh/units.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct ExportArguments {
  std::string image;
  std::string mesh;
  std::optional<std::string> pose;
  bool cells = false;
  bool floats = false;
};

/// Faces in OBJ. After missing triangles, a comment gives the number of the next triangle.
std::string faces_of(const std::vector<SourceTriangle>& triangles) {
  std::string text;
  std::uint32_t next = 0;
  for (const SourceTriangle& triangle : triangles) {
    if (triangle.number != next) {
      text += concat("# triangle ", triangle.number, "\n");
    }
    next = triangle.number + 1;
    text += "f";
    for (const std::uint32_t vertex : triangle.vertices) {
      text += concat(" ", vertex + 1);
    }
    text += "\n";
  }
  return text;
}

void write_obj(const ExportArguments& arguments) {
  check_output(arguments.mesh, {});
  const ImageFile image(arguments.image);
  const std::vector<SourceTriangle> triangles = source_triangles(image);
  std::vector<LatticePoint> vertices = vertices_of(image.tree());
  if (arguments.pose) {
    vertices = transformed_vertices(
        image.tree(), read_lattice_pose(*arguments.pose, image.cell(), "--pose", arguments.floats));
  }
  const std::string unit = unit_name(image.unit());
  std::string text = arguments.cells ? "# in cells\n"
                     : unit.empty()  ? "# in the mesh's unit\n"
                                     : "# in " + unit + "\n";
  if (!arguments.cells) {
    text += concat("# within ", shortest(image.deviation()), unit.empty() ? "" : " ", unit,
                   " of the file it was baked from\n");
  }
  for (const LatticePoint& v : vertices) {
    text += "v";
    for (const std::int64_t c : v) {
      text += " " + (arguments.cells ? std::to_string(c)
                                     : shortest(static_cast<double>(c) * image.cell()));
    }
    text += "\n";
  }
  write_file(arguments.mesh, text + faces_of(triangles));
}

}  // namespace

void add_export(CLI::App& app) {
  auto [command, a] = add_command<ExportArguments>(
      app, "export",
      "Write the lattice mesh of an image as OBJ, in its unit, triangles in the "
      "order of the\nsource mesh.",
      write_obj);
  add_option(command, "IMAGE", a.image, "FILE.fbvh", "Image (.fbvh)")->required();
  add_option(command, "-o,--output", a.mesh, "MESH.obj", "File to write")->required();
  command.add_option("--pose", a.pose,
                     "A pose of 12 numbers, as in `collide --poses`: write the mesh where a query "
                     "puts it as B, in A's frame");
  command.add_flag("--float", a.floats,
                   "Take the pose's numbers as 32-bit floats, as firmware's pose_of() does");
  command.add_flag("--cells", a.cells, "Integer coordinates, in cells");
  add_example(command, "export baked/plate.fbvh -o lattice.obj",
              "writes the mesh that firmware queries");
}

}  // namespace flashbvh::tool
