// Every way a call into flashbvh can end.
#ifndef FLASHBVH_STATUS_HPP
#define FLASHBVH_STATUS_HPP

#include <stdint.h>

namespace flashbvh {

/// The values are part of the interface: they never change their number.
enum class [[nodiscard]] Status : uint8_t{
    done = 0,       ///< The answer is complete.
    suspended = 1,  ///< The visits granted are used up; run again to go on. Nothing is lost.
    full = 2,       ///< The caller's array is full; empty it and run again. Nothing is lost.

    cell_mismatch = 16,             ///< The two meshes were baked with different cells.
    stack_too_small = 17,           ///< A stack traversal's array is shorter than stack_entries().
    translation_out_of_range = 18,  ///< A translation beyond +-kMaxTranslation cells.
    not_a_rotation = 19,            ///< A matrix or quaternion that turns and does something else.
    position_invalid = 20,          ///< A saved position that is not one of this query's.

    image_truncated = 32,     ///< Fewer bytes than the image says it has.
    image_misaligned = 33,    ///< The image does not start at a multiple of 4 bytes.
    image_not_flashbvh = 34,  ///< The first four bytes are not "FBVH".
    image_version = 35,       ///< Written in another version of the format; bake again.
    image_kind = 36,          ///< Another layout or index width than the tree asked for.
    image_corrupt = 37,       ///< The checksum does not match: the bytes were damaged.
    image_invalid = 38,  ///< The checksum matches, but the contents break a rule of the format.
};

}  // namespace flashbvh

#endif
