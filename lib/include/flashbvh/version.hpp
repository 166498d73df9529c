// The version of the library. CMake reads it from here; everything else includes it.
//
// Below 1.0 a change of MINOR may break sources; from 1.0 on only a change of MAJOR does.
#ifndef FLASHBVH_VERSION_HPP
#define FLASHBVH_VERSION_HPP

#define FLASHBVH_VERSION_MAJOR 0
#define FLASHBVH_VERSION_MINOR 2
#define FLASHBVH_VERSION_PATCH 0

#endif
