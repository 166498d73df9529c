// Arbitrary bytes as an image: refused, or queries on it read nothing else and end
// (golden/exercise.hpp).
//
// The input is an image; bytes after its end make another pose. Magic, version, size and checksum
// are repaired first, since chance would not find them.
#include <vector>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "flashbvh/image.hpp"
#include "fuzz/any_pose.hpp"
#include "golden/exercise.hpp"

using namespace flashbvh;
using namespace flashbvh::detail;
using namespace flashbvh::test;

namespace {

/// The image's part of the input, repaired as far as its header allows.
std::vector<std::uint8_t> repaired(const std::uint8_t* bytes, std::size_t size) {
  ImageHeader header;
  std::memcpy(&header, bytes, sizeof header);
  header.magic = kImageMagic;
  header.version = kImageVersion;
  header.padding = 0;
  header.layout &= 1;
  header.index_bits = header.index_bits == 32 ? 32 : 16;
  const std::uint64_t end = image_offsets(header).end;
  header.byte_count = static_cast<std::uint32_t>(end < size ? end : size);
  std::vector<std::uint8_t> image(bytes, bytes + header.byte_count);
  std::memcpy(image.data(), &header, sizeof header);
  repair_crc(image.data(), image.size());
  return image;
}

/// With every traversal testing all intersecting pairs, keeps one input below a second.
constexpr std::uint32_t kManyTriangles = 120;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  (void)exercise_image(bytes, size, {});  // unrepaired
  if (size < sizeof(ImageHeader)) {
    return 0;
  }
  const std::vector<std::uint8_t> image = repaired(bytes, size);
  Input rest(bytes + image.size(), size - image.size());
  std::vector<Pose> poses = {any_pose(rest)};
  ImageHeader header;
  std::memcpy(&header, image.data(), sizeof header);
  if (header.triangle_count < kManyTriangles) {
    for (const Pose& pose : representative_poses()) {
      poses.push_back(pose);
    }
  }
  const test::Verdict verdict = exercise_image(image.data(), image.size(), poses);
  require(verdict.wrong == nullptr, verdict.wrong);
  return 0;
}
