// Arms made of boxes and prisms, by hand and at random.
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

/// In [low, high).
double real_between(Random& random, double low, double high);

Transform shifted(const Vector3& translation);
/// About axis 0, 1 or 2.
Transform turned(std::size_t axis, double angle);

/// Closed, with these corners.
bake::SourceMesh box(const Vector3& low, const Vector3& high);
/// Between z = low and z = high, round a polygon of `sides` corners at `radius` from (x, y), the
/// first of them in the direction of x.
bake::SourceMesh prism(int sides, double radius, double x, double y, double low, double high);

/// A new joint with a variable of its own; its number. Continuous ones are limited to +-pi.
std::size_t add_joint(Model& model, std::size_t parent, const Transform& fixed, JointType type,
                      double lower, double upper);
/// One that moves as another's variable says.
std::size_t add_mimic(Model& model, std::size_t parent, const Transform& fixed, JointType type,
                      std::size_t variable, double multiplier, double offset);
std::size_t add_link(Model& model, std::size_t joint, const bake::SourceMesh& mesh);

/// A chain of `joints` joints of all types, now and then with a mimic or a branch; links of about a
/// length of 0.3.
Model any_arm(Random& random, std::size_t joints);

/// All its links with one cell.
class BakedArm {
 public:
  BakedArm(const Model& model, double cell);

  /// What firmware gets.
  const std::vector<Mesh>& meshes() const { return meshes_; }
  /// On which pairs are decided.
  const std::vector<tool::WholeMesh>& wholes() const { return wholes_; }
  double cell() const { return cell_; }
  /// Of a link, in metres.
  std::vector<std::uint32_t> image(std::size_t link) const;
  /// By the exact query.
  bool intersect(std::size_t a, std::size_t b, const std::vector<double>& variables) const;
  /// Whether they are at most so many cells apart.
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

/// A value each, within the limits.
std::vector<double> any_variables(Random& random, const Model& model);

/// A base with `mesh`, and a blade, 0.1 long either way, on a carriage that slides along x, turning
/// about z.
tool::Model blade_and(const bake::SourceMesh& mesh, double lower, double upper);

}  // namespace flashbvh::test
