// flashbvh guard: a trajectory through the guard that firmware runs, on the desktop.
#include <memory>

#include "cli/commands.hpp"
#include "cli/robot/baked_robot.hpp"
#include "cli/robot/guard_output.hpp"
#include "report/guard_page.hpp"
#include "text/files.hpp"

namespace flashbvh::tool {
namespace {

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

/// The trajectory is read before anything is baked.
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
  const Replayed replayed = {
      robot,
      arguments.trajectory,
      trajectory,
      replay(robot.robot(), trajectory, arguments.work),
      arguments.motion,
      arguments.motion ? certify(robot.robot(), trajectory) : std::vector<CertifiedMotion>()};
  FileSet files;
  if (!arguments.page.empty()) {
    std::set<std::string> read = files_read(arguments, robot.model);
    read.insert(arguments.trajectory);
    refuse_to_replace_inputs(arguments.page, {read.begin(), read.end()});
    files.add(arguments.page, guard_page({robot.model, robot.robot(), trajectory, replayed.answers,
                                          arguments.work, replayed.motions, robot.unguarded}));
  }
  files.write([&] {
    warnings.print();
    print_refused(replayed);
    (arguments.json ? print_replayed_json : print_replayed)(replayed);
    flush_output();
  });
  return exit_code_of(replayed);
}

}  // namespace

void add_guard(CLI::App& app, ExitCode& exit_code) {
  const auto arguments = std::make_shared<GuardArguments>();
  GuardArguments& a = *arguments;
  CLI::App* const command = app.add_subcommand(
      "guard",
      "Print what a robot's guard answers along a trajectory, by the firmware's own code.\n"
      "Exit code 0: all periods are free or warned of; 1: in some the guard says stop, or what "
      "was\n"
      "granted did not do, or a motion is not free; 3: firmware refuses some values.");
  add_robot_options(*command, "ROBOT", a);
  command->get_option("ROBOT")->description("The robot (URDF), or its image (.robot)");
  command
      ->add_option("TRAJECTORY", a.trajectory,
                   "A CSV: a line with the joints' names, then one a period with their values, in "
                   "radians\nand metres")
      ->required();
  add_option(*command, "--work", a.work, "N",
             "What the guard may spend in a period; default: what it takes")
      ->check(CLI::Range(1u, kAllWork));
  command->add_flag("--motion", a.motion,
                    "Certify the straight motion of all joints from each line to the next, too");
  add_option(*command, "--report", a.page, "PAGE.html",
             "Write a page: distances and work over time, the closest moment, motions");
  add_json(*command, a.json, "One JSON object a line");
  command->callback(
      [arguments, command, &exit_code] { exit_code = guard_trajectory(*arguments, *command); });
}

}  // namespace flashbvh::tool
