(* Two triangles in one plane, and two without area: flat_intersect() of lib/src/predicates/triangle.cpp. For any edge
   that it finds in any projection, and if it reports skew segments, there is no common point. If it returns true,
   there is one. *)
From Coq Require Import ZArith Lia Psatz Bool Nsatz.
Require Import Triangle Segment Helly.
Local Open Scope Z_scope.

(* ============================================================== Definitions *)

(* Twice the area in a projection, and its sign, the turn.
   code: src/predicates/orientation.hpp | return static_cast<int64_t>(q.*u - p.*u) * (r.*v - p.*v) - static_cast<int64_t>(q.*v - p.*v) * (r.*u - p.*u);
   code: src/predicates/triangle.cpp | return twice > 0 ? 1 : twice < 0 ? -1 : 0; *)
Definition area (u v : Point -> Z) p q r := (u q - u p) * (v r - v p) - (v q - v p) * (u r - u p).
Definition turn u v p q r := Z.sgn (area u v p q r).

(* code: src/predicates/triangle.cpp | if (side != 0 && side != inner && side == turn(onto, p, q, b.corner[1]) && side == turn(onto, p, q, b.corner[2])) { *)
Definition beyond u v inner p q b0 b1 b2 : bool :=
  let side := turn u v p q b0 in
  negb (side =? 0) && negb (side =? inner) && (side =? turn u v p q b1) && (side =? turn u v p q b2).
Definition edge_separates u v a0 a1 a2 b0 b1 b2 : bool :=
  let inner := turn u v a0 a1 a2 in
  beyond u v inner a0 a1 b0 b1 b2 || beyond u v inner a1 a2 b0 b1 b2 || beyond u v inner a2 a0 b0 b1 b2.

(* code: src/predicates/triangle.cpp | if (detail::volume<Wide>(a.corner[0], a.corner[i], b.corner[0], b.corner[j]) != 0) { *)
Definition coplanar a0 a1 a2 b0 b1 b2 : bool :=
  (volume a0 a1 b0 b1 =? 0) && (volume a0 a1 b0 b2 =? 0) && (volume a0 a2 b0 b1 =? 0) && (volume a0 a2 b0 b2 =? 0).

(* code: src/predicates/triangle.cpp | {&Point::x, &Point::y}, {&Point::y, &Point::z}, {&Point::z, &Point::x}};
   code: src/predicates/triangle.cpp | if (edge_separates(onto, a, b) || edge_separates(onto, b, a)) { return false; } if (turn(onto, a) != 0) { return true; }
   code: src/predicates/triangle.cpp | return coplanar(a, b); *)
Definition flat_intersect a0 a1 a2 b0 b1 b2 : bool :=
  let onto u v later :=
    if edge_separates u v a0 a1 a2 b0 b1 b2 || edge_separates u v b0 b1 b2 a0 a1 a2 then false
    else if negb (turn u v a0 a1 a2 =? 0) then true else later in
  onto x y (onto y z (onto z x (coplanar a0 a1 a2 b0 b1 b2))).

Definition on_plane_of b0 b1 b2 a0 a1 a2 : Prop :=
  height b0 b1 b2 a0 = 0 /\ height b0 b1 b2 a1 = 0 /\ height b0 b1 b2 a2 = 0.

(* ============================================================== Theorems *)

Definition No_is_right := forall a0 a1 a2 b0 b1 b2, on_plane_of b0 b1 b2 a0 a1 a2 ->
  flat_intersect a0 a1 a2 b0 b1 b2 = false -> ~ meet a0 a1 a2 b0 b1 b2.

(* If one of the two has an area. *)
Definition Yes_is_right := forall a0 a1 a2 b0 b1 b2, on_plane_of b0 b1 b2 a0 a1 a2 -> on_plane_of a0 a1 a2 b0 b1 b2 ->
  ~ (no_area a0 a1 a2 /\ no_area b0 b1 b2) ->
  flat_intersect a0 a1 a2 b0 b1 b2 = true -> meet a0 a1 a2 b0 b1 b2.

(* ============================================================== Proofs *)

Definition axes (u v : Point -> Z) : Prop := (u = x /\ v = y) \/ (u = y /\ v = z) \/ (u = z /\ v = x).

(* An edge in a projection is a plane in space. *)
Lemma edge_plane u v p q : axes u v -> exists n, forall r, area u v p q r = dot n (sub r p).
Proof.
  intros [[-> ->] | [[-> ->] | [-> ->]]].
  - exists {| x := - (y q - y p); y := x q - x p; z := 0 |}. intros r. unfold area, dot, sub. cbn [x y z]. ring.
  - exists {| x := 0; y := - (z q - z p); z := y q - y p |}. intros r. unfold area, dot, sub. cbn [x y z]. ring.
  - exists {| x := z q - z p; y := 0; z := - (x q - x p) |}. intros r. unfold area, dot, sub. cbn [x y z]. ring.
Qed.

Lemma area_cycle u v p q r : area u v q r p = area u v p q r.
Proof. unfold area. ring. Qed.

Lemma beyond_apart u v p q r b0 b1 b2 : axes u v -> beyond u v (turn u v p q r) p q b0 b1 b2 = true ->
  ~ meet p q r b0 b1 b2.
Proof.
  intros X H M. destruct (edge_plane u v p q X) as (n & N).
  assert (area u v p q p = 0) as P by (unfold area; ring).
  assert (area u v p q q = 0) as Q by (unfold area; ring).
  unfold beyond, turn in H. cbv zeta in H.
  rewrite !andb_true_iff, !negb_true_iff, !Z.eqb_eq, !Z.eqb_neq in H.
  rewrite !N in H. rewrite N in P, Q. destruct H as [[[S0 S] S1] S2].
  destruct (Z.lt_trichotomy 0 (dot n (sub b0 p))) as [L | [E | L]]; [| rewrite <- E in S0; easy |].
  - apply (separates n p p q r b0 b1 b2 M); lia.
  - assert (forall w, dot (negated n) w = - dot n w) as D by (intros w; unfold dot, negated; cbn [x y z]; ring).
    apply (separates (negated n) p p q r b0 b1 b2 M); rewrite D; lia.
Qed.

Lemma edge_apart u v a0 a1 a2 b0 b1 b2 : axes u v -> edge_separates u v a0 a1 a2 b0 b1 b2 = true ->
  ~ meet a0 a1 a2 b0 b1 b2.
Proof.
  intros X H M. unfold edge_separates in H. cbv zeta in H. rewrite !orb_true_iff in H.
  destruct H as [[H | H] | H].
  - now apply (beyond_apart u v a0 a1 a2 b0 b1 b2).
  - unfold turn in H at 1. rewrite <- area_cycle in H.
    apply (beyond_apart u v a1 a2 a0 b0 b1 b2 X H). now apply meet_cycle.
  - unfold turn in H at 1. rewrite <- area_cycle, <- area_cycle in H.
    apply (beyond_apart u v a2 a0 a1 b0 b1 b2 X H). now apply meet_cycle, meet_cycle.
Qed.

Lemma turns_no_area a0 a1 a2 : turn x y a0 a1 a2 = 0 -> turn y z a0 a1 a2 = 0 -> turn z x a0 a1 a2 = 0 ->
  no_area a0 a1 a2.
Proof.
  unfold turn. intros X Y Z0. rewrite Z.sgn_null_iff in X, Y, Z0. unfold area in *.
  unfold no_area, normal, cross, sub. cbn [x y z]. auto.
Qed.

(* ---- Segments with a common point lie in one plane. *)

Definition origin_way w c p := {| x := x c - w * x p; y := y c - w * y p; z := z c - w * z p |}.
Lemma along_line a0 a1 a2 i j k c : no_area a0 a1 a2 -> mean i j k a0 a1 a2 c -> forall e, e = a1 \/ e = a2 ->
  let f := sub e a0 in let d := origin_way (i + j + k) c a0 in
  y f * z d - z f * y d = 0 /\ z f * x d - x f * z d = 0 /\ x f * y d - y f * x d = 0.
Proof.
  intros (N1 & N2 & N3) (X & Y & Z0) e E. unfold normal, cross, origin_way, sub in *. cbn [x y z] in *.
  rewrite <- X, <- Y, <- Z0.
  assert (forall f n, n = 0 -> f * n = 0) as Zero by (intros f n ->; ring).
  destruct E; subst e.
  - repeat split; [rewrite <- (Zero k _ N1) | rewrite <- (Zero k _ N2) | rewrite <- (Zero k _ N3)]; ring.
  - repeat split; [rewrite <- (Zero (- j) _ N1) | rewrite <- (Zero (- j) _ N2) | rewrite <- (Zero (- j) _ N3)]; ring.
Qed.

Lemma segments_meet_flat a0 a1 a2 b0 b1 b2 : no_area a0 a1 a2 -> no_area b0 b1 b2 -> meet a0 a1 a2 b0 b1 b2 ->
  coplanar a0 a1 a2 b0 b1 b2 = true.
Proof.
  intros NA NB (i & j & k & l & m & n & c & _ & _ & _ & _ & _ & _ & W & E & MA & MB).
  assert (forall e f, e = a1 \/ e = a2 -> f = b1 \/ f = b2 -> volume a0 e b0 f = 0) as V.
  { intros e f He Hf. destruct (along_line a0 a1 a2 i j k c NA MA e He) as (X & Y & Z0).
    destruct (along_line b0 b1 b2 l m n c NB MB f Hf) as (X' & Y' & Z'). rewrite <- E in *.
    set (w := i + j + k) in *. clearbody w. clear - W X Y Z0 X' Y' Z'.
    apply (Z.mul_reg_l _ _ w); [lia|]. rewrite Z.mul_0_r.
    unfold volume, cross, dot, origin_way, sub in *. cbn [x y z] in *.
    clear W. nsatz. }
  unfold coplanar. now rewrite !V by auto.
Qed.

(* A plane with area contains no three independent directions. *)
Lemma flat_is_coplanar n d e f : dot n d = 0 -> dot n e = 0 -> dot n f = 0 -> dot (cross d e) f <> 0 ->
  x n = 0 /\ y n = 0 /\ z n = 0.
Proof.
  intros D E F V.
  assert (forall c, c * dot (cross d e) f = 0 -> c = 0) as G by (intros c; nia).
  unfold dot, cross in *. cbn [x y z] in *.
  clear V. repeat split; apply G; nsatz.
Qed.

Lemma skew_no_area a0 a1 a2 b0 b1 b2 : on_plane_of b0 b1 b2 a0 a1 a2 -> coplanar a0 a1 a2 b0 b1 b2 = false ->
  no_area b0 b1 b2.
Proof.
  intros (H0 & H1 & H2) C. unfold height in *. unfold no_area. set (n := normal b0 b1 b2) in *.
  assert (forall e f, (e = a1 \/ e = a2) -> (f = b1 \/ f = b2) -> volume a0 e b0 f <> 0 ->
    x n = 0 /\ y n = 0 /\ z n = 0) as G.
  { intros e f He Hf V. apply (flat_is_coplanar n (sub f b0) (sub e a0) (sub b0 a0)); auto.
    - unfold n. destruct Hf; subst f; unfold normal, dot, cross, sub; cbn [x y z]; ring.
    - assert (dot n (sub e a0) = dot n (sub e b0) - dot n (sub a0 b0)) as -> by (unfold dot, sub; cbn [x y z]; ring).
      destruct He; subst e; lia.
    - assert (dot n (sub b0 a0) = - dot n (sub a0 b0)) as -> by (unfold dot, sub; cbn [x y z]; ring). lia. }
  unfold coplanar in C. rewrite !andb_false_iff, !Z.eqb_neq in C. destruct C as [[[C | C] | C] | C];
    [apply (G a1 b1) | apply (G a1 b2) | apply (G a2 b1) | apply (G a2 b2)]; auto.
Qed.

(* The properties of each answer. *)
Lemma flat_decides a0 a1 a2 b0 b1 b2 : let flat u v := turn u v a0 a1 a2 = 0 in
  let apart u v := edge_separates u v a0 a1 a2 b0 b1 b2 || edge_separates u v b0 b1 b2 a0 a1 a2 in
  if flat_intersect a0 a1 a2 b0 b1 b2 then (exists u v, axes u v /\ apart u v = false /\ ~ flat u v) \/
    coplanar a0 a1 a2 b0 b1 b2 = true /\ (forall u v, axes u v -> apart u v = false /\ flat u v)
  else (exists u v, axes u v /\ apart u v = true) \/
    coplanar a0 a1 a2 b0 b1 b2 = false /\ (forall u v, axes u v -> flat u v).
Proof.
  unfold flat_intersect, axes. cbv zeta.
  destruct (edge_separates x y _ _ _ _ _ _ || _) eqn:S0; [left; exists x, y; auto|].
  destruct (Z.eqb_spec (turn x y a0 a1 a2) 0); cbn [negb]; [|left; exists x, y; auto].
  destruct (edge_separates y z _ _ _ _ _ _ || _) eqn:S1; [left; exists y, z; auto|].
  destruct (Z.eqb_spec (turn y z a0 a1 a2) 0); cbn [negb]; [|left; exists y, z; auto 6].
  destruct (edge_separates z x _ _ _ _ _ _ || _) eqn:S2; [left; exists z, x; auto|].
  destruct (Z.eqb_spec (turn z x a0 a1 a2) 0); cbn [negb]; [|left; exists z, x; auto 6].
  destruct (coplanar _ _ _ _ _ _); right; split; auto; intros u v [[-> ->] | [[-> ->] | [-> ->]]]; auto.
Qed.

Theorem no_is_right : No_is_right.
Proof.
  intros a0 a1 a2 b0 b1 b2 H F M. pose proof (flat_decides a0 a1 a2 b0 b1 b2) as T. cbv zeta in T. rewrite F in T.
  destruct T as [(u & v & X & E) | [C T]].
  - apply orb_true_iff in E as [E | E]; apply edge_apart in E; auto. now apply meet_swap in M.
  - rewrite segments_meet_flat in C; [discriminate | | now apply (skew_no_area a0 a1 a2) | exact M].
    apply turns_no_area; apply T; unfold axes; auto.
Qed.

(* ---- A positive answer, in a projection. *)
Definition onto (u v : Point -> Z) p := {| x := u p; y := v p; z := 1 |}.
Lemma onto_corner u v p : corner (onto u v p).
Proof. reflexivity. Qed.
Lemma det_area u v p q r : det (onto u v p) (onto u v q) (onto u v r) = area u v p q r.
Proof. unfold det, dot, cross, onto, area. cbn [x y z]. ring. Qed.

Ltac signs := repeat match goal with |- context [Z.sgn ?t] =>
  let E := fresh in destruct (Z.sgn_spec t) as [[? E] | [[? E] | [? E]]]; rewrite E in *; clear E end.

Lemma not_beyond u v s p q b0 b1 b2 : s = 1 \/ s = -1 -> beyond u v s p q b0 b1 b2 = false ->
  some_inner s (onto u v p) (onto u v q) (onto u v b0) (onto u v b1) (onto u v b2).
Proof.
  unfold beyond, turn, some_inner, inner. rewrite !det_area. cbv zeta.
  generalize (area u v p q b0) (area u v p q b1) (area u v p q b2). intros c d e [-> | ->]; signs; intros H; cbn in H;
    try discriminate; lia.
Qed.
Lemma no_edge_of u v a0 a1 a2 b0 b1 b2 : area u v a0 a1 a2 <> 0 -> edge_separates u v a0 a1 a2 b0 b1 b2 = false ->
  no_edge (onto u v a0) (onto u v a1) (onto u v a2) (onto u v b0) (onto u v b1) (onto u v b2).
Proof.
  intros A H. unfold edge_separates, turn in H. cbv zeta in H. rewrite !orb_false_iff in H.
  unfold no_edge. rewrite det_area. destruct H as [[H0 H1] H2].
  assert (Z.sgn (area u v a0 a1 a2) = 1 \/ Z.sgn (area u v a0 a1 a2) = -1) as S
    by (destruct (Z.sgn_spec (area u v a0 a1 a2)) as [[_ ->] | [[E _] | [_ ->]]]; auto; now symmetry in E).
  cbv zeta. auto using not_beyond.
Qed.
Lemma beside_line u v p q a0 a1 a2 : beyond u v 0 p q a0 a1 a2 = false ->
  crossed (cross (onto u v p) (onto u v q)) (onto u v a0) (onto u v a1) (onto u v a2).
Proof.
  assert (forall r, dot (cross (onto u v p) (onto u v q)) (onto u v r) = area u v p q r) as D by (intros; apply det_area).
  unfold beyond, turn, crossed. rewrite !D. cbv zeta. clear D.
  generalize (area u v p q a0) (area u v p q a1) (area u v p q a2). intros c d e; signs; intros H; cbn in H;
    try discriminate; lia.
Qed.

(* ---- A plane that contains no projection's axis: triangles that meet in the projection meet. *)
Definition faces u v n := (u = x /\ v = y /\ z n <> 0) \/ (u = y /\ v = z /\ x n <> 0) \/ (u = z /\ v = x /\ y n <> 0).
Definition in_plane n o p := dot n (sub p o) = 0.

Lemma lift u v n o a0 a1 a2 b0 b1 b2 : faces u v n ->
  in_plane n o a0 -> in_plane n o a1 -> in_plane n o a2 -> in_plane n o b0 -> in_plane n o b1 -> in_plane n o b2 ->
  meet (onto u v a0) (onto u v a1) (onto u v a2) (onto u v b0) (onto u v b1) (onto u v b2) -> meet a0 a1 a2 b0 b1 b2.
Proof.
  intros F P0 P1 P2 Q0 Q1 Q2 (i & j & k & l & m & n' & c & I & J & K & L & M & N & W & E & (X1 & Y1 & _) & (X2 & Y2 & _)).
  rewrite <- X2 in X1. rewrite <- Y2 in Y1. clear X2 Y2 c. unfold onto in *. cbn [x y z] in *.
  unfold in_plane, dot, sub in *. cbn [x y z] in *.
  assert (x n * (i * x a0 + j * x a1 + k * x a2 - (l * x b0 + m * x b1 + n' * x b2)) +
    y n * (i * y a0 + j * y a1 + k * y a2 - (l * y b0 + m * y b1 + n' * y b2)) +
    z n * (i * z a0 + j * z a1 + k * z a2 - (l * z b0 + m * z b1 + n' * z b2)) = 0) as S.
  { clear - P0 P1 P2 Q0 Q1 Q2 E. nsatz. }
  assert (forall a b, a <> 0 -> a * b = 0 -> b = 0) as Cancel by (intros a b A B; apply Z.mul_eq_0 in B; tauto).
  exists i, j, k, l, m, n', {| x := l * x b0 + m * x b1 + n' * x b2; y := l * y b0 + m * y b1 + n' * y b2;
    z := l * z b0 + m * z b1 + n' * z b2 |}.
  do 8 (split; [assumption|]). split; [|repeat split]. unfold mean. cbn [x y z].
  destruct F as [(-> & -> & F) | [(-> & -> & F) | (-> & -> & F)]]; rewrite X1, Y1, !Z.sub_diag, !Z.mul_0_r in S;
    cbn [Z.add] in S; rewrite ?Z.add_0_r in S; apply (Cancel _ _ F) in S; repeat split; lia.
Qed.

Lemma area_faces u v p q r : axes u v -> area u v p q r <> 0 -> faces u v (normal p q r).
Proof.
  unfold faces, area, normal, cross, sub. cbn [x y z]. intros [[-> ->] | [[-> ->] | [-> ->]]] A; auto.
Qed.

Lemma onto_eq u v p q : u p = u q -> v p = v q -> onto u v p = onto u v q.
Proof. unfold onto. now intros -> ->. Qed.
Lemma line_of u v p q : u p <> u q \/ v p <> v q ->
  let n := cross (onto u v p) (onto u v q) in x n <> 0 \/ y n <> 0.
Proof. unfold cross, onto. cbn [x y z]. lia. Qed.

Theorem area_yes u v a0 a1 a2 b0 b1 b2 : axes u v -> area u v a0 a1 a2 <> 0 -> on_plane_of a0 a1 a2 b0 b1 b2 ->
  edge_separates u v a0 a1 a2 b0 b1 b2 = false -> edge_separates u v b0 b1 b2 a0 a1 a2 = false ->
  meet a0 a1 a2 b0 b1 b2.
Proof.
  intros X A (H0 & H1 & H2) E F.
  apply (lift u v (normal a0 a1 a2) a0); auto using area_faces;
    try (unfold in_plane, normal, cross, dot, sub; cbn [x y z]; ring).
  pose proof (no_edge_of u v _ _ _ _ _ _ A E) as NE.
  assert (det (onto u v a0) (onto u v a1) (onto u v a2) <> 0) as DA by now rewrite det_area.
  destruct (Z.eq_dec (area u v b0 b1 b2) 0) as [B | B].
  2:{ apply areas_meet; auto using onto_corner, no_edge_of. now rewrite det_area. }
  unfold edge_separates, turn in F. cbv zeta in F. rewrite B, !orb_false_iff in F. cbn [Z.sgn] in F.
  destruct F as [[F0 F1] F2]. apply beside_line in F0, F1, F2.
  assert (forall p q, dot (cross p q) p = 0 /\ dot (cross p q) q = 0) as Own
    by (intros; unfold dot, cross; cbn [x y z]; split; ring).
  destruct (Z.eq_dec (u b0) (u b1)) as [U | U]; [destruct (Z.eq_dec (v b0) (v b1)) as [V | V]|].
  2, 3: apply (line_meets (cross (onto u v b0) (onto u v b1))); auto using onto_corner, line_of; try apply Own;
    change (det (onto u v b0) (onto u v b1) (onto u v b2) = 0); now rewrite det_area.
  destruct (Z.eq_dec (u b1) (u b2)) as [U' | U']; [destruct (Z.eq_dec (v b1) (v b2)) as [V' | V']|].
  2, 3: apply (line_meets (cross (onto u v b1) (onto u v b2))); auto using onto_corner, line_of; try apply Own;
    change (det (onto u v b1) (onto u v b2) (onto u v b0) = 0); now rewrite det_area, area_cycle.
  rewrite <- (onto_eq u v b1 b2 U' V'), <- (onto_eq u v b0 b1 U V) in *.
  apply point_meets; auto using onto_corner.
Qed.

Lemma has_area a0 a1 a2 : no_area a0 a1 a2 \/ exists u v, axes u v /\ area u v a0 a1 a2 <> 0.
Proof.
  unfold axes. destruct (Z.eq_dec (area x y a0 a1 a2) 0) as [X | X]; [|right; exists x, y; auto].
  destruct (Z.eq_dec (area y z a0 a1 a2) 0) as [Y | Y]; [|right; exists y, z; auto].
  destruct (Z.eq_dec (area z x a0 a1 a2) 0) as [Z0 | Z0]; [|right; exists z, x; auto].
  left. apply turns_no_area; unfold turn; now rewrite ?X, ?Y, ?Z0.
Qed.

Lemma no_area_flat u v a0 a1 a2 : axes u v -> no_area a0 a1 a2 -> area u v a0 a1 a2 = 0.
Proof.
  unfold no_area, normal, cross, sub, area. cbn [x y z]. intros [[-> ->] | [[-> ->] | [-> ->]]]; tauto.
Qed.

Theorem yes_is_right : Yes_is_right.
Proof.
  intros a0 a1 a2 b0 b1 b2 PA PB Some_ F. pose proof (flat_decides a0 a1 a2 b0 b1 b2) as T. cbv zeta in T.
  rewrite F in T.
  destruct T as [(u & v & X & E & A) | [_ T]].
  - apply orb_false_iff in E as [S S']. apply (area_yes u v); auto. intros A'. apply A. unfold turn. now rewrite A'.
  - assert (no_area a0 a1 a2) as NA by (apply turns_no_area; apply T; unfold axes; auto).
    destruct (has_area b0 b1 b2) as [NB | (u & v & X & B)]; [tauto|]. destruct (T u v X) as [E _].
    apply orb_false_iff in E as [S S']. now apply meet_swap, (area_yes u v).
Qed.

Print Assumptions yes_is_right.
