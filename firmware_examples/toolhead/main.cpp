// A printer's planner refuses straight moves of the nozzle, its blocks, on which the head or the
// gantry would touch a finished part or a clamp. It certifies each block for every moment, before
// the block is queued, in slices, between which the firmware does other work.
//
// A real planner stops at the first refused block; this one goes on as if the machine had executed
// it, to report all errors of a program.
//
// Prints the refused blocks, then the cost of the checks. Run it by hand with FLASHBVH_ICOUNT to
// see the instruction counts (ports/README.md). Exits with 1 if a check cost too much.
#include <flashbvh/contact.hpp>
#include <flashbvh/first_contact.hpp>
#include <flashbvh/image.hpp>
#include <flashbvh/triangle.hpp>

#include "arch.fbvh.h"
#include "clamp.fbvh.h"
#include "gantry.fbvh.h"
#include "head.fbvh.h"
#include "insn.hpp"
#include "stack.hpp"
#include "text.hpp"
#include "vase.fbvh.h"
#include "wheel.fbvh.h"

using namespace flashbvh;

namespace {

const Mesh head = view_unchecked<Mesh>(head_image);
const Mesh gantry = view_unchecked<Mesh>(gantry_image);
const Mesh clamp = view_unchecked<Mesh>(clamp_image);
const Mesh vase = view_unchecked<Mesh>(vase_image);
const Mesh wheel = view_unchecked<Mesh>(wheel_image);
const Mesh arch = view_unchecked<Mesh>(arch_image);

constexpr int kCell = 10;  // in micrometres; 100 cells per millimetre
static_assert(head_CELLS_PER_UNIT == 1000.0f / kCell);

/// A place of the nozzle's tip, in millimetres from a corner of the bed.
struct Place {
  int x, y, z;
};

/// The origin of both meshes is the nozzle's tip, but the gantry does not move along x.
struct Body {
  const char* name;
  const Mesh& mesh;
  bool goes_along_x;
};
const Body kBodies[] = {{"head", head, true}, {"gantry", gantry, false}};
/// The x coordinate of the gantry's centre.
constexpr int kMiddle = 110;

/// A fixture or a finished part. The part being printed is not an obstacle: the nozzle touches it.
struct Obstacle {
  const char* name;
  const Mesh& mesh;
  int x, y;
};
const Obstacle kObstacles[] = {
    {"left clamp", clamp, 15, 110},  {"right clamp", clamp, 205, 110},
    {"front clamp", clamp, 110, 15}, {"back clamp", clamp, 110, 205},
    {"vase", vase, 60, 150},         {"wheel", wheel, 165, 165},
    {"arch", arch, 45, 60},
};

/// The program: a block leads from each place to the next one. A real planner parses G-code.
constexpr Place kProgram[] = {
    {125, 10, 60},  {125, 55, 20},  {141, 55, 1},   {125, 71, 1},    // a printed star
    {109, 55, 1},   {125, 39, 1},   {141, 55, 1},   {125, 55, 95},   //
    {200, 40, 95},  {20, 190, 95},  {165, 165, 95}, {165, 165, 15},  // down onto the wheel
    {165, 165, 95}, {205, 60, 95},  {205, 60, 6},   {205, 150, 6},   // through a clamp
    {205, 150, 95}, {94, 150, 95},  {94, 150, 12},  {94, 150, 95},   // the heater is wide
    {190, 60, 30},  {190, 100, 30}, {190, 100, 95}, {60, 60, 70},    // the gantry is wider
    {60, 200, 70},  {60, 200, 95},  {-6, 60, 95},   {-6, 60, 2},     // over the vase; the arch
    {-6, 60, 95},
};

/// Bodies nearer than this count as touching: belts stretch, and meshes are inexact.
constexpr FineLength kMargin = {250 / kCell * 256};
/// The work of a slice, in units of query.hpp.
constexpr uint32_t kWork = 500;
/// Limits that the tests hold, at 168 MHz and one instruction per cycle: 50 ms for a block, while
/// the machine has blocks in its queue; 1 ms for a slice; bytes of RAM for the whole firmware.
constexpr uint32_t kMostOfBlock = 8'400'000;
constexpr uint32_t kMostOfSlice = 168'000;
constexpr uint32_t kMostBytes = 4096;

/// The cost of all checks. Instructions are 0 on the host.
struct Costs {
  unsigned slices = 0;
  uint32_t most_of_slice = 0;
  uint32_t most_of_block = 0;
};

/// A body's pose in an obstacle's frame.
Pose pose_of(const Body& body, const Obstacle& obstacle, const Place& nozzle) {
  constexpr int cells = 1000 / kCell;
  const int x = body.goes_along_x ? nozzle.x : kMiddle;
  return Pose::translated(cells * (x - obstacle.x), cells * (nozzle.y - obstacle.y),
                          cells * nozzle.z);
}

/// Prints 1/256 cells as mm with one decimal, rounded to the nearest, after a space.
void print_mm(int64_t fine) {
  constexpr int64_t tenth = 100 / kCell * 256;
  const auto tenths = static_cast<int32_t>(((fine < 0 ? -fine : fine) + tenth / 2) / tenth);
  port::print(fine < 0 && tenths != 0 ? " -" : " ", tenths / 10, ".", tenths % 10);
}

/// Prints a point of contact on the obstacle, where one of possibly several pairs touches.
void print_touched(const Body& body, const Obstacle& obstacle, const BodyMotion& motion,
                   const FirstContactAnswer& answer) {
  Triangle of_obstacle;
  Triangle of_body;
  if (transform_pair(obstacle.mesh, body.mesh, motion.pose_at(answer.to), answer.triangles,
                     of_obstacle, of_body)) {
    constexpr int64_t mm = 1000 / kCell * 256;
    const FinePoint at = nearest_points_of(of_obstacle, of_body).point_a;
    port::print(" at");
    print_mm(at.x + mm * obstacle.x);
    print_mm(at.y + mm * obstacle.y);
    print_mm(at.z);
  }
}

/// Checks a body against an obstacle on a block; prints where they touch. An error is no permission
/// to move. Each block starts where the last one ended: a head that is outside all obstacles cannot
/// get inside one without touching it.
bool is_free(unsigned line, const Body& body, const Obstacle& obstacle, uint32_t& instructions,
             Costs& costs) {
  const BodyMotion motion = BodyMotion::between(pose_of(body, obstacle, kProgram[line - 1]),
                                                pose_of(body, obstacle, kProgram[line]));
  FirstContact query(obstacle.mesh, body.mesh, motion, kMargin);
  FirstContactAnswer answer;
  do {
    const uint32_t slice = port::instructions_of([&] { answer = query.run(kWork); });
    instructions += slice;
    costs.most_of_slice = slice > costs.most_of_slice ? slice : costs.most_of_slice;
    ++costs.slices;
    // Heaters, the display, the next line from the host.
  } while (answer.status == Status::suspended);
  if (answer.status != Status::done) {
    port::print("line ", line, ": the check failed, is the block within the machine?\n");
    return false;
  }
  if (answer.outcome == ContactOutcome::free) {
    return true;
  }
  port::print("line ", line, ": ", body.name, " and ", obstacle.name, " touch after ",
              static_cast<uint32_t>(uint64_t{answer.from} * 100 / kMotionEnd), " % of the block");
  print_touched(body, obstacle, motion, answer);
  port::print("\n");
  return false;
}

/// Checks a block; true if it may be queued.
bool is_free(unsigned line, Costs& costs) {
  uint32_t instructions = 0;
  for (const Body& body : kBodies) {
    for (const Obstacle& obstacle : kObstacles) {
      if (!is_free(line, body, obstacle, instructions, costs)) {
        return false;
      }
    }
  }
  costs.most_of_block = instructions > costs.most_of_block ? instructions : costs.most_of_block;
  return true;
}

}  // namespace

int main() {
  constexpr unsigned kBlocks = sizeof kProgram / sizeof *kProgram - 1;
  Costs costs;
  unsigned queued = 0;
  for (unsigned line = 1; line <= kBlocks; ++line) {
    queued += is_free(line, costs) ? 1 : 0;
  }
  const uint32_t bytes = port::static_bytes() + port::stack_used();
  port::print(queued, " blocks queued, ", kBlocks - queued, " refused, after ", costs.slices,
              " slices\ninstructions at most: of a block ", costs.most_of_block, ", of a slice ",
              costs.most_of_slice, "\nRAM: ", bytes, " bytes\n");
  return costs.most_of_block <= kMostOfBlock && costs.most_of_slice <= kMostOfSlice &&
                 bytes <= kMostBytes
             ? 0
             : 1;
}
