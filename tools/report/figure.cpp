#include "report/figure.hpp"

#include <cmath>

#include "mesh/units.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

constexpr std::int64_t kStrip = 120;  ///< height of what lies below the picture
constexpr std::int64_t kArrow = 55;   ///< an axis's length

/// The axes as arrows; none for the one along which one looks.
std::string axes(const View& view) {
  constexpr std::int64_t x = 80;
  constexpr std::int64_t y = kDrawingSide + 60;
  constexpr std::array<const char*, 3> names = {"x", "y", "z"};
  std::string svg;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t to_x = view.right[axis] * kArrow / View::kUnit;
    const std::int64_t to_y = -view.up[axis] * kArrow / View::kUnit;
    if (to_x != 0 || to_y != 0) {
      svg += concat("<path class=axis d=\"M", x, " ", y, "l", to_x, " ", to_y,
                    "\"/><text x=", x + to_x * 135 / 100, " y=", y + to_y * 135 / 100, ">",
                    names[axis], "</text>\n");
    }
  }
  return svg;
}

/// The longest of 1, 2 or 5 times a power of ten that takes at most a third of the side.
double scale_length(double across) {
  const double most = across / 3;
  const double power = std::pow(10, std::floor(std::log10(most)));
  return power * (most < 2 * power ? 1 : most < 5 * power ? 2 : 5);
}

std::string length_of(const std::string& suffix, double length) {
  const double size = std::fabs(length);
  return (size >= 1e4 && size < 1e9 ? fixed(length, 0) : significant(length, 4)) + suffix;
}

std::string scale_bar(const Frame& frame, const Measure& measure) {
  const double across = static_cast<double>(frame.across) * measure.cell;
  const double length = scale_length(across);
  const auto units = static_cast<std::int64_t>(std::llround(kDrawingSide * length / across));
  const std::int64_t right = kDrawingSide - 40;
  const std::int64_t y = kDrawingSide + 80;
  return concat("<path class=axis d=\"M", right - units, " ", y - 14, "v28m0-14h", units,
                "m0-14v28\"/><text x=", right - units / 2, " y=", y - 38, ">",
                length_of(measure.suffix, length), "</text>\n");
}

}  // namespace

Measure measure_of(const ImageFile& image) {
  return {image.cell(), unit_suffix(image)};
}

std::string unit_suffix(const ImageFile& image) {
  const std::string unit = unit_name(image.unit());
  return unit.empty() ? "" : " " + unit;
}

std::string length_of(const ImageFile& image, double length) {
  return length_of(unit_suffix(image), length);
}

std::string figure(const Faces& faces, const Frame& frame, const Measure& measure,
                   const std::string& label, const std::string& overlay,
                   const std::string& caption) {
  return concat("<figure><svg viewBox=\"0 0 ", kDrawingSide, " ", kDrawingSide + kStrip,
                "\" role=img aria-label=\"", label, "\">\n", drawing(faces, frame), overlay,
                axes(frame.view), scale_bar(frame, measure), "</svg><figcaption>", caption,
                "</figcaption></figure>\n");
}

}  // namespace flashbvh::tool
