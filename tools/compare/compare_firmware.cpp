// Measures instructions of a query by flashbvh, OPCODE and a tree of floats, for each pair of
// links and class of poses in lib/docs/figures.md. Prints lines:
//     CORE A-B MOTION CLASS LIBRARY mean most pairs-found
#include <initializer_list>

#include "flashbvh/collide.hpp"

#include "insn.hpp"
#include "library.hpp"
#include "links.hpp"
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
  void print(const LinkPair& pair, const char* motion, const char* name,
             const char* library) const {
    port::print(FLASHBVH_CORE " ", pair.a_name, "-", pair.b_name, " ", motion, " ", name, " ",
                library, " ", static_cast<uint32_t>(sum / count), " ", most, " ", found, "\n");
  }
};

struct Named {
  const char* name;
  Library& library;
};

void query_class(PoseKey key, const Named& named) {
  Cost all;
  Cost first;
  for (key.number = 0; key.number < kPosesOfPair; ++key.number) {
    named.library.set_pose(key.pose());
    all.add(named.library, false);
    first.add(named.library, true);
  }
  const LinkPair& pair = kPairs[key.pair];
  all.print(pair, key.motion(), key.proximity_name(), named.name);
  if (key.proximity == Proximity::intersecting) {
    first.print(pair, key.motion(), "first", named.name);
  }
}

}  // namespace
}  // namespace compare

int main() {
  compare::WithFlashbvh itself;
  const compare::Named all[] = {
      {"flashbvh", itself}, {"opcode", compare::opcode()}, {"float", compare::float_tree()}};
  for (uint32_t p = 0; p < kLinkPairs; ++p) {
    for (const compare::Named& named : all) {
      named.library.set_meshes(*kPairs[p].a, *kPairs[p].b);
      for (const bool is_rotated : {false, true}) {
        for (uint32_t i = 0; i < kProximities; ++i) {
          compare::query_class({is_rotated, static_cast<Proximity>(i), p, 0}, named);
        }
      }
    }
  }
  return 0;
}
