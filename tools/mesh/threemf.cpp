// 3MF: a zip of parts, of which the model has the meshes and places them. Other parts and
// extensions may change the geometry: those that do, or may, are refused by their names.
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "mesh/limited_import.hpp"
#include "mesh/mesh_builder.hpp"
#include "mesh/units.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/xml.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kModel = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";
/// Extensions that change the geometry by nothing that is not refused.
constexpr std::array<std::string_view, 2> kHarmlessSpaces = {
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"};
constexpr std::size_t kMostObjectLevels = 64;

class Package {
 public:
  explicit Package(const std::string& file) : file_(file), zip_(unzOpen(file.c_str())) {
    if (zip_ == nullptr) {
      throw UserError(file, "can't be read: is no whole zip", kImportFix);
    }
  }
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;
  ~Package() { unzClose(zip_); }

  std::string part(const std::string& name) const {
    unz_file_info about{};
    std::string bytes;
    bool is_whole =
        unzLocateFile(zip_, name.c_str(), 2) == UNZ_OK &&  // 2: in any case of letters
        unzGetCurrentFileInfo(zip_, &about, nullptr, 0, nullptr, 0, nullptr, 0) == UNZ_OK &&
        unzOpenCurrentFile(zip_) == UNZ_OK;
    if (is_whole) {
      bytes.resize(about.uncompressed_size);
      const auto size = static_cast<unsigned>(bytes.size());
      is_whole = unzReadCurrentFile(zip_, bytes.data(), size) == static_cast<int>(size) &&
                 unzCloseCurrentFile(zip_) == UNZ_OK;  // compares the checksum
    }
    if (!is_whole) {
      throw UserError(file_, "can't be read: its part ", tool::quoted(name),
                      " is damaged or not there", kImportFix);
    }
    return bytes;
  }

  std::vector<std::string> parts() const {
    std::vector<std::string> names;
    for (int at = unzGoToFirstFile(zip_); at == UNZ_OK; at = unzGoToNextFile(zip_)) {
      std::array<char, 1024> name{};
      unz_file_info about{};
      unzGetCurrentFileInfo(zip_, &about, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
      names.emplace_back(name.data());
    }
    return names;
  }

 private:
  const std::string& file_;
  const unzFile zip_;
};

class Reader {
 public:
  explicit Reader(const std::string& file) : file_(file), package_(file), builder_(file) {}

  FileMesh read() {
    refuse_projects();
    const std::string part = model_part();
    const std::string text = package_.part(part);
    const XmlNode model = read_xml(text, concat(file_, ", ", part), "export the mesh again");
    check_model(model);
    for (const XmlNode& resources : model.inside) {
      for (const XmlNode& object : resources.inside) {
        if (resources.name == "resources" && object.name == "object" &&
            !objects_.emplace(object.attribute("id"), &object).second) {
          refuse("has two objects ", object.attribute("id"), "; export the mesh again");
        }
      }
    }
    for (const XmlNode& build : model.inside) {
      if (build.name == "build") {
        check_inside(build, {"item"});
        for (const XmlNode& item : build.inside) {
          add(item, kIdentity, 0);
        }
      }
    }
    FileMesh mesh = builder_.finish();
    mesh.unit = unit_of_3mf(unit_name_of(model));
    return mesh;
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, one_line(concat(what...)));
  }

  /// In settings beside the model, slicers say which meshes are cut away, or are no part.
  void refuse_projects() const {
    for (const std::string& part : package_.parts()) {
      if (part.substr(0, 9) == "Metadata/" && part.substr(part.find_last_of('.') + 1) == "config") {
        refuse("is a slicer's project, by ", tool::quoted(part), "; export its parts as STL");
      }
    }
  }

  std::string model_part() const {
    const std::string relations = package_.part("_rels/.rels");
    for (const XmlNode& relation : read_xml(relations, file_, "export the mesh again").inside) {
      if (relation.attribute("Type") == kModel) {
        const std::string part = relation.attribute("Target");
        return part.substr(std::min(part.find_first_not_of('/'), part.size()));
      }
    }
    refuse("can't be read: names no part as its model", kImportFix);
  }

  static std::string unit_name_of(const XmlNode& model) {
    return model.find("unit") == nullptr ? "millimeter" : model.attribute("unit");
  }

  void check_model(const XmlNode& model) const {
    if (model.name != "model") {
      refuse("begins with <", model.name, ">, not with <model>; export the mesh again");
    }
    if (unit_of_3mf(unit_name_of(model)) == Unit::none) {
      refuse("is in ", tool::quoted(unit_name_of(model)), "; export it in millimeter");
    }
    const std::string prefixes = model.attribute("requiredextensions");
    for (const std::string_view prefix : words_of(prefixes)) {
      const std::string space = model.attribute(concat("xmlns:", std::string(prefix)));
      if (std::find(kHarmlessSpaces.begin(), kHarmlessSpaces.end(), space) ==
          kHarmlessSpaces.end()) {
        refuse("requires the extension ", tool::quoted(prefix), " (", space,
               "), which is not read; export it without");
      }
    }
  }

  /// UserError for an element inside of another name.
  void check_inside(const XmlNode& element, const std::set<std::string_view>& names) const {
    for (const XmlNode& inside : element.inside) {
      if (names.count(inside.name) == 0) {
        refuse("has a <", inside.name, "> in a <", element.name,
               ">, which is not read; export it as triangles");
      }
    }
  }

  /// UserError for attributes of extensions, but identifiers.
  void check_attributes(const XmlNode& element) const {
    for (const auto& [name, value] : element.attributes) {
      const std::size_t colon = name.find(':');
      if (colon != std::string_view::npos && name.substr(colon) != ":UUID") {
        refuse("has a ", tool::quoted(name), " in an <", element.name,
               ">, which is not read; export it without");
      }
    }
  }

  /// Adds the object that an item or a component refers to.
  void add(const XmlNode& reference, const Placement& outer, std::size_t level) {
    check_attributes(reference);
    const std::string id = reference.attribute("objectid");
    const auto found = objects_.find(id);
    if (found == objects_.end() || level > kMostObjectLevels) {
      refuse("refers to the object ", tool::quoted(id),
             found == objects_.end() ? ", which is not there" : ", which is in itself",
             "; export it again");
    }
    const XmlNode& object = *found->second;
    check_attributes(object);
    if (const std::string type = object.attribute("type"); !type.empty() && type != "model") {
      refuse("builds the object ", tool::quoted(id), " of type ", tool::quoted(type),
             ", not 'model'; export it without");
    }
    const Placement placement = composed(outer, placement_of(reference));
    check_inside(object, {"mesh", "components"});
    for (const XmlNode& inside : object.inside) {
      if (inside.name == "mesh") {
        builder_.begin_part(placement);
        add_mesh(inside, concat(file_, ", object ", tool::quoted(id)));
        continue;
      }
      check_inside(inside, {"component"});
      for (const XmlNode& component : inside.inside) {
        add(component, placement, level + 1);
      }
    }
  }

  Placement placement_of(const XmlNode& reference) const {
    Placement placement = kIdentity;
    if (const std::string* const transform = reference.find("transform")) {
      const std::vector<std::string_view> numbers = words_of(*transform);
      if (numbers.size() != 12) {
        refuse("has a transform of ", numbers.size(), " numbers, not of 12; export it again");
      }
      for (std::size_t i = 0; i < 12; ++i) {
        placement[i % 3][i / 3] = number_of(numbers[i], file_ + ", transform");
      }
    }
    return placement;
  }

  /// `object`: a place for messages.
  void add_mesh(const XmlNode& mesh, const std::string& object) {
    check_inside(mesh, {"vertices", "triangles"});
    for (const XmlNode& part : mesh.inside) {
      const bool has_vertices = part.name == "vertices";
      check_inside(part, {has_vertices ? "vertex" : "triangle"});
      for (const XmlNode& e : part.inside) {
        if (has_vertices) {
          builder_.add_point({number_of(e.attribute("x"), object + ", x of a vertex"),
                              number_of(e.attribute("y"), object + ", y of a vertex"),
                              number_of(e.attribute("z"), object + ", z of a vertex")});
        } else {
          builder_.add_polygon({corner(e.attribute("v1"), object),
                                corner(e.attribute("v2"), object),
                                corner(e.attribute("v3"), object)});
        }
      }
    }
  }

  std::uint32_t corner(const std::string& text, const std::string& object) const {
    const auto count = static_cast<long long>(builder_.point_count());
    const long long number = parse_integer(text).value_or(-1);
    if (number < 0 || number >= count) {
      throw UserError(object, "a corner at vertex ", tool::quoted(text), " of ", count,
                      "; export the mesh again");
    }
    return static_cast<std::uint32_t>(number);
  }

  const std::string& file_;
  Package package_;
  std::map<std::string, const XmlNode*> objects_;  ///< by id
  MeshBuilder builder_;
};

}  // namespace

FileMesh read_3mf(std::string_view, const std::string& file) {
  return Reader(file).read();
}

}  // namespace flashbvh::tool
