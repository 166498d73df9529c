// Meshes, queries, contacts, time bounds.
#include <iterator>

#include "c_api/slices.hpp"
#include "flashbvh/contact.hpp"
#include "flashbvh/float.hpp"
#include "flashbvh/image.hpp"
#include "flashbvh/time_bound.hpp"
#include "flashbvh/units.hpp"
#include "support/same_view.hpp"

namespace flashbvh::test {
namespace {

struct PairFunctions {
  using Struct = flashbvh_query;
  static constexpr bool kVisits = true;
  static PairQuery query(Scene& s) { return PairQuery(s.a.mesh, s.b.mesh, s.pose); }
  static flashbvh_status start(Struct* c, Scene& s) {
    return flashbvh_query_start(c, &s.a.c, &s.b.c, &s.c_pose);
  }
  static const QueryStats& counts_of(const PairQuery& query) { return query.stats(); }
  static constexpr auto status = flashbvh_query_status;
  static constexpr auto run = flashbvh_query_run;
  static constexpr auto visit = flashbvh_query_visit;
  static constexpr auto counts = flashbvh_query_stats;
  static constexpr auto position = flashbvh_query_cursor;
  static constexpr auto resume = flashbvh_query_resume;
  static constexpr auto last_pair = flashbvh_query_last_pair;
};

/// Changes a word of the image, with or without a repaired checksum; cuts it; misaligns it.
bool damage_agrees(Scene& s) {
  const std::size_t count = s.a.image.size();
  auto* bytes = reinterpret_cast<unsigned char*>(s.damaged.data());
  std::memcpy(bytes, s.a.image.data(), s.a.size());
  const std::size_t of_header = s.random.below(2) == 0 ? 3 : count;
  s.damaged[s.random.below(static_cast<std::uint32_t>(of_header))] ^= 1u << s.random.below(32);
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

bool views_agree(const Scene& s) {
  flashbvh_mesh found;
  flashbvh_view_unchecked(s.a.image.data(), &found);
  Mesh seen;
  std::memcpy(&seen, &found, sizeof seen);
  return same_view(seen, s.a.mesh);
}

bool mesh_agrees(Scene& s) {
  const Mesh& mesh = s.a.mesh;
  std::int32_t origin[3];
  flashbvh_mesh_origin(&s.a.c, origin);
  return same(origin, mesh.origin) && flashbvh_mesh_triangles(&s.a.c) == mesh.triangle_count &&
         flashbvh_mesh_cell(&s.a.c) == mesh.cell_bits &&
         flashbvh_mesh_cells_per_unit(&s.a.c) == cells_per_unit(mesh.cell_bits) && views_agree(s) &&
         flashbvh_mesh_unit(&s.a.c) == static_cast<flashbvh_unit>(mesh.unit) &&
         flashbvh_mesh_is_closed(&s.a.c) == mesh.is_closed;
}

bool visits_agree(Scene& s) {
  Kept wanted = {1 + s.random.below(40), 0, {}};
  Kept found = wanted;
  const Status status = for_each_pair(
      s.a.mesh, s.b.mesh, s.pose, [&](const flashbvh_pair& pair) { return keep(pair, &wanted); });
  return same(flashbvh_for_each_pair(&s.a.c, &s.b.c, &s.c_pose, keep, &found), status) &&
         same(found, wanted);
}

bool first_pair_agrees(Scene& s) {
  flashbvh_pair wanted = {0xABCD, 0xDCBA};  // unchanged if there is no pair
  flashbvh_pair found = wanted;
  bool yes = false;
  const Answer answer = first_pair(s.a.mesh, s.b.mesh, s.pose, wanted);
  return same(flashbvh_first_pair(&s.a.c, &s.b.c, &s.c_pose, &yes, &found), answer.status) &&
         yes == answer.yes && same(found, wanted);
}

bool intersects_agrees(Scene& s) {
  bool yes = false;
  const Answer answer = intersects(s.a.mesh, s.b.mesh, s.pose);
  return same(flashbvh_intersects(&s.a.c, &s.b.c, &s.c_pose, &yes), answer.status) &&
         yes == answer.yes;
}

bool hinted_agrees(Scene& s) {
  Witness<std::uint16_t> hint;
  flashbvh_witness c_hint = FLASHBVH_NO_WITNESS;
  if (s.random.below(4) != 0) {  // sometimes beyond the last triangle
    hint.a = c_hint.a = static_cast<std::uint16_t>(s.random.below(s.a.mesh.triangle_count + 1));
    hint.b = c_hint.b = static_cast<std::uint16_t>(s.random.below(s.b.mesh.triangle_count + 1));
  }
  for (int step = 0; step < 2; ++step) {
    bool yes = false;
    const Answer answer = intersects(s.a.mesh, s.b.mesh, s.pose, hint);
    if (!same(flashbvh_intersects_hinted(&s.a.c, &s.b.c, &s.c_pose, &c_hint, &yes),
              answer.status) ||
        yes != answer.yes || !same(c_hint, hint)) {
      return false;
    }
  }
  return true;
}

bool pairs_agree(Scene& s) {
  flashbvh_pair wanted[3];
  flashbvh_pair found[3];
  const RunResult some = find_pairs(s.a.mesh, s.b.mesh, s.pose, wanted, 3);
  return same(flashbvh_count_pairs(&s.a.c, &s.b.c, &s.c_pose),
              count_pairs(s.a.mesh, s.b.mesh, s.pose)) &&
         same(flashbvh_find_pairs(&s.a.c, &s.b.c, &s.c_pose, found, 3), some) &&
         same(found, wanted, some.count);
}

/// The contact of each pair: from the query, and at any later time.
bool contacts_agree(Scene& s) {
  PairQuery query(s.a.mesh, s.b.mesh, s.pose);
  flashbvh_query c_query;
  flashbvh_pair pair[1];
  (void)flashbvh_query_start(&c_query, &s.a.c, &s.b.c, &s.c_pose);
  Triangle none[2];
  bool agree = query.status() == Status::suspended ||
               !flashbvh_transform_pair(&s.a.c, &s.b.c, &s.c_pose, {0, 0}, &none[0], &none[1]);
  while (agree && query.run(UINT32_MAX, pair).status == Status::full) {
    Triangle a;
    Triangle b;
    flashbvh_triangle c_a;
    flashbvh_triangle c_b;
    flashbvh_contact last;
    flashbvh_contact again;
    query.last_pair(a, b);
    agree = flashbvh_query_run(&c_query, UINT32_MAX, pair, 1).status == Status::full &&
            flashbvh_transform_pair(&s.a.c, &s.b.c, &s.c_pose, pair[0], &c_a, &c_b);
    flashbvh_query_last_contact(&c_query, &last);
    flashbvh_contact_of(&c_a, &c_b, &again);
    agree = agree && same(c_a, a) && same(c_b, b) && same(last, contact_of(a, b)) &&
            same(again, contact_of(a, b));
  }
  return agree;
}

/// By a query and a contact, and in C.
bool first_contact_agrees(Scene& s) {
  flashbvh_pair pair[1] = {};
  PairQuery query(s.a.mesh, s.b.mesh, s.pose);
  const Status status = query.run(UINT32_MAX, pair).status;
  const UnitContact<std::uint16_t> found = first_contact(s.a.mesh, s.b.mesh, s.pose);
  flashbvh_unit_contact c;
  if (found.yes != (status != Status::done) ||
      !same(flashbvh_first_contact(&s.a.c, &s.b.c, &s.c_pose, &c), found.status) ||
      c.yes != found.yes) {
    return false;
  }
  if (status != Status::full) {
    return found.status == status;
  }
  const Contact wanted = contact_of_last(query);
  const UnitPoint end = in_unit(wanted.ends[1], s.a.mesh.cell_bits);
  return found.status == Status::done && same(found.normal_a, wanted.normal_a) &&
         same(found.normal_b, wanted.normal_b) && same(c.normal_b, wanted.normal_b) &&
         same(found.triangles, pair[0]) && same(c.triangles, pair[0]) && found.ends[1].x == end.x &&
         found.ends[1].y == end.y && found.ends[1].z == end.z && c.ends[1].x == end.x &&
         c.ends[0].z == found.ends[0].z;
}

bool lengths_agree(Scene& s) {
  const FinePoint p = {s.random.between(-9999, 9999), s.random.between(INT32_MIN / 2, 0), 1};
  const std::uint64_t cell = s.a.mesh.cell_bits;
  const UnitPoint wanted = in_unit(p, cell);
  const std::int64_t whole[3] = {millionths_of(p.x, cell), millionths_of(p.y, cell),
                                 millionths_of(p.z, cell)};
  const auto length = static_cast<float>(s.random.between(-10, 100000)) / 7;
  float at[3];
  std::int64_t millionths[3];
  flashbvh_in_unit(&p, &s.a.c, at);
  flashbvh_in_millionths(&p, &s.a.c, millionths);
  return at[0] == wanted.x && at[1] == wanted.y && at[2] == wanted.z && same(millionths, whole) &&
         flashbvh_length_in_unit(p.y, &s.a.c) == length_in_unit(p.y, cell) &&
         flashbvh_fine_length_rounded_up(length, 3).count ==
             fine_length_rounded_up(length, 3).count;
}

bool bounds_agree(Scene& s) {
#define OF_CPP(core, ...) k##core,
#define OF_C(core, c_name, ...) &flashbvh_##c_name,
#define CYCLES_OF_CPP(core, ...) k##core##Cycles,
#define CYCLES_OF_C(core, c_name, ...) &flashbvh_##c_name##_cycles,
  const RunCosts costs[] = {FLASHBVH_FOR_EACH_CORE(OF_CPP)};
  const flashbvh_run_costs* const c_costs[] = {FLASHBVH_FOR_EACH_CORE(OF_C)};
  const RunCycles cycles[] = {FLASHBVH_FOR_EACH_CORE_IN_CYCLES(CYCLES_OF_CPP)};
  const flashbvh_run_cycles* const c_cycles[] = {FLASHBVH_FOR_EACH_CORE_IN_CYCLES(CYCLES_OF_C)};
#undef OF_CPP
#undef OF_C
#undef CYCLES_OF_CPP
#undef CYCLES_OF_C
  const std::uint32_t in_cycles = s.random.below(std::uint32_t{std::size(cycles)});
  const std::uint32_t wait_states = s.random.below(8);
  const std::uint32_t core = s.random.below(std::uint32_t{std::size(costs)});
  const std::uint64_t instructions = s.random.below(1000000);
  const std::uint32_t work = s.random.below(10000);
  ImageHeader of_a;
  ImageHeader of_b;
  flashbvh_tree_size a;
  flashbvh_tree_size b;
  const Status read = read_image_header(s.a.image.data(), s.a.size(), of_a);
  (void)read_image_header(s.b.image.data(), s.b.size(), of_b);
  return same(flashbvh_image_tree_size(s.a.image.data(), s.a.size(), &a), read) &&
         same(flashbvh_image_tree_size(s.b.image.data(), s.b.size(), &b), Status::done) &&
         same(a, tree_size_of(of_a)) && same(*c_costs[core], costs[core]) &&
         flashbvh_work_within(instructions, c_costs[core], &a, &b) ==
             work_within(instructions, costs[core], a, b) &&
         flashbvh_most_instructions(c_costs[core], &a, &b, work) ==
             most_instructions(costs[core], a, b, work) &&
         same(*c_cycles[in_cycles], cycles[in_cycles]) &&
         flashbvh_work_within_cycles(instructions, c_cycles[in_cycles], wait_states, &a, &b) ==
             work_within(instructions, cycles[in_cycles], wait_states, a, b) &&
         flashbvh_most_cycles(c_cycles[in_cycles], wait_states, &a, &b, work) ==
             most_cycles(cycles[in_cycles], wait_states, a, b, work) &&
         flashbvh_most_work(&a, &b) == most_work(a, b) &&
         flashbvh_largest_step(&a, &b) == largest_step(a, b);
}

bool names_agree(Scene& s) {
  const auto status = static_cast<flashbvh_status>(s.random.below(64));
  return flashbvh_status_name(status) == status_name(static_cast<Status>(status)) &&
         std::strcmp(flashbvh_status_name(FLASHBVH_STATUS_HINT_INVALID), "hint_invalid") == 0;
}

}  // namespace

std::vector<Row> query_rows() {
  return {{"images, damaged", damages_agree},
          {"what a mesh says", mesh_agrees},
          {"a query in slices", [](Scene& s) { return Slices<PairFunctions>(s).agree(); }},
          {"each pair, to a visitor", visits_agree},
          {"the first pair", first_pair_agrees},
          {"whether triangles intersect, with a hint", hinted_agrees},
          {"whether there is one", intersects_agrees},
          {"how many pairs", pairs_agree},
          {"contacts", contacts_agree},
          {"first contact", first_contact_agrees},
          {"lengths", lengths_agree},
          {"time bounds", bounds_agree},
          {"names of statuses", names_agree}};
}

}  // namespace flashbvh::test
