#include "robot/matrix/reaches.hpp"

#include "robot/matrix/support.hpp"

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
      reach(body, support);
      const std::size_t parent = model_.joints[body].parent;
      if (leads_on(parent, body)) {
        visit(parent, body, swept(body, support, false).moved(model_.joints[body].fixed));
      }
    }
    for (std::size_t child = 0; child < model_.joints.size(); ++child) {
      if (model_.joints[child].parent == body && child != from) {
        const Support seen = support.moved(inverse(model_.joints[child].fixed));
        reach(child, seen);
        if (leads_on(child, child)) {
          visit(child, child, swept(child, seen, true));
        }
      }
    }
  }

  const std::vector<double>& reaches() const { return reaches_; }

 private:
  /// Whether there is a joint at the body but the one that it was reached over.
  bool leads_on(std::size_t body, std::size_t from) const {
    const auto& joints = model_.joints;
    for (std::size_t child = 0; child < joints.size(); ++child) {
      if (joints[child].parent == body && child != from) {
        return true;
      }
    }
    return body != kNoJoint && body != from;
  }

  /// `support`: in the joint's frame.
  void reach(std::size_t number, const Support& support) {
    reaches_[number] = model_.joints[number].type == JointType::prismatic ? 1 : support.reach();
  }

  /// In the joint's frame, beyond it. Outward: from the parent's side, where what lies still moves
  /// backwards.
  Support swept(std::size_t number, const Support& support, bool outward) const {
    Interval range = range_of_joint(model_, number);
    if (outward) {
      range = {-range.upper, -range.lower};
    }
    return model_.joints[number].type == JointType::prismatic ? support.slid(range)
                                                              : support.turned(range);
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
