// flashbvh guard: runs a trajectory through firmware's guard on the desktop.
#include <algorithm>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/robot/guard_output.hpp"
#include "cli/robot/robot_options.hpp"
#include "cli/table.hpp"
#include "robot/pipeline/baked_robot.hpp"
#include "robot/replay/period_costs.hpp"
#include "text/files.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// The largest number of lines in tables and on standard error.
constexpr std::size_t kShownLines = 10;

/// In cells: rounding to the lattice moves points less than this; simplified links deviate more.
constexpr double kRounded = 2;

/// Prints which pairs are guarded, and the deviation of simplified links.
void print_head(const GuardedTrajectory& guarded) {
  for (const UnguardedPair& pair : guarded.file->unguarded()) {
    std::cout << "not guarded: " << names_of(guarded.model, {pair}) << "\n";
  }
  std::cout << guarded.answers.size() << (guarded.answers.size() == 1 ? " period, " : " periods, ")
            << guarded.robot().pair_count << (guarded.robot().pair_count == 1 ? " pair" : " pairs")
            << " of links guarded\n";
  const double deviation = links_deviation(guarded.robot());
  if (deviation > kRounded * cell_of(guarded.robot())) {
    std::cout << "simplified: " << early_text(deviation) << "\n";
  }
  std::cout << "\n";
}

/// "first at line 3, upper - fore, at least 0.01 m apart".
std::string first_of_unknown(const GuardedTrajectory& guarded, const ReplaySummary& summary,
                             std::size_t kind) {
  std::string text = first_of(guarded, summary, kind);
  const GuardAnswer& answer = guarded.answers[summary.first[kind]];
  if (kind != static_cast<std::size_t>(Verdict::not_yet_known) || answer.pair == kNoPair) {
    return text;
  }
  const double known = unit_length(answer.distance, cell_of(guarded.robot()));
  return text +
         (known == 0 ? ", of which nothing is known" : ", at least " + metres(known, 4) + " apart");
}

void print_counts(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  Json rows = Json::array();
  for (const std::size_t kind : kKindsInOrder) {
    const bool has_first = kind != 0 && summary.periods[kind] != 0;
    rows.push_back({{"verdict", kKindNames[kind]},
                    {"periods", summary.periods[kind]},
                    {"first", has_first ? first_of_unknown(guarded, summary, kind) : ""}});
  }
  print_table(rows, {word_column("verdict", "verdict"), number_column("periods", "periods"),
                     word_column("", "first")});
}

/// Prints what limit() made of the lines.
void print_limits(const GuardedTrajectory& guarded) {
  std::cout << "\n";
  print_table(limits_json(guarded),
              {word_column("limit", "verdict"),
               number_column("periods", "periods"),
               {"", [](const Json& row) {
                  return row["line"].is_null()
                             ? ""
                             : concat("first at line ", row["line"].dump(),
                                      row["a"].is_null() ? "" : ", " + pair_text(row),
                                      row["touches"] == true
                                          ? ", which touch: only release() lets them apart"
                                          : "");
                }}});
}

/// Prints the stretches that are not free.
void print_stretches(const GuardedTrajectory& guarded) {
  const std::vector<Stretch> stretches =
      stretches_of(guarded.robot(), guarded.trajectory, guarded.answers);
  if (stretches.empty()) {
    return;
  }
  std::vector<Column> columns = {
      number_column("from", "from"),
      number_column("to", "to"),
      word_column("verdict", "verdict"),
      number_column("known mm", "distance", 4, 1000),
      number_column("closest mm", "closest", 4, 1000),
      {"links", [](const Json& row) { return row["a"].is_null() ? "-" : pair_text(row); }}};
  if (!guarded.trajectory.times.empty()) {
    columns.push_back({guarded.trajectory.time_name, [](const Json& row) {
                         return shortest(row["from_time"]) + " to " + shortest(row["to_time"]);
                       }});
  }
  std::cout << "\n";
  print_table(stretches_json(guarded, worst_of(stretches, kShownLines)), columns);
  if (stretches.size() > kShownLines) {
    std::cout << "and " << stretches.size() - kShownLines << " more: --report has a table\n";
  }
}

void print_closest(const GuardedTrajectory& guarded) {
  const auto closest = closest_moment(guarded.robot(), guarded.trajectory);
  if (!closest) {
    return;
  }
  const double distance = unit_length(closest->lower, cell_of(guarded.robot()));
  std::cout << "\nclosest: line " << guarded.trajectory.lines[closest->period] << ", "
            << links_of(guarded, closest->pair)
            << (distance == 0 ? " intersect" : ", " + metres(distance, 4)) << "\n";
}

void print_work(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  if (summary.is_primed) {
    std::cout << "work: " << summary.priming << " to prime; a period " << fixed(summary.mean, 1)
              << " on average, " << summary.percentile_999 << " at the 99.9th percentile, at most "
              << summary.most << "\n";
  }
}

/// "to line 5: upper - fore hit 0.3 of the way on, at turn 0, fold 2.9".
std::string motion_text(const Json& motion) {
  const std::string line = concat("  to line ", motion["to"].dump(), ": ");
  if (motion["outcome"] == "refused") {
    return line + "refused";
  }
  return concat(line, pair_text(motion), " ", motion["outcome"].get<std::string>(), " ",
                significant(motion["part"], 4), " of the way on, at ",
                joined(motion["values"].items(), [](const auto& value) {
                  return value.key() + " " + significant(value.value().template get<double>(), 6);
                }));
}

void print_motions(const GuardedTrajectory& guarded) {
  const Json others = motions_json(guarded);
  std::cout << "\nmotions from line to line: " << guarded.motions.size() - others.size()
            << " free, " << others.size() << " not\n";
  for (std::size_t i = 0; i < std::min(others.size(), kShownLines); ++i) {
    std::cout << motion_text(others[i]) << "\n";
  }
  if (others.size() > kShownLines) {
    std::cout << "  and " << others.size() - kShownLines << " more: --json has all\n";
  }
}

/// Prints values that firmware refuses to standard error.
void print_refused(const GuardedTrajectory& guarded) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < guarded.answers.size(); ++i) {
    if (guarded.answers[i].status != Status::done && ++refused <= kShownLines) {
      const std::string place = at_line(guarded.path, guarded.trajectory.lines[i]);
      std::cerr << "flashbvh: " << one_line(place + ": " + why_refused(guarded, i)) << "\n";
    }
  }
  if (refused > kShownLines) {
    std::cerr << "flashbvh: " << one_line(guarded.path) << ": and " << refused - kShownLines
              << " more lines with values that are refused\n";
  }
}

void print_guarded(const GuardedTrajectory& guarded) {
  print_head(guarded);
  print_counts(guarded);
  if (!guarded.limits.empty()) {
    print_limits(guarded);
  }
  print_stretches(guarded);
  print_closest(guarded);
  print_work(guarded);
  if (!guarded.cost.is_null()) {
    print_cost(guarded.cost);
  }
  if (guarded.has_motions) {
    print_motions(guarded);
  }
}

/// kCheckFailed if any period is `stop` or `not_yet_known`, or `leaving` without limit(), or a
/// motion is not free; kRefusedValues if firmware refuses any values.
ExitCode exit_code_of(const GuardedTrajectory& guarded) {
  const Verdict best = guarded.limits.empty() ? Verdict::warn : Verdict::leaving;
  bool is_free_all = std::all_of(guarded.motions.begin(), guarded.motions.end(), is_free);
  for (const GuardAnswer& answer : guarded.answers) {
    if (answer.status != Status::done) {
      return kRefusedValues;
    }
    is_free_all = is_free_all && answer.verdict <= best;
  }
  return is_free_all ? kSuccess : kCheckFailed;
}

struct GuardArguments : RobotRequest {
  std::string trajectory;
  std::string page;
  std::string limit;
  std::uint32_t work = kAllWork;
  std::string core;
  double hz = 0;
  double clock = 0;
  bool motion = false;
  bool json = false;
};

/// Opens an image. UserError if it is none, or if options for baking were given.
GuardedTrajectory opened(const GuardArguments& arguments, const CLI::App& command,
                         Warnings& warnings) {
  const std::string& path = arguments.urdf;
  for (const char* const option : {"--package", "--stop", "--warn"}) {
    if (command.count(option) != 0) {
      throw UserError(path, "is baked already, ", option,
                      " is for a URDF; leave it out, or bake again with `flashbvh robot`");
    }
  }
  auto file = std::make_unique<RobotFile>(path);
  Model model = file->model();
  warn_of_unguarded(model, file->unguarded(), path, warnings);
  Trajectory trajectory = read_trajectory(arguments.trajectory, model, warnings);
  return {std::move(model), std::move(file), arguments.trajectory, std::move(trajectory),
          std::vector{path, arguments.trajectory}};
}

/// Bakes a URDF, once the trajectory is read.
GuardedTrajectory baked(const GuardArguments& arguments, Warnings& warnings) {
  Model model = described_robot(arguments, warnings);
  Trajectory trajectory = read_trajectory(arguments.trajectory, model, warnings);
  std::vector<std::string> inputs = files_read(arguments, model);
  inputs.push_back(arguments.trajectory);
  Progress progress(steps_of(model));
  BakedRobot robot = baked_robot(std::move(model), arguments, shown_by(progress), warnings);
  const std::string bytes = as_bytes(image_of(robot, robot.model.name));
  return {std::move(robot.model), std::make_unique<RobotFile>(arguments.urdf, bytes),
          arguments.trajectory, std::move(trajectory), std::move(inputs)};
}

ExitCode guard_trajectory(const GuardArguments& arguments, const CLI::App& command) {
  Warnings warnings;
  GuardedTrajectory guarded = is_robot_file_name(arguments.urdf)
                                  ? opened(arguments, command, warnings)
                                  : baked(arguments, warnings);
  guarded.wanted = arguments.limit.empty() ? Trajectory() : guarded.trajectory;
  guarded.answers =
      arguments.limit.empty()
          ? replay(guarded.robot(), guarded.trajectory, arguments.work)
          : replay_limited(guarded.robot(), guarded.trajectory, arguments.work, guarded.limits);
  if (!arguments.core.empty()) {
    guarded.cost = cost_json(guarded, arguments.core, arguments.clock * 1e6 / arguments.hz);
  }
  guarded.has_motions = arguments.motion;
  if (arguments.motion) {
    guarded.motions = certify(guarded.robot(), guarded.trajectory);
  }
  FileSet files(guarded.inputs);
  if (!arguments.limit.empty()) {
    files.add(arguments.limit, trajectory_csv(guarded));
  }
  if (!arguments.page.empty()) {
    files.add(arguments.page, guard_page(guarded));
  }
  files.write([&] {
    warnings.print();
    print_refused(guarded);
    (arguments.json ? print_guarded_json : print_guarded)(guarded);
  });
  return exit_code_of(guarded);
}

}  // namespace

void add_guard(CLI::App& app) {
  auto [command, a] = add_command<GuardArguments>(
      app, "guard",
      "Print what a robot's guard answers along a trajectory, by the firmware's own code.\n"
      "Exit code 0: all periods are free or warned of; 1: in some the guard says stop or leaving,\n"
      "or the work budget was too small, or a motion is not free; 3: firmware refuses some "
      "values.\n"
      "With --limit, leaving is no failure.",
      [&app](const GuardArguments& given) {
        return guard_trajectory(given, *app.get_subcommand("guard"));
      });
  add_described_options(command, "ROBOT", a);
  command.get_option("ROBOT")->description(
      "The robot's image (.robot), or the robot (URDF), baked as by `flashbvh robot`");
  add_distances(command, a);
  add_option(command, "TRAJECTORY", a.trajectory, "FILE.csv",
             "A CSV: a line with the joints' names, then one a period with their values, in "
             "radians\nand metres")
      ->required();
  add_option(command, "--work", a.work, "N",
             "What the guard may spend in a period; default: what it takes")
      ->check(CLI::Range(1u, kAllWork));
  CLI::Option* const core =
      command
          .add_option("--core", a.core,
                      "Estimate the instructions of these periods on this core, and the work that "
                      "fits one of --hz and --clock")
          ->transform(CLI::IsMember(kPeriodCosts, CLI::ignore_case));
  CLI::Option* const hz = add_option(command, "--hz", a.hz, "HZ", "Periods a second");
  CLI::Option* const clock = add_option(command, "--clock", a.clock, "MHZ",
                                        "The core's clock; an instruction counts as a cycle");
  for (CLI::Option* const needed : {hz, clock}) {
    core->needs(needed->check(CLI::Range(1.0, 1e6))->needs(core));
  }
  add_option(
      command, "--limit", a.limit, "GRANTED.csv",
      "Let the robot go as far towards each line as no pair comes nearer than its stop distance,\n"
      "or gets deeper; write the values granted, and guard these; --work is for each of both calls")
      ->excludes("--core");
  command.add_flag("--motion", a.motion,
                   "Certify the straight motion of all joints from each line to the next, too");
  add_option(command, "--report", a.page, "PAGE.html",
             "Write a page: the robot on its way, distances and work over time, motions");
  command.add_flag("--json", a.json, "One JSON object a line");
  add_example(command, "guard arm.urdf motion.csv --stop 0.005 --warn 0.03",
              "prints how many periods are free, warned, stopped");
}

}  // namespace flashbvh::tool
