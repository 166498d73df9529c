// flashbvh bench: the paper's evaluation, section 9, on this machine.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "cli/options.hpp"
#include "cli/outputs.hpp"
#include "evaluate/figure.hpp"
#include "evaluate/firmware_writer.hpp"
#include "evaluate/run.hpp"
#include "evaluate/tables.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

struct BenchArguments {
  std::vector<std::uint32_t> tables;
  Effort effort;
  FirmwareOptions firmware;
  std::string svg;
  std::string builder = "median";
  bool json = false;

  bool wants(std::uint32_t table) const {
    return tables.empty() || std::find(tables.begin(), tables.end(), table) != tables.end();
  }
};

void check(const BenchArguments& arguments) {
  if (!std::isfinite(arguments.effort.repetitions_scale) ||
      !(arguments.effort.repetitions_scale > 0) || arguments.effort.repetitions_scale > 1000) {
    throw UserError("--repetitions-scale", "must lie above 0 and at most at 1000; see --help");
  }
  if (!arguments.svg.empty() && !arguments.wants(kScalabilityTable)) {
    throw UserError("--svg", "draws table 6; add --table 6");
  }
  check_output(arguments.svg, {});
}

/// What all objects of one setup begin with.
Json json_head(const SetupResult& result, const std::string& algorithm) {
  const scene::Setup& setup = *result.setup;
  return {{"table", setup.table},
          {"setup", setup.name},
          {"faces_a", setup.a.faces()},
          {"faces_b", setup.b.faces()},
          {"algorithm", algorithm}};
}

void print_json(const SetupResult& result) {
  for (const RowResult& row : result.rows) {
    Json line = json_head(result, row.algorithm);
    line.update({{"repetitions", result.repetitions},
                 {"rounds", result.rounds},
                 {"seconds",
                  {{"min", row.times.least},
                   {"max", row.times.most},
                   {"mean", row.times.mean},
                   {"deviation", row.times.deviation}}},
                 {"visits", row.counts.visits},
                 {"overlaps", row.counts.overlaps},
                 {"leaf_pairs", row.counts.leaf_pairs},
                 {"triangle_pairs", row.counts.triangle_pairs}});
    print_object(line);
  }
  if (result.best_rule) {
    Json line = json_head(result, "best rule");
    line["visits"] = *result.best_rule;
    print_object(line);
  }
}

void print_json(const Totals& totals) {
  const Json line = {{"summary",
                      {{"volume_stack_visits", totals.volume},
                       {"stackless_visits", totals.alternating},
                       {"leaf_visits", totals.leaf},
                       {"ranked_visits", totals.ranked},
                       {"ranked_to_volume", ratio(totals.ranked, totals.volume)},
                       {"worst_ranked_to_volume", totals.worst_ranked},
                       {"best_rule_to_volume", ratio(totals.best, totals.volume_by_best)}}}};
  print_object(line);
}

Json json_of(const DefaultTreeVisits& visits) {
  return {{"stackless_visits_paper_tree", visits.stackless},
          {"ranked_visits", visits.ranked},
          {"best_rule_visits", visits.best_rule},
          {"ranked_to_stackless", visits.ranked_to_stackless()},
          {"ranked_to_best", visits.ranked_to_best()}};
}

void print_json(const std::vector<DefaultTreeResult>& results) {
  for (const DefaultTreeResult& result : results) {
    Json line = {{"table", result.setup->table},
                 {"setup", result.setup->name},
                 {"intersecting", result.intersecting}};
    line["default_tree"] = json_of(result.visits);
    print_object(line);
  }
  const Json line = {{"default_tree_totals",
                      {{"intersecting", json_of(sum_of(results, true))},
                       {"all", json_of(sum_of(results, false))}}}};
  print_object(line);
}

void print_text(const SetupResult& result, bool first_of_table) {
  if (first_of_table) {
    std::cout << table_heading(result.setup->table) << "\n";
  }
  std::cout << setup_table(result) << "\n" << std::flush;
}

/// False if the rows of a setup found different overlaps.
bool run_all(const BenchArguments& arguments) {
  Objects objects;
  std::vector<SetupResult> results;
  std::vector<DefaultTreeResult> default_results;
  bool agree = true;
  for (const scene::Setup& setup : scene::kSetups) {
    if (!arguments.wants(setup.table)) {
      continue;
    }
    std::cerr << "table " << setup.table << ": " << setup.name << "\n";
    const bool first = results.empty() || results.back().setup->table != setup.table;
    results.push_back(run_setup(setup, arguments.effort, objects));
    default_results.push_back(compare_default_tree(setup, objects));
    if (arguments.json) {
      print_json(results.back());
    } else {
      print_text(results.back(), first);
    }
    if (!results.back().rows_agree()) {
      std::cerr << "flashbvh: " << setup.name << ": the algorithms found different overlaps\n";
      agree = false;
    }
  }
  if (arguments.json) {
    print_json(default_results);
    print_json(totals_of(results));
  } else {
    std::cout << summary_table(results) << "\n"
              << default_tree_table(default_results) << "\n"
              << time_table(results);
  }
  if (!arguments.svg.empty()) {
    write_file(arguments.svg, figure_33(results), flush_output);
  }
  return agree;
}

void add_firmware(CLI::App& command, FirmwareOptions& firmware) {
  CLI::Option* const folder =
      add_option(command, "--firmware", firmware.folder, "DIR",
                 "Instead, write the setups with 16-bit trees as C++ for firmware");
  const auto add = [&](const char* name, auto& value, const char* what) {
    command.add_option(name, value, what)->check(CLI::Range(1u, UINT32_MAX))->needs(folder);
  };
  add("--images", firmware.images, "Firmware images that share the setups; default 1");
  add("--max-faces", firmware.max_faces, "Leave out larger objects");
  add("--max-bytes", firmware.max_bytes, "Of the trees of an image; leave out what does not fit");
  for (const char* other : {"--table", "--svg", "--json"}) {
    folder->excludes(command.get_option(other));
  }
}

}  // namespace

void add_bench(CLI::App& app, ExitCode& exit_code) {
  const auto arguments = std::make_shared<BenchArguments>();
  BenchArguments& a = *arguments;
  CLI::App* const command = app.add_subcommand(
      "bench", "Repeat the paper's evaluation, section 9, tables 2 to 8, on this machine.");
  add_option(*command, "--table", a.tables, "N", "Only this table; may be given more than once")
      ->check(CLI::Range(scene::kFirstTable, scene::kLastTable));
  add_option(*command, "--repetitions-scale", a.effort.repetitions_scale, "F",
             "Part of the paper's repetitions to make for each sample; default 0.01");
  add_option(*command, "--rounds", a.effort.rounds, "N", "Samples; default 10, the paper: 100")
      ->check(CLI::Range(1u, 1000000u));
  command->add_option("--builder", a.builder, "How the trees are split; default median")
      ->check(CLI::IsMember({"median"}));
  add_option(*command, "--svg", a.svg, "FILE", "Draw table 6 as the paper's figure 33");
  add_json(*command, a.json, "One JSON object a row, and one for the summary");
  add_firmware(*command, a.firmware);
  command->callback([arguments, &exit_code] {
    check(*arguments);
    if (!arguments->firmware.folder.empty()) {
      write_firmware(arguments->firmware);
      return;
    }
    exit_code = run_all(*arguments) ? kSuccess : kCheckFailed;
  });
}

}  // namespace flashbvh::tool
