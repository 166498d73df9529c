#include "image/output_name.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "text/files.hpp"
#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word(char c) {
  return is_digit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// Reserved for compilers: a '_' before another one or before a capital.
bool is_reserved(const std::string& word) {
  return word.size() > 1 && word[0] == '_' &&
         (word[1] == '_' || (word[1] >= 'A' && word[1] <= 'Z'));
}

std::string word_of(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return is_word(c) ? c : '_'; });
  if (text.empty() || is_digit(text[0])) {
    text.insert(0, "_");
  } else if (is_reserved(text)) {
    text.insert(0, "m");
  }
  return text;
}

}  // namespace

OutputName output_name(const std::string& mesh_path, const std::string& chosen) {
  if (chosen.empty()) {
    const std::string stem = std::filesystem::path(mesh_path).stem().string();
    if (stem.find_first_of("\"\\\n\r") != std::string::npos) {
      throw UserError(mesh_path, "has a name that no #include can hold; use --name");
    }
    return {stem, word_of(stem)};
  }
  if (is_reserved(chosen)) {
    throw UserError("--name " + chosen, "is a name that C or C++ takes; use another, such as ",
                    word_of(chosen));
  }
  if (word_of(chosen) != chosen) {
    throw UserError("--name " + chosen, "is no name for C; use letters, digits and '_'");
  }
  return {chosen, chosen};
}

void TakenOutputs::add(const OutputName& name, const std::string& mesh, const char* fix) {
  const auto take = [&](std::map<std::string, std::string>& taken, const std::string& wanted) {
    const auto [known, is_new] = taken.emplace(lower_case(wanted), wanted);
    if (!is_new) {
      const std::string other = "'" + known->second + "'";
      throw UserError(mesh, "would be written as '", wanted, "' like ",
                      known->second == wanted
                          ? "one of a mesh before it"
                          : other + " but for the case, which some file systems ignore",
                      "; ", fix);
    }
  };
  take(words_, name.word);
  take(stems_, name.stem);
}

std::vector<OutputName> distinct_names(const std::vector<std::string>& names) {
  std::vector<OutputName> made;
  made.reserve(names.size());
  std::map<std::string, std::size_t> last_number;
  std::set<std::string> taken;
  for (const std::string& any : names) {
    const std::string wanted = word_of(any);
    std::string name = wanted;
    for (std::size_t& number = last_number.emplace(lower_case(wanted), 1).first->second;
         !taken.insert(lower_case(name)).second;) {
      name = concat(wanted, "_", ++number);
    }
    made.push_back({name, name});
  }
  return made;
}

}  // namespace flashbvh::tool
