// The binary image: a baked mesh in one block of bytes, used in place in flash. A header, then the
// mesh's arrays; lib/docs/format.md has every bit.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "flashbvh/mesh.hpp"
#include "flashbvh/status.hpp"

namespace flashbvh {

constexpr uint32_t kImageMagic = 0x48564246u;  // "FBVH"
constexpr uint16_t kImageVersion = 4;

/// Largest magnitude of an origin, in cells. Rotations rotate origins too
/// (detail/bounds/rotated_transform.hpp).
constexpr int32_t kMaxOrigin = 1 << 29;
/// Most triangles in a leaf: it limits the cost of one visit, and a cursor counts the pairs of
/// triangles of two leaves in 16 bits.
constexpr uint32_t kMaxLeafSize = 255;

/// Bits of ImageHeader::flags.
constexpr uint8_t kImageHasLevels = 1;  ///< always set for a pre-indexed tree
constexpr uint8_t kImageIsClosed = 2;   ///< Mesh::is_closed
constexpr uint8_t kImageHasSlabs = 4;   ///< Mesh::slabs

/// The first 80 bytes of an image.
struct ImageHeader {
  uint32_t magic;
  uint16_t version;
  uint8_t layout;       ///< a value of enum Layout
  uint8_t index_bits;   ///< 16 or 32
  uint32_t byte_count;  ///< of the whole image
  uint32_t crc;         ///< CRC-32 (IEEE 802.3) of all bytes except these four
  uint32_t node_count;
  uint32_t leaf_count;
  uint32_t triangle_count;
  uint32_t vertex_count;
  uint32_t depth;       ///< of the deepest leaf; the root has depth 0
  uint32_t stack_need;  ///< Tree::stack_need
  uint8_t leaf_size;    ///< most triangles in a leaf
  uint8_t name_size;    ///< bytes of the source's name
  uint16_t arity;       ///< most children of a node; 65,535 means this many or more
  int32_t origin[3];    ///< in cells, within +-kMaxOrigin
  uint32_t cell[2];     ///< the cell in the unit: IEEE binary64, low word first
  /// Largest distance of a point of mesh or source from the other one, in the unit: IEEE binary32,
  /// rounded up. FLT_MAX also stands for more.
  uint32_t deviation;
  uint16_t deviation_sixteenths;  ///< Mesh::deviation_sixteenths, of `deviation`
  uint16_t padding;               ///< 0
  uint32_t shell_count;
  uint16_t longest_edge;  ///< Mesh::longest_edge
  uint8_t unit;           ///< a value of enum Unit
  uint8_t flags;          ///< kImageHasLevels, kImageIsClosed, kImageHasSlabs
};

static_assert(sizeof(ImageHeader) == 80, "the figure in the format's description");

/// Checks magic, version and size, and copies the header. The header says which kind of image it
/// is; its contents may still be invalid.
Status read_image_header(const void* bytes, size_t size, ImageHeader& header);

/// Returns the tree's size for bounds (time_bound.hpp) from the header of an image that was opened.
inline TreeSize tree_size_of(const ImageHeader& header) {
  return {header.depth, header.arity, header.leaf_size, header.leaf_count, header.triangle_count};
}

/// Opens an image in place. `bytes` must start at a multiple of 4 and outlive `mesh`.
///
/// Checks all of it in linear time and constant memory: the checksum, links that go forward and
/// nest, and indices in range. Levels, ranks and the header's numbers must match the tree. Each
/// node's box must be in its parent's, each triangle in its leaf's box and slabs. The longest edge
/// and closedness must be right. On `done`, queries on `mesh` end and read only the image. After an
/// error the mesh is not open: queries on it return `not_open`.
///
/// Instructions: 10 a byte for the checksum and, on a Cortex-M4, 720 a node with slabs. Stack: 400
/// bytes on Cortex-M3 to M55 at -O2.
///
/// If `size` exceeds the header's byte count, the bytes after the image are ignored. MeshType:
/// Mesh, PreMesh, Mesh32 or PreMesh32. `image_kind`: the image has another kind.
template <class MeshType>
Status open_image(const void* bytes, size_t size, MeshType& mesh);

/// Returns the mesh of an image that the firmware's own build has baked (`flashbvh bake` writes C):
/// a view in constant time, without any check. Other bytes lead queries out of bounds; open_image()
/// is for images from elsewhere or written at run time.
///
///     const flashbvh::Mesh plate = flashbvh::view_unchecked<flashbvh::Mesh>(plate_image);
///
/// Precondition: `image` starts at a multiple of 4, outlives the mesh and has its kind. A null
/// pointer is not detected. At namespace scope such a line needs a start-up file that runs
/// constructors; without, queries return `not_open` (lib/docs/guide.md, "Start-up").
template <class MeshType>
MeshType view_unchecked(const void* image);

// For programs that write or show images.

/// Offsets of an image's arrays, in bytes from its start; `end` is its size. 64 bits, so that sums
/// of any header's values do not wrap.
struct ImageOffsets {
  uint64_t nodes, levels, climb, triangles, triangle_ids, leaf_offsets, slabs, vertices,
      shell_vertices, name, end;
};
/// Returns the offsets for a header, which may hold any values.
ImageOffsets image_offsets(const ImageHeader& header);

/// Returns the checksum for the header of an image of at least 16 bytes. 10 instructions a byte.
uint32_t image_crc(const void* bytes, size_t size);

}  // namespace flashbvh
