#include "cli/mesh/sizes.hpp"

#include <algorithm>

#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

double longest_side(const Size& size) {
  return *std::max_element(size.begin(), size.end());
}

/// Three digits, without an exponent where it is large.
std::string side_text(double side) {
  return side >= 100 && side < 1e9 ? fixed(side, 0) : significant(side, 3);
}

/// How many times as long as the median of all but one; 1 if there is none. Of an even number of
/// sides the median that is nearer counts.
double times_the_others(std::vector<double> sides, std::size_t which) {
  const double side = sides[which];
  sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(which));
  std::sort(sides.begin(), sides.end());
  if (sides.empty() || sides[(sides.size() - 1) / 2] <= 0) {
    return 1;
  }
  return side / std::clamp(side, sides[(sides.size() - 1) / 2], sides[sides.size() / 2]);
}

}  // namespace

Size size_of(const bake::SourceMesh& mesh) {
  Size size{};
  for (std::size_t axis = 0; axis < 3 && !mesh.vertices.empty(); ++axis) {
    const auto [least, most] =
        std::minmax_element(mesh.vertices.begin(), mesh.vertices.end(),
                            [&](const auto& u, const auto& v) { return u[axis] < v[axis]; });
    size[axis] = (*most)[axis] - (*least)[axis];
  }
  return size;
}

std::string size_text(const Size& size, const std::string& unit) {
  return concat(side_text(size[0]), " x ", side_text(size[1]), " x ", side_text(size[2]),
                unit.empty() ? "" : " ", unit);
}

std::vector<OddSize> odd_sizes(const std::vector<Size>& sizes) {
  std::vector<double> sides(sizes.size());
  std::transform(sizes.begin(), sizes.end(), sides.begin(), longest_side);
  std::vector<OddSize> odd;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const double times = times_the_others(sides, i);
    if (times >= kOddSize || (times <= 1 / kOddSize && sides.size() > 2)) {
      odd.push_back({i, times});
    }
  }
  return odd;
}

std::string odd_size_text(const OddSize& odd, const std::string& others) {
  return concat(
      odd.times > 0 && odd.times < 1 ? "1/" + side_text(1 / odd.times) : side_text(odd.times),
      " times as long as the other ", others);
}

}  // namespace flashbvh::tool
