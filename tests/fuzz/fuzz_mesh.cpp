// Any bytes as a mesh file: a mesh, or a message of one line, in bounded time and memory.
//
// The input is a line that names the format (stl, obj, off, ply), then the file. Read by the strict
// readers; what they take is read by assimp, too, as `bake` does.
#include <unistd.h>

#include <fstream>
#include <string>

#include "fuzz/fuzz.hpp"
#include "mesh/formats.hpp"
#include "mesh/import.hpp"
#include "text/messages.hpp"

using namespace flashbvh;
using flashbvh::test::require;

namespace {

tool::MeshText read_strictly(const std::string& format, const std::string& file) {
  if (format == "stl") {
    return tool::plain_stl(file, "fuzzed");
  }
  if (format == "obj") {
    return tool::plain_obj(file, "fuzzed");
  }
  return format == "off" ? tool::plain_off(file, "fuzzed") : tool::plain_ply(file, "fuzzed");
}

void read_as_bake_does(const std::string& format, const std::string& file) {
  const std::string path = "/tmp/fuzz_mesh." + std::to_string(getpid()) + "." + format;
  std::ofstream(path, std::ios::binary) << file;
  try {
    tool::Warnings warnings;
    const bake::SourceMesh mesh = tool::import_mesh(path, warnings);
    for (const bake::TriangleCorners& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) {
        require(corner < mesh.vertices.size(), "a corner that is no vertex");
      }
    }
    require(!mesh.triangles.empty(), "a mesh without triangles");
  } catch (const tool::UserError&) {
  }
  unlink(path.c_str());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(bytes), size);
  const std::string format = input.substr(0, input.find('\n'));
  const std::string file = input.size() > 4 ? input.substr(4) : std::string();
  // read_file() takes no empty files.
  if ((format != "stl" && format != "obj" && format != "off" && format != "ply") || file.empty()) {
    return 0;
  }
  try {
    const tool::MeshText text = read_strictly(format, file);
    require(text.face_count != 0 && !text.bytes.empty(), "a mesh of nothing");
  } catch (const tool::UserError& error) {
    require(std::string(error.what()).find("fuzzed") == 0, "a message that does not name the file");
    return 0;
  }
  read_as_bake_does(format, file);
  return 0;
}
