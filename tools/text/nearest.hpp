// The word that a mistyped one was meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// Letters to insert, leave out or replace until `a` is `b` (Levenshtein's distance).
std::size_t edits_between(std::string_view a, std::string_view b);

/// Of `words`, the one with the fewest edits to `word`, the first of several; a word that begins
/// with all of `word`, of two letters or more, is at most one edit away. Empty if none is near:
/// more edits than a third of the letters, rounded up, or as many as there are.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

/// "; the nearest is '--bake'", with "--" before the words; or nothing if none is near.
std::string nearest_hint(std::string_view word, const std::vector<std::string>& words,
                         const char* before = "");

}  // namespace flashbvh::tool
