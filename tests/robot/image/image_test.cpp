// Robots' images: a written image opens unchanged; a damaged, truncated or invented one is refused
// or harmless.
#include <fstream>
#include <iterator>

#include "flashbvh/robot/image.hpp"
#include "robot/hash.hpp"
#include "support/arms/guarded_arm.hpp"
#include "support/arms/image_in_parts.hpp"
#include "support/refused.hpp"
#include "support/same_view.hpp"
#include "support/test.hpp"

namespace {

std::string path_of(const NamedImage& image) {
  return FLASHBVH_ROBOT_IMAGES "/" + image.name + ".robot";
}

struct Opened {
  explicit Opened(const Words& words, std::uint32_t capacity = kMaxLinks)
      : meshes(kMaxLinks),
        status(open_robot(words.data(), size_of(words), meshes.data(), capacity, robot)) {}
  std::vector<Mesh> meshes;
  Robot robot{};
  Status status;
};

}  // namespace

TEST_CASE("an image opens as the robot that it was made of, and its guard answers the same") {
  for_rounds(3, [&](Random& random, int) {
    const FixedArm arm = any_guarded_arm(random, 3 + random.below(3), 1e-3);
    const Words words = image_of(arm);
    REQUIRE(words == image_of(arm));
    const Opened opened(words);
    REQUIRE(opened.status == Status::done);
    REQUIRE(same_view(arm.robot(), opened.robot));
    CHECK(std::string(robot_name(words.data())) == "arm");
    for (std::size_t i = 0; i < arm.model.joints.size(); ++i) {
      CHECK(joint_name(words.data(), static_cast<std::uint32_t>(i)) == arm.model.joints[i].name);
    }
    for (std::size_t i = 0; i < arm.model.links.size(); ++i) {
      CHECK(link_name(words.data(), static_cast<std::uint32_t>(i)) == arm.model.links[i].name);
    }
    REQUIRE(mount_count(words.data()) == arm.model.mounts.size());
    for (std::uint32_t i = 0; i < arm.model.mounts.size(); ++i) {
      const tool::ModelMount& mount = arm.model.mounts[i];
      const Mount& kept = mounts(words.data())[i];
      const Frame frame = tool::fixed_frame(mount.transform, arm.arm.cell());
      CHECK(mount_name(words.data(), i) == mount.name);
      CHECK((tool::joint_of(kept.joint) == mount.joint && same_array(&kept.frame, &frame, 1)));
    }
    const auto states = std::make_unique<AnyGuardState[]>(2);
    Guard of_arrays(arm.robot(), states[0]);
    Guard of_image(opened.robot, states[1]);
    Wandering wandering(arm, arm.any_values(random), 0.01);
    for (int i = 0; i < 100; ++i) {
      const Values values = wandering.step(random);
      const std::uint32_t work = i == 0 ? UINT32_MAX : 100;
      REQUIRE(test::are_same(of_arrays.update(values.data(), work),
                             of_image.update(values.data(), work)));
    }
  });
}

// For a new version of the format, or when bake builds other trees on purpose.
TEST_CASE("write the images that are kept", "[.]") {
  for (const NamedImage& image : arm_images()) {
    std::ofstream file(path_of(image), std::ios::binary);
    file.write(reinterpret_cast<const char*>(image.words.data()),
               static_cast<std::streamsize>(size_of(image.words)));
    CHECK(file.good());
  }
}

TEST_CASE("the images that are kept are baked to the byte, and harmless") {
  for (const NamedImage& image : arm_images()) {
    CAPTURE(image.name);
    std::ifstream file(path_of(image), std::ios::binary);
    const std::string kept{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    CHECK((kept.size() == size_of(image.words) &&
           std::memcmp(kept.data(), image.words.data(), kept.size()) == 0));
    const RobotVerdict verdict = exercise_any(image.words.data(), size_of(image.words));
    CHECK(verdict.status == Status::done);
    CHECK(verdict.wrong == nullptr);
  }
}

TEST_CASE(
    "an image that lost its end is refused, its size repaired or not; one with more is itself") {
  Words words = arm_images()[0].words;
  for (std::size_t size = 0; size < size_of(words); ++size) {
    REQUIRE(exercise_any(words.data(), size).status == Status::image_truncated);
  }
  for (std::size_t count = sizeof(RobotImageHeader) / 4; count < words.size(); ++count) {
    Words cut(words.data(), words.data() + count);
    Parts(cut).header.byte_count = static_cast<std::uint32_t>(size_of(cut));
    repair_robot(cut.data(), size_of(cut));
    const RobotVerdict verdict = exercise_any(cut.data(), size_of(cut));
    REQUIRE(verdict.status != Status::done);
    REQUIRE(verdict.wrong == nullptr);
  }
  words.push_back(0xFFFFFFFF);
  CHECK(Opened(words).status == Status::done);
  Parts(words).header.byte_count += 4;
  repair_robot(words.data(), size_of(words));
  CHECK(Opened(words).status == Status::image_invalid);
}

TEST_CASE("a flipped bit is refused, and neither the robot nor any of its meshes is open") {
  const Words whole = arm_images()[0].words;
  Words words = whole;
  const std::size_t meshes = detail::robot_meshes_offset(Parts(words).header);
  for (std::size_t bit = 0; bit < 8 * size_of(words); bit += bit < 8 * meshes ? 1 : 13) {
    CAPTURE(bit);
    words[bit / 32] ^= 1u << bit % 32;
    Opened opened(whole);
    REQUIRE(detail::is_open(opened.robot));
    REQUIRE(open_robot(words.data(), size_of(words), opened.meshes.data(), kMaxLinks,
                       opened.robot) != Status::done);
    REQUIRE((opened.robot.hash == 0 && opened.robot.joint_count == 0));
    for (std::size_t i = 0; bit % 97 == 0 && i < opened.meshes.size(); ++i) {
      REQUIRE(are_refused(opened.meshes[i], opened.meshes[i], Status::not_open));
    }
    words[bit / 32] ^= 1u << bit % 32;
  }
}

TEST_CASE("every flipped bit before the meshes, with checksum and hash that match, is harmless") {
  std::size_t opened = 0;
  for (const NamedImage& image : arm_images()) {
    Words words = image.words;
    const std::size_t meshes = detail::robot_meshes_offset(Parts(words).header);
    for (std::size_t bit = 0; bit < 8 * meshes; ++bit) {
      CAPTURE(image.name, bit);
      words = image.words;
      words[bit / 32] ^= 1u << bit % 32;
      repair_robot(words.data(), size_of(words));
      const RobotVerdict verdict = exercise_any(words.data(), size_of(words));
      REQUIRE(verdict.wrong == nullptr);
      opened += verdict.status == Status::done ? 1 : 0;
    }
  }
  CHECK(opened > 100);  // a changed limit, distance or translation may be valid
}

TEST_CASE("pairs that are not guarded are kept with the reason; one that no joint moves is none") {
  const Words& words = arm_images()[0].words;
  REQUIRE(unguarded_count(words.data()) == 2);
  const RobotUnguarded* const kept = unguarded_pairs(words.data());
  CHECK((kept[0].a == 0 && kept[0].b == 1 && kept[0].why == WhyUnguarded::zone));
  CHECK((kept[0].joint == 0 && kept[0].radius == 12800));  // 50 cells
  CHECK((kept[1].a == 2 && kept[1].b == 3 && kept[1].why == WhyUnguarded::believed));
  CHECK((kept[1].joint == kBase && kept[1].radius == 0));
  Model model;
  add_joint(model, tool::kNoJoint, {}, JointType::revolute, -1, 1);
  add_link(model, 0, box({0, 0, 0}, {0.1, 0.1, 0.1}));
  add_link(model, 0, box({0, 0, 0}, {0.1, 0.1, 0.1}));
  const FixedArm arm(model, 1e-3);
  CHECK_THROWS_AS(image_of(arm, {tool::UnguardedPair{0, 1, WhyUnguarded::believed}}),
                  std::logic_error);
}

TEST_CASE("an image at an address that is no multiple of 4, and with too little room for meshes") {
  const Words words = arm_images()[0].words;
  const std::uint32_t links = words[1] >> 24;
  CHECK(Opened(words, links).status == Status::done);
  CHECK(Opened(words, links - 1).status == Status::image_too_large);
  std::vector<unsigned char> bytes(size_of(words) + 4);
  for (std::size_t shift = 1; shift < 4; ++shift) {
    std::memcpy(bytes.data() + shift, words.data(), size_of(words));
    std::vector<Mesh> meshes(kMaxLinks);
    Robot robot{};
    CHECK(open_robot(bytes.data() + shift, size_of(words), meshes.data(), kMaxLinks, robot) ==
          Status::image_misaligned);
  }
}

TEST_CASE("no robot's hash is 0") {
  for (std::uint32_t i = 0; i < 256; ++i) {
    const auto byte = static_cast<unsigned char>(i);
    CHECK(detail::hash_of(&byte, 1, i) == 1);
  }
}

TEST_CASE("as many joints and links as there may be, and one joint more") {
  const Words whole = arm_images()[1].words;  // one link
  const auto opens_with = [&](std::uint8_t joints, std::uint8_t links) {
    Words source = whole;
    const Parts parts(source);
    Words made(sizeof(RobotImageHeader) / 4);
    const auto add = [&](const void* bytes, std::size_t size) {
      const auto* const first = static_cast<const std::uint32_t*>(bytes);
      made.insert(made.end(), first, first + size / 4);
    };
    RobotImageHeader header = parts.header;
    header.joint_count = header.variable_count = joints;
    header.link_count = links;
    header.mount_count = 0;
    header.names_size = static_cast<std::uint16_t>(1 + joints + links);
    for (std::uint8_t i = 0; i < joints; ++i) {
      const RobotJoint joint = {
          kIdentityFrame,      0, 1, 1, 0, 0, i == 0 ? kBase : static_cast<std::uint8_t>(i - 1), i,
          JointType::revolute, 0};
      add(&joint, sizeof joint);
    }
    for (std::uint8_t i = 0; i < links; ++i) {
      add(parts.links, sizeof(RobotLink));
    }
    made.resize((detail::robot_meshes_offset(header)) / 4);
    for (std::uint8_t i = 0; i < links; ++i) {
      add(parts.meshes, parts.mesh().byte_count);
    }
    header.byte_count = static_cast<std::uint32_t>(size_of(made));
    std::memcpy(made.data(), &header, sizeof header);
    repair_robot(made.data(), size_of(made));
    const RobotVerdict verdict = exercise_any(made.data(), size_of(made));
    CHECK(verdict.wrong == nullptr);
    return verdict.status;
  };
  CHECK(opens_with(0, 1) == Status::image_invalid);
  CHECK(opens_with(1, 1) == Status::done);
  CHECK(opens_with(kMaxJoints, kMaxLinks) == Status::done);
  CHECK(opens_with(kMaxJoints + 1, 1) == Status::image_invalid);
}
