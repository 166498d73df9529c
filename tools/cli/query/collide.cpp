// flashbvh collide: runs the firmware's collision query on the desktop.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <tuple>
#include <vector>

#include "cli/query/scene.hpp"
#include "evaluate/needed_work.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

struct CollideArguments : PosedImages {
  std::string pairs;
  bool first = false;
  bool bound = false;
  bool json = false;
};

Json json_of(std::size_t pose, const std::string& algorithm, const Answer& answer) {
  Json line = {{"pose", pose}, {"intersects", answer.counts.triangle_pairs != 0}};
  if (answer.inside) {
    line["inside"] = *answer.inside;
  }
  line.update({{"algorithm", algorithm},
               {"visits", answer.counts.visits},
               {"overlaps", answer.counts.overlaps},
               {"leaf_pairs", answer.counts.leaf_pairs},
               {"triangle_pairs", answer.counts.triangle_pairs},
               {"status", "ok"}});
  return line;
}

std::string verdict_of(const Json& line) {
  return line["intersects"] ? "intersect" : line.value("inside", false) ? "inside" : "free";
}

/// The verdict of a single pose; for several poses, how many intersect.
std::string verdict_of_all(const Json& lines) {
  if (lines.size() == 1) {
    return verdict_of(lines[0]);
  }
  const auto count_of = [&](const char* verdict) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const Json& line) { return verdict_of(line) == verdict; });
  };
  const auto inside = count_of("inside");
  return concat(count_of("intersect"), " of ", lines.size(), " poses intersect",
                inside == 0 ? "" : concat(", one mesh is inside the other in ", inside));
}

/// A line per pair, by poses and triangle numbers.
std::string pair_lines(std::vector<Answer> found) {
  std::string text;
  for (std::size_t pose = 0; pose < found.size(); ++pose) {
    std::vector<FoundPair>& pairs = found[pose].pairs;
    std::sort(pairs.begin(), pairs.end(), [](const FoundPair& p, const FoundPair& q) {
      return std::tie(p.a, p.b) < std::tie(q.a, q.b);
    });
    for (const auto& [a, b] : pairs) {
      text += concat(pose, " ", a, " ", b, "\n");
    }
  }
  return text;
}

/// The maximum of all poses, the terms of a run's time bound (lib/docs/bounded_time.md), and the
/// work of the given poses, if any.
Json bound_json(const Scene& scene, const std::string& algorithm,
                const std::vector<Answer>& answers) {
  const VisitBound bound = visit_bound(scene.a.tree(), scene.b.tree());
  const ImageHeader& a = scene.a.header();
  const ImageHeader& b = scene.b.header();
  const auto later = [](const ImageHeader& header) {
    return header.arity == 0 ? 0u : header.arity - 1u;
  };
  Json line = {{"algorithm", algorithm},
               {"most_work", bound.work},
               {"most_visits", bound.visits},
               {"most_leaf_pairs", bound.leaf_pairs},
               {"most_triangle_pairs", bound.triangle_pairs},
               {"depths", a.depth + b.depth},
               {"later_siblings", later(a) + later(b)},
               {"leaf_size", std::max(a.leaf_size, b.leaf_size)}};
  if (!answers.empty()) {
    std::vector<std::uint64_t> work;
    work.reserve(answers.size());
    for (const Answer& answer : answers) {
      work.push_back(answer.work);
    }
    const NeededWork needed = needed_work(work);
    line.update({{"poses", work.size()},
                 {"poses_most_work", needed.most},
                 {"poses_99_percent_work", needed.percentile_99},
                 {"poses_mean_work", std::llround(needed.mean)}});
  }
  return line;
}

void print_bound(const Json& bound, const std::string& names) {
  std::cout << names << ", " << bound["algorithm"].get<std::string>() << "\nany pose: at most "
            << bound["most_work"] << " work: " << bound["most_visits"] << " visits, of which "
            << bound["most_leaf_pairs"] << " pairs of leaves, where "
            << bound["most_triangle_pairs"] << " pairs of triangles are tested\n";
  if (bound.contains("poses")) {
    std::cout << bound["poses"] << (bound["poses"] == 1 ? " pose: at most " : " poses: at most ")
              << bound["poses_most_work"] << " work, 99 % of them at most "
              << bound["poses_99_percent_work"] << ", the mean " << bound["poses_mean_work"]
              << "\n";
  }
  std::cout << "depths " << bound["depths"] << ", later siblings " << bound["later_siblings"]
            << ", triangles a leaf at most " << bound["leaf_size"] << "\n";
}

/// The answers for all poses, in order.
std::vector<Answer> answers_of(const CollideArguments& arguments, const Scene& scene) {
  std::vector<Answer> found;
  if (arguments.poses.empty()) {
    return found;
  }
  for (const Pose& pose : scene.poses(arguments)) {
    found.push_back(collide(scene.a.tree(), scene.b.tree(), pose, arguments.first));
    Answer& answer = found.back();
    check_answered(answer, arguments.poses, found.size() - 1);
    if (answer.counts.triangle_pairs == 0 && !arguments.bound) {
      answer.inside = one_is_inside(scene.a, scene.b, pose);
    }
    if (arguments.pairs.empty()) {
      answer.pairs = {};  // may be many
    }
  }
  return found;
}

void print_collisions(const CollideArguments& arguments, const Scene& scene,
                      const std::string& algorithm, const std::vector<Answer>& found) {
  Json lines = Json::array();
  for (const Answer& answer : found) {
    lines.push_back(json_of(lines.size(), algorithm, answer));
  }
  print_answers(arguments.json, lines,
                concat(scene.names(), ", ", algorithm, ": ", verdict_of_all(lines)),
                {number_column("pose", "pose"),
                 {"verdict", verdict_of},
                 number_column("visits", "visits"),
                 number_column("overlaps", "overlaps"),
                 number_column("leaf pairs", "leaf_pairs"),
                 number_column("triangle pairs", "triangle_pairs")});
}

void collide_all(const CollideArguments& arguments) {
  if (!arguments.bound && arguments.poses.empty()) {
    throw CLI::RequiredError("--poses or --bound");
  }
  check_output(arguments.pairs, {arguments.poses});
  const Scene scene(arguments);
  const std::string algorithm = traversal_of(scene.a.layout());
  const std::vector<Answer> found = answers_of(arguments, scene);
  if (arguments.bound) {
    const Json bound = bound_json(scene, algorithm, found);
    arguments.json ? print_object(bound) : print_bound(bound, scene.names());
    return;
  }
  FileSet files;
  if (!arguments.pairs.empty()) {
    files.add(arguments.pairs, pair_lines(found));
  }
  files.write([&] { print_collisions(arguments, scene, algorithm, found); });
}

}  // namespace

void add_collide(CLI::App& app) {
  auto [command, a] =
      add_command<CollideArguments>(app, "collide",
                                    "Find the triangles of A that intersect triangles of B, by the "
                                    "firmware's own code. Prints of "
                                    "each pose:\nintersect; inside, if the one closed mesh lies in "
                                    "the other; or free. Insides of "
                                    "pre-indexed\nimages are not tested.",
                                    collide_all);
  (void)add_posed_images(command, a);
  CLI::Option* const first =
      command.add_flag("--first", a.first, "Stop at the first pair of triangles");
  CLI::Option* const pairs =
      add_option(command, "--pairs", a.pairs, "FILE", "Write `pose a b` for each pair, sorted");
  command.add_flag("--json", a.json, "One JSON object a pose");
  command
      .add_flag("--bound", a.bound,
                "Print the work that no pose exceeds, instead, and what the given poses needed")
      ->excludes(first, pairs);
  add_example(command, "collide baked/plate.fbvh baked/peg.fbvh --poses poses.txt",
              "prints a verdict and the work of each pose");
}

}  // namespace flashbvh::tool
