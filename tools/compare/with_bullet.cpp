#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>

#include "bullet_mesh.hpp"
#include "comparison.hpp"

using flashbvh::Mesh;

namespace compare {
namespace {

/// Bullet reports each contact point of two triangles; this counts each pair once.
class Contacts : public btManifoldResult {
 public:
  using btManifoldResult::btManifoldResult;

  void addContactPoint(const btVector3& /*normal*/, const btVector3& /*point*/,
                       btScalar /*depth*/) override {
    const std::pair<int, int> pair(m_index0, m_index1);
    if (pairs.empty() || pairs.back() != pair) {
      pairs.push_back(pair);
    }
  }

  std::vector<std::pair<int, int>> pairs;
};

/// A mesh's shape as a body of a world.
class Body {
 public:
  explicit Body(const Mesh& mesh) : mesh_(mesh), shape_(&mesh_.array()) {
    shape_.setMargin(0);
    shape_.updateBound();
    object_.setCollisionShape(&shape_);
  }

  void set_pose(const btTransform& pose) { object_.setWorldTransform(pose); }
  btCollisionObjectWrapper wrapped() const {
    return {nullptr, &shape_, &object_, object_.getWorldTransform(), -1, -1};
  }

 private:
  BulletMesh mesh_;
  btGImpactMeshShape shape_;
  btCollisionObject object_;
};

class Bullet : public Collider {
 public:
  Bullet(const Mesh& a, const Mesh& b)
      : mesh_a_(&a),
        mesh_b_(&b),
        configuration_(few()),
        dispatcher_(&configuration_),
        a_(a),
        b_(b) {
    btCollisionAlgorithmConstructionInfo info(&dispatcher_, 0);
    const btCollisionObjectWrapper wrapped_a = a_.wrapped();
    const btCollisionObjectWrapper wrapped_b = b_.wrapped();
    algorithm_ = std::make_unique<btGImpactCollisionAlgorithm>(info, &wrapped_a, &wrapped_b);
  }

  void set_poses(const std::vector<Placed>& poses) override {
    poses_ = converted(poses, transform_of);
  }

  /// Finds all pairs even if only the first is wanted: Bullet does not stop at a hit.
  std::size_t query_all(Wanted /*wanted*/) override {
    std::size_t count = 0;
    for (const btTransform& pose : poses_) {
      query(pose);
      count += contacts_.pairs.size();
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    query(poses_[pose]);
    std::vector<Pair> all;
    for (const auto& [a, b] : contacts_.pairs) {
      all.emplace_back(mesh_a_->triangle_ids[a], mesh_b_->triangle_ids[b]);
    }
    return all;
  }

 private:
  /// Small pools: Bullet's defaults are for thousands of bodies, here there are two.
  static btDefaultCollisionConstructionInfo few() {
    btDefaultCollisionConstructionInfo info;
    info.m_defaultMaxPersistentManifoldPoolSize = 16;
    info.m_defaultMaxCollisionAlgorithmPoolSize = 16;
    return info;
  }

  void query(const btTransform& pose) {
    b_.set_pose(pose);
    const btCollisionObjectWrapper wrapped_a = a_.wrapped();
    const btCollisionObjectWrapper wrapped_b = b_.wrapped();
    contacts_.pairs.clear();
    contacts_.setBody0Wrap(&wrapped_a);
    contacts_.setBody1Wrap(&wrapped_b);
    algorithm_->processCollision(&wrapped_a, &wrapped_b, btDispatcherInfo(), &contacts_);
  }

  const Mesh* mesh_a_;
  const Mesh* mesh_b_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  Body a_;
  Body b_;
  std::unique_ptr<btGImpactCollisionAlgorithm> algorithm_;
  Contacts contacts_;
  std::vector<btTransform> poses_;
};

class BulletRayCaster : public RayCaster {
 public:
  explicit BulletRayCaster(const Mesh& mesh)
      : mesh_(mesh), shape_(&mesh_.array(), /*useQuantizedAabbCompression=*/true) {}

  double nearest(const flashbvh::Segment& segment) override {
    const btVector3 from = in_units<btVector3>(segment.from);
    const btVector3 to = in_units<btVector3>(segment.to);
    Nearest nearest(from, to);
    shape_.performRaycast(&nearest, from, to);
    return nearest.share;
  }

 private:
  struct Nearest : btTriangleRaycastCallback {
    using btTriangleRaycastCallback::btTriangleRaycastCallback;
    btScalar reportHit(const btVector3& /*normal*/, btScalar fraction, int /*part*/,
                       int /*triangle*/) override {
      share = fraction;  // nearer than all earlier hits
      return fraction;
    }
    double share = kNoHit;
  };

  BulletMesh mesh_;
  btBvhTriangleMeshShape shape_;
};

}  // namespace

std::unique_ptr<Collider> with_bullet(const Mesh& a, const Mesh& b) {
  return std::make_unique<Bullet>(a, b);
}

std::unique_ptr<RayCaster> ray_caster_of_bullet(const Mesh& mesh) {
  return std::make_unique<BulletRayCaster>(mesh);
}

}  // namespace compare
