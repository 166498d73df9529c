(* The code of a walk on the arrays of mesh.hpp: ranked.hpp, the loop of walk.hpp over pairs of nodes, the loop of
   walk_below.hpp over the nodes below a leaf with planes, and subtree.hpp. It makes the visits of Ranked.v.

   Part 1  definitions: the array's format, the code.
   Part 2  the theorem, and its proof. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants Ranked.
Import ListNotations.

(* ============================================================== Part 1: definitions *)

(* A node without its box; in a leaf, c_parent_rank has no meaning. *)
Record Cell := { c_link : nat; c_rank : Z; c_parent_rank : Z }.

Definition cell (cells : list Cell) (i : nat) : Cell := nth i cells (Build_Cell 0 (-1) 0).
Definition is_leaf (cells : list Cell) (i : nat) : bool := (c_rank (cell cells i) <? 0)%Z.

(* The format. `children` is the intended tree. *)
Record Post_indexed (cells : list Cell) (children : nat -> list nat) : Prop := {
  fmt_some : 0 < length cells;
  fmt_inside : forall n x, In x (children n) -> n < length cells /\ x < length cells;
  fmt_all : forall i, 0 < i < length cells -> exists n, In i (children n);
  fmt_sibling : forall n l x y r, children n = l ++ x :: y :: r ->
    c_link (cell cells x) = y /\ y < x;
  fmt_last : forall n l x, children n = l ++ [x] -> x = n + 1 /\ x <= c_link (cell cells x);
  fmt_first : forall n x r, children n = x :: r -> c_link (cell cells (n + 1)) = x;
  fmt_leaf : forall n, children n = [] <-> (c_rank (cell cells n) < 0)%Z;
  fmt_rank : forall n, children n <> [] -> (1 <= c_rank (cell cells n) <= kMaxRank)%Z;
  fmt_monotone : forall n x, In x (children n) ->
    (c_rank (cell cells x) <= c_rank (cell cells n))%Z;
  fmt_parent_rank : forall n x, In x (children n) -> children x <> [] ->
    c_parent_rank (cell cells x) = c_rank (cell cells n);
  fmt_root_parent_rank : children 0 <> [] -> c_parent_rank (cell cells 0) = kRootParentRank
}.

Section Place.
Variable cells : list Cell.

(* Ranked::Place. *)
Record Place := { node : nat; place_rank : Z  (* parent_rank *) }.

Definition first_child (i : nat) : nat := c_link (cell cells (i + 1)).

(* code: include/flashbvh/traversal/ranked.hpp | node = root + node[1].link; *)
Definition descend (p : Place) (rank : Z) : Place :=
  {| node := first_child (node p); place_rank := rank |}.

(* code: include/flashbvh/traversal/ranked.hpp | const NodeType* const next = root + node->link; if (next < node) { *)
Definition next_sibling (p : Place) : option Place :=
  let i := c_link (cell cells (node p)) in
  if i <? node p then Some {| node := i; place_rank := place_rank p |} else None.

(* code: include/flashbvh/traversal/ranked.hpp | --node; parent_rank = node->parent_rank(); *)
Definition ascend (p : Place) : Place :=
  let i := node p - 1 in {| node := i; place_rank := c_parent_rank (cell cells i) |}.

(* The loop, which ends after at most `fuel` turns. *)
(* code: include/flashbvh/traversal/ranked.hpp | while (tree.nodes[index].link < index) { *)
(* code: include/flashbvh/traversal/ranked.hpp | return tree.nodes[index - 1].rank(); *)
Fixpoint last_sibling (fuel i : nat) : nat :=
  match fuel with
  | O => i
  | S f => if c_link (cell cells i) <? i then last_sibling f (c_link (cell cells i)) else i
  end.

Definition find_parent_rank (i : nat) : Z :=
  if i =? 0 then kRootParentRank else c_rank (cell cells (last_sibling i i - 1)).

(* Place's constructor. *)
Definition place (i : nat) : Place := {| node := i; place_rank := find_parent_rank i |}.
End Place.

Inductive Side := NoLeaf | LeafA | LeafB.

Section Code.
Variables cells_a cells_b : list Cell.
(* The tests of a pair: two boxes; a leaf's slabs against the box with which it was reached; window and slabs of the
   leaf of `Side` against a box below. They are functions of the pair. *)
Variable bound : nat -> nat -> bool.
Variable begin : nat -> nat -> bool.
Variable touch : Side -> nat -> nat -> bool.

(* Ranked::leaf() *)
(* code: include/flashbvh/traversal/ranked.hpp | const bool below_leaf = into_b ? a_.node->is_leaf() : b_.node->is_leaf(); *)
Definition leaf (a b : Place) : Side :=
  if (place_rank b <=? place_rank a)%Z
  then if is_leaf cells_a (node a) then LeafA else NoLeaf
  else if is_leaf cells_b (node b) then LeafB else NoLeaf.

(* The place in the code; `resumed`: in walk_on_below(), not walk_pairs(). *)
Inductive Code :=
| CVisit (a b : Place)                       (* walk_pairs(), before a visit *)
| CBehind (resumed : bool) (a b : Place)     (* before a turn of next() *)
| CBelow (resumed visit : bool) (side : Side) (a b : Place) (i : nat)
    (* walk_below(): at node i below a or b; the other one is the leaf *)
| CDone.

(* The head of walk_on_below()'s loop: from a pair, or from behind it. *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | run.side = at.leaf(); *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | run.node = at.leaf_node(); *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | const State end = walk_below(shapes, run, at.leaf_root(), after); *)
Definition enter (visit : bool) (a b : Place) : Code :=
  match leaf a b with
  | NoLeaf => if visit then CVisit a b else CBehind false a b
  | LeafA => CBelow true visit LeafA a b (node b)
  | LeafB => CBelow true visit LeafB a b (node a)
  end.

(* A turn of Ranked::next(). *)
(* code: include/flashbvh/traversal/ranked.hpp | if (b_.parent_rank <= a_.parent_rank) { if (b_.next_sibling()) { return true; } *)
(* code: include/flashbvh/traversal/ranked.hpp | if (b_.node == b_.root) { return false; } b_.ascend(); *)
(* code: include/flashbvh/traversal/ranked.hpp | if (a_.next_sibling()) { return true; } a_.ascend(); *)
Definition next_turn (resumed : bool) (a b : Place) : Code :=
  let arrive a b := if resumed then enter true a b else CVisit a b in
  if (place_rank b <=? place_rank a)%Z then
    match next_sibling cells_b b with
    | Some sibling => arrive a sibling
    | None => if node b =? 0 then CDone else CBehind resumed a (ascend cells_b b)
    end
  else
    match next_sibling cells_a a with
    | Some sibling => arrive sibling b
    | None => CBehind resumed (ascend cells_a a) b
    end.

(* The pair of a node below a leaf and the leaf. *)
Definition pair_below (side : Side) (a b : Place) (i : nat) : nat * nat :=
  match side with LeafB => (i, node b) | _ => (node a, i) end.

(* code: include/flashbvh/traversal/ranked.hpp | if (rank_a < rank_b) { b_.descend(rank_b); } else { a_.descend(rank_a); } *)
(* code: include/flashbvh/detail/walk/walk.hpp | return (a.rank() | b.rank()) >= 0; *)
(* code: include/flashbvh/detail/walk/walk.hpp | if (!are_inner(at.node_a(), at.node_b())) { return false; } at.descend_inner(may_matter); *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | run.side = leaf_a ? Side::a : Side::b; run.leaf = leaf_a ? a : b; run.node = leaf_a ? b : a; *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | const uint32_t root = run.node; run.node = (run.side == Side::a ? shapes.b : shapes.a).first_child(root); return walk_below(shapes, run, root, false); *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | if (!shapes.begin(run.side, run.leaf, &(leaf_a ? node_b : node_a)->box)) { *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | if (shapes.may_touch(at.node().box)) { ++overlaps; if (!at.node().is_leaf()) { at.descend(); continue; } *)
(* code: include/flashbvh/detail/walk/subtree.hpp | while (node_ != root_) { const NodeType* const sibling = nodes_ + node_->link; if (sibling < node_) { node_ = sibling; return true; } --node_; } *)
(* code: include/flashbvh/detail/walk/subtree.hpp | void descend() { node_ = nodes_ + node_[1].link; } *)
Definition code_turn (c : Code) : Code :=
  match c with
  | CVisit a b =>
      let rank_a := c_rank (cell cells_a (node a)) in
      let rank_b := c_rank (cell cells_b (node b)) in
      if bound (node a) (node b) then
        match is_leaf cells_a (node a), is_leaf cells_b (node b) with
        | false, false =>                                            (* descend_inner() *)
            if (rank_a <? rank_b)%Z then CVisit a (descend cells_b b rank_b)
            else CVisit (descend cells_a a rank_a) b
        | true, true => CBehind false a b                            (* reach_leaf(): found *)
        | true, false =>
            if begin (node a) (node b) then
              CBelow false true LeafA a b (first_child cells_b (node b))
            else CBehind false a b
        | false, true =>
            if begin (node a) (node b) then
              CBelow false true LeafB a b (first_child cells_a (node a))
            else CBehind false a b
        end
      else CBehind false a b
  | CBehind resumed a b => next_turn resumed a b
  | CBelow resumed true side a b i =>
      let cells := match side with LeafB => cells_a | _ => cells_b end in
      let (x, y) := pair_below side a b i in
      if touch side x y then
        if is_leaf cells i then CBelow resumed false side a b i      (* found *)
        else CBelow resumed true side a b (first_child cells i)
      else CBelow resumed false side a b i
  | CBelow resumed false side a b i =>                               (* Subtree::next() *)
      let (cells, root) := match side with LeafB => (cells_a, node a) | _ => (cells_b, node b) end in
      let link := c_link (cell cells i) in
      if i =? root then next_turn resumed a b
      else if link <? i then CBelow resumed true side a b link
      else CBelow resumed false side a b (i - 1)
  | CDone => CDone
  end.

Fixpoint code_after (n : nat) (c : Code) : Code :=
  match n with O => c | S m => code_after m (code_turn c) end.

(* The pair that a turn visits, and whether it finds a pair of leaves. *)
Definition visited (c : Code) : option (nat * nat) :=
  match c with
  | CVisit a b => Some (node a, node b)
  | CBelow _ true side a b i => Some (pair_below side a b i)
  | _ => None
  end.

Definition finds (c : Code) : bool :=
  match c with
  | CVisit a b => bound (node a) (node b) && is_leaf cells_a (node a) && is_leaf cells_b (node b)
  | CBelow _ true side a b i =>
      let (x, y) := pair_below side a b i in
      touch side x y && is_leaf (match side with LeafB => cells_a | _ => cells_b end) i
  | _ => false
  end.

(* walk() from a cursor: at the roots of a fresh walk; or from a pair or behind it. *)
Definition begin_walk : Code := CVisit (place cells_a 0) (place cells_b 0).
Definition resume_walk (visit : bool) (p : nat * nat) : Code :=
  enter visit (place cells_a (fst p)) (place cells_b (snd p)).

(* All tests of a pair, as one function. *)
Definition side_of (a b : nat) : Side :=
  if (a =? 0) && (b =? 0) then NoLeaf else leaf (place cells_a a) (place cells_b b).
Definition tested (a b : nat) : bool :=
  match side_of a b with
  | NoLeaf =>
      bound a b && (eqb (is_leaf cells_a a) (is_leaf cells_b b) || begin a b)
  | side => touch side a b
  end.
End Code.

(* ============================================================== Part 2: the theorem *)

Section ArrayIsTree.
Variable cells : list Cell.
Variable children : nat -> list nat.
Hypothesis F : Post_indexed cells children.

Lemma after_parent n l x r : children n = l ++ x :: r -> n < x.
Proof.
  revert l x. induction r as [|y r IH]; intros l x K.
  - apply (fmt_last _ _ F) in K. lia.
  - pose proof (fmt_sibling _ _ F _ _ _ _ _ K).
    specialize (IH (l ++ [x]) y). rewrite <- app_assoc in IH. specialize (IH K). lia.
Qed.

Lemma after_parent' n x : In x (children n) -> n < x.
Proof. intros I. apply in_split in I as (l & r & K). eapply after_parent; eauto. Qed.

Lemma find_last n fuel : forall l x r,
  children n = l ++ x :: r -> x <= fuel -> last_sibling cells fuel x = n + 1.
Proof.
  induction fuel as [|fuel IH]; intros l x r K L.
  - apply after_parent in K. lia.
  - cbn [last_sibling]. destruct r as [|y r].
    + destruct (fmt_last _ _ F _ _ _ K) as [E G].
      destruct (Nat.ltb_spec (c_link (cell cells x)) x); lia.
    + destruct (fmt_sibling _ _ F _ _ _ _ _ K) as [E G]. rewrite E.
      destruct (Nat.ltb_spec y x); [|lia].
      apply (IH (l ++ [x]) y r); [now rewrite <- app_assoc | lia].
Qed.

Lemma find_kid n x : In x (children n) -> find_parent_rank cells x = c_rank (cell cells n).
Proof.
  intros I. pose proof (after_parent' _ _ I). apply in_split in I as (l & r & K).
  unfold find_parent_rank. destruct (Nat.eqb_spec x 0); [lia|].
  rewrite (find_last n x l x r K (le_n _)). now rewrite Nat.add_sub.
Qed.

Definition arr_next (i : nat) : option nat :=
  if c_link (cell cells i) <? i then Some (c_link (cell cells i)) else None.

Program Definition array_tree : Tree := {|
  Node := nat;
  root := 0;
  kids := children;
  rank i := c_rank (cell cells i);
  parent_rank := find_parent_rank cells;
  next := arr_next;
  up i := i - 1;
  is_root i := i =? 0;
  height i := length cells - i;
  rank_of_leaf := fmt_leaf _ _ F;
  rank_of_internal := fmt_rank _ _ F
|}.
Next Obligation. now apply (fmt_monotone _ _ F). Qed.
Next Obligation. now apply find_kid. Qed.
Next Obligation.
  destruct (fmt_sibling _ _ F _ _ _ _ _ H) as [E G]. unfold arr_next. rewrite E.
  destruct (Nat.ltb_spec y x); auto; lia.
Qed.
Next Obligation.
  destruct (fmt_last _ _ F _ _ _ H) as [E G]. unfold arr_next.
  destruct (Nat.ltb_spec (c_link (cell cells x)) x); auto; lia.
Qed.
Next Obligation. apply (fmt_last _ _ F) in H. lia. Qed.
Next Obligation. apply after_parent' in H. now destruct x; [lia|]. Qed.
Next Obligation.
  pose proof (after_parent' _ _ H). apply (fmt_inside _ _ F) in H. lia.
Qed.

Lemma kid_under n x : In x (children n) -> Under (T := array_tree) n x.
Proof. intros I. apply (Under_kid (T := array_tree) n x x); auto. Qed.

Lemma all_under i : i < length cells -> Under (T := array_tree) 0 i.
Proof.
  induction i as [i IH] using lt_wf_ind. intros L.
  destruct (Nat.eq_dec i 0) as [->|Z]; [constructor|].
  destruct (fmt_all _ _ F i) as [n I]; [lia|]. pose proof (after_parent' _ _ I).
  apply (Under_trans array_tree 0 n i); [apply IH; lia | now apply kid_under].
Qed.

Lemma under_inside (n x : nat) : n < length cells -> Under (T := array_tree) n x -> x < length cells.
Proof.
  intros L U. induction U as [|n x y I U IH]; auto. apply IH. now apply (fmt_inside _ _ F) in I.
Qed.

Lemma leaf_spec i : is_leaf cells i = true <-> children i = [].
Proof. unfold is_leaf. rewrite Z.ltb_lt. symmetry. apply (fmt_leaf _ _ F). Qed.

Lemma internal i : is_leaf cells i = false -> exists r, children i = first_child cells i :: r.
Proof.
  intros L. destruct (children i) as [|x r] eqn:K; [apply leaf_spec in K; congruence|].
  exists r. unfold first_child. now rewrite (fmt_first _ _ F _ _ _ K).
Qed.

(* A Place keeps the values that its constructor would find. *)
Lemma place_descend n : In (first_child cells n) (children n) ->
  descend cells (place cells n) (c_rank (cell cells n)) = place cells (first_child cells n).
Proof. intros I. unfold descend, place at 2. cbn [node place]. f_equal. symmetry. now apply find_kid. Qed.

(* An index other than the root's has a parent, and follows a sibling or lies after it. *)
Lemma has_parent i : 0 < i < length cells -> exists n, In i (children n) /\
  (arr_next i = None /\ n = i - 1 \/ exists s, arr_next i = Some s /\ In s (children n) /\ s < i).
Proof.
  intros L. destruct (fmt_all _ _ F i L) as [n I]. exists n. split; auto.
  apply in_split in I as (l & r & K). destruct r as [|s r].
  - left. split; [now apply (next_of_last array_tree n l i)|]. apply (fmt_last _ _ F) in K. lia.
  - right. exists s. split; [now apply (next_of_kid array_tree n l i s r)|].
    split; [rewrite K; apply in_or_app; cbn; auto|]. now apply (fmt_sibling _ _ F _ _ _ _ _ K).
Qed.

Lemma place_next i : i < length cells ->
  next_sibling cells (place cells i) = option_map (place cells) (arr_next i).
Proof.
  intros L. unfold next_sibling, arr_next. cbn [node place place_rank].
  destruct (Nat.ltb_spec (c_link (cell cells i)) i) as [G|]; auto.
  cbn [option_map]. unfold place. do 2 f_equal.
  destruct (has_parent i ltac:(lia)) as (n & I & [[N _] | (s & N & J & _)]);
    unfold arr_next in N; destruct (Nat.ltb_spec (c_link (cell cells i)) i); try lia; try discriminate.
  injection N as <-. now rewrite (find_kid n i I), (find_kid n _ J).
Qed.

Lemma place_ascend i : i < length cells -> In i (children (i - 1)) ->
  ascend cells (place cells i) = place cells (i - 1).
Proof.
  intros L I. unfold ascend, place. cbn [node]. f_equal.
  assert (children (i - 1) <> []) as NL by (intros E; now rewrite E in I).
  destruct (Nat.eq_dec (i - 1) 0) as [Z|Z]; [rewrite Z in *; now apply (fmt_root_parent_rank _ _ F)|].
  destruct (fmt_all _ _ F (i - 1)) as [m J]; [lia|].
  rewrite (fmt_parent_rank _ _ F _ _ J NL). symmetry. now apply find_kid.
Qed.

(* For a node strictly below m: its parent is below m or m, and ranks no higher. *)
Lemma parent_under (m i n : nat) :
  Under (T := array_tree) m i -> i <> m -> In i (children n) ->
  Under (T := array_tree) m n /\ (c_rank (cell cells n) <= c_rank (cell cells m))%Z.
Proof.
  intros U. induction U as [|m x i J U IH]; intros N I; [easy|].
  destruct (Nat.eq_dec i x) as [->|NX].
  - assert (n = m) as ->; [|split; [constructor | lia]].
    apply in_split in I as (l & r & K). apply in_split in J as (l' & r' & K').
    pose proof (find_last _ x _ _ _ K (le_n _)). pose proof (find_last _ x _ _ _ K' (le_n _)). lia.
  - destruct (IH NX I) as [V W]. pose proof (fmt_monotone _ _ F _ _ J).
    split; [eapply (Under_kid (T := array_tree)); eauto | lia].
Qed.

Lemma above_below (m i : nat) : i < length cells -> Under (T := array_tree) m i -> i <> m ->
  i <> 0 /\ (find_parent_rank cells i <= c_rank (cell cells m))%Z.
Proof.
  intros L U N. assert (m <= i) by (clear N L; induction U as [|m x i I]; [|apply after_parent' in I]; lia).
  split; [lia|]. destruct (fmt_all _ _ F i) as [n I]; [lia|]. rewrite (find_kid n i I). now apply (parent_under m i n).
Qed.
End ArrayIsTree.

Section Simulation.
Variables cells_a cells_b : list Cell.
Variables children_a children_b : nat -> list nat.
Hypothesis FA : Post_indexed cells_a children_a.
Hypothesis FB : Post_indexed cells_b children_b.
Variable bound begin : nat -> nat -> bool.
Variable touch : Side -> nat -> nat -> bool.

Let A := array_tree cells_a children_a FA.
Let B := array_tree cells_b children_b FB.
Let overlap : Node A -> Node B -> bool := tested cells_a cells_b bound begin touch.
Let leaf_of := leaf cells_a cells_b.
Let side := side_of cells_a cells_b.
Let step := code_turn cells_a cells_b bound begin touch.

Let rank_a i := c_rank (cell cells_a i).
Let rank_b j := c_rank (cell cells_b j).
Let above_a := find_parent_rank cells_a.
Let above_b := find_parent_rank cells_b.
Definition inside (i j : nat) : Prop := i < length cells_a /\ j < length cells_b.
Definition pair_at (i j : nat) : Pair A B := (i, j).
Definition state_at (visit : bool) (i j : nat) : State A B :=
  if visit then Visit (pair_at i j) else Behind (pair_at i j).
Definition good (i j : nat) : Prop := inside i j /\ can_visit A B (pair_at i j).

(* A state of the code represents a state of the loop in Ranked.v; every index is inside its array. *)
Inductive Stands_for : Code -> State A B -> Prop :=
| For_visit i j : good i j -> side i j = NoLeaf ->
    Stands_for (CVisit (place cells_a i) (place cells_b j)) (state_at true i j)
| For_behind resumed i j : good i j -> (resumed = false -> side i j = NoLeaf) ->
    Stands_for (CBehind resumed (place cells_a i) (place cells_b j)) (state_at false i j)
| For_below_a resumed visit i m j : good i m -> good i j ->
    is_leaf cells_a i = true -> Under (T := B) m j ->
    (visit = true -> side i j = LeafA) -> (resumed = false -> side i m = NoLeaf) ->
    Stands_for (CBelow resumed visit LeafA (place cells_a i) (place cells_b m) j) (state_at visit i j)
| For_below_b resumed visit m i j : good m j -> good i j ->
    is_leaf cells_b j = true -> Under (T := A) m i ->
    (visit = true -> side i j = LeafB) -> (resumed = false -> side m j = NoLeaf) ->
    Stands_for (CBelow resumed visit LeafB (place cells_a m) (place cells_b j) i) (state_at visit i j)
| For_done : Stands_for CDone Done.

Definition visits_of (s : State A B) : option (nat * nat) :=
  match s with Visit p => Some p | _ => None end.
Definition finds_of (s : State A B) : bool :=
  match s with Visit p => found A B overlap p | _ => false end.

(* A turn of the code is a turn of the loop. *)
Definition Simulates := forall c s, Stands_for c s ->
  Stands_for (step c) (turn A B overlap s) /\
  visited c = visits_of s /\ finds cells_a cells_b bound touch c = finds_of s.

(* From the roots; from a pair that can be visited, or from behind it. No run ends before the visit of the roots, so
   this is no cursor. *)
Definition Starts :=
  Stands_for (begin_walk cells_a cells_b) (Visit (roots A B)) /\
  forall i j visit, good i j -> (visit = true -> (i, j) <> (0, 0)) ->
  Stands_for (resume_walk cells_a cells_b visit (i, j)) (state_at visit i j).

(* ---- The proof. *)

Lemma good_eq i j : good i j <->
  (i < length cells_a /\ j < length cells_b) /\ (rank_a i < above_b j /\ rank_b j <= above_a i)%Z.
Proof. reflexivity. Qed.

Lemma above_limit_b j : (above_b j <= kRootParentRank)%Z.
Proof.
  unfold above_b, find_parent_rank. destruct (j =? 0); [lia|].
  pose proof (rank_limit B (last_sibling cells_b j j - 1)) as L. cbn in L. lia.
Qed.

(* The lemmas of B and of A come in pairs with one proof each; the two trees differ only on ties of rank. *)

(* To a child x of n, whether down from n or aside from another child. *)
Ltac kid F x order := intros L I [R P]; pose proof (fmt_inside _ _ F _ _ I) as [_ ?]; pose proof (fmt_monotone _ _ F _ _ I);
  pose proof (find_kid _ _ F _ _ I) as K; pose proof (after_parent' _ _ F _ _ I);
  unfold side, side_of, leaf_of, leaf, above_a, above_b, rank_a, rank_b in *; cbn [place place_rank node];
  rewrite good_eq, K, (proj2 (order _ _) P); unfold above_a, above_b, rank_a, rank_b; rewrite K;
  split; [lia | destruct x; [lia|]; cbn [Nat.eqb]; now rewrite ?andb_false_r].
Lemma kid_b i n x : i < length cells_a -> In x (children_b n) -> (rank_a i < rank_b n <= above_a i)%Z ->
  good i x /\ leaf_of (place cells_a i) (place cells_b x) = (if is_leaf cells_a i then LeafA else NoLeaf) /\
  side i x = (if is_leaf cells_a i then LeafA else NoLeaf).
Proof. kid FB x Z.leb_le. Qed.
Lemma kid_a j n x : j < length cells_b -> In x (children_a n) -> (rank_b j <= rank_a n < above_b j)%Z ->
  good x j /\ leaf_of (place cells_a x) (place cells_b j) = (if is_leaf cells_b j then LeafB else NoLeaf) /\
  side x j = (if is_leaf cells_b j then LeafB else NoLeaf).
Proof. kid FA x Z.leb_gt. Qed.

Lemma internal_sides i j : is_leaf cells_a i = false -> is_leaf cells_b j = false -> side i j = NoLeaf.
Proof.
  intros E F. unfold side, side_of, leaf, place. cbn [node]. rewrite E, F.
  destruct (andb _ _); [reflexivity | now destruct (Z.leb _ _)].
Qed.

Lemma not_leaf (cells : list Cell) (children : nat -> list nat) (F : Post_indexed cells children) n x :
  In x (children n) -> is_leaf cells n = false.
Proof.
  intros I. apply not_true_iff_false. rewrite (leaf_spec _ _ F). intros E. now rewrite E in I.
Qed.

Lemma stands_for_enter i j visit : good i j ->
  (visit = true -> side i j = leaf_of (place cells_a i) (place cells_b j)) ->
  (visit = false -> leaf_of (place cells_a i) (place cells_b j) = NoLeaf -> side i j = NoLeaf) ->
  Stands_for (enter cells_a cells_b visit (place cells_a i) (place cells_b j)) (state_at visit i j).
Proof.
  intros G S T. unfold enter. fold leaf_of. unfold leaf_of in *.
  destruct (leaf _ _ _ _) eqn:E; [destruct visit; constructor; auto | apply For_below_a | apply For_below_b]; auto;
    try discriminate; try constructor; unfold leaf, place in E; cbn in E;
    destruct (_ <=? _)%Z, (is_leaf cells_a i), (is_leaf cells_b j); try discriminate; auto.
Qed.

Lemma turn_rejected i j : tested cells_a cells_b bound begin touch i j = false ->
  turn A B overlap (Visit (pair_at i j)) = Behind (pair_at i j).
Proof. intros E. unfold pair_at. cbn [turn]. fold (overlap i j) in E. now rewrite E. Qed.

Lemma turn_leaves i j : is_leaf cells_a i = true -> is_leaf cells_b j = true ->
  turn A B overlap (Visit (pair_at i j)) = Behind (pair_at i j).
Proof.
  rewrite (leaf_spec _ _ FA), (leaf_spec _ _ FB). intros E F. unfold pair_at. cbn [turn].
  change (kids A i) with (children_a i). change (kids B j) with (children_b j). rewrite E, F.
  now destruct (overlap i j), (Z.ltb (rank A i) (rank B j)).
Qed.

(* Down into B, down into A. *)
Ltac down F i j n smaller kid order := intros G T L R x; pose proof G as ((LA & LB) & R1 & R2);
  destruct (internal _ _ F n L) as (r & K); fold x in K; pose proof (in_eq x r) as I; rewrite <- K in I;
  assert smaller as S by (pose proof (fmt_rank _ _ F n ltac:(now rewrite K));
    destruct R as [R | R]; [apply Z.ltb_lt in R; cbn; lia | exact R]);
  split; [exact I|]; split; [|destruct (kid x) as (Gx & _ & Sx); auto];
  unfold pair_at; cbn [turn]; fold (overlap i j) in T; rewrite T, (proj2 (order _ _) S);
  change (kids B j) with (children_b j); change (kids A i) with (children_a i); now rewrite K.
Lemma down_b i j : good i j -> tested cells_a cells_b bound begin touch i j = true -> is_leaf cells_b j = false ->
  is_leaf cells_a i = true \/ (rank_a i < rank_b j)%Z -> let x := first_child cells_b j in
  In x (children_b j) /\ turn A B overlap (Visit (pair_at i j)) = Visit (pair_at i x) /\ good i x /\
  side i x = (if is_leaf cells_a i then LeafA else NoLeaf).
Proof. down FB i j j (rank A i < rank B j)%Z (kid_b i j) Z.ltb_lt. Qed.
Lemma down_a i j : good i j -> tested cells_a cells_b bound begin touch i j = true -> is_leaf cells_a i = false ->
  is_leaf cells_b j = true \/ (rank_b j <= rank_a i)%Z -> let x := first_child cells_a i in
  In x (children_a i) /\ turn A B overlap (Visit (pair_at i j)) = Visit (pair_at x j) /\ good x j /\
  side x j = (if is_leaf cells_b j then LeafB else NoLeaf).
Proof. down FA i j i (rank B j <= rank A i)%Z (kid_a j i) Z.ltb_ge. Qed.

(* Aside or up in B, in A. *)
Ltac aside T F i j x order := intros G Z P; rewrite good_eq in G; destruct G as ((LA & LB) & R1 & R2);
  destruct (has_parent _ _ F x ltac:(lia)) as (n & I & N); exists n; split; [exact I|];
  pose proof (find_kid _ _ F _ _ I) as K; pose proof (fmt_inside _ _ F _ _ I) as [Ln _];
  pose proof (rank_below_parent T n (all_under _ _ F n Ln)) as M; cbn in M;
  unfold pair_at; cbn [turn]; rewrite (proj2 (order (parent_rank B j) (parent_rank A i)) P);
  change (next A i) with (arr_next cells_a i); change (next B j) with (arr_next cells_b j);
  change (is_root B j) with (j =? 0); rewrite ?(proj2 (Nat.eqb_neq x 0) Z);
  unfold above_a, above_b, rank_a, rank_b in *; split; [lia|];
  destruct N as [[-> E] | (s & -> & J & _)]; [split; [exact E|]; split; [apply good_eq | now rewrite E] | now split];
  unfold above_a, above_b, rank_a, rank_b; lia.
Lemma aside_b i j : good i j -> j <> 0 -> (above_b j <= above_a i)%Z -> exists n, In j (children_b n) /\
  (rank_a i < rank_b n <= above_a i)%Z /\ match arr_next cells_b j with
  | Some s => In s (children_b n) /\ turn A B overlap (Behind (pair_at i j)) = Visit (pair_at i s)
  | None => n = j - 1 /\ good i n /\ turn A B overlap (Behind (pair_at i j)) = Behind (pair_at i n)
  end.
Proof. aside B FB i j j Z.leb_le. Qed.
Lemma aside_a i j : good i j -> i <> 0 -> (above_a i < above_b j)%Z -> exists n, In i (children_a n) /\
  (rank_b j <= rank_a n < above_b j)%Z /\ match arr_next cells_a i with
  | Some s => In s (children_a n) /\ turn A B overlap (Behind (pair_at i j)) = Visit (pair_at s j)
  | None => n = i - 1 /\ good n j /\ turn A B overlap (Behind (pair_at i j)) = Behind (pair_at n j)
  end.
Proof. aside A FA i j i Z.leb_gt. Qed.

(* next(), from behind any good pair. *)
Ltac next_goes kid F L I R T NL resumed leaf := let s := fresh in let J := fresh in let S := fresh in let IL := fresh in
  assert (resumed = false -> leaf = false) as IL
    by (intros E; specialize (NL E); rewrite (proj2 (proj2 (kid _ L I R))) in NL; now destruct leaf);
  match type of T with context [arr_next ?c ?x] => destruct (arr_next c x) as [s|] end; cbn [option_map];
  [ destruct T as [J ->]; destruct (kid s L J R) as (? & ? & S); destruct resumed;
    [apply (stands_for_enter _ _ true); auto; congruence | apply For_visit; auto; rewrite S; now rewrite IL]
  | destruct T as (-> & ? & ->); rewrite (place_ascend _ _ F) by auto; apply For_behind; auto;
    intros; apply internal_sides; auto; now apply (not_leaf _ _ F _ _ I) ].

Lemma next_simulates resumed i j : good i j -> (resumed = false -> side i j = NoLeaf) ->
  Stands_for (next_turn cells_a cells_b resumed (place cells_a i) (place cells_b j))
    (turn A B overlap (Behind (pair_at i j))).
Proof.
  intros G NL. pose proof G as ((LA & LB) & _). unfold next_turn. cbn [place_rank place node].
  fold (above_a i) (above_b j) (place cells_a i) (place cells_b j).
  destruct (Z.leb_spec (above_b j) (above_a i)) as [P|P].
  - rewrite (place_next _ _ FB j LB). destruct (Nat.eqb_spec j 0) as [->|Z].
    { unfold pair_at. cbn [turn]. change (parent_rank A i) with (above_a i). change (parent_rank B 0) with (above_b 0).
      rewrite (proj2 (Z.leb_le _ _) P). constructor. }
    destruct (aside_b i j G Z P) as (n & I & R & T).
    next_goes (kid_b i n) FB LA I R T NL resumed (is_leaf cells_a i).
  - assert (i <> 0) as Z
      by (intros ->; pose proof (above_limit_b j); change (above_a 0) with kRootParentRank in P; lia).
    rewrite (place_next _ _ FA i LA). destruct (aside_a i j G Z P) as (n & I & R & T).
    next_goes (kid_a j n) FA LB I R T NL resumed (is_leaf cells_b j).
Qed.

Lemma finds_spec i j : finds_of (Visit (pair_at i j)) =
  tested cells_a cells_b bound begin touch i j && (is_leaf cells_a i && is_leaf cells_b j).
Proof. reflexivity. Qed.

Lemma simulates_visit i j : good i j -> side i j = NoLeaf ->
  Stands_for (step (CVisit (place cells_a i) (place cells_b j))) (turn A B overlap (Visit (pair_at i j))) /\
  finds cells_a cells_b bound touch (CVisit (place cells_a i) (place cells_b j)) =
    finds_of (Visit (pair_at i j)).
Proof.
  intros G S. assert (tested cells_a cells_b bound begin touch i j =
    bound i j && (eqb (is_leaf cells_a i) (is_leaf cells_b j) || begin i j)) as T
    by (unfold tested; fold side; now rewrite S).
  rewrite finds_spec, T. unfold step, code_turn, finds. cbn [node place].
  fold (place cells_a i) (place cells_b j) (rank_a i) (rank_b j).
  assert (Stands_for (CBehind false (place cells_a i) (place cells_b j)) (Behind (pair_at i j)))
    as Go by now apply (For_behind false i j).
  destruct (bound i j); [|split; [now rewrite turn_rejected | reflexivity]].
  cbn [andb] in *. destruct (is_leaf cells_a i) eqn:EA, (is_leaf cells_b j) eqn:EB;
    cbn [eqb orb andb] in *; rewrite ?andb_false_r; split; auto.
  - now rewrite turn_leaves.
  - destruct (begin i j); [|now rewrite turn_rejected].
    destruct (down_b i j G T EB (or_introl EA)) as (I & -> & Gx & Sx). rewrite EA in Sx.
    apply (For_below_a false true); auto. now apply kid_under.
  - destruct (begin i j); [|now rewrite turn_rejected].
    destruct (down_a i j G T EA (or_introl EB)) as (I & -> & Gx & Sx). rewrite EB in Sx.
    apply (For_below_b false true); auto. now apply kid_under.
  - destruct (Z.ltb_spec (rank_a i) (rank_b j)) as [R|R].
    + destruct (down_b i j G T EB (or_intror R)) as (I & -> & Gx & Sx). rewrite EA in Sx.
      unfold rank_b. rewrite (place_descend _ _ FB j I). now apply For_visit.
    + destruct (down_a i j G T EA (or_intror R)) as (I & -> & Gx & Sx). rewrite EB in Sx.
      unfold rank_a. rewrite (place_descend _ _ FA i I). now apply For_visit.
Qed.

(* Below a leaf: at node x under m of tree T, in the pair (i, j); the walk came from the pair (a, b). *)
Ltac below T F cells i j a b x m resumed visit leaf goes down kid aside :=
  intros Gm G L U S NL; pose proof G as ((LA & LB) & _); pose proof (proj1 (good_eq _ _) Gm) as (_ & Ra & Rb);
  destruct visit; cbn zeta; unfold state_at, step; cbn [code_turn finds pair_below node place];
  fold (place cells_a a) (place cells_b b);
  [ specialize (S eq_refl); assert (tested cells_a cells_b bound begin touch i j = touch leaf i j) as Tested
      by (unfold tested; fold side; now rewrite S);
    rewrite finds_spec, Tested, L, ?andb_true_r; split; [|reflexivity];
    destruct (touch leaf i j); [destruct (is_leaf cells x) eqn:?|];
    [ rewrite turn_leaves by assumption; apply (goes resumed false); auto; discriminate
    | destruct (down i j G Tested ltac:(assumption) (or_introl L)) as (I & -> & Gx & Sx); rewrite L in Sx;
      apply (goes resumed true); auto; apply (Under_trans T m x _ U); now apply kid_under
    | rewrite turn_rejected by assumption; apply (goes resumed false); auto; discriminate ]
  | split; [|reflexivity]; destruct (Nat.eqb_spec x m) as [->|N]; [now apply next_simulates|];
    destruct (above_below _ _ F m x ltac:(assumption) U N) as [J P];
    unfold above_a, above_b, rank_a, rank_b in Ra, Rb;
    destruct (aside i j G J ltac:(unfold above_a, above_b; lia)) as (n & I & R & Turn);
    destruct (parent_under _ _ F m x n U N I) as [V _];
    unfold arr_next in Turn; destruct (Nat.ltb_spec (c_link (cell cells x)) x);
    [ destruct Turn as [J' ->]; destruct (kid n _ ltac:(assumption) J' R) as (Gs & _ & Ss); rewrite L in Ss;
      apply (goes resumed true); auto; apply (Under_trans T m n _ V); now apply kid_under
    | destruct Turn as (-> & Gn & ->); apply (goes resumed false); auto; discriminate ] ].
Lemma simulates_below_a resumed visit i m j : good i m -> good i j ->
  is_leaf cells_a i = true -> Under (T := B) m j ->
  (visit = true -> side i j = LeafA) -> (resumed = false -> side i m = NoLeaf) ->
  let c := CBelow resumed visit LeafA (place cells_a i) (place cells_b m) j in
  Stands_for (step c) (turn A B overlap (state_at visit i j)) /\
  finds cells_a cells_b bound touch c = finds_of (state_at visit i j).
Proof. below B FB cells_b i j i m j m resumed visit LeafA For_below_a down_b (kid_b i) aside_b. Qed.
Lemma simulates_below_b resumed visit m i j : good m j -> good i j ->
  is_leaf cells_b j = true -> Under (T := A) m i ->
  (visit = true -> side i j = LeafB) -> (resumed = false -> side m j = NoLeaf) ->
  let c := CBelow resumed visit LeafB (place cells_a m) (place cells_b j) i in
  Stands_for (step c) (turn A B overlap (state_at visit i j)) /\
  finds cells_a cells_b bound touch c = finds_of (state_at visit i j).
Proof. below A FA cells_a i j m j i m resumed visit LeafB For_below_b down_a (kid_a j) aside_a. Qed.

Theorem simulates : Simulates.
Proof.
  intros c s [i j G S | resumed i j G S | resumed visit i m j | resumed visit m i j |].
  - destruct (simulates_visit i j G S) as [E F]. repeat split; auto.
  - repeat split. now apply next_simulates.
  - intros. destruct (simulates_below_a resumed visit i m j) as [E F]; auto.
    repeat split; auto. now destruct visit.
  - intros. destruct (simulates_below_b resumed visit m i j) as [E F]; auto.
    repeat split; auto. now destruct visit.
  - repeat split. constructor.
Qed.

Theorem starts : Starts.
Proof.
  split.
  - apply (For_visit 0 0); auto. split; [|apply (Inv_roots A B)].
    split; [apply (fmt_some _ _ FA) | apply (fmt_some _ _ FB)].
  - intros i j visit G N. apply stands_for_enter; auto.
    + intros E. specialize (N E). unfold side, side_of.
      destruct (Nat.eqb_spec i 0), (Nat.eqb_spec j 0); auto. now subst.
    + intros _ E. unfold side, side_of. fold leaf_of. rewrite E. now destruct (andb _ _).
Qed.
End Simulation.
