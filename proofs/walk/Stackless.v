(* The paper's stackless algorithm on post-indexed trees, tests/reference/stackless.hpp: it
   makes the visits of the recursion that steps into both trees in turn. Any number of children.

   That rule is one of ranks: -2 level, and less 1 in A. So Ranked.v has the order; what is proved here
   is that next(), which jumps up both trees at once, is Ranked.v's turns, a step up at a time.

   Part 1  definitions.   Part 2  the theorems.   Part 3  their proofs. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants Ranked Code.
Import ListNotations.
Local Open Scope nat_scope.

(* ============================================================== Part 1: definitions *)

(* Levels and right child levels, as BasicMeshWithLevels has them. *)
Record Levelled (children : nat -> list nat) (count : nat) (levels rcls : list nat) : Prop := {
  level_count : length levels = count;
  rcl_count : length rcls = count;
  level_of_root : nth 0 levels 0 = 0;
  level_of_kid : forall n x, In x (children n) -> nth x levels 0 = S (nth n levels 0);
  rcl_of_root : nth 0 rcls 0 = 0;
  rcl_of_last : forall n l x, children n = l ++ [x] -> nth x rcls 0 = S (nth n rcls 0);
  rcl_of_other : forall n l x y r, children n = l ++ x :: y :: r -> nth x rcls 0 = 0
}.

(* What a read outside an array or a level above the root leads to is None. *)
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
(* code: ../tests/reference/levels.hpp | uint32_t level_up(uint32_t node, uint32_t count) const { return node - count; } *)
Definition level_up (i count : nat) : option nat := if count <=? i then Some (i - count) else None.
(* code: ../tests/reference/levels.hpp | const uint32_t left_child = node - rcl; node = this->nodes[left_child].link; return left_child; *)
Definition escape_from (i rcl : nat) : option (nat * nat) :=
  let* left_child := level_up i rcl in
  let* to := link left_child in Some (to, left_child).
End Mesh.

Section Walk.
Variables a_ b_ : Mesh.
Variable overlap : nat -> nat -> bool.  (* what is tested of a pair: any predicate *)

Record At := { at_a : nat; at_b : nat; lead : Z }.
Inductive Turned := Goes (to : At) | Ends.

(* code: ../tests/reference/stackless.hpp | if ((lead_ < 0 || leaf_b) && !node_a().is_leaf()) { a_ = tree_a_.first_child(a_); ++lead_; return true; } *)
(* code: ../tests/reference/stackless.hpp | if (!leaf_b) { b_ = tree_b_.first_child(b_); --lead_; return true; } return false; *)
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

(* code: ../tests/reference/stackless.hpp | if (rcl_a <= lead) { *)
(* code: ../tests/reference/stackless.hpp | lead_ -= static_cast<int32_t>(rcl_a); return tree_a_.escape_from(a_, rcl_a); *)
(* code: ../tests/reference/stackless.hpp | if (rcl_a - lead <= rcl_b) { *)
(* code: ../tests/reference/stackless.hpp | b_ = tree_b_.level_up(b_, rcl_a - lead); lead_ = 0; return tree_a_.escape_from(a_, rcl_a); *)
(* code: ../tests/reference/stackless.hpp | a_ = tree_a_.level_up(a_, lead + rcl_b + 1); lead_ = -1; return tree_b_.escape_from(b_, rcl_b); *)
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

(* code: ../tests/reference/stackless.hpp | if (rcl_b < lag) { *)
(* code: ../tests/reference/stackless.hpp | lead_ += static_cast<int32_t>(rcl_b); return tree_b_.escape_from(b_, rcl_b); *)
(* code: ../tests/reference/stackless.hpp | if (rcl_a <= rcl_b - lag) { *)
(* code: ../tests/reference/stackless.hpp | b_ = tree_b_.level_up(b_, rcl_a + lag); lead_ = 0; return tree_a_.escape_from(a_, rcl_a); *)
(* code: ../tests/reference/stackless.hpp | a_ = tree_a_.level_up(a_, rcl_b - lag + 1); lead_ = -1; return tree_b_.escape_from(b_, rcl_b); *)
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

(* code: ../tests/reference/stackless.hpp | bool next() { return (lead_ >= 0 ? next_of_a() : next_of_b()) != 0; } *)
Definition next_ (s : At) : option Turned :=
  if (0 <=? lead s)%Z then next_of_a s else next_of_b s.

(* A visit and the way to the next one. *)
Definition visit (s : At) : option Turned :=
  if overlap (at_a s) (at_b s) then
    let* to := descend s in match to with Some s' => Some (Goes s') | None => next_ s end
  else next_ s.

(* code: ../tests/reference/stackless.hpp | lead_(static_cast<int32_t>(a.level(cursor.a)) - static_cast<int32_t>(b.level(cursor.b))) {} *)
Definition start (p : nat * nat) : At := {| at_a := fst p; at_b := snd p;
  lead := Z.of_nat (level a_ (fst p)) - Z.of_nat (level b_ (snd p)) |}.

(* `Loop s l`: from s on the loop visits l and then ends, and has read nothing outside. *)
Inductive Loop : At -> list (nat * nat) -> Prop :=
| Loop_ends s : visit s = Some Ends -> Loop s [(at_a s, at_b s)]
| Loop_goes s s' l : visit s = Some (Goes s') -> Loop s' l -> Loop s ((at_a s, at_b s) :: l).

(* The recursion that it replaces (the paper's algorithm 3, section 8.1): into the node of lower level, into B
   on ties; if one is a leaf, into the other one. *)
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

(* code: ../tests/reference/stackless.hpp | return level_a > level_b ? b.nodes[cursor.b].is_leaf() : level_b - level_a <= 1 || a.nodes[cursor.a].is_leaf(); *)
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

(* From the roots the loop makes the visits of the recursion, in its order, no pair twice, and ends;
   from any of them, knowing nothing else, those that are left. *)
Definition Stackless_is_search := forall depth, deep_enough a_ b_ depth ->
  Loop (start (0, 0)) (visits depth) /\ NoDup (visits depth) /\
  (forall before p rest, visits depth = before ++ p :: rest -> Loop (start p) (p :: rest)).

(* It ends from every pair that can_visit() accepts; those are the pairs that are visited where all
   boxes overlap. *)
Definition Stackless_positions := forall p, inside a_ b_ p ->
  (can_visit a_ b_ p = true -> exists l, Loop (start p) (p :: l)) /\
  (forall depth, deep_enough a_ b_ depth -> can_visit a_ b_ p = true <->
     In p (search a_ b_ (fun _ _ => true) children_a children_b depth (0, 0))).

(* Of all pairs of leaves exactly those that `hit` says yes of are visited and pass it, each once, if what
   is rejected has none of them below it. *)
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

(* Of a node: a last child, another child, or the root. *)
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

Lemma rcl_small k : forall i, i < count -> k <= rcl i ->
  k <= i /\ level (i - k) = level i - k /\ k <= level i /\ rcl (i - k) = rcl i - k.
Proof.
  induction k as [|k IH]; intros i H K; [rewrite Nat.sub_0_r; lia|].
  destruct (kind i H) as [(_ & R & _) | (n & _ & P & V & [(-> & R & _) | (R & _)])]; try lia.
  destruct (IH (i - 1)) as (A1 & A2 & A3 & A4); [lia | lia|].
  replace (i - S k) with (i - 1 - k) by lia. lia.
Qed.

(* As ranks. *)
Variable limit_ : nat.
Hypothesis limit_large : count < limit_.
Variable less : Z.                       (* 1 in A, 0 in B *)
Hypothesis less_small : (0 <= less <= 1)%Z.
Definition level_rank (i : nat) : Z := (2 * (Z.of_nat limit_ - Z.of_nat (level i)) - less)%Z.
Definition node_rank i := if is_leaf (cells m) i then (-1)%Z else level_rank i.

Lemma node_rank_internal i : children i <> [] -> node_rank i = level_rank i.
Proof.
  intros N. unfold node_rank. destruct (is_leaf (cells m) i) eqn:E; auto.
  now apply (leaf_spec _ _ F) in E.
Qed.

Lemma rank_range i : i < count -> (1 <= level_rank i <= Z.of_nat (2 * limit_))%Z.
Proof. intros H. pose proof (level_small i H). unfold level_rank. lia. Qed.

Lemma internal_inside i : children i <> [] -> i < count.
Proof.
  intros N. destruct (children i) as [|x r] eqn:K; [easy|].
  apply (fmt_inside _ _ F i x). rewrite K. now left.
Qed.

Definition level_tree : @Tree (rank_limits limit_).
Proof.
  refine {| Node := nat; root := 0; kids := children; rank := node_rank;
    parent_rank i := if i =? 0 then @top (rank_limits limit_) else (level_rank i + 2)%Z;
    next := arr_next (cells m); up i := i - 1; is_root i := i =? 0; height i := count - i |}; intros.
  - unfold node_rank. split; intros H.
    + apply (leaf_spec _ _ F) in H. now rewrite H.
    + destruct (is_leaf (cells m) n) eqn:E; [now apply (leaf_spec _ _ F) in E|].
      destruct (children n) as [|x r] eqn:K; auto. exfalso.
      assert (n < count) as I by (apply internal_inside; now rewrite K).
      pose proof (rank_range n I). lia.
  - rewrite node_rank_internal by auto. apply rank_range. now apply internal_inside.
  - assert (children n <> []) as N by (intros K; rewrite K in *; easy).
    rewrite (node_rank_internal n N). pose proof (rank_range n (internal_inside n N)).
    unfold node_rank. destruct (is_leaf (cells m) x); [lia|].
    pose proof (level_of_kid _ _ _ _ L n x ltac:(auto)) as V. fold (level x) (level n) in V.
    unfold level_rank. lia.
  - assert (children n <> []) as N by (intros K; rewrite K in *; easy).
    rewrite (node_rank_internal n N). pose proof (after_parent' _ _ F n x ltac:(auto)).
    pose proof (level_of_kid _ _ _ _ L n x ltac:(auto)) as V. fold (level x) (level n) in V.
    unfold level_rank. destruct (Nat.eqb_spec x 0); lia.
  - reflexivity.
  - now apply (Ranked.next_of_kid (array_tree _ _ F) n l x y r).
  - now apply (Ranked.next_of_last (array_tree _ _ F) n l x).
  - reflexivity.
  - now apply (Ranked.up_of_last (array_tree _ _ F) n l x).
  - reflexivity.
  - now apply (Ranked.kid_is_not_root (array_tree _ _ F) n x).
  - pose proof (after_parent' _ _ F n x ltac:(auto)).
    pose proof (fmt_inside _ _ F n x ltac:(auto)). unfold count. lia.
Defined.

Lemma level_tree_inside i : Under (T := level_tree) 0 i <-> i < count.
Proof.
  split.
  - intros U. assert (forall n x, Under (T := level_tree) n x -> n < count -> x < count) as G.
    { induction 1 as [|n x y I U' IH]; auto. intros H. apply IH. now apply (fmt_inside _ _ F) in I. }
    apply (G 0 i U). apply (fmt_some _ _ F).
  - intros H. induction i as [i IH] using lt_wf_ind.
    destruct (Nat.eq_dec i 0) as [->|Z]; [constructor|].
    destruct (fmt_all _ _ F i) as [n I]; [unfold count in *; lia|].
    pose proof (after_parent' _ _ F _ _ I).
    apply (Under_trans level_tree 0 n i); [apply IH; lia|].
    apply (Under_kid (T := level_tree) n i i); auto.
Qed.

Lemma same_under n x : Under (T := level_tree) n x -> Under (T := array_tree _ _ F) n x.
Proof. induction 1; [constructor | econstructor; eauto]. Qed.
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
    { apply (internal_inside b_ children_b FB). intros N. apply (leaf_spec _ _ FB) in N. congruence. }
    pose proof (rank_range b_ children_b FB LB most_ fits_b 0 small_0 b I).
    destruct (Z.ltb_spec (-1) (level_rank b_ most_ 0 b)); [reflexivity | lia].
  - rewrite orb_true_r. assert (a < length (cells a_)) as I.
    { apply (internal_inside a_ children_a FA). intros N. apply (leaf_spec _ _ FA) in N. congruence. }
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

(* ---- A step up. *)

Definition Up (a b : nat) (s : State A B) : Prop := turn (Behind (here a b)) = s.

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

Lemma up_in_a a b : inside (a, b) -> level_b b <= level_a a ->
  match rcl_a a with
  | S _ => Up a b (Behind (here (a - 1) b))
  | O => if a =? 0 then Up a b Done else exists s, link a_ a = Some s /\ Up a b (Visit (here s b))
  end.
Proof.
  intros I V. pose proof I as [Ia Ib]. cbn [fst snd] in *. unfold Up, here. cbn [Ranked.turn].
  rewrite (into_b a b I). destruct (Nat.ltb_spec (level_a a) (level_b b)); [lia|]. cbn [orb].
  destruct (kind a_ children_a FA LA a Ia) as [(-> & R & Va) | (n & _ & Pa & Va & K)].
  - rewrite R. destruct (kind b_ children_b FB LB b Ib) as [(-> & _ & Vb) | (n' & _ & Pb & Vb & _)]; [|lia].
    reflexivity.
  - destruct (Nat.eqb_spec a 0); [lia|]. cbn [andb A level_tree next up].
    destruct K as [(-> & R & N) | (R & s & N & _ & K)]; rewrite R, N; [reflexivity|].
    exists s. now split.
Qed.

Lemma up_in_b a b : inside (a, b) -> level_a a < level_b b ->
  b <> 0 /\ match rcl_b b with
  | S _ => Up a b (Behind (here a (b - 1)))
  | O => exists s, link b_ b = Some s /\ Up a b (Visit (here a s))
  end.
Proof.
  intros I V. pose proof I as [Ia Ib]. cbn [fst snd] in *. unfold Up, here. cbn [Ranked.turn].
  rewrite (into_b a b I). destruct (Nat.ltb_spec (level_a a) (level_b b)); [|lia]. cbn [orb].
  destruct (kind b_ children_b FB LB b Ib) as [(-> & R & Vb) | (n & _ & Pb & Vb & K)]; [lia|].
  split; [lia|]. cbn [B level_tree next up is_root]. destruct (Nat.eqb_spec b 0); [lia|].
  destruct K as [(-> & R & N) | (R & s & N & _ & K)]; rewrite R, N; [reflexivity|].
  exists s. now split.
Qed.

(* Turns up to the next visit or the end. *)
Inductive Climbs : nat -> nat -> State A B -> Prop :=
| Climbed a b s : Up a b s -> (forall p, s <> Behind p) -> Climbs a b s
| Climbing a b a' b' s : Up a b (Behind (here a' b')) -> Climbs a' b' s -> Climbs a b s.

Lemma rcl_a_small k a : a < length (cells a_) -> k <= rcl_a a ->
  k <= a /\ level_a (a - k) = level_a a - k /\ k <= level_a a /\ rcl_a (a - k) = rcl_a a - k.
Proof. apply (rcl_small a_ children_a FA LA). Qed.
Lemma rcl_b_small k b : b < length (cells b_) -> k <= rcl_b b ->
  k <= b /\ level_b (b - k) = level_b b - k /\ k <= level_b b /\ rcl_b (b - k) = rcl_b b - k.
Proof. apply (rcl_small b_ children_b FB LB). Qed.

Lemma climb_a k : forall a b s, inside (a, b) -> k <= rcl_a a -> level_b b + k <= S (level_a a) ->
  Climbs (a - k) b s -> Climbs a b s.
Proof.
  induction k as [|k IH]; intros a b s I K V C; [now rewrite Nat.sub_0_r in C|].
  pose proof I as [Ia Ib]. cbn [fst snd] in *. destruct (rcl_a_small 1 a Ia) as (P & V' & _ & R); [lia|].
  pose proof (up_in_a a b I) as U. destruct (rcl_a a); [lia|].
  eapply Climbing; [apply U; lia|]. replace (a - S k) with (a - 1 - k) in C by lia.
  apply IH; auto; try lia. split; cbn [fst snd]; lia.
Qed.
Lemma climb_b k : forall a b s, inside (a, b) -> k <= rcl_b b -> level_a a + k <= level_b b ->
  Climbs a (b - k) s -> Climbs a b s.
Proof.
  induction k as [|k IH]; intros a b s I K V C; [now rewrite Nat.sub_0_r in C|].
  pose proof I as [Ia Ib]. cbn [fst snd] in *. destruct (rcl_b_small 1 b Ib) as (P & V' & _ & R); [lia|].
  pose proof (up_in_b a b I) as U. destruct (rcl_b b); [lia|].
  eapply Climbing; [apply U; lia|]. replace (b - S k) with (b - 1 - k) in C by lia.
  apply IH; auto; try lia. split; cbn [fst snd]; lia.
Qed.

(* A left child, or the root, is reached in A or in B. *)
Definition reached_a (a b : nat) (s : State A B) : Prop :=
  exists to, link a_ a = Some to /\ s = if a =? 0 then Done else Visit (here to b).
Definition reached_b (a b : nat) (s : State A B) : Prop :=
  exists to, link b_ b = Some to /\ b <> 0 /\ s = Visit (here a to).

Lemma link_some m children (F : Post_indexed (cells m) children) i : i < length (cells m) -> exists to, link m i = Some to.
Proof. intros H. unfold link. rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0)) by exact H. cbn. eauto. Qed.

Lemma reach_a a b : inside (a, b) -> rcl_a a = 0 -> level_b b <= level_a a ->
  exists s, reached_a a b s /\ Climbs a b s.
Proof.
  intros I R V. pose proof (up_in_a a b I V) as U. rewrite R in U. unfold reached_a.
  destruct (Nat.eqb_spec a 0) as [E|_].
  - destruct (link_some _ _ FA a (proj1 I)) as [to E']. exists Done. split; [now exists to|].
    apply Climbed; [exact U | discriminate].
  - destruct U as (to & E & U). exists (Visit (here to b)). split; [now exists to|].
    apply Climbed; [exact U | discriminate].
Qed.
Lemma reach_b a b : inside (a, b) -> rcl_b b = 0 -> level_a a < level_b b ->
  exists s, reached_b a b s /\ Climbs a b s.
Proof.
  intros I R V. pose proof (up_in_b a b I V) as [Z U]. rewrite R in U. destruct U as (to & E & U).
  exists (Visit (here a to)). split; [now exists to|]. apply Climbed; [exact U | discriminate].
Qed.

(* From equal levels, by turns in A and in B. *)
Lemma alternate ra : forall a b, inside (a, b) -> level_a a = level_b b -> rcl_a a = ra ->
  if ra <=? rcl_b b then exists s, reached_a (a - ra) (b - ra) s /\ Climbs a b s
  else exists s, reached_b (a - (rcl_b b + 1)) (b - rcl_b b) s /\ Climbs a b s.
Proof.
  induction ra as [|ra IH]; intros a b I V R; pose proof I as [Ia Ib]; cbn [fst snd] in *.
  { cbn [Nat.leb]. rewrite !Nat.sub_0_r. apply reach_a; auto. lia. }
  destruct (rcl_a_small 1 a Ia) as (P1 & V1 & L1 & R1); [lia|].
  pose proof (up_in_a a b I) as U. rewrite R in U. specialize (U ltac:(lia)).
  assert (inside (a - 1, b)) as I1 by (split; cbn [fst snd]; lia).
  destruct (rcl_b b) as [|rb] eqn:Rb.
  - cbn [Nat.leb]. rewrite Nat.add_0_l, Nat.sub_0_r.
    destruct (reach_b (a - 1) b I1 Rb) as (s & E & C); [lia|]. exists s. split; auto.
    now apply (Climbing _ _ (a - 1) b).
  - destruct (rcl_b_small 1 b Ib) as (P2 & V2 & L2 & R2); [lia|].
    pose proof (up_in_b (a - 1) b I1) as U'. rewrite Rb in U'. destruct U' as [_ U']; [lia|].
    assert (inside (a - 1, b - 1)) as I2 by (split; cbn [fst snd]; lia).
    specialize (IH (a - 1) (b - 1) I2 ltac:(lia) ltac:(lia)).
    replace (rcl_b (b - 1)) with rb in IH by lia. cbn [Nat.leb].
    destruct (ra <=? rb).
    + replace (a - 1 - ra) with (a - S ra) in IH by lia. replace (b - 1 - ra) with (b - S ra) in IH by lia.
      destruct IH as (s & E & C). exists s. split; auto.
      apply (Climbing _ _ (a - 1) b); [exact U|]. now apply (Climbing _ _ (a - 1) (b - 1)).
    + replace (a - 1 - (rb + 1)) with (a - (S rb + 1)) in IH by lia.
      replace (b - 1 - rb) with (b - S rb) in IH by lia.
      destruct IH as (s & E & C). exists s. split; auto.
      apply (Climbing _ _ (a - 1) b); [exact U|]. now apply (Climbing _ _ (a - 1) (b - 1)).
Qed.

(* ---- next() does those turns at once. *)

Definition turned (s : State A B) : Turned :=
  match s with Visit p => Goes (start (fst p, snd p)) | _ => Ends end.

Definition arrives (s : State A B) : Prop :=
  match s with Visit p => inside (fst p, snd p) | _ => True end.

Lemma read_rcl m children (L : Levelled children (length (cells m)) (levels m) (rcls m)) i :
  i < length (cells m) -> nth_error (rcls m) i = Some (rcl m i).
Proof. intros H. apply nth_error_nth'. now rewrite (rcl_count _ _ _ _ L). Qed.

Lemma link_level m children (F : Post_indexed (cells m) children)
  (L : Levelled children (length (cells m)) (levels m) (rcls m)) i to :
  i < length (cells m) -> rcl m i = 0 -> i <> 0 -> link m i = Some to ->
  level m to = level m i /\ to < length (cells m).
Proof.
  intros H R Z E. destruct (kind m children F L i H) as [(-> & _) | (n & _ & _ & V & [(_ & R' & _) | (_ & s & _ & I & K)])];
    [easy | lia|].
  rewrite K in E. injection E as <-. rewrite V. split; [apply (level_of_kid _ _ _ _ L _ _ I)|].
  now apply (fmt_inside _ _ F) in I.
Qed.

Lemma land_a x y s to l : reached_a x y s -> rcl_a x = 0 -> inside (x, y) -> link a_ x = Some to ->
  l = (Z.of_nat (level_a x) - Z.of_nat (level_b y))%Z -> goes x to y l = Some (turned s) /\ arrives s.
Proof.
  intros (to' & E & ->) R [I J] K ->. rewrite K in E. injection E as <-. unfold goes.
  destruct (Nat.eqb_spec x 0); [now split|]. unfold turned, Stackless.start, here. cbn [fst snd].
  destruct (link_level a_ children_a FA LA x to I R) as [-> H]; auto. now repeat split.
Qed.
Lemma land_b x y s to l : reached_b x y s -> rcl_b y = 0 -> inside (x, y) -> link b_ y = Some to ->
  l = (Z.of_nat (level_a x) - Z.of_nat (level_b y))%Z -> goes y x to l = Some (turned s) /\ arrives s.
Proof.
  intros (to' & E & Z & ->) R [J I] K ->. rewrite K in E. injection E as <-. unfold goes.
  destruct (Nat.eqb_spec y 0); [easy|]. unfold turned, Stackless.start, here. cbn [fst snd].
  destruct (link_level b_ children_b FB LB y to I R) as [-> H]; auto. now repeat split.
Qed.

Lemma up_is i count : count <= i -> level_up i count = Some (i - count).
Proof. intros H. unfold level_up. now rewrite (proj2 (Nat.leb_le _ _) H). Qed.

Lemma next_climbs a b : inside (a, b) ->
  exists s, Climbs a b s /\ next_ a_ b_ (start (a, b)) = Some (turned s) /\ arrives s.
Proof.
  intros I. pose proof I as [Ia Ib]. cbn [fst snd] in *.
  destruct (rcl_a_small (rcl_a a) a Ia (le_n _)) as (A1 & A2 & A3 & A4).
  destruct (rcl_b_small (rcl_b b) b Ib (le_n _)) as (B1 & B2 & B3 & B4).
  destruct (link_some _ _ FA (a - rcl_a a)) as [ta Ta]; [lia|].
  destruct (link_some _ _ FB (b - rcl_b b)) as [tb Tb]; [lia|].
  unfold next_, Stackless.start, next_of_a, next_of_b, escape_from. cbn [fst snd lead at_a at_b].
  rewrite (read_rcl a_ _ LA a Ia), (read_rcl b_ _ LB b Ib), (up_is a (rcl_a a) A1), (up_is b (rcl_b b) B1).
  rewrite Ta, Tb. destruct (Z.leb_spec 0 (Z.of_nat (level_a a) - Z.of_nat (level_b b))) as [V|V].
  - replace (Z.to_nat _) with (level_a a - level_b b) by lia. set (l := level_a a - level_b b).
    destruct (Nat.leb_spec (rcl_a a) l) as [C|C].
    + destruct (reach_a (a - rcl_a a) b) as (s & E & G); [split; cbn [fst snd]; lia | lia | lia|].
      exists s. split; [apply (climb_a (rcl_a a)); auto; lia|].
      apply (land_a _ _ _ _ _ E); auto; try lia. split; cbn [fst snd]; lia.
    + destruct (rcl_a_small l a Ia) as (D1 & D2 & D3 & D4); [lia|].
      assert (inside (a - l, b)) as I' by (split; cbn [fst snd]; lia).
      pose proof (alternate (rcl_a a - l) (a - l) b I' ltac:(lia) ltac:(lia)) as G.
      destruct (Nat.leb_spec (rcl_a a - l) (rcl_b b)) as [H|H]; destruct G as (s & E & G); exists s.
      * split; [apply (climb_a l); auto; lia|]. rewrite up_is by lia.
        replace (a - l - (rcl_a a - l)) with (a - rcl_a a) in E by lia.
        destruct (rcl_b_small (rcl_a a - l) b Ib H) as (F1 & F2 & F3 & F4).
        apply (land_a _ _ _ _ _ E); auto; try lia. split; cbn [fst snd]; lia.
      * split; [apply (climb_a l); auto; lia|]. rewrite up_is by lia.
        replace (a - l - (rcl_b b + 1)) with (a - (l + rcl_b b + 1)) in E by lia.
        destruct (rcl_a_small (l + rcl_b b + 1) a Ia) as (F1 & F2 & F3 & F4); [lia|].
        apply (land_b _ _ _ _ _ E); auto; try lia. split; cbn [fst snd]; lia.
  - replace (Z.to_nat _) with (level_b b - level_a a) by lia. set (l := level_b b - level_a a).
    destruct (Nat.ltb_spec (rcl_b b) l) as [C|C].
    + destruct (reach_b a (b - rcl_b b)) as (s & E & G); [split; cbn [fst snd]; lia | lia | lia|].
      exists s. split; [apply (climb_b (rcl_b b)); auto; lia|].
      apply (land_b _ _ _ _ _ E); auto; try lia. split; cbn [fst snd]; lia.
    + destruct (rcl_b_small l b Ib) as (D1 & D2 & D3 & D4); [lia|].
      assert (inside (a, b - l)) as I' by (split; cbn [fst snd]; lia).
      pose proof (alternate (rcl_a a) a (b - l) I' ltac:(lia) eq_refl) as G. rewrite D4 in G.
      destruct (Nat.leb_spec (rcl_a a) (rcl_b b - l)) as [H|H]; destruct G as (s & E & G); exists s.
      * split; [apply (climb_b l); auto; lia|]. rewrite up_is by lia.
        replace (b - l - rcl_a a) with (b - (rcl_a a + l)) in E by lia.
        destruct (rcl_b_small (rcl_a a + l) b Ib) as (F1 & F2 & F3 & F4); [lia|].
        apply (land_a _ _ _ _ _ E); auto; try lia. split; cbn [fst snd]; lia.
      * split; [apply (climb_b l); auto; lia|]. rewrite up_is by lia.
        replace (b - l - (rcl_b b - l)) with (b - rcl_b b) in E by lia.
        destruct (rcl_a_small (rcl_b b - l + 1) a Ia) as (F1 & F2 & F3 & F4); [lia|].
        apply (land_b _ _ _ _ _ E); auto; try lia. split; cbn [fst snd]; lia.
Qed.

Lemma read_leaf m i : i < length (cells m) -> leaf_at m i = Some (is_leaf (cells m) i).
Proof.
  intros H. unfold leaf_at, is_leaf, cell.
  now rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0) H).
Qed.

(* Of an internal node: the link of the node behind it. *)
Lemma read_first m children (F : Post_indexed (cells m) children) i x r :
  children i = x :: r -> first_child m i = Some x.
Proof.
  intros K. unfold first_child, link. destruct (@exists_last _ (x :: r) ltac:(easy)) as (l & z & E).
  rewrite E in K. pose proof (fmt_last _ _ F _ _ _ K) as [-> _].
  assert (In (i + 1) (children i)) as I by (rewrite K; apply in_elt).
  apply (fmt_inside _ _ F) in I as [_ I]. rewrite <- E in K.
  rewrite (nth_error_nth' _ (Build_Cell 0 (-1) 0) I). cbn. f_equal. apply (fmt_first _ _ F _ _ _ K).
Qed.

Lemma descend_is a b : inside (a, b) -> descend a_ b_ (start (a, b)) =
  Some (match into (a, b) with q :: _ => Some (start q) | [] => None end).
Proof.
  intros [Ia Ib]. cbn [fst snd] in *. unfold descend, Stackless.into, Stackless.start.
  cbn [fst snd at_a at_b lead]. rewrite (read_leaf a_ a Ia), (read_leaf b_ b Ib).
  replace (Z.of_nat (level_a a) - Z.of_nat (level_b b) <? 0)%Z with (level_a a <? level_b b)
    by (destruct (Nat.ltb_spec (level_a a) (level_b b)); symmetry; [apply Z.ltb_lt | apply Z.ltb_ge]; lia).
  destruct ((_ || _) && _) eqn:E.
  - apply andb_prop in E as [_ E]. apply negb_true_iff in E.
    destruct (children_a a) as [|x r] eqn:K; [apply (leaf_spec _ _ FA) in K; congruence|].
    rewrite (read_first a_ _ FA a x r K). cbn [map fst snd].
    assert (In x (children_a a)) as I by (rewrite K; now left).
    pose proof (level_of_kid _ _ _ _ LA _ _ I) as V. fold (level_a x) (level_a a) in V. rewrite V.
    do 3 f_equal. lia.
  - destruct (is_leaf (cells b_) b) eqn:Lb; cbn [negb].
    + apply (leaf_spec _ _ FB) in Lb. now rewrite Lb.
    + destruct (children_b b) as [|x r] eqn:K; [apply (leaf_spec _ _ FB) in K; congruence|].
      rewrite (read_first b_ _ FB b x r K). cbn [map fst snd].
      assert (In x (children_b b)) as I by (rewrite K; now left).
      pose proof (level_of_kid _ _ _ _ LB _ _ I) as V. fold (level_b x) (level_b b) in V. rewrite V.
      do 3 f_equal. lia.
Qed.

(* ---- So the loop is Ranked.v's. *)

Lemma climbs_run a b s : Climbs a b s -> forall n t, RunTo n (Behind (here a b)) t Done ->
  exists m, m < n /\ RunTo m s t Done.
Proof.
  induction 1 as [a b s U _ | a b a' b' s U _ IH]; intros n t R;
    (destruct n as [|n]; [destruct R; discriminate|]).
  - exists n. split; [lia|]. destruct R as [R1 R2]. cbn [after trace app] in R1, R2.
    unfold Up in U. rewrite U in R1, R2. now split.
  - assert (RunTo n (Behind (here a' b')) t Done) as R'.
    { destruct R as [R1 R2]. cbn [after trace app] in R1, R2. unfold Up in U. rewrite U in R1, R2. now split. }
    destruct (IH n t R') as (m & H & Q). exists m. split; [lia | exact Q].
Qed.

Lemma climbs_end a b s : Climbs a b s -> forall p, s <> Behind p.
Proof. now induction 1. Qed.

Lemma into_inside p q : inside p -> In q (into p) -> inside q.
Proof.
  destruct p as [a b], q as [a' b']. intros I Q. rewrite <- (same_expand a b) in Q.
  apply (in_trees a' b'). apply (In_trees_child A B (here a b)); [now apply in_trees | exact Q].
Qed.

Lemma run_loop n : forall a b t, inside (a, b) -> RunTo n (Visit (here a b)) t Done ->
  exists l, t = (a, b) :: l /\ Loop a_ b_ overlap (start (a, b)) t.
Proof.
  induction n as [n IH] using lt_wf_ind. intros a b t I R.
  destruct n as [|n]; [destruct R; discriminate|].
  assert (exists t', t = (a, b) :: t' /\ RunTo n (turn (Visit (here a b))) t' Done) as (t' & -> & R').
  { destruct R as [R1 R2]. cbn [after trace app] in R1, R2. exists (trace A B overlap n (turn (Visit (here a b)))).
    split; [now rewrite <- R2 | now split]. }
  exists t'. split; auto. rewrite turn_visit in R'. unfold descents in R'. rewrite same_expand in R'.
  cbn [here fst snd] in R'.
  assert (visit a_ b_ overlap (start (a, b)) = next_ a_ b_ (start (a, b)) ->
    RunTo n (Behind (here a b)) t' Done -> Loop a_ b_ overlap (start (a, b)) ((a, b) :: t')) as Go.
  { intros E Q. destruct (next_climbs a b I) as (s & C & N & J). rewrite N in E.
    destruct (climbs_run a b s C n t' Q) as (m & H & Q').
    destruct s as [[a' b'] | p |]; [| now destruct (climbs_end _ _ _ C p) |].
    - destruct (IH m ltac:(lia) a' b' t' J Q') as (l & -> & G).
      now apply (Loop_goes a_ b_ overlap (start (a, b)) (start (a', b'))).
    - assert (t' = []) as -> by (destruct Q' as [_ <-]; apply (done_stays A B overlap m)).
      now apply (Loop_ends a_ b_ overlap (start (a, b))). }
  unfold visit in Go. cbn [Stackless.start at_a at_b fst snd] in Go.
  rewrite (descend_is a b I) in Go. destruct (overlap a b) eqn:O; [|now apply Go].
  destruct (into (a, b)) as [|[a' b'] r] eqn:K; [now apply Go|].
  destruct (IH n ltac:(lia) a' b' t') as (l & -> & G); auto.
  { apply (into_inside (a, b)); auto. rewrite K. now left. }
  apply (Loop_goes a_ b_ overlap (start (a, b)) (start (a', b'))); auto.
  unfold visit. cbn [Stackless.start at_a at_b fst snd]. now rewrite O, (descend_is a b I), K.
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
  - destruct (run_loop _ 0 0 _ roots_inside W) as (_ & _ & G). exact G.
  - intros l [a b] r E. destruct (resumes A B overlap d l (here a b) r D E) as (n & R).
    enough (inside (a, b)) as I by (destruct (run_loop n a b _ I R) as (_ & _ & G); exact G).
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
  destruct (run_loop n a b t I R) as (l & -> & G). now exists l.
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

(* The premises can be met; the walk of two small trees, of which the second has one child a node. *)
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
