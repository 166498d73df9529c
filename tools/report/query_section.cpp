#include "report/sections.hpp"

#include <algorithm>

#include "evaluate/queries.hpp"
#include "report/html.hpp"
#include "report/visits.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// Pairs of different images that are asked about.
constexpr std::size_t kMostPairs = 6;

bool can_be_queried(const Subject& a, const Subject& b) {
  return a.image.tree().index() == b.image.tree().index() && a.image.cell() == b.image.cell();
}

std::vector<SubjectPair> all_pairs(const std::vector<const Subject*>& subjects) {
  std::vector<SubjectPair> pairs;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    for (std::size_t j = i + 1; j < subjects.size(); ++j) {
      if (can_be_queried(*subjects[i], *subjects[j])) {
        pairs.emplace_back(subjects[i], subjects[j]);
      }
    }
  }
  return pairs;
}

std::vector<std::string> row_of(const std::string& name, const Visits& visits, std::uint64_t most) {
  if (visits.poses == 0) {
    return {name, "0", "&ndash;", "&ndash;", ""};
  }
  const double mean = static_cast<double>(visits.sum) / static_cast<double>(visits.poses);
  const auto share = [&](double count) {
    return fixed(100 * count / static_cast<double>(most), 1) + "%";
  };
  return {name, grouped(visits.poses), grouped((visits.sum + visits.poses / 2) / visits.poses),
          grouped(visits.most),
          "<div class=\"row over\"><span class=inner style=\"width:" +
              share(static_cast<double>(visits.most)) +
              "\"></span><span class=leaf style=\"width:" + share(mean) + "\"></span></div>"};
}

std::string title_of(const SubjectPair& pair) {
  const std::string a = escaped(pair.first->name);
  return pair.first == pair.second ? a + " and a second " + a
                                   : a + " and " + escaped(pair.second->name);
}

std::string note(const std::string& text) {
  return "<p class=note>" + text + "</p>\n";
}

/// Why there may be fewer poses than wanted.
std::string shortfall(const VisitSample& sample) {
  if (sample.costly) {
    return note("Stopped after " + grouped(kMostVisits) +
                " visits in all: there may be fewer poses.");
  }
  return sample.out_of_range == 0
             ? ""
             : note(counted(sample.out_of_range, "pose", "poses") +
                    " passed over: a mesh lies so far from its origin that rotating it about its "
                    "middle takes a translation out of range.");
}

}  // namespace

std::vector<SubjectPair> asked_pairs(const std::vector<const Subject*>& subjects) {
  std::vector<SubjectPair> pairs(subjects.size());
  std::transform(subjects.begin(), subjects.end(), pairs.begin(),
                 [](const Subject* subject) { return SubjectPair(subject, subject); });
  const std::vector<SubjectPair> different = all_pairs(subjects);
  const auto count = static_cast<std::ptrdiff_t>(std::min(different.size(), kMostPairs));
  pairs.insert(pairs.end(), different.begin(), different.begin() + count);
  return pairs;
}

std::string pair_section(const SubjectPair& pair, std::size_t poses) {
  const VisitSample sample = sample_visits(pair.first->image, pair.second->image, poses);
  std::uint64_t most = 1;
  for (const Visits& visits : sample.all) {
    most = std::max(most, visits.most);
  }
  const std::vector<std::vector<std::string>> rows = {
      row_of("separated", sample.all[kSeparated], most),
      row_of("small proximity", sample.all[kSmallProximity], most),
      row_of("close proximity", sample.all[kCloseProximity], most),
      row_of("intersecting", sample.all[kIntersecting], most),
      row_of("intersecting, to the first pair", sample.first, most)};
  return "<div class=\"pair hist\">\n" +
         table(title_of(pair) + " <small>" + default_traversal(pair.first->image.layout()) +
                   "</small>",
               {{"class", false},
                {"poses", true},
                {"<i class=\"key leaf\"></i>mean", true},
                {"<i class=\"key inner\"></i>maximum", true},
                {"<span class=hide>bar</span>", false}},
               rows) +
         shortfall(sample) + "</div>\n";
}

std::string query_note(const std::vector<const Subject*>& subjects, std::size_t poses) {
  const std::size_t different = subjects.size() * (subjects.size() - 1) / 2;
  const std::size_t possible = all_pairs(subjects).size();
  std::string html =
      "<p>Visits, the pairs of boxes that a query tests, in random poses: B rotated by any "
      "rotation, the middle of its box in any direction from that of A, at any distance up to the "
      "sum of half their diagonals. Of each class the first " +
      grouped(poses) + " among " + grouped(kTries * poses) +
      " such poses, always the same.</p>\n<dl class=terms>\n"
      "<div><dt>separated</dt><dd>the boxes of the two meshes are disjoint</dd></div>\n"
      "<div><dt>small proximity</dt><dd>boxes overlap, but of no two leaves</dd></div>\n"
      "<div><dt>close proximity</dt><dd>boxes of leaves overlap, but no two triangles "
      "intersect</dd></div>\n"
      "<div><dt>intersecting</dt><dd>triangles intersect: up to the last pair of them, or to the "
      "first</dd></div>\n</dl>\n";
  if (possible < different) {
    html += note(counted(different - possible, "pair", "pairs") +
                 " can&#39;t be queried: baked with another cell, layout or index width.");
  }
  if (possible > kMostPairs) {
    html += note("Of " + grouped(possible) + " pairs of different meshes, the first " +
                 grouped(kMostPairs) + ".");
  }
  return html;
}

}  // namespace flashbvh::tool
