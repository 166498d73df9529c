(* A query cut into runs (lib/include/flashbvh/detail/query/query_run.hpp): batches of pairs of leaves, cursors, and the
   rest of a pair of leaves. Wherever runs end, the answers are equal: all pairs of triangles that pass the exact
   test, each once.

   Part 1  definitions.   Part 2  the theorems.   Part 3  their proofs. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants Ranked Code.
Import ListNotations.

(* ============================================================== Part 1: definitions *)

(* QueryCursor; `untested`: the number of remaining pairs of triangles of the pair of leaves. *)
Inductive Position :=
| Fresh
| At_pair (p : nat * nat)
| At_leaf_pair (p : nat * nat) (untested : nat)
| Finished.

Section Query.
Variables cells_a cells_b : list Cell.
Variables children_a children_b : nat -> list nat.
Hypothesis FA : Post_indexed cells_a children_a.
Hypothesis FB : Post_indexed cells_b children_b.
Variable bound begin : nat -> nat -> bool.
Variable touch : Side -> nat -> nat -> bool.

Variable Triangles : Type.                           (* a triangle of A and one of B *)
Variable pairs_of : nat * nat -> list Triangles.     (* of two leaves, in the order of testing *)
Variable intersect : Triangles -> bool.              (* the exact test *)

Let step := code_turn cells_a cells_b bound begin touch.
Let finds := finds cells_a cells_b bound touch.

Definition answers (p : nat * nat) : list Triangles := filter intersect (pairs_of p).
Definition last_of (u : nat) (p : nat * nat) := skipn (length (pairs_of p) - u) (pairs_of p).

(* The walk that a run begins. Its traversal is Ranked; near_first.hpp's is left out. *)
(* code: include/flashbvh/traversal/ranked.hpp | using OfTranslations = Ranked; *)
(* code: include/flashbvh/detail/query/query_run.hpp | return detail::walk<typename Traversal::OfTranslations>(bound, shapes, run, state_); *)
(* code: include/flashbvh/detail/query/query_run.hpp | return detail::walk<Traversal>(ByReference<decltype(bound)>{&bound}, shapes, run, state_); *)
(* code: include/flashbvh/detail/walk/walk.hpp | from = walk_on_below<Traversal>(shapes, run, from == State::at_leaf_pair); *)
Definition load (at_ : Position) : Code :=
  match at_ with
  | Fresh => begin_walk cells_a cells_b
  | At_pair p => resume_walk cells_a cells_b true p
  | At_leaf_pair p _ => resume_walk cells_a cells_b false p
  | Finished => CDone
  end.

(* The pairs of leaves that n turns find. *)
Fixpoint found_in (n : nat) (c : Code) : list (nat * nat) :=
  match n with
  | O => []
  | S m => (if finds c then match visited c with Some p => [p] | None => [] end else [])
             ++ found_in m (step c)
  end.
Let go := code_after cells_a cells_b bound begin touch.

(* The stops of a walk of n turns: before a visit, without work; behind a found pair of leaves, the last of the batch;
at
   the end. *)
Inductive Stops (c : Code) : nat -> Position -> Prop :=
| Stops_before n p : visited (go n c) = Some p -> Stops c n (At_pair p)
| Stops_behind n p : visited (go n c) = Some p -> finds (go n c) = true ->
    Stops c (S n) (At_leaf_pair p 0)
| Stops_at_end n : go n c = CDone -> Stops c n Finished.

Definition nothing_untested (at_ : Position) : Prop :=
  match at_ with At_leaf_pair _ u => u = 0 | Finished => False | _ => True end.

(* When a walk resumes below the root that the previous one kept, walk_below() and walk_pairs() continue as in one run:
   here they are one walk, tested in parts. *)
(* code: include/flashbvh/detail/walk/walk.hpp | shapes.keep_root(run.side == Side::a ? at.index_b() : at.index_a()); *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | State end = walk_below(shapes, run, root, after); *)
(* code: include/flashbvh/detail/walk/walk_below.hpp | run.node = root; run.side = Side::none; shapes.keep_root(0); end = State::at_leaf_pair; *)
(* A single run of a query, up to its end: without work, with a full batch, or with a full array of the caller.
   `Round at answers at'`. *)
(* code: include/flashbvh/detail/query/query_run.hpp | const uint32_t kept = untested_ == 0 ? 0 : pay(untested_, work); *)
(* code: include/flashbvh/detail/query/query_run.hpp | batch.current().a, batch.current().b); *)
(* code: include/flashbvh/detail/query/query_run.hpp | if (untested_ == 0) { end = walk(work, batch, shapes, room()); } *)
(* code: include/flashbvh/detail/walk/leaf_pairs.hpp | if (progress.work_left < work) { unpaid_ = true; return false; } *)
Inductive Round : Position -> list Triangles -> Position -> Prop :=
| Tests p u v : v <= u <= length (pairs_of p) ->     (* v of the remaining pairs of triangles *)
    Round (At_leaf_pair p u) (filter intersect (firstn v (last_of u p))) (At_leaf_pair p (u - v))
| Walks at_ n at' : nothing_untested at_ -> 1 <= n -> Stops (load at_) n at' ->
    Round at_ (flat_map answers (found_in n (load at_))) at'      (* a batch, tested to its end *)
| Leaves_off at_ n l p r v :                         (* a batch, stopped inside a pair of leaves *)
    nothing_untested at_ -> found_in n (load at_) = l ++ p :: r -> v <= length (pairs_of p) ->
    Round at_ (flat_map answers l ++ filter intersect (firstn v (pairs_of p)))
      (At_leaf_pair p (length (pairs_of p) - v)).

Inductive Rounds : Position -> list Triangles -> Position -> Prop :=
| No_round at_ : Rounds at_ [] at_
| And_round at_ e at' f at'' : Round at_ e at' -> Rounds at' f at'' -> Rounds at_ (e ++ f) at''.

(* The cursors that resume() accepts. (A query's own cursor is never before the visit of the roots.) *)
Definition accepted (at_ : Position) : Prop :=
  match at_ with
  | At_pair (i, j) => good cells_a cells_b children_a children_b FA FB i j /\ (i, j) <> (0, 0)
  | At_leaf_pair (i, j) u =>
      good cells_a cells_b children_a children_b FA FB i j /\ u <= length (pairs_of (i, j))
  | _ => True
  end.

(* ============================================================== Part 2: the theorems *)

(* From each accepted cursor, all divisions that reach the end give equal answers, and every cursor in between is
   accepted. *)
Definition Cuts_agree := forall at_, accepted at_ -> exists all,
  (forall e, Rounds at_ e Finished -> e = all) /\
  (forall e at', Rounds at_ e at' -> accepted at' /\ exists left_, all = e ++ left_ /\
     forall f, Rounds at' f Finished -> f = left_).

(* The end can always be reached. *)
Definition Can_end := forall at_, accepted at_ -> exists e, Rounds at_ e Finished.

(* Pairs that boxes or slabs reject contain no answer. *)
Definition Below_a := Under (T := array_tree cells_a children_a FA).
Definition Below_b := Under (T := array_tree cells_b children_b FB).
Definition rejects_safely (test : nat -> nat -> bool) : Prop := forall a b x y t,
  Below_a a x -> Below_b b y -> children_a x = [] -> children_b y = [] ->
  In t (pairs_of (x, y)) -> intersect t = true -> test a b = true.

(* Exactly the intersecting pairs of triangles of all leaves; each once, if leaves share none. *)
Definition Answers_are_exact :=
  rejects_safely bound -> rejects_safely begin -> (forall side, rejects_safely (touch side)) ->
  forall e, Rounds Fresh e Finished ->
    (forall t, In t e <-> exists x y, x < length cells_a /\ y < length cells_b /\
       children_a x = [] /\ children_b y = [] /\ In t (pairs_of (x, y)) /\ intersect t = true) /\
    ((forall p, NoDup (pairs_of p)) ->
     (forall p q t, In t (pairs_of p) -> In t (pairs_of q) -> p = q) -> NoDup e).

(* ============================================================== Part 3: the proofs *)

Let A := array_tree cells_a children_a FA.
Let B := array_tree cells_b children_b FB.
Let overlap : Node A -> Node B -> bool := tested cells_a cells_b bound begin touch.
Local Notation Stands_for := (Stands_for cells_a cells_b children_a children_b FA FB).
Local Notation good := (good cells_a cells_b children_a children_b FA FB).
Local Notation After := (after A B overlap).
Local Notation Trace := (trace A B overlap).
Local Notation Found := (filter (found A B overlap)).

Lemma stands_for_visited c s p : Stands_for c s -> visited c = Some p ->
  s = Visit (p : Pair A B) /\ good (fst p) (snd p).
Proof.
  destruct 1 as [i j G | | r v i m j _ G | r v m i j _ G |]; try discriminate; cbn.
  - intros [= <-]. auto.
  - destruct v; [|discriminate]. intros [= <-]. auto.
  - destruct v; [|discriminate]. intros [= <-]. auto.
Qed.

Lemma stands_for_done s : Stands_for CDone s -> s = Done.
Proof. intros S. now inversion S. Qed.

Lemma simulates_n n : forall c s, Stands_for c s ->
  Stands_for (go n c) (After n s) /\ found_in n c = Found (Trace n s).
Proof.
  induction n as [|n IH]; intros c s S; [now split|].
  destruct (simulates _ _ _ _ FA FB bound begin touch c s S) as (S' & V & F).
  destruct (IH _ _ S') as [E1 E2]. split; [exact E1|].
  cbn [found_in trace]. rewrite filter_app. fold step in E2. rewrite E2. f_equal.
  unfold finds. rewrite F, V. destruct s as [p | p |]; reflexivity.
Qed.

Lemma after_add n m s : After (n + m) s = After m (After n s).
Proof. revert s. induction n; cbn; auto. Qed.
Lemma trace_add n m s : Trace (n + m) s = Trace n s ++ Trace m (After n s).
Proof.
  revert s. induction n as [|n IH]; intros s; [reflexivity|].
  cbn [Nat.add trace after]. now rewrite IH, app_assoc.
Qed.

(* The remaining answers from a state of the loop. *)
Definition Left (s : State A B) (l : list Triangles) : Prop :=
  exists n t, Run A B overlap n s t Done /\ l = flat_map answers (Found t).

Lemma Left_after n s l : Left s l ->
  exists l', Left (After n s) l' /\ l = flat_map answers (Found (Trace n s)) ++ l'.
Proof.
  intros (m & t & [E <-] & ->).
  assert (After (n + m) s = Done /\ Trace (n + m) s = Trace m s) as [E1 E2].
  { rewrite Nat.add_comm, after_add, trace_add, E. fold A B.
    destruct (done_stays A B overlap n) as [-> ->]. now rewrite app_nil_r. }
  rewrite after_add in E1. rewrite trace_add in E2.
  exists (flat_map answers (Found (Trace m (After n s)))).
  split; [exists m, (Trace m (After n s)); now split|].
  now rewrite <- flat_map_app, <- filter_app, E2.
Qed.

Definition Left_at (at_ : Position) (l : list Triangles) : Prop :=
  match at_ with
  | Fresh => Left (Visit (roots A B)) l
  | At_pair p => Left (Visit (p : Pair A B)) l
  | At_leaf_pair p u => exists l', l = filter intersect (last_of u p) ++ l' /\
      Left (Behind (p : Pair A B)) l'
  | Finished => l = []
  end.

Lemma in_trees i j : good i j -> In_trees A B (pair_at _ _ _ _ FA FB i j).
Proof. intros [[L M] _]. split; now apply all_under. Qed.

Lemma left_exists at_ : accepted at_ -> exists l, Left_at at_ l.
Proof.
  assert (forall p, In_trees A B p -> can_visit A B p ->
    (exists l, Left (Visit p) l) /\ (exists l, Left (Behind p) l)) as E.
  { intros p T C. destruct (ends_from_everywhere A B overlap p T C) as [(n & t & R) (m & u & Q)].
    split; eexists; eexists; eexists; eauto. }
  destruct at_ as [|[i j]|[i j] u|]; cbn; intros H; eauto.
  - apply E; [split; constructor | apply Inv_roots].
  - destruct H as [G _]. apply (E (i, j)); [now apply in_trees | apply G].
  - destruct H as [G _]. destruct (E (i, j)) as [_ [l L]]; [now apply in_trees | apply G | eauto].
Qed.

(* The state that load() makes of a cursor represents it. *)
Definition state_of (at_ : Position) : State A B :=
  match at_ with
  | Fresh => Visit (roots A B)
  | At_pair p => Visit (p : Pair A B)
  | At_leaf_pair p _ => Behind (p : Pair A B)
  | Finished => Done
  end.

Lemma load_stands at_ : accepted at_ -> Stands_for (load at_) (state_of at_).
Proof.
  destruct (starts _ _ _ _ FA FB) as [S0 S].
  destruct at_ as [|[i j]|[i j] u|]; cbn; intros H; auto.
  - apply (S i j true); tauto.
  - apply (S i j false); [tauto | discriminate].
  - constructor.
Qed.

Lemma left_of_state at_ l : nothing_untested at_ -> Left_at at_ l -> Left (state_of at_) l.
Proof.
  destruct at_ as [|p|p u|]; cbn; auto; [|easy]. intros -> (l' & -> & L). unfold last_of.
  now rewrite Nat.sub_0_r, skipn_all.
Qed.

Lemma turn_not_roots c s i j : Stands_for c s -> turn A B overlap s = Visit (pair_at _ _ _ _ FA FB i j) ->
  (i, j) <> (0, 0).
Proof.
  intros S. assert (forall i j, good i j -> turn A B overlap (Behind (pair_at _ _ _ _ FA FB i j)) =
    Visit (pair_at _ _ _ _ FA FB 0 0) -> False) as Next.
  { clear. intros i j [[LA LB] _]. unfold pair_at. cbn [turn].
    change (next A i) with (arr_next cells_a i). change (next B j) with (arr_next cells_b j).
    change (is_root B j) with (j =? 0).
    destruct (_ <=? _)%Z.
    - destruct (arr_next cells_b j) eqn:N; [|now destruct (j =? 0)]. intros [= -> ->].
      destruct j; [discriminate|]. destruct (has_parent _ _ FB (S j)) as (n & _ & [[E _]|(s & E & I & _)]);
        [lia | congruence|]. rewrite N in E. injection E as <-. apply (after_parent' _ _ FB) in I. lia.
    - destruct (arr_next cells_a i) eqn:N; [|discriminate]. intros [= -> ->].
      destruct i; [discriminate|]. destruct (has_parent _ _ FA (S i)) as (n & _ & [[E _]|(s & E & I & _)]);
        [lia | congruence|]. rewrite N in E. injection E as <-. apply (after_parent' _ _ FA) in I. lia. }
  assert (forall i j, turn A B overlap (Visit (pair_at _ _ _ _ FA FB i j)) =
    Visit (pair_at _ _ _ _ FA FB 0 0) -> False) as Down.
  { clear. intros i j E. unfold pair_at in E. rewrite turn_visit in E.
    assert (In (pair_at _ _ _ _ FA FB 0 0) (descents A B overlap (i, j))) as I.
    { revert E. fold A B. destruct (descents A B overlap (i, j)); [discriminate|].
      intros [= ->]. now left. }
    apply child_expand in I.
    cbn [expand] in I. destruct (_ <? _)%Z; apply in_map_iff in I as (x & [= -> ->] & I).
    - apply (after_parent' _ _ FB) in I. lia.
    - apply (after_parent' _ _ FA) in I. lia. }
  intros E [= -> ->]. destruct S as [i j | r i j G | r [|] i m j _ G | r [|] m i j _ G |]; eauto; discriminate.
Qed.

Lemma good_behind p c s : Stands_for c s -> finds c = true -> visited c = Some p ->
  s = Visit (p : Pair A B) /\ turn A B overlap s = Behind (p : Pair A B) /\
  found A B overlap p = true /\ good (fst p) (snd p).
Proof.
  intros S F V. destruct (stands_for_visited c s p S V) as [-> G].
  destruct (simulates _ _ _ _ FA FB bound begin touch c _ S) as (_ & _ & E).
  unfold finds in F. rewrite F in E. cbn [finds_of] in E. symmetry in E. repeat split; auto; try apply G.
  destruct p as [i j]. unfold found, is_leaf_pair in E. cbn [fst snd] in E.
  rewrite !andb_true_iff in E. now apply (turn_leaves _ _ _ _ FA FB).
Qed.

Lemma found_split n : forall c l p r, found_in n c = l ++ p :: r -> exists m,
  found_in m c = l /\ visited (go m c) = Some p /\ finds (go m c) = true.
Proof.
  induction n as [|n IH]; intros c l p r E; cbn [found_in] in E; [now destruct l|].
  assert (forall l', found_in n (step c) = l' ++ p :: r ->
    l = (if finds c then match visited c with Some p => [p] | None => [] end else []) ++ l' ->
    exists m, found_in m c = l /\ visited (go m c) = Some p /\ finds (go m c) = true) as Later.
  { intros l' E' ->. destruct (IH _ _ _ _ E') as (m & <- & V & F). now exists (S m). }
  destruct (finds c) eqn:F; [destruct (visited c) as [q|] eqn:V|]; cbn [app] in *; eauto.
  destruct l as [|z l]; injection E as -> E; [now exists O | now apply (Later l)].
Qed.

Lemma skipn_skipn (T : Type) n m (l : list T) : skipn n (skipn m l) = skipn (m + n) l.
Proof. revert l. induction m; intros [|x l]; cbn; auto. apply skipn_nil. Qed.

Lemma round_keeps at_ e at' l : accepted at_ -> Left_at at_ l -> Round at_ e at' ->
  accepted at' /\ exists l', l = e ++ l' /\ Left_at at' l'.
Proof.
  intros H L R. destruct R as [p u v V | at_ n at' N P T | at_ n l0 p r v N F V].
  - destruct p as [i j]. destruct H as [G U]. cbn [accepted]. split; [split; [exact G | lia]|].
    destruct L as (l' & -> & L). exists (filter intersect (last_of (u - v) (i, j)) ++ l').
    split; [|exists l'; auto]. rewrite app_assoc, <- filter_app. do 2 f_equal. unfold last_of.
    rewrite <- (firstn_skipn v (skipn _ _)) at 1. f_equal. rewrite skipn_skipn. f_equal. lia.
  - pose proof (load_stands at_ H) as S. apply left_of_state in L; auto.
    destruct (simulates_n n _ _ S) as [Sn ->]. destruct (Left_after n _ _ L) as (l' & L' & E).
    destruct T as [n p Vp | n p Vp Fp | n D].
    + destruct (stands_for_visited _ _ p Sn Vp) as [Ep G]. rewrite Ep in L'.
      split; [|eauto]. destruct p as [i j]. split; [exact G|]. destruct n as [|n]; [lia|].
      destruct (simulates_n n _ _ S) as [Sm _]. eapply (turn_not_roots _ _ i j Sm).
      refine (eq_trans _ Ep). change (Datatypes.S n) with (1 + n).
      now rewrite Nat.add_comm, after_add.
    + destruct (simulates_n n _ _ S) as [Sm _].
      destruct (good_behind p _ _ Sm Fp Vp) as (_ & Ep & _ & G).
      replace (After (Datatypes.S n) (state_of at_)) with (Behind (p : Pair A B)) in L'.
      2:{ rewrite <- Ep. change (Datatypes.S n) with (1 + n). now rewrite Nat.add_comm, after_add. }
      destruct p as [i j]. split; [split; [exact G | lia]|]. exists l'. split; auto.
      exists l'. split; auto. unfold last_of. now rewrite Nat.sub_0_r, skipn_all.
    + rewrite D in Sn. apply stands_for_done in Sn. rewrite Sn in L'. split; [exact I|].
      exists l'. split; auto. destruct L' as (m & t & [_ <-] & ->).
      exact (f_equal (fun t => flat_map answers (Found t)) (proj2 (done_stays A B overlap m))).
  - pose proof (load_stands at_ H) as S. apply left_of_state in L; auto.
    destruct (found_split _ _ _ _ _ F) as (m & <- & Vp & Fp).
    destruct (simulates_n m _ _ S) as [Sm Em]. rewrite Em.
    destruct (good_behind p _ _ Sm Fp Vp) as (Es & Ep & Fo & G).
    destruct (Left_after (m + 1) _ _ L) as (l' & L' & ->).
    rewrite after_add, trace_add, Es in *. cbn [after trace app] in *. rewrite Ep in L'.
    destruct p as [i j]. split; [split; [exact G | lia]|].
    exists (filter intersect (skipn v (pairs_of (i, j))) ++ l'). split.
    + rewrite filter_app, flat_map_app. cbn [filter]. rewrite Fo. cbn [flat_map].
      rewrite app_nil_r, <- !app_assoc. f_equal. unfold answers.
      rewrite <- (firstn_skipn v (pairs_of (i, j))) at 1. now rewrite filter_app, <- app_assoc.
    + exists l'. split; auto. do 2 f_equal. unfold last_of. f_equal. lia.
Qed.

Lemma rounds_keep at_ e at' : Rounds at_ e at' -> forall l, accepted at_ -> Left_at at_ l ->
  accepted at' /\ exists l', l = e ++ l' /\ Left_at at' l'.
Proof.
  intros Q. induction Q as [at_ | at_ e at' f at'' R Q IH]; intros l H L; [now split; [|exists l]|].
  destruct (round_keeps _ _ _ _ H L R) as (H' & l' & -> & L').
  destruct (IH l' H' L') as (H'' & l'' & -> & L''). split; auto. exists l''. now rewrite app_assoc.
Qed.

Theorem cuts_agree : Cuts_agree.
Proof.
  intros at_ H. destruct (left_exists at_ H) as [all L]. exists all.
  assert (forall at_ l e, accepted at_ -> Left_at at_ l -> Rounds at_ e Finished -> e = l) as Whole.
  { intros at' l e H' L' R. destruct (rounds_keep _ _ _ R l H' L') as (_ & l' & -> & E).
    cbn in E. subst l'. now rewrite app_nil_r. }
  split; [intros e R; now apply (Whole at_)|]. intros e at' R.
  destruct (rounds_keep _ _ _ R all H L) as (H' & l' & E & L'). split; auto.
  exists l'. split; auto. intros f Q. now apply (Whole at').
Qed.

Lemma stands_for_end c : Stands_for c Done -> c = CDone.
Proof. intros S. now inversion S; try destruct visit. Qed.

Theorem can_end : Can_end.
Proof.
  assert (forall at_, accepted at_ -> nothing_untested at_ -> exists e, Round at_ e Finished) as Walk.
  { intros at_ H N. destruct (left_exists at_ H) as [l L]. apply left_of_state in L; auto.
    destruct L as (n & t & [E _] & _).
    destruct (simulates_n n _ _ (load_stands at_ H)) as [S _]. rewrite E in S.
    eexists. apply (Walks at_ n); auto.
    - destruct n; [|lia]. destruct at_; now cbn in E.
    - apply Stops_at_end. now apply stands_for_end. }
  intros at_ H. destruct at_ as [|p|p u|]; [| | |now exists []; constructor].
  1, 2: destruct (Walk _ H I) as [e R]; eexists; eapply And_round; [exact R | constructor].
  assert (accepted (At_leaf_pair p 0)) as H0 by (destruct p; cbn in *; split; [tauto | lia]).
  destruct (Walk _ H0 eq_refl) as [e R]. eexists.
  eapply And_round; [|eapply And_round; [exact R | constructor]].
  replace 0 with (u - u) by lia. apply Tests. destruct p; cbn in *; lia.
Qed.

Lemma NoDup_flat_map (T U : Type) (f : T -> list U) l : NoDup l -> (forall x, NoDup (f x)) ->
  (forall x y u, In u (f x) -> In u (f y) -> x = y) -> NoDup (flat_map f l).
Proof.
  intros N F D. induction N as [|x l X N IH]; cbn; [constructor|].
  assert (forall a b : list U, NoDup a -> NoDup b -> (forall u, In u a -> ~ In u b) -> NoDup (a ++ b)) as App.
  { clear. intros a b M. induction M as [|u a X M IH]; cbn; auto. intros O H. constructor.
    - rewrite in_app_iff. intros [I | I]; [auto | apply (H u); auto].
    - apply IH; auto. }
  apply App; auto. intros u I J. apply in_flat_map in J as (y & Y & J).
  now rewrite (D x y u I J) in X.
Qed.

Theorem answers_are_exact : Answers_are_exact.
Proof.
  intros SB SG ST e R.
  set (hit := fun p : Pair A B => existsb intersect (pairs_of p)).
  assert (safe A B overlap hit) as Safe.
  { intros a b x y UA UB LX LY H. apply existsb_exists in H as (t & I & T).
    unfold overlap, tested. assert (bound a b = true) as -> by (eapply SB; eauto).
    assert (begin a b = true) as -> by (eapply SG; eauto). rewrite orb_true_r.
    destruct (side_of _ _ _ _); auto; eapply ST; eauto. }
  set (depth := S (length cells_a + length cells_b)).
  assert (enough A B depth) as D by (unfold enough, size; cbn; lia).
  pose proof (walk_is_dfs A B overlap depth D) as W.
  set (visits := dfs A B overlap depth (roots A B)) in *.
  assert (e = flat_map answers (Found visits)) as ->.
  { destruct (rounds_keep _ _ _ R (flat_map answers (Found visits))) as (_ & l & E & N).
    - exact I.
    - eexists; eexists; eauto.
    - cbn in N. subst l. now rewrite app_nil_r in E. }
  destruct (finds_each_once A B overlap depth hit D Safe) as [_ Exact].
  split.
  - intros t. rewrite in_flat_map. split.
    + intros ([x y] & P & T). apply filter_In in T as [T I]. apply filter_In in P as [P F].
      assert (hit (x, y) = true) as Hit by (apply existsb_exists; eauto).
      destruct (Exact (x, y)) as [To _].
      destruct To as ((UX & UY) & LX & LY & _); [apply filter_In; fold visits; rewrite F, Hit; auto|].
      exists x, y. repeat split; auto; eapply under_inside; eauto;
        [apply (fmt_some _ _ FA) | apply (fmt_some _ _ FB)].
    + intros (x & y & LX & LY & KX & KY & T & I). exists (x, y).
      split; [|now apply filter_In]. destruct (Exact (x, y)) as [_ From].
      assert (hit (x, y) = true) as Hit by (apply existsb_exists; eauto).
      apply filter_In. destruct (proj1 (filter_In _ _ _) (From ltac:(
        repeat split; auto; [now apply all_under | now apply all_under]))) as [V F].
      apply andb_true_iff in F. split; tauto.
  - intros N U. apply NoDup_flat_map.
    + apply NoDup_filter. now apply visits_once.
    + intros p. now apply NoDup_filter.
    + intros p q t P Q. apply filter_In in P as [P _], Q as [Q _]. eauto.
Qed.
End Query.
