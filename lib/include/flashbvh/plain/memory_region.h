/* Memory that does not change. For C and C++: `MemoryRegion` is `flashbvh_memory_region`. */
#ifndef FLASHBVH_PLAIN_MEMORY_REGION_H
#define FLASHBVH_PLAIN_MEMORY_REGION_H

#include <stddef.h>
#include <stdint.h>

/** Bytes with a known checksum. */
typedef struct flashbvh_memory_region {
  const void* begin;
  size_t size;  /**< bytes */
  uint32_t crc; /**< CRC-32 (IEEE 802.3), as in images and zlib; 0 for no bytes */
} flashbvh_memory_region;

/** Length of flashbvh_sealed_regions(): the most regions that a firmware can have. */
#define FLASHBVH_SEALED_REGIONS 8

#endif
