// flashbvh_judge IMAGE URDF --stop METRES [--package NAME=FOLDER] [--visual-too]
//                [--configurations N] [--seed N] [--more METRES]
//
// Checks that the guard of a robot with simplified links keeps the URDF's own meshes at the stop
// distance. Half of the configurations are random; the other half are as near to a stop of the
// guard as 12 bisections get. Distances are in doubles. With --more, the stop distances are larger
// than baked by METRES, so the check has to fail.
#include <cstdio>

#include "described.hpp"
#include "drawn_mesh.hpp"
#include "flashbvh/robot/guard.hpp"
#include "robot/baked/fixed_robot.hpp"
#include "robot/baked/robot_file.hpp"
#include "simplify/nearest.hpp"
#include "support/random.hpp"
#include "text/parallel.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr int kHalvings = 12;
constexpr int kCuts = 4;
constexpr int kTries = 200;
constexpr std::size_t kStateWords = 1 << 16;
constexpr long kRound = 1000;  ///< configurations of a seed

using Values = std::vector<JointCoordinate>;

/// Two meshes that the guard must keep at the stop distance.
struct JudgedPair {
  std::size_t a;
  std::size_t b;
  tool::JointsBetween joints;
  double stop;
  const DrawnMesh* of_a;
  const DrawnMesh* of_b;
};

double from_axis(const tool::Transform& axis, const Vector3& p) {
  const Vector3 at = placed(axis, p);
  return std::hypot(at[0], at[1]);
}

/// Adds the part beyond the cylinder about an axis, of triangles cut in four; not all of it.
void add_beyond(const FloatTriangle& triangle, const tool::Transform& axis, double radius, int cuts,
                std::vector<FloatTriangle>& beyond) {
  const Vector3 centre = simplify::centre_of(triangle);
  const double size = simplify::radius_of(triangle, centre);
  const double off = from_axis(axis, centre);
  if (off - size > radius) {
    beyond.push_back(triangle);
    return;
  }
  if (cuts == 0 || off + size < radius) {
    return;
  }
  for (const FloatTriangle& part : simplify::quarters_of(triangle)) {
    add_beyond(part, axis, radius, cuts - 1, beyond);
  }
}

class Judge {
 public:
  Judge(const tool::RobotFile& file, tool::Model model, double stop, double more)
      : file_(file), model_(std::move(model)), more_(more) {
    for (const tool::ModelLink& link : model_.links) {
      meshes_.push_back(std::make_unique<DrawnMesh>(triangles_of(link.mesh)));
    }
    for (std::size_t a = 0; a < model_.links.size(); ++a) {
      for (std::size_t b = a + 1; b < model_.links.size(); ++b) {
        if (model_.links[a].joint != model_.links[b].joint) {
          add_pair(a, b, stop);
        }
      }
    }
  }

  std::size_t whole() const { return whole_; }
  std::size_t beyond_zones() const { return pairs_.size() - whole_; }
  std::size_t left_out() const { return left_out_; }
  const tool::Model& model() const { return model_; }
  const Robot& robot() const { return file_.robot(); }

  Values any_values(Random& random) const {
    Values values;
    for (const std::size_t number : model_.variables) {
      const RobotJoint& joint = robot().joints[number];
      values.push_back(joint.type == JointType::continuous
                           ? random.between(-kFullTurn / 2, kFullTurn / 2)
                           : random.between(joint.lower, joint.upper));
    }
    return values;
  }

  /// A pair nearer than its stop distance, or null.
  const JudgedPair* near_pair(const Values& values) const {
    std::vector<double> variables;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const JointType type = robot().joints[model_.variables[i]].type;
      variables.push_back(values[i] * tool::unit_of_coordinate(type, file_.cell()));
    }
    for (const JudgedPair& pair : pairs_) {
      if (pair.of_a->is_nearer(*pair.of_b, frame_between(model_, pair.joints, variables),
                               pair.stop)) {
        return &pair;
      }
    }
    return nullptr;
  }

 private:
  void add_pair(std::size_t a, std::size_t b, double stop) {
    JudgedPair pair = {
        a, b, joints_between(model_, a, b), stop, meshes_[a].get(), meshes_[b].get()};
    const Robot& of = robot();
    for (std::size_t i = 0; i < of.pair_count; ++i) {
      if (of.pairs[i].a == a && of.pairs[i].b == b) {
        pair.stop = of.pairs[i].stop * file_.cell() / kFineOne;
      }
    }
    pair.stop += more_;
    const std::vector<tool::UnguardedPair> unguarded = file_.unguarded();
    if (const tool::UnguardedPair* const out = find_pair(unguarded, a, b)) {
      if (out->why != WhyUnguarded::zone ||
          model_.joints[out->joint].type == JointType::prismatic) {
        ++left_out_;
        return;
      }
      pair.of_a = beyond_zone(a, *out);
      pair.of_b = beyond_zone(b, *out);
      pairs_.push_back(pair);
      return;
    }
    ++whole_;
    pairs_.insert(pairs_.begin(), pair);
  }

  /// All zones are balls about a point of the axis, so the cylinder about it contains them.
  const DrawnMesh* beyond_zone(std::size_t link, const tool::UnguardedPair& pair) {
    const bool is_moved = model_.links[link].joint == pair.joint;
    const tool::Transform axis =
        is_moved ? tool::Transform() : inverse(model_.joints[pair.joint].fixed);
    std::vector<FloatTriangle> beyond;
    for (const FloatTriangle& triangle : triangles_of(model_.links[link].mesh)) {
      add_beyond(triangle, axis, pair.radius, kCuts, beyond);
    }
    meshes_.push_back(std::make_unique<DrawnMesh>(std::move(beyond)));
    return meshes_.back().get();
  }

  const tool::RobotFile& file_;
  tool::Model model_;
  double more_;
  std::vector<std::unique_ptr<DrawnMesh>> meshes_;
  std::vector<JudgedPair> pairs_;
  std::size_t whole_ = 0;
  std::size_t left_out_ = 0;
};

struct Counts {
  long stops = 0;
  long passes = 0;
  long next_to_stops = 0;  ///< of passes
  long unsound = 0;
};

class Judged {
 public:
  explicit Judged(const Judge& judge)
      : judge_(judge),
        memory_(kStateWords),
        guard_(judge.robot(), memory_.data(), kStateWords * sizeof memory_[0]) {}

  const Counts& run(std::uint64_t seed, long configurations) {
    Random random(seed);
    for (long i = 0; i < configurations; ++i) {
      Values values = judge_.any_values(random);
      const bool stops = is_stopped(values);
      counts_.stops += stops ? 1 : 0;
      if (i % 2 == 0) {
        if (!stops) {
          check(values, seed);
        }
      } else if (move_next_to_stop(random, values, stops)) {
        ++counts_.next_to_stops;
        check(values, seed);
      }
    }
    return counts_;
  }
  bool fits() const { return guard_.fits(); }

 private:
  bool is_stopped(const Values& values) {
    const GuardAnswer answer = guard_.prime(values.data());
    return answer.status != Status::done || answer.verdict == Verdict::stop ||
           answer.verdict == Verdict::not_yet_known;
  }

  bool move_next_to_stop(Random& random, Values& values, bool stops) {
    Values other = values;
    int tries = 0;
    do {
      other = judge_.any_values(random);
    } while (is_stopped(other) == stops && ++tries < kTries);
    if (tries == kTries) {
      return false;
    }
    Values& passing = stops ? other : values;
    Values& stopping = stops ? values : other;
    for (int i = 0; i < kHalvings; ++i) {
      Values middle = passing;
      for (std::size_t k = 0; k < middle.size(); ++k) {
        middle[k] = static_cast<JointCoordinate>((std::int64_t{passing[k]} + stopping[k]) / 2);
      }
      (is_stopped(middle) ? stopping : passing) = middle;
    }
    values = passing;
    return true;
  }

  void check(const Values& values, std::uint64_t seed) {
    ++counts_.passes;
    if (const JudgedPair* const pair = judge_.near_pair(values)) {
      ++counts_.unsound;
      std::fprintf(stderr, "seed %llu: %s - %s are nearer than %g m at",
                   static_cast<unsigned long long>(seed),
                   judge_.model().links[pair->a].name.c_str(),
                   judge_.model().links[pair->b].name.c_str(), pair->stop);
      for (const JointCoordinate value : values) {
        std::fprintf(stderr, " %d", value);
      }
      std::fprintf(stderr, "\n");
    }
  }

  const Judge& judge_;
  std::vector<std::uint64_t> memory_;
  Guard guard_;
  Counts counts_;
};

int judged(const Judge& judge, long configurations, std::uint64_t seed) {
  if (!Judged(judge).fits()) {
    std::fprintf(stderr, "the robot's guard needs more memory than there is here\n");
    return 2;
  }
  std::vector<Counts> rounds(static_cast<std::size_t>((configurations + kRound - 1) / kRound));
  tool::for_each_in_parallel(rounds.size(), [&](std::size_t i) {
    const long before = static_cast<long>(i) * kRound;
    rounds[i] = Judged(judge).run(seed + i, std::min(kRound, configurations - before));
  });
  Counts all;
  for (const Counts& more : rounds) {
    all.stops += more.stops;
    all.passes += more.passes;
    all.next_to_stops += more.next_to_stops;
    all.unsound += more.unsound;
  }
  std::printf(
      "| robot | pairs | outside zones | left out | configurations | stops | judged | next to a "
      "stop | unsound |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n"
      "| %s | %zu | %zu | %zu | %ld | %ld | %ld | %ld | %ld |\n",
      judge.model().name.c_str(), judge.whole(), judge.beyond_zones(), judge.left_out(),
      configurations, all.stops, all.passes, all.next_to_stops, all.unsound);
  return all.unsound == 0 && all.passes != 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Judges a guard by the URDF's own meshes.");
  std::string image;
  Described described;
  double stop = 0;
  double more = 0;
  long configurations = 1'000'000;
  std::uint64_t seed = 1;
  app.add_option("IMAGE", image)->required();
  described.add_to(app);
  app.add_option("--stop", stop)->required();
  app.add_option("--more", more);
  app.add_option("--configurations", configurations);
  app.add_option("--seed", seed);
  CLI11_PARSE(app, count, arguments);
  try {
    const tool::RobotFile file(image);
    return judged(Judge(file, described.read(), stop, more), configurations, seed);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
