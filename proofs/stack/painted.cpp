// The painted stack of every entry, measured on the target: "stack NAME painted BYTES", the largest
// over queries built to take the deepest paths. Needs neither Catch2 nor a heap: for every board.
#include "deep_post.fbvh.h"
#include "deep_pre.fbvh.h"
#include "flashbvh/image.hpp"
#include "proofs/stack/arguments.hpp"
#include "stack.hpp"
#include "support/rotations.hpp"
#include "text.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;

extern "C" {
#define ENTRY(name, kind, most, ...) EntryFunction name;
#include "proofs/stack/entries.inc"
#undef ENTRY
}

namespace {

enum class Kind : uint8_t { ticked, translated, single };

struct Entry {
  const char* name;
  EntryFunction* call;
  Kind kind;
};

constexpr Entry kEntries[] = {
#define ENTRY(name, kind, most, ...) {#name, name, Kind::kind},
#include "proofs/stack/entries.inc"
#undef ENTRY
};
constexpr uint32_t kEntryCount = sizeof kEntries / sizeof kEntries[0];

/// So small that slices end in the middle of every phase.
constexpr uint32_t kWork = 7;

/// The pose of B: a quaternion of integers and cells.
struct TestPose {
  test::Quaternion rotation;
  int32_t cells[3];
};

/// A distance at which nothing is near, and B is placed far.
constexpr int32_t kFarCells = 200'000;

constexpr TestPose kTestPoses[] = {
    {{1, 0, 0, 0}, {1000, 500, 0}},      // coplanar and crossing
    {{1, 0, 0, 0}, {1000, 0, 0}},        // segments on one line
    {{1, 0, 0, 0}, {0, 0, 0}},           // the mesh on itself
    {{1, 0, 0, 0}, {400, 300, 50}},      // crosses everywhere
    {{1, 0, 0, 0}, {17000, 300, 50}},    // crossing, and more than 2^15 wide together
    {{1, 0, 0, 1}, {1000, 500, 0}},      // a quarter turn, coplanar
    {{0, 0, 0, 1}, {1000, 10000, 0}},    // a half turn: segments on one line
    {{7, 3, -2, 5}, {3000, 1000, 500}},  // crossing, rotated
    {{7, 3, -2, 5}, {kFarCells, 1000, 500}},
    {{1, 0, 0, 0}, {0, 0, 2500}},        // above itself
    {{1, 0, 0, 0}, {16000, 500, 2500}},  // above itself, and along an edge
    {{7, 3, -2, 5}, {0, 15000, 20000}},  // next to itself, rotated
    {{7, 3, -2, 5}, {0, 0, 20000}},      // a corner above a face
    {{7, 3, -2, 5}, {3000, -2000, -20000}},
    {{3, 1, 1, 0}, {3636, -636, 18409}},
    {{0, 0, 0, 1}, {33000, 500, 0}},  // parallel edges: equal distances
    {{0, 0, 0, 1}, {33000, 500, 300}},
    {{7, 3, -2, 5}, {0, 44000, 44000}},  // beyond 32,767 cells, although boxes are not
};

/// Corners for the exact test and contacts. The narrow ones differ by less than 2^15.
constexpr Triangle kPairs[][2] = {
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

constexpr float kRigidFloats[12] = {0.6f, -0.8f, 0, 0.8f, 0.6f, 0, 0, 0, 1, 1.25f, -7, 0.125f};

/// A matrix and a translation, row by row; the first seven are also a quaternion and a translation.
constexpr float kFloats[][12] = {
    {0.6f, -0.8f, 0, 1.25f, 0.8f, 0.6f, 0, -7, 0, 0, 1, 0.125f},
    {1, 0, 0, 0, 2000.5f, -3, 0.75f, 0, 0, 0, 0, 0},
    {0.5f, 0.5f, 0.5f, 0.5f, 2000.5f, -3, 0.75f, 0, 0, 0, 0, 0},
};

template <class Element, size_t count>
constexpr uint32_t length(const Element (&)[count]) {
  return count;
}

/// A small distance, the limit of 32-bit tests, and the largest; the second row for a far B.
constexpr uint32_t kDistances[] = {3000 * 256, 32'767 * 256, kMaxDistance};
constexpr uint32_t kFarDistances[] = {3000 * 256, (kFarCells - 20'000) * 256, kFarCells * 256};

// Static, since the smallest board's stack is too small.
stack_proof::Arguments in;
MeshWithLevels post;
PreMeshWithLevels pre;
flashbvh_mesh c_tree;
Mesh closed;
flashbvh_mesh c_closed;
flashbvh_deformable bent;
flashbvh_node bent_nodes[deep_post_NODE_COUNT];
flashbvh_vertex bent_vertices[36];
stack_proof::Room<sizeof(Pose)> poses[2];
GuardStateOf<1, 1, 1> guard_state;
MotionStateOf<1, 1> motion_state;
WorkcellOf<3, 4, 2, 5> workcell_memory;
RobotJoint joint;
RobotPair pair;
Mesh meshes[2];
Robot robot;
alignas(4) constexpr unsigned char kRobotImage[] = {
#include "robot_image.inc"
};
Mesh robot_meshes[stack_proof::kRobotLinks];
uint32_t most[kEntryCount];
uint32_t answers[kEntryCount];
int failures = 0;

void check(bool holds, const char* what, const char* where) {
  if (!holds) {
    ++failures;
    port::print("failed: ", what, ", ", where, "\n");
  }
}

void open_trees() {
  check(open_image(deep_post_image, sizeof deep_post_image, post) == Status::done, "open", "post");
  check(open_image(deep_pre_image, sizeof deep_pre_image, pre) == Status::done, "open", "pre");
  check(flashbvh_open(deep_post_image, sizeof deep_post_image, &c_tree) == FLASHBVH_STATUS_DONE,
        "open", "C");
  in.a = in.b = &post;
  in.pre_a = in.pre_b = &pre;
  closed = post;
  closed.is_closed = true;
  in.closed = &closed;
  c_closed = c_tree;
  reinterpret_cast<Mesh*>(c_closed.opaque.bytes)->is_closed = true;
  in.c_closed = &c_closed;
  check(post.vertex_count <= length(bent_vertices), "vertices", "bent");
  flashbvh_deformable_make(&bent, &c_tree, bent_nodes, bent_vertices);
  in.c_bent = &bent;
  in.bent = reinterpret_cast<DeformableMesh*>(&bent);
  in.c_a = in.c_b = &c_tree;
  in.image = deep_post_image;
  in.image_size = sizeof deep_post_image;
  in.robot_image = kRobotImage;
  in.robot_image_size = sizeof kRobotImage;
  in.robot_meshes = robot_meshes;
}

/// Replaces the first and the last triangle by these two, at half size.
void bend(const Triangle* two) {
  const auto half = [](int32_t at) { return static_cast<int16_t>(at / 2); };
  for (int i = 0; i < 2; ++i) {
    const auto& corners = post.triangles[i == 0 ? 0 : post.triangle_count - 1].corner;
    for (int j = 0; j < 3; ++j) {
      const Point& to = two[i].corner[j];
      bent_vertices[corners[j]] = {half(to.x), half(to.y), half(to.z)};
    }
  }
  check(in.bent->refit().status == Status::done, "refit", "bent");
}

/// In 1/2,048 cell: the extent of a mesh.
constexpr uint32_t kRadius = 30000u << kFrameBits;
constexpr RobotLink kLinks[] = {{{0, 0, 0}, kRadius, 0, kBase, 0, 0},
                                {{0, 0, 0}, kRadius, 0, 0, 0, 0}};
/// Makes motion_run test slightly less than kMaxGuardDistance.
constexpr uint32_t kReaches[] = {32760u << 14};

/// Two links, posed like B in A's frame.
void make_robot() {
  meshes[0] = meshes[1] = post;
  joint.lower = -kFullTurn;
  joint.upper = kFullTurn;
  joint.parent = kBase;
  pair = {0, 0, kReaches[0], 0, 1, 0, 1};
  robot = {&joint, kLinks, meshes, &pair, kReaches, nullptr, 1, 2,
           1,      0,      1,      1,     1,        0,       1, post.cell_bits};
  in.robot = &robot;
  in.guard_state = &guard_state;
  in.motion_state = &motion_state;
  in.workcell_memory = &workcell_memory;
}

void pose_robot(const TestPose& where, const test::Rotation& matrix) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      joint.fixed.rotation[i][j] = matrix.entry[i][j];
    }
    joint.fixed.translation[i] = where.cells[i] * kFrameCell;
  }
}

constexpr int16_t kFraction[3] = {-32768, 32767, 5};

/// Copies of `matrix` for the entries that make poses; the pose itself and another one.
void set_pose(const TestPose& where, test::Rotation& matrix) {
  matrix = test::rotation_of(where.rotation);
  for (auto& row : matrix.entry) {
    for (int32_t& entry : row) {
      entry &= ~0x3FFF;  // so coarse that a product is proven again
    }
  }
  in.rotation = matrix.entry;
  in.cells = where.cells;
  in.fraction = kFraction;
  in.rigid_floats = kRigidFloats;
  in.pose =
      &stack_proof::make_in<Pose>(poses[0], [&] { return Pose::rigid(matrix.entry, where.cells); });
  in.other_pose = &stack_proof::make_in<Pose>(poses[1], [&] { return in.pose->inverse(); });
  in.c_pose = reinterpret_cast<const flashbvh_pose*>(in.pose);
  in.c_other_pose = reinterpret_cast<const flashbvh_pose*>(in.other_pose);
}

/// Prepares a query stopped at its first pair, and a walk at its start, for entries that use them.
void prepare() {
  auto& query =
      stack_proof::make_in<PairQuery>(in.query, [] { return PairQuery(post, post, *in.pose); });
  (void)query.run(UINT32_MAX, in.found, 1);
  in.position = query.cursor();
  in.c_cursor = flashbvh_query_cursor(reinterpret_cast<const flashbvh_query*>(in.query.bytes));
  stack_proof::make_in<TranslatedBoxTest>(in.made_pose, [] {
    return TranslatedBoxTest(in.pose->translation(0), in.pose->translation(1),
                             in.pose->translation(2));
  });
  in.stack[0] = {};
}

void call(uint32_t entry) {
  const auto function = reinterpret_cast<port::Call>(kEntries[entry].call);
  const uint32_t bytes = port::stack_of_call(function, &in);
  most[entry] = bytes > most[entry] ? bytes : most[entry];
}

void run_entry(uint32_t entry) {
  in.status = static_cast<uint8_t>(Status::done);
  in.answer = 0;
  in.capacity = length(in.found);
  in.work = 0;
  if (kEntries[entry].kind == Kind::single) {
    in.work = UINT32_MAX;
    call(entry);
    check(in.status <= static_cast<uint8_t>(Status::full), "status", kEntries[entry].name);
  } else {
    call(entry);
    in.status = static_cast<uint8_t>(Status::suspended);
    in.work = kWork;
    while (in.status == static_cast<uint8_t>(Status::suspended) ||
           in.status == static_cast<uint8_t>(Status::full)) {
      call(entry);
    }
    check(in.status == static_cast<uint8_t>(Status::done), "status", kEntries[entry].name);
  }
  answers[entry] += in.answer;
}

void run_entries(bool translated) {
  for (uint32_t entry = 0; entry < kEntryCount; ++entry) {
    if (translated || kEntries[entry].kind != Kind::translated) {
      prepare();
      run_entry(entry);
    }
  }
}

/// The first entry's answers must be every query's.
void report() {
  for (uint32_t entry = 0; entry < kEntryCount; ++entry) {
    port::print("stack ", kEntries[entry].name, " painted ", most[entry], "\n");
    check(kEntries[entry].kind != Kind::ticked || answers[entry] == answers[0], "answers",
          kEntries[entry].name);
  }
  check(answers[0] != 0, "no pairs", kEntries[0].name);
  port::print("object PairQuery ", sizeof(PairQuery), "\nobject Pose ", sizeof(Pose),
              "\nobject Mesh ", sizeof(Mesh), "\nobject QueryCursor ",
              sizeof(QueryCursor<uint16_t>), "\nobject Contact ", sizeof(Contact),
              "\nobject ClearanceQuery ", sizeof(ClearanceQuery), "\nobject WithinQuery ",
              sizeof(WithinQuery), "\nobject FirstContact ", sizeof(FirstContact),
              "\nobject BodyMotion ", sizeof(BodyMotion), "\n");
  check(port::stack_used() < port::stack_size(), "stack", "overflow");
  port::print("failures: ", failures, "\n");
}

}  // namespace

int main() {
  open_trees();
  make_robot();
  uint32_t round = 0;
  for (const TestPose& where : kTestPoses) {
    test::Rotation matrix;
    set_pose(where, matrix);
    pose_robot(where, matrix);
    for (uint32_t i = 0; i < length(kDistances); ++i, ++round) {
      in.triangles = kPairs[round % length(kPairs)];
      bend(in.triangles);
      in.floats = kFloats[round % length(kFloats)];
      in.distance = (where.cells[0] == kFarCells ? kFarDistances : kDistances)[i];
      pair.stop = (i == 0 ? 4095 : 32760) << 8;  // near and far pairs have triangles within it
      pair.warn = UINT32_MAX;                    // so that spheres do not suffice
      run_entries(in.pose->is_translation());
    }
  }
  report();
  return failures == 0 ? 0 : 1;
}
