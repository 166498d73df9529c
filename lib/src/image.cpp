#include "flashbvh/image.hpp"

#include <string.h>

namespace flashbvh {
namespace {

constexpr size_t kCrcOffset = offsetof(ImageHeader, crc);
constexpr size_t kCrcEnd = kCrcOffset + sizeof(uint32_t);
static_assert(offsetof(ImageHeader, byte_count) == 8 && kCrcOffset == 12, "the format's header");

constexpr uint64_t aligned(uint64_t offset) {
  return (offset + 3) & ~uint64_t{3};
}

/// A positive, finite, normal binary64.
bool is_length(const uint32_t (&bits)[2]) {
  const uint32_t exponent = bits[1] >> 20;  // with the sign, which must be 0
  return exponent != 0 && exponent < 0x7FF;
}

template <class Index>
bool counts_fit(const ImageHeader& header) {
  constexpr uint32_t most = static_cast<Index>(~Index{0});
  return header.node_count >= 1 && header.leaf_count >= 1 && header.vertex_count >= 1 &&
         header.node_count <= most && header.leaf_count <= most / 2 + 1 &&
         header.leaf_count <= header.node_count && header.leaf_count <= header.triangle_count &&
         header.triangle_count <= most && header.vertex_count <= most && header.stack_need <= most;
}

template <class Element>
const Element* at(const void* bytes, uint64_t offset) {
  return reinterpret_cast<const Element*>(static_cast<const unsigned char*>(bytes) + offset);
}

template <class Index>
void set_climb(LevelledTree<Index, Layout::pre_indexed>& tree, const Index* climb) {
  tree.parents = climb;
}
template <class Index>
void set_climb(LevelledTree<Index, Layout::post_indexed>& tree, const Index* climb) {
  tree.right_child_levels = climb;
}

template <class TreeType>
TreeType view(const void* bytes, const ImageHeader& header) {
  using Index = typename TreeType::Index;
  const ImageOffsets offsets = image_offsets(header);
  TreeType tree{};
  tree.nodes = at<Node<Index>>(bytes, offsets.nodes);
  tree.triangles = at<Corners<Index>>(bytes, offsets.triangles);
  tree.sources = at<Index>(bytes, offsets.sources);
  tree.leaf_firsts =
      header.leaf_count == header.triangle_count ? nullptr : at<Index>(bytes, offsets.leaf_firsts);
  tree.vertices = at<Vertex>(bytes, offsets.vertices);
  tree.node_count = static_cast<Index>(header.node_count);
  tree.leaf_count = static_cast<Index>(header.leaf_count);
  tree.triangle_count = static_cast<Index>(header.triangle_count);
  tree.vertex_count = static_cast<Index>(header.vertex_count);
  tree.stack_need = static_cast<Index>(header.stack_need);
  memcpy(tree.origin, header.origin, sizeof tree.origin);
  tree.cell_bits = (uint64_t{header.cell[1]} << 32) | header.cell[0];
  tree.levels = at<Index>(bytes, offsets.levels);
  set_climb(tree, at<Index>(bytes, offsets.climb));
  return tree;
}

}  // namespace

ImageOffsets image_offsets(const ImageHeader& header) {
  const uint64_t index = header.index_bits / 8u;
  const uint64_t nodes = header.node_count;
  const uint64_t triangles = header.triangle_count;
  const uint64_t firsts = header.leaf_count == triangles ? 0 : uint64_t{header.leaf_count} + 1;
  ImageOffsets at;
  at.nodes = sizeof(ImageHeader);
  at.levels = at.nodes + nodes * (sizeof(PackedBox) + 2 * index);
  at.climb = aligned(at.levels + nodes * index);
  at.triangles = aligned(at.climb + nodes * index);
  at.sources = aligned(at.triangles + triangles * 3 * index);
  at.leaf_firsts = aligned(at.sources + triangles * index);
  at.vertices = aligned(at.leaf_firsts + firsts * index);
  at.end = aligned(at.vertices + uint64_t{header.vertex_count} * sizeof(Vertex));
  return at;
}

uint32_t crc32(const void* bytes, size_t size, uint32_t crc) {
  const unsigned char* byte = static_cast<const unsigned char*>(bytes);
  crc = ~crc;
  for (size_t i = 0; i < size; ++i) {
    crc ^= byte[i];
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ (0xEDB88320u & (0u - (crc & 1u)));
    }
  }
  return ~crc;
}

uint32_t image_crc(const void* bytes, size_t size) {
  const unsigned char* byte = static_cast<const unsigned char*>(bytes);
  return crc32(byte + kCrcEnd, size - kCrcEnd, crc32(byte, kCrcOffset));
}

Status read_image_header(const void* bytes, size_t size, ImageHeader& header) {
  uint32_t magic = 0;
  if (size < sizeof magic) {
    return Status::image_truncated;
  }
  memcpy(&magic, bytes, sizeof magic);
  if (magic != kImageMagic) {
    return Status::image_not_flashbvh;
  }
  if (size < sizeof header) {
    return Status::image_truncated;
  }
  memcpy(&header, bytes, sizeof header);
  if (header.version != kImageVersion) {
    return Status::image_version;
  }
  return header.byte_count > size ? Status::image_truncated : Status::done;
}

template <class TreeType>
Status open_image(const void* bytes, size_t size, TreeType& tree) {
  using Index = typename TreeType::Index;
  ImageHeader header;
  if (reinterpret_cast<uintptr_t>(bytes) % 4 != 0) {
    return Status::image_misaligned;
  }
  const Status read = read_image_header(bytes, size, header);
  if (read != Status::done) {
    return read;
  }
  if (header.byte_count < sizeof header || image_crc(bytes, header.byte_count) != header.crc) {
    return Status::image_corrupt;
  }
  if (header.layout > static_cast<uint8_t>(Layout::post_indexed) ||
      (header.index_bits != 16 && header.index_bits != 32)) {
    return Status::image_invalid;
  }
  if (header.layout != static_cast<uint8_t>(TreeType::kLayout) ||
      header.index_bits != 8 * sizeof(Index)) {
    return Status::image_kind;
  }
  if (!counts_fit<Index>(header) || !is_length(header.cell) ||
      image_offsets(header).end != header.byte_count) {
    return Status::image_invalid;
  }
  const TreeType opened = view<TreeType>(bytes, header);
  const Status checked = check_tree(opened);
  if (checked == Status::done) {
    tree = opened;
  }
  return checked;
}

template Status open_image(const void*, size_t, LevelledPreTree&);
template Status open_image(const void*, size_t, LevelledPostTree&);
template Status open_image(const void*, size_t, LargeLevelledPreTree&);
template Status open_image(const void*, size_t, LargeLevelledPostTree&);

}  // namespace flashbvh
