// flashbvh ray: runs the firmware's ray queries on the desktop.
#include <optional>

#include "cli/query/scene.hpp"
#include "flashbvh/ray.hpp"

namespace flashbvh::tool {
namespace {

struct RayArguments {
  std::string image;
  std::string rays;
  bool json = false;
};

using Hit = RayHit<std::uint32_t>;

/// The hits of one ray, for meshes with 16-bit or 32-bit indices.
struct Found {
  Segment segment;
  Status status = Status::done;
  std::optional<Hit> hit;
  std::uint32_t visits = 0;
  std::optional<std::int32_t> outwards;  ///< for a closed mesh
};

template <class MeshType>
Found cast(const MeshType& mesh, const Segment& segment) {
  Found found;
  found.segment = segment;
  const auto nearest = nearest_hit(mesh, segment);
  found.status = nearest.status;
  found.visits = nearest.visits;
  if (nearest.yes) {
    const auto& [triangle, slot, side, along] = nearest.hit;
    found.hit = {triangle, slot, side, along};
  }
  const CrossingCount crossings = signed_crossings(mesh, segment);
  if (crossings.status == Status::done) {
    found.outwards = crossings.outwards;
  }
  return found;
}

Json hit_json(const Segment& segment, const Hit& hit, double cell) {
  return {{"triangle", hit.triangle},
          {"distance", unit_length(distance_along(segment, hit.along), cell)},
          {"point", point_json(point_along(segment, hit.along), cell)},
          {"side", hit.side > 0   ? "front"
                   : hit.side < 0 ? "back"
                                  : "edge"}};
}

Json json_of(std::size_t number, const Found& found, double cell, const std::string& unit) {
  Json line = {{"ray", number}, {"unit", unit}, {"hit", found.hit.has_value()}};
  if (found.hit) {
    line.update(hit_json(found.segment, *found.hit, cell));
  }
  line["visits"] = found.visits;
  if (found.outwards) {
    line["crossings"] = *found.outwards;
  }
  line["status"] = "ok";
  return line;
}

/// A field of the hit, for a table.
Column hit_column(const char* field, const std::string& none) {
  return {field,
          [=](const Json& line) {
            return line["hit"] ? significant(line[field].get<double>(), 6) : none;
          },
          true};
}

void query_rays(const RayArguments& arguments) {
  const ImageFile image(arguments.image);
  const std::string unit = unit_name(image.unit());
  Json lines = Json::array();
  for (const Segment& segment : read_lattice_rays(arguments.rays, image.cell())) {
    const auto found =
        query_post_mesh<Found>(image, [&](const auto& mesh) { return cast(mesh, segment); });
    if (found.status != Status::done) {
      throw UserError(arguments.rays, "ray ", lines.size(),
                      " ends too far off: ", kMaxRayCoordinate, " cells, ",
                      significant(kMaxRayCoordinate * image.cell(), 6),
                      ", from the middle of the mesh's box is the most");
    }
    lines.push_back(json_of(lines.size(), found, image.cell(), unit));
  }
  print_answers(arguments.json, lines,
                image.name() + (unit.empty() ? "" : ", distances in " + unit),
                {number_column("ray", "ray"), hit_column("distance", "none"),
                 hit_column("triangle", ""), number_column("visits", "visits")});
}

}  // namespace

void add_ray(CLI::App& app) {
  auto [command, a] = add_command<RayArguments>(
      app, "ray",
      "Print what rays hit first, how far off, and how often they go out of a closed mesh and in, "
      "by the\nfirmware's own code.",
      query_rays);
  add_option(command, "IMAGE", a.image, "FILE.fbvh", "Image (.fbvh)")->required();
  add_option(command, "--rays", a.rays, "FILE",
             "A ray a line, in the mesh's frame and unit: 6 numbers, from and to, each to the "
             "nearest cell")
      ->required();
  command.add_flag("--json", a.json, "One JSON object a ray");
  add_example(command, "ray baked/plate.fbvh --rays rays.txt", "prints the first hit of each ray");
}

}  // namespace flashbvh::tool
