; the test of two boxes under a translation is that of unpacked integers, for all boxes and all translations within +-3 * 2^29
;
; Bounds are within +-kMaxCoordinate. Compares packing, packed sums and thresholds of box.hpp with
; max(lower) <= min(upper) in 64 bits. For the other forms of the comparison: box_forms.smt2.
; code: include/flashbvh/lattice.hpp | return static_cast<uint32_t>(bound + kBoundBias);
; code: include/flashbvh/lattice.hpp | return {join_halves(pack_bound(box.upper.x), pack_bound(box.upper.y)),
; code: include/flashbvh/lattice.hpp | join_halves(pack_bound(-box.lower.x), pack_bound(-box.lower.y)),
; code: include/flashbvh/lattice.hpp | join_halves(pack_bound(box.upper.z), pack_bound(-box.lower.z))};
; code: include/flashbvh/detail/bounds/box.hpp | return {{a.upper_xy + b.lower_xy, a.lower_xy + b.upper_xy, a.z + swap_halves(b.z)}};
; code: include/flashbvh/detail/bounds/box.hpp | least_{{join_halves(threshold(x), threshold(y)), join_halves(threshold(-x), threshold(-y)), join_halves(threshold(z), threshold(-z))}} {}
; code: include/flashbvh/detail/bounds/box.hpp | constexpr int32_t never = UINT16_MAX; const int32_t least = kZero + t; return static_cast<uint32_t>(least < 0 ? 0 : least > never ? never : least);
(set-logic QF_BV)
(define-sort Word () (_ BitVec 32))
(define-sort Half () (_ BitVec 16))
(define-sort Int64 () (_ BitVec 64))

; ---- boxes a and b, a translation of b: unpacked, as 64-bit integers
(define-fun most () Half (_ bv@kMaxCoordinate@ 16))
(define-fun bound ((h Half)) Bool (and (bvsle (bvneg most) h) (bvsle h most)))
(declare-fun alx () Half) (declare-fun aux () Half) (declare-fun blx () Half) (declare-fun bux () Half)
(declare-fun aly () Half) (declare-fun auy () Half) (declare-fun bly () Half) (declare-fun buy () Half)
(declare-fun alz () Half) (declare-fun auz () Half) (declare-fun blz () Half) (declare-fun buz () Half)
(declare-fun tx () Word) (declare-fun ty () Word) (declare-fun tz () Word)
(define-fun box_axis ((lower Half) (upper Half)) Bool
  (and (bound lower) (bound upper) (bvsle lower upper)))
(assert (and (box_axis alx aux) (box_axis aly auy) (box_axis alz auz)))
(assert (and (box_axis blx bux) (box_axis bly buy) (box_axis blz buz)))

; ---- the definition: max of the lower bounds <= min of the upper bounds, without wrapping
(define-fun wide ((h Half)) Int64 ((_ sign_extend 48) h))
(define-fun max64 ((p Int64) (q Int64)) Int64 (ite (bvsge p q) p q))
(define-fun min64 ((p Int64) (q Int64)) Int64 (ite (bvsle p q) p q))
(define-fun axis ((al Half) (au Half) (bl Half) (bu Half) (t Word)) Bool
  (let ((t64 ((_ sign_extend 32) t)))
    (bvsle (max64 (wide al) (bvadd (wide bl) t64)) (min64 (wide au) (bvadd (wide bu) t64)))))
(define-fun overlap () Bool
  (and (axis alx aux blx bux tx) (axis aly auy bly buy ty) (axis alz auz blz buz tz)))

; ---- pack()
(define-fun packed ((b Half)) Half (bvadd b (_ bv@kBoundBias@ 16)))
(define-fun join ((low Half) (high Half)) Word (concat high low))
(define-fun a_upper_xy () Word (join (packed aux) (packed auy)))
(define-fun a_lower_xy () Word (join (packed (bvneg alx)) (packed (bvneg aly))))
(define-fun a_z () Word (join (packed auz) (packed (bvneg alz))))
(define-fun b_upper_xy () Word (join (packed bux) (packed buy)))
(define-fun b_lower_xy () Word (join (packed (bvneg blx)) (packed (bvneg bly))))
(define-fun b_z () Word (join (packed buz) (packed (bvneg blz))))

; ---- sums(): one 32-bit addition for two sums
(define-fun swap_halves ((w Word)) Word (bvor (bvshl w #x00000010) (bvlshr w #x00000010)))
(define-fun sum0 () Word (bvadd a_upper_xy b_lower_xy))
(define-fun sum1 () Word (bvadd a_lower_xy b_upper_xy))
(define-fun sum2 () Word (bvadd a_z (swap_halves b_z)))

; ---- threshold()
(define-fun zero () Word (_ bv@2 * kBoundBias@ 32))
(define-fun clamp ((t Word)) Word (ite (bvslt t #x00000000) #x00000000 (ite (bvsgt t #x0000ffff) #x0000ffff t)))
(define-fun threshold ((t Word)) Half ((_ extract 15 0) (clamp (bvadd zero t))))
(define-fun least0 () Word (join (threshold tx) (threshold ty)))
(define-fun least1 () Word (join (threshold (bvneg tx)) (threshold (bvneg ty))))
(define-fun least2 () Word (join (threshold tz) (threshold (bvneg tz))))
(define-fun near ((t Word)) Bool (and (bvsle #xa0000000 t) (bvsle t #x60000000)))
(assert (and (near tx) (near ty) (near tz)))

; ---- halves_reach_portable()
(define-fun low ((w Word)) Half ((_ extract 15 0) w))
(define-fun high ((w Word)) Half ((_ extract 31 16) w))
(define-fun reaches ((v Word) (l Word)) Bool
  (and (bvuge (low v) (low l)) (bvuge (high v) (high l))))
(define-fun test () Bool (and (reaches sum0 least0) (reaches sum1 least1) (reaches sum2 least2)))

; ---- boxes_disjoint()
; code: include/flashbvh/detail/bounds/box.hpp | if (below(low_half(upper_xy), zero + x)) { return true; }
; code: include/flashbvh/detail/bounds/box.hpp | if (below(low_half(lower_xy), zero - x)) { return true; }
; code: include/flashbvh/detail/bounds/box.hpp | if (below(high_half(upper_xy), zero + y) || below(high_half(lower_xy), zero - y)) { return true; }
; code: include/flashbvh/detail/bounds/box.hpp | return below(low_half(both_z), zero + z) || below(high_half(both_z), zero - z);
(define-fun below ((h Half) (l Word)) Bool (bvslt ((_ zero_extend 16) h) l))
(define-fun disjoint () Bool
  (or (below (low sum0) (bvadd zero tx)) (below (low sum1) (bvsub zero tx))
      (below (high sum0) (bvadd zero ty)) (below (high sum1) (bvsub zero ty))
      (below (low sum2) (bvadd zero tz)) (below (high sum2) (bvsub zero tz))))

; ---- window_of_a(), window_of_b(): a box against the limits of a leaf's box, seen from the other tree
; code: include/flashbvh/detail/lattice/box_packed.hpp | return {{subtract_halves(least.word[1], other.lower_xy),
; code: include/flashbvh/detail/bounds/box.hpp | return window({{least_.word[1], least_.word[0], swap_halves(least_.word[2])}}, b);
(define-fun less ((x Half) (y Half)) Half (ite (bvugt x y) (bvsub x y) #x0000))
(define-fun subtract ((u Word) (v Word)) Word (join (less (low u) (low v)) (less (high u) (high v))))
(define-fun window_of_a () Bool
  (and (reaches b_upper_xy (subtract least1 a_lower_xy)) (reaches b_lower_xy (subtract least0 a_upper_xy))
       (reaches b_z (swap_halves (subtract least2 a_z)))))
(define-fun window_of_b () Bool
  (and (reaches a_upper_xy (subtract least0 b_lower_xy)) (reaches a_lower_xy (subtract least1 b_upper_xy))
       (reaches a_z (swap_halves (subtract (swap_halves least2) b_z)))))

(check-sat-assuming ((distinct overlap test))) ; unsat: the packed test differs
(check-sat-assuming ((= overlap disjoint))) ; unsat: boxes_disjoint() differs
(check-sat-assuming ((distinct test window_of_a))) ; unsat: A's window differs
(check-sat-assuming ((distinct test window_of_b))) ; unsat: B's window differs
(check-sat-assuming (test)) ; sat: boxes can overlap
(check-sat-assuming ((not test))) ; sat: boxes can be disjoint
