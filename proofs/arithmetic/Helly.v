(* Separating axes in the plane: triangles that no edge separates have a common point, by Helly's theorem, which
   requires common points of only three convex sets at a time.

   A point of the plane is a ray of space: (x, y, z) with z > 0 stands for (x / z, y / z), and corners have z = 1.
   A convex set of the plane is a cone there, and the determinant of three corners is twice their area. *)
From Coq Require Import ZArith Lia Psatz Bool Nsatz.
Require Import Triangle.
Local Open Scope Z_scope.

Definition mix i p j q :=
  {| x := i * x p + j * x q; y := i * y p + j * y q; z := i * z p + j * z q |}.
Definition cone (C : Point -> Prop) := forall i j p q, 0 <= i -> 0 <= j -> C p -> C q -> C (mix i p j q).
Definition both (C D : Point -> Prop) p := C p /\ D p.
Definition somewhere (C : Point -> Prop) := exists p, 0 < z p /\ C p.
Definition det p q r := dot (cross p q) r.

(* ============================================================== Statements *)

Definition Helly := forall C D E F, cone C -> cone D -> cone E -> cone F ->
  somewhere (both C (both D E)) -> somewhere (both C (both D F)) ->
  somewhere (both C (both E F)) -> somewhere (both D (both E F)) -> somewhere (both (both C D) (both E F)).

(* On one line, on which n is 0, two sets at a time. *)
Definition Helly_on_line := forall n C D E, x n <> 0 \/ y n <> 0 -> cone C -> cone D -> cone E ->
  let on p := dot n p = 0 in
  somewhere (both on (both C D)) -> somewhere (both on (both C E)) -> somewhere (both on (both D E)) ->
  somewhere (both on (both C (both D E))).

(* ============================================================== Proofs *)

Lemma point_eq p q : x p = x q -> y p = y q -> z p = z q -> p = q.
Proof. destruct p, q. cbn. now intros -> -> ->. Qed.
Lemma cone_both C D : cone C -> cone D -> cone (both C D).
Proof. intros K L i j p q I J [] []. split; [apply K | apply L]; auto. Qed.
Definition sum3 i p j q k r := mix 1 (mix i p j q) k r.

(* ---- More vectors than dimensions are linearly dependent. *)
Lemma depend1 a b : exists s t, (s <> 0 \/ t <> 0) /\ s * a + t * b = 0.
Proof.
  destruct (Z.eq_dec a 0) as [-> | A]; [exists 1, 0; split; [now left | ring]|].
  exists (- b), a. split; [now right | ring].
Qed.
Lemma depend2 a a' b b' c c' : exists i j k, (i <> 0 \/ j <> 0 \/ k <> 0) /\
  i * a + j * b + k * c = 0 /\ i * a' + j * b' + k * c' = 0.
Proof.
  assert (forall a a' b b' c c', a <> 0 -> exists i j k, (i <> 0 \/ j <> 0 \/ k <> 0) /\
    i * a + j * b + k * c = 0 /\ i * a' + j * b' + k * c' = 0) as G.
  { clear. intros a a' b b' c c' A. destruct (depend1 (a * b' - b * a') (a * c' - c * a')) as (s & t & N & E).
    exists (- (s * b + t * c)), (s * a), (t * a). split; [right; destruct N; [left | right]; now apply Z.neq_mul_0|]. split; [ring|].
    rewrite <- E. ring. }
  destruct (Z.eq_dec a 0) as [-> | A]; [|now apply G].
  destruct (Z.eq_dec b 0) as [-> | B]; [|destruct (G b b' 0 a' c c' B) as (j & i & k & N & E & F); exists i, j, k; lia].
  destruct (Z.eq_dec c 0) as [-> | C]; [|destruct (G c c' 0 a' 0 b' C) as (k & i & j & N & E & F); exists i, j, k; lia].
  destruct (depend1 a' b') as (s & t & N & E). exists s, t, 0. lia.
Qed.
Lemma depend3 p q r s : exists i j k l, (i <> 0 \/ j <> 0 \/ k <> 0 \/ l <> 0) /\
  i * x p + j * x q + k * x r + l * x s = 0 /\ i * y p + j * y q + k * y r + l * y s = 0 /\
  i * z p + j * z q + k * z r + l * z s = 0.
Proof.
  assert (forall p q r s, x p <> 0 -> exists i j k l, (i <> 0 \/ j <> 0 \/ k <> 0 \/ l <> 0) /\
    i * x p + j * x q + k * x r + l * x s = 0 /\ i * y p + j * y q + k * y r + l * y s = 0 /\
    i * z p + j * z q + k * z r + l * z s = 0) as G.
  { clear. intros p q r s P. destruct (depend2 (x p * y q - x q * y p) (x p * z q - x q * z p)
      (x p * y r - x r * y p) (x p * z r - x r * z p) (x p * y s - x s * y p) (x p * z s - x s * z p))
      as (j & k & l & N & E & F).
    exists (- (j * x q + k * x r + l * x s)), (j * x p), (k * x p), (l * x p).
    split; [right; destruct N as [N | [N | N]]; [left | right; left | right; right]; now apply Z.neq_mul_0|].
    split; [ring|].
    split; [rewrite <- E | rewrite <- F]; ring. }
  destruct (Z.eq_dec (x p) 0) as [P | P]; [|now apply G].
  destruct (Z.eq_dec (x q) 0) as [Q | Q];
    [|destruct (G q p r s Q) as (j & i & k & l & N & H); exists i, j, k, l; lia].
  destruct (Z.eq_dec (x r) 0) as [R | R];
    [|destruct (G r p q s R) as (k & i & j & l & N & H); exists i, j, k, l; lia].
  destruct (Z.eq_dec (x s) 0) as [S | S];
    [|destruct (G s p q r S) as (l & i & j & k & N & H); exists i, j, k, l; lia].
  destruct (depend2 (y p) (z p) (y q) (z q) (y r) (z r)) as (i & j & k & N & E & F).
  exists i, j, k, 0. rewrite P, Q, R, S. lia.
Qed.

(* ---- Radon: of dependent points, some have a mean that is also a mean of the others. *)
Definition pos i := Z.max i 0.
Definition sum4 i p j q k r l s := mix 1 (mix i p j q) 1 (mix k r l s).
Lemma cone_sum4 C i p j q k r l s : cone C -> 0 <= i -> 0 <= j -> 0 <= k -> 0 <= l ->
  i = 0 \/ C p -> j = 0 \/ C q -> k = 0 \/ C r -> l = 0 \/ C s -> 0 < z (sum4 i p j q k r l s) -> C (sum4 i p j q k r l s).
Proof.
  intros K I J L M P Q R S U. set (o := {| x := 0; y := 0; z := 0 |}).
  (* With the origin, which is an empty sum. *)
  assert (forall i p j q, 0 <= i -> 0 <= j -> i = 0 \/ p = o \/ C p -> j = 0 \/ q = o \/ C q ->
    mix i p j q = o \/ C (mix i p j q)) as G.
  { clear - K. intros i p j q I J.
    assert (forall i p, 0 <= i -> C p -> C (mix i p 0 p)) as One by (intros; apply K; auto; lia).
    intros [-> | [-> | P]] [-> | [-> | Q]]; try (right; now apply K); try (left; apply point_eq; cbn; ring).
    all: right; match goal with P : ?D ?p |- ?D (mix ?i ?p _ _) => replace (mix i p _ _) with (mix i p 0 p) |
      Q : ?D ?q |- ?D (mix _ _ ?j ?q) => replace (mix _ _ j q) with (mix j q 0 q) end; auto; apply point_eq; cbn; ring. }
  destruct (G 1 (mix i p j q) 1 (mix k r l s)) as [E | E]; auto; try lia; try (right; apply G; tauto).
  unfold sum4 in U. rewrite E in U. now cbn in U.
Qed.

Lemma radon p q r s i j k l : 0 < z p -> 0 < z q -> 0 < z r -> 0 < z s -> i <> 0 \/ j <> 0 \/ k <> 0 \/ l <> 0 ->
  i * x p + j * x q + k * x r + l * x s = 0 -> i * y p + j * y q + k * y r + l * y s = 0 ->
  i * z p + j * z q + k * z r + l * z s = 0 ->
  exists t, 0 < z t /\ (forall n, dot n p = 0 -> dot n q = 0 -> dot n r = 0 -> dot n s = 0 -> dot n t = 0) /\
  forall C, cone C -> C p /\ C q /\ C r \/ (l = 0 \/ C s) /\ (C q /\ C r \/ C p /\ C r \/ C p /\ C q) -> C t.
Proof.
  intros Zp Zq Zr Zs N X Y Z0.
  set (above := sum4 (pos i) p (pos j) q (pos k) r (pos l) s).
  set (below := sum4 (pos (- i)) p (pos (- j)) q (pos (- k)) r (pos (- l)) s).
  assert (forall n t, n * t = pos n * t - pos (- n) * t) as Split
    by (intros n t; rewrite <- Z.mul_sub_distr_r; f_equal; unfold pos; lia).
  rewrite (Split i), (Split j), (Split k), (Split l) in X, Y, Z0.
  assert (above = below) as E0 by (apply point_eq; unfold above, below, sum4, mix; cbn [x y z]; lia).
  assert (0 < z above) as Up.
  { assert (z above + z below = Z.abs i * z p + Z.abs j * z q + Z.abs k * z r + Z.abs l * z s) as Sum.
    { unfold above, below, sum4, mix. cbn [x y z].
      assert (forall n, Z.abs n = pos n + pos (- n)) as A by (intros; unfold pos; lia). rewrite !A. ring. }
    rewrite <- E0 in Sum.
    assert (forall n t, 0 < t -> 0 <= Z.abs n * t /\ (n <> 0 -> 0 < Z.abs n * t)) as Share
      by (clear; intros n t T; split; intros; [apply Z.mul_nonneg_nonneg | apply Z.mul_pos_pos]; lia).
    pose proof (Share i _ Zp). pose proof (Share j _ Zq). pose proof (Share k _ Zr). pose proof (Share l _ Zs).
    clear - Sum N H H0 H1 H2. lia. }
  exists above. split; [exact Up|]. split.
  - intros n P Q R S. transitivity (pos i * dot n p + pos j * dot n q + pos k * dot n r + pos l * dot n s);
      [unfold dot, above, sum4, mix; cbn [x y z]; ring | rewrite P, Q, R, S; ring].
  - (* With weight 0 for one point, in the set that need not contain it. *)
    assert (forall n, 0 <= pos n) as Pos by (intros; unfold pos; lia).
    assert (forall n, n = 0 -> pos n = 0 /\ pos (- n) = 0) as Zero by (intros; unfold pos; lia).
    assert (forall n, pos n = 0 \/ pos (- n) = 0) as One by (intros; unfold pos; lia).
    assert (forall n (P : Prop), n = 0 \/ P -> (pos n = 0 \/ P) /\ (pos (- n) = 0 \/ P)) as Or
      by (intros n P [E | E]; [destruct (Zero n E) |]; tauto).
    intros C K [(P & Q & R) | (S & H)]; [|apply Or in S as [S S']; destruct H as [(Q & R) | [(P & R) | (P & Q)]]];
      [destruct (One l) | destruct (One i) | destruct (One j) | destruct (One k)]; [idtac | rewrite E0 | idtac |
      rewrite E0 | idtac | rewrite E0 | idtac | rewrite E0];
      apply cone_sum4; auto; change (0 < z below); now rewrite <- E0.
Qed.

Theorem helly : Helly.
Proof.
  intros C D E F KC KD KE KF (s & Zs & sC & sD & sE) (r & Zr & rC & rD & rF) (q & Zq & qC & qE & qF) (p & Zp & pD & pE & pF).
  destruct (depend3 p q r s) as (i & j & k & l & N & X & Y & Z0).
  destruct (radon p q r s i j k l) as (t & Zt & _ & H); auto. exists t. split; [exact Zt|]. repeat split; apply H; tauto.
Qed.

Lemma depend_on_line n p q r : x n <> 0 \/ y n <> 0 -> dot n p = 0 -> dot n q = 0 -> dot n r = 0 ->
  exists i j k, (i <> 0 \/ j <> 0 \/ k <> 0) /\ i * x p + j * x q + k * x r = 0 /\
    i * y p + j * y q + k * y r = 0 /\ i * z p + j * z q + k * z r = 0.
Proof.
  unfold dot. intros N P Q R.
  assert (forall a b, a <> 0 -> a * b = 0 -> b = 0) as Cancel by (intros a b A E; apply Z.mul_eq_0 in E; tauto).
  destruct (Z.eq_dec (x n) 0) as [X | X].
  - destruct (depend2 (x p) (z p) (x q) (z q) (x r) (z r)) as (i & j & k & M & E & F).
    exists i, j, k. repeat split; auto. apply (Cancel (y n)); [lia|].
    clear - P Q R E F. nsatz.
  - destruct (depend2 (y p) (z p) (y q) (z q) (y r) (z r)) as (i & j & k & M & E & F).
    exists i, j, k. repeat split; auto. apply (Cancel (x n)); [exact X|].
    clear - P Q R E F. nsatz.
Qed.

Theorem helly_on_line : Helly_on_line.
Proof.
  intros n C D E N KC KD KE on (r & Zr & rO & rC & rD) (q & Zq & qO & qC & qE) (p & Zp & pO & pD & pE).
  destruct (depend_on_line n p q r N pO qO rO) as (i & j & k & M & X & Y & Z0).
  destruct (radon p q r p i j k 0) as (t & Zt & O & H); auto; try lia.
  exists t. split; [exact Zt|]. split; [now apply O|]. repeat split; apply H; tauto.
Qed.

(* ---- Triangles in the plane. *)
Definition hull a0 a1 a2 p := exists i j k, 0 <= i /\ 0 <= j /\ 0 <= k /\ p = sum3 i a0 j a1 k a2.
Lemma cone_hull a0 a1 a2 : cone (hull a0 a1 a2).
Proof.
  intros m n p q M N (i & j & k & I & J & K & ->) (i' & j' & k' & I' & J' & K' & ->).
  exists (m * i + n * i'), (m * j + n * j'), (m * k + n * k').
  repeat split; try (apply Z.add_nonneg_nonneg; apply Z.mul_nonneg_nonneg; assumption).
  apply point_eq; unfold sum3, mix; cbn [x y z]; ring.
Qed.

(* On the inner side of an edge. *)
Definition inner s p q r := 0 <= s * det p q r.
Lemma cone_inner s p q : cone (inner s p q).
Proof.
  intros i j u v I J U V. unfold inner in *.
  assert (s * det p q (mix i u j v) = i * (s * det p q u) + j * (s * det p q v)) as ->
    by (unfold det, dot, mix; cbn [x y z]; ring).
  apply Z.add_nonneg_nonneg; apply Z.mul_nonneg_nonneg; assumption.
Qed.

Definition inside_all a0 a1 a2 : Point -> Prop :=
  let s := Z.sgn (det a0 a1 a2) in both (inner s a0 a1) (both (inner s a1 a2) (inner s a2 a0)).

Lemma inside_hull a0 a1 a2 p : det a0 a1 a2 <> 0 -> inside_all a0 a1 a2 p ->
  exists w, 0 < w /\ hull a0 a1 a2 (mix w p 0 p).
Proof.
  intros D (H0 & H1 & H2). exists (Z.abs (det a0 a1 a2)). split; [lia|].
  unfold inner in *. exists (Z.sgn (det a0 a1 a2) * det a1 a2 p), (Z.sgn (det a0 a1 a2) * det a2 a0 p),
    (Z.sgn (det a0 a1 a2) * det a0 a1 p). repeat split; auto.
  rewrite <- Z.sgn_abs. set (s := Z.sgn (det a0 a1 a2)). 
  apply point_eq; unfold sum3, mix, det, dot, cross; cbn [x y z]; ring.
Qed.

(* The corners of an edge's own triangle. *)
Lemma corners_inside a0 a1 a2 : inside_all a0 a1 a2 a0 /\ inside_all a0 a1 a2 a1 /\ inside_all a0 a1 a2 a2.
Proof.
  set (s := Z.sgn (det a0 a1 a2)).
  assert (0 <= s * det a0 a1 a2) as P by (unfold s; pose proof (Z.sgn_abs (det a0 a1 a2)); lia).
  assert (forall p q, det p q p = 0 /\ det p q q = 0) as O by (intros; unfold det, dot, cross; cbn [x y z]; split; ring).
  assert (forall p q r, det q r p = det p q r) as Cycle by (intros; unfold det, dot, cross; cbn [x y z]; ring).
  unfold inside_all, both, inner. fold s.
  repeat split; first [rewrite (proj1 (O _ _)); lia | rewrite (proj2 (O _ _)); lia | exact P
    | rewrite Cycle; exact P | rewrite Cycle, Cycle; exact P].
Qed.

(* Some corner of b is not beyond each edge of a. *)
Definition some_inner s p q b0 b1 b2 := inner s p q b0 \/ inner s p q b1 \/ inner s p q b2.
Definition no_edge a0 a1 a2 b0 b1 b2 := let s := Z.sgn (det a0 a1 a2) in
  some_inner s a0 a1 b0 b1 b2 /\ some_inner s a1 a2 b0 b1 b2 /\ some_inner s a2 a0 b0 b1 b2.
Definition corner p := z p = 1.

Theorem edges_decide a0 a1 a2 b0 b1 b2 : corner a0 -> corner a1 -> corner a2 -> corner b0 -> corner b1 -> corner b2 ->
  det a0 a1 a2 <> 0 -> det b0 b1 b2 <> 0 -> no_edge a0 a1 a2 b0 b1 b2 -> no_edge b0 b1 b2 a0 a1 a2 ->
  somewhere (both (inside_all a0 a1 a2) (inside_all b0 b1 b2)).
Proof.
  intros A0 A1 A2 B0 B1 B2 DA DB (E0 & E1 & E2) (F0 & F1 & F2).
  pose proof (corners_inside a0 a1 a2) as IA. pose proof (corners_inside b0 b1 b2) as IB.
  set (s := Z.sgn (det a0 a1 a2)) in *. set (t := Z.sgn (det b0 b1 b2)) in *.
  unfold inside_all in *. fold s in IA. fold s. fold t in IB. fold t.
  set (H0 := inner s a0 a1) in *. set (H1 := inner s a1 a2) in *. set (H2 := inner s a2 a0) in *.
  set (K0 := inner t b0 b1) in *. set (K1 := inner t b1 b2) in *. set (K2 := inner t b2 b0) in *.
  assert (cone H0 /\ cone H1 /\ cone H2 /\ cone K0 /\ cone K1 /\ cone K2) as (CH0 & CH1 & CH2 & CK0 & CK1 & CK2)
    by (repeat split; apply cone_inner).
  assert (forall K, cone K -> K a0 \/ K a1 \/ K a2 -> somewhere (both K (both H0 (both H1 H2)))) as OfA.
  { intros K _ [G | [G | G]]; [exists a0 | exists a1 | exists a2]; unfold corner in *; split; try lia; split; auto; apply IA. }
  assert (forall H, cone H -> H b0 \/ H b1 \/ H b2 -> somewhere (both H (both K0 (both K1 K2)))) as OfB.
  { intros H _ [G | [G | G]]; [exists b0 | exists b1 | exists b2]; unfold corner in *; split; try lia; split; auto; apply IB. }
  pose proof (OfA K0 CK0 F0) as (k0 & Zk0 & Ak0). pose proof (OfA K1 CK1 F1) as (k1 & Zk1 & Ak1).
  pose proof (OfA K2 CK2 F2) as (k2 & Zk2 & Ak2). pose proof (OfB H0 CH0 E0) as (h0 & Zh0 & Ah0).
  pose proof (OfB H1 CH1 E1) as (h1 & Zh1 & Ah1). pose proof (OfB H2 CH2 E2) as (h2 & Zh2 & Ah2).
  clearbody H0 H1 H2 K0 K1 K2. clear E0 E1 E2 F0 F1 F2 IA IB OfA OfB DA DB A0 A1 A2 B0 B1 B2. clear s t.
  unfold both in *.
  (* Two sides of each. *)
  assert (forall X Y U V hx hy ku kv, cone X -> cone Y -> cone U -> cone V ->
    0 < z hx -> 0 < z hy -> 0 < z ku -> 0 < z kv ->
    X hx /\ U hx /\ V hx -> Y hy /\ U hy /\ V hy -> U ku /\ X ku /\ Y ku -> V kv /\ X kv /\ Y kv ->
    somewhere (both (both X Y) (both U V))) as Two.
  { intros X Y U V hx hy ku kv CX CY CU CV Zx Zy Zu Zv HX HY HU HV. apply helly; auto;
      [exists ku | exists kv | exists hx | exists hy]; split; auto; unfold both; tauto. }
  (* All sides of a, two of b. *)
  assert (forall U V ku kv, cone U -> cone V -> 0 < z ku -> 0 < z kv ->
    U ku /\ H0 ku /\ H1 ku /\ H2 ku -> V kv /\ H0 kv /\ H1 kv /\ H2 kv ->
    (forall p, K0 p /\ K1 p /\ K2 p -> U p /\ V p) -> somewhere (both (both H0 H1) (both H2 (both U V)))) as Three.
  { intros U V ku kv CU CV Zu Zv HU HV Sub.
    pose proof (Sub h0 (proj2 Ah0)). pose proof (Sub h1 (proj2 Ah1)). pose proof (Sub h2 (proj2 Ah2)).
    apply helly; auto using cone_both.
    - exists ku. unfold both. tauto.
    - destruct (Two H0 H1 U V h0 h1 ku kv) as (p & Zp & P); try assumption; try tauto. exists p. unfold both in *. tauto.
    - destruct (Two H0 H2 U V h0 h2 ku kv) as (p & Zp & P); try assumption; try tauto. exists p. unfold both in *. tauto.
    - destruct (Two H1 H2 U V h1 h2 ku kv) as (p & Zp & P); try assumption; try tauto. exists p. unfold both in *. tauto. }
  destruct (helly K0 K1 K2 (both H0 (both H1 H2))) as (p & Zp & P); auto using cone_both.
  - exists h0. unfold both. tauto.
  - destruct (Three K0 K1 k0 k1) as (p & Zp & P); auto; try tauto. exists p. unfold both in *. tauto.
  - destruct (Three K0 K2 k0 k2) as (p & Zp & P); auto; try tauto. exists p. unfold both in *. tauto.
  - destruct (Three K1 K2 k1 k2) as (p & Zp & P); auto; try tauto. exists p. unfold both in *. tauto.
  - exists p. unfold both in *. tauto.
Qed.

(* In the plane, corners have equal weights. *)
Lemma hulls_meet a0 a1 a2 b0 b1 b2 : corner a0 -> corner a1 -> corner a2 -> corner b0 -> corner b1 -> corner b2 ->
  (exists p, 0 < z p /\ hull a0 a1 a2 p /\ hull b0 b1 b2 p) -> meet a0 a1 a2 b0 b1 b2.
Proof.
  unfold corner. intros A0 A1 A2 B0 B1 B2 (p & P & (i & j & k & I & J & K & E) & (l & m & n & L & M & N & F)).
  exists i, j, k, l, m, n, p. unfold mean.
  assert (z p = i + j + k) as S by (rewrite E; unfold sum3, mix; cbn [x y z]; rewrite A0, A1, A2; ring).
  assert (z p = l + m + n) as T by (rewrite F; unfold sum3, mix; cbn [x y z]; rewrite B0, B1, B2; ring).
  do 6 (split; [assumption|]). split; [lia|]. split; [lia|].
  split; [rewrite E | rewrite F]; unfold sum3, mix; cbn [x y z]; repeat split; ring.
Qed.

Lemma grown a0 a1 a2 p w v : 0 <= v -> hull a0 a1 a2 (mix w p 0 p) -> hull a0 a1 a2 (mix (v * w) p 0 p).
Proof.
  intros V H. replace (mix (v * w) p 0 p) with (mix v (mix w p 0 p) 0 (mix w p 0 p))
    by (apply point_eq; unfold mix; cbn [x y z]; ring).
  apply cone_hull; auto; lia.
Qed.

Theorem areas_meet a0 a1 a2 b0 b1 b2 : corner a0 -> corner a1 -> corner a2 -> corner b0 -> corner b1 -> corner b2 ->
  det a0 a1 a2 <> 0 -> det b0 b1 b2 <> 0 -> no_edge a0 a1 a2 b0 b1 b2 -> no_edge b0 b1 b2 a0 a1 a2 ->
  meet a0 a1 a2 b0 b1 b2.
Proof.
  intros A0 A1 A2 B0 B1 B2 DA DB E F.
  destruct (edges_decide a0 a1 a2 b0 b1 b2) as (p & P & PA & PB); auto.
  apply inside_hull in PA as (v & V & PA); auto. apply inside_hull in PB as (w & W & PB); auto.
  apply hulls_meet; auto. exists (mix (v * w) p 0 p).
  split; [unfold mix; cbn [z]; assert (0 < v * w * z p) by (repeat apply Z.mul_pos_pos; auto); lia|].
  split; [rewrite Z.mul_comm; apply grown; auto; lia | apply grown; auto; lia].
Qed.

(* ---- A triangle with area, and one on a line: testing the two sides of this line suffices. *)
Definition crossed n a0 a1 a2 := ~ (0 < dot n a0 /\ 0 < dot n a1 /\ 0 < dot n a2) /\
  ~ (dot n a0 < 0 /\ dot n a1 < 0 /\ dot n a2 < 0).

Lemma point_on C n p q : cone C -> corner p -> corner q -> C p -> C q -> dot n p <= 0 <= dot n q ->
  somewhere (both (fun r => dot n r = 0) C).
Proof.
  unfold corner. intros K Zp Zq P Q [L M]. destruct (Z.eq_dec (dot n p) 0) as [E | E].
  - exists p. split; [lia|]. now split.
  - exists (mix (dot n q) p (- dot n p) q). split; [unfold mix; cbn [z]; rewrite Zp, Zq; lia|].
    split; [unfold dot, mix; cbn [x y z]; ring | apply K; auto; lia].
Qed.

Lemma crossed_somewhere C n a0 a1 a2 : cone C -> corner a0 -> corner a1 -> corner a2 -> C a0 -> C a1 -> C a2 ->
  crossed n a0 a1 a2 -> somewhere (both (fun r => dot n r = 0) C).
Proof.
  intros K Z0 Z1 Z2 H0 H1 H2 [U V].
  assert (forall P : Point -> Prop, P a0 \/ P a1 \/ P a2 -> exists p, P p /\ corner p /\ C p) as Pick
    by (intros P [H | [H | H]]; eauto).
  destruct (Pick (fun p => dot n p <= 0)) as (p & LP & Zp & Hp); [lia|].
  destruct (Pick (fun p => 0 <= dot n p)) as (q & LQ & Zq & Hq); [lia|].
  now apply (point_on C n p q K).
Qed.

Lemma hull_corners b0 b1 b2 : hull b0 b1 b2 b0 /\ hull b0 b1 b2 b1 /\ hull b0 b1 b2 b2.
Proof.
  repeat split; [exists 1, 0, 0 | exists 0, 1, 0 | exists 0, 0, 1]; repeat split; try lia;
    apply point_eq; unfold sum3, mix; cbn [x y z]; ring.
Qed.

Theorem line_meets n a0 a1 a2 b0 b1 b2 : corner a0 -> corner a1 -> corner a2 -> corner b0 -> corner b1 -> corner b2 ->
  det a0 a1 a2 <> 0 -> x n <> 0 \/ y n <> 0 -> dot n b0 = 0 -> dot n b1 = 0 -> dot n b2 = 0 ->
  no_edge a0 a1 a2 b0 b1 b2 -> crossed n a0 a1 a2 -> meet a0 a1 a2 b0 b1 b2.
Proof.
  intros A0 A1 A2 B0 B1 B2 DA N N0 N1 N2 (E0 & E1 & E2) X.
  pose proof (corners_inside a0 a1 a2) as (I0 & I1 & I2). pose proof (hull_corners b0 b1 b2) as (J0 & J1 & J2).
  set (s := Z.sgn (det a0 a1 a2)) in *. pose proof (cone_hull a0 a1 a2) as _.
  assert (cone (inside_all a0 a1 a2)) as CA by (apply cone_both; [|apply cone_both]; apply cone_inner).
  destruct (crossed_somewhere _ n a0 a1 a2 CA A0 A1 A2 I0 I1 I2 X) as (p & Zp & Np & Ip).
  assert (forall q r, some_inner s q r b0 b1 b2 -> exists b, 0 < z b /\ dot n b = 0 /\ inner s q r b /\ hull b0 b1 b2 b) as Some_.
  { unfold corner in *. intros q r [G | [G | G]]; [exists b0 | exists b1 | exists b2]; repeat split; auto; lia. }
  assert (forall q r t o, inner s q r p -> inner s t o p -> some_inner s q r b0 b1 b2 -> some_inner s t o b0 b1 b2 ->
    somewhere (both (inner s q r) (both (inner s t o) (hull b0 b1 b2)))) as Two.
  { intros q r t o P Q S T. destruct (Some_ q r S) as (c & Zc & Nc & Ic & Hc), (Some_ t o T) as (d & Zd & Nd & Id & Hd).
    destruct (helly_on_line n (inner s q r) (inner s t o) (hull b0 b1 b2) N) as (w & Zw & _ & W);
      try apply cone_inner; try apply cone_hull; [exists p | exists c | exists d | now exists w]; unfold both; auto. }
  destruct Ip as (P0 & P1 & P2). fold s in P0, P1, P2.
  destruct (helly (inner s a0 a1) (inner s a1 a2) (inner s a2 a0) (hull b0 b1 b2)) as (w & Zw & W);
    try apply cone_inner; try apply cone_hull; auto.
  - exists a0. unfold corner in *. split; [lia|]. exact I0.
  - destruct W as ((W0 & W1) & W2 & WB).
    assert (inside_all a0 a1 a2 w) as WA by (repeat split; assumption).
    apply inside_hull in WA as (v & V & WA); auto. apply hulls_meet; auto. exists (mix v w 0 w).
    split; [unfold mix; cbn [z]; assert (0 < v * z w) by (apply Z.mul_pos_pos; auto); lia|].
    split; auto. apply cone_hull; auto; lia.
Qed.

Theorem point_meets a0 a1 a2 b : corner a0 -> corner a1 -> corner a2 -> corner b -> det a0 a1 a2 <> 0 ->
  no_edge a0 a1 a2 b b b -> meet a0 a1 a2 b b b.
Proof.
  intros A0 A1 A2 B DA (E0 & E1 & E2).
  assert (inside_all a0 a1 a2 b) as I by (unfold some_inner in *; repeat split; tauto).
  apply inside_hull in I as (v & V & I); auto. apply hulls_meet; auto. exists (mix v b 0 b).
  unfold corner in B. split; [unfold mix; cbn [z]; rewrite B; lia|]. split; auto.
  apply cone_hull; try lia; apply hull_corners.
Qed.

(* Two triangles on lines that cross. *)
Theorem lines_meet n m a0 a1 a2 b0 b1 b2 : corner a0 -> corner a1 -> corner a2 -> corner b0 -> corner b1 -> corner b2 ->
  z (cross n m) <> 0 -> dot n a0 = 0 -> dot n a1 = 0 -> dot n a2 = 0 -> dot m b0 = 0 -> dot m b1 = 0 -> dot m b2 = 0 ->
  crossed n b0 b1 b2 -> crossed m a0 a1 a2 -> meet a0 a1 a2 b0 b1 b2.
Proof.
  intros A0 A1 A2 B0 B1 B2 D N0 N1 N2 M0 M1 M2 XB XA.
  pose proof (hull_corners a0 a1 a2) as (I0 & I1 & I2). pose proof (hull_corners b0 b1 b2) as (J0 & J1 & J2).
  destruct (crossed_somewhere _ m a0 a1 a2 (cone_hull a0 a1 a2) A0 A1 A2 I0 I1 I2 XA) as (p & Zp & Mp & Hp).
  destruct (crossed_somewhere _ n b0 b1 b2 (cone_hull b0 b1 b2) B0 B1 B2 J0 J1 J2 XB) as (q & Zq & Nq & Hq).
  assert (forall l c0 c1 c2 r, dot l c0 = 0 -> dot l c1 = 0 -> dot l c2 = 0 -> hull c0 c1 c2 r -> dot l r = 0) as On.
  { intros l c0 c1 c2 r E0 E1 E2 (i & j & k & _ & _ & _ & ->).
    unfold dot, sum3, mix in *. cbn [x y z]. clear - E0 E1 E2. nsatz. }
  pose proof (On n _ _ _ p N0 N1 N2 Hp) as Np. pose proof (On m _ _ _ q M0 M1 M2 Hq) as Mq.
  pose proof (parallel n m p Np Mp) as (PX & PY & PZ). pose proof (parallel n m q Nq Mq) as (QX & QY & QZ).
  cbv zeta in *. set (d := cross n m) in *. set (P := dot p d) in *. set (Q := dot q d) in *.
  assert (dot d d <> 0) as DD by (unfold dot; nia).
  assert (forall s t, dot d d * s = dot d d * t -> s = t) as Cancel by (intros; eapply Z.mul_reg_l; eauto).
  assert (mix (z q) p 0 p = mix (z p) q 0 q) as E.
  { apply point_eq; unfold mix; cbn [x y z]; rewrite !Z.mul_0_l, !Z.add_0_r; apply Cancel, Cancel.
    all: clear - PX PY PZ QX QY QZ; nsatz. }
  apply hulls_meet; auto. exists (mix (z q) p 0 p).
  split; [unfold mix; cbn [z]; assert (0 < z q * z p) by (apply Z.mul_pos_pos; auto); lia|].
  split; [|rewrite E]; apply cone_hull; auto; lia.
Qed.

Print Assumptions areas_meet.
