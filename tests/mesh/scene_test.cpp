// Scenes: DAE, glTF and 3MF. Units and placements apply; what would be misread is refused by its
// name.
#include <fstream>

#include "mesh/any_format.hpp"
#include "mesh/package.hpp"
#include "support/test.hpp"

using tool::FileMesh;

namespace {

// A tetrahedron of volume 1/6 in each format; the glTF's buffer is a file.

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

const std::string k3mf =
    R"(<?xml version="1.0"?><model xml:lang="en" xmlns:p="http://schemas.microsoft.com/)"
    R"(3dmanufacturing/production/2015/06" requiredextensions="p"><resources><basematerials id="9"/>
    <object id="1" type="model" p:UUID="1"><mesh><vertices><vertex x="0" y="0" z="0"/>
    <vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
    <triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>
    <triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh></object>
    </resources><build><item objectid="1"/></build></model>)";

/// Writes a file for one reading.
std::string written(const std::string& text, const std::string& extension,
                    std::uint16_t last_corner = 3, const Parts& others = {}) {
  const std::array<float, 12> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  const std::array<std::uint16_t, 12> corners = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, last_corner};
  std::ofstream buffer("tetrahedron.bin", std::ios::binary);
  buffer.write(reinterpret_cast<const char*>(points.data()), sizeof points);
  buffer.write(reinterpret_cast<const char*>(corners.data()), sizeof corners);
  const std::string path = "scene_test." + extension;
  if (extension == "3mf") {
    write_3mf(path, text, others);
  } else {
    std::ofstream(path, std::ios::binary) << text;
  }
  return path;
}

FileMesh read_scene(const std::string& text, const std::string& path) {
  return path.find(".3mf") != std::string::npos ? tool::read_3mf(text, path)
                                                : tool::read_with_assimp(text, path);
}

const std::string& plain(const std::string& extension) {
  return extension == "gltf" ? kGltf : extension == "dae" ? kCollada : k3mf;
}

/// A change of the plain file of a format.
struct Change {
  const char* extension;
  const char* part;
  const char* by;
};

FileMesh read_changed(const Change& change) {
  const std::string text = with(plain(change.extension), change.part, change.by);
  return read_scene(text, written(text, change.extension));
}

}  // namespace

TEST_CASE("a scene's nodes are placed, mirrored ones are no inside out solids") {
  constexpr double kInch = 0.0254 * 0.0254 * 0.0254;
  const std::pair<Change, double> scenes[] = {
      {{"gltf", "", ""}, 1},
      {{"gltf", R"("mesh":0)", R"("mesh":0,"scale":[-2,1,1])"}, 2},
      {{"gltf", R"("mesh":0)", R"("children":[1],"scale":[-1,1,1]},{"mesh":0,"scale":[1,-1,1])"},
       1},
      {{"dae", "", ""}, kInch},
      {{"dae", "<scale>1 1 1", "<scale>-1 1 1"}, kInch},
      {{"3mf", "<item", "<item transform=\"0 1 0\n-1 0 0 0\t0 1 10 20 30\""}, 1},
      {{"3mf", "<item", "<item transform=\"-2 0 0 0 1 0 0 0 1 0 0 0\""}, 2},
      {{"3mf", "</resources><build><item objectid=\"1\"/>",
        "<object id=\"2\"><components><component objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 -1 0 0 "
        "5\"/></components></object></resources><build><item objectid=\"2\"/><item "
        "objectid=\"1\"/>"},
       2}};
  for (const auto& [change, volume] : scenes) {
    CAPTURE(change.extension, change.part, change.by);
    CHECK(volume6(read_changed(change)) == Approx(volume));
  }
}

TEST_CASE("a scene carries its unit: a 3MF millimetres unless it says another") {
  CHECK(read_changed({"gltf", "", ""}).unit == Unit::m);
  CHECK(read_changed({"dae", "", ""}).unit == Unit::m);
  CHECK(read_changed({"3mf", "", ""}).unit == Unit::mm);
  const auto [name, unit] = GENERATE(table<const char*, Unit>({{"micron", Unit::um},
                                                               {"centimeter", Unit::cm},
                                                               {"inch", Unit::inch},
                                                               {"foot", Unit::foot},
                                                               {"meter", Unit::m}}));
  CHECK(read_changed({"3mf", "<model", tool::concat("<model unit=\"", name, "\"").c_str()}).unit ==
        unit);
}

TEST_CASE("Collada: nodes are placed in the unit's metres, whatever the up axis") {
  const std::string up =
      GENERATE("", "<up_axis>Z_UP</up_axis>", "<up_axis>Y_UP</up_axis>", "<up_axis>X_UP</up_axis>");
  const std::string placed = with(kCollada, "<scale>", "<translate>0 0 1</translate><scale>");
  const std::string text = with(placed, "</asset>", up + "</asset>");
  const FileMesh file = read_scene(text, written(text, "dae"));
  REQUIRE(file.mesh.vertices.size() == 4);
  CHECK(file.mesh.vertices[1][1] == Approx(0.0254));  // the second corner is (0 1 0)
  CHECK(file.mesh.vertices[3][2] == Approx(2 * 0.0254));
  CHECK(file.precision > 0);
}

TEST_CASE("glTF: what moves no vertex may be required") {
  CHECK(read_changed({"gltf", R"("scene":0)",
                      R"("extensionsRequired":["KHR_texture_transform","KHR_materials_ior",
                      "EXT_texture_webp","KHR_lights_punctual"],"scene":0)"})
            .mesh.triangles.size() == 4);
  CHECK(read_changed({"gltf", R"("scene":0,"scenes":[)", R"("scenes":[{"nodes":[0]},)"}).warnings ==
        std::vector<std::string>{"has 2 scenes and no default; the first alone is read"});
}

TEST_CASE("glTF: a triangle with a corner at no vertex is not left out in silence") {
  CHECK_THAT(refusal(read_scene, kGltf, written(kGltf, "gltf", 4)),
             Catch::Matchers::Contains("has 4 triangles, of which assimp reads 3"));
}

TEST_CASE("3MF: a project of a slicer, which may have parts that are no solids, is refused") {
  for (const char* const part :
       {"Metadata/Slic3r_PE_model.config", "Metadata/model_settings.config"}) {
    CHECK_THAT(refusal(read_scene, "", written(k3mf, "3mf", 3, {{part, "<config/>"}})),
               Catch::Matchers::Contains(tool::concat("is a slicer's project, by '", part)));
  }
}

TEST_CASE("what is not read of a scene is refused by its name") {
  const std::pair<Change, const char*> changes[] = {
      {{"gltf", R"("scene":0)", R"("extensionsRequired":["VENDOR_x"],"scene":0)"},
       "requires the extension VENDOR_x"},
      {{"gltf", R"("mesh":0)", R"("mesh":0,"extensions":{"EXT_mesh_gpu_instancing":{}})"},
       "nodes[0] uses the extension EXT_mesh_gpu_instancing"},
      {{"gltf", R"("indices":1)",
        R"("indices":1,"extensions":{"KHR_draco_mesh_compression":{"bufferView":0}})"},
       "meshes[0] uses the extension KHR_draco_mesh_compression"},
      {{"gltf", R"("byteLength":48)",
        R"("byteLength":48,"extensions":{"EXT_meshopt_compression":{}})"},
       "bufferViews[0] uses the extension EXT_meshopt_compression"},
      {{"gltf", R"("mesh":0)", R"("mesh":0,"skin":0)"}, "nodes[0] has 'skin'"},
      {{"gltf", R"("count":4)", R"("count":4,"sparse":{})"}, "accessors[0] has 'sparse'"},
      {{"gltf", "5126", "5123"}, "accessors[0] does not hold floats as positions"},
      {{"gltf", "5123", "5122"}, "accessors[1] does not hold unsigned integers as indices"},
      {{"gltf", R"("count":12)", R"("count":11)"}, "meshes[0] has 11 corners"},
      {{"gltf", R"("count":12)", R"("count":15)"}, "accessors[1] ends behind its data"},
      {{"gltf", R"("bufferView":0,)", ""}, "accessors[0] has no data"},
      {{"gltf", R"("indices":1)", R"("indices":1,"mode":7)"}, "a primitive of mode 7"},
      {{"gltf", R"("POSITION":0)", R"("NORMAL":0)"}, "a primitive of mode 4 without positions"},
      {{"gltf", R"("version")", R"("minVersion":"2.1","version")"}, "is of glTF '2.1'"},
      {{"gltf", R"("nodes":[0])", R"("nodes":[0,0])"}, "nodes[0] has two parents"},
      {{"dae", "<instance_geometry url=\"#g\"/>", "<instance_controller url=\"#g\"/>"},
       "has a <instance_controller>, a skin or a morph"},
      {{"dae", "<triangles count=\"4\">", "<trifans count=\"4\"/><triangles count=\"4\">"},
       "has a <trifans>"},
      {{"dae", "<triangles count=\"4\">", "<triangles>"}, "<triangles> without a count"},
      {{"dae", "0 2 1", "0 -2 1"}, "a negative index"},
      {{"dae", "url=\"#g\"", "url=\"#h\""}, "refers to '#h', which is not in the file"},
      {{"dae", "0.0254", "-1"}, "a <unit> of '-1' metres"},
      {{"dae", "<mesh>", "<asset><unit meter=\"1\"/></asset><mesh>"}, "beside another"},
      {{"dae", "</node>", ""}, "is no XML"},
      {{"3mf", "requiredextensions=\"p\"", "requiredextensions=\"p b\" xmlns:b=\"http://beams\""},
       "requires the extension 'b' (http://beams)"},
      {{"3mf", "<model", "<model unit=\"parsec\""}, "is in 'parsec'"},
      {{"3mf", "type=\"model\"", "type=\"support\""}, "the object '1' of type 'support'"},
      {{"3mf", "<object", "<object s:slicestackid=\"3\""}, "has a 's:slicestackid' in an <object>"},
      {{"3mf", "<item", "<item p:path=\"/3D/other.model\""}, "has a 'p:path' in an <item>"},
      {{"3mf", "</triangles>", "</triangles><b:beamlattice/>"}, "a <b:beamlattice> in a <mesh>"},
      {{"3mf", "<mesh>", "<bo:booleanshape/><mesh>"}, "has a <bo:booleanshape> in a <object>"},
      {{"3mf", "x=\"1\"", "x=\"1,5\""}, "'1,5' is no finite number"},
      {{"3mf", "v2=\"2\"", "v2=\"4\""}, "a corner at vertex '4' of 4"},
      {{"3mf", "objectid=\"1\"", "objectid=\"2\""}, "refers to the object '2', which is not there"},
      {{"3mf", "<item", "<item transform=\"1 0 0\""}, "has a transform of 3 numbers"},
      {{"3mf", "<mesh>", "<components><component objectid=\"1\"/></components><mesh>"},
       "refers to the object '1', which is in itself"},
      {{"3mf", "</object>", "</object><object id=\"1\"/>"}, "has two objects 1"},
      {{"3mf", "</triangles>", ""}, "is no XML"}};
  for (const auto& [change, said] : changes) {
    CAPTURE(change.extension, change.part, change.by);
    CHECK_THROWS_WITH(read_changed(change), Catch::Matchers::Contains(said));
  }
}
