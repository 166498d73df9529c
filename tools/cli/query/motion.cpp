// flashbvh motion: runs the firmware's certificate, on the desktop, that two bodies are apart at
// every moment between two poses.
#include <iostream>

#include "cli/query/scene.hpp"
#include "evaluate/motions.hpp"

namespace flashbvh::tool {
namespace {

struct MotionArguments : PosedImages {
  std::string from;
  std::string to;
  double within = 0;
  bool json = false;
};

Json json_of(const FoundContact& part, const BodyMotion& motion, const Scene& scene) {
  const double cell = scene.a.cell();
  Json line = {{"outcome", outcome_name(part.outcome)}, {"unit", scene.unit()}};
  if (part.outcome != ContactOutcome::free) {
    line.update({{"from", share_of(part.from)},
                 {"to", share_of(part.to)},
                 {"triangles", {part.triangles.a, part.triangles.b}},
                 {"from_pose", pose_numbers(motion.pose_at(part.from), cell)},
                 {"to_pose", pose_numbers(motion.pose_at(part.to), cell)}});
  }
  if (part.outcome == ContactOutcome::close) {
    line["distance_at_most"] = part.close_distance / double{kFineOne} * cell;
  }
  return line;
}

/// "1.5 0 3.25".
std::string origin_text(const Json& part) {
  const Json& pose = part["to_pose"];
  return joined(
      std::vector<double>{pose[9], pose[10], pose[11]},
      [](double along) { return significant(along, 6); }, " ");
}

void print_outcome(const Json& line, const Scene& scene, double within) {
  const std::string outcome = line["outcome"];
  std::cout << scene.names() << (within == 0 ? "" : ", within " + length_text(within, scene.unit()))
            << ": " << outcome;
  if (outcome == "close") {
    std::cout << ", at most " << length_text(line["distance_at_most"], scene.unit()) << " apart";
  }
  std::cout << "\n";
  if (outcome != "free") {
    print_table(Json::array({line}), {word_column("", "outcome"),
                                      number_column("from", "from", 9),
                                      number_column("to", "to", 9),
                                      word_column("triangles", "triangles"),
                                      {"B's origin at `to`", origin_text}});
  }
}

ExitCode certify_motion(const MotionArguments& arguments) {
  const Scene scene(arguments);
  check_has_clearance(scene.a);
  const double cell = scene.a.cell();
  const FineLength within = fine_length(arguments.within, cell, kMaxMotionDistance);
  const auto motion = BodyMotion::between(read_pose_argument(arguments.from, cell, "--from"),
                                          read_pose_argument(arguments.to, cell, "--to"));
  const FoundContact found = first_contact(scene.a, scene.b, motion, within);
  const Json line = json_of(found, motion, scene);
  if (arguments.json) {
    print_object(line);
  } else {
    print_outcome(line, scene, arguments.within);
  }
  return found.outcome == ContactOutcome::free ? kSuccess : kCheckFailed;
}

}  // namespace

void add_motion(CLI::App& app) {
  auto [command, a] = add_command<MotionArguments>(
      app, "motion",
      "Certify that B is apart from A at every moment on its way from one pose to another, by the "
      "firmware's own\ncode. Prints free; contact, from where to where they first touch; or close, "
      "where they come near and may\ntouch.\nExit code 0: free; 1: contact or close.",
      certify_motion);
  add_option(command, "A", a.a, "FILE.fbvh", "Image (.fbvh) that stays in place")->required();
  add_option(command, "B", a.b, "FILE.fbvh", "Image (.fbvh) that moves")->required();
  add_option(
      command, "--from", a.from, "POSE",
      "Where B begins, in A's frame: 12 numbers, the rotation row by row and the translation "
      "in the mesh's\nunit; or 3, the translation alone")
      ->required();
  add_option(
      command, "--to", a.to, "POSE",
      "Where B ends: its origin goes straight, and it turns the shorter way at constant speed")
      ->required();
  add_option(command, "--within", a.within, "LENGTH",
             "How near counts as touching, in the images' unit; default: 0, meshes that intersect");
  command.add_flag("--json", a.json, "One JSON object");
  add_example(command, "motion baked/plate.fbvh baked/peg.fbvh --from \"0 0 5\" --to \"20 0 5\"",
              "prints free, or where they first touch");
}

}  // namespace flashbvh::tool
