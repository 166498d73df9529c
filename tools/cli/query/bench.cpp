// flashbvh bench: runs the paper's evaluation, section 9, on this machine.
#include <algorithm>
#include <iostream>

#include "cli/commands.hpp"
#include "evaluate/firmware_writer.hpp"
#include "evaluate/run.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

struct BenchArguments {
  std::vector<std::uint32_t> tables;
  Effort effort;
  FirmwareOptions firmware;

  bool wants(std::uint32_t table) const {
    return tables.empty() || std::find(tables.begin(), tables.end(), table) != tables.end();
  }
};

/// kCheckFailed if rows of a setup found different overlaps.
ExitCode run_all(const BenchArguments& arguments) {
  Objects objects;
  std::vector<SetupResult> results;
  ExitCode exit_code = kSuccess;
  for (const scene::Setup& setup : scene::kSetups) {
    if (!arguments.wants(setup.table)) {
      continue;
    }
    std::cerr << "table " << setup.table << ": " << setup.name << "\n";
    if (results.empty() || results.back().setup->table != setup.table) {
      std::cout << table_heading(setup.table) << "\n";
    }
    results.push_back(run_setup(setup, arguments.effort, objects));
    std::cout << setup_table(results.back()) << "\n" << std::flush;
    if (!results.back().rows_agree()) {
      std::cerr << "flashbvh: " << setup.name << ": the algorithms found different overlaps\n";
      exit_code = kCheckFailed;
    }
  }
  std::cout << summary_tables(results);
  return exit_code;
}

ExitCode run_bench(const BenchArguments& arguments) {
  const double scale = arguments.effort.repetitions_scale;
  if (!(scale > 0 && scale <= 1000)) {
    throw UserError("--repetitions-scale", "must lie above 0 and at most at 1000; see --help");
  }
  if (arguments.firmware.folder.empty()) {
    return run_all(arguments);
  }
  write_firmware(arguments.firmware);
  return kSuccess;
}

void add_firmware(CLI::App& command, FirmwareOptions& firmware) {
  CLI::Option* const folder =
      add_option(command, "--firmware", firmware.folder, "DIR",
                 "Instead, write the setups with 16-bit trees as C++ for firmware")
          ->excludes(command.get_option("--table"));
  const auto add = [&](const char* name, auto& value, const char* what) {
    command.add_option(name, value, what)->check(CLI::Range(1u, UINT32_MAX))->needs(folder);
  };
  add("--images", firmware.images, "Firmware images that share the setups; default 1");
  add("--max-bytes", firmware.max_bytes, "Of the trees of an image; leave out what does not fit");
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
  add_firmware(command, a.firmware);
  add_example(command, "bench --table 2 --rounds 1",
              "prints the times of table 2, each taken once");
}

}  // namespace flashbvh::tool
