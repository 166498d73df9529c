// What the library does not prove of an image when it opens it.
#include <algorithm>
#include <variant>

#include "bake/quantise.hpp"
#include "bake/surface.hpp"
#include "cli/mesh/image_facts.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

/// UserError unless the shells that the image stores, and whether they are closed, agree with its
/// triangles. The library does not test the shells, and tests closedness by a sum. `of`: the mesh
/// of the image, for the message.
template <class Tree>
void check_surface(const Tree& tree, const std::string& path, const std::string& of) {
  bake::LatticeMesh mesh;
  mesh.vertices.assign(tree.vertices, tree.vertices + tree.vertex_count);
  for (std::uint32_t i = 0; i < tree.triangle_count; ++i) {
    const auto& corner = tree.triangles[i].corner;
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
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

}  // namespace

void check_whole(const ImageFile& image) {
  (void)source_triangles(image);
  std::visit([&](const auto& tree) { check_surface(tree, image.path(), ""); }, image.tree());
  if (image.header().deviation_sixteenths !=
      bake::sixteenths_above(image.deviation(), image.cell())) {
    throw UserError(image.path(),
                    "is invalid: its deviation in cells is not that in its unit; bake it again");
  }
}

void check_whole(const Robot& robot, const std::string& path) {
  for (std::size_t i = 0; i < robot.link_count; ++i) {
    const Mesh& link = robot.meshes[i];
    check_surface(link, path, concat("of link ", i, ": "));
    if (robot.links[i].deviation + 15 < 16u * link.deviation_sixteenths) {
      throw UserError(path, "is invalid: link ", i,
                      " deviates by less than its mesh; bake it again");
    }
  }
}

}  // namespace flashbvh::tool
