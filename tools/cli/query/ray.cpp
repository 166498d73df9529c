// flashbvh ray: runs the firmware's ray queries on the desktop.
#include <algorithm>
#include <optional>

#include "cli/query/scene.hpp"
#include "flashbvh/ray.hpp"

namespace flashbvh::tool {
namespace {

struct RayArguments {
  std::string image;
  std::string rays;
  bool all = false;
  bool json = false;
};

using Hit = RayHit<std::uint32_t>;

/// The hits of one ray, for meshes with 16-bit or 32-bit indices.
struct Found {
  Segment segment;
  Status status = Status::done;
  std::vector<Hit> hits;  ///< the nearest, or all in order along the ray
  std::uint32_t visits = 0;
  std::optional<std::int32_t> outwards;  ///< for a closed mesh
};

template <class Index>
Hit widened(const RayHit<Index>& hit) {
  return {hit.triangle, hit.slot, hit.side, hit.along};
}

bool is_before(const Hit& x, const Hit& y) {
  const int order = order_along(x.along, y.along);
  return order < 0 || (order == 0 && x.triangle < y.triangle);
}

template <class MeshType>
Found cast(const MeshType& mesh, const Segment& segment, bool all) {
  Found found;
  found.segment = segment;
  const auto nearest = nearest_hit(mesh, segment);
  found.status = nearest.status;
  found.visits = nearest.visits;
  if (all) {
    (void)for_each_hit(mesh, segment, [&found](const auto& hit) {
      found.hits.push_back(widened(hit));
      return true;
    });
    std::sort(found.hits.begin(), found.hits.end(), is_before);
  } else if (nearest.yes) {
    found.hits.push_back(widened(nearest.hit));
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

Json json_of(std::size_t number, bool all, const Found& found, double cell,
             const std::string& unit) {
  Json line = {{"ray", number}, {"unit", unit}, {"hit", !found.hits.empty()}};
  if (all) {
    line["hits"] = Json::array();
    for (const Hit& hit : found.hits) {
      line["hits"].push_back(hit_json(found.segment, hit, cell));
    }
  } else if (!found.hits.empty()) {
    line.update(hit_json(found.segment, found.hits[0], cell));
  }
  line["visits"] = found.visits;
  if (found.outwards) {
    line["crossings"] = *found.outwards;
  }
  line["status"] = "ok";
  return line;
}

/// A row for each hit, and for each ray that has none.
Json rows_of(const Json& lines) {
  Json rows = Json::array();
  for (const Json& line : lines) {
    const Json none = {{"distance", "none"}, {"triangle", ""}};
    for (const Json& hit : line.value("hits", Json::array({line["hit"] ? line : none}))) {
      rows.push_back(hit);
      rows.back().update({{"ray", line["ray"]}, {"visits", line["visits"]}});
    }
  }
  return rows;
}

void query_rays(const RayArguments& arguments) {
  const ImageFile image(arguments.image);
  const std::string unit = unit_name(image.unit());
  Json lines = Json::array();
  for (const Segment& segment : read_lattice_rays(arguments.rays, image.cell())) {
    const auto found = query_post_mesh<Found>(
        image, [&](const auto& mesh) { return cast(mesh, segment, arguments.all); });
    if (found.status != Status::done) {
      throw UserError(arguments.rays, "ray ", lines.size(),
                      " ends too far off: ", kMaxRayCoordinate, " cells, ",
                      significant(kMaxRayCoordinate * image.cell(), 6),
                      ", from the middle of the mesh's box is the most");
    }
    lines.push_back(json_of(lines.size(), arguments.all, found, image.cell(), unit));
  }
  print_answers(arguments.json, arguments.json ? lines : rows_of(lines),
                image.name() + (unit.empty() ? "" : ", distances in " + unit),
                {number_column("ray", "ray"), number_column("distance", "distance"),
                 number_column("triangle", "triangle"), number_column("visits", "visits")});
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
             "nearest cell; or 7: origin, direction, reach")
      ->required();
  command.add_flag("--all", a.all, "All hits of each ray, nearest first");
  command.add_flag("--json", a.json, "One JSON object a ray");
  add_example(command, "ray baked/plate.fbvh --rays rays.txt", "prints the first hit of each ray");
}

}  // namespace flashbvh::tool
