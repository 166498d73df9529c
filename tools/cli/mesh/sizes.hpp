// How large meshes are, in words, and which are of another unit by the look of it.
#ifndef FLASHBVH_TOOLS_CLI_SIZES_HPP
#define FLASHBVH_TOOLS_CLI_SIZES_HPP

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "bake/mesh.hpp"

namespace flashbvh::tool {

/// Of a box that holds a mesh, along x, y and z.
using Size = std::array<double, 3>;

/// In the mesh's unit; zeros if it has no vertex.
Size size_of(const bake::SourceMesh& mesh);

/// "0.21 x 0.1 x 0.1 m", three digits each. `unit` may be empty.
std::string size_text(const Size& size, const std::string& unit);

/// A mesh that is at least kOddSize times as long as the others' median, or at most 1/kOddSize.
constexpr double kOddSize = 50;
struct OddSize {
  std::size_t which;
  double times;  ///< the others' median, by the longest side
};

/// In ascending order. Of two meshes the larger one alone.
std::vector<OddSize> odd_sizes(const std::vector<Size>& sizes);

/// "1000 times as long as the other links", "1/400 times as long as ..."; `others`: "links".
std::string odd_size_text(const OddSize& odd, const std::string& others);

}  // namespace flashbvh::tool

#endif
