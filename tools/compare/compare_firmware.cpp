// Measures instructions of a query by flashbvh, OPCODE and a tree of floats, for each pair of
// meshes of scenes.py and of links in lib/docs/figures.md, and each class of their poses. Prints:
//     CORE made|links A-B MOTION CLASS LIBRARY mean most pairs-found
#include <initializer_list>

#include "flashbvh/collide.hpp"

#include "insn.hpp"
#include "library.hpp"
#include "links.hpp"
#include "scenes.hpp"
#include "support/rotations.hpp"
#include "text.hpp"

using namespace flashbvh;
using namespace figures;

namespace compare {
namespace {

class WithFlashbvh : public Library {
 public:
  void set_meshes(const Mesh& a, const Mesh& b) override {
    a_ = &a;
    b_ = &b;
  }
  void set_pose(const Pose& pose) override { pose_ = pose; }
  uint32_t query(bool first) override {
    return first ? (intersects(*a_, *b_, pose_).yes ? 1 : 0) : count_pairs(*a_, *b_, pose_).count;
  }

 private:
  const Mesh* a_ = nullptr;
  const Mesh* b_ = nullptr;
  Pose pose_ = Pose::translated(0, 0, 0);
};

struct Named {
  const char* name;
  Library& library;
};

/// A pair of meshes and its poses: of scenes.py, then of a robot's links.
class Scene {
 public:
  explicit Scene(uint32_t number)
      : is_made_(number < kSceneCount),
        number_(is_made_ ? number : number - kSceneCount),
        pair_(is_made_ ? kScenes[number_] : kPairs[number_]) {}

  const LinkPair& pair() const { return pair_; }
  bool is_made() const { return is_made_; }
  uint32_t poses() const { return is_made_ ? kScenePosesOfClass : kPosesOfPair; }
  Pose pose(bool is_rotated, uint32_t proximity, uint32_t i) const {
    if (!is_made_) {
      return PoseKey{is_rotated, static_cast<Proximity>(proximity), number_, i}.pose();
    }
    const uint32_t set = (number_ * 2 + (is_rotated ? 1 : 0)) * kProximities + proximity;
    const int32_t(&from)[7] = kScenePoses[set * kScenePosesOfClass + i];
    const int32_t cells[3] = {from[4], from[5], from[6]};
    return Pose::rigid(test::rotation_of({from[0], from[1], from[2], from[3]}).entry, cells);
  }

 private:
  bool is_made_;
  uint32_t number_;
  const LinkPair& pair_;
};

struct Cost {
  uint64_t sum = 0;
  uint32_t most = 0;
  uint32_t found = 0;
  uint32_t count = 0;

  void add(Library& library, bool first) {
    const uint32_t instructions = port::instructions_of([&] { found += library.query(first); });
    sum += instructions;
    most = instructions > most ? instructions : most;
    ++count;
  }
  void print(const Scene& scene, bool is_rotated, const char* name, const char* library) const {
    const LinkPair& pair = scene.pair();
    port::print(FLASHBVH_CORE " ", scene.is_made() ? "made " : "links ", pair.a_name, "-",
                pair.b_name, is_rotated ? " rotated " : " translated ", name, " ", library, " ",
                static_cast<uint32_t>(sum / count), " ", most, " ", found, "\n");
  }
};

void query_class(const Scene& scene, bool is_rotated, uint32_t proximity, const Named& named) {
  Cost all;
  Cost first;
  for (uint32_t i = 0; i < scene.poses(); ++i) {
    named.library.set_pose(scene.pose(is_rotated, proximity, i));
    all.add(named.library, false);
    first.add(named.library, true);
  }
  all.print(scene, is_rotated, kProximityNames[proximity], named.name);
  if (static_cast<Proximity>(proximity) == Proximity::intersecting) {
    first.print(scene, is_rotated, "first", named.name);
  }
}

}  // namespace
}  // namespace compare

int main() {
  compare::WithFlashbvh itself;
  const compare::Named all[] = {
      {"flashbvh", itself}, {"opcode", compare::opcode()}, {"float", compare::float_tree()}};
  for (uint32_t number = 0; number < compare::kSceneCount + kLinkPairs; ++number) {
    const compare::Scene scene(number);
    for (const compare::Named& named : all) {
      named.library.set_meshes(*scene.pair().a, *scene.pair().b);
      for (const bool is_rotated : {false, true}) {
        for (uint32_t i = 0; i < kProximities; ++i) {
          compare::query_class(scene, is_rotated, i, named);
        }
      }
    }
  }
  return 0;
}
