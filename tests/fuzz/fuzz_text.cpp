// Arbitrary bytes as one of the tool's text formats other than meshes: read, or refused with a
// message that names the place.
//
// The input: a line with the kind (urdf, srdf, poses, values: a trajectory), then the file.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <string>

#include "evaluate/poses.hpp"
#include "fuzz/fuzz.hpp"
#include "robot/read/urdf.hpp"
#include "robot/replay/replay.hpp"

using namespace flashbvh;
using namespace flashbvh::tool;
using flashbvh::test::require;

namespace {

/// A file in memory, with a path.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& text) : handle_(memfd_create("fuzzed", 0)) {
    const bool whole = handle_ >= 0 && write(handle_, text.data(), text.size()) ==
                                           static_cast<ssize_t>(text.size());
    if (!whole) {
      std::abort();
    }
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { close(handle_); }

  std::string path() const { return "/proc/self/fd/" + std::to_string(handle_); }

 private:
  int handle_;
};

/// Two joints, one of them without limits; three links, two of them with primitives.
const char* const kArm = R"(<robot name="arm"><link name="base"><collision><geometry>
<sphere radius="0.1"/></geometry></collision></link><link name="middle"/><link name="hand"><collision>
<geometry><box size="0.1 0.2 0.3"/></geometry></collision></link>
<joint name="turn" type="continuous"><parent link="base"/><child link="middle"/></joint>
<joint name="lift" type="revolute"><parent link="middle"/><child link="hand"/><axis xyz="0 1 0"/>
<limit lower="-1" upper="2" effort="1" velocity="1"/></joint></robot>)";

const Model& arm() {
  static const Model model = [] {
    Warnings warnings;
    return read_urdf(MemoryFile(kArm).path(), {}, "", warnings);
  }();
  return model;
}

void check(const Model& model) {
  require(!model.links.empty(), "a robot without links");
  for (const ModelJoint& joint : model.joints) {
    require(std::isfinite(joint.lower) && std::isfinite(joint.upper), "limits that are no numbers");
  }
}

void read(const std::string& kind, const std::string& path) {
  Warnings warnings;
  if (kind == "urdf") {
    check(read_urdf(path, {}, "", warnings));
  } else if (kind == "srdf") {
    (void)read_srdf(path, arm(), warnings);
  } else if (kind == "poses") {
    (void)read_lattice_poses(path, 0.001);
  } else {
    const Trajectory values = read_trajectory(path, arm(), warnings);
    for (std::size_t period = 0; period < values.size(); ++period) {
      for (std::size_t i = 0; i < values.variables; ++i) {
        require(std::isfinite(values.values(period)[i]), "a value that is no number");
      }
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(bytes), size);
  const std::size_t end = input.find('\n');
  const std::string kind = input.substr(0, end);
  if (end == std::string::npos ||
      (kind != "urdf" && kind != "srdf" && kind != "poses" && kind != "values")) {
    return 0;
  }
  const MemoryFile file(input.substr(end + 1));
  try {
    read(kind, file.path());
  } catch (const UserError& error) {
    const std::string what = error.what();
    require(what.find(file.path()) == 0, "a message that does not name the file");
    require(what.find('\n') == std::string::npos, "a message of several lines");
  }
  return 0;
}
