// Queries of one image, in the layout that the firmware's queries take.
#ifndef FLASHBVH_TOOLS_CLI_POST_MESH_HPP
#define FLASHBVH_TOOLS_CLI_POST_MESH_HPP

#include <type_traits>
#include <variant>

#include "image/image_file.hpp"
#include "text/messages.hpp"

namespace flashbvh::tool {

/// query(mesh), whatever the width of the indices. UserError if the image is pre-indexed.
template <class Answer, class Query>
Answer query_post_mesh(const ImageFile& image, const Query& query) {
  return std::visit(
      [&](const auto& tree) -> Answer {
        using Tree = std::decay_t<decltype(tree)>;
        if constexpr (Tree::kLayout == Layout::post_indexed) {
          using Plain = BasicMesh<typename Tree::Index, Layout::post_indexed>;
          return query(static_cast<const Plain&>(tree));
        } else {
          throw UserError(image.path(),
                          "is pre-indexed, which this question does not take; bake it with "
                          "--layout post");
        }
      },
      image.tree());
}

}  // namespace flashbvh::tool

#endif
