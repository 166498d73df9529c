// 3MF: units, placements, parts of the package; and what is not read is refused by its name.
#include <fstream>

#include "mesh/any_format.hpp"
#include "mesh/zip.hpp"
#include "support/test.hpp"

using tool::FileMesh;

namespace {

/// A tetrahedron of volume 1/6.
const std::string kMesh =
    R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/>
    <vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
    <triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/>
    <triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh>)";

std::string model(const std::string& objects, const std::string& build,
                  const std::string& attributes = "") {
  return "<?xml version=\"1.0\"?><model xmlns=\"" + kSpace + "core/2015/02\" xmlns:p=\"" + kSpace +
         "production/2015/06\" " + attributes + "><resources>" + objects + "</resources><build>" +
         build + "</build></model>";
}

/// The tetrahedron with the transform of its item.
std::string placed(const std::string& transform) {
  return model("<object id=\"1\">" + kMesh + "</object>",
               "<item objectid=\"1\" transform=\"" + transform + "\"/>");
}

std::string whole() {
  return model("<object id=\"1\" type=\"model\">" + kMesh + "</object>", "<item objectid=\"1\"/>");
}

std::string written(const std::string& root, const Parts& others) {
  std::ofstream("threemf_test.3mf", std::ios::binary) << package_of(root, others);
  return "threemf_test.3mf";
}

FileMesh read(const std::string& root, const Parts& others = {}) {
  return tool::read_3mf("", written(root, others));
}

std::string refusal_of(const std::string& root, const Parts& others = {}) {
  return refusal(tool::read_3mf, "", written(root, others));
}

}  // namespace

TEST_CASE("a 3MF carries its unit, millimetres unless it says another") {
  CHECK(read(whole()).unit == Unit::mm);
  const auto [name, unit] = GENERATE(table<const char*, Unit>({{"micron", Unit::um},
                                                               {"millimeter", Unit::mm},
                                                               {"centimeter", Unit::cm},
                                                               {"inch", Unit::inch},
                                                               {"foot", Unit::foot},
                                                               {"meter", Unit::m}}));
  const std::string object = "<object id=\"1\">" + kMesh + "</object>";
  CHECK(read(model(object, "<item objectid=\"1\"/>", tool::concat("unit=\"", name, "\""))).unit ==
        unit);
}

TEST_CASE("items and components place objects, mirrored ones are no inside out solids") {
  const FileMesh item = read(placed("0 1 0\n-1 0 0 0\t0 1 10 20 30"));
  CHECK(item.mesh.vertices[2] == tool::Position{10, 21, 30});
  CHECK(volume6(item) == Approx(1));
  CHECK(volume6(read(placed("-2 0 0 0 1 0 0 0 1 0 0 0"))) == Approx(2));
  const std::string objects = "<object id=\"1\">" + kMesh +
                              "</object><object id=\"2\"><components><component objectid=\"1\" "
                              "transform=\"1 0 0 0 1 0 0 0 -1 0 0 5\"/></components></object>";
  const FileMesh component =
      read(model(objects,
                 "<item objectid=\"2\" transform=\"0 1 0 -1 0 0 0 0 1 7 0 0\"/>"
                 "<item objectid=\"1\"/>"));
  CHECK(component.mesh.vertices[0] == tool::Position{7, 0, 5});
  CHECK(component.mesh.vertices[1] == tool::Position{7, 1, 5});
  CHECK(volume6(component) == Approx(2));
}

TEST_CASE("objects of other parts of the package are read") {
  const std::string root = model(
      "<object id=\"1\"><components><component p:path=\"/3D/o.model\" objectid=\"1\"/>"
      "</components></object>",
      "<item objectid=\"1\"/><item p:path=\"/3D/o.model\" objectid=\"1\"/>",
      "requiredextensions=\"p\"");
  CHECK(read(root, {{"3D/o.model", whole()}}).mesh.triangles.size() == 8);
  CHECK_THAT(refusal_of(root),
             Catch::Matchers::Contains("its part '3D/o.model' is damaged or not"));
  CHECK_THAT(
      refusal_of(root, {{"3D/o.model", with(whole(), "<model", "<model unit=\"inch\"")}}),
      Catch::Matchers::Contains("is in 'inch' in 3D/o.model, but elsewhere in another unit"));
}

TEST_CASE("3MF: what is not read is refused by its name") {
  const Change changes[] = {
      {"<model", "<model requiredextensions=\"p b\" xmlns:b=\"http://beams\"",
       "requires the extension 'b' (http://beams)"},
      {"<model", "<model unit=\"parsec\"", "is in 'parsec'"},
      {"type=\"model\"", "type=\"support\"", "builds the object '1' of type 'support'"},
      {"<object", "<object s:slicestackid=\"3\"", "has slices as 1"},
      {"</triangles>", "</triangles><b:beamlattice/>", "has a <beamlattice> in a <mesh>"},
      {"<mesh>", "<bo:booleanshape/><mesh>", "has a <booleanshape> in a <object>"},
      {"<mesh>",
       "<metadatagroup><metadata name=\"cura:infill_mesh\">True</metadata></metadatagroup><mesh>",
       "has a 'cura:infill_mesh'"},
      {"x=\"1\"", "x=\"1,5\"", "'1,5' is no finite number"},
      {"x=\"1\"", "", "object '1', x of a vertex: '' is no finite number"},
      {"v2=\"2\"", "v2=\"4\"", "a corner at vertex '4' of 4"},
      {"v2=\"2\"", "", "a corner at vertex '' of 4"},
      {"objectid=\"1\"", "objectid=\"2\"", "refers to the object '2' of 3D/m.model"},
      {"objectid=\"1\"", "objectid=\"1\" transform=\"1 0 0\"", "has a transform of 3 numbers"},
      {"<mesh>", "<components><component objectid=\"1\"/></components><mesh>",
       "refers to the object '1' of 3D/m.model, which is in itself"},
      {"</object>", "</object><object id=\"1\"/>", "has two objects 1"},
      {"</triangles>", "", "is damaged or cut off in <'triangles'>"},
      {"</model>", "", "is damaged or cut off in <'model'>"}};
  for (const auto& [part, by, said] : changes) {
    CAPTURE(part, by);
    CHECK_THAT(refusal_of(with(whole(), part, by)), Catch::Matchers::Contains(said));
  }
}

TEST_CASE("volumes of slicers that are no solids are refused by their kinds") {
  const std::array<std::string, 3> volumes[] = {
      {"Metadata/Slic3r_PE_model.config",
       "<config><object id=\"1\"><volume firstid=\"0\" lastid=\"3\"><metadata type=\"volume\" "
       "key=\"volume_type\" value=\"NegativeVolume\"/></volume></object></config>",
       "has a 'NegativeVolume', by 'Metadata/Slic3r_PE_model.config'"},
      {"Metadata/Slic3r_PE_model.config",
       "<metadata type=\"volume\" key=\"modifier\" value=\"1\"/>", "has a 'modifier'"},
      {"Metadata/model_settings.config", "<part id=\"2\" subtype=\"negative_part\">",
       "has a 'negative_part'"},
      {"Metadata/Slic3r_PE_model.config",
       "<metadata key=\"volume_type\" value=\"ModelPart\"/><metadata key=\"modifier\" "
       "value=\"0\"/>",
       ""},
      {"Metadata/model_settings.config", "<part id=\"2\" subtype=\"normal_part\">", ""}};
  for (const auto& [part, text, said] : volumes) {
    CAPTURE(part, text);
    const std::string found = refusal_of(whole(), {{part, text}});
    CHECK_THAT(found, Catch::Matchers::Contains(said));
    CHECK(found.empty() == said.empty());
  }
}
