#include "cli/robot/baked_robot.hpp"
#include "bake/image_bytes.hpp"
#include "cli/commands.hpp"

#include <algorithm>

#include "cli/progress.hpp"
#include "cli/robot/robot_arguments.hpp"
#include "cli/robot/robot_warnings.hpp"
#include "cli/robot/simplified_links.hpp"
#include "cli/simplify_options.hpp"
#include "flashbvh/clearance.hpp"
#include "image/fine_length.hpp"
#include "robot/baked/robot_image.hpp"
#include "robot/read/urdf.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// The progress weight of baking a link; deciding a pair has weight 1.
constexpr double kBakingWeight = 0.1;

/// Bakes trees for deciding pairs. Their leaves are as large as in firmware's trees, so that a
/// witness is the same pair of triangles.
std::vector<BakedPart> bake_wholes(const Model& model, double cell, const RobotArguments& arguments,
                                   Progress& progress, Warnings& warnings) {
  std::vector<BakedPart> wholes;
  for (const ModelLink& link : model.links) {
    progress.begin("baking " + link.name, kBakingWeight);
    const InputMesh input = link_input(link, arguments.urdf);
    wholes.push_back(bake_part(input, cell, arguments.leaf_size));
    warn_of_precision(input, cell, warnings);
    warn_of_place(wholes.back().origin, input.path, warnings);
  }
  return wholes;
}

/// UserError if firmware cannot hold a link. Takes almost no time unless it refuses.
void check_wholes(const RobotArguments& arguments, const BakedRobot& made) {
  if (arguments.simplify || arguments.fit) {
    return;
  }
  for (std::size_t i = 0; i < made.wholes.size(); ++i) {
    if (!fits_firmware(made.wholes[i])) {
      (void)bake_link(made.model.links[i], made.cell, arguments.leaf_size, arguments.urdf);
    }
  }
}

std::vector<Mesh> meshes_of(const std::vector<BakedLink>& links) {
  std::vector<Mesh> meshes;
  meshes.reserve(links.size());
  for (const BakedLink& link : links) {
    meshes.push_back(link.mesh());
  }
  return meshes;
}

/// The stages' deadlines as parts of the whole time; unused time goes to later stages. Zones get
/// most: without its zone, a joint's links are guarded everywhere.
constexpr double kPartForReaches = 0.1;
constexpr double kPartForZones = 0.6;
constexpr double kPartForPairs = 0.8;
constexpr double kPartForParts = 0.9;
constexpr double kPartForTables = 1;

/// Computes the stages' deadlines.
class StageTimes {
 public:
  explicit StageTimes(const RobotArguments& arguments) {
    if (arguments.time) {
      seconds_ = seconds(*arguments.time);
    }
  }

  Deadline until(double part) const {
    return seconds_ ? in_seconds(began_, part * *seconds_) : Deadline{};
  }

 private:
  Clock::time_point began_ = Clock::now();
  std::optional<double> seconds_;
};

/// All pairs that a joint moves and that may be guarded.
std::vector<GuardedPair> moved_pairs(const Model& model) {
  std::vector<GuardedPair> pairs;
  for (std::size_t a = 0; a < model.links.size(); ++a) {
    for (std::size_t b = a + 1; b < model.links.size(); ++b) {
      const DisabledPair* const disabled = find_pair(model.disabled, a, b);
      if (model.links[a].joint != model.links[b].joint &&
          (disabled == nullptr || !disabled->is_believed)) {
        pairs.push_back({a, b, 0, 0});
      }
    }
  }
  return pairs;
}

/// Proofs include firmware's own kinematics. UserError if firmware cannot hold such a fine robot.
MatrixOptions matrix_options(const Model& model, const std::vector<WholeMesh>& meshes, double cell,
                             const AllDistances& distances, const Reaches& reaches) {
  MatrixOptions options;
  options.stop = distances.usual.stop / cell;
  options.warn = distances.usual.warn / cell;
  for (const GuardedPair& pair : distances.own) {
    options.stops.push_back({pair.a, pair.b, pair.stop / cell, pair.warn / cell});
  }
  const FixedRobot robot(model, meshes, {}, cell, moved_pairs(model), reaches);
  options.slack = std::max(options.slack, kPlacing + robot.robot().slack / double{kFineOne});
  return options;
}

/// UserError, at the option that gives it, if a distance is too large for firmware.
void check_range(double distance, const std::string& place, double cell) {
  const double most = kMaxGuardDistance * cell / kFineOne;
  if (fine_length_rounded_up(distance, cell).count > kMaxGuardDistance) {
    throw UserError(place, "is out of range: 0 to ", significant(most, 6),
                    " m, 32,767 cells; lengths are in metres: ", shortest(distance), " mm is ",
                    shortest(distance / 1000));
  }
}

void check_ranges(const AllDistances& distances, const RobotArguments& arguments, double cell) {
  check_range(distances.usual.stop, "--stop " + arguments.stop, cell);
  check_range(distances.usual.warn, "--warn " + arguments.warn.value_or(arguments.stop), cell);
  for (std::size_t i = 0; i < distances.own.size(); ++i) {
    check_range(distances.own[i].warn, "--pair " + arguments.pairs[i], cell);
  }
}

/// The guarded pairs. Pairs that are always within their warn distance get no warning: neighbours
/// next to their zone, and pairs without distances of their own.
std::vector<GuardedPair> guarded(const std::vector<PairVerdict>& pairs,
                                 const AllDistances& distances) {
  std::vector<GuardedPair> guarded;
  for (const PairVerdict& pair : pairs) {
    if (pair.is_guarded) {
      const auto [stop, warn] = distances_of(distances, pair);
      const bool is_near = pair.is_warned && find_pair(distances.own, pair.a, pair.b) == nullptr;
      for (const auto& [a, b] : pair.bodies) {
        guarded.push_back({a, b, stop, pair.zone || is_near ? stop : warn});
      }
    }
  }
  std::sort(guarded.begin(), guarded.end(), [](const GuardedPair& p, const GuardedPair& q) {
    return std::pair(p.a, p.b) < std::pair(q.a, q.b);
  });
  return guarded;
}

/// Adds a part of a link as another link.
std::size_t add_part(std::size_t of, bake::SourceMesh mesh, const std::string& where,
                     const RobotArguments& arguments, BakedRobot& made) {
  ModelLink part;
  part.name = made.model.links[of].name;
  part.joint = made.model.links[of].joint;
  part.mesh = std::move(mesh);
  part.sources = {concat("outside ", where)};
  part.source_begins = {0};
  part.precision = made.model.links[of].precision;
  made.wholes.push_back(
      bake_part(link_input(part, arguments.urdf), made.cell, arguments.leaf_size));
  made.model.links.push_back(std::move(part));
  made.links_of_parts.push_back(of);
  ++made.model.part_count;
  return made.model.links.size() - 1;
}

/// UserError if the links and their parts are more than firmware holds.
void check_parts(const Model& model, const std::string& path) {
  if (model.links.size() > kMaxLinks) {
    throw UserError(path, "has ", model.links.size() - model.part_count,
                    " links with a <collision> and ", model.part_count,
                    " parts of them to guard next to joint zones, firmware holds ", kMaxLinks,
                    " of both; give more --time, or joints a larger --zone");
  }
}

/// Adds the parts of neighbours that a guard tests.
void add_parts(const RobotArguments& arguments, BakedRobot& made) {
  std::vector<std::vector<ZoneParts>> parts(made.pairs.size());
  for_each_in_parallel(parts.size(), [&](std::size_t i) {
    const PairVerdict& pair = made.pairs[i];
    if (pair.zone && pair.is_guarded) {
      parts[i] = zone_parts(made.model, made.zones[*pair.zone], made.cell, made.options);
    }
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PairVerdict& pair = made.pairs[i];
    if (!pair.zone || !pair.is_guarded) {
      continue;
    }
    if (parts[i].empty()) {
      pair.is_guarded = false;
      pair.is_stopped = false;
      pair.verdict = MatrixVerdict::never;
      pair.reason += "; proven by triangles";
    }
    const std::string where = zone_text(made.model, made.zones[*pair.zone]);
    pair.bodies.clear();
    for (ZoneParts& part : parts[i]) {
      const std::size_t a = add_part(pair.a, std::move(part.a), where, arguments, made);
      pair.bodies.emplace_back(a, add_part(pair.b, std::move(part.b), where, arguments, made));
    }
  }
  made.sizes = link_sizes(made.model);
  check_parts(made.model, arguments.urdf);
}

/// Adds the reaches of the parts; none exceeds its whole link's.
void add_reaches(BakedRobot& made) {
  const std::size_t first = made.reaches.size();
  made.reaches.resize(made.model.links.size());
  for_each_in_parallel(made.reaches.size() - first, [&](std::size_t i) {
    std::vector<double>& reaches = made.reaches[first + i];
    reaches = reaches_of(made.model, first + i, made.cell, made.options.deadline);
    const std::vector<double>& whole = made.reaches[made.links_of_parts[i]];
    std::transform(reaches.begin(), reaches.end(), whole.begin(), reaches.begin(),
                   [](double part, double all) { return std::min(part, all); });
  });
}

void check_simplifying(const Model& model, const RobotArguments& arguments) {
  check_simplify_or_fit(arguments.simplify.has_value(), arguments.fit.has_value());
  for (const ModelLink& link : model.links) {
    if (!arguments.simplify && !arguments.fit) {
      check_triangles(link, robot_cell(model, given_cell(arguments), arguments.urdf),
                      arguments.urdf);
    }
  }
}

/// Warns if parts next to joint zones took so much flash that simplifying exceeds the zones' limit.
void warn_of_fit(const SimplifiedLinks& simplified, const RobotArguments& arguments,
                 Warnings& warnings) {
  if (simplified.exceeds_expected()) {
    warnings.add("--fit " + *arguments.fit,
                 concat("takes --simplify ", shortest(simplified.length()),
                        ", more than joint zones were chosen for; give that in its place, or a "
                        "guard may stop next to zones"));
  }
}

/// UserError if a guard's slack cannot hold the links' deviations twice. `slack`: of the robot with
/// all triangles, in cells.
void check_slack_for_simplify(double slack, double cell, const RobotArguments& arguments) {
  constexpr double kLess = 0.99;  // so that rounding to three digits does not exceed it
  const double most = (kMaxGuardDistance / double{kFineOne} - slack) * cell / 2;
  if (arguments.simplify && simplify_length(arguments) > most) {
    throw UserError("--simplify " + *arguments.simplify,
                    "is out of range: a guard would stop this robot wherever it is; give ",
                    significant(kLess * most, 3), " or less");
  }
}

double steps_of(const Model& model) {
  const auto count = static_cast<double>(model.links.size());
  return kBakingWeight * (count + 1) + count * (count - 1) / 2;
}

/// A robot without any decisions.
BakedRobot prepared(Model model, const AllDistances& distances, const RobotArguments& arguments,
                    Progress& progress, Warnings& warnings) {
  BakedRobot made;
  made.model = std::move(model);
  made.cell = robot_cell(made.model, given_cell(arguments), arguments.urdf);
  (void)zone_radii(made.model, arguments.zones, made.cell);
  check_ranges(distances, arguments, made.cell);
  made.sizes = link_sizes(made.model);
  warn_of_sizes(made.model, made.sizes, arguments.urdf, warnings);
  warn_of_cell(made.model, made.sizes, made.cell, least_stop(distances), arguments, warnings);
  made.wholes = bake_wholes(made.model, made.cell, arguments, progress, warnings);
  return made;
}

/// Decides zones and pairs; bakes no trees for firmware. `early`: how much earlier than requested a
/// guard may stop, in metres.
void decide(const AllDistances& distances, const RobotArguments& arguments, const StageTimes& times,
            double early, Progress& progress, BakedRobot& made) {
  const ZoneRadii radii = zone_radii(made.model, arguments.zones, made.cell);
  const std::vector<WholeMesh> meshes = views_of(made.wholes);
  made.reaches = all_reaches(made.model, made.cell, times.until(kPartForReaches));
  made.options = matrix_options(made.model, meshes, made.cell, distances, made.reaches);
  check_slack_for_simplify(made.options.slack, made.cell, arguments);
  made.options.early = early / made.cell;
  progress.begin("joint zones", kBakingWeight);
  made.options.deadline = times.until(kPartForZones);
  FoundZones found = joint_zones(made.model, meshes, made.cell, made.options, radii);
  made.zones = std::move(found.zones);
  made.late_joints = std::move(found.late_joints);
  made.options.deadline = times.until(kPartForPairs);
  made.pairs = decide_pairs(made.model, meshes, made.zones, made.reaches, made.cell, made.options,
                            [&](std::size_t pair, std::size_t pairs) {
                              progress.begin(concat("pair ", pair, " of ", pairs), 1);
                            });
  made.options.deadline = times.until(kPartForParts);
  made.deadline = times.until(kPartForTables);
}

/// Bakes firmware's links and tables, once all pairs are decided.
void bake_for_firmware(const AllDistances& distances, SimplifiedLinks& simplified,
                       BakedRobot& made) {
  const std::vector<GuardedPair> pairs = guarded(made.pairs, distances);
  const std::vector<WholeMesh> wholes = views_of(made.wholes);
  {
    const FixedRobot bare(made.model, wholes, {}, made.cell, pairs, made.reaches);
    made.own_bytes = own_image_bytes(made.model, bare.robot(), made.unguarded, made.model.name);
  }
  made.links = simplified.baked(made.model, made.own_bytes);
  made.simplified = simplified.length();
  made.leaf_size = simplified.leaf_size();
  std::vector<double> deviations;
  for (std::size_t i = 0; i < made.links.size(); ++i) {
    deviations.push_back(made.links[i].tree.deviation);
  }
  made.fixed = std::make_unique<FixedRobot>(made.model, wholes, meshes_of(made.links), made.cell,
                                            pairs, made.reaches, deviations);
}

}  // namespace

std::vector<std::uint32_t> image_of(const BakedRobot& robot, const std::string& name) {
  if (robot.file) {
    return robot.file->words();
  }
  std::vector<std::vector<std::uint32_t>> meshes;
  for (const BakedLink& link : robot.links) {
    meshes.push_back(bake::image_of(link.tree));
  }
  return robot_image(robot.model, robot.robot(), robot.unguarded, meshes, name);
}

Model described_robot(const RobotArguments& arguments, Warnings& warnings) {
  (void)usual_distances(arguments);
  Model model = read_urdf(arguments.urdf, packages_of(arguments.packages), arguments.srdf, warnings,
                          arguments.visual_too);
  check_counts(model, arguments.urdf);
  for (const std::string& names : arguments.believed) {
    const std::string place = "--believe " + names;
    const auto [a, b] = links_of(model, place, names);
    believe(a, b, place, model);
  }
  return model;
}

BakedRobot decided_robot(Model model, const RobotArguments& arguments, Warnings& warnings) {
  const AllDistances distances = all_distances(model, arguments);
  Progress progress(steps_of(model), arguments.progress);
  const StageTimes times(arguments);
  BakedRobot made = prepared(std::move(model), distances, arguments, progress, warnings);
  decide(distances, arguments, times, 0, progress, made);
  warn_of_late_zones(made, arguments.urdf, "undecided", warnings);
  return made;
}

BakedRobot baked_robot(Model model, const RobotArguments& arguments, Warnings& warnings) {
  const AllDistances distances = all_distances(model, arguments);
  Progress progress(steps_of(model), arguments.progress);
  const StageTimes times(arguments);
  // Requests that no work can meet are refused before any work.
  check_simplifying(model, arguments);
  BakedRobot made = prepared(std::move(model), distances, arguments, progress, warnings);
  check_image(made.model, made.model.name, made.cell);
  check_wholes(arguments, made);
  // Zones and pairs depend on how much earlier a guard of simplified links stops.
  SimplifiedLinks simplified(made.model, made.cell, arguments);
  decide(distances, arguments, times, simplified.early(), progress, made);
  warn_of_late_zones(made, arguments.urdf, "guarded all over, and a guard would always say stop",
                     warnings);
  // Before parts: an SRDF names links, and it is refused by verdicts alone.
  check_disabled(made.model, made.pairs, arguments.srdf, warnings);
  add_parts(arguments, made);
  add_reaches(made);
  // After parts: a pair whose parts never come near needs no guard and no warning.
  made.unguarded = unguarded_pairs(made.pairs, made.zones);
  warn_of_unguarded(made, arguments.urdf, warnings);
  warn_of_fixed(made, distances, arguments.urdf, warnings);
  warn_of_near(made, distances, arguments, warnings);
  bake_for_firmware(distances, simplified, made);
  warn_of_fit(simplified, arguments, warnings);
  // Last: tables hold distances between firmware's meshes.
  progress.begin("distance tables", 0);
  made.fixed->set_distance_tables(distance_tables_of(made.model, made.robot(), made.deadline));
  return made;
}

}  // namespace flashbvh::tool
