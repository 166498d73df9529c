(* The constants of lib/include/flashbvh/mesh.hpp, inserted by proofs/prelude.py. *)
From Coq Require Import ZArith.
Local Open Scope Z_scope.
Definition kRootParentRank : Z := @kRootParentRank@.
Definition kMaxRank : Z := @kMaxRank@.
