#include "image/output_name.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

#include "text/messages.hpp"
#include "text/numbers.hpp"

namespace flashbvh::tool {
namespace {

/// C++20's keywords and alternative tokens, and names that a namespace of the user can't have.
constexpr std::array<std::string_view, 100> kTaken = {
    "alignas",       "alignof",      "and",       "and_eq",       "asm",      "auto",
    "bitand",        "bitor",        "bool",      "break",        "case",     "catch",
    "char",          "char16_t",     "char32_t",  "char8_t",      "class",    "co_await",
    "co_return",     "co_yield",     "compl",     "concept",      "const",    "const_cast",
    "consteval",     "constexpr",    "constinit", "continue",     "decltype", "default",
    "delete",        "do",           "double",    "dynamic_cast", "else",     "enum",
    "explicit",      "export",       "extern",    "false",        "flashbvh", "float",
    "for",           "friend",       "goto",      "if",           "inline",   "int",
    "long",          "main",         "mutable",   "namespace",    "new",      "noexcept",
    "not",           "not_eq",       "nullptr",   "operator",     "or",       "or_eq",
    "posix",         "private",      "protected", "public",       "register", "reinterpret_cast",
    "requires",      "return",       "short",     "signed",       "sizeof",   "static",
    "static_assert", "static_cast",  "std",       "struct",       "switch",   "template",
    "this",          "thread_local", "throw",     "true",         "try",      "typedef",
    "typeid",        "typename",     "union",     "unsigned",     "using",    "virtual",
    "void",          "volatile",     "wchar_t",   "while",        "xor",      "xor_eq",
    "linux",         "unix",         "errno",     "NULL"};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word(char c) {
  return is_digit(c) || c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string identifier_of(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return is_word(c) ? c : '_'; });
  if (text.empty() || is_digit(text[0])) {
    text.insert(0, "_");
  }
  if (std::find(kTaken.begin(), kTaken.end(), text) != kTaken.end()) {
    text += '_';
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
    return {stem, identifier_of(stem)};
  }
  if (identifier_of(chosen) != chosen) {
    throw UserError("--name " + chosen,
                    "is no name for a C++ namespace; use letters, digits and '_'");
  }
  return {chosen, chosen};
}

std::vector<OutputName> body_names(const std::string& mesh_path,
                                   const std::vector<InputMesh>& bodies) {
  const std::string stem = std::filesystem::path(mesh_path).stem().string();
  std::vector<OutputName> names;
  std::map<std::string, std::size_t> last_number;
  std::set<std::string> taken;
  for (const InputMesh& body : bodies) {
    const std::string& own = body.bodies.front();
    const std::string wanted = identifier_of(own.empty() ? stem : own);
    std::string name = wanted;
    for (std::size_t& number = last_number.emplace(wanted, 1).first->second;
         !taken.insert(name).second;) {
      name = concat(wanted, "_", ++number);
    }
    names.push_back({name, name});
  }
  return names;
}

}  // namespace flashbvh::tool
