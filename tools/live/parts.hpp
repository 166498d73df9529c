// What embed.py makes of this folder's files; libraries are empty where there was no Clang for
// them.
#pragma once

namespace flashbvh::tool {

extern const char* const kLiveCss;
extern const char* const kRobotScript;
extern const char* const kMeshScript;
extern const char* const kDeviationScript;
extern const char* const kArmLibrary;   ///< base64
extern const char* const kPairLibrary;  ///< base64

}  // namespace flashbvh::tool
