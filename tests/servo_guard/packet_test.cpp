// Packets of servos: found in any stream, by the byte, as a scan of the whole stream finds them,
// and classified by their effects.
#include "packet.hpp"

#include <vector>

#include "support/random.hpp"
#include "support/test.hpp"

using namespace servo;
using flashbvh::test::Random;
using flashbvh::test::test_random;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes packet(std::uint8_t id, std::uint8_t instruction, const Bytes& parameters) {
  Bytes made = {0, 0, id, 0, instruction};
  made.insert(made.end(), parameters.begin(), parameters.end());
  made.push_back(0);
  seal(made.data(), static_cast<std::uint32_t>(made.size()));
  return made;
}

/// The packets of a stream that ends: a scan of all of it.
std::vector<Bytes> scanned(const Bytes& stream) {
  std::vector<Bytes> found;
  for (std::size_t i = 0; i + 6 <= stream.size();) {
    const std::size_t size = stream[i + 3] + 4u;
    unsigned sum = 1;
    for (std::size_t j = i + 2; j < std::min(i + size, stream.size()); ++j) {
      sum += stream[j];
    }
    const bool is = stream[i] == 0xFF && stream[i + 1] == 0xFF && stream[i + 2] != 0xFF &&
                    size >= 6 && i + size <= stream.size() && sum % 256 == 0;
    if (is) {
      found.emplace_back(&stream[i], &stream[i] + size);
    }
    i += is ? size : 1;
  }
  return found;
}

/// A parser and what it found; a packet may stay in it for a while, and its bytes elsewhere.
struct Found {
  void take() {
    while (parser.has_packet()) {
      const Packet at = parser.packet();
      packets.emplace_back(at.bytes, at.bytes + at.size());
      parser.drop_packet();
    }
  }
  void push(std::uint8_t byte) {
    parser.push(byte);
    take();
  }
  void end() {
    while (!parser.is_empty()) {
      parser.give_up();
      take();
    }
  }
  Parser parser;
  std::vector<Bytes> packets;
};

std::vector<Bytes> parsed(const Bytes& stream) {
  Found found;
  for (const std::uint8_t byte : stream) {
    found.push(byte);
  }
  found.end();
  std::size_t size = found.parser.skipped;
  for (const Bytes& each : found.packets) {
    size += each.size();
  }
  CHECK(size == stream.size());
  return found.packets;
}

Bytes random_bytes(Random& random, std::size_t size) {
  Bytes made;
  for (std::size_t i = 0; i < size; ++i) {  // many headers, and short lengths
    const std::uint32_t kind = random.below(4);
    made.push_back(static_cast<std::uint8_t>(kind == 0 ? 0xFF : random.below(kind == 1 ? 9 : 256)));
  }
  return made;
}

Effect effect(const Bytes& of) {
  return effect_of({of.data()});
}
Effect write(std::uint8_t first, Bytes data) {
  data.insert(data.begin(), first);
  return effect(packet(1, kWrite, data));
}

const Bytes kGoals = packet(kBroadcast, kSyncWrite, {42, 2, 1, 0, 8, 2, 0xFF, 0xFF});

}  // namespace

TEST_CASE(
    "servo packets: junk, cuts and false headers hide no packet, in both directions at once") {
  Random random = test_random();
  for (int i = 0; i < 3000; ++i) {
    Bytes stream[2];
    Found found[2];
    for (Bytes& of : stream) {
      for (std::uint32_t parts = random.below(6); parts != 0; --parts) {
        Bytes part = random_bytes(random, random.below(40));
        if (random.below(2) == 0) {
          part = packet(static_cast<std::uint8_t>(random.below(255)), kWrite, part);
        }
        const std::size_t end = random.below(8) == 0 ? part.size() / 2 : part.size();
        of.insert(of.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(end));
      }
    }
    for (std::size_t at = 0; at < std::max(stream[0].size(), stream[1].size()); ++at) {
      for (std::size_t k = 0; k < 2; ++k) {
        if (at < stream[k].size()) {
          found[k].push(stream[k][at]);
        }
      }
    }
    for (std::size_t k = 0; k < 2; ++k) {
      found[k].end();
      REQUIRE(found[k].packets == scanned(stream[k]));
    }
  }
}

TEST_CASE("servo packets: every cut of a packet is no packet, and the next one is found") {
  for (std::size_t cut = 0; cut < kGoals.size(); ++cut) {
    Bytes stream(kGoals.begin(), kGoals.begin() + static_cast<std::ptrdiff_t>(cut));
    stream.insert(stream.end(), kGoals.begin(), kGoals.end());
    CAPTURE(cut);
    CHECK(parsed(stream) == scanned(stream));
    CHECK(parsed(stream).size() == 1);
  }
}

TEST_CASE(
    "servo packets: no packet with a flipped bit sets goals, and one of the next two is found") {
  // The sum does not see a length that is one too large before the next packet's FF.
  for (std::size_t bit = 0; bit < 8 * kGoals.size(); ++bit) {
    Bytes stream = kGoals;
    stream[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    stream.insert(stream.end(), kGoals.begin(), kGoals.end());
    stream.insert(stream.end(), kGoals.begin(), kGoals.end());
    CAPTURE(bit);
    const std::vector<Bytes> found = parsed(stream);
    CHECK(found == scanned(stream));
    CHECK(found.back() == kGoals);
    for (const Bytes& each : found) {
      CHECK((each == kGoals || effect(each) == Effect::withheld));
    }
  }
}

TEST_CASE("servo packets: the largest packet fits") {
  const Bytes largest = packet(1, kWrite, Bytes(253, 0xFF));
  CHECK(largest.size() == kLargestPacket);
  CHECK(parsed(largest) == std::vector<Bytes>{largest});
}

TEST_CASE("servo packets: what each can do") {
  CHECK(effect(packet(1, kPing, {})) == Effect::none);
  CHECK(effect(packet(kBroadcast, kPing, {})) == Effect::none);
  CHECK(effect(packet(1, kRead, {56, 2})) == Effect::none);
  CHECK(effect(packet(kBroadcast, kSyncRead, {56, 2, 1, 2})) == Effect::none);
  CHECK(write(40, {1}) == Effect::enable);
  CHECK(write(33, {0}) == Effect::enable);
  CHECK(write(40, {0}) == Effect::release);
  CHECK(effect(packet(kBroadcast, kSyncWrite, {40, 1, 1, 0, 2, 0})) == Effect::release);
  CHECK(effect(packet(kBroadcast, kSyncWrite, {40, 1, 1, 0, 2, 1})) == Effect::withheld);
  CHECK(effect(kGoals) == Effect::goal);
  for (std::uint32_t first = 0; first < 256; ++first) {
    for (std::uint32_t end = first + 1; end < first + 20; ++end) {
      const Bytes data(end - first, 128);
      const bool is_goal = (first == 41 || first == 42) && (end == 44 || end == 46 || end == 48);
      bool moves = false;  // or redefines
      for (std::uint32_t i = first; i < end; ++i) {
        moves = moves || i < 7 || (i > 7 && i < 13) || i == 18 || (i >= 30 && i <= 33) || i == 40 ||
                (i >= 42 && i <= 47) || (i > 49 && i != 55 && i != 85 && i != 86);
      }
      CAPTURE(first, end);
      CHECK(write(static_cast<std::uint8_t>(first), data) == (is_goal ? Effect::goal
                                                              : moves ? Effect::withheld
                                                                      : Effect::none));
    }
  }
  for (const std::uint8_t instruction : Bytes{0, 4, 5, 6, 8, 10, 11, 0x92, 255}) {
    CHECK(effect(packet(1, instruction, {42, 0, 8})) == Effect::withheld);
  }
  CHECK(effect(packet(kBroadcast, kWrite, {42, 0, 8})) == Effect::withheld);
  CHECK(effect(packet(kBroadcast, kSyncWrite, {42, 2, 1, 0, 8, 2, 0})) == Effect::withheld);
  CHECK(effect(packet(kBroadcast, kSyncWrite, {42, 0, 1, 0})) == Effect::withheld);
  CHECK(effect(packet(1, kSyncWrite, {42, 2, 1, 0, 8})) == Effect::withheld);
  CHECK(effect(packet(1, kWrite, {42})) == Effect::withheld);
}
