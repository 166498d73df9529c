#include "viewer/live_section.hpp"

#include <cstddef>

#include "text/numbers.hpp"
#include "viewer/parts.hpp"

namespace flashbvh::tool {
namespace {

/// The bytes of a string, or of a vector of numbers in memory, which is little-endian on all
/// supported machines.
template <class Data>
std::string base64(const Data& data) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(data.data());
  const std::size_t size = data.size() * sizeof(typename Data::value_type);
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

std::string quoted(const std::string& text) {
  return "\"" + text + "\"";
}

/// A JSON array.
template <class Elements, class TextOf>
std::string list_of(const Elements& elements, const TextOf& text_of) {
  return "[" + joined(elements, text_of, ",") + "]";
}

std::string periods_of(const LivePeriods& periods) {
  return periods.names.empty()
             ? ""
             : concat(",\"values\":\"", base64(periods.values), "\",\"verdicts\":\"",
                      periods.verdicts, "\",\"names\":", list_of(periods.names, quoted));
}

std::string zone_of(const LiveZone& zone) {
  const auto& [x, y, z] = zone.middle;
  return concat("[", zone.joint, ",", shortest(x), ",", shortest(y), ",", shortest(z), ",",
                shortest(zone.radius), "]");
}

std::string mesh_of(const LiveMesh& mesh) {
  const auto marks = [](const LiveMarks& of) {
    return concat("[\"--", of.colour, "\",",
                  list_of(of.vertices, [](std::uint32_t vertex) { return concat(vertex); }), "]");
  };
  return concat("{\"name\":\"", base64(mesh.name), "\",\"image\":\"", base64(mesh.image),
                "\",\"unit\":\"", mesh.unit, "\",\"marks\":", list_of(mesh.marks, marks), "}");
}

std::string pair_of(const LivePair& pair) {
  return concat("{\"a\":", pair.a, ",\"b\":", pair.b, ",\"poses\":", list_of(pair.poses, quoted),
                ",\"names\":", list_of(pair.names, quoted), ",\"verdicts\":\"", pair.verdicts,
                "\"}");
}

/// `data`: in JSON.
std::string section_of(const char* title, const std::string& data, const char* script) {
  return concat("<section id=live hidden>\n<h2>", title,
                "</h2>\n</section>\n<script type=\"application/json\" id=live-data>{", data,
                "}</script>\n<script>\n{\n", script, "}\n</script>\n");
}

std::string library_of(const char* library) {
  return concat(",\"library\":\"", library, "\"");
}

}  // namespace

bool has_live_section() {
  return *kArmLibrary != '\0';
}

std::string live_section(const std::vector<std::uint32_t>& image,
                         const std::vector<LiveZone>& zones, const LivePeriods& periods) {
  return has_live_section() ? section_of("The robot",
                                         concat("\"image\":\"", base64(image),
                                                "\",\"zones\":", list_of(zones, zone_of),
                                                periods_of(periods), library_of(kArmLibrary)),
                                         kRobotScript)
                            : "";
}

std::string live_section(const std::vector<LiveMesh>& meshes, const std::vector<LivePair>& pairs,
                         std::size_t first) {
  return has_live_section() && !meshes.empty()
             ? section_of(meshes.size() == 1 ? "The mesh" : "The meshes",
                          concat("\"first\":", first, ",\"meshes\":", list_of(meshes, mesh_of),
                                 ",\"pairs\":", list_of(pairs, pair_of), library_of(kPairLibrary)),
                          kMeshScript)
             : "";
}

std::string page_of(const std::string& data, const std::string& section) {
  std::string quoted_data;  // no text in it ends the script
  for (const char c : data) {
    quoted_data += c == '<' ? std::string("\\u003c") : std::string(1, c);
  }
  return concat(
      "<!DOCTYPE html>\n<html lang=en>\n<head>\n<meta charset=utf-8>\n<meta name=viewport "
      "content=\"width=device-width,initial-scale=1\">\n<title>flashbvh</title>\n<style>\n",
      kPageCss,
      "</style>\n</head>\n<body>\n<header><h1 id=title></h1></header>\n<main>\n<section><ul "
      "id=decision class=verdict></ul></section>\n",
      section, "<div id=facts></div>\n<script type=\"application/json\" id=page-data>", quoted_data,
      "</script>\n<script>\n{\n", kTablesScript, "}\n</script>\n</main>\n</body>\n</html>\n");
}

}  // namespace flashbvh::tool
