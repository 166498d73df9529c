#include "viewer/page.hpp"

#include <cstdint>

#include "text/messages.hpp"

namespace flashbvh::tool {

std::string base64(const void* data, std::size_t size) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* const bytes = static_cast<const std::uint8_t*>(data);
  const auto byte = [&](std::size_t i) { return i < size ? std::uint32_t{bytes[i]} : 0u; };
  std::string text;
  for (std::size_t i = 0; i < size; i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t digit = 0; digit < 4; ++digit) {
      text += i + digit > size ? '=' : kDigits[three >> (18 - 6 * digit) & 63u];
    }
  }
  return text;
}

std::string page_of(const std::string& data) {
  std::string quoted;  // no text in it ends the script
  for (const char c : data) {
    quoted += c == '<' ? std::string("\\u003c") : std::string(1, c);
  }
  return concat(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n<meta name=viewport "
      "content=\"width=device-width,initial-scale=1\">\n<title>flashbvh</title>\n<style>\n",
      kPageCss,
      "</style>\n</head>\n<body>\n<main>\n<h1 id=title></h1>\n<ul id=advice "
      "class=verdict></ul>\n<section "
      "id=live hidden></section>\n<section><ul id=decision class=verdict></ul></section>\n<div "
      "id=facts></div>\n</main>\n<script type=\"application/json\" id=page-data>",
      quoted, "</script>\n<script type=\"text/plain\" id=library>", kPageLibrary,
      "</script>\n<script>\n{\n", kPageScript, "}\n</script>\n</body>\n</html>\n");
}

}  // namespace flashbvh::tool
