// The baked objects of the setups, each made once.
#ifndef FLASHBVH_TOOLS_EVALUATE_OBJECTS_HPP
#define FLASHBVH_TOOLS_EVALUATE_OBJECTS_HPP

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "bake/baked_tree.hpp"
#include "evaluate/paper_object.hpp"

namespace flashbvh::tool {

/// One tree in both layouts.
template <class Index>
struct BothLayouts {
  bake::BakedTree<Index, Layout::pre_indexed> pre;
  bake::BakedTree<Index, Layout::post_indexed> post;

  template <Layout layout>
  const bake::BakedTree<Index, layout>& in() const {
    if constexpr (layout == Layout::pre_indexed) {
      return pre;
    } else {
      return post;
    }
  }
};

/// The paper's tree over one object, split at the median, a triangle a leaf; and that of `flashbvh
/// bake` with a triangle a leaf, too.
class BakedObject {
 public:
  explicit BakedObject(const scene::PaperObject& object);

  const scene::PaperObject& object() const { return object_; }
  const bake::BuildTree& tree() const { return tree_; }
  /// What `flashbvh bake` builds without options. Built on first use.
  const bake::BuildTree& default_tree();
  /// The same, laid out on first use.
  const bake::BakedTree<std::uint32_t, Layout::post_indexed>& baked_default();
  bool fits_16_bits() const { return bake::fits_index<std::uint16_t>(tree_, mesh_); }

  /// Laid out on first use. Index: 16 bits only if they fit.
  template <class Index>
  const BothLayouts<Index>& baked();

 private:
  scene::PaperObject object_;
  bake::LatticeMesh mesh_;
  bake::BuildTree tree_;
  std::optional<BothLayouts<std::uint16_t>> narrow_;
  std::optional<BothLayouts<std::uint32_t>> wide_;
  std::optional<bake::BuildTree> default_tree_;
  std::optional<bake::BakedTree<std::uint32_t, Layout::post_indexed>> baked_default_;
};

template <>
const BothLayouts<std::uint16_t>& BakedObject::baked();
template <>
const BothLayouts<std::uint32_t>& BakedObject::baked();

class Objects {
 public:
  /// The reference stays good as long as this.
  BakedObject& get(const scene::PaperObject& object);

 private:
  std::vector<std::unique_ptr<BakedObject>> objects_;
};

}  // namespace flashbvh::tool

#endif
