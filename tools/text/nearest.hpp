// Finds the word that the user probably meant by a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flashbvh::tool {

/// Letters to insert, delete or replace to turn `a` into `b` (Levenshtein's distance).
std::size_t edits_between(std::string_view a, std::string_view b);

/// The first of `words` with the fewest edits to `word`. A word that begins with all of `word` (two
/// or more letters) counts as at most one edit away. Empty if none is near: a near word needs fewer
/// edits than there are letters, and at most a third of them, rounded up.
std::string nearest_word(std::string_view word, const std::vector<std::string>& words);

/// "; the nearest is '--bake'", with `before` ("--") before the word; empty if none is near.
std::string nearest_hint(std::string_view word, const std::vector<std::string>& words,
                         const char* before = "");

}  // namespace flashbvh::tool
