// The version of the library. CMake reads it from here; everything else includes it.
// lib/docs/changelog.md has the promises of MAJOR, MINOR and PATCH.
#pragma once

#define FLASHBVH_VERSION_MAJOR 0
#define FLASHBVH_VERSION_MINOR 9
#define FLASHBVH_VERSION_PATCH 0
