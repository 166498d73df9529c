// The painted stack of every entry, measured on the target: "stack NAME painted BYTES", the most
// over questions that are made to go down the deepest paths. Neither Catch2 nor a heap, so that it
// runs on every board.
#include "deep_post.fbvh.h"
#include "deep_pre.fbvh.h"
#include "flashbvh/image.hpp"
#include "memory/arguments.hpp"
#include "stack.hpp"
#include "support/rotations.hpp"
#include "text.hpp"

using namespace flashbvh;

extern "C" {
#define MEMORY_ENTRY(name, kind) MemoryEntry name;
#include "memory/entries.inc"
#undef MEMORY_ENTRY
}

namespace {

enum class Kind : uint8_t { ticked, moved, asked };

struct Entry {
  const char* name;
  MemoryEntry* call;
  Kind kind;
};

constexpr Entry kEntries[] = {
#define MEMORY_ENTRY(name, kind) {#name, name, Kind::kind},
#include "memory/entries.inc"
#undef MEMORY_ENTRY
};
constexpr uint32_t kEntryCount = sizeof kEntries / sizeof kEntries[0];

/// Few enough visits that slices end in the middle of everything.
constexpr uint32_t kVisits = 7;

using Matrix = float[3][4];

/// How B lies: a quaternion of integers and cells.
struct Place {
  test::Quaternion turn;
  int32_t cells[3];
};

constexpr Place kPlaces[] = {
    {{1, 0, 0, 0}, {1000, 500, 0}},     // coplanar and crossing
    {{1, 0, 0, 0}, {1000, 0, 0}},       // segments on one line
    {{1, 0, 0, 0}, {0, 0, 0}},          // the mesh on itself
    {{1, 0, 0, 0}, {400, 300, 50}},     // all crosses
    {{1, 0, 0, 0}, {30000, 0, 0}},      // touching at most
    {{1, 0, 0, 1}, {1000, 500, 0}},     // a quarter turn, coplanar
    {{0, 0, 0, 1}, {1000, 10000, 0}},   // a half turn: segments on one line
    {{7, 3, -2, 5}, {3000, 1000, 500}},
    {{7, 3, -2, 5}, {200000, 0, 0}},    // far apart
};

/// Corners for the exact test and contacts. The narrow ones differ by less than 2^15.
constexpr PlacedTriangle kPairs[][2] = {
    // Crossing, wide and narrow.
    {{{{-30000, -30000, 0}, {30000, -30000, 0}, {0, 30000, 0}}},
     {{{-9000, 100, -9000}, {9000, 300, -8000}, {100, 200, 25000}}}},
    {{{{-3000, -3000, 0}, {3000, -3000, 0}, {0, 3000, 0}}},
     {{{-900, 10, -900}, {900, 30, -800}, {10, 20, 2500}}}},
    // Coplanar, edges crossing: wide, narrow, and longest along z.
    {{{{-20000, -20000, 0}, {20000, -20000, 0}, {0, 20000, 0}}},
     {{{-20000, 9000, 0}, {20000, 9000, 0}, {0, -25000, 0}}}},
    {{{{-2000, -2000, 0}, {2000, -2000, 0}, {0, 2000, 0}}},
     {{{-2000, 900, 0}, {2000, 900, 0}, {0, -2500, 0}}}},
    {{{{0, -2000, -20000}, {0, 2000, -20000}, {0, 0, 20000}}},
     {{{0, -2000, 9000}, {0, 2000, 9000}, {0, 0, -25000}}}},
    // Two segments on one line; two that cross; one through a triangle.
    {{{{-20000, 0, 0}, {20000, 0, 0}, {0, 0, 0}}}, {{{-19000, 0, 0}, {21000, 0, 0}, {5, 0, 0}}}},
    {{{{-20000, 0, 0}, {20000, 0, 0}, {0, 0, 0}}}, {{{0, -20000, 0}, {0, 20000, 0}, {0, 0, 0}}}},
    {{{{-20000, -20000, 0}, {20000, -20000, 0}, {0, 20000, 0}}},
     {{{10, 10, -20000}, {10, 10, 20000}, {10, 10, 0}}}},
    // Corners and edges that touch.
    {{{{0, 0, 0}, {20000, 0, 0}, {0, 20000, 0}}}, {{{0, 0, 0}, {0, 0, 20000}, {-20000, 0, 5}}}},
    {{{{0, 0, 0}, {20000, 0, 0}, {0, 20000, 0}}}, {{{0, 0, 0}, {20000, 0, 0}, {0, 0, 20000}}}},
};

// Static, since the smallest board has no such stack.
memory::Arguments in;
LevelledPostTree post;
LevelledPreTree pre;
flashbvh_tree c_tree;
Room<sizeof(Pose)> c_poses;
uint32_t most[kEntryCount];
uint32_t answers[kEntryCount];
int failures = 0;

}  // namespace
