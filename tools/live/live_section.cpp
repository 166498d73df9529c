#include "live/live_section.hpp"

#include <cstddef>

#include "live/parts.hpp"
#include "text/numbers.hpp"

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

std::string deviation_of(const LiveDeviation& mesh) {
  return concat("{\"name\":\"", base64(mesh.name), "\",\"original\":\"", base64(mesh.original),
                "\",\"coarse\":\"", base64(mesh.coarse), "\",\"most\":", shortest(mesh.most),
                ",\"text\":\"", mesh.text, "\"}");
}

/// `data`: in JSON.
std::string section_of(const char* id, const char* title, const std::string& data,
                       const char* script) {
  return concat("<style>\n", kLiveCss, "</style>\n<section id=", id, " class=live hidden>\n<h2>",
                title, "</h2>\n</section>\n<script type=\"application/json\" id=", id, "-data>{",
                data, "}</script>\n<script>\n{\n", script, "}\n</script>\n");
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
  return has_live_section() ? section_of("live", "The robot",
                                         concat("\"image\":\"", base64(image),
                                                "\",\"zones\":", list_of(zones, zone_of),
                                                periods_of(periods), library_of(kArmLibrary)),
                                         kRobotScript)
                            : "";
}

std::string live_section(const std::vector<LiveMesh>& meshes, const std::vector<LivePair>& pairs,
                         std::size_t first) {
  return has_live_section() && !meshes.empty()
             ? section_of("live", meshes.size() == 1 ? "The mesh" : "The meshes",
                          concat("\"first\":", first, ",\"meshes\":", list_of(meshes, mesh_of),
                                 ",\"pairs\":", list_of(pairs, pair_of), library_of(kPairLibrary)),
                          kMeshScript)
             : "";
}

std::string deviation_section(const std::vector<LiveDeviation>& meshes) {
  return meshes.empty()
             ? ""
             : section_of("deviation", "The file&#39;s mesh and what is baked of it",
                          concat("\"meshes\":", list_of(meshes, deviation_of)), kDeviationScript);
}

}  // namespace flashbvh::tool
