#include "evaluate/queries.hpp"

#include <cmath>

#include "flashbvh/triangle.hpp"
#include "image/fine_length.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

double as_double(const std::uint64_t (&words)[2]) {
  return std::ldexp(static_cast<double>(words[0]), 64) + static_cast<double>(words[1]);
}

NearestPair nearest_pair(const FoundPair& ids, const Triangle& a, const Triangle& b) {
  const SquaredDistance squared = squared_distance(a, b);
  return {ids, std::sqrt(as_double(squared.above) / as_double(squared.below)),
          nearest_points_of(a, b)};
}

template <class Mesh>
ClearanceAnswer clearance_of(const Mesh& a, const Mesh& b, const Pose& pose,
                             Witness<std::uint32_t>& hint) {
  using Index = typename Mesh::Index;
  Witness<Index> begin;
  if (!hint.is_none()) {
    begin = {static_cast<Index>(hint.a), static_cast<Index>(hint.b)};
  }
  BasicClearanceQuery<Mesh> query(a, b, pose, begin);
  ClearanceAnswer answer;
  (void)query.run(UINT32_MAX);
  const Clearance<Index> found = query.result();
  answer.status = found.status;
  answer.in_range = found.in_range;
  if (found.status != Status::done) {
    return answer;
  }
  answer.visits = query.stats().visits;
  answer.triangle_pairs = query.triangle_tests();
  answer.lower = found.lower;
  answer.upper = found.upper;
  if (!found.in_range) {
    hint = {};
    return answer;
  }
  hint = {found.witness.a, found.witness.b};
  Triangle of_a;
  Triangle of_b;
  query.nearest_triangles(of_a, of_b);
  answer.nearest = nearest_pair({found.triangles.a, found.triangles.b}, of_a, of_b);
  return answer;
}

}  // namespace

void check_has_clearance(const ImageFile& image) {
  if (image.layout() != Layout::post_indexed) {
    throw UserError(image.path(),
                    "is pre-indexed, which has no distances; bake it with --layout post");
  }
}

FineLength fine_length(double length, double cell, std::uint32_t most) {
  const FineLength fine = fine_length_rounded_up(length, cell);
  if (fine.count > most) {
    throw UserError("--within " + shortest(length), "is out of range: 0 to ",
                    significant(most * cell / kFineOne, 6), ", ", most / kFineOne,
                    " cells; bake with a larger --cell to reach further");
  }
  return fine;
}

ClearanceAnswer clearance(const AnyTree& a, const AnyTree& b, const Pose& pose,
                          Witness<std::uint32_t>& hint) {
  const auto query = [&](const auto& mesh_a, const auto& mesh_b) {
    return clearance_of(mesh_a, mesh_b, pose, hint);
  };
  return query_post<ClearanceAnswer>(query, a, b).value();
}

}  // namespace flashbvh::tool
