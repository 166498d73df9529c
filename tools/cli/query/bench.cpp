// flashbvh bench: runs the paper's evaluation, section 9, on this machine.
#include <algorithm>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/table.hpp"
#include "evaluate/run.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::uint32_t kScalability = 6;  // the table that figure 33 plots

struct BenchArguments {
  std::vector<std::uint32_t> tables;
  Effort effort;

  bool wants(std::uint32_t table) const {
    return tables.empty() || std::find(tables.begin(), tables.end(), table) != tables.end();
  }
};

/// A column of text, aligned as numbers are.
Column time_column(const std::string& heading) {
  return {heading, [heading](const Json& row) { return row[heading].get<std::string>(); }, true};
}

/// A setup's part of its table, in the paper's columns.
void print_setup(const SetupResult& result) {
  Json rows = Json::array();
  for (const Row& row : result.rows) {
    const Times times = times_of(row.seconds);
    rows.push_back({{"algorithm", row.name},
                    {"min.", fixed(times.least, 7)},
                    {"max.", fixed(times.most, 7)},
                    {"mean", fixed(times.mean, 7)},
                    {"std. deviation", fixed(times.deviation, 7)},
                    {"iterations", row.counts.visits},
                    {"overlaps", row.counts.overlaps},
                    {"leaf overlaps", row.counts.leaf_pairs},
                    {"geometry overlaps", row.counts.triangle_pairs}});
  }
  std::cout << result.setup->name << " (seconds; repetitions: " << result.repetitions
            << ", rounds: " << result.rows[0].seconds.size() << ")\n\n";
  std::vector<Column> columns = {word_column("algorithm", "algorithm")};
  for (const char* const heading : {"min.", "max.", "mean", "std. deviation"}) {
    columns.push_back(time_column(heading));
  }
  for (const char* const heading :
       {"iterations", "overlaps", "leaf overlaps", "geometry overlaps"}) {
    columns.push_back(number_column(heading, heading));
  }
  print_table(rows, columns);
  std::cout << "\n" << std::flush;
}

/// The data of figure 33: the mean time of each row over the number of faces. `results`: table 6.
void print_figure_33(const std::vector<SetupResult>& results) {
  Json rows = Json::array();
  std::vector<Column> columns = {number_column("faces", "faces")};
  for (const SetupResult& result : results) {
    rows.push_back({{"faces", result.setup->a.faces()}});
    for (const Row& row : result.rows) {
      rows.back()[row.name] = fixed(times_of(row.seconds).mean / result.repetitions, 7);
      if (rows.size() == 1) {
        columns.push_back(time_column(row.name));
      }
    }
  }
  std::cout << "Figure 33: mean seconds of one query over faces\n\n";
  print_table(rows, columns);
}

/// kCheckFailed if rows of a setup found different overlaps.
ExitCode run_bench(const BenchArguments& arguments) {
  const double scale = arguments.effort.repetitions_scale;
  if (!(scale > 0 && scale <= 1000)) {
    throw UserError("--repetitions-scale", "must lie above 0 and at most at 1000; see --help");
  }
  Objects objects;
  std::vector<SetupResult> scalability;
  std::uint32_t table = 0;
  ExitCode exit_code = kSuccess;
  for (const scene::Setup& setup : scene::kSetups) {
    if (!arguments.wants(setup.table)) {
      continue;
    }
    if (setup.table != table) {
      table = setup.table;
      std::cout << "Table " << table << ": " << scene::table_title(table) << "\n\n";
    }
    const SetupResult result = run_setup(setup, arguments.effort, objects);
    print_setup(result);
    if (!result.rows_agree()) {
      std::cerr << "flashbvh: " << setup.name << ": the algorithms found different overlaps\n";
      exit_code = kCheckFailed;
    }
    if (table == kScalability) {
      scalability.push_back(result);
    }
  }
  if (!scalability.empty()) {
    print_figure_33(scalability);
  }
  return exit_code;
}

}  // namespace

void add_bench(CLI::App& app) {
  auto [command, a] = add_command<BenchArguments>(
      app, "bench", "Repeat the paper's evaluation, section 9, tables 2 to 8, on this machine.",
      run_bench);
  add_option(command, "--table", a.tables, "N", "Only this table; may be given more than once")
      ->check(CLI::Range(scene::kFirstTable, scene::kLastTable));
  add_option(command, "--repetitions-scale", a.effort.repetitions_scale, "F",
             "Part of the paper's repetitions to make for each sample; default 0.01");
  add_option(command, "--rounds", a.effort.rounds, "N", "Samples; default 10, the paper: 100")
      ->check(CLI::Range(1u, 1000000u));
  add_example(command, "bench --table 2 --rounds 1",
              "prints the times of table 2, each taken once");
}

}  // namespace flashbvh::tool
