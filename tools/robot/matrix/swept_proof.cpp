#include "robot/matrix/swept_proof.hpp"

#include <algorithm>

#include "robot/matrix/pair_search.hpp"
#include "robot/matrix/pair_space.hpp"
#include "robot/matrix/reaches.hpp"
#include "robot/matrix/swept_pair.hpp"

namespace flashbvh::tool {
namespace {

/// A part of Options::most_cells is all that a proof may take that may not work.
constexpr std::uint64_t kShare = 4;

/// Surfaces that meet nowhere in a box of values keep the side of each other that they have at any
/// place of it.
bool is_proven(const SweptPair& pair, std::size_t a, std::size_t b,
               const std::vector<SweptEnd>& ends, const MatrixOptions& options,
               const std::function<void(double)>& progress, std::uint64_t& cells, double distance) {
  const Mesh mesh_a = pair.a.view();
  const Mesh mesh_b = pair.b.view();
  const std::vector<double> reaches_a = reaches_of(pair.model, a, pair.cell);
  const std::vector<double> reaches_b = reaches_of(pair.model, b, pair.cell);
  const PairSpace space(pair.model, {a, &mesh_a, &reaches_a}, {b, &mesh_b, &reaches_b}, pair.cell);
  const SearchResult found = search_pair(space, options, progress, distance);
  cells += found.cells;
  if (found.end != SearchEnd::apart) {
    return false;
  }
  std::vector<double> middle;
  for (const Dimension& dimension : space.dimensions()) {
    middle.push_back(dimension.range.lower);
  }
  const Transform frame =
      frame_between(pair.model, joints_between(pair.model, a, b), space.variables_at(middle));
  return std::none_of(ends.begin(), ends.end(), [&](const SweptEnd& end) {
    return end.link == a ? is_any_inside(mesh_a, mesh_b, frame, pair.cell)
                         : is_any_inside(mesh_b, mesh_a, inverse(frame), pair.cell);
  });
}

}  // namespace

bool is_proven_swept(const Model& model, std::size_t a, std::size_t b, double cell,
                     const MatrixOptions& options, const std::function<void(double)>& progress,
                     std::uint64_t& cells, double distance) {
  const std::optional<SweptEnd> end_a = swept_end(model, a, b);
  const std::optional<SweptEnd> end_b = swept_end(model, b, a);
  std::vector<std::vector<SweptEnd>> choices;
  if (end_a && end_b && end_a->joint != end_b->joint) {
    choices.push_back({*end_a, *end_b});
  }
  for (const std::optional<SweptEnd>& end : {end_b, end_a}) {
    if (end) {
      choices.push_back({*end});
    }
  }
  MatrixOptions share = options;
  share.most_cells = options.most_cells / kShare;
  // The other link is rounded to the new lattice, and was to the old one.
  share.slack += 2 * kDeviation;
  return std::any_of(choices.begin(), choices.end(), [&](const std::vector<SweptEnd>& ends) {
    const SweptPair pair = swept_pair(model, a, b, cell, ends, kCoarse);
    return is_proven(pair, a, b, ends, share, progress, cells, distance);
  });
}

}  // namespace flashbvh::tool
