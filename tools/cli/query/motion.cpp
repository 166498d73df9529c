// flashbvh motion: runs the firmware's certificate, on the desktop, that two bodies are apart at
// every moment between two poses.
#include <algorithm>
#include <iomanip>
#include <iostream>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "evaluate/motions.hpp"
#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "image/image_file.hpp"
#include "mesh/units.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

struct MotionArguments {
  std::string a;
  std::string b;
  std::string from;
  std::string to;
  std::string moves;
  double within = 0;
  bool all = false;
  bool json = false;
};

/// The contacts of a motion between two images.
struct FoundMotion {
  const ImageFile& a;
  const BodyMotion& motion;
  std::vector<FoundContact> parts;

  /// How near the bodies come where they are close, in the unit.
  double at_most(const FoundContact& part) const {
    return part.close_distance / double{kFineOne} * a.cell();
  }
  Json pose_json(std::uint32_t time) const { return pose_numbers(motion.pose_at(time), a.cell()); }
};

void print_json(const FoundMotion& found) {
  for (const FoundContact& part : found.parts) {
    Json line = {{"outcome", outcome_name(part.outcome)}, {"unit", unit_name(found.a.unit())}};
    if (part.outcome != ContactOutcome::free) {
      line.update({{"from", share_of(part.from)},
                   {"to", share_of(part.to)},
                   {"triangles", {part.triangles.a, part.triangles.b}},
                   {"from_pose", found.pose_json(part.from)},
                   {"to_pose", found.pose_json(part.to)}});
    }
    if (part.outcome == ContactOutcome::close) {
      line["distance_at_most"] = found.at_most(part);
    }
    print_object(line);
  }
}

/// Prints "contact   0.331123   0.331456       12       7   1.5 0 3.25".
void print_part(const FoundMotion& found, const FoundContact& part) {
  const auto there = pose_numbers(found.motion.pose_at(part.to), found.a.cell());
  std::cout << "  " << std::left << std::setw(8) << outcome_name(part.outcome) << std::right
            << std::setw(12) << significant(share_of(part.from), 9) << std::setw(13)
            << significant(share_of(part.to), 9) << std::setw(9) << part.triangles.a << " "
            << std::setw(8) << part.triangles.b << "  ";
  for (std::size_t i = 9; i < there.size(); ++i) {
    std::cout << " " << significant(there[i], 6);
  }
  std::cout << "\n";
}

/// The worst outcome of all parts; the last may be `free`.
ContactOutcome outcome_of(const std::vector<FoundContact>& parts) {
  const ContactOutcome last = parts.back().outcome;
  return last == ContactOutcome::free && parts.size() > 1 ? ContactOutcome::close : last;
}

void print_table(const FoundMotion& found, const std::string& names, double within) {
  const std::string unit = unit_name(found.a.unit());
  const ContactOutcome outcome = outcome_of(found.parts);
  std::cout << names;
  if (within != 0) {
    std::cout << ", within " << shortest(within) << (unit.empty() ? "" : " " + unit);
  }
  std::cout << ": " << outcome_name(outcome);
  if (outcome == ContactOutcome::close) {
    std::cout << ", at most " << significant(found.at_most(found.parts.front()), 6)
              << (unit.empty() ? "" : " " + unit) << " apart";
  }
  std::cout << "\n";
  if (outcome == ContactOutcome::free) {
    return;
  }
  std::cout << "                  from           to     triangles      B's origin at `to`\n";
  for (const FoundContact& part : found.parts) {
    if (part.outcome != ContactOutcome::free) {
      print_part(found, part);
    }
  }
}

ExitCode certify_motion(const MotionArguments& arguments) {
  if (arguments.to.empty() == arguments.moves.empty()) {
    throw CLI::RequiredError("--to or --moves");
  }
  const ImageFile a(arguments.a);
  const ImageFile b(arguments.b);
  check_has_clearance(a);
  check_partners(a, b);
  const double cell = a.cell();
  const FineLength within = fine_length(arguments.within, cell, kMaxMotionDistance);
  const Pose from = read_pose_argument(arguments.from, cell, "--from");
  std::vector<Move> moves;
  if (!arguments.moves.empty()) {
    moves = read_moves(arguments.moves, cell);
  }
  const BodyMotion motion =
      moves.empty() ? BodyMotion::between(from, read_pose_argument(arguments.to, cell, "--to"))
                    : BodyMotion(from, moves.data(), static_cast<std::uint32_t>(moves.size()));
  const std::string place = moves.empty() ? "--to" : arguments.moves;
  const FoundMotion found = {a, motion, first_contacts(a, b, motion, within, arguments.all, place)};
  if (arguments.json) {
    print_json(found);
  } else {
    print_table(found, a.name() + " and " + b.name(), arguments.within);
  }
  return outcome_of(found.parts) == ContactOutcome::free ? kSuccess : kCheckFailed;
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
      "in the mesh's\nunit; 3, the translation alone; or the name of a file with one pose")
      ->required();
  CLI::Option* const to = add_option(
      command, "--to", a.to, "POSE",
      "Where B ends: its origin goes straight, and it turns the shorter way at constant speed");
  add_option(command, "--moves", a.moves, "FILE",
             "A move a line, from the outermost to the innermost, all at once: a point of an axis, "
             "its direction,\ndegrees that B turns about it, and what it travels; 10 numbers")
      ->excludes(to);
  add_option(command, "--within", a.within, "LENGTH",
             "How near counts as touching, in the images' unit; default: 0, meshes that intersect");
  command.add_flag("--all", a.all, "Go on behind each place where they are close");
  add_json(command, a.json, "One JSON object; with --all one for each place, and how it ends");
  add_example(command, "motion baked/plate.fbvh baked/peg.fbvh --from \"0 0 5\" --to \"20 0 5\"",
              "prints free, or where they first touch");
}

}  // namespace flashbvh::tool
