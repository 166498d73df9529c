// Packages of 3MF.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace flashbvh::test {

using Parts = std::vector<std::pair<std::string, std::string>>;

inline std::string little_endian(std::uint32_t number, int count) {
  return std::string(reinterpret_cast<const char*>(&number), static_cast<std::size_t>(count));
}

inline std::uint32_t crc(const std::string& bytes) {
  std::uint32_t sum = ~0u;
  for (const char c : bytes) {
    sum ^= static_cast<unsigned char>(c);
    for (int i = 0; i < 8; ++i) {
      sum = (sum >> 1) ^ ((sum & 1) != 0 ? 0xEDB88320u : 0);
    }
  }
  return ~sum;
}

/// A zip of these parts, without compression.
inline std::string zip_of(const Parts& parts) {
  std::string bytes;
  std::string directory;
  for (const auto& [name, text] : parts) {
    const auto size = static_cast<std::uint32_t>(text.size());
    const std::string facts = little_endian(20, 2) + little_endian(0, 4) + little_endian(0x21, 4) +
                              little_endian(crc(text), 4) + little_endian(size, 4) +
                              little_endian(size, 4) +
                              little_endian(static_cast<std::uint32_t>(name.size()), 4);
    directory += "PK\1\2" + little_endian(20, 2) + facts + little_endian(0, 4) +
                 little_endian(0, 4) + little_endian(0, 2) +
                 little_endian(static_cast<std::uint32_t>(bytes.size()), 4) + name;
    bytes += "PK\3\4" + facts + name + text;
  }
  const auto count = static_cast<std::uint32_t>(parts.size());
  return bytes + directory + "PK\5\6" + little_endian(0, 4) + little_endian(count, 2) +
         little_endian(count, 2) + little_endian(static_cast<std::uint32_t>(directory.size()), 4) +
         little_endian(static_cast<std::uint32_t>(bytes.size()), 4) + little_endian(0, 2);
}

inline const std::string kSpace = "http://schemas.microsoft.com/3dmanufacturing/";

/// A 3MF whose model is this one.
inline std::string package_of(const std::string& root, const Parts& others) {
  Parts parts = {{"_rels/.rels", "<Relationships><Relationship Target=\"/3D/m.model\" Type=\"" +
                                     kSpace + "2013/01/3dmodel\"/></Relationships>"},
                 {"3D/m.model", root}};
  parts.insert(parts.end(), others.begin(), others.end());
  return zip_of(parts);
}

}  // namespace flashbvh::test
