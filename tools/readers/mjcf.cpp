// flashbvh_read_mjcf FILE: reads a robot in MuJoCo's form, MJCF, as MuJoCo compiles it.
//
// A body becomes a link; further joints of a body become a chain of links without shapes. A mesh
// has the vertices that MuJoCo stores: moved to the middle of the mesh, as floats.
#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>

#include "readers/mjcf_document.hpp"
#include "readers/reader.hpp"
#include "robot/read/xml_file.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

std::string path_of_model;  ///< for mju_error(), which ends the program

/// The first number of an element in a table with `width` numbers per element.
template <class Number>
const Number* row(const Number* table, int width, int element) {
  return table + std::ptrdiff_t{width} * element;
}

Vector3 vector_of(const mjtNum* of) {
  return {of[0], of[1], of[2]};
}
Transform frame_of(const mjtNum* position, const mjtNum* quaternion) {
  return transform_of_quaternion({quaternion[0], quaternion[1], quaternion[2], quaternion[3]},
                                 vector_of(position));
}
Transform moved(const Vector3& by, double factor) {
  Transform transform;
  transform.translation = {by[0] * factor, by[1] * factor, by[2] * factor};
  return transform;
}

class MjcfReader {
 public:
  MjcfReader(const mjModel& model, const std::string& path, const MjcfDocument& document)
      : m_(model), path_(path), document_(document), links_(m_.nbody) {}

  ReadRobot read() {
    made_.robot.name = m_.names;
    made_.robot.files = document_.files;
    check_joints();
    for (int pair = 0; pair < m_.npair; ++pair) {
      paired_.insert({m_.pair_geom1[pair], m_.pair_geom2[pair]});
    }
    UrdfLink left_out;
    if (!has_world()) {
      add_shapes(0, left_out);  // for its warnings
    }
    for (int body = has_world() ? 0 : 1; body < m_.nbody; ++body) {
      add_body(body);
    }
    warn_of_rest();
    return std::move(made_);
  }

 private:
  std::string name(int kind, const char* word, int id) const {
    const char* const given = mj_id2name(&m_, kind, id);
    return given == nullptr || *given == 0 ? concat(word, " ", id) : one_line(given);
  }
  std::string body_name(int body) const { return name(mjOBJ_BODY, "body", body); }
  std::string joint_name(int joint) const { return name(mjOBJ_JOINT, "joint", joint); }
  std::string body_place(int body) const { return at_element(path_, "body", body_name(body)); }
  std::string joint_place(int joint) const { return at_element(path_, "joint", joint_name(joint)); }
  void warn(const std::string& place, const std::string& what) {
    made_.warnings.push_back({place, what});
  }

  void check_joints() {
    for (int joint = 0; joint < m_.njnt; ++joint) {
      if (m_.jnt_type[joint] == mjJNT_BALL) {
        throw UserError(joint_place(joint),
                        "is a ball, which firmware does not move; write it as three hinges");
      }
      if (m_.jnt_type[joint] == mjJNT_SLIDE && m_.jnt_limited[joint] == 0) {
        throw UserError(joint_place(joint), "slides without limits; give it a range");
      }
      if (m_.jnt_type[joint] != mjJNT_FREE) {
        continue;
      }
      if (floating_ != -1) {
        throw UserError(joint_place(joint), "is a second free joint, after ",
                        tool::quoted(joint_name(floating_)),
                        ": how the two lie is not known; leave out what is not of the robot");
      }
      floating_ = joint;
      warn(joint_place(joint),
           "floats and is taken for fixed: how the robot's links collide does not depend on where "
           "it is");
    }
  }

  bool has_mesh_or_primitive(int body) const {
    const int first = m_.body_geomadr[body];
    const auto counts = [&](int type) { return type != mjGEOM_PLANE && type != mjGEOM_HFIELD; };
    return std::any_of(m_.geom_type + first, m_.geom_type + first + m_.body_geomnum[body], counts);
  }

  /// False if the world has no shape and a single body, which floats or lies in the world's frame.
  bool has_world() {
    const auto children = std::count(m_.body_parentid + 1, m_.body_parentid + m_.nbody, 0);
    const Transform at = m_.nbody > 1 ? frame_of(m_.body_pos + 3, m_.body_quat + 4) : Transform();
    const bool is_there = m_.nbody > 1 && m_.body_jntnum[1] == 0 && at.translation == Vector3{} &&
                          at.rotation == Transform().rotation;
    const bool floats = floating_ != -1 && m_.jnt_bodyid[floating_] == 1;
    return has_mesh_or_primitive(0) || children != 1 || !(is_there || floats);
  }

  std::size_t add_link(const std::string& name) {
    made_.robot.links.emplace_back().name = name;
    return made_.robot.links.size() - 1;
  }

  void add_body(int body) {
    const int first = m_.body_jntadr[body];
    const int end = first + m_.body_jntnum[body];
    const int parent = m_.body_parentid[body];
    const bool is_root = made_.robot.links.empty();
    std::size_t above = is_root ? 0 : links_[static_cast<std::size_t>(parent)];
    Transform origin = frame_of(row(m_.body_pos, 3, body), row(m_.body_quat, 4, body));
    for (int joint = first; joint + 1 < end; ++joint) {
      const std::size_t link = add_link(concat(body_name(body), "/", joint_name(joint)));
      add_joint(joint, above, link, origin);
      above = link;
      origin = {};
    }
    const std::size_t link = add_link(body_name(body));
    links_[static_cast<std::size_t>(body)] = link;
    add_shapes(body, made_.robot.links[link]);
    if (first != end && m_.jnt_type[end - 1] != mjJNT_FREE) {
      add_joint(end - 1, above, link, origin);
    } else if (!is_root) {
      UrdfJoint& fixed = made_.robot.joints.emplace_back();
      fixed.name = concat(body_name(body), "/fixed");
      fixed.parent = above;
      fixed.child = link;
      fixed.origin = origin;
    }
  }

  /// MuJoCo counts a joint's value from `ref`, at which the file draws the body.
  void add_joint(int joint, std::size_t parent, std::size_t child, const Transform& origin) {
    const double ref = m_.qpos0[m_.jnt_qposadr[joint]];
    const bool slides = m_.jnt_type[joint] == mjJNT_SLIDE;
    UrdfJoint& made = made_.robot.joints.emplace_back();
    made.name = joint_name(joint);
    made.parent = parent;
    made.child = child;
    made.axis = vector_of(row(m_.jnt_axis, 3, joint));
    made.anchor = vector_of(row(m_.jnt_pos, 3, joint));
    made.origin = composed(origin, slides ? moved(made.axis, -ref) : turned_about(joint, -ref));
    const bool is_limited = m_.jnt_limited[joint] != 0;
    made.lower = is_limited ? row(m_.jnt_range, 2, joint)[0] : 0;
    made.upper = is_limited ? row(m_.jnt_range, 2, joint)[1] : 0;
    made.type = slides       ? UrdfJoint::Type::prismatic
                : is_limited ? UrdfJoint::Type::revolute
                             : UrdfJoint::Type::continuous;
    set_mimic(joint, made);
  }

  /// A turn about the joint's axis through its anchor.
  Transform turned_about(int joint, double angle) const {
    if (angle == 0) {
      return {};
    }
    std::array<mjtNum, 4> turn{};
    mju_axisAngle2Quat(turn.data(), row(m_.jnt_axis, 3, joint), angle);
    const Vector3 anchor = vector_of(row(m_.jnt_pos, 3, joint));
    return composed(moved(anchor, 1),
                    composed(transform_of_quaternion(turn, {}), moved(anchor, -1)));
  }

  /// joint 1 - its ref = a0 + a1 (joint 2 - its ref).
  void set_mimic(int joint, UrdfJoint& made) {
    for (int eq = 0; eq < m_.neq; ++eq) {
      if (m_.eq_type[eq] != mjEQ_JOINT || m_.eq_obj1id[eq] != joint || m_.eq_active[eq] == 0) {
        continue;
      }
      const mjtNum* const a = row(m_.eq_data, mjNEQDATA, eq);
      const int master = m_.eq_obj2id[eq];
      const bool is_linear = a[2] == 0 && a[3] == 0 && a[4] == 0;
      if (master < 0 || !is_linear || a[1] == 0 || made.mimic) {
        warn(joint_place(joint),
             "has an equality that is no line over one other joint (polycoef); it does not count: "
             "the joint is taken to move by itself");
        continue;
      }
      const double ref = m_.qpos0[m_.jnt_qposadr[joint]];
      const double master_ref = m_.qpos0[m_.jnt_qposadr[master]];
      made.mimic = {joint_name(master), a[1], ref + a[0] - a[1] * master_ref};
    }
  }

  void add_shapes(int body, UrdfLink& link) {
    const int first = m_.body_geomadr[body];
    for (int geom = first; geom < first + m_.body_geomnum[body]; ++geom) {
      const bool collides =
          m_.geom_contype[geom] != 0 || m_.geom_conaffinity[geom] != 0 || paired_.count(geom) != 0;
      UrdfCollision shape;
      shape.origin = frame_of(row(m_.geom_pos, 3, geom), row(m_.geom_quat, 4, geom));
      if (set_geometry(geom, body, shape.geometry)) {
        (collides ? link.collisions : link.visuals).push_back(std::move(shape));
        link.has_visual |= !collides;
      }
    }
    if (!link.collisions.empty()) {
      link.visuals.clear();  // Their meshes need not be sent.
    }
  }

  bool set_geometry(int geom, int body, UrdfGeometry& geometry) {
    using Shape = UrdfGeometry::Shape;
    static const std::map<int, Shape> shapes = {{mjGEOM_BOX, Shape::box},
                                                {mjGEOM_SPHERE, Shape::sphere},
                                                {mjGEOM_CYLINDER, Shape::cylinder},
                                                {mjGEOM_CAPSULE, Shape::capsule},
                                                {mjGEOM_ELLIPSOID, Shape::ellipsoid},
                                                {mjGEOM_MESH, Shape::triangles}};
    const auto shape = shapes.find(m_.geom_type[geom]);
    if (shape == shapes.end()) {
      warn(body_place(body),
           concat("has a ", m_.geom_type[geom] == mjGEOM_PLANE ? "plane" : "height field",
                  ", which is left out; if the robot can hit it, write it as a box"));
      return false;
    }
    geometry.shape = shape->second;
    const mjtNum* const size = row(m_.geom_size, 3, geom);
    geometry.size = {2 * size[0], 2 * size[1], 2 * size[2]};
    geometry.radius = size[0];
    geometry.length = 2 * size[1];
    if (geometry.shape == Shape::triangles) {
      set_mesh(m_.geom_dataid[geom], geom, geometry);
    }
    return true;
  }

  void set_mesh(int mesh, int geom, UrdfGeometry& geometry) {
    const std::string mesh_name = name(mjOBJ_MESH, "mesh", mesh);
    const auto file = document_.mesh_files.find(mesh_name);
    geometry.mesh = file == document_.mesh_files.end() ? mesh_name : file->second;
    const float* const vertices = row(m_.mesh_vert, 3, m_.mesh_vertadr[mesh]);
    const int* const faces = row(m_.mesh_face, 3, m_.mesh_faceadr[mesh]);
    double farthest = 0;
    for (int i = 0; i < m_.mesh_vertnum[mesh]; ++i) {
      Vector3 vertex{};
      std::copy_n(row(vertices, 3, i), 3, vertex.begin());
      farthest = std::max(farthest, std::hypot(vertex[0], vertex[1], vertex[2]));
      geometry.triangles.vertices.push_back(vertex);
    }
    for (int i = 0; i < m_.mesh_facenum[mesh]; ++i) {
      const int* const face = row(faces, 3, i);
      geometry.triangles.triangles.push_back({static_cast<std::uint32_t>(face[0]),
                                              static_cast<std::uint32_t>(face[1]),
                                              static_cast<std::uint32_t>(face[2])});
    }
    // A float's rounding each for reading, scaling, moving and storing.
    const mjtNum* const at = row(m_.geom_pos, 3, geom);
    geometry.precision = 0x1p-22 * (farthest + std::hypot(at[0], at[1], at[2]));
  }

  void warn_of_rest() {
    for (int i = 0; i < m_.nexclude; ++i) {
      const int first = (m_.exclude_signature[i] >> 16) - 1;
      const int second = (m_.exclude_signature[i] & 0xFFFF) - 1;
      warn(path_, concat("excludes ", tool::quoted(body_name(first)), " and ",
                         tool::quoted(body_name(second)),
                         " from contact, which does not count: the pair is decided as all are; to "
                         "leave it out, disable it in an SRDF"));
    }
    for (const char* const element : {"tendon", "connect", "weld"}) {
      if (document_.dropped.count(element) != 0) {
        warn(path_, concat("has a <", element,
                           ">, which does not count: joints are taken to move by themselves"));
      }
    }
  }

  const mjModel& m_;
  const std::string& path_;
  const MjcfDocument& document_;
  std::vector<std::size_t> links_;  ///< of each body
  std::set<int> paired_;            ///< geoms that collide by a <pair>
  int floating_ = -1;               ///< joint, or -1
  ReadRobot made_;
};

constexpr const char* kName = "model.xml";  ///< of the file in memory

ReadRobot read_mjcf(const std::string& path) {
  path_of_model = path;
  mju_user_error = [](const char* message) {
    refuse_and_exit(concat(path_of_model, ": is no sound MJCF: ", one_line(message),
                           "; correct what it names"));
  };
  mju_user_warning = [](const char*) {};
  const MjcfDocument document = read_mjcf_document(path);
  auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  mj_makeEmptyFileVFS(files.get(), kName, static_cast<int>(document.text.size()));
  document.text.copy(static_cast<char*>(files->filedata[0]), document.text.size());
  std::array<char, 1000> error{};
  const mjModel* const model =
      mj_loadXML(kName, files.get(), error.data(), static_cast<int>(error.size()));
  std::string message = one_line(error.data());
  message = message.substr(0, message.find(", line "));  // a line of the trimmed text
  if (model == nullptr) {
    throw UserError(path, "is no sound MJCF: ", message, "; correct what it names");
  }
  ReadRobot read = MjcfReader(*model, path, document).read();
  if (!message.empty()) {
    read.warnings.push_back({path, message});
  }
  return read;
}

}  // namespace
}  // namespace flashbvh::tool

int main(int argc, char** argv) {
  flashbvh::tool::run_reader(argc, argv, flashbvh::tool::read_mjcf);
}
