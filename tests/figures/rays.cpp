// Rays at the KR5's links: single ones that are aimed at a link's box from outside, and scans of
// it, fans of rays from one place; and points in the box. Ends with 1 if a seed changes an answer,
// or any_hit() is of another opinion than nearest_hit().
#include "flashbvh/ray.hpp"

#include "bicep.fbvh.hpp"
#include "flashbvh/solid.hpp"
#include "forearm.fbvh.hpp"
#include "insn.hpp"
#include "palm.fbvh.hpp"
#include "ray_sets.hpp"
#include "report.hpp"
#include "wrist.fbvh.hpp"

using namespace flashbvh;

namespace figures {
namespace {

constexpr uint64_t kSeed = 20240607;
constexpr uint32_t kOfLink = 128;  ///< aimed rays, and points
constexpr uint16_t kNone = kNoSeed<uint16_t>;

constexpr Fan kFans[] = {{"grid", 16, 16}, {"line", 1, 256}};

const PostMesh* const kLinks[] = {&bicep::mesh, &forearm::mesh, &palm::mesh, &wrist::mesh};

/// What one question took.
struct Question {
  Spread instructions;
  Spread visits;

  template <class Ask>
  auto ask(const Ask& ask) {
    decltype(ask()) answer = {};
    instructions.add(port::instructions_of([&] { answer = ask(); }));
    visits.add(answer.visits);
    counted.add(answer.visits);
    return answer;
  }
  void print(const char* name, const char* set = nullptr) const {
    print_figures({{"ray", name, set}}, instructions);
    print_counts({{"ray", "visits", name, set}}, visits);
  }
};

/// What a visit takes, and a triangle that is met: fetched and tested.
struct Parts {
  uint64_t visits = 0;
  uint64_t walks = 0;  ///< instructions
  Spread triangles;

  void print() const {
    print_quotient({{"ray", "visit", "mean"}}, walks, visits);
    print_figures({{"ray", "triangle"}}, triangles);
  }
};

/// Rays of one kind.
class Set {
 public:
  /// Returns whether the answers agree.
  bool ask(const PostMesh& mesh, const Segment& segment, uint16_t seed, Parts& parts) {
    const auto cold = cold_.ask([&] { return nearest_hit(mesh, segment); });
    const auto seeded = seeded_.ask([&] { return nearest_hit(mesh, segment, seed); });
    const auto any = any_.ask([&] { return any_hit(mesh, segment); });
    crossings_.add(port::instructions_of([&] { (void)signed_crossings(mesh, segment); }));
    measure_parts(mesh, segment, parts);
    return cold.status == Status::done && seeded.yes == cold.yes && any.yes == cold.yes &&
           (!cold.yes || seeded.hit.triangle == cold.hit.triangle);
  }

  void print(const char* name) const {
    print_count({{"ray", "rays", name}}, triangles_.count());
    print_counts({{"ray", "triangles", name}}, triangles_);
    cold_.print("cold", name);
    any_.print("any", name);
    print_figures({{"ray", "crossings", name}}, crossings_);
  }
  void print_seeded(const char* name) const { seeded_.print("seeded", name); }

 private:
  /// The walk alone, with nothing cut off; and each triangle that nearest_hit() comes to.
  void measure_parts(const PostMesh& mesh, const Segment& segment, Parts& parts) {
    detail::SegmentWalk<PostMesh> all(mesh, segment);
    uint32_t position = 0;
    parts.walks += port::instructions_of([&] {
      while (all.next_triangle(position)) {
      }
    });
    parts.visits += all.visits();

    detail::SegmentWalk<PostMesh> walk(mesh, segment);
    RayHit<uint16_t> hit = {};
    SegmentShare nearest = {1, 1};
    uint32_t count = 0;
    while (walk.next_triangle(position)) {
      bool yes = false;
      parts.triangles.add(port::instructions_of([&] { yes = walk.get_hit(position, hit); }));
      ++count;
      if (yes && detail::order_along(hit.along, nearest) < 0) {
        nearest = hit.along;
        walk.shorten(nearest);
      }
    }
    triangles_.add(count);
  }

  Question cold_;
  Question seeded_;
  Question any_;
  Spread crossings_;
  Spread triangles_;
};

bool ask_aimed(Parts& parts) {
  test::Random random(kSeed);
  Set hit;
  Set missed;
  bool good = true;
  for (const PostMesh* const link : kLinks) {
    const Box box(*link);
    for (uint32_t i = 0; i < kOfLink; ++i) {
      const Segment segment = any_aimed(random, box);
      Set& set = any_hit(*link, segment).yes ? hit : missed;
      good = set.ask(*link, segment, kNone, parts) && good;
    }
  }
  hit.print("aimed");
  missed.print("missed");
  return good;
}

/// Each ray that hits is seeded by what was hit before; the others leave the seed as it is.
bool ask_fan(const Fan& fan, Parts& parts) {
  Set hit;
  bool good = true;
  for (const PostMesh* const link : kLinks) {
    const Box box(*link);
    uint16_t seed = kNone;
    for (int32_t i = 0; i < fan.rows * fan.columns; ++i) {
      const Segment segment = of_fan(fan, box, i / fan.columns, i % fan.columns);
      const auto found = nearest_hit(*link, segment);
      if (found.yes) {
        good = hit.ask(*link, segment, seed, parts) && good;
        seed = found.hit.position;
      }
    }
  }
  hit.print(fan.name);
  hit.print_seeded(fan.name);
  return good;
}

bool ask_points() {
  test::Random random(kSeed);
  Question points;
  bool good = true;
  for (const PostMesh* const link : kLinks) {
    const Box box(*link);
    for (uint32_t i = 0; i < kOfLink; ++i) {
      const Point point = any_point(random, box.lower, box.upper);
      good = points.ask([&] { return inside(*link, point); }).status == Status::done && good;
    }
  }
  points.print("inside");
  return good;
}

bool run() {
  print_core();
  Parts parts;
  bool good = ask_aimed(parts);
  for (const Fan& fan : kFans) {
    good = ask_fan(fan, parts) && good;
  }
  good = ask_points() && good;
  parts.print();
  print_count({{"ray", "digest"}}, counted.value());
  return good;
}

}  // namespace
}  // namespace figures

int main() {
  return figures::run() ? 0 : 1;
}
