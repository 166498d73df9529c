; what opening an image reads of a node's words: boxes inside boxes, leaves and ranks
; code: src/lattice/tree_check.cpp | return ((box.upper_xy | box.lower_xy | box.z) & 0x80008000u) == 0;
; code: src/lattice/tree_check.cpp | const uint32_t reach = ((outer.upper_xy | spare) - inner.upper_xy) &
; code: src/lattice/tree_check.cpp | return (reach & spare) == spare;
; code: src/lattice/tree_check.cpp | return node.rank() >= 1 && node.rank() <= kMaxRank && (node.data & ends) == node.data;
; code: include/flashbvh/mesh.hpp | return static_cast<int8_t>(data >> (kBits - 8));
; code: include/flashbvh/mesh.hpp | constexpr bool is_leaf() const { return (data & kLeafFlag) != 0; }
(set-logic QF_BV)
(define-sort Word () (_ BitVec 32))
(define-sort Half () (_ BitVec 16))
(define-fun low ((w Word)) Half ((_ extract 15 0) w))
(define-fun high ((w Word)) Half ((_ extract 31 16) w))
(declare-fun i0 () Word) (declare-fun i1 () Word) (declare-fun i2 () Word)  ; inner
(declare-fun o0 () Word) (declare-fun o1 () Word) (declare-fun o2 () Word)  ; outer
(define-fun spare () Word #x80008000)
(define-fun on_lattice ((u Word) (v Word) (w Word)) Bool (= #x00000000 (bvand (bvor u v w) spare)))
(define-fun inside () Bool
  (= spare (bvand (bvsub (bvor o0 spare) i0) (bvsub (bvor o1 spare) i1) (bvsub (bvor o2 spare) i2) spare)))
; a box in another: no bound, upper or negated lower, beyond the other's
(define-fun within ((i Word) (o Word)) Bool (and (bvule (low i) (low o)) (bvule (high i) (high o))))
(define-fun all_within () Bool (and (within i0 o0) (within i1 o1) (within i2 o2)))
(check-sat-assuming ((on_lattice i0 i1 i2) (on_lattice o0 o1 o2) (distinct inside all_within))) ; unsat: is_inside() differs

; Node::data of 16 and of 32 bits: the top byte, signed, is the rank
(declare-fun d16 () Half) (declare-fun d32 () Word)
(define-fun byte ((c Half)) Word ((_ sign_extend 24) ((_ extract 7 0) c)))
(define-fun rank16 () Word (byte (bvlshr d16 #x0008)))
(define-fun rank32 () Word (byte ((_ extract 15 0) (bvlshr d32 #x00000018))))
(check-sat-assuming ((distinct (bvslt rank16 #x00000000) (distinct #x0000 (bvand d16 #x8000))))) ; unsat: a leaf is what has a negative rank, 16 bits
(check-sat-assuming ((distinct (bvslt rank32 #x00000000) (distinct #x00000000 (bvand d32 #x80000000))))) ; unsat: a leaf is what has a negative rank, 32 bits
(check-sat-assuming ((bvsgt rank16 (_ bv@kRootParentRank@ 32)))) ; unsat: a rank above that of a root's missing parent
