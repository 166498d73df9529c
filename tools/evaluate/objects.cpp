#include "evaluate/objects.hpp"

namespace flashbvh::tool {
namespace {

template <class Index>
const BothLayouts<Index>& made(std::optional<BothLayouts<Index>>& baked,
                               const bake::BuildTree& tree, const bake::LatticeMesh& mesh) {
  if (!baked) {
    baked.emplace(BothLayouts<Index>{bake::lay_out<Index, Layout::pre_indexed>(tree, mesh),
                                     bake::lay_out<Index, Layout::post_indexed>(tree, mesh)});
  }
  return *baked;
}

}  // namespace

BakedObject::BakedObject(const scene::PaperObject& object)
    : object_(object), mesh_(make_mesh(object)), tree_(bake::build_median(mesh_, 1)) {}

const bake::BuildTree& BakedObject::default_tree() {
  if (!default_tree_) {
    default_tree_ = bake::build_default(mesh_, 1);
  }
  return *default_tree_;
}

const bake::BakedTree<std::uint32_t, Layout::post_indexed>& BakedObject::baked_default() {
  if (!baked_default_) {
    baked_default_ = bake::lay_out<std::uint32_t, Layout::post_indexed>(default_tree(), mesh_);
  }
  return *baked_default_;
}

template <>
const BothLayouts<std::uint16_t>& BakedObject::baked() {
  return made(narrow_, tree_, mesh_);
}

template <>
const BothLayouts<std::uint32_t>& BakedObject::baked() {
  return made(wide_, tree_, mesh_);
}

BakedObject& Objects::get(const scene::PaperObject& object) {
  for (const auto& known : objects_) {
    if (known->object() == object) {
      return *known;
    }
  }
  objects_.push_back(std::make_unique<BakedObject>(object));
  return *objects_.back();
}

}  // namespace flashbvh::tool
