// A model's frames against the URDF's own axes and origins, evaluated by its specification.
#include "support/arms/arms.hpp"
#include "support/arms/robot_files.hpp"
#include "support/oracles/float_distance.hpp"
#include "support/test.hpp"

namespace {

std::string text_of(const Vector3& v) {
  return "\"" + tool::shortest(v[0]) + " " + tool::shortest(v[1]) + " " + tool::shortest(v[2]) +
         "\"";
}

Vector3 unit_along(const Vector3& axis) {
  return plus({0, 0, 0}, 1 / std::sqrt(squared(axis)), axis);
}

/// A rotation by Rodrigues' formula.
Transform turn_about(const Vector3& axis, double angle) {
  const Vector3 k = unit_along(axis);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  Transform turn;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      turn.rotation[i][j] = (i == j ? c : 0) + (1 - c) * k[i] * k[j];
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    turn.rotation[(i + 2) % 3][(i + 1) % 3] += s * k[i];
    turn.rotation[(i + 1) % 3][(i + 2) % 3] -= s * k[i];
  }
  return turn;
}

/// The rotations about fixed axes: x, then y, then z.
Transform origin_of(const Vector3& xyz, const Vector3& rpy) {
  Transform moved;
  moved.translation = xyz;
  return composed(
      composed(composed(moved, turn_about({0, 0, 1}, rpy[2])), turn_about({0, 1, 0}, rpy[1])),
      turn_about({1, 0, 0}, rpy[0]));
}

struct PlainJoint {
  std::string type;
  std::size_t parent;
  Vector3 xyz, rpy, axis;
  std::size_t mimics;  ///< its own number if it is no mimic
  double multiplier, offset;

  double coordinate(const std::vector<PlainJoint>& joints, const std::vector<double>& values,
                    std::size_t own) const {
    return mimics == own ? values[own]
                         : multiplier * joints[mimics].coordinate(joints, values, mimics) + offset;
  }
  Transform at(double q) const {
    const Transform origin = origin_of(xyz, rpy);
    if (type == "fixed") {
      return origin;
    }
    if (type == "prismatic") {
      Transform slide;
      slide.translation = plus({0, 0, 0}, q, unit_along(axis));
      return composed(origin, slide);
    }
    return composed(origin, turn_about(axis, q));
  }
};

/// Joint i leads from an earlier link to link i + 1.
std::vector<PlainJoint> random_joints(Random& random, std::uint32_t count) {
  const std::vector<Vector3> plain_axes = {{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                           {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  const char* const types[] = {"revolute", "prismatic", "fixed", "revolute", "continuous"};
  std::vector<PlainJoint> joints;
  for (std::uint32_t i = 0; i < count; ++i) {
    PlainJoint joint{types[random.below(5)],
                     random.below(i + 1),
                     any_vector(random, 1),
                     any_vector(random, 3),
                     any_vector(random, 1),
                     i,
                     1,
                     0};
    if (random.below(2) == 0) {
      joint.axis = plain_axes[random.below(6)];
    } else if (random.below(2) == 0) {
      joint.axis = {1e-9, -1e-5, -1};
    }
    const std::size_t other = random.below(i + 1);
    const bool can_mimic = joint.type == "revolute" || joint.type == "prismatic";
    if (can_mimic && other != i &&
        (joints[other].type == "revolute" || joints[other].type == "prismatic")) {
      joint.mimics = other;
      joint.multiplier = real_between(random, -2, 2);
      joint.offset = real_between(random, -1, 1);
    }
    joints.push_back(joint);
  }
  return joints;
}

std::string urdf_of(const std::vector<PlainJoint>& joints, const std::vector<Vector3>& corners) {
  std::string text;
  for (std::size_t i = 0; i <= joints.size(); ++i) {
    text +=
        link_text("l" + std::to_string(i), "<collision><origin xyz=" + text_of(corners[i]) +
                                               " rpy=\"0.3 -2 1\"/><geometry><box size=\"1 2 3\"/>"
                                               "</geometry></collision>");
  }
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const PlainJoint& j = joints[i];
    std::string inside = "<origin xyz=" + text_of(j.xyz) + " rpy=" + text_of(j.rpy) +
                         "/><axis xyz=" + text_of(j.axis) + "/>";
    inside += j.type == "continuous" ? "" : kLimit;
    if (j.mimics != i) {
      inside += "<mimic joint=\"j" + std::to_string(j.mimics) + "\" multiplier=\"" +
                tool::shortest(j.multiplier) + "\" offset=\"" + tool::shortest(j.offset) + "\"/>";
    }
    text += joint_text("j" + std::to_string(i), j.type, "l" + std::to_string(j.parent),
                       "l" + std::to_string(i + 1), inside);
  }
  return text;
}

void check_at(const tool::Model& model, const std::vector<PlainJoint>& joints,
              const std::vector<Vector3>& corners, Random& random) {
  std::vector<double> values;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    values.push_back(real_between(random, -1, 2));
  }
  std::vector<double> variables;
  for (const std::size_t joint : model.variables) {
    variables.push_back(values[std::stoul(model.joints[joint].name.substr(1))]);
  }
  const std::vector<Transform> frames = tool::frames_of(model, variables);
  std::vector<Transform> wanted(1);
  double worst = 0;
  for (std::size_t i = 0; i <= joints.size(); ++i) {
    if (i != 0) {
      const PlainJoint& joint = joints[i - 1];
      wanted.push_back(
          composed(wanted[joint.parent], joint.at(joint.coordinate(joints, values, i - 1))));
    }
    const tool::ModelLink& link = model.links[i];
    const Transform frame = link.joint == tool::kNoJoint ? Transform{} : frames[link.joint];
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vector3 own = {corner & 1 ? 0.5 : -0.5, corner & 2 ? 1.0 : -1.0,
                           corner & 4 ? 1.5 : -1.5};
      const Transform box = origin_of(corners[i], {0.3, -2, 1});
      worst = std::max(worst, squared(minus(placed(frame, link.mesh.vertices[corner]),
                                            placed(composed(wanted[i], box), own))));
    }
  }
  CHECK(std::sqrt(worst) < 1e-12);
}

}  // namespace

TEST_CASE("frames turned to z put each point where the URDF's own axes do") {
  RobotFiles files;
  for_rounds(60, [&](Random& random, int) {
    const std::vector<PlainJoint> joints = random_joints(random, 1 + random.below(9));
    std::vector<Vector3> corners;
    for (std::size_t i = 0; i <= joints.size(); ++i) {
      corners.push_back(any_vector(random, 1));
    }
    const tool::Model model = files.read(urdf_of(joints, corners));
    REQUIRE(model.links.size() == corners.size());
    for (int i = 0; i < 20; ++i) {
      check_at(model, joints, corners, random);
    }
  });
}

TEST_CASE("turning an axis of the frame to z moves no entry off 0, 1 and -1") {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      Vector3 wanted{};
      wanted[axis] = sign;
      const Transform turned = tool::rotation_to(wanted);
      CHECK(placed(turned, {0, 0, 1}) == wanted);
      for (const auto& row : turned.rotation) {
        CHECK(std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]) == 1);
      }
      const auto& r = turned.rotation;
      CHECK(dot(r[0], cross(r[1], r[2])) == 1);
    }
  }
  CHECK(tool::rotation_to({0, 0, 1}).rotation == Transform{}.rotation);
}
