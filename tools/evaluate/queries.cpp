#include "evaluate/queries.hpp"

#include <algorithm>

#include "evaluate/count_query.hpp"
#include "flashbvh/solid.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Small enough that no count of one run overflows.
constexpr std::uint32_t kWorkPerRun = 1u << 30;

void add(WideCounts& sum, const QueryStats& now, const QueryStats& before) {
  sum.visits += now.visits - before.visits;
  sum.overlaps += now.overlaps - before.overlaps;
  sum.leaf_pairs += now.leaf_pairs - before.leaf_pairs;
  sum.triangle_pairs += now.triangle_pairs - before.triangle_pairs;
}

template <class Traversal>
Answer run(const typename Traversal::Tree& a, const typename Traversal::Tree& b, const Pose& pose,
           const Requested& requested) {
  scene::WalkStart<Traversal> start(a, b);
  Query<Traversal> query(a, b, pose, start.cursor());
  Answer answer;
  answer.status = query.status();
  while (answer.status == Status::suspended) {
    const QueryStats before = query.stats();
    const RunResult step = query.run(kWorkPerRun, [&](const typename Query<Traversal>::Pair& pair) {
      answer.pairs.push_back({pair.a, pair.b});
      if (requested.contacts) {
        answer.contacts.push_back(contact_of_last(query));
      }
      return !requested.first;
    });
    answer.status = step.status;
    answer.work += step.work;
    add(answer.counts, query.stats(), before);
  }
  if (answer.status == Status::full) {
    answer.status = Status::done;  // only the first pair was requested
  }
  return answer;
}

template <class WithLevels>
Answer run_named(const std::string& name, const WithLevels& a, const WithLevels& b,
                 const Pose& pose, const Requested& requested) {
  Answer answer;
  for_each_traversal([&](auto traversal) {
    using Named = decltype(traversal);
    if constexpr (Named::walks(WithLevels::kLayout)) {
      if (name == traversal.name) {
        using Traversal =
            typename Named::template On<typename WithLevels::Index, WithLevels::kLayout>;
        answer = run<Traversal>(a, b, pose, requested);
      }
    }
  });
  return answer;
}

std::string kind_of(const ImageFile& image) {
  return concat(layout_name(image.layout()), "-indexed with ", image.header().index_bits,
                "-bit indices");
}

}  // namespace

std::vector<std::string> traversal_names() {
  std::vector<std::string> names;
  for_each_traversal([&](auto traversal) { names.emplace_back(traversal.name); });
  std::rotate(names.begin(),
              std::find(names.begin(), names.end(), default_traversal(Layout::post_indexed)),
              names.end());
  return names;
}

bool walks(const std::string& traversal, Layout layout) {
  bool result = false;
  for_each_traversal(
      [&](auto named) { result = result || (named.name == traversal && named.walks(layout)); });
  return result;
}

bool are_partners(const ImageFile& a, const ImageFile& b) {
  return a.tree().index() == b.tree().index() && a.cell() == b.cell();
}

void check_partners(const ImageFile& a, const ImageFile& b) {
  if (a.tree().index() != b.tree().index()) {
    throw UserError(b.path(), "is ", kind_of(b), ", but ", a.path(), " is ", kind_of(a),
                    "; bake both with the same --layout and --index-bits");
  }
  if (a.cell() != b.cell()) {
    throw UserError(b.path(), "has a cell of ", shortest(b.cell()), ", but ", a.path(), " one of ",
                    shortest(a.cell()), "; bake both in one call or with the same --cell");
  }
}

Answer collide(const AnyTree& a, const AnyTree& b, const Pose& pose, const std::string& traversal,
               const Requested& requested) {
  return std::visit(
      [&](const auto& tree_a) {
        using WithLevels = std::decay_t<decltype(tree_a)>;
        return run_named(traversal, tree_a, std::get<WithLevels>(b), pose, requested);
      },
      a);
}

std::optional<bool> one_is_inside(const ImageFile& a, const ImageFile& b, const Pose& pose) {
  const auto query = [&](const auto& mesh_a, const auto& mesh_b) {
    const auto answer = flashbvh::one_is_inside(mesh_a, mesh_b, pose);
    return answer.status == Status::done ? std::optional(answer.yes) : std::nullopt;
  };
  return query_post<std::optional<bool>>(query, a.tree(), b.tree()).value_or(std::nullopt);
}

void check_answered(const Answer& answer, const std::string& place, std::size_t pose) {
  if (answer.status != Status::done) {
    throw UserError(place, "pose ", pose, " can't be answered: ", status_name(answer.status));
  }
}

}  // namespace flashbvh::tool
