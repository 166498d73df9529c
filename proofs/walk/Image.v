(* lib/src/lattice/tree_check.cpp accepts only trees: its single pass over the nodes of a post-indexed image, climbing
   after each leaf, proves the format that Code.v assumes, and that each node's box lies in its parent's.

   Not in this model: levels, leaf numbers, triangles and vertices, which have separate checks.

   Part 1  definitions.   Part 2  the theorem.   Part 3  its proof. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants Ranked Code.
Import ListNotations.

(* ============================================================== Part 1: definitions *)

Section Image.
Variable cells : list Cell.
Variable inside : nat -> nat -> bool.  (* is_inside(): of the boxes of two nodes *)

Let count := length cells.
Let link i := c_link (cell cells i).
Let rank i := c_rank (cell cells i).
Let above i := c_parent_rank (cell cells i).
Let leaf := is_leaf cells.
Let last x := last_sibling cells x x.

(* has_ranks(), of internal nodes *)
(* code: src/lattice/tree_check.cpp | return is_on_lattice(node.box) && (node.is_leaf() ? leaf(node) : has_ranks(node)); *)
Definition node_fits (i : nat) : bool := leaf i || ((1 <=? rank i) && (rank i <=? kMaxRank))%Z.

(* code: src/lattice/tree_check.cpp | const bool rank = node.is_leaf() || node.parent_rank() == kRootParentRank; *)
(* code: src/lattice/tree_check.cpp | return node.link == tree_.node_count && rank && levels; *)
Definition root_fits : bool :=
  (link 0 =? count) && (leaf 0 || (above 0 =? kRootParentRank)%Z).

(* children_belong_to(), from one of the children on. Loops end after `fuel` turns, and then refuse. *)
(* code: src/lattice/tree_check.cpp | for (uint32_t child = tree_.first_child(parent);; child = tree_.next_sibling(child)) { *)
(* code: src/lattice/tree_check.cpp | node.is_leaf() || (node.parent_rank() == above.rank() && node.rank() <= above.rank()); *)
(* code: src/lattice/tree_check.cpp | if (!ranks || !is_inside(node.box, above.box)) { *)
Fixpoint belong_from (fuel parent child : nat) : bool :=
  match fuel with
  | O => false
  | S f =>
      (leaf child || ((above child =? rank parent) && (rank child <=? rank parent)))%Z &&
      inside child parent &&
      if child =? parent + 1 then true else belong_from f parent (link child)
  end.
Definition children_belong_to (parent : nat) : bool :=
  belong_from count parent (first_child cells parent).

(* code: src/lattice/tree_check.cpp | while (place_of(node) > place) { *)
(* code: src/lattice/tree_check.cpp | const uint32_t last = last_sibling(node); if (tree_.nodes[last].link != node) { return false; } parent = last - 1; *)
(* code: src/lattice/tree_check.cpp | if (!children_belong_to(parent)) { return false; } node = parent; } return place_of(node) == place; *)
Fixpoint leave_to (fuel node place : nat) : bool :=
  match fuel with
  | O => false
  | S f =>
      if place <? node then
        (link (last node) =? node) && children_belong_to (last node - 1) &&
        leave_to f (last node - 1) place
      else node =? place
  end.

(* code: src/lattice/tree_check.cpp | return tree_.nodes[i].link >= i && (!has_levels() *)
Definition enter_child (i : nat) : bool := i <=? link i.
(* code: src/lattice/tree_check.cpp | return link < i && leave_to(sibling, link, i) && *)
Definition enter_sibling (i : nat) : bool := (link i <? i) && leave_to count (i - 1) (link i).
Definition enters (i : nat) : bool := if leaf (i - 1) then enter_sibling i else enter_child i.

(* check() *)
(* code: src/lattice/tree_check.cpp | const bool entered = tree_.nodes[i - 1].is_leaf() ? enter_sibling(i) : enter_child(i); *)
(* code: src/lattice/tree_check.cpp | if (!tree_.nodes[last].is_leaf() || !leave_to(last, 0, tree_.node_count) || *)
Definition accepts : bool :=
  (0 <? count) && root_fits && forallb node_fits (seq 0 count) &&
  forallb enters (seq 1 (count - 1)) &&
  leaf (count - 1) && leave_to count (count - 1) 0.

(* The intended tree: the siblings from one on, in order; the children of a node. *)
Fixpoint siblings_from (fuel i : nat) : list nat :=
  i :: match fuel with
       | O => []
       | S f => if link i <? i then siblings_from f (link i) else []
       end.
Definition siblings (i : nat) : list nat := siblings_from i i.
Definition children (i : nat) : list nat := if leaf i then [] else siblings (link (i + 1)).

(* ============================================================== Part 2: the theorem *)

Definition Accepted_is_tree := accepts = true ->
  Post_indexed cells children /\
  forall n x, In x (children n) -> inside x n = true.

(* ============================================================== Part 3: the proof *)

Lemma siblings_fuel f : forall g x, x <= f -> x <= g -> siblings_from f x = siblings_from g x.
Proof.
  induction f as [|f IH]; intros [|g] x F G; cbn [siblings_from]; try (replace x with 0 by lia; reflexivity).
  destruct (Nat.ltb_spec (link x) x); auto. f_equal. apply IH; lia.
Qed.

Lemma siblings_eq x : siblings x = x :: if link x <? x then siblings (link x) else [].
Proof.
  unfold siblings. destruct x as [|x]; [reflexivity|]. cbn [siblings_from].
  destruct (Nat.ltb_spec (link (S x)) (S x)); auto. f_equal. apply siblings_fuel; lia.
Qed.

Lemma last_is f : forall x, last_sibling cells f x = List.last (siblings_from f x) 0.
Proof.
  induction f as [|f IH]; intros x; [reflexivity|]. cbn [last_sibling siblings_from]. fold (link x).
  destruct (link x <? x); [|reflexivity]. rewrite IH. now destruct f.
Qed.

Lemma last_eq x : last x = if link x <? x then last (link x) else x.
Proof.
  unfold last. rewrite !last_is. fold (siblings x) (siblings (link x)). rewrite (siblings_eq x).
  destruct (link x <? x); [|reflexivity]. now rewrite (siblings_eq (link x)).
Qed.

Lemma last_le x : last x <= x.
Proof.
  induction x as [x IH] using lt_wf_ind. rewrite last_eq.
  destruct (Nat.ltb_spec (link x) x) as [H|]; auto. specialize (IH _ H). lia.
Qed.

Lemma siblings_le z : forall x, In x (siblings z) -> x <= z.
Proof.
  induction z as [z IH] using lt_wf_ind. intros x. rewrite siblings_eq.
  intros [-> | I]; auto. destruct (Nat.ltb_spec (link z) z) as [H|]; [|easy].
  specialize (IH _ H _ I). lia.
Qed.

Lemma siblings_last z : forall x, In x (siblings z) -> last x = last z.
Proof.
  induction z as [z IH] using lt_wf_ind. intros x. rewrite siblings_eq.
  intros [-> | I]; auto. rewrite (last_eq z). destruct (Nat.ltb_spec (link z) z); [|easy]. now apply IH.
Qed.

Lemma siblings_step z : forall l x y r, siblings z = l ++ x :: y :: r -> link x = y /\ y < x.
Proof.
  induction z as [z IH] using lt_wf_ind. intros l x y r. rewrite siblings_eq.
  destruct (Nat.ltb_spec (link z) z) as [H|]; [|now destruct l as [|? [|? ?]]].
  destruct l as [|w l]; [|intros [= _ E]; now apply (IH _ H l x y r)].
  intros [= -> E]. rewrite siblings_eq in E. injection E as E _. rewrite <- E. now split.
Qed.

Lemma siblings_end z : forall l x, siblings z = l ++ [x] -> x = last z /\ x <= link x.
Proof.
  induction z as [z IH] using lt_wf_ind. intros l x. rewrite siblings_eq, last_eq.
  destruct (Nat.ltb_spec (link z) z) as [H|].
  - destruct l as [|w l]; [|intros [= _ E]; now apply (IH _ H l x)].
    intros [= -> E]. rewrite siblings_eq in E. discriminate.
  - destruct l as [|w [|? ?]]; intros [= ->]; auto; discriminate.
Qed.

(* From a node up to its parent, and so on. *)
Inductive Path : nat -> nat -> Prop :=
| Path_self x : Path x x
| Path_up x y : 0 < last x -> Path (last x - 1) y -> Path x y.

(* The climb with the checks of leave_to(). *)
Inductive Climb : nat -> nat -> Prop :=
| Climb_self x : Climb x x
| Climb_up x place : place < x -> link (last x) = x -> children_belong_to (last x - 1) = true ->
    Climb (last x - 1) place -> Climb x place.

Lemma climb f : forall x place, leave_to f x place = true -> Climb x place.
Proof.
  induction f as [|f IH]; intros x place; [discriminate|]. cbn [leave_to].
  destruct (Nat.ltb_spec place x).
  - rewrite !andb_true_iff, Nat.eqb_eq. intros [[E C] R]. constructor; auto.
  - rewrite Nat.eqb_eq. intros ->. constructor.
Qed.

Lemma path_le x y : Path x y -> y <= x.
Proof. induction 1; auto. pose proof (last_le x). lia. Qed.

Lemma climb_checks x place : Climb x place -> forall z, Path x z -> place < z ->
  link (last z) = z /\ children_belong_to (last z - 1) = true.
Proof.
  induction 1 as [x | x place P E C K IH]; intros z Z L.
  - apply path_le in Z. lia.
  - destruct Z as [x | x z U Z]; auto.
Qed.

Lemma climb_closes x place : Climb x place -> forall p, Path x p -> p <> x -> place <= p ->
  exists z, last z = p + 1 /\ link (p + 1) = z /\ z <= x /\ children_belong_to p = true.
Proof.
  induction 1 as [x | x place P E C K IH]; intros p Z N L.
  - apply path_le in Z. lia.
  - destruct Z as [x | x p U Z]; [easy|]. pose proof (last_le x).
    destruct (Nat.eq_dec p (last x - 1)) as [->|D].
    + exists x. replace (last x - 1 + 1) with (last x) by lia. auto.
    + destruct (IH p Z D L) as (z & ? & ? & ? & ?). exists z. repeat split; auto. lia.
Qed.

Lemma climb_rest x place : Climb x place -> forall z, Path x z -> z <= place -> Path place z.
Proof.
  induction 1 as [x | x place P E C K IH]; intros z Z L; auto. destruct Z as [x | x z U Z]; [lia | auto].
Qed.

Section Accepted.
Hypothesis root_link : link 0 = count.
Hypothesis fits : forall i, i < count -> node_fits i = true.
Hypothesis entered : forall i, 0 < i < count -> enters i = true.

(* A step of the pass: its properties of the next node. *)
Lemma enter i : i + 1 < count ->
  (leaf i = false /\ last (i + 1) = i + 1) \/
  (leaf i = true /\ exists k, k <= i /\ link (i + 1) = k /\ last (i + 1) = last k /\ Climb i k).
Proof.
  intros L. pose proof (entered (i + 1) ltac:(lia)) as E. unfold enters in E.
  replace (i + 1 - 1) with i in E by lia. rewrite (last_eq (i + 1)). destruct (leaf i).
  - right. split; auto. unfold enter_sibling in E. rewrite andb_true_iff, Nat.ltb_lt in E.
    replace (i + 1 - 1) with i in E by lia. destruct E as [E F]. exists (link (i + 1)).
    rewrite (proj2 (Nat.ltb_lt _ _) E). repeat split; auto; [lia | now apply climb in F].
  - left. unfold enter_child in E. apply Nat.leb_le in E. split; auto.
    destruct (Nat.ltb_spec (link (i + 1)) (i + 1)); lia.
Qed.

(* A "sibling" of the root: no accepted pass ends with one. *)
Definition Stray b := 0 < b < count /\ last b = 0.

Lemma no_stray_above x place b : Climb x place -> Path x b -> Stray b -> b <= place.
Proof.
  intros C P [B E]. destruct (Nat.le_gt_cases b place) as [|G]; auto.
  destruct (climb_checks x place C b P G) as [L _]. rewrite E, root_link in L. lia.
Qed.

Lemma path_up x y : Path x y -> y <> x -> 0 < last x /\ Path (last x - 1) y.
Proof. destruct 1; auto. easy. Qed.

(* The nodes on the path of node i remain on that of i + 1, unless the climb closed them. *)
Lemma path_on i k z : last (i + 1) = last k -> Climb i k -> Path i z -> z < k -> Path (i + 1) z.
Proof.
  intros E C P L. pose proof (climb_rest _ _ C z P ltac:(lia)) as K.
  destruct (path_up k z K ltac:(lia)) as [U V]. rewrite <- E in *. now apply Path_up.
Qed.

Lemma parents i : i < count -> (exists b, Stray b /\ Path i b) \/
  forall j, 0 < j <= i -> 0 < last j /\ leaf (last j - 1) = false.
Proof.
  induction i as [|i IH]; intros L; [right; lia|]. replace (S i) with (i + 1) in * by lia.
  destruct (enter i L) as [[F E] | (F & k & K & Ek & E & C)].
  - destruct (IH ltac:(lia)) as [(b & B & P) | G].
    + left. exists b. split; auto. apply Path_up; rewrite E; [lia | now rewrite Nat.add_sub].
    + right. intros j J. destruct (Nat.eq_dec j (i + 1)) as [->|]; [|apply G; lia].
      rewrite E, Nat.add_sub. split; [lia | exact F].
  - destruct (Nat.eq_dec (last k) 0) as [Z|Z].
    { left. exists (i + 1). split; [split; [lia | congruence] | constructor]. }
    destruct (IH ltac:(lia)) as [(b & B & P) | G].
    + left. exists b. split; auto. pose proof (no_stray_above _ _ _ C P B).
      apply (path_on i k); auto. destruct (Nat.eq_dec b k) as [->|]; [|lia]. now destruct B.
    + right. intros j J. destruct (Nat.eq_dec j (i + 1)) as [->|]; [|apply G; lia].
      rewrite E. destruct (Nat.eq_dec k 0) as [->|]; [now destruct Z | apply G; lia].
Qed.

Definition Closed p := exists z, last z = p + 1 /\ link (p + 1) = z /\ z < count /\
  children_belong_to p = true.

Lemma closed i : i < count -> forall p, p <= i -> leaf p = false -> Path i p \/ Closed p.
Proof.
  induction i as [|i IH]; intros L p P F.
  - assert (p = 0) as -> by lia. left. constructor.
  - replace (S i) with (i + 1) in * by lia.
    destruct (Nat.eq_dec p (i + 1)) as [->|N]; [left; constructor|].
    destruct (IH ltac:(lia) p ltac:(lia) F) as [Q|]; [|now right].
    destruct (enter i L) as [[Fi E] | (Fi & k & K & _ & E & C)].
    + left. apply Path_up; rewrite E; [lia | now rewrite Nat.add_sub].
    + destruct (Nat.le_gt_cases k p) as [G|G]; [|left; now apply (path_on i k)].
      right. destruct (climb_closes _ _ C p Q) as (z & A1 & A2 & A3 & A4); auto; [congruence|].
      exists z. repeat split; auto. lia.
Qed.

Definition Member x := In x (siblings (link (last x))).

Lemma members i : i < count -> forall x, 0 < x <= i ->
  Member x \/ exists z, 0 < z /\ Path i z /\ In x (siblings z).
Proof.
  induction i as [|i IH]; intros L x X; [lia|]. replace (S i) with (i + 1) in * by lia.
  destruct (Nat.eq_dec x (i + 1)) as [->|N].
  { right. exists (i + 1). repeat split; [lia | constructor | rewrite siblings_eq; now left]. }
  destruct (IH ltac:(lia) x ltac:(lia)) as [M | (z & Z & P & I)]; [now left|].
  destruct (enter i L) as [[Fi E] | (Fi & k & K & Ek & E & C)].
  - right. exists z. repeat split; auto. apply Path_up; rewrite E; [lia | now rewrite Nat.add_sub].
  - destruct (Nat.lt_trichotomy z k) as [G | [-> | G]].
    + right. exists z. repeat split; auto. now apply (path_on i k).
    + right. exists (i + 1). repeat split; [lia | constructor|]. rewrite siblings_eq, Ek.
      destruct (Nat.ltb_spec k (i + 1)); [now right | lia].
    + left. destruct (climb_checks _ _ C z P G) as [V _]. unfold Member.
      now rewrite (siblings_last z x I), V.
Qed.

Lemma belong f : forall p c, belong_from f p c = true -> last c = p + 1 ->
  forall y, In y (siblings c) ->
  (leaf y = true \/ above y = rank p /\ (rank y <= rank p)%Z) /\ inside y p = true.
Proof.
  induction f as [|f IH]; intros p c; [discriminate|]. cbn [belong_from].
  rewrite !andb_true_iff, orb_true_iff, andb_true_iff, Z.eqb_eq, Z.leb_le.
  intros [[G J] R] E y. rewrite siblings_eq. rewrite last_eq in E. intros [<- | I]; auto.
  destruct (Nat.ltb_spec (link c) c); [|easy]. pose proof (last_le (link c)).
  destruct (Nat.eqb_spec c (p + 1)); [lia|]. now apply (IH p (link c)).
Qed.
End Accepted.

Theorem accepted_is_tree : Accepted_is_tree.
Proof.
  unfold Accepted_is_tree, accepts. rewrite !andb_true_iff, Nat.ltb_lt, !forallb_forall.
  intros (((((Some_ & Root) & Fits) & Enters) & Last) & Leave).
  unfold root_fits in Root. rewrite andb_true_iff, Nat.eqb_eq, orb_true_iff, Z.eqb_eq in Root.
  destruct Root as [Root Above]. apply climb in Leave.
  assert (forall i, i < count -> node_fits i = true) as F by (intros i L; apply Fits, in_seq; lia).
  assert (forall i, 0 < i < count -> enters i = true) as E by (intros i L; apply Enters, in_seq; lia).
  assert (forall i, 0 < i < count -> 0 < last i /\ leaf (last i - 1) = false) as Parents.
  { destruct (parents Root E (count - 1) ltac:(lia)) as [(b & B & P) | G].
    - pose proof (no_stray_above Root _ _ b Leave P B). destruct B. lia.
    - intros i L. apply G. lia. }
  assert (forall p, leaf p = false -> Closed p /\ p < count) as AllClosed.
  { intros p Lp. assert (p < count) as P.
    { destruct (Nat.le_gt_cases count p) as [G|]; auto. unfold leaf, is_leaf, cell in Lp.
      now rewrite nth_overflow in Lp. }
    split; auto. destruct (closed Root E (count - 1) ltac:(lia) p ltac:(lia) Lp) as [Q|]; auto.
    destruct (climb_closes _ _ Leave p Q) as (z & A1 & A2 & A3 & A4); [congruence | lia|].
    exists z. repeat split; auto. lia. }
  assert (forall i, 0 < i < count -> Member i) as Members.
  { intros i L. destruct (members Root E (count - 1) ltac:(lia) i ltac:(lia)) as [M | (z & Z & P & I)]; auto.
    destruct (climb_checks _ _ Leave z P Z) as [V _]. unfold Member. now rewrite (siblings_last z i I), V. }
  assert (forall n x, In x (children n) -> leaf n = false /\ In x (siblings (link (n + 1)))) as Kid.
  { intros n x. unfold children. now destruct (leaf n). }
  assert (forall n x, In x (children n) ->
    (leaf x = true \/ above x = rank n /\ (rank x <= rank n)%Z) /\ inside x n = true) as Belongs.
  { intros n x I. apply Kid in I as [L I]. destruct (AllClosed n L) as [(z & A1 & A2 & _ & A4) _].
    rewrite A2 in I. unfold children_belong_to, first_child in A4. fold (link (n + 1)) in A4.
    rewrite A2 in A4. eapply belong; eauto. }
  assert (forall n, leaf n = false -> (1 <= rank n <= kMaxRank)%Z) as Ranks.
  { intros n L. destruct (AllClosed n L) as [_ C]. specialize (F n C). unfold node_fits in F.
    rewrite L in F. cbn [orb] in F. rewrite andb_true_iff, !Z.leb_le in F. exact F. }
  assert (forall n, children n <> [] <-> leaf n = false) as Internal.
  { intros n. unfold children. rewrite siblings_eq. now destruct (leaf n). }
  assert (forall n, leaf n = true <-> (rank n < 0)%Z) as Leaf by (intros n; apply Z.ltb_lt).
  split; [constructor|].
  - exact Some_.
  - intros n x I. apply Kid in I as [L I]. destruct (AllClosed n L) as [(z & _ & A2 & A3 & _) C].
    split; auto. rewrite A2 in I. apply siblings_le in I. fold count. lia.
  - intros i L. destruct (Parents i L) as [P Q]. exists (last i - 1). unfold children. rewrite Q.
    replace (last i - 1 + 1) with (last i) by lia. now apply Members.
  - intros n l x y r K. unfold children in K. destruct (leaf n); [now destruct l|].
    now apply (siblings_step (link (n + 1)) l x y r).
  - intros n l x K. unfold children in K. destruct (leaf n) eqn:L; [now destruct l|].
    destruct (AllClosed n L) as [(z & A1 & A2 & _ & _) _]. rewrite A2 in K.
    destruct (siblings_end z l x K) as [-> H]. rewrite A1 in *. auto.
  - intros n x r K. unfold children in K. destruct (leaf n); [discriminate|].
    rewrite siblings_eq in K. injection K as K _. exact K.
  - intros n. fold (rank n). rewrite <- Leaf. specialize (Internal n). split.
    + intros N. destruct (leaf n) eqn:L; auto. destruct Internal as [_ J]. now destruct (J eq_refl).
    + intros L. unfold children. now rewrite L.
  - intros n N. apply Ranks. now apply Internal.
  - intros n x I. destruct (Belongs n x I) as [[G | [_ G]] _]; auto.
    apply Leaf in G. apply Kid in I as [I _]. apply Ranks in I. fold (rank n) (rank x). lia.
  - intros n x I N. apply Internal in N. destruct (Belongs n x I) as [[G | [G _]] _]; auto. congruence.
  - intros N. apply Internal in N. destruct Above; auto. congruence.
  - intros n x I. now apply Belongs.
Qed.
End Image.
