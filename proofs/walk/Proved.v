(* The proved properties of the walk, combined, with evidence that the premises can be met: a false premise would make
   every theorem true and worthless. *)
From Coq Require Import List ZArith Lia Bool.
Require Import Constants Ranked Code Query Image.
Import ListNotations.

(* For two opened images, and any tests of boxes and slabs that reject safely: every division of a query into runs gives
   exactly the pairs of triangles that intersect. *)
Theorem opened_and_queried cells_a cells_b inside_a inside_b
    (A : accepts cells_a inside_a = true) (B : accepts cells_b inside_b = true) :
  let FA := proj1 (accepted_is_tree cells_a inside_a A) in
  let FB := proj1 (accepted_is_tree cells_b inside_b B) in
  forall bound begin touch Triangles pairs_of intersect,
  Cuts_agree cells_a cells_b _ _ FA FB bound begin touch Triangles pairs_of intersect /\
  Can_end cells_a cells_b _ _ FA FB bound begin touch Triangles pairs_of intersect /\
  Answers_are_exact cells_a cells_b _ _ FA FB bound begin touch Triangles pairs_of intersect.
Proof.
  intros FA FB bound begin touch T pairs_of intersect. split; [apply cuts_agree|].
  split; [apply can_end | apply answers_are_exact].
Qed.

(* ---- The premises can be met. *)

(* R of rank 5 with a leaf, a node of rank 5 that has one leaf, and a node of rank 2 that has three. *)
Definition leaf_at l := {| c_link := l; c_rank := -7; c_parent_rank := 0 |}.
Definition tree_a : list Cell := [
  {| c_link := 8; c_rank := 5; c_parent_rank := kRootParentRank |};
    {| c_link := 7; c_rank := 2; c_parent_rank := 5 |};   (* 1: third, last child *)
      leaf_at 4; leaf_at 2; leaf_at 3;                    (* 2 to 4 *)
    {| c_link := 1; c_rank := 5; c_parent_rank := 5 |};   (* 5: second child *)
      leaf_at 6;                                          (* 6: alone *)
    leaf_at 5 ].                                          (* 7: first child *)
Definition tree_b : list Cell := [
  {| c_link := 5; c_rank := kMaxRank; c_parent_rank := kRootParentRank |};
    {| c_link := 4; c_rank := 3; c_parent_rank := kMaxRank |};
      leaf_at 3; leaf_at 2;
    leaf_at 1 ].
Definition all_inside (_ _ : nat) : bool := true.

Lemma a_opens : accepts tree_a all_inside = true. Proof. vm_compute. reflexivity. Qed.
Lemma b_opens : accepts tree_b all_inside = true. Proof. vm_compute. reflexivity. Qed.
Lemma a_leaf_opens : accepts [leaf_at 1] all_inside = true. Proof. vm_compute. reflexivity. Qed.

(* A walk in which some pairs overlap, also by leaf planes, finds pairs of leaves and ends. *)
Definition some (a b : nat) : bool := negb ((a * 3 + b * 5) mod 7 =? 4).
Definition shape_meets (_ : Side) (a b : nat) : bool := negb ((a + b) mod 5 =? 3).
Example finds_some :
  let go n := code_after tree_a tree_b some some shape_meets n (begin_walk tree_a tree_b) in
  go 60 = CDone /\
  found_in tree_a tree_b some some shape_meets 60 (begin_walk tree_a tree_b) =
    [(7, 4); (6, 4); (3, 4); (2, 4); (7, 3); (7, 2); (6, 3); (4, 2); (3, 2); (2, 2)].
Proof. vm_compute. split; reflexivity. Qed.

(* The check finds faults: a rank that grows, a node without a parent, a sibling of the root. *)
Example rank_grows : accepts
  [ {| c_link := 3; c_rank := 5; c_parent_rank := kRootParentRank |};
    {| c_link := 1; c_rank := 6; c_parent_rank := 5 |}; leaf_at 2 ] all_inside = false.
Proof. reflexivity. Qed.
Example lost_node : accepts (tree_b ++ [leaf_at 5]) all_inside = false.
Proof. reflexivity. Qed.
Example sibling_of_root : accepts [leaf_at 2; leaf_at 0] all_inside = false.
Proof. reflexivity. Qed.

Print Assumptions walk_is_dfs.
Print Assumptions resumes.
Print Assumptions resumes_behind.
Print Assumptions visits_once.
Print Assumptions visited_can_be.
Print Assumptions can_be_visited.
Print Assumptions ends_from_everywhere.
Print Assumptions finds_each_once.
Print Assumptions simulates.
Print Assumptions starts.
Print Assumptions opened_and_queried.
