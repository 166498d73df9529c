// Pictures of few colours as PNG, to be embedded in a page.
#ifndef FLASHBVH_TOOLS_REPORT_PNG_HPP
#define FLASHBVH_TOOLS_REPORT_PNG_HPP

#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::tool {

struct Colour {
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
  std::uint8_t alpha;  ///< 255 is opaque
};

struct Picture {
  std::uint32_t width;
  std::uint32_t height;
  std::vector<Colour> palette;  ///< 1 to 256
  std::string pixels;           ///< width * height places in the palette, row by row
};

/// A `data:` address that holds the picture as PNG.
std::string data_uri(const Picture& picture);

}  // namespace flashbvh::tool

#endif
