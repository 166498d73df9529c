// A reader in its own process: whatever it does, the caller gets a mesh or a message.
#include <unistd.h>
#include <csignal>
#include <stdexcept>

#include "mesh/any_format.hpp"
#include "mesh/guarded_import.hpp"
#include "support/test.hpp"

using tool::FileMesh;

namespace {

constexpr tool::ImportLimits kLimits = {256 << 20, 1};

FileMesh two_bodies() {
  tool::MeshBuilder builder("file");
  builder.begin_body("left");
  builder.add_triangle({{{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}}});
  builder.begin_body("");
  builder.add_triangle({{{0, 0, 0}, {0.1, 0, 0}, {0, -3e38, 0}}});
  FileMesh mesh = builder.finish();
  mesh.precision = 0.25;
  mesh.unit = Unit::inch;
  mesh.warnings = {"one", "", "three"};
  return mesh;
}

/// The caller's message for this reader.
std::string said_of(const std::function<FileMesh()>& read) {
  return refusal([&](const std::string&,
                     const std::string& file) { return guarded_import(read, file, kLimits); },
                 "");
}

}  // namespace

TEST_CASE("a guarded reader's mesh arrives whole") {
  const FileMesh sent = two_bodies();
  const FileMesh found = tool::guarded_import(two_bodies, "file", kLimits);
  CHECK(found.mesh.vertices == sent.mesh.vertices);
  CHECK(found.mesh.triangles == sent.mesh.triangles);
  CHECK(found.bodies == sent.bodies);
  CHECK(found.body_of == sent.body_of);
  CHECK(found.precision == sent.precision);
  CHECK(found.unit == sent.unit);
  CHECK(found.warnings == sent.warnings);
}

TEST_CASE("however a guarded reader fails, the caller gets a message") {
  const std::string fix = "; export the mesh again, or as STL or PLY";
  CHECK(said_of([]() -> FileMesh { throw tool::UserError("file", "is odd: why"); }) ==
        "file: is odd: why");
  CHECK(said_of([]() -> FileMesh { throw std::runtime_error("odd"); }) ==
        "file: can't be read: odd" + fix);
  for (const int crash : {SIGABRT, SIGSEGV, SIGKILL}) {
    CHECK(said_of([&]() -> FileMesh {
            raise(crash);
            return two_bodies();
          }) == tool::concat("file: can't be read: its reader crashed (signal ", crash, ")") + fix);
  }
  for (const int code : {0, 3}) {
    CHECK(said_of([&]() -> FileMesh { _exit(code); }) ==
          tool::concat("file: can't be read: its reader crashed (exit code ", code, ")") + fix);
  }
  CHECK(said_of([] { return FileMesh(); }) == "file: can't be read: its reader gave no mesh" + fix);
}

TEST_CASE("a guarded reader that never ends or always grows is ended") {
  CHECK(said_of([]() -> FileMesh {
          for (volatile int i = 0;; i = i ^ 1) {
          }
        }) ==
        "file: can't be read: takes over 1 s of processor time; export the mesh again, or as "
        "STL or PLY");
  CHECK(said_of([]() -> FileMesh {
          std::vector<std::string> all;
          for (;;) {
            all.emplace_back(1 << 20, 'x');
          }
        }) ==
        "file: can't be read: takes over 256 MiB of memory; export the mesh again, or as STL "
        "or PLY");
}

TEST_CASE("bytes that are not those of a mesh are refused") {
  const FileMesh mesh = two_bodies();
  const std::string bytes = tool::bytes_of(mesh);
  REQUIRE(tool::mesh_of_bytes(bytes));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    CHECK(!tool::mesh_of_bytes(bytes.substr(0, size)));
  }
  CHECK(!tool::mesh_of_bytes(bytes + "x"));
  const auto is_taken = [&](const std::function<void(FileMesh&)>& damage) {
    FileMesh damaged = mesh;
    damage(damaged);
    return tool::mesh_of_bytes(tool::bytes_of(damaged)).has_value();
  };
  CHECK(is_taken([](FileMesh&) {}));
  CHECK(!is_taken([](FileMesh& m) { m.mesh.triangles[1][2] = 4; }));
  CHECK(!is_taken([](FileMesh& m) { m.mesh.vertices[1][2] = 4e38; }));
  CHECK(!is_taken([](FileMesh& m) { m.body_of[1] = 2; }));
  CHECK(!is_taken([](FileMesh& m) { m.unit = static_cast<Unit>(kUnitCount); }));
  CHECK(!is_taken([](FileMesh& m) { m.body_of.pop_back(); }));
}
