// glTF: what assimp reads right, listed; all else on the way from the scene to its triangles is
// refused by its name.
#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "mesh/scene_checks.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

using Gltf = nlohmann::json;

/// The members that are read of each kind of element, besides its name, extras and extensions.
const std::map<std::string_view, std::set<std::string_view>> kMembers = {
    {"scenes", {"nodes"}},
    {"nodes", {"camera", "children", "matrix", "mesh", "rotation", "scale", "translation"}},
    {"meshes", {"primitives"}},
    {"primitives", {"attributes", "indices", "material", "mode"}},
    {"accessors",
     {"bufferView", "byteOffset", "componentType", "count", "max", "min", "normalized", "type"}},
    {"bufferViews", {"buffer", "byteLength", "byteOffset", "byteStride", "target"}},
    {"buffers", {"byteLength", "uri"}}};

/// Beginnings of the names of extensions that move no vertex and make no triangle.
constexpr std::array<std::string_view, 6> kHarmless = {
    "KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_", "KHR_xmp", "FB_ngon_encoding"};

bool is_harmless(std::string_view extension) {
  return std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view known) {
    return extension.substr(0, known.size()) == known;
  });
}

/// What an accessor holds: the size of an element in bytes by the type of its components.
struct Data {
  const char* what;
  const char* type;
  std::map<int, std::uint64_t> sizes;
};
const Data kPositions = {"floats as positions", "VEC3", {{5126, 12}}};
const Data kCorners = {"unsigned integers as indices", "SCALAR", {{5121, 1}, {5123, 2}, {5125, 4}}};

/// The JSON of a .glb, or the whole file.
std::string_view json_of(std::string_view bytes) {
  std::uint32_t size = 0;
  if (bytes.substr(0, 4) != "glTF" || bytes.size() < 20) {
    return bytes;
  }
  std::memcpy(&size, bytes.data() + 12, sizeof size);
  const std::string_view json = bytes.substr(20, size);
  return json.substr(0, json.find('\0'));
}

class GltfChecks {
 public:
  GltfChecks(std::string_view bytes, const std::string& file)
      : file_(file),
        is_glb_(bytes.substr(0, 4) == "glTF"),
        gltf_(Gltf::parse(json_of(bytes), nullptr, false)) {
    if (!gltf_.is_object()) {
      refuse("can't be read: has no JSON of a glTF; export the mesh again");
    }
  }

  GltfContents contents() {
    for (const Gltf& required : member(gltf_, "extensionsRequired")) {
      check_extension(required.get<std::string>(), "requires");
    }
    if (const std::string least = member(gltf_, "asset").value("minVersion", "2.0");
        least != "2.0") {
      refuse("is of glTF ", tool::quoted(least), "; export it as glTF 2.0");
    }
    check_scene();
    return std::move(contents_);
  }

 private:
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... what) const {
    throw UserError(file_, one_line(concat(what...)));
  }

  /// Null if there is no such member.
  static const Gltf& member(const Gltf& of, const char* name) {
    static const Gltf nothing;
    const auto found = of.find(name);
    return found == of.end() ? nothing : *found;
  }

  void check_extension(const std::string& name, const std::string& user) const {
    if (!is_harmless(name)) {
      refuse(user, " the extension ", name, ", which is not read; export it without");
    }
  }

  void check_members(const Gltf& element, const char* kind, const std::string& where) const {
    for (const auto& [name, value] : element.items()) {
      if (name != "extensions" && name != "extras" && name != "name" &&
          kMembers.at(kind).count(name) == 0) {
        refuse(where, " has ", tool::quoted(name), ", which is not read; export it without");
      }
    }
    for (const auto& [name, value] : member(element, "extensions").items()) {
      check_extension(name, where + " uses");
    }
  }

  const Gltf& element(const char* kind, std::size_t number) const {
    const Gltf& all = member(gltf_, kind);
    if (number >= all.size()) {
      refuse("can't be read: refers to number ", number, " of its ", all.size(), " ", kind,
             "; export the mesh again");
    }
    check_members(all[number], kind, concat(kind, "[", number, "]"));
    return all[number];
  }

  void check_scene() {
    const std::size_t scenes = member(gltf_, "scenes").size();
    if (scenes > 1 && !gltf_.contains("scene")) {
      contents_.warnings.push_back(
          concat("has ", scenes, " scenes and no default; the first alone is read"));
    }
    const Gltf& scene = element("scenes", gltf_.value("scene", std::size_t{0}));
    std::vector<std::size_t> open = member(scene, "nodes").get<std::vector<std::size_t>>();
    std::set<std::size_t> seen;
    while (!open.empty()) {
      const std::size_t number = open.back();
      open.pop_back();
      if (!seen.insert(number).second) {
        refuse("can't be read: nodes[", number, "] has two parents; export the mesh again");
      }
      const Gltf& node = element("nodes", number);
      for (const Gltf& child : member(node, "children")) {
        open.push_back(child.get<std::size_t>());
      }
      if (node.contains("mesh")) {
        check_mesh(node["mesh"].get<std::size_t>());
      }
    }
  }

  void check_mesh(std::size_t number) {
    for (const Gltf& primitive : member(element("meshes", number), "primitives")) {
      const std::string where = concat("meshes[", number, "]");
      check_members(primitive, "primitives", where);
      const int mode = primitive.value("mode", 4);
      if (mode >= 0 && mode < 4) {
        continue;  // points and lines are counted by the reader
      }
      const Gltf& attributes = member(primitive, "attributes");
      if (mode < 0 || mode > 6 || !attributes.contains("POSITION")) {
        refuse(where, " has a primitive of mode ", mode,
               mode < 0 || mode > 6 ? "" : " without positions", "; export the mesh again");
      }
      const std::uint64_t positions = count_of(attributes["POSITION"], kPositions);
      const std::uint64_t count =
          primitive.contains("indices") ? count_of(primitive["indices"], kCorners) : positions;
      if (mode == 4 ? count % 3 != 0 : count < 3) {
        refuse("can't be read: ", where, " has ", count,
               " corners, which make no whole triangles; export the mesh again");
      }
      contents_.triangles += mode == 4 ? count / 3 : count - 2;
    }
  }

  /// The number of elements of an accessor of these data, which lie within its buffer view.
  std::uint64_t count_of(const Gltf& number, const Data& data) const {
    const Gltf& accessor = element("accessors", number.get<std::size_t>());
    const std::string where = concat("accessors[", number.get<std::size_t>(), "]");
    const auto size = data.sizes.find(accessor.at("componentType").get<int>());
    if (accessor.at("type") != data.type || size == data.sizes.end()) {
      refuse(where, " does not hold ", data.what, ", which alone are read; export it again, ",
             "without quantization");
    }
    if (!accessor.contains("bufferView")) {
      refuse("can't be read: ", where, " has no data; export the mesh again");
    }
    const Gltf& view = element("bufferViews", accessor["bufferView"].get<std::size_t>());
    const auto buffer = view.at("buffer").get<std::size_t>();
    if (element("buffers", buffer).contains("uri") && is_glb_ && buffer == 0) {
      refuse("has its data in another file, although it is a GLB; export it as GLB again");
    }
    const auto count = accessor.at("count").get<std::uint64_t>();
    const auto bytes = static_cast<double>(size->second);
    const double begin = accessor.value("byteOffset", 0.0);
    const double stride = view.value("byteStride", bytes);
    const double end = begin + (static_cast<double>(count) - 1) * stride + bytes;
    if (!(begin >= 0 && stride >= bytes && end <= view.at("byteLength").get<double>())) {
      refuse("can't be read: ", where, " ends behind its data; export the mesh again");
    }
    return count;
  }

  const std::string& file_;
  bool is_glb_;
  Gltf gltf_;
  GltfContents contents_;
};

}  // namespace

GltfContents check_gltf(std::string_view bytes, const std::string& file) {
  return GltfChecks(bytes, file).contents();
}

}  // namespace flashbvh::tool
