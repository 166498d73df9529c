; UQSUB16, plain words, SSE2 and NEON compare two boxes as the reference does
;
; Instructions as their vendors define them, each lane separately. UQSUB16, PSUBUSW, VQSUB: the difference of halves, or
; 0 if it is negative. Boxes: halves from 1 to 32,767; thresholds: any.
; code: include/flashbvh/detail/arch/packed.hpp | return value >= least && (value << 16) >= (least << 16);
; code: include/flashbvh/detail/arch/packed.hpp | return (__uqsub16(least.word[0], value.word[0]) | __uqsub16(least.word[1], value.word[1]) |
; code: include/flashbvh/detail/bounds/box_dsp.hpp | "ldrd r2, r3, %0\n\t" "ldrd r0, r12, %1\n\t" "add r2, r2, r12\n\t" "uqsub16 r2, %2, r2\n\t" "add r3, r3, r0\n\t" "uqsub16 r3, %3, r3\n\t" "orrs r2, r2, r3\n\t"
; code: include/flashbvh/detail/bounds/box_dsp.hpp | return __uqsub16(least.word[2], a.z + swap_halves(b.z)) == 0;
; code: include/flashbvh/detail/bounds/box_simd.hpp | _mm_add_epi16(first_two(&a), _mm_shuffle_epi32(first_two(&b), 0xE1));
; code: include/flashbvh/detail/bounds/box_simd.hpp | const __m128i missing = _mm_subs_epu16(threshold, _mm_unpacklo_epi64(xy, z));
; code: include/flashbvh/detail/bounds/box_simd.hpp | const uint16x4_t xy = add(first_two(&a), vrev64_u32(first_two(&b)));
(set-logic QF_BV)
(define-sort Word () (_ BitVec 32))
(define-sort Half () (_ BitVec 16))
(define-fun low ((w Word)) Half ((_ extract 15 0) w))
(define-fun high ((w Word)) Half ((_ extract 31 16) w))
(define-fun swap_halves ((w Word)) Word (bvor (bvshl w #x00000010) (bvlshr w #x00000010)))
(declare-fun a0 () Word) (declare-fun a1 () Word) (declare-fun a2 () Word)  ; upper_xy, lower_xy, z
(declare-fun b0 () Word) (declare-fun b1 () Word) (declare-fun b2 () Word)
(declare-fun l0 () Word) (declare-fun l1 () Word) (declare-fun l2 () Word)  ; thresholds
(define-fun bounds ((w Word)) Bool
  (and (= #b0 ((_ extract 15 15) w)) (= #b0 ((_ extract 31 31) w))
       (distinct #x0000 (low w)) (distinct #x0000 (high w))))
(assert (and (bounds a0) (bounds a1) (bounds a2) (bounds b0) (bounds b1) (bounds b2)))

; ---- the reference
(define-fun s0 () Word (bvadd a0 b1))
(define-fun s1 () Word (bvadd a1 b0))
(define-fun s2 () Word (bvadd a2 (swap_halves b2)))
(define-fun reaches ((v Word) (l Word)) Bool
  (and (bvuge (low v) (low l)) (bvuge (high v) (high l))))
(define-fun portable () Bool (and (reaches s0 l0) (reaches s1 l1) (reaches s2 l2)))

; ---- plain words; UQSUB16
(define-fun word_plain ((v Word) (l Word)) Bool
  (and (bvuge v l) (bvuge (bvshl v #x00000010) (bvshl l #x00000010))))
(define-fun plain () Bool (and (word_plain s0 l0) (word_plain s1 l1) (word_plain s2 l2)))
(define-fun uqsub ((x Half) (y Half)) Half (ite (bvult x y) #x0000 (bvsub x y)))
(define-fun uqsub16 ((x Word) (y Word)) Word
  (concat (uqsub (high x) (high y)) (uqsub (low x) (low y))))
(define-fun dsp () Bool
  (= (bvor (uqsub16 l0 s0) (uqsub16 l1 s1) (uqsub16 l2 s2)) #x00000000))

; ---- vectors, by their 32-bit lanes: halves are added without carry
(define-fun add16 ((u Word) (v Word)) Word (concat (bvadd (high u) (high v)) (bvadd (low u) (low v))))
; SSE2: PSHUFD 0xE1 exchanges lanes 0 and 1; PUNPCKLQDQ puts the low lanes of z after those of xy; PCMPEQW with 0 and
; PMOVMSKB: all ones
(define-fun sse2 () Bool
  (and (= #x00000000 (uqsub16 l0 (add16 a0 b1))) (= #x00000000 (uqsub16 l1 (add16 a1 b0)))
       (= #x00000000 (uqsub16 l2 (add16 a2 (swap_halves b2))))
       (= #x00000000 (uqsub16 #x00000000 (add16 #x00000000 #x00000000)))))
; NEON: VREV64 exchanges the lanes of a pair; the ORed pairs as one number of 64 bits
(define-fun neon () Bool
  (= #x0000000000000000
     (bvor (concat (uqsub16 l1 (add16 a1 b0)) (uqsub16 l0 (add16 a0 b1)))
           (concat (uqsub16 #x00000000 (add16 #x00000000 #x00000000))
                   (uqsub16 l2 (add16 a2 (swap_halves b2)))))))

(check-sat-assuming ((distinct portable plain))) ; unsat: plain words differ
(check-sat-assuming ((distinct portable dsp))) ; unsat: UQSUB16 differs
(check-sat-assuming ((distinct portable sse2))) ; unsat: SSE2 differs
(check-sat-assuming ((distinct portable neon))) ; unsat: NEON differs
(check-sat-assuming (portable)) ; sat: boxes can overlap
(check-sat-assuming ((not portable))) ; sat: boxes can be disjoint
