/* Memory that does not change. Of C++ and C alike: `MemoryRegion` is `flashbvh_memory_region`. */
#ifndef FLASHBVH_PLAIN_MEMORY_REGION_H
#define FLASHBVH_PLAIN_MEMORY_REGION_H

#include <stddef.h>
#include <stdint.h>

/** Bytes with a known checksum. */
typedef struct flashbvh_memory_region {
  const void* begin;
  size_t size;  /**< bytes */
  uint32_t crc; /**< CRC-32 (IEEE 802.3), as of images and in zlib; 0 of no bytes */
} flashbvh_memory_region;

/** Of flashbvh_sealed_regions(): as many as firmware has room for. */
#define FLASHBVH_SEALED_REGIONS 8

#endif
