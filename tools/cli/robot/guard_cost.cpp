// What the periods of flashbvh guard cost on a core.
#include <algorithm>
#include <cmath>

#include "cli/robot/guard_output.hpp"
#include "robot/replay/period_costs.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {

Json cost_json(const GuardedTrajectory& guarded, const std::string& core, double a_period) {
  const PeriodCosts& of = kPeriodCosts.at(core);
  const Robot& robot = guarded.robot();
  double without_work = of.period + of.joint * robot.joint_count + of.pair * robot.pair_count;
  for (std::uint32_t i = 0; i < robot.pair_count; ++i) {
    without_work += of.between * (robot.pairs[i].joints_a + robot.pairs[i].joints_b);
  }
  // With work, the guard makes frames, and looks at all pairs again.
  const double measuring = without_work + of.frames / 6 * robot.joint_count;
  const auto row = [&](const char* periods, double with_work, double work) -> Json {
    const std::int64_t fixed = std::llround(without_work + with_work * measuring);
    const std::int64_t of_work = std::llround(work * of.work);
    return {{"periods", periods},
            {"instructions", fixed + of_work},
            {"fixed", fixed},
            {"of_work", of_work}};
  };
  const ReplaySummary summary = summary_of(guarded.answers);
  const double fits = (a_period - without_work - measuring) / of.work;
  return {{"core", of.core},
          {"a_work", std::llround(of.work)},
          {"costs",
           {row("mean", summary.with_work, summary.mean),
            row("99.9 %", summary.percentile_999 != 0, summary.percentile_999),
            row("most", summary.most != 0, summary.most)}},
          {"most_work", summary.most},
          {"a_period", static_cast<std::int64_t>(a_period)},
          {"work", static_cast<std::int64_t>(std::clamp(fits, 0.0, double{kAllWork}))}};
}

void print_cost(const Json& cost) {
  const auto share_of = [](const char* part) {
    return Column{"",
                  [part](const Json& row) {
                    const double all = row["instructions"];
                    return fixed(100 * row[part].get<double>() / all, 0) + " %";
                  },
                  true};
  };
  std::cout << "\n";
  print_table(cost["costs"],
              {word_column(cost["core"].get_ref<const std::string&>().c_str(), "periods"),
               number_column("instructions", "instructions"), number_column("fixed", "fixed"),
               share_of("fixed"), number_column("work", "of_work"), share_of("of_work")});
  std::cout << cost["work"] << " work fits a period of " << cost["a_period"] << " instructions";
  if (cost["work"] >= cost["most_work"]) {
    std::cout << ", and all periods here";
  } else {
    std::cout << ", too little for some here, which take up to " << cost["most_work"]
              << " and would be `not yet known`; take a faster --clock or fewer --hz, or bake with "
                 "--simplify or a larger --zone";
  }
  std::cout << "\nan estimate, by what a KUKA KR5 takes for a unit of work: links of few triangles "
               "take more; leave room, and count yours there\n";
}

}  // namespace flashbvh::tool
