// Pages that draw and answer: a drawing, and tables of facts.
#pragma once

#include <cstddef>
#include <string>

namespace flashbvh::tool {

/// The largest number of meshes in a drawing.
constexpr std::size_t kMostDrawn = 64;

// Strings that embed.py makes of this folder's files.
extern const char* const kPageCss;
extern const char* const kPageScript;
extern const char* const kPageLibrary;  ///< base64; empty if there was no Clang to compile it

std::string base64(const void* data, std::size_t size);

/// A self-contained page of this JSON: its command, title, headlines (a verdict's digit and a text
/// each; the first says what to do), facts (objects), version and, if kPageLibrary is not empty,
/// its drawing, as robot.js or scene.js takes it.
std::string page_of(const std::string& data);

}  // namespace flashbvh::tool
