// damage FILE flip OFFSET OUT: a copy with all bits of one byte turned round.
// damage FILE set OFFSET WORD OUT: a copy with other 4 bytes there and a checksum that matches.
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

namespace {

constexpr std::size_t kCrcAt = 12;

/// CRC-32 (IEEE 802.3), bit by bit: not the library's.
std::uint32_t checksum(const std::string& bytes) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i >= kCrcAt && i < kCrcAt + 4) {
      continue;
    }
    crc ^= static_cast<unsigned char>(bytes[i]);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xEDB88320u : 0u);
    }
  }
  return ~crc;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    return EXIT_FAILURE;
  }
  std::ifstream in(argv[1], std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  const auto offset = static_cast<std::size_t>(std::strtoul(argv[3], nullptr, 0));
  if (std::string(argv[2]) == "flip") {
    bytes.at(offset) = static_cast<char>(~bytes.at(offset));
  } else {
    const auto word = static_cast<std::uint32_t>(std::strtoul(argv[4], nullptr, 0));
    std::memcpy(&bytes.at(offset), &word, 4);
    const std::uint32_t crc = checksum(bytes);
    std::memcpy(&bytes.at(kCrcAt), &crc, 4);
  }
  std::ofstream(argv[argc - 1], std::ios::binary) << bytes;
  return EXIT_SUCCESS;
}
