#include "robot/reaches.hpp"

#include "robot/support.hpp"

namespace flashbvh::tool {
namespace {

/// From body to body over the joints, with what the link sweeps on the way. A body is what hangs on
/// a joint, in the joint's frame, or the base.
class Spread {
 public:
  explicit Spread(const Model& model) : model_(model), reaches_(model.joints.size()) {}

  /// `from`: the joint that it came over, or none.
  void visit(std::size_t body, std::size_t from, const Support& support) {
    if (body != kNoJoint && body != from) {
      const Support swept = cross(body, support, false);
      visit(model_.joints[body].parent, body, swept.moved(model_.joints[body].fixed));
    }
    for (std::size_t child = 0; child < model_.joints.size(); ++child) {
      if (model_.joints[child].parent == body && child != from) {
        const Support seen = support.moved(inverse(model_.joints[child].fixed));
        visit(child, child, cross(child, seen, true));
      }
    }
  }

  const std::vector<double>& reaches() const { return reaches_; }

 private:
  /// `support` in the joint's frame, on the one side and the other. Outward: from the parent's
  /// side, where what lies still moves backwards.
  Support cross(std::size_t number, const Support& support, bool outward) {
    const bool slides = model_.joints[number].type == JointType::prismatic;
    reaches_[number] = slides ? 1 : support.reach();
    Interval range = range_of_joint(model_, number);
    if (outward) {
      range = {-range.upper, -range.lower};
    }
    return slides ? support.slid(range) : support.turned(range);
  }

  const Model& model_;
  std::vector<double> reaches_;
};

}  // namespace

std::vector<double> reaches_of(const Model& model, std::size_t link, double cell) {
  Spread spread(model);
  const ModelLink& of = model.links[link];
  spread.visit(of.joint, kNoJoint, Support(of.mesh.vertices, kDeviation * cell));
  return spread.reaches();
}

}  // namespace flashbvh::tool
