// flashbvh clearance: runs the firmware's distance queries on the desktop.
#include <iomanip>
#include <iostream>
#include <optional>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "image/image_file.hpp"
#include "mesh/units.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct ClearanceArguments : PosedImages {
  std::string pairs;
  std::optional<double> within;
  bool cold = false;
  bool json = false;
};

void print_json(std::size_t pose, const ClearanceArguments& arguments, const ClearanceAnswer& found,
                double cell, const std::string& unit) {
  Json line = {{"pose", pose}, {"unit", unit}};
  if (arguments.within) {
    line["within"] = !found.nearest.empty();
  } else if (!found.in_range) {
    line.update({{"distance", nullptr}, {"lower", unit_length(found.lower, cell)}});
    line["upper"] = found.upper == UINT32_MAX ? Json() : Json(unit_length(found.upper, cell));
    line.update({{"triangles", nullptr}, {"point_a", nullptr}, {"point_b", nullptr}});
  }
  if (!found.nearest.empty()) {
    const NearestPair& pair = found.nearest[0];
    if (!arguments.within) {  // else this is any near pair's distance, not the meshes'
      line.update({{"distance", pair.distance * cell},
                   {"lower", unit_length(pair.points.lower, cell)},
                   {"upper", unit_length(pair.points.upper, cell)}});
    }
    line.update({{"triangles", {pair.triangles.a, pair.triangles.b}},
                 {"point_a", point_json(pair.points.point_a, cell)},
                 {"point_b", point_json(pair.points.point_b, cell)}});
  }
  line.update({{"visits", found.visits},
               {"triangle_pairs", found.triangle_pairs},
               {"status", found.in_range ? "ok" : "out_of_range"}});
  print_object(line);
}

void print_heading(const std::string& names, bool is_within) {
  std::cout << names << (is_within ? ", within" : ", distance") << "\n"
            << "  pose  " << std::setw(12) << (is_within ? "within" : "distance")
            << "     triangles             visits  triangle pairs\n";
}

void print_row(std::size_t pose, const ClearanceArguments& arguments, const ClearanceAnswer& found,
               double cell, const std::string& unit) {
  std::cout << std::setw(6) << pose << "  " << std::setw(12);
  if (arguments.within) {
    std::cout << (found.nearest.empty() ? "no" : "yes");
  } else {
    const std::string length = found.in_range
                                   ? significant(found.nearest[0].distance * cell, 6)
                                   : ">= " + significant(unit_length(found.lower, cell), 6);
    std::cout << length + (unit.empty() ? "" : " " + unit);
  }
  if (found.nearest.empty()) {
    std::cout << std::setw(17) << (found.in_range ? "" : "out of range");
  } else {
    std::cout << std::setw(8) << found.nearest[0].triangles.a << " " << std::setw(8)
              << found.nearest[0].triangles.b;
  }
  std::cout << std::setw(16) << found.visits << std::setw(16) << found.triangle_pairs << "\n";
}

std::vector<ClearanceAnswer> answers(const ClearanceArguments& arguments, const ImageFile& a,
                                     const ImageFile& b) {
  std::vector<ClearanceAnswer> found;
  Witness<std::uint32_t> hint;
  const FineLength reach =
      arguments.within ? fine_length(*arguments.within, a.cell(), kMaxDistance) : FineLength{0};
  for (const Pose& pose : read_lattice_poses(arguments.poses, a.cell(), arguments.floats)) {
    if (arguments.cold) {
      hint = {};
    }
    found.push_back(arguments.within
                        ? within_distance(a.tree(), b.tree(), pose, reach, !arguments.pairs.empty())
                        : clearance(a.tree(), b.tree(), pose, hint));
    if (found.back().status == Status::distance_out_of_range) {
      throw UserError(arguments.poses, "pose ", found.size() - 1,
                      " puts B so far off that --within is not decidable; use less than ",
                      significant(1e6 * a.cell(), 6));
    }
    if (found.back().status != Status::done) {
      throw UserError(arguments.poses, "pose ", found.size() - 1,
                      " can't be answered: ", status_name(found.back().status));
    }
  }
  return found;
}

void query_distances(const ClearanceArguments& arguments) {
  check_output(arguments.pairs, {arguments.poses});
  const ImageFile a(arguments.a);
  const ImageFile b(arguments.b);
  check_has_clearance(a);
  check_partners(a, b);
  const std::vector<ClearanceAnswer> found = answers(arguments, a, b);
  std::string pairs;
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (const NearestPair& pair : found[i].nearest) {
      pairs += concat(i, " ", pair.triangles.a, " ", pair.triangles.b, "\n");
    }
  }
  FileSet files;
  if (!arguments.pairs.empty()) {
    files.add(arguments.pairs, std::move(pairs));
  }
  files.write([&] {
    if (!arguments.json) {
      print_heading(a.name() + " and " + b.name(), arguments.within.has_value());
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (arguments.json) {
        print_json(i, arguments, found[i], a.cell(), unit_name(a.unit()));
      } else {
        print_row(i, arguments, found[i], a.cell(), unit_name(a.unit()));
      }
    }
    flush_output();
  });
}

}  // namespace

void add_clearance(CLI::App& app) {
  auto [command, a] = add_command<ClearanceArguments>(
      app, "clearance",
      "Print how far A and B are apart, or whether they are within a distance, by the firmware's "
      "own\ncode. Distances are between surfaces: a mesh inside another one is as far as its wall.",
      query_distances);
  add_posed_images(command, a)->required();
  CLI::Option* const within =
      add_option(command, "--within", a.within, "LENGTH",
                 "Print whether any points are at most this far apart, in the images' unit, "
                 "and of which triangles");
  CLI::Option* const pairs =
      add_option(command, "--pairs", a.pairs, "FILE",
                 "Write `pose a b` for each pair of triangles within that distance, sorted");
  pairs->needs(within);
  command
      .add_flag("--cold", a.cold,
                "Begin each pose without a hint, not with what was nearest before")
      ->excludes(within);
  add_float_flag(command, a);
  add_json(command, a.json, "One JSON object a pose");
  add_example(command, "clearance baked/plate.fbvh baked/peg.fbvh --poses poses.txt",
              "prints a distance for each pose");
}

}  // namespace flashbvh::tool
