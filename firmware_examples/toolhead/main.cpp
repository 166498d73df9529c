// A printer's planner refuses blocks on which the head or the gantry would touch a finished part or
// a clamp. It certifies each block for every moment, before the block is queued.
//
// The example certifies straight motions of several bodies against several obstacles in the memory
// of one query. It runs in slices, between which the firmware does other work, and reports where a
// block would touch. A real planner stops at the first refused block; this planner goes on as if
// the machine had executed it, to report all errors of a program.
//
// Prints the refused blocks, then the cost of the checks. Run it by hand with FLASHBVH_ICOUNT to
// see the instruction counts (ports/README.md). Exits with 1 if a check cost too much.
#include "block_check.hpp"
#include "insn.hpp"
#include "stack.hpp"
#include "text.hpp"

namespace {

/// The work of a slice, in units of query.hpp.
constexpr uint32_t kWork = 500;
/// Limits that the tests hold, at 168 MHz and one instruction per cycle: 100 blocks per second in
/// the mean; 50 ms for a block, while the machine has blocks in its queue; 1 ms for a slice.
constexpr uint32_t kMeanOfBlock = 1'680'000;
constexpr uint32_t kMostOfBlock = 8'400'000;
constexpr uint32_t kMostOfSlice = 168'000;
/// Bytes of RAM for the whole firmware.
constexpr uint32_t kMostBytes = 4096;

/// The cost of all checks. Instructions are 0 on the host.
struct Costs {
  unsigned blocks = 0;
  unsigned slices = 0;
  unsigned most_slices = 0;
  uint32_t most_of_slice = 0;
  uint32_t most_of_block = 0;
  uint64_t instructions = 0;

  void add_block(unsigned of_block, uint32_t taken) {
    ++blocks;
    slices += of_block;
    most_slices = of_block > most_slices ? of_block : most_slices;
    most_of_block = taken > most_of_block ? taken : most_of_block;
    instructions += taken;
  }
  uint32_t mean() const { return blocks == 0 ? 0 : static_cast<uint32_t>(instructions / blocks); }
};

struct Machine {
  unsigned queued = 0;  ///< blocks
  float seconds = 0;    ///< that the machine needs for the queued blocks
  unsigned turns = 0;

  /// Heaters, the display, the next line from the host: the example only counts these turns.
  void do_other_things() { ++turns; }

  void queue(const Block& block) {
    ++queued;
    seconds += block.length() / static_cast<float>(block.speed);
  }
};

/// Prints mm with one decimal, rounded to the nearest.
void print_mm(int32_t micrometres) {
  const int32_t tenths = ((micrometres < 0 ? -micrometres : micrometres) + 50) / 100;
  port::print(micrometres < 0 && tenths != 0 ? " -" : " ", tenths / 10, ".", tenths % 10);
}

void print_place(const Place& place) {
  for (const int32_t coordinate : place.axis) {
    print_mm(coordinate);
  }
}

void print_refused(unsigned line, const Block& block, const BlockCheck& check) {
  port::print("line ", line, ": ", check.body().name, " and ", check.obstacle().name);
  if (check.has_error()) {
    port::print(": the check failed, is the block within the machine?\n");
    return;
  }
  port::print(" touch after");
  print_mm(static_cast<int32_t>(block.length() * check.free_part()));
  port::print(" mm, nozzle at");
  print_place(block.at(check.free_part()));
  Place touched;
  if (check.get_touched(touched)) {
    port::print(", touched at");
    print_place(touched);
  }
  port::print("\n");
}

/// Checks a block; queues it if it is free.
void plan(unsigned line, const Block& block, Machine& machine, Costs& costs) {
  BlockCheck check(block);
  unsigned slices = 0;
  uint32_t taken = 0;
  for (bool is_last = false; !is_last; ++slices) {
    const uint32_t slice = port::instructions_of([&] { is_last = check.run(kWork); });
    taken += slice;
    costs.most_of_slice = slice > costs.most_of_slice ? slice : costs.most_of_slice;
    machine.do_other_things();
  }
  costs.add_block(slices, taken);
  if (check.is_free()) {
    machine.queue(block);
  } else {
    print_refused(line, block, check);
  }
}

}  // namespace

int main() {
  Machine machine;
  Costs costs;
  unsigned line = 0;
  for (const Block& block : kProgram) {
    plan(++line, block, machine, costs);
  }
  const uint32_t bytes = port::static_bytes() + port::stack_used();
  port::print(machine.queued, " blocks queued, ", costs.blocks - machine.queued,
              " refused; the machine needs ", static_cast<uint64_t>(machine.seconds), " s\n",
              costs.slices, " slices, at most ", costs.most_slices,
              " a block; other things were done ", machine.turns, " times\n");
  port::print("instructions of a block: ", costs.mean(), " in the mean, ", costs.most_of_block,
              " at most; of a slice ", costs.most_of_slice, " at most\nRAM: ", bytes, " bytes\n");
  return costs.mean() <= kMeanOfBlock && costs.most_of_block <= kMostOfBlock &&
                 costs.most_of_slice <= kMostOfSlice && bytes <= kMostBytes
             ? 0
             : 1;
}
