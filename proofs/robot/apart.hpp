// Whether two links stay apart for all values of the joints in between. A box of joint values is
// halved until, for each pair of nodes, the gap of two parts of the links at the middle of the box
// exceeds the motion of these parts in the box.
#pragma once

#include <chrono>
#include <functional>
#include <string>

#include "body.hpp"
#include "image.hpp"

namespace robot_check {

/// The error of doubles, in cells: coordinates below 2^22 cells have 30 fraction bits.
constexpr double kOutward = 1e-6;

using Moment = std::chrono::steady_clock::time_point;

/// The range of a variable that moves the two links against each other: radians or cells.
struct Range {
  double lower, upper;
};

using Box = std::vector<Range>;

enum class Found { apart, near, undecided };

struct Answer {
  Found found = Found::apart;
  std::vector<double> at;     ///< values at which they are near, or may be
  double nearest = HUGE_VAL;  ///< the least distance of two measured triangles, in cells
  std::size_t boxes = 0;
};

class PairSpace {
 public:
  PairSpace(const Robot& robot, std::uint32_t a, const Body& body_a, std::uint32_t b,
            const Body& body_b);

  /// The variables of the joints in between, a's own first.
  const std::vector<std::uint32_t>& variables() const { return variables_; }
  /// The variables' limits, enlarged by a unit on each side; one turn for a joint without limits.
  Box limits() const;
  /// Text like "elbow 0.51, wrist -1.2".
  std::string text(const std::vector<double>& at) const;

  /// Proves that they are more than `need` cells apart in the box. The answer is `near` if they are
  /// at most `refuse` cells apart in the middle of a part. Boxes for which `excused` returns true
  /// need no proof.
  Answer prove(const Box& box, double need, double refuse, std::size_t most_boxes,
               const std::function<bool(const Box&)>& excused = {});
  /// Values with a common point of both links, by descent from `starts` places; empty if not found.
  std::vector<double> find_contact(int starts);
  /// Whether some triangles less than `near` apart are proven to stay less than `most` apart in the
  /// box. False proves nothing.
  bool is_within(const Box& box, double near, double most);
  /// Ends all proofs and searches at this moment.
  void end_at(Moment end) { end_ = end; }
  /// The frame of b in a's frame, in the middle of the box.
  const Frame& frame_at(const Box& box);

 private:
  bool is_late() const { return std::chrono::steady_clock::now() >= end_; }
  struct PathJoint {
    const Joint* joint;
    std::size_t dimension;
    double scale, offset;  ///< its coordinate by the variable's value
    Vec origin, axis;      ///< in a's frame, in the middle of the box
    double travel;         ///< of a point at distance 1 from the axis, or of any point if it slides
    double distance(const Vec& point) const;
    double moves(const Vec& point, double radius) const;
  };
  struct Placed {
    std::size_t box = 0;  ///< the box of the other fields
    Vec centre, half;     ///< of the node's box, in a's frame
    double moved;
  };
  struct Near {
    std::uint32_t a, b;  ///< nodes
    double distance, moved;
  };

  void add_path(const Robot& robot, std::uint32_t a, std::uint32_t b);
  void place(const Box& box);
  void choose_side();
  const Placed& placed_a(std::uint32_t node);
  const Placed& placed_b(std::uint32_t node);
  double moved(const Vec& centre, double radius, bool of_a) const;
  double moved(const Triangle& triangle, bool of_a) const;
  Triangle triangle_b(std::uint32_t node) const;
  double gap(std::uint32_t a, std::uint32_t b);
  bool are_apart(std::uint32_t a, std::uint32_t b, double need);
  bool leaves_apart(std::uint32_t a, std::uint32_t b, double need);
  double distance_at(const std::vector<double>& at);
  std::size_t widest(std::size_t dimensions) const;

  const Robot& robot_;
  const Body& a_;
  const Body& b_;
  std::vector<PathJoint> path_;  ///< from a to b
  std::size_t own_ = 0;          ///< the number of joints on a's branch
  std::size_t cut_ = 0;          ///< joints before it move a, the others b
  std::vector<std::uint32_t> variables_;
  Frame frame_;  ///< b's in a's
  std::size_t stamp_ = 0;
  std::vector<Placed> placed_a_, placed_b_;
  Near near_{};
  double nearest_ = HUGE_VAL;
  Moment end_ = Moment::max();
};

}  // namespace robot_check
