(* Work: a run does at most its budget and the rest of one step, for any kind of steps: a step begins if some work is
   left, and the excess of its cost is forgiven. *)
From Coq Require Import List ZArith Lia.
Import ListNotations.
Local Open Scope Z_scope.

(* code: include/flashbvh/detail/walk/work.hpp | if (left != kUnlimited) { left = spent < left ? left - spent : 0; }
   code: include/flashbvh/detail/walk/walk_run.hpp | const uint32_t spent = work < work_left ? work : work_left; work_left -= spent; *)
Definition take (left spent : Z) : Z := if spent <? left then left - spent else 0.

(* The executed steps of all steps to come, each with its cost.
   code: include/flashbvh/detail/walk/walk_below.hpp | if (work_left == 0) { end = State::at_pair; break; } --work_left;
   code: include/flashbvh/detail/walk/walk.hpp | if (work_left == 0) { end = State::at_pair; break; } --work_left;
   code: include/flashbvh/detail/query/query_run.hpp | if (end == State::done || work == 0) { return status(); } *)
Fixpoint done (left : Z) (steps : list Z) : list Z :=
  match steps with
  | s :: r => if left =? 0 then [] else s :: done (take left s) r
  | [] => []
  end.
Definition sum := fold_right Z.add 0.

(* Pairs of triangles: as many as the work pays for, the last one for the remaining work.
   code: include/flashbvh/detail/walk/work.hpp | return work / pair_work + (work % pair_work != 0 ? 1 : 0); *)
Definition paid (work : Z) : Z :=
  work / @kTrianglePairWork@ + if work mod @kTrianglePairWork@ =? 0 then 0 else 1.

Definition Spends_a_step_more_at_most := forall most granted steps, 0 <= granted ->
  (forall s, In s steps -> 1 <= s <= most) ->
  sum (done granted steps) <= granted + Z.max 0 (most - 1) /\
  (done granted steps = steps \/ granted <= sum (done granted steps)).   (* to the end, or all of it *)
Definition Always_gets_on := forall granted s r, 0 < granted -> exists d, done granted (s :: r) = s :: d.
Definition Pays_for_pairs := forall work, 0 <= work ->
  work <= paid work * @kTrianglePairWork@ < work + @kTrianglePairWork@.

Theorem spends_a_step_more_at_most : Spends_a_step_more_at_most.
Proof.
  intros most granted steps. revert granted. induction steps as [|s r IH]; intros g G S; cbn [done sum fold_right].
  - split; [cbn; lia | now left].
  - destruct (Z.eqb_spec g 0) as [-> | N]; cbn [sum fold_right]; [split; [cbn; lia | right; cbn; lia]|].
    assert (1 <= s <= most) as B by (apply S; now left).
    specialize (IH (take g s)). unfold take in *. fold sum. destruct (Z.ltb_spec s g).
    + destruct IH as [L [E | M]]; [lia | intros; apply S; now right | |]; (split; [lia|]); [left; now f_equal | right; lia].
    + assert (done 0 r = []) as -> by now destruct r. cbn. split; [lia | right; lia].
Qed.
Theorem always_gets_on : Always_gets_on.
Proof. intros g s r G. cbn [done]. destruct (Z.eqb_spec g 0); [lia | eauto]. Qed.
Theorem pays_for_pairs : Pays_for_pairs.
Proof.
  intros w W. unfold paid. pose proof (Z.div_mod w @kTrianglePairWork@ ltac:(easy)).
  pose proof (Z.mod_pos_bound w @kTrianglePairWork@ eq_refl).
  destruct (Z.eqb_spec (w mod @kTrianglePairWork@) 0); lia.
Qed.

Print Assumptions spends_a_step_more_at_most.
Print Assumptions always_gets_on.
Print Assumptions pays_for_pairs.
