(* The whole of triangles_intersect() in lib/src/predicates/triangle.cpp, combined from its cases: it returns true
   exactly if the triangles have a common point, for all triangles. *)
From Coq Require Import ZArith Lia Bool.
Require Import Triangle Segment Flat Lines.
Local Open Scope Z_scope.

(* The values of Upper: kSeparated is kAllCorners, and no corner is above if all lie on the plane.
   code: src/predicates/triangle.cpp | constexpr Upper kSeparated = kAllCorners; *)
Definition separate g0 g1 g2 : bool :=
  (0 <? g0) && (0 <? g1) && (0 <? g2) || (g0 <? 0) && (g1 <? 0) && (g2 <? 0).
Definition all_on_plane g0 g1 g2 : bool := (g0 =? 0) && (g1 =? 0) && (g2 =? 0).

(* code: src/predicates/triangle.cpp | const Point& from = corner_at(segment, fan.tip); const Point& to = corner_at(segment, fan.others[1]);
   code: src/predicates/triangle.cpp | if (of_a != 0) { return segment_intersects(a, of_a, b); } return of_b == 0 ? flat_intersect(a, b) : segment_intersects(b, of_b, a);
   code: src/predicates/triangle.cpp | if (of_a == 0 || of_b == 0) { return flat_or_segment_intersect(a, b, of_a, of_b); } *)
Definition segment_case a0 a1 a2 t0 t1 t2 : bool :=
  let h := height t0 t1 t2 in
  let '(s0, s1, _) := from (fst (tip_of (h a0) (h a1) (h a2))) a0 a1 a2 in segment_intersects s0 s1 t0 t1 t2.
Definition intersect a0 a1 a2 b0 b1 b2 : bool :=
  let of f (g : Z -> Z -> Z -> bool) p q r := g (f p) (f q) (f r) in
  let above_b := height b0 b1 b2 in let above_a := height a0 a1 a2 in
  if of above_b separate a0 a1 a2 || of above_a separate b0 b1 b2 then false
  else if of above_b all_on_plane a0 a1 a2 then
    if of above_a all_on_plane b0 b1 b2 then flat_intersect a0 a1 a2 b0 b1 b2
    else segment_case b0 b1 b2 a0 a1 a2
  else if of above_a all_on_plane b0 b1 b2 then segment_case a0 a1 a2 b0 b1 b2
  else intervals_overlap a0 a1 a2 b0 b1 b2.

Definition overlap_along (c : Point -> Z) a0 a1 a2 b0 b1 b2 : bool :=
  let least p q r := Z.min (c p) (Z.min (c q) (c r)) in let most p q r := Z.max (c p) (Z.max (c q) (c r)) in
  (least a0 a1 a2 <=? most b0 b1 b2) && (least b0 b1 b2 <=? most a0 a1 a2).
Definition boxes_overlap a0 a1 a2 b0 b1 b2 : bool := overlap_along x a0 a1 a2 b0 b1 b2 &&
  overlap_along y a0 a1 a2 b0 b1 b2 && overlap_along z a0 a1 a2 b0 b1 b2.

(* Without B's current normal, and with it: in the second case boxes are compared late.
   code: src/predicates/triangle.cpp | return boxes_overlap(a, b) && intersect(/*narrow=*/false, a, b);
   code: src/predicates/triangle.cpp | if (of_a == 0 || of_b == 0) { return boxes_overlap(a, b) && flat_or_segment_intersect(a, b, of_a, of_b); } *)
Definition triangles_intersect a0 a1 a2 b0 b1 b2 : bool :=
  boxes_overlap a0 a1 a2 b0 b1 b2 && intersect a0 a1 a2 b0 b1 b2.
Definition near_triangles_intersect a0 a1 a2 b0 b1 b2 : bool :=
  let on p q r s t o := all_on_plane (height p q r s) (height p q r t) (height p q r o) in
  if (on b0 b1 b2 a0 a1 a2 || on a0 a1 a2 b0 b1 b2) && negb (boxes_overlap a0 a1 a2 b0 b1 b2) then false
  else intersect a0 a1 a2 b0 b1 b2.

Definition Test_is_exact := forall a0 a1 a2 b0 b1 b2,
  (triangles_intersect a0 a1 a2 b0 b1 b2 = true <-> meet a0 a1 a2 b0 b1 b2) /\
  (near_triangles_intersect a0 a1 a2 b0 b1 b2 = true <-> meet a0 a1 a2 b0 b1 b2).

(* ---- Proof. *)

Lemma overlap_spec a0 a1 a2 b0 b1 b2 : boxes_overlap a0 a1 a2 b0 b1 b2 = true <-> ~ boxes_apart a0 a1 a2 b0 b1 b2.
Proof.
  unfold boxes_overlap, overlap_along, boxes_apart, apart_along. rewrite !andb_true_iff, !Z.leb_le. lia.
Qed.
Lemma boxes_hold a0 a1 a2 b0 b1 b2 : meet a0 a1 a2 b0 b1 b2 -> boxes_overlap a0 a1 a2 b0 b1 b2 = true.
Proof.
  intros M. apply overlap_spec.
  assert (forall n p q r s t o (c : Point -> Z), (forall p q, dot n (sub p q) = c p - c q) -> meet p q r s t o ->
    Z.max (c p) (Z.max (c q) (c r)) < Z.min (c s) (Z.min (c t) (c o)) -> False) as G.
  { intros n p q r s t o c N K L. destruct (extremes c p q r) as (_ & u & _ & _ & _ & E & _).
    apply (separates n u p q r s t o K); rewrite N; lia. }
  pose proof (meet_swap _ _ _ _ _ _ M) as S.
  intros [[A | A] | [[A | A] | [A | A]]].
  1, 2: revert A; apply (G {| x := 1; y := 0; z := 0 |}); auto; intros; unfold dot, sub; cbn [x y z]; ring.
  1, 2: revert A; apply (G {| x := 0; y := 1; z := 0 |}); auto; intros; unfold dot, sub; cbn [x y z]; ring.
  1, 2: revert A; apply (G {| x := 0; y := 0; z := 1 |}); auto; intros; unfold dot, sub; cbn [x y z]; ring.
Qed.

Lemma separate_no_meet a0 a1 a2 b0 b1 b2 : let h := height b0 b1 b2 in
  separate (h a0) (h a1) (h a2) = true -> ~ meet a0 a1 a2 b0 b1 b2.
Proof.
  unfold separate. rewrite orb_true_iff, !andb_true_iff, !Z.ltb_lt. unfold height. intros H M. apply meet_swap in M.
  assert (dot (normal b0 b1 b2) (sub b0 b0) = 0 /\ dot (normal b0 b1 b2) (sub b1 b0) = 0 /\
    dot (normal b0 b1 b2) (sub b2 b0) = 0) as (E0 & E1 & E2)
    by (unfold normal, dot, cross, sub; cbn [x y z]; repeat split; ring).
  assert (forall w, dot (negated (normal b0 b1 b2)) w = - dot (normal b0 b1 b2) w) as D
    by (intros w; unfold dot, negated; cbn [x y z]; ring).
  destruct H as [H | H].
  - apply (separates (normal b0 b1 b2) b0 b0 b1 b2 a0 a1 a2 M); lia.
  - apply (separates (negated (normal b0 b1 b2)) b0 b0 b1 b2 a0 a1 a2 M); rewrite D; lia.
Qed.

Lemma crosses_or g0 g1 g2 : separate g0 g1 g2 = false -> all_on_plane g0 g1 g2 = false -> crosses g0 g1 g2.
Proof.
  unfold separate, all_on_plane, crosses. rewrite orb_false_iff, !andb_false_iff, !Z.ltb_ge, !Z.eqb_neq. lia.
Qed.
Lemma all_on g0 g1 g2 : all_on_plane g0 g1 g2 = true <-> g0 = 0 /\ g1 = 0 /\ g2 = 0.
Proof. unfold all_on_plane. rewrite !andb_true_iff, !Z.eqb_eq. tauto. Qed.

(* A triangle whose plane contains the other one, but which does not lie in the other's plane, has no area. *)
Lemma is_segment a0 a1 a2 b0 b1 b2 : on_plane_of a0 a1 a2 b0 b1 b2 -> let h := height b0 b1 b2 in
  all_on_plane (h a0) (h a1) (h a2) = false -> no_area a0 a1 a2.
Proof.
  intros (H0 & H1 & H2) h. unfold height in *. unfold all_on_plane, no_area.
  rewrite !andb_false_iff, !Z.eqb_neq. set (n := normal a0 a1 a2) in *.
  assert (forall p q, dot n (sub p q) = dot n (sub p a0) - dot n (sub q a0)) as S
    by (intros; unfold dot, sub; cbn [x y z]; ring).
  assert (dot n (sub a0 a0) = 0 /\ dot n (sub a1 a0) = 0 /\ dot n (sub a2 a0) = 0) as (E0 & E1 & E2)
    by (unfold n, normal, dot, cross, sub; cbn [x y z]; repeat split; ring).
  intros [[V | V] | V]; apply (flat_is_coplanar n (sub b1 b0) (sub b2 b0)) in V; auto; rewrite S; lia.
Qed.

Lemma no_area_cycle p q r : no_area p q r -> no_area q r p.
Proof. unfold no_area, normal, cross, sub. cbn [x y z]. lia. Qed.

Lemma segment_case_is_exact a0 a1 a2 t0 t1 t2 : no_area a0 a1 a2 -> let h := height t0 t1 t2 in
  crosses (h a0) (h a1) (h a2) -> (segment_case a0 a1 a2 t0 t1 t2 = true <-> meet a0 a1 a2 t0 t1 t2).
Proof.
  intros N h C. unfold segment_case. cbv zeta. fold h. apply tip_of_is_tip in C.
  destruct (tip_of (h a0) (h a1) (h a2)) as [c up]. cbn [fst].
  pose proof (from_same c a0 a1 a2) as F. assert (let '(u, v, w) := from c a0 a1 a2 in no_area u v w) as NF
    by (destruct c as [|[|c]]; cbn [from]; auto using no_area_cycle).
  destruct (from c a0 a1 a2) as [[s0 s1] s2]. destruct F as (_ & M & S). rewrite (S h) in C.
  rewrite <- M. apply segment_is_exact; [exact NF|]. fold h. destruct up; auto.
Qed.

Lemma intersect_is_exact a0 a1 a2 b0 b1 b2 :
  (on_plane_of b0 b1 b2 a0 a1 a2 -> on_plane_of a0 a1 a2 b0 b1 b2 -> boxes_overlap a0 a1 a2 b0 b1 b2 = true) ->
  (intersect a0 a1 a2 b0 b1 b2 = true <-> meet a0 a1 a2 b0 b1 b2).
Proof.
  intros Boxes. unfold intersect. cbv zeta beta.
  destruct (separate (height b0 b1 b2 a0) _ _) eqn:SA; cbn [orb].
  { split; [easy|]. intros M. now apply separate_no_meet in SA. }
  destruct (separate (height a0 a1 a2 b0) _ _) eqn:SB; cbn [orb].
  { split; [easy|]. intros M. apply meet_swap in M. now apply separate_no_meet in SB. }
  destruct (all_on_plane (height b0 b1 b2 a0) _ _) eqn:OA, (all_on_plane (height a0 a1 a2 b0) _ _) eqn:OB.
  - apply all_on in OA, OB. specialize (Boxes OA OB). apply overlap_spec in Boxes. split.
    + intros F. destruct (has_area a0 a1 a2) as [NA | (u & v & X & E)]; [destruct (has_area b0 b1 b2) as [NB | (u & v & X & E)]|].
      * now apply segments_are_exact.
      * apply yes_is_right; auto. intros [_ N]. now apply (no_area_flat u v) in N.
      * apply yes_is_right; auto. intros [N _]. now apply (no_area_flat u v) in N.
    + intros M. destruct (flat_intersect a0 a1 a2 b0 b1 b2) eqn:F; auto. now apply no_is_right in F.
  - assert (no_area b0 b1 b2) as N by (apply (is_segment b0 b1 b2 a0 a1 a2); auto; now apply all_on in OA).
    rewrite segment_case_is_exact; auto using crosses_or. split; apply meet_swap.
  - assert (no_area a0 a1 a2) as N by (apply (is_segment a0 a1 a2 b0 b1 b2); auto; now apply all_on in OB).
    apply segment_case_is_exact; auto using crosses_or.
  - apply general_case_is_exact; auto using crosses_or.
Qed.

Theorem test_is_exact : Test_is_exact.
Proof.
  intros a0 a1 a2 b0 b1 b2. unfold triangles_intersect, near_triangles_intersect. cbv zeta.
  pose proof (boxes_hold a0 a1 a2 b0 b1 b2) as H. destruct (boxes_overlap a0 a1 a2 b0 b1 b2) eqn:B; cbn [andb negb].
  - rewrite andb_false_r. split; apply intersect_is_exact; auto.
  - split; [split; [easy | intros M; now apply H in M]|]. rewrite andb_true_r.
    destruct (all_on_plane (height b0 b1 b2 a0) _ _) eqn:OA; cbn [orb].
    + split; [easy | intros M; now apply H in M].
    + destruct (all_on_plane (height a0 a1 a2 b0) _ _) eqn:OB; [split; [easy | intros M; now apply H in M]|].
      apply intersect_is_exact. intros P. apply all_on in P. congruence.
Qed.

Print Assumptions test_is_exact.
