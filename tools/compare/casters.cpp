#include "opcode_model.hpp"
//
#include <cmath>

using flashbvh::PostMesh;

namespace compare {
namespace {

class FlashbvhCaster : public Caster {
 public:
  explicit FlashbvhCaster(const PostMesh& mesh) : mesh_(&mesh) {}

  double nearest(const flashbvh::Segment& segment) override {
    const auto answer = flashbvh::nearest_hit(*mesh_, segment);
    if (answer.status != flashbvh::Status::done) {
      throw std::runtime_error("flashbvh refused a ray");
    }
    const flashbvh::SegmentShare& along = answer.hit.along;
    return answer.yes ? static_cast<double>(along.above) / static_cast<double>(along.below)
                      : kNoHit;
  }

 private:
  const PostMesh* mesh_;
};

class OpcodeCaster : public Caster {
 public:
  explicit OpcodeCaster(const PostMesh& mesh) : model_(mesh) {
    collider_.SetClosestHit(true);
    collider_.SetCulling(false);
    collider_.SetTemporalCoherence(false);
    collider_.SetDestination(&faces_);
  }

  double nearest(const flashbvh::Segment& segment) override {
    const IceMaths::Point from = point_of(segment.from);
    IceMaths::Point way = point_of(segment.to) - from;
    const float length = way.Magnitude();
    way /= length;
    collider_.SetMaxDist(length);
    faces_.Reset();
    if (!collider_.Collide(IceMaths::Ray(from, way), model_.model())) {
      throw std::runtime_error("OPCODE refused a ray");
    }
    double nearest = kNoHit;
    for (udword i = 0; i < faces_.GetNbFaces(); ++i) {
      nearest = std::fmin(nearest, faces_.GetFaces()[i].mDistance / length);
    }
    return nearest;
  }

 private:
  static IceMaths::Point point_of(const flashbvh::Point& point) {
    const auto units = [](std::int32_t cells) { return static_cast<float>(cells / kCellsOfUnit); };
    return {units(point.x), units(point.y), units(point.z)};
  }

  OpcodeModel model_;
  Opcode::RayCollider collider_;
  Opcode::CollisionFaces faces_;
};

}  // namespace

std::unique_ptr<Caster> caster_of_flashbvh(const PostMesh& mesh) {
  return std::make_unique<FlashbvhCaster>(mesh);
}

std::unique_ptr<Caster> caster_of_opcode(const PostMesh& mesh) {
  return std::make_unique<OpcodeCaster>(mesh);
}

}  // namespace compare
