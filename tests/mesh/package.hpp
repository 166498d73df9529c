// Packages of 3MF.
#pragma once

#include <minizip/zip.h>

#include <string>
#include <utility>
#include <vector>

namespace flashbvh::test {

using Parts = std::vector<std::pair<std::string, std::string>>;

/// Writes a 3MF with this model and other parts.
inline void write_3mf(const std::string& path, const std::string& model, const Parts& others = {}) {
  Parts parts = {{"_rels/.rels",
                  "<Relationships><Relationship Target=\"/3D/m.model\" Type=\"http://"
                  "schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
                 {"3D/m.model", model}};
  parts.insert(parts.end(), others.begin(), others.end());
  const zipFile zip = zipOpen(path.c_str(), APPEND_STATUS_CREATE);
  for (const auto& [name, text] : parts) {
    zipOpenNewFileInZip(zip, name.c_str(), nullptr, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                        Z_DEFAULT_COMPRESSION);
    zipWriteInFileInZip(zip, text.data(), static_cast<unsigned>(text.size()));
    zipCloseFileInZip(zip);
  }
  zipClose(zip, nullptr);
}

}  // namespace flashbvh::test
