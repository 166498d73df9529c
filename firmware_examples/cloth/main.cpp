// A sheet of cloth falls over a robot's link and, below it, onto itself. Each frame reports exactly
// which triangles touch.
//
// A frame is 10 ms. The sheet is a deformable mesh. Each frame copies the cloth's points to its
// vertices, refits its boxes and runs four queries. Two report intersecting triangles: of link and
// sheet, and of the sheet with itself. Two report those nearer than the cloth is thick, and push
// them apart. All cores and the host compute the same numbers.
//
// Prints each frame's pairs, a digest of all pairs so far, and instructions. Run it by hand with
// FLASHBVH_ICOUNT to see the instruction counts (ports/README.md).
#include <flashbvh/clearance.hpp>
#include <flashbvh/image.hpp>
#include <flashbvh/self.hpp>

#include "arm_link.fbvh.h"
#include "cloth.hpp"
#include "insn.hpp"
#include "sheet.fbvh.h"
#include "text.hpp"

using namespace flashbvh;
using cloth::Cloth;
using cloth::Vector;

namespace {

constexpr int kFrames = 130;
/// Half of a Cortex-M7 at 480 MHz and 100 Hz, at one instruction per cycle.
constexpr uint32_t kMostInstructions = 2'400'000;
constexpr float kPerMm = 1 / static_cast<float>(sheet_CELL);
constexpr float kThickness = 1.5f * kPerMm;
constexpr uint32_t kNear = static_cast<uint32_t>(kThickness) * 256;
constexpr uint32_t kNearLink = 2 * kNear;

const Mesh sheet = view_unchecked<Mesh>(sheet_image);

// All memory that the program uses, except for views of the meshes.
Node<uint16_t> nodes[sheet_NODE_COUNT];
Vertex vertices[sheet_VERTEX_COUNT];
Vector points[sheet_VERTEX_COUNT];
Vector before[sheet_VERTEX_COUNT];

const Pose kInPlace = Pose::translated(0, 0, 0);

struct FrameAnswers {
  uint32_t of_link = 0;    ///< intersecting pairs of link and cloth
  uint32_t of_itself = 0;  ///< intersecting pairs of the cloth
  uint32_t near_link = 0;
  uint32_t near_itself = 0;
  uint32_t digest = 2166136261u;  ///< of this frame and all frames before

  template <class Pair>
  void add(uint32_t& count, const Pair& pair) {
    ++count;
    digest = ((digest ^ pair.a) * 16777619u ^ pair.b) * 16777619u;
  }
};

/// Instructions of a frame, or the most of any frame.
struct Costs {
  uint32_t refit = 0;
  uint32_t itself = 0;
  uint32_t band = 0;
  uint32_t link = 0;

  void raise_to(const Costs& other) {
    const auto larger = [](uint32_t u, uint32_t v) { return u < v ? v : u; };
    refit = larger(refit, other.refit);
    itself = larger(itself, other.itself);
    band = larger(band, other.band);
    link = larger(link, other.link);
  }
};

/// Places the link below the sheet's lower edge, its top 28 mm above the sheet's origin.
Mesh put_link() {
  Mesh link = view_unchecked<Mesh>(arm_link_image);
  const Box box = unpack(link.nodes[0].box);
  link.origin[0] = -(box.lower.x + box.upper.x) / 2;
  link.origin[1] = -(box.lower.y + box.upper.y) / 2;
  link.origin[2] = static_cast<int32_t>(28 * kPerMm) - box.upper.z;
  return link;
}
const Mesh link = put_link();

/// A link's vertex in the cloth's coordinates: each mesh counts from its own origin.
Vector of_link(uint16_t vertex) {
  const auto from_sheet = [](int axis) {
    return static_cast<float>(link.origin[axis] - sheet.origin[axis]);
  };
  return cloth::from(link.vertices[vertex], {from_sheet(0), from_sheet(1), from_sheet(2)});
}

void push_off_link(Cloth& cloth, uint32_t of_a, uint32_t of_b) {
  const auto& corner = link.triangles[of_a].corner;
  const Vector o = of_link(corner[0]);
  const Vector n = cloth::cross(of_link(corner[1]) - o, of_link(corner[2]) - o);
  const float squared = dot(n, n);
  if (squared > 0) {
    cloth.push_off(of_b, o, (1 / __builtin_sqrtf(squared)) * n);
  }
}

/// Runs all queries of a frame.
Costs run_queries(const Mesh& mesh, Cloth& cloth, FrameAnswers& frame) {
  Costs costs;
  costs.link = port::instructions_of([&] {
    PairQuery query(link, mesh, kInPlace);
    (void)query.run(UINT32_MAX, [&](const PairQuery::Pair& pair) {
      frame.add(frame.of_link, pair);
      return true;
    });
  });
  costs.itself = port::instructions_of([&] {
    SelfQuery query(mesh);
    (void)query.run(UINT32_MAX, [&](const SelfQuery::Pair& pair) {
      frame.add(frame.of_itself, pair);
      return true;
    });
  });
  WithinQuery near_link(link, mesh, kInPlace, {}, within({kNearLink}));
  (void)near_link.run(UINT32_MAX, [&](const WithinQuery::Pair& pair) {
    frame.add(frame.near_link, pair);
    const auto positions = near_link.last_slots();
    push_off_link(cloth, positions.a, positions.b);
    return true;
  });
  costs.band = port::instructions_of([&] {
    SelfWithinQuery query(mesh, within({kNear}));
    (void)query.run(UINT32_MAX, [&](const SelfWithinQuery::Pair& pair) {
      frame.add(frame.near_itself, pair);
      const auto positions = query.last_slots();
      cloth.push_apart(positions.a, positions.b);
      return true;
    });
  });
  return costs;
}

void print_frame(int number, const FrameAnswers& frame, const Costs& costs) {
  port::print("frame ", number, ": link ", frame.of_link, " near ", frame.near_link, ", itself ",
              frame.of_itself, " near ", frame.near_itself, ", digest ", frame.digest,
              "; instructions: ");
  port::print("refit ", costs.refit, ", itself ", costs.itself, ", near itself ", costs.band,
              ", link ", costs.link, "\n");
}

}  // namespace

int main() {
  DeformableMesh mesh(sheet, nodes, vertices);
  const float floor = -45.0f * kPerMm - static_cast<float>(sheet.origin[2]);
  Cloth cloth(sheet, {0.5f * kPerMm, 3.0f * kPerMm, floor, kThickness}, points, before);
  Costs most;
  uint32_t digest = 0;
  for (int number = 0; number < kFrames; ++number) {
    cloth.put_into(mesh.vertices());
    RefitResult step{};
    const uint32_t refit = port::instructions_of([&] { step = mesh.refit(); });
    if (step.status != Status::done) {
      port::print("vertex ", step.vertex, " left the lattice\n");
      return 1;
    }
    FrameAnswers frame;
    frame.digest ^= digest;
    Costs costs = run_queries(mesh.mesh(), cloth, frame);
    costs.refit = refit;
    digest = frame.digest;
    most.raise_to(costs);
    if (number % 10 == 0 || number == kFrames - 1) {
      print_frame(number, frame, costs);
    }
    cloth.step();
  }
  port::print("at most: refit ", most.refit, " (", most.refit / sheet_NODE_COUNT,
              " a node), itself ", most.itself, ", near itself ", most.band, ", link ", most.link,
              "\n");
  port::print("RAM: nodes and vertices ", unsigned{sizeof nodes + sizeof vertices},
              " bytes, the cloth's points ", unsigned{sizeof points + sizeof before}, "\n");
  return most.refit + most.itself <= kMostInstructions ? 0 : 1;
}
