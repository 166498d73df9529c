#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>

#include "mesh/scene_checks.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

using Gltf = nlohmann::json;

/// The beginnings of the names of extensions of glTF and 3MF that move no vertex and make no
/// triangle, and of those that a reader checks.
constexpr std::array<std::string_view, 22> kUnderstood = {
    "KHR_materials_",
    "KHR_texture_",
    "EXT_texture_",
    "MSFT_texture_",
    "MSFT_packing_",
    "KHR_lights_",
    "EXT_lights_",
    "KHR_xmp",
    "KHR_audio",
    "KHR_animation_pointer",
    "KHR_interactivity",
    "KHR_draco_mesh_compression",
    "KHR_mesh_quantization",
    "EXT_structural_metadata",
    "EXT_mesh_features",
    "EXT_mesh_manifold",
    "FB_ngon_encoding",
    "CESIUM_primitive_outline",
    "VRM",
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"};

constexpr const char* kDraco = "KHR_draco_mesh_compression";

// Types of components.
constexpr int kByte = 5121;
constexpr int kShort = 5123;
constexpr int kInt = 5125;
constexpr int kFloat = 5126;

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

class Checks {
 public:
  Checks(std::string_view bytes, const std::string& file)
      : file_(file),
        is_glb_(bytes.substr(0, 4) == "glTF"),
        gltf_(Gltf::parse(json_of(bytes), nullptr, false)) {
    if (!gltf_.is_object()) {
      throw UserError(file, "can't be read: has no JSON of a glTF; export the mesh again");
    }
  }

  GltfContents contents() {
    for (const Gltf& required : list(gltf_, "extensionsRequired")) {
      if (!is_understood(required.get<std::string>())) {
        refuse("requires the extension ", required.get<std::string>(),
               ", which is not read; export it without");
      }
    }
    if (const std::string least = list(gltf_, "asset").value("minVersion", "2.0"); least != "2.0") {
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

  /// The member, or an empty list.
  static const Gltf& list(const Gltf& of, const char* name) {
    static const Gltf nothing;
    const auto found = of.find(name);
    return found == of.end() ? nothing : *found;
  }

  const Gltf& element(const char* kind, std::size_t number) const {
    const Gltf& all = list(gltf_, kind);
    if (number >= all.size()) {
      refuse("can't be read: refers to number ", number, " of its ", all.size(), " ", kind,
             "; export the mesh again");
    }
    return all[number];
  }

  void check_extensions(const Gltf& of, const std::string& where) const {
    for (const auto& [name, value] : list(of, "extensions").items()) {
      if (!is_understood(name)) {
        refuse(where, " uses the extension ", name, ", which is not read; export it without");
      }
    }
  }

  void check_scene() {
    const std::size_t scenes = list(gltf_, "scenes").size();
    if (scenes > 1 && !gltf_.contains("scene")) {
      contents_.warnings.push_back(
          concat("has ", scenes, " scenes and no default; the first alone is read"));
    }
    const Gltf& scene = element("scenes", gltf_.value("scene", std::size_t{0}));
    check_extensions(scene, "its scene");
    std::vector<std::size_t> open = list(scene, "nodes").get<std::vector<std::size_t>>();
    std::vector<bool> seen(list(gltf_, "nodes").size());
    while (!open.empty()) {
      const std::size_t number = open.back();
      open.pop_back();
      const Gltf& node = element("nodes", number);
      if (seen[number]) {
        refuse("can't be read: node ", number, " has two parents; export the mesh again");
      }
      seen[number] = true;
      for (const Gltf& child : list(node, "children")) {
        open.push_back(child.get<std::size_t>());
      }
      check_node(node, concat("node ", number));
    }
  }

  void check_node(const Gltf& node, const std::string& where) {
    check_extensions(node, where);
    if (!node.contains("mesh")) {
      return;
    }
    if (node.contains("skin")) {
      refuse(where, " has a skin, which is not read; export the pose as a mesh without a skin");
    }
    const auto number = node["mesh"].get<std::size_t>();
    const Gltf& mesh = element("meshes", number);
    check_extensions(mesh, concat("mesh ", number));
    for (const Gltf& weight : list(node.contains("weights") ? node : mesh, "weights")) {
      if (weight.get<double>() != 0) {
        refuse(where, " has weights of morph targets, which are not read; apply the shape keys");
      }
    }
    for (const Gltf& primitive : list(mesh, "primitives")) {
      check_primitive(primitive, concat("mesh ", number));
    }
  }

  void check_primitive(const Gltf& primitive, const std::string& where) {
    check_extensions(primitive, where);
    const int mode = primitive.value("mode", 4);
    if (mode >= 0 && mode < 4) {
      return;  // points and lines are counted by the reader
    }
    const Gltf& attributes = list(primitive, "attributes");
    if (mode < 0 || mode > 6 || !attributes.contains("POSITION")) {
      refuse(where, " has a primitive of mode ", mode,
             mode < 0 || mode > 6 ? "" : " without positions", "; export the mesh again");
    }
    const bool draco = list(primitive, "extensions").contains(kDraco);
    const bool indexed = primitive.contains("indices");
    const Gltf& position =
        accessor(attributes["POSITION"].get<std::size_t>(), "VEC3", {kFloat}, draco);
    const Gltf& corners = !indexed ? position
                                   : accessor(primitive["indices"].get<std::size_t>(), "SCALAR",
                                              {kByte, kShort, kInt}, draco);
    if (draco && (mode != 4 || !indexed || corners.value("componentType", 0) == kInt ||
                  !list(primitive["extensions"][kDraco], "attributes").contains("POSITION"))) {
      refuse(where, " is compressed by ", kDraco,
             ", of which triangles of positions with 16-bit indices alone are read; export it "
             "without");
    }
    const auto count = corners.at("count").get<std::uint64_t>();
    if (mode == 4 ? count % 3 != 0 : count < 3) {
      refuse("can't be read: ", where, " has ", count,
             " corners, which make no whole triangles; export the mesh again");
    }
    contents_.triangles += mode == 4 ? count / 3 : count - 2;
  }

  const Gltf& accessor(std::size_t number, const char* type, const std::vector<int>& components,
                       bool draco) const {
    const Gltf& found = element("accessors", number);
    const std::string where = concat("accessor ", number);
    check_extensions(found, where);
    const int component = found.at("componentType").get<int>();
    if (found.at("type") != type ||
        std::find(components.begin(), components.end(), component) == components.end()) {
      refuse(where, " has components of type ", component, " in a ",
             found["type"].get<std::string>(),
             components.size() == 1
                 ? ", positions that are no floats (KHR_mesh_quantization), which are not read; "
                   "export it without quantization"
                 : ", which are no indices; export the mesh again");
    }
    if (found.contains("sparse")) {
      refuse(where, " is sparse, which is not read; export it without sparse accessors");
    }
    if (!draco) {
      check_data(found, where,
                 components.size() == 1 ? 12
                 : component == kByte   ? 1
                 : component == kShort  ? 2
                                        : 4);
    }
    return found;
  }

  /// `size`: of an element, in bytes.
  void check_data(const Gltf& accessor, const std::string& where, std::uint64_t size) const {
    if (!accessor.contains("bufferView")) {
      refuse("can't be read: ", where, " has no data; export the mesh again");
    }
    const Gltf& view = element("bufferViews", accessor["bufferView"].get<std::size_t>());
    check_extensions(view, "a buffer view");
    const auto number = view.at("buffer").get<std::size_t>();
    const Gltf& buffer = element("buffers", number);
    check_extensions(buffer, "a buffer");
    if (is_glb_ && number == 0 && buffer.contains("uri")) {
      refuse("has its data in another file, although it is a GLB; export it as GLB again");
    }
    const double begin = accessor.value("byteOffset", 0.0);
    const double stride = view.value("byteStride", static_cast<double>(size));
    const double end =
        begin + (accessor.at("count").get<double>() - 1) * stride + static_cast<double>(size);
    if (!(begin >= 0 && stride >= static_cast<double>(size) &&
          end <= view.at("byteLength").get<double>())) {
      refuse("can't be read: ", where, " ends behind its data; export the mesh again");
    }
  }

  const std::string& file_;
  bool is_glb_;
  Gltf gltf_;
  GltfContents contents_;
};

}  // namespace

bool is_understood(std::string_view extension) {
  return std::any_of(kUnderstood.begin(), kUnderstood.end(), [&](std::string_view known) {
    return extension.substr(0, known.size()) == known;
  });
}

GltfContents check_gltf(std::string_view bytes, const std::string& file) {
  return Checks(bytes, file).contents();
}

}  // namespace flashbvh::tool
