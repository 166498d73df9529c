// flashbvh collide: runs the firmware's collision query on the desktop.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "evaluate/needed_work.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "flashbvh/solid.hpp"
#include "image/image_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

// Work and instructions of queries at the given poses.

/// Mean, 99th percentile and maximum.
using Three = std::array<std::uint64_t, 3>;

/// most_instructions() for any amount of work.
std::uint64_t instructions_of(const RunCosts& costs, const TreeSize& a, const TreeSize& b,
                              std::uint64_t work) {
  return instructions_of_start(costs, a, b) +
         (work + largest_step(a, b) - 1) * instructions_of_work(costs, a, b);
}

Json json_of(const Three& numbers) {
  return {{"mean", numbers[0]}, {"percentile_99", numbers[1]}, {"most", numbers[2]}};
}

void print_row(const std::string& label, const Three& numbers) {
  std::cout << std::left << std::setw(12) << label << std::right;
  for (const std::uint64_t number : numbers) {
    std::cout << std::setw(16) << number;
  }
  std::cout << "\n";
}

/// Prints mean, 99th percentile and maximum of the poses' work, and each core's upper limit of
/// instructions, which is proven only for `ranked`. `work`: one per pose, not empty.
void print_summary(const ImageFile& a, const ImageFile& b, const std::string& algorithm,
                   const std::vector<std::uint64_t>& work, bool json) {
  const NeededWork needed = needed_work(work);
  const Three of_work = {static_cast<std::uint64_t>(std::llround(needed.mean)),
                         needed.percentile_99, needed.most};
  const TreeSize size_a = tree_size(a.header());
  const TreeSize size_b = tree_size(b.header());
  Json line = {{"poses", work.size()}, {"algorithm", algorithm}, {"work", json_of(of_work)}};
  if (!json) {
    std::cout << a.name() << " and " << b.name() << ", " << algorithm << ", " << work.size()
              << (work.size() == 1 ? " pose\n" : " poses\n")
              << "                        mean            99 %            most\n";
    print_row("work", of_work);
  }
  if (algorithm == "ranked") {
    if (!json) {
      std::cout << "instructions at most, all of a query in one run, GCC 12 at -O2\n";
    }
    for (const Core& core : kCores) {
      Three instructions{};
      for (std::size_t i = 0; i < instructions.size(); ++i) {
        instructions[i] = instructions_of(core.costs, size_a, size_b, of_work[i]);
      }
      line["instructions"][core.name] = json_of(instructions);
      if (!json) {
        print_row(core.name, instructions);
      }
    }
  }
  if (json) {
    print_object(line);
  }
}

struct CollideArguments : PosedImages {
  std::string algorithm;
  std::string pairs;
  bool first = false;
  bool bound = false;
  bool summary = false;
  bool json = false;
  std::string contacts;
};

std::string chosen_algorithm(const CollideArguments& arguments, const ImageFile& a) {
  if (arguments.algorithm.empty()) {
    return default_traversal(a.layout());
  }
  if (!walks(arguments.algorithm, a.layout())) {
    const bool pre = a.layout() == Layout::pre_indexed;
    throw UserError(a.path(), "is ", std::string(layout_name(a.layout())), "-indexed, which ",
                    arguments.algorithm, " can't walk; bake it with --layout ",
                    pre ? "post" : "pre");
  }
  return arguments.algorithm;
}

bool intersects(const Answer& answer) {
  return answer.counts.triangle_pairs != 0;
}

const char* verdict_of(const Answer& answer) {
  return intersects(answer) ? "intersect" : answer.inside.value_or(false) ? "inside" : "free";
}

/// The verdict of a single pose; for several poses, how many intersect.
std::string verdict_of_all(const std::vector<Answer>& found) {
  if (found.size() == 1) {
    return verdict_of(found[0]);
  }
  const auto count = std::count_if(found.begin(), found.end(), intersects);
  const auto inside = std::count_if(found.begin(), found.end(), [](const Answer& answer) {
    return answer.inside.value_or(false);
  });
  return concat(count, " of ", found.size(), " poses intersect",
                inside == 0 ? "" : concat(", one mesh is inside the other in ", inside));
}

void print_json(std::size_t pose, const std::string& algorithm, const Answer& answer) {
  Json line = {{"pose", pose}, {"intersects", intersects(answer)}};
  if (answer.inside) {
    line["inside"] = *answer.inside;
  }
  line.update({{"algorithm", algorithm},
               {"visits", answer.counts.visits},
               {"overlaps", answer.counts.overlaps},
               {"leaf_pairs", answer.counts.leaf_pairs},
               {"triangle_pairs", answer.counts.triangle_pairs},
               {"status", "ok"}});
  print_object(line);
}

void print_table_row(std::size_t pose, const Answer& answer) {
  const WideCounts& counts = answer.counts;
  std::cout << std::setw(6) << pose << "  " << std::left << std::setw(9) << verdict_of(answer)
            << std::right << std::setw(14) << counts.visits << std::setw(14) << counts.overlaps
            << std::setw(14) << counts.leaf_pairs << std::setw(16) << counts.triangle_pairs << "\n";
}

/// The order of the answer's pairs by triangle numbers.
std::vector<std::size_t> order_of(const Answer& answer) {
  std::vector<std::size_t> order(answer.pairs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const FoundPair& p = answer.pairs[i];
    const FoundPair& q = answer.pairs[j];
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  });
  return order;
}

/// Both ends of the common segment, in the images' unit.
std::string ends_text(const Contact& contact, double cell) {
  std::string text;
  for (const FinePoint& end : contact.ends) {
    for (const std::int64_t coordinate : {end.x, end.y, end.z}) {
      text += " " + shortest(unit_length(coordinate, cell));
    }
  }
  return text;
}

/// A line per pair, by poses and triangle numbers; with its contact if there is a `cell`.
std::string pair_lines(const std::vector<Answer>& found, std::optional<double> cell) {
  std::string text;
  for (std::size_t pose = 0; pose < found.size(); ++pose) {
    const Answer& answer = found[pose];
    for (const std::size_t i : order_of(answer)) {
      text += concat(pose, " ", answer.pairs[i].a, " ", answer.pairs[i].b,
                     cell ? ends_text(answer.contacts[i], *cell) : "", "\n");
    }
  }
  return text;
}

/// Prints the maximum of all poses, the terms of a run's time bound (lib/docs/bounded_time.md), and
/// the work of the given poses, if any.
void print_bound(const ImageFile& a, const ImageFile& b, const CollideArguments& arguments,
                 const std::string& algorithm, const std::vector<std::uint64_t>& work) {
  const VisitBound bound = visit_bound(a.tree(), b.tree(), algorithm);
  const std::uint32_t depths = a.header().depth + b.header().depth;
  const auto later = [](const ImageHeader& header) {
    return header.arity == 0 ? 0u : header.arity - 1u;
  };
  const std::uint32_t siblings = later(a.header()) + later(b.header());
  const std::uint32_t leaf_size = std::max(a.header().leaf_size, b.header().leaf_size);
  const NeededWork poses = work.empty() ? NeededWork() : needed_work(work);
  if (arguments.json) {
    Json line = {{"algorithm", algorithm},
                 {"most_work", bound.work},
                 {"most_visits", bound.visits},
                 {"most_leaf_pairs", bound.leaf_pairs},
                 {"most_triangle_pairs", bound.triangle_pairs},
                 {"depths", depths},
                 {"later_siblings", siblings},
                 {"leaf_size", leaf_size}};
    if (!work.empty()) {
      line.update({{"poses", work.size()},
                   {"poses_most_work", poses.most},
                   {"poses_99_percent_work", poses.percentile_99},
                   {"poses_mean_work", std::llround(poses.mean)}});
    }
    print_object(line);
    return;
  }
  std::cout << a.name() << " and " << b.name() << ", " << algorithm << "\n"
            << "any pose: at most " << bound.work << " work: " << bound.visits
            << " visits, of which " << bound.leaf_pairs << " pairs of leaves, where "
            << bound.triangle_pairs << " pairs of triangles are tested\n";
  if (!work.empty()) {
    std::cout << work.size() << (work.size() == 1 ? " pose: at most " : " poses: at most ")
              << poses.most << " work, 99 % of them at most " << poses.percentile_99
              << ", the mean " << std::llround(poses.mean) << "\n";
  }
  std::cout << "depths " << depths << ", later siblings " << siblings
            << ", triangles a leaf at most " << leaf_size << "\n";
}

/// The answers for all poses, in order.
std::vector<Answer> answers(const CollideArguments& arguments, const ImageFile& a,
                            const ImageFile& b, const std::string& algorithm) {
  std::vector<Answer> found;
  const Requested requested = {arguments.first, !arguments.contacts.empty()};
  for (const Pose& pose : read_lattice_poses(arguments.poses, a.cell(), arguments.floats)) {
    found.push_back(collide(a.tree(), b.tree(), pose, algorithm, requested));
    Answer& answer = found.back();
    check_answered(answer, arguments.poses, found.size() - 1);
    if (!intersects(answer) && !arguments.bound && !arguments.summary) {
      answer.inside = one_is_inside(a, b, pose);
    }
    if (arguments.pairs.empty() && arguments.contacts.empty()) {
      answer.pairs = {};  // may be many
    }
  }
  return found;
}

void print_answers(const CollideArguments& arguments, const std::string& names,
                   const std::string& algorithm, const std::vector<Answer>& found) {
  if (!arguments.json) {
    std::cout << names << ", " << algorithm << ": " << verdict_of_all(found) << "\n"
              << "  pose  verdict          visits      overlaps    leaf pairs  triangle pairs\n";
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (arguments.json) {
      print_json(i, algorithm, found[i]);
    } else {
      print_table_row(i, found[i]);
    }
  }
}

void collide_all(const CollideArguments& arguments) {
  if (!arguments.bound && arguments.poses.empty()) {
    throw CLI::RequiredError("--poses or --bound");
  }
  for (const std::string& output : {arguments.pairs, arguments.contacts}) {
    check_output(output, {arguments.poses});
  }
  if (!arguments.pairs.empty() && arguments.pairs == arguments.contacts) {
    throw UserError("--contacts " + arguments.contacts,
                    "is the same file as that of --pairs; name two");
  }
  const ImageFile a(arguments.a);
  const ImageFile b(arguments.b);
  check_partners(a, b);
  const std::string algorithm = chosen_algorithm(arguments, a);
  std::vector<Answer> found;
  if (!arguments.poses.empty()) {
    found = answers(arguments, a, b, algorithm);
  }
  if (arguments.bound || arguments.summary) {
    std::vector<std::uint64_t> work(found.size());
    std::transform(found.begin(), found.end(), work.begin(),
                   [](const Answer& answer) { return answer.work; });
    if (arguments.bound) {
      print_bound(a, b, arguments, algorithm, work);
    } else {
      print_summary(a, b, algorithm, work, arguments.json);
    }
    return;
  }
  FileSet files;
  if (!arguments.pairs.empty()) {
    files.add(arguments.pairs, pair_lines(found, std::nullopt));
  }
  if (!arguments.contacts.empty()) {
    files.add(arguments.contacts, pair_lines(found, a.cell()));
  }
  files.write([&] {
    print_answers(arguments, a.name() + " and " + b.name(), algorithm, found);
    flush_output();
  });
}

}  // namespace

void add_collide(CLI::App& app) {
  auto [command, a] = add_command<CollideArguments>(
      app, "collide",
      "Find the triangles of A that intersect triangles of B, by the firmware's own code. Prints "
      "of "
      "each pose:\nintersect; inside, if the one closed mesh lies in the other; or free. Insides "
      "of pre-indexed\nimages are not tested.",
      collide_all);
  (void)add_posed_images(command, a);
  command
      .add_option("--algorithm", a.algorithm,
                  "Traversal; default: ranked, or stackless on pre-indexed images")
      ->check(CLI::IsMember(traversal_names()));
  CLI::Option* const first =
      command.add_flag("--first", a.first, "Stop at the first pair of triangles");
  CLI::Option* const pairs =
      add_option(command, "--pairs", a.pairs, "FILE", "Write `pose a b` for each pair, sorted");
  CLI::Option* const contacts =
      add_option(command, "--contacts", a.contacts, "FILE",
                 "Write `pose a b x y z x y z` for each pair, sorted: both ends of the part that "
                 "the triangles\nhave in common, in the images' unit, in A's frame");
  add_float_flag(command, a);
  add_json(command, a.json, "One JSON object a pose");
  CLI::Option* const summary =
      command
          .add_flag("--summary", a.summary,
                    "Print, instead, the mean, the 99th percentile and the most work of the "
                    "poses, and the\ninstructions that each core takes for it at most")
          ->excludes(pairs, contacts);
  command
      .add_flag("--bound", a.bound,
                "Print the work that no pose exceeds, instead, and what the given poses needed")
      ->excludes(first, pairs, contacts, summary);
  add_example(command, "collide baked/plate.fbvh baked/peg.fbvh --poses poses.txt",
              "prints a verdict and the work of each pose");
}

}  // namespace flashbvh::tool
