/* The whole library, for sketches; parts of it are <flashbvh/ray.hpp>, <flashbvh/robot/guard.hpp>
 * ... */
#pragma once

#if !defined(__cplusplus)
#include "flashbvh/flashbvh.h"
#elif __cplusplus < 201703L
#error \
    "flashbvh is C++17: take a core that compiles it, or set -std=gnu++17 in the core's platform.local.txt"
#else
#include "flashbvh/flashbvh.hpp"
#endif
