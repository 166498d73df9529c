#include "flashbvh/image.hpp"

#include <string.h>

#include "flashbvh/detail/lattice/image_parts.hpp"

namespace flashbvh {

using namespace detail;

namespace {

constexpr size_t kCrcOffset = offsetof(ImageHeader, crc);
constexpr size_t kCrcEnd = kCrcOffset + sizeof(uint32_t);
static_assert(offsetof(ImageHeader, byte_count) == 8 && kCrcOffset == 12, "the format's header");

constexpr uint64_t aligned(uint64_t offset) {
  return (offset + 3) & ~uint64_t{3};
}

/// Tests for a positive, finite, normal binary64.
bool is_length(const uint32_t (&bits)[2]) {
  return bits[1] < 0x7FF00000u && bits[1] >= 0x00100000u;
}

/// -0 is no deviation, so that equal lengths have equal bits.
bool measures_fit(const ImageHeader& header) {
  for (const int32_t origin : header.origin) {
    if (origin < -kMaxOrigin || origin > kMaxOrigin) {
      return false;
    }
  }
  constexpr uint32_t infinity = 0x7F800000u;
  return is_length(header.cell) && header.deviation < infinity && header.padding == 0 &&
         header.unit < kUnitCount;
}

bool has_levels(const ImageHeader& header) {
  return (header.flags & kImageHasLevels) != 0;
}

bool flags_fit(const ImageHeader& header) {
  const bool pre = header.layout == static_cast<uint8_t>(Layout::pre_indexed);
  return (header.flags & ~(kImageHasLevels | kImageIsClosed | kImageHasSlabs)) == 0 &&
         (has_levels(header) || !pre);
}

/// Checks that counts fit the index type and that there is a root. The check of the tree proves the
/// format's other rules: there are leaves, triangles and vertices.
template <class Index>
bool counts_fit(const ImageHeader& header) {
  constexpr uint32_t most = static_cast<Index>(~Index{0});
  return header.node_count >= 1 && header.node_count <= most && header.leaf_count <= most &&
         header.triangle_count <= most && header.vertex_count <= most && header.shell_count <= most;
}

uint64_t level_count(const ImageHeader& header) {
  return has_levels(header) ? header.node_count : 0;
}

/// Number of leaf offsets; 0 if each leaf has one triangle.
uint64_t leaf_offset_count(const ImageHeader& header) {
  return header.leaf_count == header.triangle_count ? 0 : uint64_t{header.leaf_count} + 1;
}

uint64_t slab_count(const ImageHeader& header) {
  return (header.flags & kImageHasSlabs) != 0 ? header.leaf_count : 0;
}

/// Returns whether the bytes from `begin` to the next multiple of 4 are zeros.
bool gap_is_zero(const void* bytes, uint64_t begin) {
  for (uint64_t i = begin; i < aligned(begin); ++i) {
    if (static_cast<const unsigned char*>(bytes)[i] != 0) {
      return false;
    }
  }
  return true;
}

[[gnu::noinline]] bool gaps_are_zeros(const void* bytes, const ImageHeader& header,
                                      const ImageOffsets& at) {
  const uint64_t index = header.index_bits / 8u;
  return gap_is_zero(bytes, at.levels + level_count(header) * index) &&
         gap_is_zero(bytes, at.climb + level_count(header) * index) &&
         gap_is_zero(bytes, at.triangles + header.triangle_count * (3 * index)) &&
         gap_is_zero(bytes, at.triangle_ids + header.triangle_count * index) &&
         gap_is_zero(bytes, at.leaf_offsets + leaf_offset_count(header) * index) &&
         gap_is_zero(bytes, at.vertices + header.vertex_count * uint64_t{sizeof(Vertex)}) &&
         gap_is_zero(bytes, at.shell_vertices + header.shell_count * index) &&
         gap_is_zero(bytes, at.name + header.name_size);
}

/// Returns whether no byte of a name is 0.
bool is_name(const unsigned char* name, unsigned size) {
  for (unsigned i = 0; i < size; ++i) {
    if (name[i] == 0) {
      return false;
    }
  }
  return true;
}

/// Checks the arrays' sizes against the header, the gaps and the name, but not the arrays' content.
[[gnu::noinline]] bool arrays_fit(const void* bytes, const ImageHeader& header) {
  const ImageOffsets at = image_offsets(header);
  return at.end == header.byte_count && gaps_are_zeros(bytes, header, at) &&
         is_name(static_cast<const unsigned char*>(bytes) + at.name, header.name_size);
}

bool has_shape(const ImageHeader& header, const TreeShape& shape) {
  const uint32_t arity = shape.arity < UINT16_MAX ? shape.arity : UINT16_MAX;
  return header.depth == shape.depth && header.stack_need == shape.stack_need &&
         header.leaf_size == shape.leaf_size && header.arity == arity &&
         header.longest_edge == shape.longest_edge &&
         ((header.flags & kImageIsClosed) != 0) == shape.is_closed;
}

template <class Index, Layout layout>
[[gnu::noinline]] void view(const void* bytes, const ImageHeader& header,
                            BasicMesh<Index, layout>& mesh) {
  const ImageOffsets offsets = image_offsets(header);
  mesh.nodes = image_part<Node<Index>>(bytes, offsets.nodes);
  mesh.triangles = image_part<Corners<Index>>(bytes, offsets.triangles);
  mesh.triangle_ids = image_part<Index>(bytes, offsets.triangle_ids);
  mesh.leaf_offsets =
      leaf_offset_count(header) == 0 ? nullptr : image_part<Index>(bytes, offsets.leaf_offsets);
  mesh.slabs = slab_count(header) == 0 ? nullptr : image_part<LeafSlabs>(bytes, offsets.slabs);
  mesh.vertices = image_part<Vertex>(bytes, offsets.vertices);
  mesh.shell_vertices = image_part<Index>(bytes, offsets.shell_vertices);
  mesh.node_count = static_cast<Index>(header.node_count);
  mesh.leaf_count = static_cast<Index>(header.leaf_count);
  mesh.triangle_count = static_cast<Index>(header.triangle_count);
  mesh.vertex_count = static_cast<Index>(header.vertex_count);
  mesh.shell_count = static_cast<Index>(header.shell_count);
  mesh.stack_need = static_cast<Index>(header.stack_need);
  mesh.longest_edge = header.longest_edge;
  memcpy(mesh.origin, header.origin, sizeof mesh.origin);
  mesh.unit = static_cast<Unit>(header.unit);
  mesh.is_closed = (header.flags & kImageIsClosed) != 0;
  mesh.deviation_sixteenths = header.deviation_sixteenths;
  mesh.cell_bits = (uint64_t{header.cell[1]} << 32) | header.cell[0];
}

/// Checks alignment and header. A function of its own, so that its copy is gone from the stack when
/// the tree is checked.
[[gnu::noinline]] Status check_readable(const void* bytes, size_t size) {
  ImageHeader copy;
  return reinterpret_cast<uintptr_t>(bytes) % 4 != 0 ? Status::image_misaligned
                                                     : read_image_header(bytes, size, copy);
}

template <class Index, Layout layout>
Status open_any(const void* bytes, size_t size, BasicMesh<Index, layout>& mesh) {
  const Status read = check_readable(bytes, size);
  if (read != Status::done) {
    return read;
  }
  const ImageHeader& header = *image_part<ImageHeader>(bytes, 0);
  if (header.byte_count < sizeof header || image_crc(bytes, header.byte_count) != header.crc) {
    return Status::image_corrupt;
  }
  if (header.layout > static_cast<uint8_t>(Layout::post_indexed) ||
      (header.index_bits != 16 && header.index_bits != 32)) {
    return Status::image_invalid;
  }
  if (header.layout != static_cast<uint8_t>(layout) || header.index_bits != 8 * sizeof(Index)) {
    return Status::image_kind;
  }
  if (!counts_fit<Index>(header) || !measures_fit(header) || !flags_fit(header) ||
      !arrays_fit(bytes, header)) {
    return Status::image_invalid;
  }
  view(bytes, header, mesh);
  TreeShape shape;
  return check_tree(mesh, image_levels<Index>(bytes), shape) == Status::done &&
                 has_shape(header, shape)
             ? Status::done
             : Status::image_invalid;
}

}  // namespace

namespace detail {

/// CRC remainder of each 4-bit value, with the reflected polynomial 0xEDB88320.
constexpr uint32_t kCrcOfNibble[16] = {
    0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
    0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
    0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu,
};

uint32_t crc32(const void* bytes, size_t size, uint32_t crc) {
  const unsigned char* byte = static_cast<const unsigned char*>(bytes);
  crc = ~crc;
  for (size_t i = 0; i < size; ++i) {
    crc ^= byte[i];
    crc = (crc >> 4) ^ kCrcOfNibble[crc & 15u];
    crc = (crc >> 4) ^ kCrcOfNibble[crc & 15u];
  }
  return ~crc;
}

}  // namespace detail

ImageOffsets image_offsets(const ImageHeader& header) {
  const uint64_t index = header.index_bits / 8u;
  const uint64_t triangles = header.triangle_count;
  ImageOffsets at;
  at.nodes = sizeof(ImageHeader);
  at.levels = at.nodes + uint64_t{header.node_count} * (sizeof(PackedBox) + 2 * index);
  at.climb = aligned(at.levels + level_count(header) * index);
  at.triangles = aligned(at.climb + level_count(header) * index);
  at.triangle_ids = aligned(at.triangles + triangles * 3 * index);
  at.leaf_offsets = aligned(at.triangle_ids + triangles * index);
  at.slabs = aligned(at.leaf_offsets + leaf_offset_count(header) * index);
  at.vertices = at.slabs + slab_count(header) * sizeof(LeafSlabs);
  at.shell_vertices = aligned(at.vertices + uint64_t{header.vertex_count} * sizeof(Vertex));
  at.name = aligned(at.shell_vertices + header.shell_count * index);
  at.end = aligned(at.name + header.name_size);
  return at;
}

namespace detail {

template <class Index>
[[gnu::noinline]] ImageLevels<Index> image_levels(const void* bytes) {
  const ImageHeader& header = *image_part<ImageHeader>(bytes, 0);
  if (!has_levels(header)) {
    return {nullptr, nullptr};
  }
  const ImageOffsets at = image_offsets(header);
  return {image_part<Index>(bytes, at.levels), image_part<Index>(bytes, at.climb)};
}

template ImageLevels<uint16_t> image_levels(const void*);
template ImageLevels<uint32_t> image_levels(const void*);

}  // namespace detail

uint32_t image_crc(const void* bytes, size_t size) {
  const unsigned char* byte = static_cast<const unsigned char*>(bytes);
  return detail::crc32(byte + kCrcEnd, size - kCrcEnd, detail::crc32(byte, kCrcOffset));
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

template <class MeshType>
Status open_image(const void* bytes, size_t size, MeshType& mesh) {
  const Status status = open_any(bytes, size, mesh);
  if (status != Status::done) {
    mesh = {};
  }
  return status;
}

template <class MeshType>
MeshType view_unchecked(const void* image) {
  MeshType mesh;
  view(image, *image_part<ImageHeader>(image, 0), mesh);
  return mesh;
}

template Status open_image(const void*, size_t, Mesh&);
template Status open_image(const void*, size_t, Mesh32&);
template Status open_image(const void*, size_t, PreMesh&);
template Status open_image(const void*, size_t, PreMesh32&);
template Mesh view_unchecked(const void*);
template Mesh32 view_unchecked(const void*);
template PreMesh view_unchecked(const void*);
template PreMesh32 view_unchecked(const void*);

}  // namespace flashbvh
