(* The paper's stackless algorithm on post-indexed trees, lib/include/flashbvh/traversal/stackless.hpp: it makes the visits of the
   recursion that descends into both trees alternately. Any number of children.

   This rule is a rule of ranks: -2 level, and less 1 in A. So Ranked.v gives the order. This file proves that next(),
   which jumps up both trees at once, equals Ranked.v's turns, a step up at a time.

   Part 1  definitions.   Part 2  the theorems.   Part 3  their proofs. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants Ranked Code.
Import ListNotations.
Local Open Scope nat_scope.

(* ============================================================== Part 1: definitions *)

(* Levels and right child levels, as in BasicMeshWithLevels. *)
Record Levelled (children : nat -> list nat) (count : nat) (levels rcls : list nat) : Prop := {
  level_count : length levels = count;
  rcl_count : length rcls = count;
  level_of_root : nth 0 levels 0 = 0;
  level_of_kid : forall n x, In x (children n) -> nth x levels 0 = S (nth n levels 0);
  rcl_of_root : nth 0 rcls 0 = 0;
  rcl_of_last : forall n l x, children n = l ++ [x] -> nth x rcls 0 = S (nth n rcls 0);
  rcl_of_other : forall n l x y r, children n = l ++ x :: y :: r -> nth x rcls 0 = 0
}.

(* A read outside an array, or a level above the root, gives None. *)
Notation "'let*' x := e 'in' f" := (match e with Some x => f | None => None end)
  (at level 200, x pattern, f at level 200).

Record Mesh := { cells : list Cell; levels : list nat; rcls : list nat }.

Section Mesh.
Variable m : Mesh.
Definition level (i : nat) : nat := nth i (levels m) 0.
Definition rcl (i : nat) : nat := nth i (rcls m) 0.
Definition link (i : nat) : option nat := option_map c_link (nth_error (cells m) i).
Definition leaf_at (i : nat) : option bool :=
  option_map (fun c => (c_rank c <? 0)%Z) (nth_error (cells m) i).
(* code: include/flashbvh/mesh.hpp | return layout == Layout::pre_indexed ? node + 1 : nodes[node + 1].link; *)
Definition first_child (i : nat) : option nat := link (i + 1).
(* code: include/flashbvh/traversal/levels.hpp | uint32_t level_up(uint32_t node, uint32_t count) const { return node - count; } *)
Definition level_up (i count : nat) : option nat := if count <=? i then Some (i - count) else None.
(* code: include/flashbvh/traversal/levels.hpp | const uint32_t left_child = node - rcl; node = this->nodes[left_child].link; return left_child; *)
Definition escape_from (i rcl : nat) : option (nat * nat) :=
  let* left_child := level_up i rcl in
  let* to := link left_child in Some (to, left_child).
End Mesh.

Section Walk.
Variables a_ b_ : Mesh.
Variable overlap : nat -> nat -> bool.  (* the test of a pair: any predicate *)

Record At := { at_a : nat; at_b : nat; lead : Z }.
Inductive Turned := Goes (to : At) | Ends.

(* code: include/flashbvh/traversal/stackless.hpp | if ((lead_ < 0 || leaf_b) && !node_a().is_leaf()) { a_ = tree_a_.first_child(a_); ++lead_; return true; } *)
(* code: include/flashbvh/traversal/stackless.hpp | if (!leaf_b) { b_ = tree_b_.first_child(b_); --lead_; return true; } return false; *)
Definition descend (s : At) : option (option At) :=
  let* leaf_a := leaf_at a_ (at_a s) in
  let* leaf_b := leaf_at b_ (at_b s) in
  if ((lead s <? 0)%Z || leaf_b) && negb leaf_a then
    let* a := first_child a_ (at_a s) in
    Some (Some {| at_a := a; at_b := at_b s; lead := lead s + 1 |})
  else if negb leaf_b then
    let* b := first_child b_ (at_b s) in
    Some (Some {| at_a := at_a s; at_b := b; lead := lead s - 1 |})
  else Some None.

Definition goes (left_child a b : nat) (l : Z) : option Turned :=
  Some (if left_child =? 0 then Ends else Goes {| at_a := a; at_b := b; lead := l |}).

(* code: include/flashbvh/traversal/stackless.hpp | if (rcl_a <= lead) { *)
(* code: include/flashbvh/traversal/stackless.hpp | lead_ -= static_cast<int32_t>(rcl_a); return tree_a_.escape_from(a_, rcl_a); *)
(* code: include/flashbvh/traversal/stackless.hpp | if (rcl_a - lead <= rcl_b) { *)
(* code: include/flashbvh/traversal/stackless.hpp | b_ = tree_b_.level_up(b_, rcl_a - lead); lead_ = 0; return tree_a_.escape_from(a_, rcl_a); *)
(* code: include/flashbvh/traversal/stackless.hpp | a_ = tree_a_.level_up(a_, lead + rcl_b + 1); lead_ = -1; return tree_b_.escape_from(b_, rcl_b); *)
Definition next_of_a (s : At) : option Turned :=
  let l := Z.to_nat (lead s) in
  let* rcl_a := nth_error (rcls a_) (at_a s) in
  if rcl_a <=? l then
    let* (a, left_child) := escape_from a_ (at_a s) rcl_a in
    goes left_child a (at_b s) (lead s - Z.of_nat rcl_a)
  else
    let* rcl_b := nth_error (rcls b_) (at_b s) in
    if rcl_a - l <=? rcl_b then
      let* b := level_up (at_b s) (rcl_a - l) in
      let* (a, left_child) := escape_from a_ (at_a s) rcl_a in goes left_child a b 0
    else
      let* a := level_up (at_a s) (l + rcl_b + 1) in
      let* (b, left_child) := escape_from b_ (at_b s) rcl_b in goes left_child a b (-1).

(* code: include/flashbvh/traversal/stackless.hpp | if (rcl_b < lag) { *)
(* code: include/flashbvh/traversal/stackless.hpp | lead_ += static_cast<int32_t>(rcl_b); return tree_b_.escape_from(b_, rcl_b); *)
(* code: include/flashbvh/traversal/stackless.hpp | if (rcl_a <= rcl_b - lag) { *)
(* code: include/flashbvh/traversal/stackless.hpp | b_ = tree_b_.level_up(b_, rcl_a + lag); lead_ = 0; return tree_a_.escape_from(a_, rcl_a); *)
(* code: include/flashbvh/traversal/stackless.hpp | a_ = tree_a_.level_up(a_, rcl_b - lag + 1); lead_ = -1; return tree_b_.escape_from(b_, rcl_b); *)
Definition next_of_b (s : At) : option Turned :=
  let lag := Z.to_nat (- lead s) in
  let* rcl_b := nth_error (rcls b_) (at_b s) in
  if rcl_b <? lag then
    let* (b, left_child) := escape_from b_ (at_b s) rcl_b in
    goes left_child (at_a s) b (lead s + Z.of_nat rcl_b)
  else
    let* rcl_a := nth_error (rcls a_) (at_a s) in
    if rcl_a <=? rcl_b - lag then
      let* b := level_up (at_b s) (rcl_a + lag) in
      let* (a, left_child) := escape_from a_ (at_a s) rcl_a in goes left_child a b 0
    else
      let* a := level_up (at_a s) (rcl_b - lag + 1) in
      let* (b, left_child) := escape_from b_ (at_b s) rcl_b in goes left_child a b (-1).

(* code: include/flashbvh/traversal/stackless.hpp | bool next() { return (lead_ >= 0 ? next_of_a() : next_of_b()) != 0; } *)
Definition next_ (s : At) : option Turned :=
  if (0 <=? lead s)%Z then next_of_a s else next_of_b s.

(* A visit and the step to the next one. *)
Definition visit (s : At) : option Turned :=
  if overlap (at_a s) (at_b s) then
    let* to := descend s in match to with Some s' => Some (Goes s') | None => next_ s end
  else next_ s.

(* code: include/flashbvh/traversal/stackless.hpp | lead_(static_cast<int32_t>(a.level(cursor.a)) - static_cast<int32_t>(b.level(cursor.b))) {} *)
Definition start (p : nat * nat) : At := {| at_a := fst p; at_b := snd p;
  lead := Z.of_nat (level a_ (fst p)) - Z.of_nat (level b_ (snd p)) |}.

(* `Loop s l`: from s on, the loop visits l, then ends, and reads nothing outside. *)
Inductive Loop : At -> list (nat * nat) -> Prop :=
| Loop_ends s : visit s = Some Ends -> Loop s [(at_a s, at_b s)]
| Loop_goes s s' l : visit s = Some (Goes s') -> Loop s' l -> Loop s ((at_a s, at_b s) :: l).

(* The recursion that it replaces (the paper's algorithm 3, section 8.1): into the node of lower level, into B on
   ties; if one is a leaf, into the other one. *)
Variables children_a children_b : nat -> list nat.
Let level_a := level a_.
Let level_b := level b_.
Definition into (p : nat * nat) : list (nat * nat) :=
  let (a, b) := p in
  if ((level_a a <? level_b b) || is_leaf (cells b_) b) && negb (is_leaf (cells a_) a)
  then map (fun x => (x, b)) (children_a a)
  else map (fun y => (a, y)) (children_b b).
Fixpoint search (depth : nat) (p : nat * nat) : list (nat * nat) :=
  match depth with
  | O => []
  | S d => p :: flat_map (search d) (if overlap (fst p) (snd p) then into p else [])
  end.
Definition deep_enough depth := length (cells a_) + length (cells b_) < depth.

(* code: include/flashbvh/traversal/stackless.hpp | return level_a > level_b ? b.nodes[cursor.b].is_leaf() : level_b - level_a <= 1 || a.nodes[cursor.a].is_leaf(); *)
Definition can_visit (p : nat * nat) : bool :=
  let (a, b) := p in
  if level_b b <? level_a a then is_leaf (cells b_) b
  else (level_b b - level_a a <=? 1) || is_leaf (cells a_) a.
Definition inside (p : nat * nat) := fst p < length (cells a_) /\ snd p < length (cells b_).
End Walk.

(* ============================================================== Part 2: the theorems *)

Section Theorems.
Variables a_ b_ : Mesh.
Variables children_a children_b : nat -> list nat.
Hypothesis FA : Post_indexed (cells a_) children_a.
Hypothesis FB : Post_indexed (cells b_) children_b.
Hypothesis LA : Levelled children_a (length (cells a_)) (levels a_) (rcls a_).
Hypothesis LB : Levelled children_b (length (cells b_)) (levels b_) (rcls b_).
Variable overlap : nat -> nat -> bool.
Let visits depth := search a_ b_ overlap children_a children_b depth (0, 0).
Let Loop := Loop a_ b_ overlap.
Let start := start a_ b_.

(* From the roots the loop makes the visits of the recursion, in its order, no pair twice, and ends; from any of them,
   without other data, it makes the remaining ones. *)
Definition Stackless_is_search := forall depth, deep_enough a_ b_ depth ->
  Loop (start (0, 0)) (visits depth) /\ NoDup (visits depth) /\
  (forall before p rest, visits depth = before ++ p :: rest -> Loop (start p) (p :: rest)).

(* It ends from every pair that can_visit() accepts; these are the pairs that are visited if all boxes overlap. *)
Definition Stackless_positions := forall p, inside a_ b_ p ->
  (can_visit a_ b_ p = true -> exists l, Loop (start p) (p :: l)) /\
  (forall depth, deep_enough a_ b_ depth -> can_visit a_ b_ p = true <->
     In p (search a_ b_ (fun _ _ => true) children_a children_b depth (0, 0))).

(* Exactly the pairs of leaves that pass `hit` are visited and pass it, each once, if rejected pairs have none of them
   below. *)
Definition Stackless_finds := forall depth (hit : nat * nat -> bool), deep_enough a_ b_ depth ->
  (forall a b x y, Under (T := array_tree _ _ FA) a x -> Under (T := array_tree _ _ FB) b y ->
     children_a x = [] -> children_b y = [] -> hit (x, y) = true -> overlap a b = true) ->
  let found p := overlap (fst p) (snd p) && (is_leaf (cells a_) (fst p) && is_leaf (cells b_) (snd p)) in
  let answers := filter (fun p => found p && hit p) (visits depth) in
  NoDup answers /\ forall p, In p answers <->
    inside a_ b_ p /\ children_a (fst p) = [] /\ children_b (snd p) = [] /\ hit p = true.
End Theorems.

(* ============================================================== Part 3: the proofs *)

Definition rank_limits (limit_ : nat) : Limits.
Proof. exists (Z.of_nat (2 * limit_)) (Z.of_nat (2 * limit_ + 1)). lia. Defined.

Section OneTree.
Variable m : Mesh.
Variable children : nat -> list nat.
Hypothesis F : Post_indexed (cells m) children.
Hypothesis L : Levelled children (length (cells m)) (levels m) (rcls m).
Local Notation level := (level m).
Local Notation rcl := (rcl m).
Let count := length (cells m).

Lemma level_small i : i < count -> level i <= i.
Proof.
  induction i as [i IH] using lt_wf_ind. intros H. unfold level.
  destruct (Nat.eq_dec i 0) as [->|Z]; [rewrite (level_of_root _ _ _ _ L); lia|].
  destruct (fmt_all _ _ F i) as [n I]; [unfold count in *; lia|].
  pose proof (after_parent' _ _ F _ _ I). rewrite (level_of_kid _ _ _ _ L _ _ I).
  specialize (IH n). unfold level in IH. lia.
Qed.

(* The kinds of a node: a last child, another child, or the root. *)
Lemma kind i : i < count ->
  (i = 0 /\ rcl i = 0 /\ level i = 0) \/
  (exists n, In i (children n) /\ 0 < i /\ level i = S (level n) /\
     ((n = i - 1 /\ rcl i = S (rcl n) /\ arr_next (cells m) i = None) \/
      (rcl i = 0 /\ exists s, arr_next (cells m) i = Some s /\ In s (children n) /\ link m i = Some s))).
Proof.
  intros H. destruct (Nat.eq_dec i 0) as [->|Z].
  - left. unfold rcl, level. now rewrite (rcl_of_root _ _ _ _ L), (level_of_root _ _ _ _ L).
  - right. destruct (fmt_all _ _ F i) as [n I]; [unfold count in *; lia|]. exists n.
    split; auto. split; [lia|]. split; [apply (level_of_kid _ _ _ _ L _ _ I)|].
    apply in_split in I as (l & r & K). destruct r as [|s r].
    + left. pose proof (fmt_last _ _ F _ _ _ K) as [E _].
      split; [lia|]. split; [apply (rcl_of_last _ _ _ _ L _ _ _ K)|].
      now apply (Ranked.next_of_last (array_tree _ _ F) n l i).
    + right. split; [apply (rcl_of_other _ _ _ _ L _ _ _ _ _ K)|]. exists s.
      pose proof (Ranked.next_of_kid (array_tree _ _ F) n l i s r K) as N. cbn in N.
      split; auto. split; [rewrite K; apply in_or_app; cbn; auto|].
      unfold link. rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0)) by exact H. cbn.
      f_equal. now apply (fmt_sibling _ _ F) in K.
Qed.

(* Levels as ranks. *)
Variable limit_ : nat.
Hypothesis limit_large : count < limit_.
Variable less : Z.                       (* 1 in A, 0 in B *)
Hypothesis less_small : (0 <= less <= 1)%Z.
Definition level_rank (i : nat) : Z := (2 * (Z.of_nat limit_ - Z.of_nat (level i)) - less)%Z.
Definition node_rank i := if is_leaf (cells m) i then (-1)%Z else level_rank i.

Lemma rank_range i : i < count -> (1 <= level_rank i <= Z.of_nat (2 * limit_))%Z.
Proof. intros H. pose proof (level_small i H). unfold level_rank. lia. Qed.

Lemma internal_inside i : children i <> [] -> i < count /\ node_rank i = level_rank i.
Proof.
  intros N. split.
  - destruct (children i) as [|x r] eqn:K; [easy|]. apply (fmt_inside _ _ F i x). rewrite K. now left.
  - unfold node_rank. destruct (is_leaf (cells m) i) eqn:E; auto. now apply (leaf_spec _ _ F) in E.
Qed.

Lemma kid_facts n x : In x (children n) -> n < x /\ n < count /\ x < count /\ level x = S (level n) /\
  node_rank n = level_rank n /\ (1 <= level_rank n)%Z.
Proof.
  intros I. destruct (fmt_inside _ _ F n x I) as [N X]. assert (children n <> []) as E by (intros E; now rewrite E in I).
  repeat split; auto; [apply (after_parent' _ _ F _ _ I) | apply (level_of_kid _ _ _ _ L _ _ I) |
    now apply internal_inside | now apply rank_range].
Qed.

Definition level_tree : @Tree (rank_limits limit_).
Proof.
  refine {| Node := nat; root := 0; kids := children; rank := node_rank;
    parent_rank i := if i =? 0 then @top (rank_limits limit_) else (level_rank i + 2)%Z;
    next := arr_next (cells m); up i := i - 1; is_root i := i =? 0; height i := count - i |};
    [| | | | reflexivity | | | reflexivity | | reflexivity | |]; intros;
    try match goal with I : In _ _ |- _ => pose proof (kid_facts _ _ I) end.
  - unfold node_rank. destruct (is_leaf (cells m) n) eqn:E; [apply (leaf_spec _ _ F) in E; now split|].
    split; intros H; [apply (leaf_spec _ _ F) in H; congruence|]. destruct (children n) eqn:K; auto.
    destruct (internal_inside n) as [I _]; [now rewrite K|]. pose proof (rank_range n I). lia.
  - destruct (internal_inside n) as [I ->]; auto. now apply rank_range.
  - unfold node_rank at 1. destruct (is_leaf (cells m) x); unfold level_rank in *; lia.
  - destruct (Nat.eqb_spec x 0); unfold level_rank in *; lia.
  - now apply (Ranked.next_of_kid (array_tree _ _ F) n l x y r).
  - now apply (Ranked.next_of_last (array_tree _ _ F) n l x).
  - now apply (Ranked.up_of_last (array_tree _ _ F) n l x).
  - now apply (Ranked.kid_is_not_root (array_tree _ _ F) n x).
  - lia.
Defined.

Lemma same_under n x : Under (T := level_tree) n x <-> Under (T := array_tree _ _ F) n x.
Proof. split; (induction 1; [constructor | econstructor; eauto]). Qed.
Lemma level_tree_inside i : Under (T := level_tree) 0 i <-> i < count.
Proof. rewrite same_under. split; [apply under_inside, (fmt_some _ _ F) | apply (all_under _ _ F)]. Qed.
End OneTree.

Section Proofs.
Variables a_ b_ : Mesh.
Variables children_a children_b : nat -> list nat.
Hypothesis FA : Post_indexed (cells a_) children_a.
Hypothesis FB : Post_indexed (cells b_) children_b.
Hypothesis LA : Levelled children_a (length (cells a_)) (levels a_) (rcls a_).
Hypothesis LB : Levelled children_b (length (cells b_)) (levels b_) (rcls b_).
Variable overlap : nat -> nat -> bool.
Let most_ := length (cells a_) + length (cells b_) + 1.
Lemma small_0 : (0 <= 0 <= 1)%Z. Proof. lia. Qed.
Lemma small_1 : (0 <= 1 <= 1)%Z. Proof. lia. Qed.
Lemma fits_a : length (cells a_) < most_. Proof. unfold most_. lia. Qed.
Lemma fits_b : length (cells b_) < most_. Proof. unfold most_. lia. Qed.
Local Instance level_ranks : Limits := rank_limits most_.
Let A : Tree := level_tree a_ children_a FA LA most_ fits_a 1 small_1.
Let B : Tree := level_tree b_ children_b FB LB most_ fits_b 0 small_0.
Local Notation inside := (inside a_ b_).
Local Notation into := (into a_ b_ children_a children_b).
Local Notation turn := (turn A B overlap).
Local Notation RunTo := (Run A B overlap).
Local Notation start := (start a_ b_).
Local Notation level_a := (level a_).
Local Notation level_b := (level b_).
Local Notation rcl_a := (rcl a_).
Local Notation rcl_b := (rcl b_).

Definition here (a b : nat) : Pair A B := (a, b).

Lemma same_expand a b : expand A B (here a b) = into (a, b).
Proof.
  unfold expand, here, Stackless.into. cbn [A B level_tree rank kids].
  destruct (is_leaf (cells a_) a) eqn:Ea; destruct (is_leaf (cells b_) b) eqn:Eb;
    unfold node_rank; rewrite ?Ea, ?Eb.
  - apply (leaf_spec _ _ FA) in Ea. apply (leaf_spec _ _ FB) in Eb.
    rewrite Ea, Eb, andb_false_r. reflexivity.
  - rewrite andb_false_r. assert (b < length (cells b_)) as I.
    { apply (internal_inside b_ children_b FB most_ 0 b). intros N. apply (leaf_spec _ _ FB) in N. congruence. }
    pose proof (rank_range b_ children_b FB LB most_ fits_b 0 small_0 b I).
    destruct (Z.ltb_spec (-1) (level_rank b_ most_ 0 b)); [reflexivity | lia].
  - rewrite orb_true_r. assert (a < length (cells a_)) as I.
    { apply (internal_inside a_ children_a FA most_ 1 a). intros N. apply (leaf_spec _ _ FA) in N. congruence. }
    pose proof (rank_range a_ children_a FA LA most_ fits_a 1 small_1 a I).
    destruct (Z.ltb_spec (level_rank a_ most_ 1 a) (-1)); [lia | reflexivity].
  - rewrite orb_false_r. cbn [andb negb]. rewrite andb_true_r. unfold level_rank.
    destruct (Nat.ltb_spec (level_a a) (level_b b)); destruct (Z.ltb_spec
      (2 * (Z.of_nat most_ - Z.of_nat (level_a a)) - 1) (2 * (Z.of_nat most_ - Z.of_nat (level_b b)) - 0));
      try lia; reflexivity.
Qed.

Lemma same_search d : forall p, search a_ b_ overlap children_a children_b d p = dfs A B overlap d p.
Proof.
  induction d as [|d IH]; intros [a b]; [reflexivity|]. cbn [search dfs].
  apply (f_equal (cons (a, b))). unfold descents. rewrite <- (same_expand a b). unfold here. cbn [fst snd].
  destruct (overlap a b); [|reflexivity]. apply (flat_map_ext _ _ IH).
Qed.

Lemma same_can_visit a b : inside (a, b) ->
  (Ranked.can_visit A B (here a b) <-> can_visit a_ b_ (a, b) = true).
Proof.
  intros [Ia Ib]. cbn [fst snd] in *. unfold Ranked.can_visit, Stackless.can_visit, here.
  cbn [A B level_tree rank parent_rank].
  pose proof (rank_range a_ children_a FA LA most_ fits_a 1 small_1 a Ia) as Ra.
  pose proof (rank_range b_ children_b FB LB most_ fits_b 0 small_0 b Ib) as Rb.
  destruct (kind a_ children_a FA LA a Ia) as [(Ea & _ & Va) | (n & _ & Pa & Va & _)];
  destruct (kind b_ children_b FB LB b Ib) as [(Eb & _ & Vb) | (n' & _ & Pb & Vb & _)].
  all: destruct (Nat.eqb_spec a 0), (Nat.eqb_spec b 0); try lia.
  all: unfold node_rank, level_rank in *; cbn [top level_ranks rank_limits].
  all: destruct (Nat.ltb_spec (level_b b) (level_a a)); destruct (is_leaf (cells a_) a);
    destruct (is_leaf (cells b_) b); rewrite ?orb_true_r, ?orb_false_r, ?Nat.leb_le; lia.
Qed.

Lemma in_trees a b : In_trees A B (here a b) <-> inside (a, b).
Proof.
  unfold In_trees, Stackless.inside, here. cbn [fst snd].
  pose proof (level_tree_inside a_ children_a FA LA most_ fits_a 1 small_1 a) as Ha.
  pose proof (level_tree_inside b_ children_b FB LB most_ fits_b 0 small_0 b) as Hb.
  unfold A, B. cbn [root level_tree]. tauto.
Qed.

(* ---- A turn up. *)

Lemma into_b a b : inside (a, b) -> (parent_rank B b <=? parent_rank A a)%Z =
  (level_a a <? level_b b) || ((a =? 0) && (b =? 0)).
Proof.
  intros [Ia Ib]. cbn [fst snd] in *. cbn [A B level_tree parent_rank].
  pose proof (rank_range a_ children_a FA LA most_ fits_a 1 small_1 a Ia).
  pose proof (rank_range b_ children_b FB LB most_ fits_b 0 small_0 b Ib).
  destruct (kind a_ children_a FA LA a Ia) as [(Ea & _ & Va) | (n & _ & Pa & Va & _)];
  destruct (kind b_ children_b FB LB b Ib) as [(Eb & _ & Vb) | (n' & _ & Pb & Vb & _)].
  all: destruct (Nat.eqb_spec a 0), (Nat.eqb_spec b 0); try lia.
  all: unfold level_rank in *; cbn [top rank_limits andb].
  all: destruct (Nat.ltb_spec (level_a a) (level_b b)); cbn [orb];
    rewrite ?Z.leb_le, ?Z.leb_gt; lia.
Qed.

Lemma read_rcl m children (L : Levelled children (length (cells m)) (levels m) (rcls m)) i :
  i < length (cells m) -> nth_error (rcls m) i = Some (rcl m i).
Proof. intros H. apply nth_error_nth'. now rewrite (rcl_count _ _ _ _ L). Qed.

Lemma level_up_before i k : 0 < i -> level_up (i - 1) k = level_up i (S k).
Proof. intros P. destruct i; [lia|]. cbn. now rewrite Nat.sub_0_r. Qed.
Lemma level_up_one i k : 0 < i -> k = 1 -> level_up i k = Some (i - 1).
Proof. intros P ->. now destruct i. Qed.

(* next() from a pair: its cases, and its reads. *)
Ltac next_cases a b := unfold next_, next_of_a, next_of_b, escape_from, Stackless.start; cbn [fst snd lead at_a at_b];
  rewrite ?(read_rcl a_ _ LA a), ?(read_rcl b_ _ LB b), ?(read_rcl a_ _ LA (a - 1)), ?(read_rcl b_ _ LB (b - 1)) by lia.
Ltac compare_all := repeat match goal with
  | |- context [(0 <=? ?x)%Z] => destruct (Z.leb_spec 0 x)
  | |- context [?x <=? ?y] => destruct (Nat.leb_spec x y)
  | |- context [?x <? ?y] => destruct (Nat.ltb_spec x y)
  end; try lia.
Ltac same_reads := rewrite ?level_up_before by lia; compare_all;
  repeat match goal with |- context [level_up ?i ?k] => rewrite (level_up_one i k) by lia end;
  repeat match goal with |- context [level_up ?i ?k] => match goal with |- context [level_up i ?j] =>
    tryif constr_eq k j then fail else replace k with j by lia end end;
  repeat match goal with |- context [level_up ?i ?k] => destruct (level_up i k) end;
  repeat match goal with |- context [link ?m ?i] => destruct (link m i) end; f_equal; lia.

Ltac no_reads K V := compare_all; cbn [level_up Nat.leb]; rewrite Nat.sub_0_r, K; unfold goes;
  rewrite ?Z.sub_0_r, ?Z.add_0_r; destruct V as [-> | ->]; reflexivity.

(* From a last child it continues as from the parent; from another node, or the root, to the node's link. *)
Lemma next_up_a a b : inside (a, b) -> 0 < a -> level_a a = S (level_a (a - 1)) -> rcl_a a = S (rcl_a (a - 1)) ->
  level_b b <= level_a a -> next_ a_ b_ (start (a, b)) = next_ a_ b_ (start (a - 1, b)).
Proof. intros [Ia Ib] P V R L. cbn [fst snd] in *. next_cases a b. rewrite V, R in *. same_reads. Qed.
Lemma next_up_b a b : inside (a, b) -> 0 < b -> level_b b = S (level_b (b - 1)) -> rcl_b b = S (rcl_b (b - 1)) ->
  level_a a < level_b b -> next_ a_ b_ (start (a, b)) = next_ a_ b_ (start (a, b - 1)).
Proof. intros [Ia Ib] P V R L. cbn [fst snd] in *. next_cases a b. rewrite V, R in *. same_reads. Qed.

Lemma next_aside_a a b to : inside (a, b) -> rcl_a a = 0 -> level_b b <= level_a a -> link a_ a = Some to ->
  a = 0 \/ level_a to = level_a a -> next_ a_ b_ (start (a, b)) = Some (if a =? 0 then Ends else Goes (start (to, b))).
Proof. intros [Ia Ib] R L K V. cbn [fst snd] in *. next_cases a b. rewrite R. no_reads K V. Qed.
Lemma next_aside_b a b to : inside (a, b) -> rcl_b b = 0 -> level_a a < level_b b -> link b_ b = Some to ->
  b = 0 \/ level_b to = level_b b -> next_ a_ b_ (start (a, b)) = Some (if b =? 0 then Ends else Goes (start (a, to))).
Proof. intros [Ia Ib] R L K V. cbn [fst snd] in *. next_cases a b. rewrite R. no_reads K V. Qed.

Lemma next_turns a b : inside (a, b) -> match turn (Behind (here a b)) with
  | Behind (a', b') => inside (a', b') /\ next_ a_ b_ (start (a, b)) = next_ a_ b_ (start (a', b'))
  | Visit (a', b') => inside (a', b') /\ next_ a_ b_ (start (a, b)) = Some (Goes (start (a', b')))
  | Done => next_ a_ b_ (start (a, b)) = Some Ends
  end.
Proof.
  intros I. pose proof I as [Ia Ib]. cbn [fst snd] in *. unfold here. cbn [Ranked.turn].
  rewrite (into_b a b I). destruct (Nat.ltb_spec (level_a a) (level_b b)) as [V|V]; cbn [orb].
  - destruct (kind b_ children_b FB LB b Ib) as [(-> & _ & W) | (n & _ & P & W & K)]; [lia|].
    cbn [B level_tree next up is_root]. destruct K as [(-> & R & N) | (R & s & N & J & K)]; rewrite N.
    + destruct (Nat.eqb_spec b 0); [lia|]. split; [split; cbn; lia | now apply next_up_b].
    + split; [apply (fmt_inside _ _ FB) in J; now split|].
      rewrite (next_aside_b a b s I R V K (or_intror (eq_trans (level_of_kid _ _ _ _ LB _ _ J) (eq_sym W)))). now destruct b.
  - destruct (kind a_ children_a FA LA a Ia) as [(-> & R & W) | (n & _ & P & W & K)].
    + destruct (kind b_ children_b FB LB b Ib) as [(-> & _) | (n & _ & P & W' & _)]; [|lia]. cbn.
      apply (next_aside_a 0 0 (c_link (cell (cells a_) 0)) I R V); auto.
      unfold link. now rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0) Ia).
    + destruct (Nat.eqb_spec a 0); [lia|]. cbn [andb A level_tree next up].
      destruct K as [(-> & R & N) | (R & s & N & J & K)]; rewrite N.
      * split; [split; cbn; lia | now apply next_up_a].
      * split; [apply (fmt_inside _ _ FA) in J; now split|].
        rewrite (next_aside_a a b s I R V K (or_intror (eq_trans (level_of_kid _ _ _ _ LA _ _ J) (eq_sym W)))). now destruct a.
Qed.

Lemma read_leaf m i : i < length (cells m) -> leaf_at m i = Some (is_leaf (cells m) i).
Proof.
  intros H. unfold leaf_at, is_leaf, cell.
  now rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0) H).
Qed.

(* For an internal node: the link of the node behind it. *)
Lemma first_kid m children (F : Post_indexed (cells m) children)
  (L : Levelled children (length (cells m)) (levels m) (rcls m)) i : is_leaf (cells m) i = false ->
  exists x r, children i = x :: r /\ first_child m i = Some x /\ level m x = S (level m i).
Proof.
  intros E. destruct (internal _ _ F i E) as (r & K). exists (Code.first_child (cells m) i), r.
  split; [exact K|]. split; [|apply (level_of_kid _ _ _ _ L); rewrite K; now left].
  destruct (@exists_last _ (children i) ltac:(now rewrite K)) as (l & z & E').
  pose proof (fmt_last _ _ F _ _ _ E') as [-> _].
  assert (In (i + 1) (children i)) as I by (rewrite E'; apply in_elt). apply (fmt_inside _ _ F) in I as [_ I].
  unfold first_child, link. now rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0) I).
Qed.

Lemma descend_is a b : inside (a, b) -> descend a_ b_ (start (a, b)) =
  Some (match into (a, b) with q :: _ => Some (start q) | [] => None end).
Proof.
  intros [Ia Ib]. cbn [fst snd] in *. unfold descend, Stackless.into, Stackless.start.
  cbn [fst snd at_a at_b lead]. rewrite (read_leaf a_ a Ia), (read_leaf b_ b Ib).
  replace (Z.of_nat (level_a a) - Z.of_nat (level_b b) <? 0)%Z with (level_a a <? level_b b)
    by (destruct (Nat.ltb_spec (level_a a) (level_b b)); symmetry; [apply Z.ltb_lt | apply Z.ltb_ge]; lia).
  destruct ((_ || _) && _) eqn:E; [apply andb_prop in E as [_ E]; apply negb_true_iff in E|].
  - destruct (first_kid a_ _ FA LA a E) as (x & r & -> & -> & V). cbn [map fst snd]. rewrite V. do 3 f_equal. lia.
  - destruct (is_leaf (cells b_) b) eqn:Lb; cbn [negb]; [apply (leaf_spec _ _ FB) in Lb; now rewrite Lb|].
    destruct (first_kid b_ _ FB LB b Lb) as (x & r & -> & -> & V). cbn [map fst snd]. rewrite V. do 3 f_equal. lia.
Qed.

(* ---- So the loop is Ranked.v's. *)

Lemma into_inside p q : inside p -> In q (into p) -> inside q.
Proof.
  destruct p as [a b], q as [a' b']. intros I Q. rewrite <- (same_expand a b) in Q.
  apply (in_trees a' b'). apply (In_trees_child A B (here a b)); [now apply in_trees | exact Q].
Qed.

Lemma visit_turns a b : inside (a, b) -> match turn (Visit (here a b)) with
  | Visit (a', b') => inside (a', b') /\ visit a_ b_ overlap (start (a, b)) = Some (Goes (start (a', b')))
  | Behind p => p = here a b /\ visit a_ b_ overlap (start (a, b)) = next_ a_ b_ (start (a, b))
  | Done => False
  end.
Proof.
  intros I. rewrite turn_visit. unfold descents, visit. rewrite same_expand, (descend_is a b I).
  cbn [here fst snd Stackless.start at_a at_b]. destruct (overlap a b); [|now split].
  destruct (into (a, b)) as [|[a' b'] r] eqn:K; split; auto.
  apply (into_inside (a, b)); auto. rewrite K. now left.
Qed.

Lemma run_loop n : forall s t, RunTo n s t Done -> match s with
  | Visit (a, b) => inside (a, b) -> Loop a_ b_ overlap (start (a, b)) t
  | Behind (a, b) => inside (a, b) -> forall from, visit a_ b_ overlap from = next_ a_ b_ (start (a, b)) ->
      Loop a_ b_ overlap from ((at_a from, at_b from) :: t)
  | Done => t = []
  end.
Proof.
  induction n as [|n IH]; intros s t [E <-]; [now cbn in E; subst s|]. cbn [after trace] in *.
  specialize (IH _ _ (conj E eq_refl)).
  destruct s as [[a b] | [a b] |]; [| |apply (done_stays A B overlap n)]; intros I; set (s := turn _) in *;
    [pose proof (visit_turns a b I) as N; change (turn (Visit (here a b))) with s in N |
     pose proof (next_turns a b I) as N; change (turn (Behind (here a b))) with s in N];
    clearbody s; destruct s as [[a' b'] | [a' b'] |].
  - destruct N as [J N]. apply (Loop_goes a_ b_ overlap (start (a, b)) _ _ N). now apply IH.
  - destruct N as [[= -> ->] N]. now apply (IH I (start (a, b))).
  - easy.
  - intros from V. destruct N as [J N]. apply (Loop_goes a_ b_ overlap _ _ _ (eq_trans V N)). now apply IH.
  - intros from V. destruct N as [J N]. apply (IH J). exact (eq_trans V N).
  - intros from V. rewrite IH. apply Loop_ends. exact (eq_trans V N).
Qed.

Lemma deep d : deep_enough a_ b_ d -> enough A B d.
Proof.
  unfold deep_enough, enough, size, roots. cbn [A B level_tree height root fst snd]. lia.
Qed.
Lemma roots_inside : inside (0, 0).
Proof. split; [apply (fmt_some _ _ FA) | apply (fmt_some _ _ FB)]. Qed.

Theorem stackless_is_search : Stackless_is_search a_ b_ children_a children_b overlap.
Proof.
  intros d D. apply deep in D. rewrite same_search.
  pose proof (visits_once A B overlap d D) as Once. pose proof (walk_is_dfs A B overlap d D) as W.
  split; [|split; [exact Once|]].
  - exact (run_loop _ _ _ W roots_inside).
  - intros l [a b] r E. destruct (resumes A B overlap d l (here a b) r D E) as (n & R).
    enough (inside (a, b)) as I by exact (run_loop n _ _ R I).
    apply in_trees. apply (visited_can_be A B overlap d _ D). change (In (a, b) (dfs A B overlap d (0, 0))). rewrite E. apply in_elt.
Qed.

Theorem stackless_finds : Stackless_finds a_ b_ children_a children_b FA FB overlap.
Proof.
  intros d hit D S found answers. apply deep in D.
  destruct (finds_each_once A B overlap d hit D) as [N E].
  { intros a b x y U V. apply (S a b x y); [now apply same_under in U | now apply same_under in V]. }
  assert (answers = filter (fun p => Ranked.found A B overlap p && hit p) (dfs A B overlap d (roots A B))) as ->.
  { unfold answers. rewrite same_search. apply filter_ext_in. intros [a b] I. f_equal.
    unfold found, Ranked.found, is_leaf_pair. cbn [fst snd]. f_equal.
    apply (visited_can_be A B overlap d _ D) in I as [I _]. apply in_trees in I as [Ia Ib]. cbn [fst snd] in *.
    pose proof (rank_range a_ children_a FA LA most_ fits_a 1 small_1 a Ia).
    pose proof (rank_range b_ children_b FB LB most_ fits_b 0 small_0 b Ib).
    cbn [A B level_tree rank]. unfold node_rank. destruct (is_leaf (cells a_) a), (is_leaf (cells b_) b);
      symmetry; rewrite ?andb_true_iff, ?andb_false_iff, ?Z.ltb_lt, ?Z.ltb_ge; lia. }
  split; [exact N|]. intros [a b]. etransitivity; [apply (E (here a b))|].
  split; intros (H & K); (split; [now apply in_trees | exact K]).
Qed.
Lemma ends_from p : inside p -> can_visit a_ b_ p = true -> exists l, Loop a_ b_ overlap (start p) (p :: l).
Proof.
  destruct p as [a b]. intros I C. apply (same_can_visit a b I) in C.
  destruct (ends_from_everywhere A B overlap (here a b) (proj2 (in_trees a b) I) C) as [(n & t & R) _].
  pose proof (run_loop n _ _ R I : Loop a_ b_ overlap (start (a, b)) t) as G. inversion G; subst; eexists; exact G.
Qed.

Lemma visited_where_all_overlap d p : overlap = (fun _ _ => true) -> deep_enough a_ b_ d -> inside p ->
  can_visit a_ b_ p = true <-> In p (search a_ b_ overlap children_a children_b d (0, 0)).
Proof.
  destruct p as [a b]. intros O D I. apply deep in D. rewrite same_search.
  rewrite <- (same_can_visit a b I). split.
  - intros C. rewrite O. exact (can_be_visited A B d (here a b) D (proj2 (in_trees a b) I) C).
  - intros P. exact (proj2 (visited_can_be A B overlap d (here a b) D P)).
Qed.
End Proofs.

Theorem stackless_positions a_ b_ children_a children_b
  (FA : Post_indexed (cells a_) children_a) (FB : Post_indexed (cells b_) children_b)
  (LA : Levelled children_a (length (cells a_)) (levels a_) (rcls a_))
  (LB : Levelled children_b (length (cells b_)) (levels b_) (rcls b_)) overlap :
  Stackless_positions a_ b_ children_a children_b overlap.
Proof.
  intros p I. split; [now apply (ends_from a_ b_ children_a children_b FA FB LA LB)|].
  intros d D. now apply (visited_where_all_overlap a_ b_ children_a children_b FA FB LA LB).
Qed.

(* The premises can be met: the walk of two small trees; the second one has one child per node. *)
Definition leaf_of l := {| c_link := l; c_rank := -1; c_parent_rank := 0 |}.
Definition node_of l p := {| c_link := l; c_rank := 1; c_parent_rank := p |}.
Definition tree_a := {| cells := [node_of 5 kRootParentRank; node_of 4 1; leaf_of 3; leaf_of 2; leaf_of 1];
  levels := [0; 1; 2; 2; 1]; rcls := [0; 1; 2; 0; 0] |}.
Definition tree_b := {| cells := [node_of 3 kRootParentRank; node_of 1 1; leaf_of 2];
  levels := [0; 1; 2]; rcls := [0; 1; 2] |}.
Fixpoint walk_some (n : nat) (s : At) : list (nat * nat) * bool :=
  match n with
  | O => ([], false)
  | S k => match visit tree_a tree_b (fun _ _ => true) s with
           | Some (Goes t) => let (l, e) := walk_some k t in ((at_a s, at_b s) :: l, e)
           | Some Ends => ([(at_a s, at_b s)], true)
           | None => ([], false)
           end
  end.
Example walks_some : walk_some 30 (start tree_a tree_b (0, 0)) =
  ([(0, 0); (0, 1); (4, 1); (4, 2); (1, 1); (1, 2); (3, 2); (2, 2)], true).
Proof. reflexivity. Qed.

Print Assumptions stackless_is_search.
Print Assumptions stackless_positions.
Print Assumptions stackless_finds.
