// Pixels as an address that a page can show.
#ifndef FLASHBVH_TOOLS_REPORT_PNG_HPP
#define FLASHBVH_TOOLS_REPORT_PNG_HPP

#include <cstdint>
#include <string>

namespace flashbvh::tool {

/// A square.
struct Picture {
  std::uint32_t side;
  std::string pixels;  ///< row by row from the top, four bytes each: red, green, blue, opacity
};

/// The picture as a PNG, in a "data:" address.
std::string data_uri(const Picture& picture);

}  // namespace flashbvh::tool

#endif
