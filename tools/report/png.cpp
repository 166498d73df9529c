// PNG (Portable Network Graphics, ISO/IEC 15948), colour type 6: colours and opacity.
#include "report/png.hpp"

#include <zlib.h>

#include <algorithm>

namespace flashbvh::tool {
namespace {

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>((value >> shift) & 0xFF);
  }
  return bytes;
}

const Bytef* bytes_of(const std::string& text) {
  return reinterpret_cast<const Bytef*>(text.data());
}

std::string chunk(const std::string& name, const std::string& data) {
  const std::string body = name + data;
  const auto crc = crc32(0, bytes_of(body), static_cast<uInt>(body.size()));
  return big_endian(static_cast<std::uint32_t>(data.size())) + body +
         big_endian(static_cast<std::uint32_t>(crc));
}

/// Each row after the byte that says "not filtered", compressed.
std::string compressed_rows(const Picture& picture) {
  std::string rows;
  const std::size_t row = std::size_t{4} * picture.side;
  for (std::uint32_t y = 0; y < picture.side; ++y) {
    rows += '\0';
    rows.append(picture.pixels, y * row, row);
  }
  uLongf size = compressBound(rows.size());
  std::string stream(size, '\0');
  // Fails only where memory or room runs out; there is as much as any rows can take.
  compress2(reinterpret_cast<Bytef*>(stream.data()), &size, bytes_of(rows), rows.size(), 9);
  stream.resize(size);
  return stream;
}

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t j = 0; j < 3; ++j) {
      three = three << 8 | (i + j < bytes.size() ? static_cast<std::uint8_t>(bytes[i + j]) : 0u);
    }
    const std::size_t given = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t j = 0; j < 4; ++j) {
      text += j <= given ? digits[(three >> (18 - 6 * j)) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::string data_uri(const Picture& picture) {
  const std::string side = big_endian(picture.side);
  const std::string kind("\x08\x06\0\0\0", 5);  // 8 bits, colours and opacity, not interlaced
  return "data:image/png;base64," +
         base64("\x89PNG\r\n\x1A\n" + chunk("IHDR", side + side + kind) +
                chunk("IDAT", compressed_rows(picture)) + chunk("IEND", ""));
}

}  // namespace flashbvh::tool
