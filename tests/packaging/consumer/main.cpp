// Ends with 0 if the peg touches nothing above the plate and touches it below.
#include <flashbvh/flashbvh.hpp>

#include "peg.fbvh.hpp"
#include "plate.fbvh.hpp"

namespace {

bool touches(double height) {
  const auto cells = static_cast<int32_t>(height / plate::kCell);
  const auto pose = flashbvh::Pose::translated(0, 0, cells);
  flashbvh::PairQuery query(plate::mesh, peg::mesh, pose);
  flashbvh::PairQuery::Pair found[8];
  return query.run(0xFFFF, found).count != 0;
}

}  // namespace

int main() {
  return !touches(0.5) && touches(-2) ? 0 : 1;
}
