// Packages of 3MF.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mesh/any_format.hpp"

namespace flashbvh::test {

using Parts = std::vector<std::pair<std::string, std::string>>;

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
    const std::string facts = bytes_of(std::uint16_t{20}) + bytes_of(0u) + bytes_of(0x21u) +
                              bytes_of(crc(text)) + bytes_of(size) + bytes_of(size) +
                              bytes_of(static_cast<std::uint32_t>(name.size()));
    directory += "PK\1\2" + bytes_of(std::uint16_t{20}) + facts + std::string(10, '\0') +
                 bytes_of(static_cast<std::uint32_t>(bytes.size())) + name;
    bytes += "PK\3\4" + facts + name + text;
  }
  const std::string count = bytes_of(static_cast<std::uint16_t>(parts.size()));
  return bytes + directory + "PK\5\6" + bytes_of(0u) + count + count +
         bytes_of(static_cast<std::uint32_t>(directory.size())) +
         bytes_of(static_cast<std::uint32_t>(bytes.size())) + bytes_of(std::uint16_t{0});
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
