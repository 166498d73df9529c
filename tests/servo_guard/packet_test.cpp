// Packets of servos: found in any stream, byte by byte, as a scan of the whole stream finds them,
// and classified by their effects. Tables of servos.
#include "packet.hpp"

#include <vector>

#include "steps.hpp"
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
  sealed(made.data(), static_cast<std::uint32_t>(made.size()));
  return made;
}
const Bytes kGoals = packet(kBroadcast, kSyncWrite, {42, 2, 1, 0, 8, 2, 0xFF, 0xFF});

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

/// One direction: a parser and what it found.
struct Direction {
  explicit Direction(Bytes of) : stream(std::move(of)) {}
  void take(std::size_t i) {
    if (i < stream.size()) {
      parser.push(stream[i]);
    } else {
      parser.give_up();
    }
    for (; parser.has_packet(); parser.drop_packet()) {
      const Packet at = parser.packet();
      packets.emplace_back(at.bytes, at.bytes + at.size());
      size += at.size();
    }
  }
  Bytes stream;
  Parser parser;
  std::vector<Bytes> packets;
  std::size_t size = 0;  ///< of packets
};

/// The packets of a stream that ends, while the other direction has another one.
std::vector<Bytes> parsed(const Bytes& stream, const Bytes& other = kGoals) {
  Direction both[] = {Direction(stream), Direction(other)};
  for (std::size_t i = 0; i < 2 * std::max(stream.size(), other.size()); ++i) {
    both[0].take(i);
    both[1].take(i);
  }
  for (const Direction& each : both) {
    REQUIRE(each.packets == scanned(each.stream));
    REQUIRE(each.size + each.parser.skipped == each.stream.size());
  }
  return both[0].packets;
}

Bytes joined(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Packets, cuts of packets, and junk with many headers and short lengths.
Bytes random_stream(Random& random) {
  Bytes stream;
  for (std::uint32_t parts = random.below(6); parts != 0; --parts) {
    Bytes part(random.below(40));
    for (std::uint8_t& byte : part) {
      const std::uint32_t kind = random.below(4);
      byte = static_cast<std::uint8_t>(kind == 0 ? 0xFF : random.below(kind == 1 ? 9 : 256));
    }
    part = random.below(2) == 0
               ? part
               : packet(static_cast<std::uint8_t>(random.below(255)), kWrite, part);
    part.resize(random.below(8) == 0 ? part.size() / 2 : part.size());
    stream = joined(stream, part);
  }
  return stream;
}

Effect effect(Bytes of) {
  const Packet packet = {of.data()};
  return effect_of(packet, writes_of(packet));
}
Effect write(std::uint8_t first, const Bytes& data) {
  return effect(packet(1, kWrite, joined({first}, data)));
}

}  // namespace

TEST_CASE("servo packets: junk, cuts and false headers hide none, in both directions at once") {
  Random random = test_random();
  for (int i = 0; i < 3000; ++i) {
    parsed(random_stream(random), random_stream(random));
  }
  for (std::size_t cut = 0; cut < kGoals.size(); ++cut) {
    Bytes stream = kGoals;
    stream.resize(cut);
    CHECK(parsed(joined(stream, kGoals)) == std::vector<Bytes>{kGoals});
  }
  const Bytes largest = packet(1, kWrite, Bytes(253, 0xFF));
  CHECK(largest.size() == kLargestPacket);
  CHECK(parsed(largest) == std::vector<Bytes>{largest});
}

TEST_CASE("servo packets: none with a flipped bit sets goals, and one of the next two is found") {
  // The sum does not see a length that is one too large before the next packet's FF.
  for (std::size_t bit = 0; bit < 8 * kGoals.size(); ++bit) {
    Bytes stream = kGoals;
    stream[bit / 8] ^= static_cast<std::uint8_t>(1 << bit % 8);
    CAPTURE(bit);
    const std::vector<Bytes> found = parsed(joined(joined(stream, kGoals), kGoals));
    CHECK(found.back() == kGoals);
    for (const Bytes& each : found) {
      CHECK((each == kGoals || effect(each) == Effect::withheld));
    }
  }
}

TEST_CASE("servo packets: what each can do") {
  for (const Bytes& harmless :
       {packet(1, kPing, {}), packet(kBroadcast, kPing, {}), packet(1, kRead, {56, 2}),
        packet(kBroadcast, kSyncRead, {56, 2, 1, 2})}) {
    CHECK(effect(harmless) == Effect::none);
  }
  CHECK(write(40, {1}) == Effect::enable);
  CHECK(write(33, {0}) == Effect::enable);
  CHECK(write(40, {0}) == Effect::release);
  CHECK(effect(packet(kBroadcast, kSyncWrite, {40, 1, 1, 0, 2, 0})) == Effect::release);
  CHECK(effect(packet(kBroadcast, kSyncWrite, {40, 1, 1, 0, 2, 1})) == Effect::withheld);
  CHECK(effect(kGoals) == Effect::goal);
  for (std::uint32_t first = 0; first < 256; ++first) {
    for (std::uint32_t end = first + 1; end < first + 20; ++end) {
      const bool is_goal = (first == 41 || first == 42) && (end == 44 || end == 46 || end == 48);
      bool moves = false;  // or redefines
      for (std::uint32_t i = first; i < end; ++i) {
        moves = moves || i < 7 || (i > 7 && i < 13) || i == 18 || (i >= 30 && i <= 33) || i == 40 ||
                (i >= 42 && i <= 47) || (i > 49 && i != 55 && i != 85 && i != 86);
      }
      CAPTURE(first, end);
      CHECK(write(static_cast<std::uint8_t>(first), Bytes(end - first, 128)) ==
            (is_goal ? Effect::goal
             : moves ? Effect::withheld
                     : Effect::none));
    }
  }
  for (const std::uint8_t instruction : Bytes{0, 4, 5, 6, 8, 10, 11, 0x92, 255}) {
    CHECK(effect(packet(1, instruction, {42, 0, 8})) == Effect::withheld);
  }
  for (const Bytes& odd :
       {packet(kBroadcast, kWrite, {42, 0, 8}), packet(1, kWrite, {42}),
        packet(kBroadcast, kSyncWrite, {42, 2, 1, 0, 8, 2, 0}),
        packet(kBroadcast, kSyncWrite, {42, 0, 1, 0}), packet(1, kSyncWrite, {42, 2, 1, 0, 8})}) {
    CHECK(effect(odd) == Effect::withheld);
  }
}

TEST_CASE("servo tables: numbers out of range, and one id or joint twice, are refused") {
  const Servo good[] = {{0, 1, 0, 1, 1}, {1, 253, 4095, -1, 100'000}};
  CHECK(are_possible(good));
  const Servo any = {2, 2, 0, 1, 1};
  CHECK(are_possible({good[0], good[1], any}));
  for (const Servo& bad : {Servo{2, 254, 0, 1, 1}, Servo{2, 253, 0, 1, 1}, Servo{1, 2, 0, 1, 1},
                           Servo{2, 2, -1, 1, 1}, Servo{2, 2, 4096, 1, 1}, Servo{2, 2, 0, 0, 1},
                           Servo{2, 2, 0, 1, 0}, Servo{2, 2, 0, 1, 100'001}}) {
    CHECK_FALSE(are_possible({good[0], good[1], bad}));
  }
}
