// What embed.py makes of this folder's files; kArmWasm is empty where there was no Clang for it.
#pragma once

namespace flashbvh::tool {

extern const char* const kViewJs;
extern const char* const kArmJs;
extern const char* const kTrajectoryJs;
extern const char* const kLiveJs;
extern const char* const kLiveCss;
extern const char* const kArmWasm;  ///< base64

}  // namespace flashbvh::tool
