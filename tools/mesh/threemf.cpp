// 3MF: a zip of parts, the model and those that it refers to.
#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "mesh/limited_import.hpp"
#include "mesh/placement.hpp"
#include "mesh/scene_checks.hpp"
#include "mesh/units.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/xml_tags.hpp"

namespace flashbvh::tool {
namespace {

constexpr const char* kSpace = "http://schemas.microsoft.com/3dmanufacturing/";

/// What elements may hold.
constexpr std::array<std::pair<std::string_view, std::string_view>, 9> kPartTypes = {
    {{"object", "mesh"},
     {"object", "components"},
     {"object", "metadatagroup"},
     {"mesh", "vertices"},
     {"mesh", "triangles"},
     {"mesh", "trianglesets"},
     {"vertices", "vertex"},
     {"components", "component"},
     {"build", "item"}}};

/// What Cura's metadata say of objects that are no solids.
constexpr std::array<std::string_view, 4> kCuraKinds = {
    "cura:anti_overhang_mesh", "cura:cutting_mesh", "cura:infill_mesh", "cura:support_mesh"};

constexpr std::size_t kMostObjectLevels = 64;

/// A part's object, placed: an item of the build, or a component of an object.
struct Placed {
  std::string part;
  std::string id;
  Placement placement;
};

struct Object {
  std::string type;
  std::vector<Position> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Placed> components;
};

std::string without_root(std::string_view part) {
  return std::string(part.substr(std::min(part.find_first_not_of('/'), part.size())));
}

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

  std::string part(const std::string& name) {
    std::string bytes;
    std::array<char, 0x10000> some{};
    bool is_whole = unzLocateFile(zip_, name.c_str(), 2) == UNZ_OK &&  // 2: in any case of letters
                    unzOpenCurrentFile(zip_) == UNZ_OK;
    for (int size = 1; is_whole && size > 0; is_whole = size >= 0) {
      size = unzReadCurrentFile(zip_, some.data(), some.size());
      bytes.append(some.data(), static_cast<std::size_t>(std::max(size, 0)));
    }
    if (!is_whole || unzCloseCurrentFile(zip_) != UNZ_OK) {  // compares the checksum
      throw UserError(file_, "can't be read: its part ", tool::quoted(name),
                      " is damaged or not there", kImportFix);
    }
    return bytes;
  }

  std::vector<std::string> parts() {
    std::vector<std::string> names;
    for (int at = unzGoToFirstFile(zip_); at == UNZ_OK; at = unzGoToNextFile(zip_)) {
      std::array<char, 1024> name{};
      unz_file_info info{};
      unzGetCurrentFileInfo(zip_, &info, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
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
  explicit Reader(const std::string& file)
      : file_(file), package_(file), builder_(file), points_(file_, builder_) {}

  FileMesh read() {
    refuse_modifiers();
    root_ = root_part();
    read_part(root_);
    for (const Placed& item : items_) {
      add(item, kIdentity, 0);
    }
    FileMesh mesh = builder_.finish();
    mesh.unit = unit_;
    return mesh;
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, one_line(concat(what...)));
  }

  /// Slicers store volumes that are cut away, or are no part, as meshes, and say so elsewhere.
  void refuse_modifiers() {
    for (const std::string& part : package_.parts()) {
      if (part.substr(0, 9) != "Metadata/" || part.substr(part.find_last_of('.') + 1) != "config") {
        continue;
      }
      const std::string text = package_.part(part);
      // No XmlTags: other settings are no XML.
      for (std::optional<Markup> at = next_markup(text, 0); at; at = next_markup(text, at->end)) {
        const std::string_view tag = std::string_view(text).substr(at->begin, at->end - at->begin);
        const XmlTag known = {"", tag.substr(std::min(tag.find(' '), tag.size())), ""};
        const std::string_view key = known.attribute("key").value_or("");
        const std::string_view value = known.attribute("value").value_or("");
        const std::string_view subtype = known.attribute("subtype").value_or("normal_part");
        if (subtype != "normal_part") {
          refuse_kind(subtype, part);
        }
        if (key == "volume_type" && value != "ModelPart") {
          refuse_kind(value, part);
        }
        if (key == "modifier" && value == "1") {
          refuse_kind(key, part);
        }
      }
    }
  }

  [[noreturn]] void refuse_kind(std::string_view kind, std::string_view where) const {
    refuse("has a ", tool::quoted(kind), ", by ", tool::quoted(where),
           ", which is no solid; export the printed parts alone, or as STL");
  }

  std::string root_part() {
    const std::string relations = package_.part("_rels/.rels");
    XmlTags tags(relations, file_);
    while (const std::optional<XmlTag> tag = tags.next()) {
      if (tag->attribute("Type") == concat(kSpace, "2013/01/3dmodel")) {
        return without_root(tag->attribute("Target").value_or(""));
      }
    }
    refuse("can't be read: names no part as its model", kImportFix);
  }

  void read_part(const std::string& part) {
    parts_.insert(part);
    const std::string text = package_.part(part);
    XmlTags tags(text, concat(file_, ", ", part));
    Object* object = nullptr;
    std::string id;
    while (const std::optional<XmlTag> tag = tags.next()) {
      const std::string_view name = local_name(tag->name);
      const std::string_view parent = tags.parent();
      if (parent.empty()) {
        read_model(*tag, part);
      } else if (name == "metadata") {
        const std::string_view kind = tag->attribute("name").value_or("");
        if (tag->text == "True" &&
            std::find(kCuraKinds.begin(), kCuraKinds.end(), kind) != kCuraKinds.end()) {
          refuse_kind(kind, part);
        }
      } else if (parent == "resources" && name == "object") {
        id = tag->attribute("id").value_or("");
        const auto [made, is_new] = objects_.emplace(std::pair(part, id), Object());
        if (!is_new || tag->attribute(":slicestackid")) {
          refuse("has ", is_new ? "slices as" : "two objects", " ", id, " in ", part,
                 "; export it as one mesh an object");
        }
        object = &made->second;
        object->type = tag->attribute("type").value_or("model");
      } else if (parent == "triangles" && name == "triangle") {
        add_triangle(*tag, id, *object);
      } else if (is_read(parent, name)) {
        read_element(*tag, name, id, part, object);
      }
    }
  }

  /// False for elements that are no geometry. UserError for geometry that is not read.
  bool is_read(std::string_view parent, std::string_view name) const {
    const auto holds = [&](const auto& pair) { return pair.first == parent; };
    if (std::none_of(kPartTypes.begin(), kPartTypes.end(), holds)) {
      return false;
    }
    if (std::find(kPartTypes.begin(), kPartTypes.end(), std::pair(parent, name)) ==
        kPartTypes.end()) {
      refuse("has a <", name, "> in a <", parent, ">, which is not read; export it as triangles");
    }
    return true;
  }

  void read_model(const XmlTag& model, const std::string& part) {
    const std::string_view name = model.attribute("unit").value_or("millimeter");
    const Unit unit = unit_of_3mf(name);
    if (unit == Unit::none || (unit_ != Unit::none && unit_ != unit)) {
      refuse("is in ", tool::quoted(name), " in ", part,
             unit_ != Unit::none ? ", but elsewhere in another unit" : "",
             "; export it in millimeter");
    }
    unit_ = unit;
    for (const std::string_view prefix :
         words_of(model.attribute("requiredextensions").value_or(""))) {
      const std::string_view space =
          model.attribute(concat("xmlns:", std::string(prefix))).value_or("");
      if (!is_understood(space)) {
        refuse("requires the extension ", tool::quoted(prefix), " (", space,
               "), which is not read; export it without");
      }
    }
  }

  void read_element(const XmlTag& tag, std::string_view name, const std::string& id,
                    const std::string& part, Object* object) {
    if (name == "vertex") {
      object->vertices.push_back(
          {number(tag, "x", id), number(tag, "y", id), number(tag, "z", id)});
    } else if (name == "component") {
      object->components.push_back(placed(tag, part));
    } else if (name == "item" && part == root_) {
      items_.push_back(placed(tag, part));
    }
  }

  double number(const XmlTag& tag, const char* name, const std::string& object) const {
    return number_of(tag.attribute(name).value_or(""),
                     concat(file_, ", object ", tool::quoted(object), ", ", name, " of a vertex"));
  }

  void add_triangle(const XmlTag& tag, const std::string& id, Object& object) const {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view text = tag.attribute(std::array{"v1", "v2", "v3"}[i]).value_or("");
      const std::optional<long long> corner = parse_integer(text);
      if (!corner || *corner < 0 || static_cast<std::uint64_t>(*corner) >= object.vertices.size()) {
        refuse("object ", tool::quoted(id), ": a corner at vertex ", tool::quoted(text), " of ",
               object.vertices.size(), "; export the mesh again");
      }
      corners[i] = static_cast<std::uint32_t>(*corner);
    }
    object.triangles.push_back(corners);
  }

  Placed placed(const XmlTag& tag, const std::string& part) const {
    Placed made = {part, std::string(tag.attribute("objectid").value_or("")), kIdentity};
    if (const auto path = tag.attribute(":path")) {
      made.part = without_root(*path);
    }
    if (const auto transform = tag.attribute("transform")) {
      std::vector<double> numbers;
      for (const std::string_view word : words_of(*transform)) {
        numbers.push_back(number_of(word, file_ + ", transform"));
      }
      if (numbers.size() != 12) {
        refuse("has a transform of ", numbers.size(), " numbers, not of 12; export it again");
      }
      for (std::size_t i = 0; i < 12; ++i) {
        made.placement[i % 3][i / 3] = numbers[i];
      }
    }
    return made;
  }

  void add(const Placed& at, const Placement& outer, std::size_t level) {
    if (parts_.count(at.part) == 0) {
      read_part(at.part);
    }
    const auto found = objects_.find({at.part, at.id});
    if (found == objects_.end() || level > kMostObjectLevels) {
      refuse("refers to the object ", tool::quoted(at.id), " of ", at.part,
             found == objects_.end() ? ", which is not there" : ", which is in itself",
             "; export it again");
    }
    const Object& object = found->second;
    if (object.type != "model") {
      refuse("builds the object ", tool::quoted(at.id), " of type ", tool::quoted(object.type),
             ", not 'model'; export it without");
    }
    const Placement placement = composed(outer, at.placement);
    add_mesh(object, placement);
    for (const Placed& component : object.components) {
      add(component, placement, level + 1);
    }
  }

  void add_mesh(const Object& object, const Placement& placement) {
    const auto first = static_cast<std::uint32_t>(builder_.point_count());
    for (const Position& vertex : object.vertices) {
      points_.add(vertex, placement);
    }
    const bool mirrored = is_mirrored(placement);
    for (const auto& [a, b, c] : object.triangles) {
      builder_.add_polygon({first + a, first + (mirrored ? c : b), first + (mirrored ? b : c)});
    }
  }

  const std::string& file_;
  Package package_;
  std::string root_;
  Unit unit_ = Unit::none;
  std::set<std::string> parts_;
  std::map<std::pair<std::string, std::string>, Object> objects_;  ///< by part and id
  std::vector<Placed> items_;
  MeshBuilder builder_;
  PlacedPoints points_;
};

}  // namespace

FileMesh read_3mf(std::string_view, const std::string& file) {
  if (!std::filesystem::is_regular_file(file)) {
    throw UserError(file, "is a pipe, from which this format can't be read; name a file");
  }
  return Reader(file).read();
}

}  // namespace flashbvh::tool
