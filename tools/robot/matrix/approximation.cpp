#include "robot/matrix/approximation.hpp"

#include <algorithm>
#include <numeric>

#include "robot/matrix/zone_side.hpp"
#include "simplify/coarsening.hpp"
#include "text/parallel.hpp"

namespace flashbvh::tool {
namespace {

/// A link with fewer triangles is fast enough itself.
constexpr std::size_t kManyTriangles = 8000;
/// The smallest useful length, in cells.
constexpr double kLeastCellsOfLength = 8;
/// The length as a part of the distance that counts as contact: a zone needs no better accuracy.
constexpr double kPartOfTouching = 1.0 / 8;

/// Coarsens within `length`, source by source, shell by shell. None if the link has few triangles,
/// `length` is only a few cells, or the number of shells changes.
std::optional<Approximation> approximation(const ModelLink& link, double cell, double length,
                                           const Deadline& deadline) {
  const std::size_t count = link.mesh.triangles.size();
  if (count < kManyTriangles || length < kLeastCellsOfLength * cell) {
    return std::nullopt;
  }
  Approximation made;
  made.length = length;
  made.link.name = link.name;
  made.link.joint = link.joint;
  made.link.precision = link.precision;
  for (std::size_t i = 0; i < link.source_begins.size(); ++i) {
    const std::size_t begin = link.source_begins[i];
    const std::size_t end = i + 1 < link.source_begins.size() ? link.source_begins[i + 1] : count;
    made.link.source_begins.push_back(made.link.mesh.triangles.size());
    if (begin == end) {
      continue;
    }
    std::vector<std::uint32_t> numbers(end - begin);
    std::iota(numbers.begin(), numbers.end(), static_cast<std::uint32_t>(begin));
    simplify::Coarsening coarsening(part_of(link.mesh, numbers), cell);
    coarsening.coarsen(length, deadline);
    append(coarsening.mesh(), made.link.mesh);
  }
  if (ZoneSide(made.link, Transform()).shell_count() != ZoneSide(link, Transform()).shell_count()) {
    return std::nullopt;
  }
  made.baked = bake_part(made.link.mesh, cell);
  return made;
}

}  // namespace

std::vector<std::optional<Approximation>> approximations(const Model& model, double cell,
                                                         const MatrixOptions& options) {
  std::vector<std::optional<Approximation>> found(model.links.size());
  const double length = kPartOfTouching * cell * (options.stop + options.early + options.slack);
  for_each_in_parallel(found.size(), [&](std::size_t i) {
    const bool is_next_to_joint =
        std::any_of(model.neighbours.begin(), model.neighbours.end(),
                    [&](const auto& pair) { return pair.first == i || pair.second == i; });
    if (is_next_to_joint && !options.is_late()) {
      found[i] = approximation(model.links[i], cell, length, options.deadline);
    }
  });
  return found;
}

}  // namespace flashbvh::tool
