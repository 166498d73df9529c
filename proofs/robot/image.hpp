// A baked robot by lib/docs/format.md, read by a program that shares no line with the library or
// the baker.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry.hpp"

namespace robot_check {

/// The file is not a robot's image, or damaged; the message gives the error and its place.
struct BadImage : std::runtime_error {
  using runtime_error::runtime_error;
};

constexpr std::uint32_t kBase = 255;

enum class Type : std::uint8_t { revolute, continuous, prismatic };

struct Joint {
  std::string name;
  std::int32_t rotation[3][3];
  std::int32_t translation[3];
  std::int32_t lower, upper, multiplier, offset;
  std::uint32_t shift, parent, variable, type, zeros;
  Frame fixed;  ///< made orthogonal

  bool slides() const { return type == static_cast<std::uint32_t>(Type::prismatic); }
  bool is_free() const { return type == static_cast<std::uint32_t>(Type::continuous); }
  /// A unit of its coordinate: radians, or cells.
  double unit() const { return slides() ? 1.0 / 2048 : 2 * M_PI / (1 << 28); }
  Frame moved(double coordinate) const {
    return fixed * (slides() ? slide(coordinate) : turn(coordinate));
  }
};

struct Mesh {
  std::uint32_t flags, unit, node_count, leaf_count;
  std::int32_t origin[3];
  std::uint64_t cell_bits;
  double deviation;                 ///< in the unit
  std::vector<std::uint8_t> nodes;  ///< 16 bytes each
  std::vector<std::array<std::uint16_t, 3>> corners;
  std::vector<std::uint32_t> leaf_offsets;           ///< leaf_count + 1
  std::vector<std::array<std::int32_t, 3>> lattice;  ///< vertices, without the origin
  std::vector<Vec> vertices;                         ///< in the joint's frame

  Triangle triangle(std::size_t i) const {
    return {vertices[corners[i][0]], vertices[corners[i][1]], vertices[corners[i][2]]};
  }
};

struct Link {
  std::string name;
  std::int32_t centre[3];
  std::uint32_t radius, first_reach, joint, zero, deviation;
  Mesh mesh;
};

struct Pair {
  std::uint32_t stop, warn, reach, a, b, joints_a, joints_b;
};

struct Unguarded {
  std::uint32_t a, b, why, joint, radius;
};

struct Robot {
  std::string name;
  double cell;  ///< metres
  std::uint64_t cell_bits;
  std::uint32_t slack, variable_count, pair_joint_count;
  std::vector<Joint> joints;
  std::vector<Link> links;
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> reaches;
  std::vector<Unguarded> unguarded;
  std::vector<std::uint8_t> tables;

  /// Joints from the link's own to the base.
  std::vector<std::uint32_t> branch(std::uint32_t link) const;
  /// Joints of a's branch alone, and of b's alone, each from its link inwards.
  struct Between {
    std::vector<std::uint32_t> a, b;
  };
  Between between(std::uint32_t a, std::uint32_t b) const;
  std::string joint_name(std::uint32_t joint) const;
  /// The link's name, with a number for a part of a link.
  std::string link_name(std::uint32_t link) const;
  std::string pair_name(std::uint32_t a, std::uint32_t b) const;
  /// The joint whose coordinate is the variable's value.
  const Joint& master(std::uint32_t variable) const;
  /// The link of which this one is a part, or itself.
  std::uint32_t whole_of(std::uint32_t link) const;
};

/// Checks sizes, both kinds of checksum and the hash. Throws BadImage.
Robot read_robot(const std::string& bytes);

}  // namespace robot_check
