; rotating a box: sums by SMLAD and by PMADDWD, an entry by a branch; cells by USAT, PACKSSDW and plain code
;
; One axis: the sums of a row's products with a box's bounds, modulo 2^32, and their
; whole cells; then the comparison with another box. Rows as in SplitRow::of(): one of an entry's two parts is 0.
; code: src/arch/portable/rotate_box.hpp | return saturated<15>(bound >> kSplitBits);
; code: include/flashbvh/detail/arch/packed.hpp | return static_cast<uint32_t>(value < 0 ? 0 : value > most ? most : value);
; code: include/flashbvh/detail/lattice/box_packed.hpp | ~((a.upper_xy + b.lower_xy) & (a.lower_xy + b.upper_xy) & (a.z + swap_halves(b.z)));
; code: src/arch/plain/sums.hpp | return sum >> 31 != 0 ? 0 : sum > most ? most : sum;
; code: src/arch/plain/sums.hpp | if (__builtin_expect((sums.upper | sums.lower) >> (15 + kSplitBits) != 0, 0)) {
; code: src/arch/sse2/sums.hpp | const __m128i cells = _mm_max_epi16(_mm_packs_epi32(upper, lower), _mm_setzero_si128());
; code: src/arch/dsp/rotate_box.hpp | usat \upper, #15, \upper, asr #14
(set-logic QF_BV)
(define-sort Word () (_ BitVec 32))
(define-sort Half () (_ BitVec 16))
(define-fun split () Word (_ bv@kSplitBits@ 32))
(define-fun zext ((h Half)) Word ((_ zero_extend 16) h))
(define-fun sext ((h Half)) Word ((_ sign_extend 16) h))
(define-fun bound ((h Half)) Bool (= #b0 ((_ extract 15 15) h)))

; ---- sums: px nx, py ny, pz nz the parts of a row's entries; u, l the box's upper and lower bounds
(declare-fun px () Half) (declare-fun nx () Half) (declare-fun ux () Half) (declare-fun lx () Half)
(declare-fun py () Half) (declare-fun ny () Half) (declare-fun uy () Half) (declare-fun ly () Half)
(declare-fun pz () Half) (declare-fun nz () Half) (declare-fun uz () Half) (declare-fun lz () Half)
(declare-fun start () Word)
(define-fun parts ((p Half) (n Half)) Bool (and (bound p) (bound n) (or (= p #x0000) (= n #x0000))))
; the product of one instruction: signed halves
(define-fun smlad ((p Half) (q Half) (u Half) (v Half) (to Word)) Word
  (bvadd (bvadd (bvmul (sext p) (sext u)) (bvmul (sext q) (sext v))) to))
(define-fun upper_dsp () Word (smlad pz nz uz lz (smlad nx ny lx ly (smlad px py ux uy start))))
(define-fun pmaddwd ((p Half) (q Half) (u Half) (v Half)) Word
  (bvadd (bvmul (sext p) (sext u)) (bvmul (sext q) (sext v))))
(define-fun upper_sse2 () Word
  (bvadd (bvadd start (bvadd (pmaddwd px py ux uy) (pmaddwd nx ny lx ly))) (pmaddwd pz nz uz lz)))
(define-fun add_plain ((p Half) (n Half) (u Half) (l Half)) Word
  (ite (distinct p #x0000) (bvmul (zext p) (zext u)) (bvmul (zext n) (zext l))))
(define-fun upper_plain () Word
  (bvadd (bvadd (bvadd start (add_plain px nx ux lx)) (add_plain py ny uy ly)) (add_plain pz nz uz lz)))
; the lower bound, with u and l exchanged (SMLADX, PMADDWD of swapped halves)
(push 1)
(assert (and (bound ux) (bound lx) (bound uy) (bound ly) (bound uz) (bound lz)))
(assert (and (parts px nx) (parts py ny) (parts pz nz)))
(check-sat-assuming ((distinct upper_dsp upper_sse2))) ; unsat: SMLAD's and PMADDWD's sums differ
(check-sat-assuming ((distinct (smlad px nx ux lx start) (bvadd start (add_plain px nx ux lx))))) ; unsat: an entry's two products and the one that a branch takes differ
(pop 1)

; ---- whole cells of a sum
(declare-fun sum () Word) (declare-fun other_sum () Word)
(define-fun cells ((s Word)) Word (bvashr s split))
(define-fun whole ((s Word)) Word
  (ite (bvslt (cells s) #x00000000) #x00000000 (ite (bvsgt (cells s) #x00007fff) #x00007fff (cells s))))
(define-fun most () Word (bvshl #x00007fff split))
(define-fun clamped ((s Word)) Word
  (ite (distinct (bvlshr s #x0000001f) #x00000000) #x00000000 (ite (bvugt s most) most s)))
; one test for two sums
(define-fun whole_plain ((s Word) (t Word)) Word
  (bvlshr (ite (distinct #x00000000 (bvlshr (bvor s t) (bvadd #x0000000f split))) (clamped s) s) split))
(define-fun packs ((c Word)) Half
  (ite (bvslt c #xffff8000) #x8000 (ite (bvsgt c #x00007fff) #x7fff ((_ extract 15 0) c))))
(define-fun whole_sse2 ((s Word)) Half (let ((h (packs (cells s)))) (ite (bvslt h #x0000) #x0000 h)))
(define-fun usat15 ((c Word)) Word
  (ite (bvslt c #x00000000) #x00000000 (ite (bvsgt c #x00007fff) #x00007fff c)))
(check-sat-assuming ((distinct (whole sum) (whole_plain sum other_sum)))) ; unsat: plain code's cells differ
(check-sat-assuming ((distinct ((_ extract 15 0) (whole sum)) (whole_sse2 sum)))) ; unsat: SSE2's cells differ
(check-sat-assuming ((distinct (whole sum) (usat15 (bvashr sum split))))) ; unsat: USAT's cells differ

; ---- the comparison: the sum of cells and another box's bound, which is at least 1, is below the bias
(declare-fun h () Half)
(assert (and (bound h) (distinct h #x0000)))
; cells cut off by a clamp compare like the bound itself
(define-fun clamp_differs () Bool
  (distinct (bvsge (bvadd (cells sum) (zext h)) (_ bv@2 * kBoundBias@ 32))
            (bvuge (bvadd ((_ extract 15 0) (whole sum)) h) (_ bv@2 * kBoundBias@ 16))))
(check-sat-assuming (clamp_differs)) ; unsat: a clamped bound decides otherwise
