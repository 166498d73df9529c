// Writes Differential.v: the library's results on random trees, whole and damaged, and the claim
// that the definitions of Code.v, Image.v and Exact.v give equal results.
#include <cstdio>

#include "flashbvh/detail/lattice/image_parts.hpp"
#include "proofs/walk/generated.hpp"

using namespace flashbvh;
using namespace flashbvh::test;

namespace {

constexpr const char* kHead = R"(From Coq Require Import List ZArith Bool.
Require Import Constants Ranked Code Query Image Triangle Rejects Exact.
Import ListNotations.
Definition make := map (fun c => let '(l, r, p) := c in
  {| c_link := Z.to_nat l; c_rank := r; c_parent_rank := p |}).
Definition passes (m k : Z) := negb (k mod m =? 0)%Z.
Definition bound (m : Z) (i j : nat) :=
  let a := Z.of_nat i in let b := Z.of_nat j in passes m (a * 7 + b * 11 + a * b + 1).
Definition begin_ (m : Z) (i j : nat) := passes m (Z.of_nat i * 5 + Z.of_nat j * 3 - 1).
Definition touch a b (m : Z) (s : Side) (i j : nat) :=
  let side := (match s with LeafA => 1 | _ => 2 end)%Z in
  passes m (Z.of_nat i * 3 + Z.of_nat j * 13 + side) &&
  if is_leaf a i && is_leaf b j then passes m (Z.of_nat i * 17 + Z.of_nat j * 5 + side - 1) else true.
Fixpoint visited_in a b m (n : nat) (c : Code) : list (nat * nat) * list (nat * nat) :=
  match n with
  | O => ([], [])
  | S k =>
      let rest := visited_in a b m k (code_turn a b (bound m) (begin_ m) (touch a b m) c) in
      match visited c with
      | None => rest
      | Some p => (p :: fst rest, if finds a b (bound m) (touch a b m) c then p :: snd rest else snd rest)
      end
  end.
Definition same := fix same (s t : list (nat * nat)) := match s, t with
  | [], [] => true | (a, b) :: s, (c, d) :: t => (a =? c) && (b =? d) && same s t | _, _ => false end.
Definition nats := map (fun p : Z * Z => (Z.to_nat (fst p), Z.to_nat (snd p))).
(* start: 0 from the roots, 1 from a pair, 2 from behind it *)
Definition walks a b (m start i j : Z) visits found :=
  let a := make a in let b := make b in
  let p := (Z.to_nat i, Z.to_nat j) in
  let c := if (start =? 0)%Z then begin_walk a b else resume_walk a b (start =? 1)%Z p in
  let (v, f) := visited_in a b m 3000 c in same v (nats visits) && same f (nats found).
Local Open Scope Z_scope.
(* A leaf's box, to a cube's sides, its triangle and its baked slabs. *)
Definition leaf_opens (reach : Z) (p q r : Point) (slabs : list Baked) := opens {|
  cells := [ {| c_link := 1; c_rank := -1; c_parent_rank := 0 |} ];
  box _ := {| low := Build_Point (- reach) (- reach) (- reach); high := Build_Point reach reach reach |};
  corners _ := (p, q, r); own_triangles _ := [0%nat]; directions _ := []; baked _ := slabs |}.
)";

int parent_rank_of(const ModelNode& node) {
  return node.is_leaf() ? 0 : node.parent_rank();
}

void print(const std::vector<ModelNode>& nodes) {
  std::printf("[");
  for (size_t i = 0; i < nodes.size(); ++i) {
    std::printf("%s(%u,%d,%d)", i != 0 ? ";" : "", nodes[i].link, nodes[i].rank(),
                parent_rank_of(nodes[i]));
  }
  std::printf("]");
}

void print(const std::vector<NodePair>& pairs) {
  std::printf("[");
  for (size_t i = 0; i < pairs.size(); ++i) {
    std::printf("%s(%u,%u)", i != 0 ? ";" : "", pairs[i].first, pairs[i].second);
  }
  std::printf("]");
}

void claim() {
  std::printf(" = true. Proof. vm_compute. reflexivity. Qed.\n");
}

void write_walk(Random& random) {
  const GeneratedTree a = GeneratedTree::random(random);
  const GeneratedTree b = GeneratedTree::random(random);
  const PairTests tests{2 + random.below(30)};
  detail::PairCursor<uint16_t> cursor;
  detail::State state = detail::State::fresh;
  if (random.below(3) != 0) {
    const detail::PairCursor<uint16_t> any = {
        static_cast<uint16_t>(random.below(static_cast<uint32_t>(a.nodes.size()))),
        static_cast<uint16_t>(random.below(static_cast<uint32_t>(b.nodes.size())))};
    if (Ranked<ModelTree>::can_visit(a.view(), b.view(), any)) {
      cursor = any;
      state = random.below(2) != 0 && any.a + any.b != 0 ? detail::State::at_pair
                                                         : detail::State::at_leaf_pair;
    }
  }
  std::printf("Goal walks ");
  print(a.nodes);
  std::printf(" ");
  print(b.nodes);
  std::printf(" %u %d %u %u ", tests.modulus, static_cast<int>(state), cursor.a, cursor.b);
  Walked walked;
  const uint32_t work = 1 + random.below(30);
  walk_on<Ranked<ModelTree>>(a.view(), b.view(), tests, work, 1 + random.below(4), cursor, state,
                             walked, true);
  print(walked.visits);
  std::printf(" ");
  print(walked.found);
  claim();
}

/// Whether opening an image accepts these nodes, with everything else valid. Each leaf has a
/// triangle of three vertices.
bool library_accepts(const std::vector<ModelNode>& nodes, uint32_t leaves,
                     const Vertex (&vertices)[3], const LeafSlabs* slabs) {
  static const uint16_t shell = 0;
  const std::vector<Corners<uint16_t>> triangles(leaves + 1, {{0, 1, 2}});
  Mesh mesh = {};
  mesh.slabs = slabs;
  mesh.nodes = nodes.data();
  mesh.node_count = static_cast<uint16_t>(nodes.size());
  mesh.leaf_count = mesh.triangle_count = static_cast<uint16_t>(leaves);
  mesh.triangles = triangles.data();
  mesh.vertices = vertices;
  mesh.vertex_count = 3;
  mesh.shell_count = 1;
  mesh.shell_vertices = &shell;
  detail::TreeShape shape;
  return detail::check_tree(mesh, {}, shape) == Status::done;
}

bool write_check(Random& random) {
  std::vector<ModelNode> nodes = GeneratedTree::random(random).nodes;
  const auto count = static_cast<uint32_t>(nodes.size());
  uint32_t leaves = 0;
  for (ModelNode& node : nodes) {
    node.box = pack({{0, 0, 0}, {0, 0, 0}});
    if (node.is_leaf()) {
      node.data = static_cast<uint16_t>(ModelNode::kLeafFlag | leaves++);
    }
  }
  for (uint32_t damage = random.below(3); damage != 0; --damage) {
    ModelNode& node = nodes[random.below(count)];
    if (node.is_leaf() || random.below(3) != 0) {
      node.link = static_cast<uint16_t>(random.below(count + 2));
    } else {
      const uint32_t rank = random.below(128);
      node.data = static_cast<uint16_t>(rank << 8 | random.below(128));
    }
  }
  const bool accepted = library_accepts(nodes, leaves, {}, nullptr);
  std::printf("Goal eqb %s (accepts (make ", accepted ? "true" : "false");
  print(nodes);
  std::printf(") (fun _ _ => true))");
  claim();
  return accepted;
}

bool write_slabs(Random& random) {
  const auto most = random.one_of<int16_t>({2, 40, 3000, kMaxCoordinate});
  const auto least = static_cast<int16_t>(-most);
  const ModelNode leaf = {pack({{least, least, least}, {most, most, most}}), 1,
                          ModelNode::kLeafFlag};
  const auto coordinate = [&] {
    return static_cast<int16_t>(random.between(least, most) + (random.below(200) == 0 ? 1 : 0));
  };
  Vertex v[3];
  for (Vertex& at : v) {
    at = {coordinate(), coordinate(), coordinate()};
  }
  const auto byte = [&] { return static_cast<int8_t>(random.between(-128, 127)); };
  LeafSlabs slabs;
  for (int i = 0; i < 2; ++i) {
    const uint32_t thickness = random.below(256);
    slabs.of[i] = {byte(), byte(), byte(), static_cast<uint8_t>(thickness)};
    const auto half = static_cast<int32_t>((thickness & 31) << 2 * (thickness >> 5)) / 2;
    slabs.least[i] = static_cast<int16_t>(random.between(-2, 2) - half);
  }
  const bool accepted = library_accepts({leaf}, 1, v, &slabs);
  std::printf("Goal eqb %s (leaf_opens %d", accepted ? "true" : "false", most);
  for (const Vertex& at : v) {
    std::printf(" (Build_Point (%d) (%d) (%d))", at.x, at.y, at.z);
  }
  for (int i = 0; i < 2; ++i) {
    const LeafSlabs::Direction& d = slabs.of[i];
    std::printf("%s Build_Baked (Build_Point (%d) (%d) (%d)) %d (%d)", i == 0 ? " [" : ";", d.x,
                d.y, d.z, d.thickness, slabs.least[i]);
  }
  std::printf("])");
  claim();
  return accepted;
}

}  // namespace

int main() {
  Random random(1);
  std::fputs(kHead, stdout);
  for (int i = 0; i < 300; ++i) {
    write_walk(random);
  }
  for (const auto& write : {write_check, write_slabs}) {
    constexpr int kChecks = 600;
    int accepted = 0;
    for (int i = 0; i < kChecks; ++i) {
      accepted += write(random) ? 1 : 0;
    }
    if (accepted < kChecks / 10 || accepted > kChecks * 9 / 10) {
      return 1;
    }
  }
}
