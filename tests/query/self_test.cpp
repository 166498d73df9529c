// A mesh against itself: each unordered pair once, against brute force; slices, cursors, frames.
#include <set>

#include "flashbvh/self.hpp"
#include "support/bending.hpp"
#include "support/queries.hpp"
#include "support/test.hpp"

namespace {

/// Pairs by source numbers, the smaller first.
Pairs unordered(Pairs pairs) {
  for (auto& pair : pairs) {
    pair = {std::min(pair.first, pair.second), std::max(pair.first, pair.second)};
  }
  return sorted(std::move(pairs));
}

/// The intersecting pairs of triangles that share no vertex.
template <class Test>
Pairs brute_force(const bake::LatticeMesh& mesh, const Test& test) {
  Pairs pairs;
  const auto triangle = [&](std::uint32_t i) {
    return transformed(mesh, i, Pose::translated(0, 0, 0));
  };
  for (std::uint32_t j = 0; j < mesh.triangles.size(); ++j) {
    for (std::uint32_t i = 0; i < j; ++i) {
      const auto& of_i = mesh.triangles[i];
      const auto& of_j = mesh.triangles[j];
      const bool shares =
          std::find_first_of(of_i.begin(), of_i.end(), of_j.begin(), of_j.end()) != of_i.end();
      if (!shares && test(triangle(i), triangle(j))) {
        pairs.emplace_back(i, j);
      }
    }
  }
  return sorted(std::move(pairs));
}
Pairs intersecting(const bake::LatticeMesh& mesh) {
  return brute_force(
      mesh, [](const Triangle& a, const Triangle& b) { return detail::triangles_intersect(a, b); });
}
Pairs near_pairs(const bake::LatticeMesh& mesh, std::uint32_t distance) {
  return brute_force(mesh, [distance](const Triangle& a, const Triangle& b) {
    return detail::is_within(a, b, {std::uint64_t{distance} * distance, Within::kStepsSquared});
  });
}

/// Runs in new queries, each resumed from the previous one's cursor.
template <class Make>
Pairs run_by_cursors(Random& random, const Make& make, std::uint32_t& visits) {
  using Query = decltype(make());
  QueryCursor<typename Query::Index> position{};
  Pairs pairs;
  for (Status status = Status::suspended; status != Status::done;) {
    Query query = make();
    status = query.resume(position);
    REQUIRE((status == Status::suspended || status == Status::done));
    typename Query::Pair found[2];
    const std::uint32_t work = 1 + random.below(90);
    const RunResult step = query.run(work, found, 1 + random.below(2));
    for (std::uint32_t i = 0; i < step.count; ++i) {
      pairs.emplace_back(found[i].a, found[i].b);
    }
    status = step.status;
    visits += query.stats().visits;
    position = query.cursor();
  }
  return pairs;
}

template <class Make>
void check(Random& random, const Make& make, const Pairs& expected) {
  auto whole = make();
  const Pairs in_order = run_to_end(whole);
  REQUIRE(unordered(in_order) == expected);
  auto cut = make();
  const std::uint32_t work = 1 + random.below(200);
  REQUIRE(run_to_end(cut, work, 1 + random.below(9)) == in_order);
  REQUIRE(cut.stats().visits == whole.stats().visits);
  REQUIRE(cut.stats().leaf_pairs == whole.stats().leaf_pairs);
  std::uint32_t visits = 0;
  REQUIRE(run_by_cursors(random, make, visits) == in_order);
  REQUIRE(visits == whole.stats().visits);
}

std::uint32_t mixed(std::uint32_t sum, std::uint32_t value) {
  return (sum ^ value) * 16777619u;
}

}  // namespace

TEST_CASE("a soup's, a sheet's or a tube's triangles that intersect are found once each") {
  std::size_t answers = 0;
  for_rounds(60, [&](Random& random, int) {
    const bake::LatticeMesh lattice = any_bendable(random);
    Bending<Mesh> bent(any_tree(random, lattice), lattice);
    const Mesh& mesh = bent.mesh.mesh();
    for (int frame = 0; frame < 6; ++frame) {
      CAPTURE(frame);
      move_some(random, 12, bent.vertices);
      REQUIRE(bent.mesh.refit().status == Status::done);
      const bake::LatticeMesh now = bent.now();
      const Pairs expected = intersecting(now);
      answers += expected.size();
      check(
          random, [&] { return SelfQuery(mesh); }, expected);
      REQUIRE(intersects_itself(mesh).yes == !expected.empty());
      if (frame % 4 == 0) {
        const std::uint32_t d = random.below(6 * 256);
        check(
            random, [&] { return SelfWithinQuery(mesh, within({d})); }, near_pairs(now, d));
      }
    }
  });
  CHECK(answers > 2000);
}

TEST_CASE("a position is taken if and only if a walk on which all boxes overlap comes by") {
  for_rounds(60, 2, [&](Random& random, int) {
    // All boxes overlap and all triangles share a vertex: no answer ends a run.
    bake::LatticeMesh lattice = random_mesh(random, 1 + random.below(10), 0, 0);
    for (auto& triangle : lattice.triangles) {
      triangle = {0, 0, 0};
    }
    const Bending<Mesh> bent(any_tree(random, lattice), lattice);
    const Mesh& mesh = bent.mesh.mesh();
    std::set<std::pair<std::uint32_t, std::uint32_t>> visited;
    detail::SelfRanked<Mesh> at(mesh, mesh, {});
    do {
      REQUIRE(visited.emplace(at.index_a(), at.index_b()).second);
    } while (at.descend() || at.next());
    for (std::uint32_t a = 0; a < mesh.node_count; ++a) {
      for (std::uint32_t b = 0; b < mesh.node_count; ++b) {
        CAPTURE(a, b);
        SelfQuery other(mesh);
        const Status status =
            other.resume({static_cast<std::uint16_t>(a), static_cast<std::uint16_t>(b), 0,
                          QueryState::at_pair, 0, 0, 0});
        REQUIRE(status ==
                (visited.count({a, b}) != 0 ? Status::suspended : Status::cursor_invalid));
        if (status == Status::suspended) {
          (void)other.run(UINT32_MAX, [](const SelfQuery::Pair&) { return true; });
          REQUIRE(other.status() == Status::done);
          REQUIRE(other.stats().visits <= visited.size());
        }
      }
    }
  });
}

TEST_CASE("a bending tube's digest is the same on every core") {
  Random random(7);
  const bake::LatticeMesh lattice = grid(12, 10, true);
  Bending<Mesh> bent(bake::build_default(lattice, 2), lattice);
  lay(random, 12, 60, 40, 25, bent.vertices);
  std::uint32_t sum = 2166136261u;
  for (int frame = 0; frame < 12; ++frame) {
    move_some(random, 50, bent.vertices);
    REQUIRE(bent.mesh.refit().status == Status::done);
    for (const Node<std::uint16_t>& node : bent.nodes) {
      sum = mixed(mixed(mixed(sum, node.box.upper_xy), node.box.lower_xy), node.box.z);
    }
    const auto add = [&sum](auto& query) {
      const auto sink = [&sum](const SelfQuery::Pair& pair) {
        sum = mixed(mixed(sum, pair.a), pair.b);
        return true;
      };
      REQUIRE(query.run(UINT32_MAX, sink).status == Status::done);
      const QueryStats& counts = query.stats();
      sum = mixed(mixed(mixed(sum, counts.visits), counts.leaf_pairs), counts.triangle_pairs);
    };
    SelfQuery self(bent.mesh.mesh());
    add(self);
    SelfWithinQuery band(bent.mesh.mesh(), within({700}));
    add(band);
    const Pose pose = Pose::translated(40, 7, -11);
    PairQuery pair(bent.mesh.mesh(), bent.mesh.mesh(), pose);
    add(pair);
  }
  CHECK(sum == 0x31C8E994u);
}
