#include "bake/image_bytes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "bake/quantise.hpp"
#include "flashbvh/image.hpp"

namespace flashbvh::bake {
namespace {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "images are written as memory lies");

template <class Index, Layout layout>
ImageHeader header_of(const BakedTree<Index, layout>& baked, bool levels) {
  ImageHeader header{};
  header.magic = kImageMagic;
  header.version = kImageVersion;
  header.layout = static_cast<std::uint8_t>(layout);
  header.index_bits = 8 * sizeof(Index);
  header.node_count = static_cast<std::uint32_t>(baked.nodes.size());
  header.leaf_count = baked.leaf_count;
  header.triangle_count = static_cast<std::uint32_t>(baked.triangles.size());
  header.vertex_count = static_cast<std::uint32_t>(baked.vertices.size());
  header.depth = baked.depth;
  header.stack_need = baked.stack_need;
  header.leaf_size = static_cast<std::uint8_t>(baked.leaf_size);
  header.name_size = static_cast<std::uint8_t>(baked.name.size());
  header.arity = static_cast<std::uint16_t>(std::min(baked.arity, std::uint32_t{0xFFFF}));
  std::copy(baked.origin.begin(), baked.origin.end(), header.origin);
  std::memcpy(header.cell, &baked.cell, sizeof header.cell);
  const float deviation = float_above(baked.deviation);
  std::memcpy(&header.deviation, &deviation, sizeof header.deviation);
  header.deviation_sixteenths = sixteenths_above(baked.deviation, baked.cell);
  header.shell_count = static_cast<std::uint32_t>(baked.shell_vertices.size());
  header.longest_edge = baked.longest_edge;
  header.unit = static_cast<std::uint8_t>(baked.unit);
  levels = levels || layout == Layout::pre_indexed;
  header.flags = static_cast<std::uint8_t>((levels ? kImageHasLevels : 0) |
                                           (baked.is_closed ? kImageIsClosed : 0) |
                                           (baked.slabs.empty() ? 0 : kImageHasSlabs));
  return header;
}

template <class Element>
void put(unsigned char* bytes, std::uint64_t offset, const std::vector<Element>& elements) {
  if (!elements.empty()) {
    std::memcpy(bytes + offset, elements.data(), sizeof(Element) * elements.size());
  }
}

}  // namespace

template <class Index, Layout layout>
std::uint64_t image_size(const BakedTree<Index, layout>& baked, bool levels) {
  return image_offsets(header_of(baked, levels)).end;
}

template <class Index, Layout layout>
std::vector<std::uint32_t> image_of(const BakedTree<Index, layout>& baked, bool levels) {
  ImageHeader header = header_of(baked, levels);
  const ImageOffsets at = image_offsets(header);
  header.byte_count = static_cast<std::uint32_t>(at.end);
  const auto size = static_cast<std::size_t>(at.end);
  std::vector<std::uint32_t> words(size / sizeof(std::uint32_t));
  auto* const bytes = reinterpret_cast<unsigned char*>(words.data());
  std::memcpy(bytes, &header, sizeof header);
  put(bytes, at.nodes, baked.nodes);
  if ((header.flags & kImageHasLevels) != 0) {
    put(bytes, at.levels, baked.levels);
    put(bytes, at.climb, baked.climb);
  }
  put(bytes, at.triangles, baked.triangles);
  put(bytes, at.triangle_ids, baked.triangle_ids);
  put(bytes, at.leaf_offsets, baked.leaf_offsets);
  put(bytes, at.slabs, baked.slabs);
  put(bytes, at.vertices, baked.vertices);
  put(bytes, at.shell_vertices, baked.shell_vertices);
  std::copy(baked.name.begin(), baked.name.end(), bytes + at.name);
  header.crc = image_crc(bytes, size);
  std::memcpy(bytes + offsetof(ImageHeader, crc), &header.crc, sizeof header.crc);
  return words;
}

#define FLASHBVH_KIND(Index, layout)                                        \
  template std::uint64_t image_size(const BakedTree<Index, layout>&, bool); \
  template std::vector<std::uint32_t> image_of(const BakedTree<Index, layout>&, bool);
FLASHBVH_FOR_EACH_KIND(FLASHBVH_KIND)
#undef FLASHBVH_KIND

}  // namespace flashbvh::bake
