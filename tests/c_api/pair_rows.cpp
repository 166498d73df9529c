// Meshes, poses, pairs of triangles, time bounds.
#include <iterator>

#include "c_api/scene.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "support/rotations.hpp"
#include "support/same_view.hpp"

namespace flashbvh::test {
namespace {

/// Changes a word of the image, with or without a repaired checksum; cuts it; misaligns it.
bool damage_agrees(Scene& s) {
  const std::size_t count = s.a.image.size();
  auto* bytes = reinterpret_cast<unsigned char*>(s.damaged.data());
  std::memcpy(bytes, s.a.image.data(), s.a.size());
  const std::size_t of_header = s.random.below(2) == 0 ? 3 : count;
  const std::uint32_t word = s.random.below(static_cast<std::uint32_t>(of_header));
  s.damaged[word] ^= 1u << s.random.below(32);
  if (s.random.below(2) == 0) {
    s.damaged[offsetof(ImageHeader, crc) / 4] = image_crc(s.damaged.data(), 4 * count);
  }
  const std::size_t size = s.random.below(6) == 0 ? s.random.below(999) % s.a.size() : s.a.size();
  if (s.random.below(6) == 0) {
    std::memmove(bytes + 2, bytes, s.a.size());
    bytes += 2;
  }
  Mesh wanted;
  flashbvh_mesh found;
  const flashbvh_mesh not_open{};
  flashbvh_tree_size tree;
  ImageHeader header;
  wipe(found);
  const Status status = open_image(bytes, size, wanted);
  return same(flashbvh_open(bytes, size, &found), status) &&
         same(flashbvh_image_tree_size(bytes, size, &tree),
              read_image_header(bytes, size, header)) &&
         (status == Status::done || same(found.opaque.bytes, not_open.opaque.bytes));
}

bool damages_agree(Scene& s) {
  bool agree = true;
  for (int i = 0; i < 20; ++i) {
    agree = agree && damage_agrees(s);
  }
  return agree;
}

bool mesh_agrees(Scene& s) {
  const Mesh& mesh = s.a.mesh;
  flashbvh_mesh found;
  flashbvh_view_unchecked(s.a.image.data(), &found);
  Mesh seen;
  std::memcpy(&seen, &found, sizeof seen);
  return same_view(seen, mesh) &&
         flashbvh_mesh_cells_per_unit(&s.a.c) == cells_per_unit(mesh.cell_bits) &&
         flashbvh_mesh_unit(&s.a.c) == static_cast<flashbvh_unit>(mesh.unit) &&
         flashbvh_mesh_is_closed(&s.a.c) == mesh.is_closed;
}

/// Sometimes with a float that is not a number, or a scaled rotation.
bool float_poses_agree(Scene& s) {
  float rows[3][3];
  for (int i = 0; i < 9; ++i) {
    rows[i / 3][i % 3] = static_cast<float>(s.pose.rotation(i / 3, i % 3)) / kRotationOne;
  }
  rows[1][1] += s.random.below(4) == 0 ? 0.01f : 0;
  const float x = static_cast<float>(s.random.between(-9999, 9999)) / 7;
  const float at[3] = {x, -0.25f, s.random.below(4) == 0 ? 1e30f : 3};
  const float scale = static_cast<float>(s.random.between(0, 1000)) / 3;
  const Pose wanted = pose_of(rows, at, scale);
  flashbvh_pose made;
  return same(flashbvh_pose_of_matrix(rows[0], at, scale, &made), wanted.status()) &&
         same(made, wanted);
}

/// Also in place, into each argument.
bool relative_poses_agree(Scene& s) {
  const Pose other = any_rigid_pose(s.random, 20);
  const Pose wanted = Pose::relative(s.pose, other);
  const flashbvh_pose c_other = c_pose_of(other);
  flashbvh_pose first = s.c_pose;
  flashbvh_pose second = c_other;
  return same(c_other, other) &&
         same(flashbvh_pose_relative(&first, &c_other, &first), wanted.status()) &&
         same(first, wanted) &&
         same(flashbvh_pose_relative(&s.c_pose, &second, &second), wanted.status()) &&
         same(second, wanted);
}

/// A query in runs of any work and capacity; between them it moves in memory, or to another query
/// by its cursor, after a cursor that may be invalid.
class Slices {
 public:
  explicit Slices(Scene& scene) : s_(scene), query_(started()) {}

  bool agree() {
    bool agrees = same(start(), query_.status());
    for (bool goes_on = true; agrees && goes_on;) {
      const std::uint32_t work = s_.any_work();
      const std::uint32_t capacity = s_.random.below(kMost + 1);
      flashbvh_pair wanted[kMost];
      flashbvh_pair found[kMost];
      const RunResult step = query_.run(work, wanted, capacity);
      agrees = same(flashbvh_query_run(&c_, work, found, capacity), step) &&
               same(found, wanted, step.count) && contact_agrees(step);
      goes_on = step.status == Status::suspended || step.status == Status::full;
      agrees = agrees && (!goes_on || move());
    }
    return agrees;
  }

 private:
  static constexpr std::uint32_t kMost = 8;

  PairQuery started() { return PairQuery(s_.a.mesh, s_.b.mesh, s_.pose); }
  flashbvh_status start() { return flashbvh_query_start(&c_, &s_.a.c, &s_.b.c, &s_.c_pose); }

  bool contact_agrees(const RunResult& step) {
    flashbvh_contact found;
    if (step.status != Status::full || step.count == 0) {
      return true;
    }
    flashbvh_query_last_contact(&c_, &found);
    return same(found, contact_of_last(query_));
  }

  bool move() {
    flashbvh_query copy = c_;
    PairQuery other = query_;
    const flashbvh_cursor at = flashbvh_query_cursor(&c_);
    auto wrong = query_.cursor();
    flashbvh_cursor c_wrong = at;
    c_wrong.untested ^= static_cast<std::uint16_t>(s_.random.below(2));
    c_wrong.a += static_cast<std::uint16_t>(s_.random.below(3));
    wrong.untested = c_wrong.untested;
    wrong.a = c_wrong.a;
    wipe(c_);
    c_ = copy;
    if (s_.random.below(2) == 0) {
      return same(flashbvh_query_resume(&copy, &c_wrong), other.resume(wrong));
    }
    PairQuery again = started();
    (void)again.resume(query_.cursor());
    query_ = again;
    wipe(c_);
    (void)start();
    return same(flashbvh_query_resume(&c_, &at), query_.status());
  }

  Scene& s_;
  PairQuery query_;
  flashbvh_query c_;
};

bool calls_agree(Scene& s) {
  bool yes = false;
  flashbvh_pair wanted[3];
  flashbvh_pair found[3];
  const RunResult some = find_pairs(s.a.mesh, s.b.mesh, s.pose, wanted, 3);
  const flashbvh_status c = flashbvh_intersects(&s.a.c, &s.b.c, &s.c_pose, &yes);
  return same(c, yes, intersects(s.a.mesh, s.b.mesh, s.pose)) &&
         same(flashbvh_find_pairs(&s.a.c, &s.b.c, &s.c_pose, found, 3), some) &&
         same(found, wanted, some.count);
}

bool lengths_agree(Scene& s) {
  const std::int64_t fine = s.random.between(INT32_MIN / 2, 9999);
  const auto length = static_cast<float>(s.random.between(-10, 100000)) / 7;
  return flashbvh_length_in_unit(fine, &s.a.c) == length_in_unit(fine, s.a.mesh.cell_bits) &&
         flashbvh_fine_length_rounded_up(length, 3).count ==
             fine_length_rounded_up(length, 3).count;
}

bool bounds_agree(Scene& s) {
#define OF_CPP(core, ...) k##core,
#define OF_C(core, c_name, ...) &flashbvh_##c_name,
  const RunCosts costs[] = {FLASHBVH_FOR_EACH_CORE(OF_CPP)};
  const flashbvh_run_costs* const c_costs[] = {FLASHBVH_FOR_EACH_CORE(OF_C)};
#undef OF_CPP
#undef OF_C
  const std::uint32_t core = s.random.below(std::uint32_t{std::size(costs)});
  const std::uint64_t instructions = s.random.below(1000000);
  ImageHeader of_a;
  flashbvh_tree_size a;
  const Status read = read_image_header(s.a.image.data(), s.a.size(), of_a);
  return same(flashbvh_image_tree_size(s.a.image.data(), s.a.size(), &a), read) &&
         same(a, tree_size_of(of_a)) && same(*c_costs[core], costs[core]) &&
         flashbvh_work_within(instructions, c_costs[core], &a, &a) ==
             work_within(instructions, costs[core], a, a);
}

bool names_agree(Scene& s) {
  const auto status = static_cast<flashbvh_status>(s.random.below(64));
  return flashbvh_status_name(status) == status_name(static_cast<Status>(status)) &&
         std::strcmp(flashbvh_status_name(FLASHBVH_STATUS_HINT_INVALID), "hint_invalid") == 0;
}

}  // namespace

std::vector<Row> pair_rows() {
  return {{"images, damaged", damages_agree},
          {"facts of a mesh", mesh_agrees},
          {"poses of floats", float_poses_agree},
          {"relative poses", relative_poses_agree},
          {"a query in slices", [](Scene& s) { return Slices(s).agree(); }},
          {"queries in one call", calls_agree},
          {"lengths", lengths_agree},
          {"time bounds", bounds_agree},
          {"names of statuses", names_agree}};
}

}  // namespace flashbvh::test
