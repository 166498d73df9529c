// Writes the evaluation's setups as C++ for firmware: images, and a table of the walks on them.
#pragma once

#include <cstdint>
#include <string>

namespace flashbvh::tool {

struct FirmwareOptions {
  std::string folder;                    ///< empty: write nothing
  std::uint32_t images = 1;              ///< that share the setups
  std::uint64_t max_bytes = UINT32_MAX;  ///< of flash for the trees of an image
};

/// Writes setups_1.cpp to setups_N.cpp, one for each image, and the trees that they include: each
/// object with 16-bit indices, in both layouts, with levels. A setup goes to the first image with
/// capacity; the first image's table names the setups that fit no image. The files have the same
/// bytes on every machine. tests/figures/setups.hpp declares their symbols.
void write_firmware(const FirmwareOptions& options);

}  // namespace flashbvh::tool
