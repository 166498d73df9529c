// flashbvh collide: the firmware's query, on the desktop.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <tuple>

#include "cli/commands.hpp"
#include "cli/outputs.hpp"
#include "evaluate/needed_work.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "evaluate/visit_bound.hpp"
#include "image/image_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct CollideArguments {
  std::string a;
  std::string b;
  std::string poses;
  std::string algorithm;
  std::string pairs;
  bool first = false;
  bool bound = false;
  bool json = false;
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

void print_json(std::size_t pose, const std::string& algorithm, const WideCounts& counts) {
  const nlohmann::ordered_json line = {{"pose", pose},
                                       {"algorithm", algorithm},
                                       {"visits", counts.visits},
                                       {"overlaps", counts.overlaps},
                                       {"leaf_pairs", counts.leaf_pairs},
                                       {"triangle_pairs", counts.triangle_pairs},
                                       {"status", "ok"}};
  std::cout << line.dump() << "\n";
}

void print_table_row(std::size_t pose, const WideCounts& counts) {
  std::cout << std::setw(6) << pose << std::setw(14) << counts.visits << std::setw(14)
            << counts.overlaps << std::setw(14) << counts.leaf_pairs << std::setw(16)
            << counts.triangle_pairs << "\n";
}

void append_pairs(std::string& text, std::size_t pose, std::vector<FoundPair> pairs) {
  std::sort(pairs.begin(), pairs.end(), [](const FoundPair& p, const FoundPair& q) {
    return std::tie(p.a, p.b) < std::tie(q.a, q.b);
  });
  for (const FoundPair& pair : pairs) {
    text += concat(pose, " ", pair.a, " ", pair.b, "\n");
  }
}

/// What no pose can exceed, what a run's bound is made of (lib/docs/bounded_time.md), and what the
/// given poses needed, if any.
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
    nlohmann::ordered_json line = {{"algorithm", algorithm},
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
    std::cout << line.dump() << "\n";
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

/// All poses' answers, in their order.
std::vector<Answer> answers(const CollideArguments& arguments, const ImageFile& a,
                            const ImageFile& b, const std::string& algorithm) {
  std::vector<Answer> found;
  for (const Pose& pose : read_lattice_poses(arguments.poses, a.cell())) {
    found.push_back(collide(a.tree(), b.tree(), pose, algorithm, arguments.first));
    Answer& answer = found.back();
    check_answered(answer, arguments.poses, found.size() - 1);
    if (arguments.pairs.empty()) {
      answer.pairs = {};  // there may be many
    }
  }
  return found;
}

void print_answers(const CollideArguments& arguments, const std::string& names,
                   const std::string& algorithm, const std::vector<Answer>& found) {
  if (!arguments.json) {
    std::cout << names << ", " << algorithm << "\n"
              << "  pose        visits      overlaps    leaf pairs  triangle pairs\n";
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (arguments.json) {
      print_json(i, algorithm, found[i].counts);
    } else {
      print_table_row(i, found[i].counts);
    }
  }
}

void collide_all(const CollideArguments& arguments) {
  if (!arguments.pairs.empty()) {
    refuse_to_replace_inputs(arguments.pairs, {arguments.poses});
    refuse_to_replace_image(arguments.pairs);
  }
  const ImageFile a(arguments.a);
  const ImageFile b(arguments.b);
  check_partners(a, b);
  const std::string algorithm = chosen_algorithm(arguments, a);
  std::vector<Answer> found;
  if (!arguments.poses.empty()) {
    found = answers(arguments, a, b, algorithm);
  }
  if (arguments.bound) {
    std::vector<std::uint64_t> work(found.size());
    std::transform(found.begin(), found.end(), work.begin(),
                   [](const Answer& answer) { return answer.work; });
    print_bound(a, b, arguments, algorithm, work);
    return;
  }
  const auto print = [&] {
    print_answers(arguments, a.name() + " and " + b.name(), algorithm, found);
    flush_output();
  };
  if (arguments.pairs.empty()) {
    print();
    return;
  }
  std::string pairs;
  for (std::size_t i = 0; i < found.size(); ++i) {
    append_pairs(pairs, i, found[i].pairs);
  }
  write_file(arguments.pairs, std::move(pairs), print);
}

}  // namespace

void add_collide(CLI::App& app) {
  const auto arguments = std::make_shared<CollideArguments>();
  CollideArguments& a = *arguments;
  CLI::App* const command = app.add_subcommand(
      "collide",
      "Find the triangles of A that intersect triangles of B, by the firmware's own code.");
  command->add_option("A", a.a, "Image (.fbvh) that stays in place")->required();
  command->add_option("B", a.b, "Image (.fbvh) that the poses rotate and translate")->required();
  command
      ->add_option("--poses", a.poses,
                   "A pose a line, B into A's frame: the rotation row by row, then the translation "
                   "in the mesh's unit; 12 numbers")
      ->type_name("FILE");
  command
      ->add_option("--algorithm", a.algorithm,
                   "Traversal; default: ranked, or stackless on pre-indexed images")
      ->check(CLI::IsMember(traversal_names()));
  CLI::Option* const first =
      command->add_flag("--first", a.first, "Stop at the first pair of triangles");
  CLI::Option* const pairs =
      command->add_option("--pairs", a.pairs, "Write `pose a b` for each pair, sorted")
          ->type_name("OUT");
  command->add_flag("--json", a.json, "One JSON object a pose");
  command
      ->add_flag("--bound", a.bound,
                 "Print the work that no pose exceeds, instead, and what the given poses needed")
      ->excludes(first, pairs);
  command->callback([arguments] {
    if (!arguments->bound && arguments->poses.empty()) {
      throw CLI::RequiredError("--poses or --bound");
    }
    collide_all(*arguments);
  });
}

}  // namespace flashbvh::tool
