(* The traversal of lib/include/flashbvh/traversal/ranked.hpp on trees: a loop without a stack that makes the
   visits of a recursion.

   Part 1  definitions: a tree, the recursion, the loop.
   Part 2  the theorems.
   Part 3  their proofs, which readers who trust Coq can skip. Then the theorems again, by name. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants.
Import ListNotations.
Local Open Scope Z_scope.

(* ============================================================== Part 1: definitions *)

(* Ranks are at most `most`; a root's missing parent has `top`, which is larger. *)
Class Limits := { most : Z; top : Z; limit : 0 < top /\ most < top }.

(* A rooted, ordered tree as the walk uses it. Nodes are abstract: an index, a pointer. *)
Record Tree {limits : Limits} := {
  Node : Type;
  root : Node;
  kids : Node -> list Node;    (* in order; empty for a leaf *)
  rank : Node -> Z;            (* Node::rank() *)
  parent_rank : Node -> Z;     (* Place::parent_rank *)
  next : Node -> option Node;  (* Place::next_sibling() *)
  up : Node -> Node;           (* Place::ascend(): called for last children only *)
  is_root : Node -> bool;
  height : Node -> nat;        (* anything that shrinks from a node to its children *)

  rank_of_leaf : forall n, kids n = [] <-> rank n < 0;
  rank_of_internal : forall n, kids n <> [] -> 1 <= rank n <= most;
  rank_monotone : forall n x, In x (kids n) -> rank x <= rank n;
  parent_rank_of_kid : forall n x, In x (kids n) -> parent_rank x = rank n;
  parent_rank_of_root : parent_rank root = top;
  next_of_kid : forall n l x y r, kids n = l ++ x :: y :: r -> next x = Some y;
  next_of_last : forall n l x, kids n = l ++ [x] -> next x = None;
  next_of_root : next root = None;
  up_of_last : forall n l x, kids n = l ++ [x] -> up x = n;
  root_is_root : is_root root = true;
  kid_is_not_root : forall n x, In x (kids n) -> is_root x = false;
  height_of_kid : forall n x, In x (kids n) -> (height x < height n)%nat
}.

(* `Under n x`: x is n or lies below it. *)
Inductive Under {limits : Limits} {T : Tree} : Node T -> Node T -> Prop :=
| Under_self n : Under n n
| Under_kid n x y : In x (kids T n) -> Under x y -> Under n y.

#[global] Hint Constructors Under : core.

Section Walk.
Context {limits : Limits}.
Variables A B : Tree.
Variable overlap : Node A -> Node B -> bool.  (* the test of a pair: any predicate *)

Definition Pair : Type := Node A * Node B.
Definition roots : Pair := (root A, root B).

(* The rule: into the node of larger rank, into A on a tie. *)
Definition expand (p : Pair) : list Pair :=
  let (a, b) := p in
  if rank A a <? rank B b then map (fun y => (a, y)) (kids B b)
  else map (fun x => (x, b)) (kids A a).

Definition descents (p : Pair) : list Pair :=
  if overlap (fst p) (snd p) then expand p else [].

(* The recursion: a depth-first search. `depth` only bounds it. *)
Fixpoint dfs (depth : nat) (p : Pair) : list Pair :=
  match depth with
  | O => []
  | S d => p :: flat_map (dfs d) (descents p)
  end.

Definition size (p : Pair) : nat := height A (fst p) + height B (snd p).
Definition enough (depth : nat) : Prop := (size roots < depth)%nat.

(* The loop's states: before the visit of a pair, behind a pair and all pairs below it, or done. *)
Inductive State :=
| Visit (p : Pair)
| Behind (p : Pair)
| Done.

(* One turn, a function of the pair alone: descend() after a visit, one turn of next(). *)
Definition turn (s : State) : State :=
  match s with
  | Visit (a, b) =>
      if overlap a b then
        if rank A a <? rank B b then
          match kids B b with first :: _ => Visit (a, first) | [] => Behind (a, b) end
        else
          match kids A a with first :: _ => Visit (first, b) | [] => Behind (a, b) end
      else Behind (a, b)
  | Behind (a, b) =>
      if parent_rank B b <=? parent_rank A a then
        match next B b with
        | Some sibling => Visit (a, sibling)
        | None => if is_root B b then Done else Behind (a, up B b)
        end
      else
        match next A a with
        | Some sibling => Visit (sibling, b)
        | None => Behind (up A a, b)
        end
  | Done => Done
  end.

(* The state after n turns, and their visits. *)
Fixpoint after (n : nat) (s : State) : State :=
  match n with O => s | S m => after m (turn s) end.

Fixpoint trace (n : nat) (s : State) : list Pair :=
  match n with
  | O => []
  | S m => match s with Visit p => [p] | _ => [] end ++ trace m (turn s)
  end.

Definition Run n s visits s' : Prop := after n s = s' /\ trace n s = visits.
Definition Ends s : Prop := exists n visits, Run n s visits Done.

(* Ranked::can_visit(). *)
(* code: include/flashbvh/traversal/ranked.hpp | return a.nodes[cursor.a].rank() < find_parent_rank(b, cursor.b) && *)
(* code: include/flashbvh/traversal/ranked.hpp | b.nodes[cursor.b].rank() <= find_parent_rank(a, cursor.a); *)
Definition can_visit (p : Pair) : Prop :=
  let (a, b) := p in rank A a < parent_rank B b /\ rank B b <= parent_rank A a.

Definition In_trees (p : Pair) : Prop := Under (root A) (fst p) /\ Under (root B) (snd p).

(* The visits at which a pair of leaves is found. *)
Definition is_leaf_pair (p : Pair) : bool := (rank A (fst p) <? 0) && (rank B (snd p) <? 0).
Definition found (p : Pair) : bool := overlap (fst p) (snd p) && is_leaf_pair p.

(* Rejecting is safe: a rejected pair has no pair of leaves below it that passes `hit`, the exact test. *)
Definition safe (hit : Pair -> bool) : Prop := forall a b x y,
  Under a x -> Under b y -> kids A x = [] -> kids B y = [] -> hit (x, y) = true ->
  overlap a b = true.
End Walk.
Arguments Visit {limits A B}. Arguments Behind {limits A B}. Arguments Done {limits A B}.

(* ============================================================== Part 2: the theorems *)

Section Theorems.
Context {limits : Limits}.
Variables A B : Tree.
Variable overlap : Node A -> Node B -> bool.
Let visits depth := dfs A B overlap depth (roots A B).
Let run := Run A B overlap.

(* From the roots the loop makes the visits of the recursion, in its order, and ends: in two turns per visit, which is
   also the amortised cost. *)
Definition Walk_is_dfs := forall depth, enough A B depth ->
  run (2 * length (visits depth)) (Visit (roots A B)) (visits depth) Done.

(* From any visited pair, without other data, it makes the remaining visits. *)
Definition Resumes := forall depth before p rest, enough A B depth ->
  visits depth = before ++ p :: rest -> exists n, run n (Visit p) (p :: rest) Done.

(* From behind a pair that nothing followed, it makes the remaining visits, too. *)
Definition Resumes_behind := forall depth before p rest, enough A B depth ->
  visits depth = before ++ p :: rest -> descents A B overlap p = [] ->
  exists n, run n (Behind p) rest Done.

Definition Visits_once := forall depth, enough A B depth -> NoDup (visits depth).

(* can_visit() holds for every visited pair, and only for pairs that are visited if all boxes overlap. *)
Definition Visited_can_be := forall depth p, enough A B depth ->
  In p (visits depth) -> In_trees A B p /\ can_visit A B p.
Definition Can_be_visited := forall depth p, enough A B depth ->
  In_trees A B p -> can_visit A B p -> In p (dfs A B (fun _ _ => true) depth (roots A B)).

(* From every pair with can_visit(), even one that this walk never reaches, it ends. *)
Definition Ends_from_everywhere := forall p, In_trees A B p -> can_visit A B p ->
  Ends A B overlap (Visit p) /\ Ends A B overlap (Behind p).

(* Exactly the pairs of leaves that pass the exact test are found and pass it, each once. *)
Definition Finds_each_once := forall depth hit, enough A B depth -> safe A B overlap hit ->
  let answers := filter (fun p => found A B overlap p && hit p) (visits depth) in
  NoDup answers /\
  forall p, In p answers <->
    In_trees A B p /\ kids A (fst p) = [] /\ kids B (snd p) = [] /\ hit p = true.
End Theorems.

(* ============================================================== Part 3: the proofs *)

Section Proofs.
Context {limits : Limits}.
Variables A B : Tree.
Variable overlap : Node A -> Node B -> bool.
Local Notation Inv := (can_visit A B).
Local Notation expand := (expand A B).
Local Notation descents := (descents A B overlap).
Local Notation dfs := (dfs A B overlap).
Local Notation turn := (turn A B overlap).
Local Notation Run := (Run A B overlap).
Local Notation size := (size A B).
Local Notation roots := (roots A B).

Lemma rank_limit (T : Tree) n : rank T n < top.
Proof.
  pose proof limit. destruct (kids T n) eqn:K.
  - apply (rank_of_leaf T) in K. lia.
  - pose proof (rank_of_internal T n) as R. rewrite K in R. specialize (R ltac:(easy)). lia.
Qed.

Lemma Inv_roots : Inv roots.
Proof.
  cbn. rewrite !parent_rank_of_root.
  pose proof (rank_limit A (root A)). pose proof (rank_limit B (root B)). lia.
Qed.

(* The walk descends by the rule. *)
Lemma Inv_child p q : Inv p -> In q (expand p) -> Inv q.
Proof.
  destruct p as [a b]. intros [I1 I2]. cbn [Ranked.expand].
  destruct (Z.ltb_spec (rank A a) (rank B b)); intros I; apply in_map_iff in I as (x & <- & I).
  - pose proof (rank_monotone B _ _ I). pose proof (parent_rank_of_kid B _ _ I). cbn. lia.
  - pose proof (rank_monotone A _ _ I). pose proof (parent_rank_of_kid A _ _ I). cbn. lia.
Qed.

(* The central lemma: behind a finished pair, the walk continues with the next pair below p, or is behind p. It knows
   only the finished pair. *)
Lemma turn_behind p l q r :
  Inv p -> expand p = l ++ q :: r ->
  turn (Behind q) = match r with z :: _ => Visit z | [] => Behind p end.
Proof.
  destruct p as [a b]. intros [I1 I2]. cbn [Ranked.expand].
  destruct (rank A a <? rank B b); intros D.
  all: apply map_eq_app in D as (l' & r' & K & _ & D).
  all: apply map_eq_cons in D as (x & r'' & -> & <- & <-).
  - assert (In x (kids B b)) as X by (rewrite K; apply in_elt).
    cbn [Ranked.turn]. rewrite (parent_rank_of_kid B b x X), (kid_is_not_root B b x X).
    rewrite (proj2 (Z.leb_le _ _) I2). destruct r''; cbn [map].
    + now rewrite (next_of_last B _ _ _ K), (up_of_last B _ _ _ K).
    + now rewrite (next_of_kid B _ _ _ _ _ K).
  - assert (In x (kids A a)) as X by (rewrite K; apply in_elt).
    cbn [Ranked.turn]. rewrite (parent_rank_of_kid A a x X).
    rewrite (proj2 (Z.leb_gt _ _) I1). destruct r''; cbn [map].
    + now rewrite (next_of_last A _ _ _ K), (up_of_last A _ _ _ K).
    + now rewrite (next_of_kid A _ _ _ _ _ K).
Qed.

Lemma turn_visit p :
  turn (Visit p) = match descents p with q :: _ => Visit q | [] => Behind p end.
Proof.
  destruct p as [a b]. unfold Ranked.descents. cbn [Ranked.turn Ranked.expand fst snd].
  destruct (overlap a b); [|reflexivity].
  destruct (rank A a <? rank B b); [destruct (kids B b) | destruct (kids A a)]; reflexivity.
Qed.

Lemma turn_last : turn (Behind roots) = Done.
Proof. cbn. now rewrite !parent_rank_of_root, Z.leb_refl, next_of_root, root_is_root. Qed.

Lemma child_expand p q : In q (descents p) -> In q (expand p).
Proof. unfold Ranked.descents. now destruct (overlap (fst p) (snd p)). Qed.

Lemma split_expand p l q r : descents p = l ++ q :: r -> expand p = l ++ q :: r.
Proof. unfold Ranked.descents. destruct (overlap (fst p) (snd p)); auto. now destruct l. Qed.

Lemma smaller_child p q : In q (expand p) -> (size q < size p)%nat.
Proof.
  destruct p as [a b]. cbn [Ranked.expand].
  destruct (rank A a <? rank B b); intros I; apply in_map_iff in I as (x & <- & I);
    apply height_of_kid in I; unfold Ranked.size; cbn [fst snd]; lia.
Qed.

Lemma Run_none s : Run 0 s [] s.
Proof. now split. Qed.
Lemma Run_visit n p t s : Run n (turn (Visit p)) t s -> Run (S n) (Visit p) (p :: t) s.
Proof. intros [<- <-]. now split. Qed.
Lemma Run_behind n p t s : Run n (turn (Behind p)) t s -> Run (S n) (Behind p) t s.
Proof. intros [<- <-]. now split. Qed.

Lemma Run_trans n : forall s t s' n' t' s'',
  Run n s t s' -> Run n' s' t' s'' -> Run (n + n') s (t ++ t') s''.
Proof.
  induction n as [|n IH]; intros s t s' n' t' s'' [<- <-] R; [exact R|].
  destruct (IH (turn s) _ _ n' t' s'' (conj eq_refl eq_refl) R) as [E F].
  split; [exact E|]. cbn [trace Nat.add]. cbn in F. now rewrite F, app_assoc.
Qed.

Lemma Run_from n : forall s t s' l p r, Run n s t s' -> t = l ++ p :: r ->
  exists m, Run m (Visit p) (p :: r) s'.
Proof.
  induction n as [|n IH]; intros s t s' l p r [<- <-] E; cbn [trace] in E; [now destruct l|].
  assert (forall l, trace A B overlap n (turn s) = l ++ p :: r ->
    exists m, Run m (Visit p) (p :: r) (after A B overlap n (turn s))) as G
    by (intros l' E'; now apply (IH (turn s) _ _ l' p r (conj eq_refl eq_refl))).
  destruct s as [q | q |]; [destruct l as [|z l]; injection E as -> E | |]; eauto.
  exists (S n). split; [reflexivity|]. cbn [trace app]. now f_equal.
Qed.

Lemma dfs_not_empty d p : (size p < d)%nat -> (0 < length (dfs d p))%nat.
Proof. destruct d; cbn; lia. Qed.

(* The loop treats a pair like the recursion, in two turns per visit, and is then behind it. *)
Lemma finishes d : forall p, (size p < d)%nat -> Inv p ->
  Run (2 * length (dfs d p) - 1) (Visit p) (dfs d p) (Behind p).
Proof.
  induction d as [|d IH]; intros p H I; [lia|].
  assert (forall r l, descents p = l ++ r -> Run (2 * length (flat_map (dfs d) r))
    (match r with q :: _ => Visit q | [] => Behind p end) (flat_map (dfs d) r) (Behind p)) as Go.
  { induction r as [|q r IHr]; intros l D; [apply Run_none|].
    assert (In q (expand p)) as Q by (apply child_expand; rewrite D; apply in_elt).
    assert (size q < d)%nat as L by (pose proof (smaller_child _ _ Q); lia).
    pose proof (dfs_not_empty d q L). cbn [flat_map]. rewrite app_length.
    replace (2 * _)%nat with (2 * length (dfs d q) - 1 + S (2 * length (flat_map (dfs d) r)))%nat by lia.
    apply (Run_trans _ _ _ _ _ _ _ (IH q L (Inv_child _ _ I Q))). apply Run_behind.
    rewrite (turn_behind _ _ _ _ I (split_expand _ _ _ _ D)). apply (IHr (l ++ [q])). now rewrite <- app_assoc. }
  cbn [Ranked.dfs length]. replace (2 * _ - 1)%nat with (S (2 * length (flat_map (dfs d) (descents p)))) by lia.
  apply Run_visit. rewrite turn_visit. now apply (Go _ []).
Qed.

Theorem walk_is_dfs : Walk_is_dfs A B overlap.
Proof.
  intros d E. pose proof (finishes d _ E Inv_roots) as F. pose proof (dfs_not_empty d roots E).
  replace (2 * _)%nat with (2 * length (dfs d roots) - 1 + 1)%nat by lia.
  rewrite <- (app_nil_r (dfs d roots)) at 2.
  apply (Run_trans _ _ _ _ _ _ _ F). apply Run_behind. rewrite turn_last. apply Run_none.
Qed.

Theorem resumes : Resumes A B overlap.
Proof. intros d l p r E D. exact (Run_from _ _ _ _ _ _ _ (walk_is_dfs d E) D). Qed.

Theorem resumes_behind : Resumes_behind A B overlap.
Proof.
  intros d l p r E D N. destruct (resumes d l p r E D) as (n & R).
  destruct n as [|n]; destruct R as [R1 R2]; [discriminate|].
  exists n. cbn [after trace app] in R1, R2. rewrite turn_visit, N in *.
  injection R2 as R2. now split.
Qed.

Lemma done_stays n : after A B overlap n Done = Done /\ trace A B overlap n Done = [].
Proof. induction n; auto. Qed.

Lemma Run_done n : forall m s t u, Run n s t Done -> Run m s u Done -> t = u.
Proof.
  induction n as [|n IH]; intros m s t u R Q.
  - destruct R as [E <-], Q as [_ <-]. cbn in E. subst s. now rewrite (proj2 (done_stays m)).
  - destruct m as [|m].
    + destruct R as [_ <-], Q as [E <-]. cbn in E. subst s. now rewrite (proj2 (done_stays (S n))).
    + destruct R as [E <-], Q as [F <-]. cbn [after trace] in *. f_equal.
      now apply (IH m (turn s)).
Qed.

Theorem visits_once : Visits_once A B overlap.
Proof.
  intros d E. assert (forall suffix l, dfs d roots = l ++ suffix -> NoDup suffix) as G.
  { induction suffix as [|p r IH]; intros l D; constructor.
    - intros I. apply in_split in I as (l' & q & ->).
      destruct (resumes d _ _ _ E D) as (n & R).
      rewrite app_comm_cons, app_assoc in D. destruct (resumes d _ _ _ E D) as (m & Q).
      pose proof (Run_done _ _ _ _ _ R Q) as W. apply (f_equal (@length _)) in W.
      cbn in W. rewrite app_length in W. cbn in W. lia.
    - apply (IH (l ++ [p])). now rewrite <- app_assoc. }
  now apply (G _ []).
Qed.

(* ---- The visited pairs. *)

Lemma Under_trans (T : Tree) (x y z : Node T) : Under x y -> Under y z -> Under x z.
Proof. induction 1; eauto. Qed.

Lemma In_trees_child p q : In_trees A B p -> In q (expand p) -> In_trees A B q.
Proof.
  destruct p as [a b]. intros [U V]. cbn [Ranked.expand].
  destruct (rank A a <? rank B b); intros I; apply in_map_iff in I as (x & <- & I); split;
    cbn [fst snd] in *; auto; eapply Under_trans; eauto.
Qed.

Theorem visited_can_be : Visited_can_be A B overlap.
Proof.
  intros d p _. assert (In_trees A B roots) as T by (split; constructor).
  generalize Inv_roots T. generalize roots as q.
  induction d as [|d IH]; intros q I U P; [easy|]. destruct P as [<- | P]; auto.
  apply in_flat_map in P as (z & Z & P). apply child_expand in Z.
  apply (IH z); eauto using Inv_child, In_trees_child.
Qed.

(* Steps below the root, for induction. *)
Lemma in_tree (T : Tree) (x : Node T) : Under (root T) x ->
  x = root T \/ exists n, Under (root T) n /\ In x (kids T n).
Proof.
  assert (forall r x, Under r x -> x = r \/ exists n, Under r n /\ In x (kids T n)) as G.
  { induction 1 as [|n x' y I U [-> | (m & M & J)]]; eauto. }
  apply G.
Qed.

Lemma rank_below_parent (T : Tree) x : Under (root T) x -> rank T x <= parent_rank T x.
Proof.
  intros U. destruct (in_tree T x U) as [-> | (n & _ & I)].
  - rewrite parent_rank_of_root. pose proof (rank_limit T (root T)). lia.
  - rewrite (parent_rank_of_kid T _ _ I). now apply rank_monotone.
Qed.

(* Every pair with the invariant, except the roots, follows from one with the invariant. *)
Lemma came_from q : In_trees A B q -> Inv q ->
  q = roots \/ exists p, In_trees A B p /\ Inv p /\ In q (expand p).
Proof.
  destruct q as [a b]. intros [U V] [I1 I2]. cbn [fst snd] in U, V.
  destruct (Z.leb_spec (parent_rank B b) (parent_rank A a)) as [L|L].
  - destruct (in_tree B b V) as [-> | (n & W & K)].
    + rewrite parent_rank_of_root in L. destruct (in_tree A a U) as [-> | (n & W & K)]; [now left|].
      rewrite (parent_rank_of_kid A _ _ K) in L. pose proof (rank_limit A n). lia.
    + pose proof (rank_below_parent B _ W). rewrite (parent_rank_of_kid B _ _ K) in *.
      right. exists (a, n). repeat split; cbn [fst snd]; auto; try lia.
      cbn [Ranked.expand]. rewrite (proj2 (Z.ltb_lt _ _) I1).
      now apply in_map with (f := fun y => (a, y)).
  - destruct (in_tree A a U) as [-> | (n & W & K)].
    + rewrite parent_rank_of_root in L. destruct (in_tree B b V) as [-> | (n & W & K)];
        [rewrite parent_rank_of_root in L; lia|].
      rewrite (parent_rank_of_kid B _ _ K) in L. pose proof (rank_limit B n). lia.
    + pose proof (rank_below_parent A _ W). rewrite (parent_rank_of_kid A _ _ K) in *.
      right. exists (n, b). repeat split; cbn [fst snd]; auto; try lia.
      cbn [Ranked.expand]. rewrite (proj2 (Z.ltb_ge _ _) I2).
      now apply in_map with (f := fun x => (x, b)).
Qed.

Lemma height_under (T : Tree) (n x : Node T) : Under n x -> (height T x <= height T n)%nat.
Proof. induction 1; auto. pose proof (height_of_kid T _ _ H). lia. Qed.

(* Induction from the roots down: over pairs with the invariant, in order of their expansion. *)
Lemma down_from_roots (P : Pair A B -> Prop) :
  P roots ->
  (forall p q, In_trees A B p -> Inv p -> P p -> In q (expand p) -> P q) ->
  forall q, In_trees A B q -> Inv q -> P q.
Proof.
  intros R S. assert (forall k q, (size roots - size q < k)%nat -> In_trees A B q -> Inv q -> P q) as G.
  { induction k as [|k IH]; intros q H T I; [lia|].
    destruct (came_from q T I) as [-> | (p & Tp & Ip & C)]; auto. eapply S; eauto. apply IH; auto.
    pose proof (smaller_child _ _ C). destruct T as [T1 T2], Tp as [Tp1 Tp2].
    apply height_under in T1, T2, Tp1, Tp2. unfold Ranked.size, Ranked.roots in *.
    cbn [fst snd] in *. lia. }
  intros q. apply (G (1 + (size roots - size q))%nat). lia.
Qed.

Lemma Ends_turn s : Ends A B overlap (turn s) -> Ends A B overlap s.
Proof. intros (n & t & [E F]). now exists (S n), (trace A B overlap (S n) s). Qed.

Lemma Ends_run n s t s' : Run n s t s' -> Ends A B overlap s' -> Ends A B overlap s.
Proof. intros R (n' & t' & R'). exists (n + n')%nat, (t ++ t'). eapply Run_trans; eauto. Qed.

Lemma ends_behind q : In_trees A B q -> Inv q -> Ends A B overlap (Behind q).
Proof.
  revert q. apply down_from_roots.
  - apply Ends_turn. rewrite turn_last. exists O, []. apply Run_none.
  - intros p q _ I Up C. apply in_split in C as (l & r & C). revert q l C.
    induction r as [|z r IHr]; intros q l C; apply Ends_turn;
      rewrite (turn_behind _ _ _ _ I C); auto.
    assert (Inv z) as Iz.
    { apply (Inv_child _ _ I). rewrite C. apply in_or_app. cbn. auto. }
    eapply Ends_run; [apply (finishes (S (size z)) z); auto|].
    apply (IHr z (l ++ [q])). now rewrite <- app_assoc.
Qed.

Theorem ends_from_everywhere : Ends_from_everywhere A B overlap.
Proof.
  intros p T I. split; [|now apply ends_behind].
  eapply Ends_run; [apply (finishes (S (size p)) p); auto | now apply ends_behind].
Qed.

(* ---- The found pairs. *)

Lemma dfs_reaches d hit : safe A B overlap hit -> forall a b x y,
  (size (a, b) < d)%nat -> Under a x -> Under b y ->
  kids A x = [] -> kids B y = [] -> hit (x, y) = true -> In (x, y) (dfs d (a, b)).
Proof.
  intros S. induction d as [|d IH]; intros a b x y H UA UB LX LY O; [lia|].
  assert ((x, y) = (a, b) \/ exists x' y', In (x', y') (expand (a, b)) /\
    Under x' x /\ Under y' y) as [<- | (x' & y' & I & UX & UY)].
  { apply (rank_of_leaf A) in LX as RX. apply (rank_of_leaf B) in LY as RY.
    cbn [Ranked.expand]. destruct (Z.ltb_spec (rank A a) (rank B b)).
    - destruct UB as [|? y' ? K U].
      + destruct UA as [|? x' ? K U]; auto.
        assert (kids A n0 = []) as N by (apply (rank_of_leaf A); lia). rewrite N in K. destruct K.
      + right. exists a, y'. repeat split; auto. now apply in_map with (f := fun y => (a, y)).
    - destruct UA as [|? x' ? K U].
      + destruct UB as [|? y' ? K U]; auto.
        assert (kids B n0 <> []) as N by (intros N; now rewrite N in K).
        apply (rank_of_internal B) in N. lia.
      + right. exists x', b. repeat split; auto. now apply in_map with (f := fun x => (x, b)). }
  - now left.
  - right. apply in_flat_map. exists (x', y'). split.
    + unfold Ranked.descents. cbn [fst snd]. now rewrite (S a b x y).
    + apply smaller_child in I. apply IH; auto. lia.
Qed.

Theorem finds_each_once : Finds_each_once A B overlap.
Proof.
  intros d hit E S. split; [apply NoDup_filter; now apply visits_once|].
  intros [x y]. rewrite filter_In. unfold found, is_leaf_pair. cbn [fst snd].
  rewrite !andb_true_iff, !Z.ltb_lt, <- (rank_of_leaf A), <- (rank_of_leaf B). split.
  - intros (V & (_ & LX & LY) & O). apply visited_can_be in V; auto. tauto.
  - intros ((U & V) & LX & LY & O). cbn [fst snd] in *. repeat split; auto.
    + apply (dfs_reaches d hit); auto.
    + apply (S x y x y); auto; constructor.
Qed.
End Proofs.

Theorem can_be_visited {limits : Limits} A B : Can_be_visited A B.
Proof.
  intros d q E T I.
  assert (forall d r p q, (size A B r < d)%nat -> In p (dfs A B (fun _ _ => true) d r) ->
    In q (expand A B p) -> In q (dfs A B (fun _ _ => true) d r)) as Step.
  { clear. induction d as [|d IH]; intros r p q H P Q; [easy|]. destruct P as [<- | P]; right; apply in_flat_map.
    - exists q. split; [exact Q|]. apply (smaller_child A B) in Q. destruct d; [lia | now left].
    - apply in_flat_map in P as (z & Z & P). exists z. split; auto. apply (IH z p q); auto.
      apply (smaller_child A B) in Z. lia. }
  revert q T I. apply down_from_roots; [|eauto]. unfold enough in E. destruct d; [lia | now left].
Qed.

(* The ranks of mesh.hpp. *)
#[global] Instance ranks_of_nodes : Limits.
Proof. exists kMaxRank kRootParentRank. now split. Defined.
