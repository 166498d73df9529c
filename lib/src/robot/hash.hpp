// The hash that distinguishes robots.
#pragma once

#include <stdint.h>

namespace flashbvh::detail {

constexpr uint32_t kNoHash = 2166136261u;

/// FNV-1a over elements without padding, continued from `hash`; 1 in place of 0.
template <class Element>
[[gnu::noinline]] uint32_t hash_of(const Element* elements, uint32_t count, uint32_t hash) {
  const unsigned char* const bytes = reinterpret_cast<const unsigned char*>(elements);
  for (uint32_t i = 0; i < count * sizeof(Element); ++i) {
    hash = (hash ^ bytes[i]) * 16777619u;
  }
  return hash != 0 ? hash : 1;
}

}  // namespace flashbvh::detail
