#include "support/arms/arms.hpp"

#include <cmath>
#include <string>

#include "bake/image_bytes.hpp"
#include "flashbvh/clearance.hpp"

namespace flashbvh::test {
namespace {

using namespace tool;

void add_quad(bake::SourceMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
              std::uint32_t d) {
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

Transform any_turn(Random& random) {
  const auto angle = [&] {
    return random.below(2) == 0 ? kPi / 2 * random.between(-2, 2) : real_between(random, -kPi, kPi);
  };
  Transform turn = turned(0, angle());
  turn = composed(turn, turned(1, angle()));
  return composed(turn, turned(2, angle()));
}

/// A box or a prism of about `length` along its z axis.
bake::SourceMesh any_body(Random& random, double length) {
  const double thick = real_between(random, 0.02, 0.08);
  if (random.below(2) == 0) {
    const double wide = real_between(random, 0.02, 0.08);
    return box({-thick, -wide, -0.02}, {thick, wide, length});
  }
  const int sides = 3 + static_cast<int>(random.below(10));
  return prism(sides, thick, real_between(random, -0.03, 0.03), 0, -0.02, length);
}

std::size_t add_any_joint(Random& random, Model& model, std::size_t parent,
                          const Transform& fixed) {
  const std::uint32_t kind = random.below(8);
  if (kind == 0) {
    return add_joint(model, parent, fixed, JointType::continuous, -kPi, kPi);
  }
  if (kind == 1) {
    return add_joint(model, parent, fixed, JointType::prismatic, 0,
                     real_between(random, 0.05, 0.3));
  }
  if (kind == 2 && !model.variables.empty()) {
    const std::uint32_t variable = random.below(static_cast<std::uint32_t>(model.variables.size()));
    const double multiplier = real_between(random, -1.5, 1.5);
    return add_mimic(model, parent, fixed, JointType::revolute, variable, multiplier,
                     real_between(random, -0.5, 0.5));
  }
  const double lower = real_between(random, -3, 0);
  return add_joint(model, parent, fixed, JointType::revolute, lower, real_between(random, 0.1, 3));
}

}  // namespace

double real_between(Random& random, double low, double high) {
  return low + std::ldexp(static_cast<double>(random.next() >> 11), -53) * (high - low);
}

Vector3 any_vector(Random& random, double size) {
  Vector3 vector{};
  for (double& coordinate : vector) {
    coordinate = real_between(random, -size, size);
  }
  return vector;
}

Transform shifted(const Vector3& translation) {
  Transform made;
  made.translation = translation;
  return made;
}

Transform turned(std::size_t axis, double angle) {
  Transform made;
  const std::size_t j = (axis + 1) % 3;
  const std::size_t k = (axis + 2) % 3;
  made.rotation[j][j] = made.rotation[k][k] = std::cos(angle);
  made.rotation[k][j] = std::sin(angle);
  made.rotation[j][k] = -std::sin(angle);
  return made;
}

bake::SourceMesh box(const Vector3& low, const Vector3& high) {
  bake::SourceMesh mesh;
  for (unsigned i = 0; i < 8; ++i) {
    mesh.vertices.push_back({(i & 1) != 0 ? high[0] : low[0], (i & 2) != 0 ? high[1] : low[1],
                             (i & 4) != 0 ? high[2] : low[2]});
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

bake::SourceMesh prism(int sides, double radius, double x, double y, double low, double high) {
  bake::SourceMesh mesh;
  const auto count = static_cast<std::uint32_t>(sides);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 2 * kPi * i / sides;
    for (const double z : {low, high}) {
      mesh.vertices.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle), z});
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    add_quad(mesh, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1);
    if (i >= 1 && i + 1 < count) {
      mesh.triangles.push_back({0, 2 * next, 2 * i});
      mesh.triangles.push_back({1, 2 * i + 1, 2 * next + 1});
    }
  }
  return mesh;
}

std::size_t add_joint(Model& model, std::size_t parent, const Transform& fixed, JointType type,
                      double lower, double upper) {
  ModelJoint joint;
  joint.name = "joint" + std::to_string(model.joints.size());
  joint.parent = parent;
  joint.fixed = fixed;
  joint.type = type;
  joint.lower = lower;
  joint.upper = upper;
  joint.variable = model.variables.size();
  model.variables.push_back(model.joints.size());
  model.joints.push_back(joint);
  return model.joints.size() - 1;
}

std::size_t add_mimic(Model& model, std::size_t parent, const Transform& fixed, JointType type,
                      std::size_t variable, double multiplier, double offset) {
  const std::size_t number = add_joint(model, parent, fixed, type, 0, 0);
  model.variables.pop_back();
  ModelJoint& joint = model.joints[number];
  joint.variable = variable;
  joint.multiplier = multiplier;
  joint.offset = offset;
  return number;
}

std::size_t add_link(Model& model, std::size_t joint, const bake::SourceMesh& mesh) {
  ModelLink link;
  link.name = "link" + std::to_string(model.links.size());
  link.joint = joint;
  link.mesh = mesh;
  model.links.push_back(link);
  model.mounts.push_back({link.name, joint, shifted({0, 0, 0.01})});
  return model.links.size() - 1;
}

Model any_arm(Random& random, std::size_t joints) {
  Model model;
  std::size_t parent = kNoJoint;
  double length = real_between(random, 0.05, 0.3);
  add_link(model, parent, any_body(random, length));
  for (std::size_t i = 0; i < joints; ++i) {
    Transform fixed = shifted({0, 0, length + real_between(random, 0.01, 0.06)});
    fixed = composed(fixed, shifted(any_vector(random, 0.03)));
    fixed = composed(fixed, any_turn(random));
    const std::size_t before = parent;
    parent = add_any_joint(random, model, parent, fixed);
    length = real_between(random, 0.05, 0.3);
    add_link(model, parent, any_body(random, length));
    model.neighbours.emplace_back(model.links.size() - 2, model.links.size() - 1);
    if (random.below(10) == 0) {
      parent = before == kNoJoint ? parent : before;  // a branch; neighbours may collide
    }
  }
  return model;
}

using Baked = bake::BakedTree<std::uint16_t, Layout::post_indexed>;

BakedArm::BakedArm(const Model& model, double cell) : model_(model), cell_(cell) {
  for (const ModelLink& link : model.links) {
    BakeOptions options;
    options.cell = cell;
    baked_.push_back(tool::bake(input_of(link.name, link.mesh), options));
    Baked& tree = std::get<Baked>(baked_.back().tree);
    tree.unit = Unit::m;
    meshes_.push_back(tree.view());
    baked_wholes_.push_back(bake_part(link.mesh, cell));
  }
  wholes_ = views_of(baked_wholes_);
}

std::vector<std::uint32_t> BakedArm::image(std::size_t link) const {
  return bake::image_of(std::get<Baked>(baked_[link].tree));
}

bool BakedArm::intersect(std::size_t a, std::size_t b, const std::vector<double>& variables) const {
  const Transform frame = frame_between(model_, joints_between(model_, a, b), variables);
  return intersects(meshes_[a], meshes_[b], pose_of(frame, cell_)).yes;
}

bool BakedArm::are_within(std::size_t a, std::size_t b, const std::vector<double>& variables,
                          double distance) const {
  const Transform frame = frame_between(model_, joints_between(model_, a, b), variables);
  return closer_than(meshes_[a], meshes_[b], pose_of(frame, cell_),
                     {static_cast<std::uint32_t>(distance * kFineOne)})
      .yes;
}

std::vector<PairVerdict> BakedArm::decide(const MatrixOptions& options,
                                          const std::vector<tool::JointZone>& zones) const {
  return decide_pairs(model_, wholes_, zones, tool::all_reaches(model_, cell_), cell_, options, {});
}

std::vector<double> any_variables(Random& random, const Model& model) {
  std::vector<double> variables;
  for (std::size_t i = 0; i < model.variables.size(); ++i) {
    const Interval range = range_of_variable(model, i);
    const std::uint32_t kind = random.below(16);
    variables.push_back(kind == 0   ? range.lower
                        : kind == 1 ? range.upper
                                    : real_between(random, range.lower, range.upper));
  }
  return variables;
}

Model blade_and(const bake::SourceMesh& mesh, double lower, double upper) {
  Model model;
  add_link(model, kNoJoint, mesh);
  const std::size_t carriage =
      add_joint(model, kNoJoint, turned(1, kPi / 2), JointType::prismatic, lower, upper);
  const std::size_t spindle =
      add_joint(model, carriage, turned(1, -kPi / 2), JointType::revolute, -3, 3);
  add_link(model, spindle, box({-0.1, -0.01, 0}, {0.1, 0.01, 0.3}));
  return model;
}

}  // namespace flashbvh::test
