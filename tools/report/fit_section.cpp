#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "report/html.hpp"
#include "report/page.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The bytes of a query and of a pose on a 32-bit core: lib/docs/figures.md, "what the caller
/// keeps"; with 32-bit indices the query takes eight bytes more.
constexpr std::uint64_t kQueryBytes = 128;
constexpr std::uint64_t kLargeQueryBytes = 136;
constexpr std::uint64_t kPoseBytes = 68;

/// Upper limits of a whole query, or of several queries one after the other.
struct Need {
  std::uint64_t work = 0;
  double instructions = 0;       ///< of a single run per query
  double cycles = 0;             ///< as in Budget::costs()
  std::uint64_t slice_work = 0;  ///< work of a run that fits a period; 0: no run fits
  std::size_t queries = 1;

  double share(const Budget& budget) const { return cycles / budget.cycles(); }
};

Need need_of(std::uint64_t work, const TreeSize& a, const TreeSize& b, const Budget& budget) {
  const auto period = static_cast<std::uint64_t>(std::min(budget.cycles(), 1e18));
  // A single run spends only the existing work.
  const auto most = [&](const RunCosts& costs) {
    return static_cast<double>(instructions_of_start(costs, a, b)) +
           static_cast<double>(work) * static_cast<double>(instructions_of_work(costs, a, b));
  };
  return {work, most(budget.core.costs), most(budget.costs()),
          work_within(period, budget.costs(), a, b)};
}

Need operator+(const Need& a, const Need& b) {
  return {a.work + b.work, a.instructions + b.instructions, a.cycles + b.cycles, 0,
          a.queries + b.queries};
}

/// "fits in 37 % of the period", "needs at most 4 slices of 888 work"; for several queries, "takes
/// at most 3.2 periods".
std::string verdict(const Need& need, const Budget& budget) {
  const double share = need.share(budget);
  if (share <= 1) {
    return "fits in " +
           (share < 0.001 ? "less than 0.1" : fixed(100 * share, share < 0.1 ? 1 : 0)) +
           " % of the period";
  }
  if (need.queries > 1) {
    return "takes at most " +
           (share < 10 ? fixed(share, 1) : grouped(static_cast<std::uint64_t>(std::ceil(share)))) +
           " periods";
  }
  if (need.slice_work == 0) {
    return "no slice fits: the period is too short";
  }
  const std::uint64_t slices = (need.work + need.slice_work - 1) / need.slice_work;
  return "needs at most " + counted(slices, "slice", "slices") + " of " + grouped(need.slice_work) +
         " work";
}

/// "0.37 ms"; without proven cycles, "roughly 0.37 ms".
std::string milliseconds(const Need& need, const Budget& budget) {
  const double time = need.cycles / (budget.mhz * 1e3);
  return (budget.core.cycles ? "" : "roughly ") +
         (time >= 100 ? grouped(static_cast<std::uint64_t>(std::llround(time)))
                      : significant(time, 2)) +
         " ms";
}

/// Upper limits of a query: at the given poses, and at any pose.
enum Case : std::uint8_t { kMean, kPercentile99, kCostliest, kAnyPose, kCaseCount };
constexpr std::array<const char*, kCaseCount> kCaseNames = {"mean of the poses", "99th percentile",
                                                            "costliest pose", "any pose, proven"};
using Needs = std::array<Need, kCaseCount>;

struct Query {
  const char* name;
  NeededWork PairCosts::*needed;
};
constexpr Query kQueries[] = {{"Do they touch?", &PairCosts::needed_to_first},
                              {"Which triangles?", &PairCosts::needed}};

Needs needs_of(const QueriedPair& pair, const Query& query, const Budget& budget) {
  const auto need = [&](std::uint64_t work) {
    return need_of(work, tree_size(pair.a->image.header()), tree_size(pair.b->image.header()),
                   budget);
  };
  const NeededWork& needed = pair.costs.*query.needed;
  return {need(static_cast<std::uint64_t>(std::llround(needed.mean))), need(needed.percentile_99),
          need(needed.most), need(pair.costs.bound.work)};
}

/// The sum of all pairs, one after the other.
Needs needs_of(const std::vector<QueriedPair>& pairs, const Query& query, const Budget& budget) {
  Needs all = needs_of(pairs[0], query, budget);
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    const Needs next = needs_of(pairs[i], query, budget);
    std::transform(all.begin(), all.end(), next.begin(), all.begin(), std::plus<>());
  }
  return all;
}

std::string tiles(const Subjects& subjects, const Budget& budget) {
  std::uint64_t flash = 0;
  bool large = false;
  for (const Subject* const subject : subjects) {
    flash += subject->flash;
    large = large || subject->image.header().index_bits == 32;
  }
  const std::uint64_t query = large ? kLargeQueryBytes : kQueryBytes;
  return facts(
      fact("Flash", grouped(flash) + " bytes", "images. The code of a query, once: some 10 KiB.") +
      fact("RAM", grouped(query + kPoseBytes) + " bytes",
           concat("a query object of ", query, " and a pose of ", kPoseBytes,
                  "; no heap, no static data. On the stack, in a run: at most 544 bytes, 708 on "
                  "a Cortex-M0.")) +
      fact("Period", significant(1e3 / budget.hz, 4) + " ms",
           significant(budget.hz, 6) + " Hz on a " + budget.core.name + " at " +
               significant(budget.mhz, 6) + " MHz: " +
               grouped(static_cast<std::uint64_t>(std::min(budget.cycles(), 1e18))) + " cycles."));
}

/// "1,234,567" or "38.9 million".
std::string large(double number) {
  return number < 1e7   ? grouped(static_cast<std::uint64_t>(number))
         : number < 1e9 ? significant(number / 1e6, 3) + " million"
                        : significant(number / 1e9, 3) + " billion";
}

/// A gauge; its full width is a period.
std::string card(const char* name, const Need& need, const Budget& budget) {
  const double share = need.share(budget);
  const char* const state = share <= 1 ? "in" : "beyond";
  return concat("<div class=\"card ", state, "\"><h4>", name, "</h4><b>", verdict(need, budget),
                "</b><div class=gauge><span style=\"width:", fixed(std::min(1.0, share) * 100, 1),
                "%\"></span></div><small>", grouped(need.work), " work<br>at most ",
                large(need.instructions), " instructions<br>",
                budget.core.cycles ? large(need.cycles) + " cycles, " : "",
                milliseconds(need, budget), "</small></div>\n");
}

std::string cards(const std::string& title, const Needs& needs, bool has_poses,
                  const Budget& budget) {
  std::string html = "<h3>" + title + "</h3>\n<div class=cards>\n";
  for (std::size_t i = has_poses ? kMean : kAnyPose; i < kCaseCount; ++i) {
    html += card(kCaseNames[i], needs[i], budget);
  }
  return html + "</div>\n";
}

/// The summary.
std::string answers(const std::vector<QueriedPair>& pairs, bool has_poses, const Budget& budget) {
  const char* const when = pairs.size() > 1 ? " for all pairs, each at its costliest pose"
                                            : " at the costliest of the poses";
  std::string html = "<ul class=verdict>\n";
  for (const Query& query : kQueries) {
    const Need need = needs_of(pairs, query, budget)[kCostliest];
    if (has_poses) {
      html += verdict_line(need.share(budget) <= 1 ? " class=good" : " class=bad", query.name,
                           " " + verdict(need, budget) + when);
    }
  }
  const Need bound = needs_of(pairs, kQueries[0], budget)[kAnyPose];
  const bool fits = bound.share(budget) <= 1;
  return html +
         verdict_line(
             fits ? " class=good" : " class=soft", "Any pose, proven:",
             " " + verdict(bound, budget) +
                 (fits ? "" : ", if all boxes overlapped, which no real pose comes near")) +
         "</ul>\n";
}

std::string pose_note(const std::vector<QueriedPair>& pairs, const ReportOptions& options) {
  if (!options.poses.empty()) {
    std::size_t poses = 0;
    for (const QueriedPair& pair : pairs) {
      poses += pair.costs.poses.size();
    }
    return counted(poses, "pose", "poses") + " as given.";
  }
  if (options.samples == 0) {
    return "No poses were given.";
  }
  return grouped(options.samples) +
         (pairs.size() == 1 ? " random poses" : " random poses of each pair") +
         ": the second mesh rotated by any rotation, its middle in any direction from that of the "
         "first, at any distance at which boxes can overlap. Your machine&#39;s poses are others: "
         "give them with <code>--poses</code>.";
}

/// The source of cycles and milliseconds.
std::string cycles_note(const Budget& budget) {
  return budget.core.cycles
             ? "Cycles are proven, too, by the core&#39;s manual, with " +
                   counted(flash_wait_states().at(budget.flash), "wait state", "wait states") +
                   " of the flash and no cache"
             : std::string(
                   "Milliseconds are rough: cycles of this core are not proven, an "
                   "instruction is taken for one, and wait states of the flash come on top");
}

std::string notes(const std::vector<QueriedPair>& pairs, const ReportOptions& options) {
  return note("Poses: " + pose_note(pairs, options)) +
         note(concat(
             "Instructions are upper bounds: work times the most that a unit of work "
             "can take on a ",
             options.budget.core.name,
             ", proven for GCC 12 at -O2 (<code>flashbvh/time_bound.hpp</code>). Queries on a "
             "robot&#39;s links were measured to take about a tenth of that "
             "(<code>lib/docs/figures.md</code>). ",
             cycles_note(options.budget),
             ". Making the query comes on top, once a pose. A "
             "slice is a call of <code>run(work)</code> that takes no longer than a period."));
}

}  // namespace

std::string fit_section(const Subjects& subjects, const std::vector<QueriedPair>& pairs,
                        const ReportOptions& options) {
  const Budget& budget = options.budget;
  if (pairs.empty()) {
    return section("fit", "", tiles(subjects, budget));
  }
  const QueriedPair& worst = costliest(pairs);
  const bool has_poses = !worst.costs.poses.empty();
  std::string html = answers(pairs, has_poses, budget) + tiles(subjects, budget);
  for (const Query& query : kQueries) {
    html +=
        cards(title_of(worst) + (pairs.size() > 1 ? ", the costliest pair: " : ": ") + query.name,
              needs_of(worst, query, budget), has_poses, budget);
  }
  for (const Query& query : kQueries) {
    if (pairs.size() > 1) {
      html += cards(concat("All ", pairs.size(), " pairs, each at its own: ", query.name),
                    needs_of(pairs, query, budget), has_poses, budget);
    }
  }
  return section("fit", "", html + notes(pairs, options));
}

}  // namespace flashbvh::tool
