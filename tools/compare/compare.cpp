// compare FOLDER A-B...: what each library takes for the same queries on two meshes, whose images
// lie in FOLDER. Prints lines for table.awk:
//     time MESHES MOTION CLASS LIBRARY nanoseconds a query
//     pairs MESHES MOTION LIBRARY found by flashbvh, by the library, by one of the two alone
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <string>

#include "contender.hpp"
#include "meshes.hpp"
#include "pose_search.hpp"

using namespace figures;

namespace compare {
namespace {

constexpr std::uint64_t kSeed = 20240607;
/// Poses of a class, visited in turn, so that no branch predictor knows them by heart.
constexpr std::size_t kPoses = 64;
/// Samples of each library; their median counts.
constexpr std::size_t kRounds = 25;
/// What the fastest library's sample takes at least. All make as many walks over the poses: one,
/// unless queries are short, so that none begins with a warmer branch predictor than the others.
constexpr double kSampleNanoseconds = 10e3;

struct Named {
  const char* name;
  std::unique_ptr<Contender> library;
  std::vector<double> samples;  ///< nanoseconds a query
};

std::vector<Named> all_libraries(const flashbvh::PostMesh& a, const flashbvh::PostMesh& b) {
  std::vector<Named> all;
  const auto add = [&all](const char* name, std::unique_ptr<Contender> library) {
    all.push_back({name, std::move(library), {}});
  };
  add("flashbvh", with_flashbvh(a, b, PoseMade::before));
  add("opcode", with_opcode(a, b, Matrices::both));
  add("fcl", with_fcl(a, b));
  add("flashbvh_pose", with_flashbvh(a, b, PoseMade::in_the_query));
  add("opcode_one", with_opcode(a, b, Matrices::of_b));
  return all;
}

/// Nanoseconds of a query, on the average of the poses.
double sample(Contender& library, Wanted wanted, int walks) {
  static volatile std::size_t found;  // so that no query is left out
  const auto began = std::chrono::steady_clock::now();
  for (int i = 0; i < walks; ++i) {
    found = library.ask_all(wanted);
  }
  const std::chrono::duration<double, std::nano> passed = std::chrono::steady_clock::now() - began;
  return passed.count() / (walks * static_cast<double>(kPoses));
}

/// Every round has all the libraries, so that what slows the machine slows all of them, in an order
/// of its own, since each leaves caches and predictors to the next.
void time_all(std::vector<Named>& libraries, Wanted wanted, flashbvh::test::Random& random) {
  double fastest = 1e9;
  for (Named& named : libraries) {
    fastest = std::min(fastest, sample(*named.library, wanted, 1));
    named.samples.clear();
  }
  const int walks = 1 + static_cast<int>(kSampleNanoseconds / (fastest * kPoses));
  std::vector<Named*> order;
  for (Named& named : libraries) {
    order.push_back(&named);
  }
  for (std::size_t round = 0; round < kRounds; ++round) {
    for (std::size_t i = order.size(); i > 1; --i) {
      std::swap(order[i - 1], order[random.below(static_cast<std::uint32_t>(i))]);
    }
    for (Named* named : order) {
      named->samples.push_back(sample(*named->library, wanted, walks));
    }
  }
}

double median(std::vector<double>& samples) {
  std::sort(samples.begin(), samples.end());
  return samples[samples.size() / 2];
}

struct Found {
  std::size_t by_flashbvh = 0;
  std::size_t by_other = 0;
  std::size_t by_one = 0;  ///< of the two alone
};

void add_pairs(std::vector<Pair> ours, std::vector<Pair> theirs, Found& found) {
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  std::vector<Pair> differing;
  std::set_symmetric_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                                std::back_inserter(differing));
  found.by_flashbvh += ours.size();
  found.by_other += theirs.size();
  found.by_one += differing.size();
}

class Comparison {
 public:
  /// Poses are found with the trees `searched`.
  Comparison(const std::string& name, const Meshes& searched, const Meshes& asked)
      : name_(name),
        search_(searched, asked, kSeed),
        libraries_(all_libraries(*asked.a, *asked.b)) {}

  void run(bool rotated) {
    motion_ = rotated ? "rotated" : "translated";
    found_.assign(libraries_.size(), Found());
    for (std::uint32_t i = 0; i < kProximities; ++i) {
      const auto proximity = static_cast<Proximity>(i);
      set_poses(proximity, rotated);
      compare(Wanted::all, kProximityNames[i]);
      if (proximity == Proximity::intersecting) {
        compare(Wanted::first, "first");
      }
    }
    for (std::size_t i = 0; i < libraries_.size(); ++i) {
      std::printf("pairs %s %s %s %zu %zu %zu\n", name_.c_str(), motion_, libraries_[i].name,
                  found_[i].by_flashbvh, found_[i].by_other, found_[i].by_one);
    }
    std::fflush(stdout);
  }

 private:
  void set_poses(Proximity proximity, bool rotated) {
    std::vector<Placed> poses;
    while (poses.size() < kPoses) {
      const Asked asked = search_.next(proximity, rotated);
      const std::int16_t(&q)[4] = asked.quaternion;
      poses.push_back({flashbvh::test::rotation_of({q[0], q[1], q[2], q[3]}),
                       {asked.cells[0], asked.cells[1], asked.cells[2]},
                       pose_of(asked)});
    }
    for (std::size_t i = 0; i < libraries_.size(); ++i) {
      libraries_[i].library->set_poses(poses);
      for (std::size_t pose = 0; pose < kPoses; ++pose) {
        add_pairs(libraries_[0].library->pairs(pose), libraries_[i].library->pairs(pose),
                  found_[i]);
      }
    }
  }

  void compare(Wanted wanted, const char* of_class) {
    time_all(libraries_, wanted, random_);
    for (Named& named : libraries_) {
      std::printf("time %s %s %s %s %.2f\n", name_.c_str(), motion_, of_class, named.name,
                  median(named.samples));
    }
  }

  std::string name_;
  PoseSearch search_;
  flashbvh::test::Random random_{kSeed};
  std::vector<Named> libraries_;
  std::vector<Found> found_;  ///< as many
  const char* motion_ = nullptr;
};

void compare_pair(const std::string& folder, const std::string& names) {
  const std::size_t dash = names.find('-');
  const std::string file_a = "/" + names.substr(0, dash) + ".fbvh";
  const std::string file_b = "/" + names.substr(dash + 1) + ".fbvh";
  const Image a(folder + file_a);
  const Image b(folder + file_b);
  const Image searched_a(folder + "/searched" + file_a);
  const Image searched_b(folder + "/searched" + file_b);
  Comparison comparison(names, {&searched_a.mesh(), &searched_b.mesh()}, {&a.mesh(), &b.mesh()});
  comparison.run(false);
  comparison.run(true);
}

}  // namespace
}  // namespace compare

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: compare FOLDER A-B...\n", stderr);
    return 2;
  }
  try {
    for (int i = 2; i < argc; ++i) {
      compare::compare_pair(argv[1], argv[i]);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "compare: %s\n", error.what());
    return 1;
  }
  return 0;
}
