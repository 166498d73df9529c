// flashbvh guard: runs a trajectory through firmware's guard on the desktop.
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "cli/robot/baked_robot.hpp"
#include "cli/robot/guard_output.hpp"
#include "cli/robot/robot_warnings.hpp"
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
  for (const UnguardedPair& pair : guarded.unguarded) {
    std::cout << "not guarded: " << names_of(guarded.model, {pair}) << "\n";
  }
  std::cout << guarded.answers.size() << (guarded.answers.size() == 1 ? " period, " : " periods, ")
            << guarded.robot.pair_count << (guarded.robot.pair_count == 1 ? " pair" : " pairs")
            << " of links guarded\n";
  const double deviation = links_deviation(guarded.robot);
  if (deviation > kRounded * cell_of(guarded.robot)) {
    std::cout << "simplified: firmware's links and the URDF's lie within "
              << significant(deviation, 3) << " m of each other, so the guard stops up to "
              << significant(kEarlyByDeviation * deviation, 3) << " m earlier\n";
  }
  std::cout << "\n";
}

std::string links_of(const GuardedTrajectory& guarded, std::uint16_t pair) {
  const RobotPair& links = guarded.robot.pairs[pair];
  return link_name(guarded, links.a) + " - " + link_name(guarded, links.b);
}

std::string metres_text(const GuardedTrajectory& guarded, std::uint32_t fine) {
  return significant(unit_length(fine, cell_of(guarded.robot)), 4);
}

/// "  first at line 3, upper - fore".
std::string first_of(const GuardedTrajectory& guarded, std::size_t kind, std::size_t first) {
  const GuardAnswer& answer = guarded.answers[first];
  std::string text = concat("  first at line ", guarded.trajectory.line(first));
  if (kind == kRefusedKind || answer.pair == kNoPair) {
    return text;
  }
  text += ", " + links_of(guarded, answer.pair);
  if (kind != static_cast<std::size_t>(Verdict::not_yet_known)) {
    return text;
  }
  return text + (answer.distance == 0
                     ? ", of which nothing is known"
                     : ", at least " + metres_text(guarded, answer.distance) + " m apart");
}

void print_counts(const GuardedTrajectory& guarded) {
  const ReplaySummary counts = summary_of(guarded.answers);
  for (const std::size_t kind : kKindsInOrder) {
    std::cout << std::left << std::setw(15) << kKindNames[kind] << std::right << std::setw(9)
              << counts.periods[kind]
              << (kind == 0 || counts.periods[kind] == 0
                      ? ""
                      : first_of(guarded, kind, counts.first[kind]))
              << "\n";
  }
}

/// "0.35 to 0.81".
std::string times_of_stretch(const GuardedTrajectory& guarded, const Stretch& stretch) {
  return shortest(guarded.trajectory.time(stretch.first)) + " to " +
         shortest(guarded.trajectory.time(stretch.last));
}

void print_stretch(const GuardedTrajectory& guarded, const Stretch& stretch) {
  const bool is_refused = stretch.pair == kNoPair;
  std::cout << std::left << std::setw(9) << guarded.trajectory.line(stretch.first) << std::setw(9)
            << guarded.trajectory.line(stretch.last) << std::setw(15) << kKindNames[stretch.kind]
            << std::setw(12) << (is_refused ? "-" : metres_text(guarded, stretch.kept))
            << std::setw(12) << (stretch.closest ? metres_text(guarded, *stretch.closest) : "-")
            << (is_refused ? "-" : links_of(guarded, stretch.pair))
            << (guarded.trajectory.has_times() ? "  " + times_of_stretch(guarded, stretch) : "")
            << "\n";
}

/// Prints the stretches that are not free.
void print_stretches(const GuardedTrajectory& guarded) {
  const std::vector<Stretch> stretches =
      stretches_of(guarded.robot, guarded.trajectory, guarded.answers);
  if (stretches.empty()) {
    return;
  }
  std::cout << "\nfrom     to       verdict        known m     closest m   links"
            << (guarded.trajectory.has_times() ? ", " + guarded.trajectory.time_name() : "")
            << "\n";
  for (const Stretch& stretch : worst_of(stretches, kShownLines)) {
    print_stretch(guarded, stretch);
  }
  if (stretches.size() > kShownLines) {
    std::cout << "and " << stretches.size() - kShownLines << " more: --report has a table\n";
  }
}

void print_closest(const GuardedTrajectory& guarded) {
  const auto closest = closest_moment(guarded.robot, guarded.trajectory);
  if (!closest) {
    return;
  }
  const double distance = unit_length(closest->clearance.lower, cell_of(guarded.robot));
  std::cout << "\nclosest: line " << guarded.trajectory.line(closest->period) << ", "
            << links_of(guarded, closest->pair)
            << (distance == 0 ? " intersect" : ", " + significant(distance, 4) + " m") << "\n";
}

void print_work(const GuardedTrajectory& guarded) {
  const ReplaySummary summary = summary_of(guarded.answers);
  if (summary.is_primed) {
    std::cout << "work: " << summary.priming << " to prime; a period " << fixed(summary.mean, 1)
              << " on average, " << summary.percentile_999 << " at the 99.9th percentile, at most "
              << summary.most << "\n";
  }
}

void print_motion(const GuardedTrajectory& guarded, std::size_t i) {
  const CertifiedMotion& motion = guarded.motions[i];
  std::cout << "  to line " << guarded.trajectory.line(i + 1) << ": ";
  if (motion.answer.status != Status::done) {
    std::cout << "refused\n";
    return;
  }
  std::cout << links_of(guarded, motion.answer.pair)
            << (motion.answer.outcome == MotionOutcome::hit ? " hit " : " close ")
            << significant(motion.part, 4) << " of the way on, at ";
  for (std::size_t v = 0; v < motion.values.size(); ++v) {
    std::cout << (v == 0 ? "" : ", ") << variable_name(guarded, v) << " "
              << significant(motion.values[v], 6);
  }
  std::cout << "\n";
}

void print_motions(const GuardedTrajectory& guarded) {
  const auto& motions = guarded.motions;
  const auto free = std::count_if(motions.begin(), motions.end(), is_free);
  const std::size_t others = motions.size() - static_cast<std::size_t>(free);
  std::cout << "\nmotions from line to line: " << free << " free, " << others << " not\n";
  std::size_t shown = 0;
  for (std::size_t i = 0; i < motions.size() && shown < kShownLines; ++i) {
    if (!is_free(motions[i])) {
      print_motion(guarded, i);
      ++shown;
    }
  }
  if (shown < others) {
    std::cout << "  and " << others - shown << " more: --json has all\n";
  }
}

/// Prints values that firmware refuses to standard error.
void print_refused(const GuardedTrajectory& guarded) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < guarded.answers.size(); ++i) {
    if (guarded.answers[i].status != Status::done && ++refused <= kShownLines) {
      std::cerr << "flashbvh: "
                << one_line(at_line(guarded.path, guarded.trajectory.line(i)) + ": " +
                            why_refused(guarded, i))
                << "\n";
    }
  }
  if (refused > kShownLines) {
    std::cerr << "flashbvh: " << one_line(guarded.path) << ": and " << refused - kShownLines
              << " more lines with values that are refused\n";
  }
}

/// Prints unguarded pairs, counts, stretches and motions that are not free, the closest moment
/// and work.
void print_guarded(const GuardedTrajectory& guarded) {
  print_head(guarded);
  print_counts(guarded);
  print_stretches(guarded);
  print_closest(guarded);
  print_work(guarded);
  if (guarded.has_motions) {
    print_motions(guarded);
  }
}

/// kCheckFailed if any period is `stop` or `not_yet_known`, or a motion is not free; kRefusedValues
/// if firmware refuses any values.
ExitCode exit_code_of(const GuardedTrajectory& guarded) {
  bool is_free_all = std::all_of(guarded.motions.begin(), guarded.motions.end(), is_free);
  for (const GuardAnswer& answer : guarded.answers) {
    if (answer.status != Status::done) {
      return kRefusedValues;
    }
    is_free_all = is_free_all && answer.verdict <= Verdict::warn;
  }
  return is_free_all ? kSuccess : kCheckFailed;
}

struct GuardArguments : RobotArguments {
  std::string trajectory;
  std::string page;
  std::uint32_t work = kAllWork;
  bool motion = false;
  bool json = false;
};

struct Guarded {
  BakedRobot robot;
  Trajectory trajectory;
};

/// A robot read from an image, as it was baked. UserError if it is no image, or if `command` was
/// given options of add_robot_options(), which are for baking.
BakedRobot opened_robot(const std::string& path, const CLI::App& command, Warnings& warnings) {
  for (const char* const option :
       {"--package", "--visual-too", "--srdf", "--believe", "--cell", "--leaf-size", "--simplify",
        "--fit", "--stop", "--warn", "--pair", "--zone", "--time"}) {
    if (command.count(option) != 0) {
      throw UserError(path, "is baked already, ", option,
                      " is for a URDF; leave it out, or bake again with `flashbvh robot`");
    }
  }
  BakedRobot made;
  made.file = std::make_unique<RobotFile>(path);
  made.model = made.file->model();
  made.cell = made.file->cell();
  made.sizes = link_sizes(made.model, made.robot().meshes, made.cell);
  made.unguarded = made.file->unguarded();
  warn_of_unguarded(made, path, warnings);
  return made;
}

/// Reads the trajectory before it bakes.
Guarded read_guarded(const GuardArguments& arguments, const CLI::App& command, Warnings& warnings) {
  if (is_robot_file_name(arguments.urdf)) {
    BakedRobot robot = opened_robot(arguments.urdf, command, warnings);
    Trajectory trajectory = read_trajectory(arguments.trajectory, robot.model, warnings);
    return {std::move(robot), std::move(trajectory)};
  }
  Model model = described_robot(arguments, warnings);
  Trajectory trajectory = read_trajectory(arguments.trajectory, model, warnings);
  return {baked_robot(std::move(model), arguments, warnings), std::move(trajectory)};
}

ExitCode guard_trajectory(const GuardArguments& arguments, const CLI::App& command) {
  Warnings warnings;
  const auto& [robot, trajectory] = read_guarded(arguments, command, warnings);
  const std::vector<GuardAnswer> answers = replay(robot.robot(), trajectory, arguments.work);
  const auto motions =
      arguments.motion ? certify(robot.robot(), trajectory) : std::vector<CertifiedMotion>();
  const std::vector<std::uint32_t> image =
      arguments.page.empty() ? std::vector<std::uint32_t>() : image_of(robot, robot.model.name);
  const GuardedTrajectory guarded = {
      robot.model,    robot.robot(),    image,   arguments.trajectory, trajectory, answers,
      arguments.work, arguments.motion, motions, robot.unguarded};
  std::vector<std::string> read = files_read(arguments, robot.model);
  read.push_back(arguments.trajectory);
  FileSet files(std::move(read));
  if (!arguments.page.empty()) {
    files.add(arguments.page, guard_page(guarded));
  }
  files.write([&] {
    warnings.print();
    print_refused(guarded);
    (arguments.json ? print_guarded_json : print_guarded)(guarded);
    flush_output();
  });
  return exit_code_of(guarded);
}

}  // namespace

void add_guard(CLI::App& app) {
  auto [command, a] = add_command<GuardArguments>(
      app, "guard",
      "Print what a robot's guard answers along a trajectory, by the firmware's own code.\n"
      "Exit code 0: all periods are free or warned of; 1: in some the guard says stop, or the "
      "work\n"
      "budget was too small, or a motion is not free; 3: firmware refuses some values.",
      [&app](const GuardArguments& given) {
        return guard_trajectory(given, *app.get_subcommand("guard"));
      });
  add_robot_options(command, "ROBOT", a);
  command.get_option("ROBOT")->description("The robot (URDF), or its image (.robot)");
  add_option(command, "TRAJECTORY", a.trajectory, "FILE.csv",
             "A CSV: a line with the joints' names, then one a period with their values, in "
             "radians\nand metres")
      ->required();
  add_option(command, "--work", a.work, "N",
             "What the guard may spend in a period; default: what it takes")
      ->check(CLI::Range(1u, kAllWork));
  command.add_flag("--motion", a.motion,
                   "Certify the straight motion of all joints from each line to the next, too");
  add_option(command, "--report", a.page, "PAGE.html",
             "Write a page: the robot on its way, distances and work over time, motions");
  add_json(command, a.json, "One JSON object a line");
  add_example(command, "guard arm.urdf motion.csv --stop 0.005 --warn 0.03",
              "prints how many periods are free, warned, stopped");
}

}  // namespace flashbvh::tool
