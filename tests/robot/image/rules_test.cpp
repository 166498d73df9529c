// Robots' images with one number changed: each breaks one rule of the format.
#include <functional>

#include "flashbvh/clearance.hpp"
#include "support/arms/image_in_parts.hpp"
#include "support/test.hpp"

namespace {

/// A change to every_joint_arm()'s image, with repaired checksum and hash, and the expected status.
struct Crafted {
  const char* what;
  std::function<void(Parts parts)> change;
  Status status = Status::image_invalid;
};

/// A change to the first mesh, with a repaired checksum.
template <class Change>
auto in_mesh(const Change& change) {
  return [change](Parts parts) {
    change(parts.mesh());
    repair_crc(parts.meshes, parts.mesh().byte_count);
  };
}

constexpr std::uint8_t kNoType = 3;

/// Makes the links' meshes equal to the URDF's, and sets the slack.
void set_slack_of_exact_links(Parts parts, std::uint32_t slack) {
  for (std::uint32_t i = 0; i < parts.header.link_count; ++i) {
    parts.links[i].deviation = 0;
  }
  parts.header.slack = slack;
}

RobotUnguarded believed(std::uint8_t a, std::uint8_t b) {
  return {a, b, WhyUnguarded::believed, kBase, 0};
}

/// A link about the base's origin.
RobotLink ball(std::uint32_t radius) {
  return {{0, 0, 0}, radius, 0, kBase, 0, 0};
}

const Crafted kCrafted[] = {
    {"nothing", [](Parts) {}, Status::done},
    {"magic", [](Parts p) { p.header.magic = kImageMagic; }, Status::image_not_flashbvh},
    {"a version to come", [](Parts p) { ++p.header.version; }, Status::image_version},
    {"no version", [](Parts p) { p.header.version = 0; }, Status::image_version},
    {"more bytes", [](Parts p) { ++p.header.byte_count; }, Status::image_truncated},
    {"fewer bytes", [](Parts p) { p.header.byte_count = 44; }, Status::image_corrupt},
    {"no link", [](Parts p) { p.header.link_count = 0; }},
    {"a variable that nothing moves", [](Parts p) { ++p.header.variable_count; }},
    {"a variable less", [](Parts p) { --p.header.variable_count; }},
    {"more variables than joints", [](Parts p) { p.header.variable_count = 255; }},
    {"too little slack", [](Parts p) { set_slack_of_exact_links(p, 227); }},
    {"the least slack", [](Parts p) { set_slack_of_exact_links(p, 228); }, Status::done},
    {"too much slack", [](Parts p) { p.header.slack = kMaxGuardDistance + 1; }},
    {"another cell", [](Parts p) { p.header.cell[0] ^= 1; }, Status::cell_mismatch},
    {"other joints between", [](Parts p) { ++p.header.pair_joint_count; }},
    {"a mount less", [](Parts p) { --p.header.mount_count; }},
    {"a mount on no joint", [](Parts p) { p.mounts[1].joint = 5; }},
    {"padding of a mount", [](Parts p) { (&p.mounts[0].joint)[3] = 1; }},
    {"an unguarded pair less", [](Parts p) { --p.header.unguarded_count; }},
    {"an unguarded pair more", [](Parts p) { ++p.header.unguarded_count; }},
    {"more of them than bytes", [](Parts p) { p.header.unguarded_count = UINT16_MAX; },
     Status::image_corrupt},
    {"padding of the header", [](Parts p) { p.header.padding = 1; }},
    {"the other reason", [](Parts p) { p.unguarded[0] = believed(0, 1); }, Status::done},
    {"a reason that is none", [](Parts p) { p.unguarded[0].why = WhyUnguarded{2}; }},
    {"a zone about another joint", [](Parts p) { p.unguarded[0].joint = 1; }},
    {"a zone about no joint", [](Parts p) { p.unguarded[0].joint = kBase; }},
    {"a zone of nothing", [](Parts p) { p.unguarded[0].radius = 0; }},
    {"a joint of no zone", [](Parts p) { p.unguarded[1].joint = 1; }},
    {"a radius of no zone", [](Parts p) { p.unguarded[1].radius = 1; }},
    {"an unguarded link that is none", [](Parts p) { p.unguarded[1].b = 6; }},
    {"unguarded links turned round",
     [](Parts p) { std::swap(p.unguarded[1].a, p.unguarded[1].b); }},
    {"an unguarded link with itself", [](Parts p) { p.unguarded[1].b = 2; }},
    {"an unguarded pair twice", [](Parts p) { p.unguarded[1] = p.unguarded[0]; }},
    {"unguarded pairs out of order", [](Parts p) { std::swap(p.unguarded[0], p.unguarded[1]); }},
    {"guarded and unguarded", [](Parts p) { p.unguarded[1] = believed(2, 4); }},
    {"large tables", [](Parts p) { p.header.distance_table_bytes = UINT32_MAX; },
     Status::image_corrupt},
    {"an empty name more", [](Parts p) { p.names[0] = 0; }},
    {"a name without an end", [](Parts p) { p.names[p.header.names_size - 1] = 'x'; }},
    {"a gap that is no zero", [](Parts p) { p.meshes[-1] = 1; }},
    {"a parent after it", [](Parts p) { p.joints[1].parent = 2; }},
    {"its own parent", [](Parts p) { p.joints[1].parent = 1; }},
    {"a type that is none", [](Parts p) { p.joints[0].type = JointType{kNoType}; }},
    {"limits the wrong way", [](Parts p) { p.joints[0].lower = p.joints[0].upper + 1; }},
    {"one value alone", [](Parts p) { p.joints[0].lower = p.joints[0].upper; }, Status::done},
    {"a lower limit too far", [](Parts p) { p.joints[0].lower = -(1 << 30) - 1; }},
    {"an upper limit too far", [](Parts p) { p.joints[0].upper = (1 << 30) + 1; }},
    {"a limit of none", [](Parts p) { p.joints[2].upper = 1; }},
    {"a factor of no mimic", [](Parts p) { p.joints[0].multiplier = 2; }},
    {"an offset of no mimic", [](Parts p) { p.joints[0].offset = 1; }},
    {"too great a shift", [](Parts p) { p.joints[3].shift = 41; }},
    {"too great a factor", [](Parts p) { p.joints[3].multiplier = (1 << 30) + 1; }},
    {"too great an offset", [](Parts p) { p.joints[3].offset = INT32_MIN; }},
    {"two of one variable", [](Parts p) { p.joints[1].variable = 0; }},
    {"a variable beyond", [](Parts p) { p.joints[3].variable = 3; }},
    {"turns a part of a turn", [](Parts p) { p.joints[4].multiplier ^= 1; }},
    {"a mimic with limits of one without", [](Parts p) { p.joints[3].variable = 2; }},
    {"laps of a joint", [](Parts p) { p.joints[0].laps = 1; }},
    {"an entry above 1", [](Parts p) { p.joints[0].fixed.rotation[0][0] = INT32_MIN; }},
    {"a row too short", [](Parts p) { p.joints[0].fixed.rotation[0][0] -= 3; }},
    {"a row as rounding leaves it", [](Parts p) { --p.joints[0].fixed.rotation[0][0]; },
     Status::done},
    {"rows askew", [](Parts p) { p.joints[0].fixed.rotation[0][1] = 3; }},
    {"a mirror", [](Parts p) { p.joints[0].fixed.rotation[0][0] *= -1; }},
    {"too far a frame", [](Parts p) { p.joints[0].fixed.translation[1] = 1 << 30; }},
    {"the farthest of all", [](Parts p) { p.joints[0].fixed.translation[1] = INT32_MIN; }},
    {"too far together",
     [](Parts p) {
       p.joints[0].fixed.translation[0] = 1 << 29;
       p.joints[1].fixed.translation[0] = 1 << 29;
     }},
    {"slides too far", [](Parts p) { p.joints[1].upper = 1 << 30; }},
    {"a joint that is none", [](Parts p) { p.links[0].joint = 5; }},
    {"reaches elsewhere", [](Parts p) { ++p.links[2].first_reach; }},
    {"padding of a link", [](Parts p) { p.links[0].padding = 1; }},
    {"a deviation that the slack does not cover", [](Parts p) { p.links[2].deviation += 1 << 8; }},
    {"a deviation that wraps", [](Parts p) { p.links[2].deviation = 1u << 31; }},
    {"too small a sphere", [](Parts p) { p.links[1].radius -= p.links[1].radius / 64; }},
    {"a sphere elsewhere", [](Parts p) { p.links[1].centre[2] += kFrameCell * 8; }},
    {"too large a sphere", [](Parts p) { p.links[1].radius = UINT32_MAX; }},
    {"as far as may be", [](Parts p) { p.links[0] = ball((1 << 30) - (1 << 15) - 1); },
     Status::done},
    {"a little farther", [](Parts p) { p.links[0] = ball((1 << 30) - (1 << 15)); }},
    {"a sphere too far", [](Parts p) { p.links[1].centre[0] = INT32_MIN; }},
    {"a link with itself", [](Parts p) { p.pairs[3].a = p.pairs[3].b; }},
    {"a link that is none", [](Parts p) { p.pairs[3].b = 6; }},
    {"the other way round", [](Parts p) { std::swap(p.pairs[0], p.pairs[1]); }},
    {"a pair twice", [](Parts p) { p.pairs[1] = p.pairs[0]; }},
    {"joints of the one", [](Parts p) { ++p.pairs[2].joints_a; }},
    {"joints of the other", [](Parts p) { --p.pairs[2].joints_b; }},
    {"another sum", [](Parts p) { ++p.pairs[2].reach; }},
    {"a sum of more than 32 bits",
     [](Parts p) {
       const std::uint32_t first = p.links[2].first_reach;  // `turning`, in the pair base - slide
       p.reaches[first + 1] = UINT32_MAX;
       p.pairs[0].reach = p.reaches[first] - 1;
     }},
    {"a slide's reach", [](Parts p) { ++p.reaches[p.links[2].first_reach]; }},
    {"warns too near", [](Parts p) { p.pairs[0].warn = p.pairs[0].stop - 1; }},
    {"stops too far", [](Parts p) { p.pairs[0].stop = p.pairs[0].warn = kMaxGuardDistance + 1; }},
    {"stops at the farthest",
     [](Parts p) { p.pairs[0].stop = p.pairs[0].warn = kMaxGuardDistance; }, Status::done},
    {"a mesh damaged", [](Parts p) { p.meshes[100] ^= 1; }, Status::image_corrupt},
    {"no mesh", [](Parts p) { p.mesh().magic ^= 1; }, Status::image_corrupt},
    {"a mesh beyond the end", [](Parts p) { p.mesh().byte_count = 1 << 30; },
     Status::image_corrupt},
    {"a mesh of another version", [](Parts p) { ++p.mesh().version; }, Status::image_version},
    {"a mesh of another layout", in_mesh([](ImageHeader& m) { m.layout = 0; }), Status::image_kind},
    {"a mesh of another cell", in_mesh([](ImageHeader& m) { m.cell[0] ^= 1; }),
     Status::cell_mismatch},
    {"a mesh in millimetres",
     in_mesh([](ImageHeader& m) { m.unit = static_cast<std::uint8_t>(Unit::mm); }),
     Status::cell_mismatch},
    {"a mesh that breaks a rule", in_mesh([](ImageHeader& m) { ++m.depth; })},
    {"a mesh off its place", in_mesh([](ImageHeader& m) { m.origin[0] += 100; })},
};

/// Repairs checksum and hash, and opens the image.
void check_opened(Words& words, Status status) {
  repair_robot(words.data(), size_of(words));
  const RobotVerdict verdict = exercise_any(words.data(), size_of(words));
  CHECK(verdict.status == status);
  CHECK(verdict.wrong == nullptr);
}

}  // namespace

TEST_CASE("an image that breaks a rule is refused with its status") {
  const Words whole = arm_images()[0].words;
  for (const Crafted& crafted : kCrafted) {
    CAPTURE(crafted.what);
    Words words = whole;
    crafted.change(Parts(words));
    check_opened(words, crafted.status);
  }
  // Distance tables for other joint ranges.
  Words tabulated = arm_images()[2].words;
  REQUIRE(Parts(tabulated).header.distance_table_bytes != 0);
  Parts(tabulated).joints[0].upper = Parts(tabulated).joints[0].lower;
  check_opened(tabulated, Status::image_invalid);
  // With a wrong hash.
  Words words = whole;
  ++Parts(words).header.hash;
  CHECK(exercise_any(words.data(), size_of(words)).status == Status::image_corrupt);
}
