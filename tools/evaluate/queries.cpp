#include "evaluate/queries.hpp"

#include "flashbvh/query.hpp"
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
           bool only_first) {
  Query<Traversal> query(a, b, pose);
  Answer answer;
  answer.status = query.status();
  while (answer.status == Status::suspended) {
    const QueryStats before = query.stats();
    const RunResult step = query.run(kWorkPerRun, [&](const typename Query<Traversal>::Pair& pair) {
      answer.pairs.push_back({pair.a, pair.b});
      return !only_first;
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

std::string kind_of(const ImageFile& image) {
  return concat(layout_name(image.layout()), "-indexed with ", image.header().index_bits,
                "-bit indices");
}

}  // namespace

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

Answer collide(const AnyTree& a, const AnyTree& b, const Pose& pose, bool only_first) {
  return std::visit(
      [&](const auto& tree_a) {
        using Tree = std::decay_t<decltype(tree_a)>;
        const auto& tree_b = std::get<Tree>(b);
        if constexpr (Tree::kLayout == Layout::post_indexed) {
          using Plain = BasicMesh<typename Tree::Index, Layout::post_indexed>;
          return run<Ranked<Plain>>(tree_a, tree_b, pose, only_first);
        } else {
          return run<BasicStackless<Tree>>(tree_a, tree_b, pose, only_first);
        }
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
