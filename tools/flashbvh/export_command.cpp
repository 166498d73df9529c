// flashbvh export: the lattice mesh as OBJ, for other programs to look at and to check answers by.
#include <memory>
#include <optional>

#include "flashbvh/commands.hpp"
#include "flashbvh/files.hpp"
#include "flashbvh/image_file.hpp"
#include "flashbvh/lattice_pose.hpp"
#include "flashbvh/user_error.hpp"

namespace flashbvh::tool {
namespace {

struct Arguments {
  std::string image;
  std::string mesh;
  std::optional<std::string> placed;
};

/// The image's vertices, in its order, as the query places them.
std::vector<LatticePoint> vertices_of(const AnyTree& any, const std::optional<Pose>& pose) {
  return std::visit(
      [&](const auto& tree) {
        std::vector<LatticePoint> vertices;
        for (std::uint32_t i = 0; i < tree.vertex_count; ++i) {
          const Vertex& v = tree.vertices[i];
          const LatticePoint point = {std::int64_t{v.x} + tree.origin[0],
                                      std::int64_t{v.y} + tree.origin[1],
                                      std::int64_t{v.z} + tree.origin[2]};
          vertices.push_back(pose ? placed(point, *pose) : point);
        }
        return vertices;
      },
      any);
}

/// Vertex numbers from 0, triangles in source order.
std::vector<std::array<std::uint32_t, 3>> corners_of(const AnyTree& any) {
  return std::visit(
      [](const auto& tree) {
        std::vector<std::array<std::uint32_t, 3>> corners(tree.triangle_count);
        for (std::uint32_t i = 0; i < tree.triangle_count; ++i) {
          const auto& triangle = tree.triangles[i].corner;
          corners[tree.sources[i]] = {triangle[0], triangle[1], triangle[2]};
        }
        return corners;
      },
      any);
}

void write_obj(const Arguments& arguments) {
  const ImageFile image(arguments.image);
  source_triangles(image);  // refuses triangle numbers that are not each there once
  std::optional<Pose> pose;
  if (arguments.placed) {
    pose = lattice_pose(parse_pose(*arguments.placed, "--placed"), image.cell(), "--placed");
  }
  std::string text = "# integer coordinates: cells\n";
  for (const LatticePoint& v : vertices_of(image.tree(), pose)) {
    text += "v " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) +
            "\n";
  }
  for (const auto& corners : corners_of(image.tree())) {
    text += "f " + std::to_string(corners[0] + 1) + " " + std::to_string(corners[1] + 1) + " " +
            std::to_string(corners[2] + 1) + "\n";
  }
  write_file(arguments.mesh, std::move(text));
}

}  // namespace

void add_export(CLI::App& app) {
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* const command = app.add_subcommand(
      "export",
      "Write the lattice mesh of an image as OBJ: integer coordinates in cells, triangles "
      "in\nthe order of the source mesh.");
  command->add_option("IMAGE", arguments->image, "Image (.fbvh)")->required();
  command->add_option("-o,--output", arguments->mesh, "File to write")
      ->required()
      ->type_name("MESH.obj");
  command->add_option("--placed", arguments->placed,
                      "A pose of 12 numbers in the mesh's unit: write the mesh where a query puts "
                      "it as B, in A's frame");
  command->callback([arguments] { write_obj(*arguments); });
}

}  // namespace flashbvh::tool
