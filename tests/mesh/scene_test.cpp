// DAE and glTF: what assimp would misread is refused by its name.
#include <fstream>

#include "mesh/any_format.hpp"
#include "support/test.hpp"

using tool::FileMesh;

namespace {

/// A tetrahedron of volume 1/6; its buffer is a file.
const std::string kGltf =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},
                 {"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}],
    "bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
    "buffers":[{"byteLength":72,"uri":"tetrahedron.bin"}]})";

const std::string kCollada =
    R"(<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
    <asset><unit meter="0.0254"/></asset><library_geometries><geometry id="g"><mesh>
    <source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
    <technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
    <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
    </source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
    <p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
    <library_visual_scenes><visual_scene id="s"><node id="n"><scale>1 1 1</scale>
    <instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
    <scene><instance_visual_scene url="#s"/></scene></COLLADA>)";

/// Writes a file of this text, and the glTF's buffer, for one reading.
std::string written(const std::string& text, const std::string& extension,
                    std::uint16_t last_corner = 3) {
  const std::array<float, 12> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<std::uint16_t, 12> corners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, last_corner};
  std::ofstream buffer("tetrahedron.bin", std::ios::binary);
  buffer.write(reinterpret_cast<const char*>(points.data()), sizeof points);
  buffer.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
  const std::string path = "scene_test." + extension;
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

FileMesh read(const std::string& text, const std::string& extension) {
  return tool::read_with_assimp(text, written(text, extension));
}

}  // namespace

TEST_CASE("a glTF is in metres, its mirrored nodes are no inside out solids") {
  const FileMesh mesh = read(kGltf, "gltf");
  CHECK(mesh.unit == Unit::m);
  CHECK(volume6(mesh) == Approx(1));
  const FileMesh mirrored =
      read(with(kGltf, R"("mesh":0)", R"("mesh":0,"scale":[-2,1,1])"), "gltf");
  CHECK(volume6(mirrored) == Approx(2));
  CHECK(mirrored.mesh.vertices[1][0] == -2);
  const FileMesh turned_back = read(
      with(kGltf, R"("mesh":0)", R"("children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[1,-1,1])"),
      "gltf");
  CHECK(volume6(turned_back) == Approx(1));
}

TEST_CASE("glTF: what moves no vertex may be required") {
  const std::string used = R"("extensionsRequired":["KHR_texture_transform","KHR_materials_ior",
      "KHR_mesh_quantization","EXT_texture_webp","KHR_lights_punctual"],"scene":0)";
  CHECK(read(with(kGltf, R"("scene":0)", used), "gltf").mesh.triangles.size() == 4);
  const FileMesh mesh =
      read(with(kGltf, R"("scene":0,"scenes":[)", R"("scenes":[{"nodes":[0]},)"), "gltf");
  CHECK(mesh.warnings ==
        std::vector<std::string>{"has 2 scenes and no default; the first alone is read"});
}

TEST_CASE("glTF: what is not read is refused by its name") {
  const Change changes[] = {
      {R"("scene":0)", R"("extensionsRequired":["VENDOR_x"],"scene":0)",
       "requires the extension VENDOR_x"},
      {R"("mesh":0)", R"("mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}})",
       "node 0 uses the extension EXT_mesh_gpu_instancing"},
      {R"("mesh":0)", R"("mesh":0,"extensions":{"KHR_node_visibility":{"visible":false}})",
       "node 0 uses the extension KHR_node_visibility"},
      {R"("indices":1)", R"("indices":1,"extensions":{"VENDOR_x":{}})",
       "mesh 0 uses the extension VENDOR_x"},
      {R"("byteLength":48)", R"("byteLength":48,"extensions":{"EXT_meshopt_compression":{}})",
       "a buffer view uses the extension EXT_meshopt_compression"},
      {R"("indices":1)",
       R"("indices":1,"mode":5,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0}})",
       "mesh 0 is compressed by KHR_draco_mesh_compression"},
      {R"("mesh":0)", R"("mesh":0,"skin":0)", "node 0 has a skin"},
      {R"("mesh":0)", R"("mesh":0,"weights":[0,0.5])", "node 0 has weights of morph targets"},
      {R"({"primitives")", R"({"weights":[1],"primitives")", "node 0 has weights of morph targets"},
      {"5126", "5123", "KHR_mesh_quantization"},
      {"5126", "5120", "KHR_mesh_quantization"},
      {"VEC3", "VEC2", "accessor 0 has components of type 5126 in a VEC2"},
      {"5123", "5122", "accessor 1 has components of type 5122"},
      {R"("count":4)", R"("count":4,"sparse":{})", "accessor 0 is sparse"},
      {R"("count":12)", R"("count":11)", "mesh 0 has 11 corners"},
      {R"("count":12)", R"("count":15)", "accessor 1 ends behind its data"},
      {R"("bufferView":0)", R"("bufferView":0,"byteOffset":4)", "accessor 0 ends behind its data"},
      {R"("bufferView":0,)", "", "accessor 0 has no data"},
      {R"("indices":1)", R"("indices":1,"mode":7)", "a primitive of mode 7"},
      {R"("POSITION":0)", R"("NORMAL":0)", "a primitive of mode 4 without positions"},
      {R"("version")", R"("minVersion":"2.1","version")", "is of glTF '2.1'"},
      {R"("nodes":[0])", R"("nodes":[0,0])", "node 0 has two parents"}};
  for (const auto& [part, by, said] : changes) {
    CAPTURE(part, by);
    const std::string text = with(kGltf, part, by);
    CHECK_THAT(refusal(tool::read_with_assimp, text, written(text, "gltf")),
               Catch::Matchers::Contains(said));
  }
}

TEST_CASE("glTF: a triangle with a corner at no vertex is not left out in silence") {
  CHECK_THAT(refusal(tool::read_with_assimp, kGltf, written(kGltf, "gltf", 4)),
             Catch::Matchers::Contains("has 4 triangles, of which assimp reads 3"));
}

TEST_CASE("a DAE's unit applies, its mirrored nodes are no inside out solids") {
  const double inch = 0.0254 * 0.0254 * 0.0254;
  CHECK(volume6(read(kCollada, "dae")) == Approx(inch));
  const std::string mirrored = with(kCollada, "<scale>1 1 1", "<scale>-1 1 1");
  CHECK(volume6(read(mirrored, "dae")) == Approx(inch));
}

TEST_CASE("DAE: what is not read is refused by its name") {
  const Change changes[] = {
      {"<instance_geometry url=\"#g\"/>", "<instance_controller url=\"#g\"/>",
       "has a <instance_controller>, a skin or a morph"},
      {"<scale>", "<skew>45 1 0 0 0 1 0</skew><scale>", "has a <skew>"},
      {"<triangles count=\"4\">", "<trifans count=\"4\"/><triangles count=\"4\">",
       "has a <trifans>"},
      {"<triangles count=\"4\">", "<triangles>", "<triangles> without a count"},
      {"0 2 1", "0 -2 1", "a negative index"},
      {"url=\"#g\"", "url=\"#h\"", "refers to '#h', which is not in the file"},
      {"url=\"#g\"", "url=\"other.dae#g\"", "refers to 'other.dae#g', which is not in the file"},
      {"0.0254", "-1", "a <unit> of '-1' metres"},
      {"0.0254", "0,0254", "a <unit> of '0,0254' metres"},
      {"<mesh>", "<asset><unit meter=\"1\"/></asset><mesh>", "beside another"},
      {"</node>", "", "is damaged or cut off in <'node'>"}};
  for (const auto& [part, by, said] : changes) {
    CAPTURE(part, by);
    const std::string text = with(kCollada, part, by);
    CHECK_THAT(refusal(tool::read_with_assimp, text, written(text, "dae")),
               Catch::Matchers::Contains(said));
  }
}
