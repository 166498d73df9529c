// Pages that draw and answer: an interactive section, and tables of facts.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// True if the program was built with the library for interactive pages.
bool has_live_section();

/// A robot's trajectory, and its guard's verdicts.
struct LivePeriods {
  std::vector<float> values;       ///< of all periods, one after the other
  std::string verdicts;            ///< one digit per period
  std::vector<std::string> names;  ///< such as "line 12 (0.35)"
};

/// A ball that moves with a joint of the image.
struct LiveZone {
  std::size_t joint;
  std::array<double, 3> middle;  ///< in cells of the joint's frame
  double radius;                 ///< metres
};

/// HTML of the robot's image, the library and their script. `periods`: to play, or none. Hidden
/// without script; "" if the program was built without the library.
std::string live_section(const std::vector<std::uint32_t>& image,
                         const std::vector<LiveZone>& zones, const LivePeriods& periods = {});

/// Lines in a colour of the page, between pairs of the image's vertices.
struct LiveMarks {
  std::string colour;  ///< such as "p1"
  std::vector<std::uint32_t> vertices;
};

/// The largest number of meshes in an interactive page.
constexpr std::size_t kMostLiveMeshes = 64;

/// A post-indexed image with 16-bit indices.
struct LiveMesh {
  std::string name;
  std::string image;  ///< its bytes
  std::string unit;   ///< such as "mm"; may be empty
  std::vector<LiveMarks> marks;
};

/// Two of the meshes, by their indices, and poses of the second.
struct LivePair {
  std::size_t a;
  std::size_t b;
  std::vector<std::string> poses;  ///< each of 12 numbers
  std::vector<std::string> names;  ///< such as "pose 3"
  std::string verdicts;            ///< one digit per pose
};

/// HTML of meshes and pairs. `first`: the pair, or after all pairs the single mesh, to show first.
/// "" without meshes or library.
std::string live_section(const std::vector<LiveMesh>& meshes, const std::vector<LivePair>& pairs,
                         std::size_t first);

/// A whole page. `data`: JSON of its command, title, headlines (a verdict's digit and a text each),
/// facts (objects) and version; `section`: live_section().
std::string page_of(const std::string& data, const std::string& section);

}  // namespace flashbvh::tool
