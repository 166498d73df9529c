// Arbitrary bytes as a mesh file: a mesh, or a message of one line, in bounded time and memory.
//
// The input is a line that names the format (stl, obj, ply), then the file.
#include <algorithm>

#include "fuzz/fuzz.hpp"
#include "mesh/any_format.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

void check(const tool::FileMesh& file) {
  const bake::SourceMesh& mesh = file.mesh;
  require(!mesh.triangles.empty(), "a mesh without triangles");
  for (const bake::TriangleCorners& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      require(corner < mesh.vertices.size(), "a corner that is no vertex");
    }
  }
  for (const auto& vertex : mesh.vertices) {
    for (const double at : vertex) {
      require(tool::is_coordinate(at), "a coordinate that firmware can't hold");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(bytes), size);
  const std::string name = input.substr(0, input.find('\n'));
  const std::string file = input.size() > 4 ? input.substr(4) : std::string();
  const auto* const format =
      std::find_if(kTextFormats.begin(), kTextFormats.end(),
                   [&](const TextFormat& known) { return known.name == name; });
  if (format == kTextFormats.end() || file.empty()) {  // read_file() accepts no empty files
    return 0;
  }
  try {
    check(format->read(file, "fuzzed"));
  } catch (const tool::UserError& error) {
    require(std::string(error.what()).find("fuzzed") == 0, "a message that does not name the file");
  }
  return 0;
}
