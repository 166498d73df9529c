// Strings that embed.py makes of this folder's files. Libraries are empty if there was no Clang to
// compile them.
#pragma once

namespace flashbvh::tool {

extern const char* const kPageCss;
extern const char* const kTablesScript;
extern const char* const kRobotScript;
extern const char* const kMeshScript;
extern const char* const kArmLibrary;   ///< base64
extern const char* const kPairLibrary;  ///< base64

}  // namespace flashbvh::tool
