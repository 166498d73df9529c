#include "report/page.hpp"

#include <algorithm>
#include <filesystem>

#include "evaluate/queries.hpp"
#include "report/html.hpp"
#include "report/standing.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;

/// The largest number of pairs queried at random poses: all pairs of twelve meshes.
constexpr std::size_t kMostPairs = 66;

std::vector<QueriedPair> partners(const Subjects& subjects) {
  std::vector<QueriedPair> pairs;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    for (std::size_t j = i + 1; j < subjects.size(); ++j) {
      if (pairs.size() < kMostPairs && are_partners(subjects[i]->image, subjects[j]->image)) {
        pairs.push_back({subjects[i], subjects[j], {}, {}, {}});
      }
    }
  }
  return pairs;
}

QueriedPair at_poses(const Subject& a, const Subject& b, const std::string& path) {
  check_partners(a.image, b.image);
  return {&a, &b, costs_at(a.image, b.image, path), {}, {}};
}

/// Reads a file A-B for each queried pair.
std::vector<QueriedPair> at_poses_of_folder(const Subjects& subjects, const std::string& folder) {
  std::vector<QueriedPair> pairs;
  for (const Subject* const a : subjects) {
    for (const Subject* const b : subjects) {
      const fs::path file = fs::path(folder) / (a->name + "-" + b->name);
      if (fs::exists(file)) {
        pairs.push_back(at_poses(*a, *b, file.string()));
      }
    }
  }
  if (pairs.empty()) {
    const std::string example = subjects.front()->name + "-" + subjects.back()->name;
    throw UserError(folder, "has poses of no two of the images; name a file after them: ", example);
  }
  return pairs;
}

std::string title_of(const Subjects& subjects) {
  if (subjects.size() > 2) {
    return counted(subjects.size(), "mesh", "meshes");
  }
  return escaped(subjects[0]->name) +
         (subjects.size() == 1 ? "" : " and " + escaped(subjects[1]->name));
}

/// All pairs that can be queried, or the first few. A single mesh is queried against its copy.
std::vector<QueriedPair> queried_pairs(const Subjects& subjects, const ReportOptions& options,
                                       const OnStep& step) {
  if (!options.poses.empty()) {
    step("querying", static_cast<double>(subjects.size()));
    if (fs::is_directory(options.poses)) {
      return at_poses_of_folder(subjects, options.poses);
    }
    if (subjects.size() > 2) {
      throw UserError(options.poses, "has poses of a second image in a first one's frame, and ",
                      subjects.size(),
                      " are given; give two, or a folder with a file A-B for "
                      "each pair of them");
    }
    return {at_poses(*subjects.front(), *subjects.back(), options.poses)};
  }
  std::vector<QueriedPair> pairs = partners(subjects);
  if (subjects.size() == 1) {
    pairs.push_back({subjects[0], subjects[0], {}, {}, {}});
  }
  for (QueriedPair& pair : pairs) {
    step("querying " + pair.a->name + " and " + pair.b->name,
         static_cast<double>(subjects.size()) / static_cast<double>(pairs.size()));
    pair.costs = sampled_costs(pair.a->image, pair.b->image, options.samples);
  }
  return pairs;
}

/// The main results: whether the meshes touch; for a single mesh, whether it has an inside.
std::string decisions(const Subjects& subjects, const std::vector<QueriedPair>& pairs) {
  std::string html = standing_decisions(pairs);
  for (const Subject* const subject : subjects) {
    const std::size_t odd = subject->warnings.size();
    if (odd != 0 || subjects.size() == 1) {
      html += decision(odd == 0 ? "v0" : "v1",
                       escaped(subject->name) + (odd == 0 ? " is a closed surface" : " is odd"),
                       odd == 0 ? "" : subject->warnings[0].text);
    }
  }
  return decision_section("", html);
}

}  // namespace

std::string title_of(const QueriedPair& pair) {
  const std::string a = escaped(pair.a->name);
  return a + (pair.a == pair.b ? " and a second " + a : " and " + escaped(pair.b->name));
}

const QueriedPair& costliest(const std::vector<QueriedPair>& pairs) {
  return *std::max_element(pairs.begin(), pairs.end(),
                           [](const QueriedPair& p, const QueriedPair& q) {
                             return std::pair(p.costs.needed.most, p.costs.bound.work) <
                                    std::pair(q.costs.needed.most, q.costs.bound.work);
                           });
}

std::string page_of(const std::vector<std::unique_ptr<ImageFile>>& images,
                    const ReportOptions& options, const OnStep& step) {
  std::vector<std::string> paths(images.size());
  std::transform(images.begin(), images.end(), paths.begin(),
                 [](const auto& image) { return image->path(); });
  const std::vector<std::string> names = unique_names(paths);
  std::vector<std::unique_ptr<Subject>> owned;
  Subjects subjects;
  for (std::size_t i = 0; i < images.size(); ++i) {
    owned.push_back(std::make_unique<Subject>(*images[i], i, names[i]));
    subjects.push_back(owned.back().get());
  }
  std::vector<QueriedPair> pairs = queried_pairs(subjects, options, step);
  for (QueriedPair& pair : pairs) {
    const bool is_given = !options.poses.empty();
    if (is_given || pair.a != pair.b) {
      pair.standings = standings_of(pair.a->image, pair.b->image,
                                    is_given ? pair.costs.poses : std::vector<PoseCost>());
    }
  }
  const std::string live = live_part(subjects, pairs);
  std::string html = decisions(subjects, pairs) + live + fit_section(subjects, pairs, options) +
                     pairs_section(subjects, pairs, options) + flash_table(subjects);
  for (const Subject* const subject : subjects) {
    step("describing " + subject->name, 1);
    html += image_section(*subject);
  }
  return page(title_of(subjects), "report", "meshes that answer; flash, RAM and time",
              html + foot(subjects));
}

}  // namespace flashbvh::tool
