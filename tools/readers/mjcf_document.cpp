#include "readers/mjcf_document.hpp"

#include <filesystem>
#include <utility>

#include "robot/read/xml_file.hpp"
#include "text/files.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {
namespace {

namespace fs = std::filesystem;
using Names = std::set<std::string>;

/// The attributes that elements keep; all others are dropped. Elements in neither list stay
/// unchanged.
const std::map<std::string, Names> kKept = {
    {"body",
     {"name", "childclass", "pos", "quat", "axisangle", "xyaxes", "zaxis", "euler", "mocap"}},
    {"compiler",
     {"angle", "autolimits", "coordinate", "eulerseq", "exactmeshinertia", "fitaabb", "strippath"}},
    {"exclude", {"name", "body1", "body2"}},
    {"freejoint", {"name"}},
    {"geom",
     {"name", "class", "type", "contype", "conaffinity", "size", "fromto", "pos", "quat",
      "axisangle", "xyaxes", "zaxis", "euler", "hfield", "mesh", "fitscale"}},
    {"joint",
     {"name", "class", "type", "pos", "axis", "range", "limited", "ref", "joint1", "joint2",
      "polycoef", "active"}},
    {"mesh", {"name", "class", "file", "vertex", "face", "scale", "refpos", "refquat"}},
    {"pair", {"name", "class", "geom1", "geom2"}}};

/// Attributes of <compiler>, of MuJoCo up to 3.3, that change neither shapes nor joints. The
/// folders of meshes are read separately.
const Names kOtherCompiler = {
    "alignfree",  "assetdir",      "balanceinertia", "boundinertia",    "boundmass",
    "convexhull", "discardvisual", "fusestatic",     "inertiafromgeom", "inertiagrouprange",
    "meshdir",    "saveinertial",  "settotalmass",   "texturedir",      "usethread"};

const Names kDropped = {
    // of the model
    "option", "size", "visual", "statistic", "custom", "tendon", "actuator", "sensor", "keyframe",
    "extension", "deformable",
    // of assets, bodies and equalities
    "texture", "material", "skin", "inertial", "site", "camera", "light", "plugin", "composite",
    "flexcomp", "connect", "weld", "distance", "flex",
    // of defaults
    "general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle",
    "adhesion"};

void keep_attributes(TiXmlElement& element, const Names& kept) {
  for (TiXmlAttribute* a = element.FirstAttribute(); a != nullptr;) {
    const std::string name = a->Name();
    a = a->Next();
    if (kept.count(name) == 0) {
      element.RemoveAttribute(name);
    }
  }
}

/// An attribute of neither list may change shapes: UserError.
void check_compiler(const TiXmlElement& compiler, const std::string& path) {
  const Names& kept = kKept.at("compiler");
  for (const TiXmlAttribute* a = compiler.FirstAttribute(); a != nullptr; a = a->Next()) {
    if (kept.count(a->Name()) == 0 && kOtherCompiler.count(a->Name()) == 0) {
      throw UserError(path, "has a <compiler> with ", one_line(a->Name()),
                      ", which flashbvh does not know and which may change shapes; leave it out");
    }
  }
}

class Trimmer {
 public:
  explicit Trimmer(const std::string& path)
      : path_(path), folder_(fs::absolute(path).parent_path()) {}

  MjcfDocument trimmed() {
    TiXmlDocument document;
    read_xml(path_, "mujoco", document);
    TiXmlElement& root = *document.RootElement();
    trim(root);
    for (const auto& [name, file] : made_.mesh_files) {
      add_file(folder_ / mesh_folder_ / file);
    }
    // In front, so that the file's own ones override it.
    TiXmlNode* const first = root.FirstChild();
    (void)(first == nullptr ? root.InsertEndChild(compiler())
                            : root.InsertBeforeChild(first, compiler()));
    TiXmlPrinter printer;
    document.Accept(&printer);
    made_.text = printer.Str();
    return std::move(made_);
  }

 private:
  /// Sets limits as in newer MuJoCo, and accepts all masses, which do not matter to shapes.
  TiXmlElement compiler() const {
    TiXmlElement compiler("compiler");
    for (const char* const name : {"autolimits", "balanceinertia"}) {
      compiler.SetAttribute(name, "true");
    }
    for (const char* const name : {"boundmass", "boundinertia"}) {
      compiler.SetAttribute(name, "1");
    }
    compiler.SetAttribute("meshdir", (folder_ / mesh_folder_).string());
    return compiler;
  }

  void trim(TiXmlElement& element) {
    note(element);
    if (const auto kept = kKept.find(element.ValueStr()); kept != kKept.end()) {
      keep_attributes(element, kept->second);
    }
    for (TiXmlElement* child = element.FirstChildElement(); child != nullptr;) {
      TiXmlElement* const next = child->NextSiblingElement();
      if (kDropped.count(child->ValueStr()) != 0) {
        if (child->FirstChild() != nullptr || child->FirstAttribute() != nullptr) {
          made_.dropped.insert(child->ValueStr());
        }
        element.RemoveChild(child);
      } else if (child->ValueStr() == "include") {
        include(*child, element);
      } else {
        trim(*child);
      }
      child = next;
    }
  }

  void note(const TiXmlElement& element) {
    const std::string file = attribute(&element, "file");
    if (element.ValueStr() == "mesh" && !file.empty()) {
      const std::string name = attribute(&element, "name");
      made_.mesh_files[name.empty() ? fs::path(file).stem().string() : name] = file;
    }
    if (element.ValueStr() == "compiler") {
      check_compiler(element, path_);
      for (const char* const name : {"assetdir", "meshdir"}) {
        const std::string given = attribute(&element, name);
        mesh_folder_ = given.empty() ? mesh_folder_ : given;
      }
    }
  }

  /// Replaces `included`, an element of `parent`, by the contents of its file.
  void include(TiXmlElement& included, TiXmlElement& parent) {
    const std::string path = (folder_ / attribute(&included, "file")).string();
    if (!seen_.insert(path).second) {
      throw UserError(path, "is included twice; include it once");
    }
    std::string text = read_file(path);
    const std::string root(root_element(text));
    TiXmlDocument document;
    parse_xml(std::move(text), path, root == "mujoco" ? "mujoco" : "mujocoinclude", document);
    made_.files.push_back(path);
    const std::string outer = std::exchange(path_, path);
    trim(*document.RootElement());
    path_ = outer;
    for (const TiXmlNode* child = document.RootElement()->FirstChild(); child != nullptr;
         child = child->NextSibling()) {
      parent.InsertBeforeChild(&included, *child);
    }
    parent.RemoveChild(&included);
  }

  void add_file(const fs::path& path) {
    std::error_code unknown;
    if (fs::is_regular_file(path, unknown)) {
      made_.files.push_back(path.string());
    }
  }

  std::string path_;  ///< of the file that is being trimmed
  const fs::path folder_;
  std::string mesh_folder_;
  Names seen_;
  MjcfDocument made_;
};

}  // namespace

MjcfDocument read_mjcf_document(const std::string& path) {
  return Trimmer(path).trimmed();
}

}  // namespace flashbvh::tool
