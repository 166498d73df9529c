// Arms made of boxes and prisms: fixed and random ones.
#pragma once

#include <deque>
#include <vector>

#include "image/baking.hpp"
#include "robot/kinematics.hpp"
#include "robot/matrix/matrix.hpp"
#include "support/random.hpp"

namespace flashbvh::test {

using tool::Model;
using tool::Transform;
using tool::Vector3;

using tool::kPi;

/// A random number in [low, high).
double real_between(Random& random, double low, double high);
/// A vector with coordinates in [-size, size).
Vector3 any_vector(Random& random, double size);

Transform shifted(const Vector3& translation);
/// A rotation about axis 0, 1 or 2.
Transform turned(std::size_t axis, double angle);

/// A closed box with these corners.
bake::SourceMesh box(const Vector3& low, const Vector3& high);
/// A closed prism from z = low to z = high over a polygon of `sides` corners at `radius` from
/// (x, y); the first corner lies in the direction of x.
bake::SourceMesh prism(int sides, double radius, double x, double y, double low, double high);

/// Adds a joint with its own variable; returns its number. Continuous ones are limited to +-pi.
std::size_t add_joint(Model& model, std::size_t parent, const Transform& fixed, JointType type,
                      double lower, double upper);
/// Adds a joint that mimics `variable`; returns its number.
std::size_t add_mimic(Model& model, std::size_t parent, const Transform& fixed, JointType type,
                      std::size_t variable, double multiplier, double offset);
std::size_t add_link(Model& model, std::size_t joint, const bake::SourceMesh& mesh);

/// A chain of `joints` joints of all types, sometimes with a mimic or a branch; its links are about
/// 0.3 long.
Model any_arm(Random& random, std::size_t joints);

/// An arm whose links are all baked with one cell.
class BakedArm {
 public:
  BakedArm(const Model& model, double cell);

  /// The meshes that firmware gets.
  const std::vector<Mesh>& meshes() const { return meshes_; }
  /// The meshes on which the matrix decides pairs.
  const std::vector<tool::WholeMesh>& wholes() const { return wholes_; }
  double cell() const { return cell_; }
  /// The image of a link, whose cell is in metres.
  std::vector<std::uint32_t> image(std::size_t link) const;
  /// Whether two links intersect, by the exact query.
  bool intersect(std::size_t a, std::size_t b, const std::vector<double>& variables) const;
  /// Whether two links are at most `distance` cells apart.
  bool are_within(std::size_t a, std::size_t b, const std::vector<double>& variables,
                  double distance) const;
  std::vector<tool::PairVerdict> decide(const tool::MatrixOptions& options = {},
                                        const std::vector<tool::JointZone>& zones = {}) const;

 private:
  const Model& model_;
  double cell_;
  std::deque<tool::BakedMesh> baked_;
  std::vector<Mesh> meshes_;
  std::vector<tool::BakedPart> baked_wholes_;
  std::vector<tool::WholeMesh> wholes_;
};

/// A value for each variable, within the limits.
std::vector<double> any_variables(Random& random, const Model& model);

/// A base with `mesh`, and a blade that reaches 0.1 either way, turning about z, on a carriage that
/// slides along x.
tool::Model blade_and(const bake::SourceMesh& mesh, double lower, double upper);

}  // namespace flashbvh::test
