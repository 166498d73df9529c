// flashbvh_check_robot: an independent check of a baked robot (lib/docs/proofs.md).
#include <atomic>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>

#include "checks.hpp"

namespace robot_check {
namespace {

constexpr const char* kUsage =
    "Usage: flashbvh_check_robot NAME.robot [--boxes N] [--time SECONDS] [--first]\n"
    "Recomputes what a baked robot promises, by other methods than the baker's.\n"
    "  --boxes N  most boxes of joint values a row; more decide more (default 400000)\n"
    "  --time S   seconds for all, after which pairs in no array are undecided (default 600)\n"
    "  --first    ends with the first group that is refused\n"
    "Exit status: 0 all confirmed, 1 refused, 2 usage or unreadable image, 3 undecided rows\n";
/// Boxes of a reach cost less than those of a pair by this factor.
constexpr std::size_t kReachShare = 10;
/// The number of printed rows per group.
constexpr std::size_t kMostRows = 8;

void print(const char* verdict, const std::vector<std::string>& rows) {
  for (std::size_t i = 0; i < rows.size() && i < kMostRows; ++i) {
    std::cout << "  " << verdict << ": " << rows[i] << '\n';
  }
  if (rows.size() > kMostRows) {
    std::cout << "  " << verdict << ": " << rows.size() - kMostRows << " more rows\n";
  }
}

struct Options {
  std::string path;
  std::size_t most_boxes = 400'000;
  std::size_t seconds = 600;
  bool is_first = false;
};

int check(const Robot& robot, const Options& options) {
  const Moment end = std::chrono::steady_clock::now() + std::chrono::seconds(options.seconds);
  Report report;
  if (!check_rules(robot, report)) {
    return report.status();
  }
  Bodies bodies;
  for (const Link& link : robot.links) {
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < link.mesh.corners.size(); ++i) {
      triangles.push_back(link.mesh.triangle(i));
    }
    if (triangles.empty()) {
      report.refuse("mesh of link " + link.name + ": no triangles");
      report.end("meshes", "");
      return report.status();
    }
    bodies.emplace_back(std::move(triangles));
  }
  const std::function<void()> groups[] = {
      [&] { check_trees(robot, report); },
      [&] { check_spheres(robot, report); },
      [&] { check_reaches(robot, bodies, kReachShare * options.most_boxes, report); },
      [&] { check_slack(robot, report); },
      [&] { check_tables(robot, bodies, options.most_boxes, report); },
      [&] { check_matrix(robot, bodies, options.most_boxes, end, report); },
      [&] { check_zones(robot, bodies, options.most_boxes, report); },
  };
  for (const auto& group : groups) {
    group();
    if (options.is_first && report.status() == 1) {
      break;
    }
  }
  return report.status();
}

/// False if the options do not match kUsage.
bool read_options(int count, char** arguments, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    if (word == "--first") {
      options.is_first = true;
    } else if ((word == "--boxes" || word == "--time") && i + 1 < count) {
      const std::string number = arguments[++i];
      if (number.empty() || number.size() > 9 ||
          number.find_first_not_of("0123456789") != std::string::npos) {
        std::cerr << "flashbvh_check_robot: " << word << ' ' << number << ": give 0 to 999999999\n";
        return false;
      }
      (word == "--boxes" ? options.most_boxes : options.seconds) = std::stoul(number);
    } else if (word[0] != '-' && options.path.empty()) {
      options.path = word;
    } else {
      return false;
    }
  }
  return !options.path.empty();
}

int run(int count, char** arguments) {
  Options options;
  if (!read_options(count, arguments, options)) {
    std::cerr << kUsage;
    return 2;
  }
  std::ifstream file(options.path, std::ios::binary);
  if (!file) {
    std::cerr << "flashbvh_check_robot: " << options.path << ": cannot be opened\n";
    return 2;
  }
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  try {
    return check(read_robot(bytes), options);
  } catch (const BadImage& bad) {
    std::cerr << "flashbvh_check_robot: " << options.path << ": " << bad.what() << '\n';
    return 2;
  }
}

}  // namespace

bool Report::end(const std::string& group, const std::string& confirmed) {
  const bool holds = refused_.empty();
  std::cout << group << ": ";
  if (holds && undecided_.empty()) {
    std::cout << confirmed;
  } else {
    std::cout << refused_.size() << " refused, " << undecided_.size() << " undecided";
  }
  std::cout << std::endl;
  print("refused", refused_);
  print("undecided", undecided_);
  any_refused_ = any_refused_ || !holds;
  any_undecided_ = any_undecided_ || !undecided_.empty();
  refused_.clear();
  undecided_.clear();
  return holds;
}

std::string nearest_text(double left, const char* unit) {
  return std::isinf(left) ? "none is near" : text("the nearest has ", left, " ", unit, " left");
}

void for_each_row(std::size_t count, const std::function<void(std::size_t)>& row) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      row(i);
    }
  };
  std::vector<std::thread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) {
    threads.emplace_back(work);
  }
  work();
  for (std::thread& thread : threads) {
    thread.join();
  }
}

}  // namespace robot_check

int main(int count, char** arguments) {
  return robot_check::run(count, arguments);
}
