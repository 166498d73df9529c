// The version of the library. CMake reads it from here; everything else includes it.
//
// lib/docs/changelog.md says what MAJOR, MINOR and PATCH promise.
#ifndef FLASHBVH_VERSION_HPP
#define FLASHBVH_VERSION_HPP

#define FLASHBVH_VERSION_MAJOR 2
#define FLASHBVH_VERSION_MINOR 0
#define FLASHBVH_VERSION_PATCH 0

#endif
