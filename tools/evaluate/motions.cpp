#include "evaluate/motions.hpp"

#include <cmath>

#include "evaluate/poses.hpp"
#include "evaluate/queries.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// "2^19 cells, 5242.88".
std::string farthest(double cell) {
  constexpr std::int32_t cells = kMaxFrameTranslation / kFrameCell;
  return concat("2^", std::ilogb(cells), " cells, ", significant(cells * cell, 6));
}

template <class Mesh>
FoundContact contact_of(const Mesh& a, const Mesh& b, const BodyMotion& motion, FineLength within) {
  BasicFirstContact<Mesh> query(a, b, motion, within);
  const auto answer = query.run(UINT32_MAX);
  return {{answer.status,
           answer.outcome,
           {answer.triangles.a, answer.triangles.b},
           answer.from,
           answer.to},
          query.close_distance()};
}

}  // namespace

Pose read_pose_argument(const std::string& given, double cell, const std::string& option) {
  const std::size_t count = words_of(given).size();
  if (count != 3 && count != 12) {
    throw UserError(option, "has ", count,
                    " numbers; write 12, the rotation row by row and the translation, or 3, the "
                    "translation alone, separated by blanks");
  }
  return read_lattice_pose((count == 3 ? "1 0 0 0 1 0 0 0 1 " : "") + given, cell, option);
}

FoundContact first_contact(const ImageFile& a, const ImageFile& b, const BodyMotion& motion,
                           FineLength within) {
  const std::optional<FoundContact> found = query_post<FoundContact>(
      [&](const auto& mesh_a, const auto& mesh_b) {
        return contact_of(mesh_a, mesh_b, motion, within);
      },
      a.tree(), b.tree());
  const Status status = found.value().status;
  if (status == Status::motion_out_of_range) {
    throw UserError("--to", "may take B farther than ", farthest(a.cell()),
                    ", from A's origin; cut the motion, or bake with a larger --cell, or draw the "
                    "meshes nearer to their origins");
  }
  if (status != Status::done) {
    throw UserError("--to", "can't be answered: ", status_name(status));
  }
  return *found;
}

const char* outcome_name(ContactOutcome outcome) {
  constexpr const char* kNames[] = {"free", "contact", "close"};
  return kNames[static_cast<std::size_t>(outcome)];
}

}  // namespace flashbvh::tool
