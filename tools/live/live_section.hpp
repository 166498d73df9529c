// The section of a page in which a robot answers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace flashbvh::tool {

/// Whether the program was built with the library that answers.
bool has_live_section();

/// Where a robot goes, and what its guard said there.
struct LivePeriods {
  std::vector<float> values;       ///< so many a period, one after the other
  std::string verdicts;            ///< a digit a period
  std::vector<std::string> names;  ///< "line 12 (0.35)"
};

/// A ball that moves with a joint of the image.
struct LiveZone {
  std::size_t joint;
  std::array<double, 3> middle;  ///< in cells of the joint's frame
  double radius;                 ///< metres
};

/// HTML: the robot's image, the library, and their script. `periods`: to be played, or
/// none. Without script it stays hidden; "" if the program was built without the library.
std::string live_section(const std::vector<std::uint32_t>& image,
                         const std::vector<LiveZone>& zones, const LivePeriods& periods = {});

/// Lines of a colour of the page, between each two vertices of the image.
struct LiveMarks {
  std::string colour;  ///< "p1"
  std::vector<std::uint32_t> vertices;
};

/// Most meshes of a page that answer.
constexpr std::size_t kMostLiveMeshes = 64;

/// A post-indexed image with 16-bit indices.
struct LiveMesh {
  std::string name;
  std::string image;  ///< its bytes
  std::string unit;   ///< "mm"; may be none
  std::vector<LiveMarks> marks;
};

/// Two of the meshes, by their places, and where the second was.
struct LivePair {
  std::size_t a;
  std::size_t b;
  std::vector<std::string> poses;  ///< 12 numbers each
  std::vector<std::string> names;  ///< "pose 3"
  std::string verdicts;            ///< a digit a pose
};

/// The same of meshes. `first`: the pair that is shown first, or behind all pairs a mesh alone. ""
/// without meshes, too.
std::string live_section(const std::vector<LiveMesh>& meshes, const std::vector<LivePair>& pairs,
                         std::size_t first);

/// A mesh on what was baked of it, about where they are farthest apart, in steps of any length.
struct LiveDeviation {
  std::string name;
  std::vector<std::int16_t> original;  ///< nine a triangle
  std::vector<std::int16_t> coarse;
  double most;       ///< the deviation
  std::string text;  ///< the same with its unit
};

/// HTML: a section in which one of them is turned. Needs no library; hidden without script.
std::string deviation_section(const std::vector<LiveDeviation>& meshes);

}  // namespace flashbvh::tool
