#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>

#include <limits>

#include "contender.hpp"
#include "meshes.hpp"

using flashbvh::PostMesh;

namespace compare {
namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

/// Its triangles in the order of the baked mesh.
std::shared_ptr<Model> model_of(const PostMesh& mesh) {
  std::vector<fcl::Vector3d> vertices;
  for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
    double point[3];
    set_vertex(mesh, i, point);
    vertices.emplace_back(point[0], point[1], point[2]);
  }
  std::vector<fcl::Triangle> triangles;
  for (std::uint32_t i = 0; i < mesh.triangle_count; ++i) {
    const auto& corner = mesh.triangles[i].corner;
    triangles.emplace_back(corner[0], corner[1], corner[2]);
  }
  auto model = std::make_shared<Model>();
  model->beginModel();
  model->addSubModel(vertices, triangles);
  model->endModel();
  return model;
}

class Fcl : public Contender {
 public:
  Fcl(const PostMesh& a, const PostMesh& b)
      : mesh_a_(&a), mesh_b_(&b), a_(model_of(a)), b_(model_of(b)) {}

  void set_poses(const std::vector<Placed>& poses) override {
    poses_.clear();
    for (const Placed& placed : poses) {
      fcl::Transform3d transform = fcl::Transform3d::Identity();
      for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
          transform.linear()(row, column) = rotation_of(placed.pose, row, column);
        }
        transform.translation()[row] = translation_of(placed.pose, row);
      }
      poses_.push_back(transform);
    }
  }

  std::size_t ask_all(Wanted wanted) override {
    std::size_t count = 0;
    for (const fcl::Transform3d& pose : poses_) {
      count += ask(pose, wanted);
    }
    return count;
  }

  std::vector<Pair> pairs(std::size_t pose) override {
    std::vector<Pair> all;
    for (std::size_t i = 0, count = ask(poses_[pose], Wanted::all); i < count; ++i) {
      const fcl::Contactd& contact = result_.getContact(i);
      all.emplace_back(mesh_a_->triangle_ids[contact.b1], mesh_b_->triangle_ids[contact.b2]);
    }
    return all;
  }

 private:
  std::size_t ask(const fcl::Transform3d& pose, Wanted wanted) {
    const fcl::CollisionRequestd request(
        wanted == Wanted::first ? 1 : std::numeric_limits<std::size_t>::max());
    result_.clear();
    fcl::collide(a_.get(), fcl::Transform3d::Identity(), b_.get(), pose, request, result_);
    return result_.numContacts();
  }

  const PostMesh* mesh_a_;
  const PostMesh* mesh_b_;
  std::shared_ptr<Model> a_;
  std::shared_ptr<Model> b_;
  std::vector<fcl::Transform3d, Eigen::aligned_allocator<fcl::Transform3d>> poses_;
  fcl::CollisionResultd result_;
};

}  // namespace

std::unique_ptr<Contender> with_fcl(const PostMesh& a, const PostMesh& b) {
  return std::make_unique<Fcl>(a, b);
}

}  // namespace compare
