# cosine of up to an eighth of a turn is within 2^-29: polynomial and rounding together
#
# y: the angle in eighths of a turn; q: its square. t0 to t6: the terms of the cosine's series, in intervals; `rest`:
# all terms after them, which is less than the next one (terms shrink and alternate). `off`: the polynomial less the
# series. c0 to c4: the code's coefficients; e1 to e3: its sums, exact; u0 to u3: the losses of the square and of each
# product by rounding down; f, g: half a unit added or lost by rounding to the nearest; d0 to d3: the errors of the
# code's sums.
# code: src/lattice/sine.hpp | constexpr int32_t c[5] = {
# code: src/lattice/sine.hpp | const int32_t square = times_high(y, y);
# code: src/lattice/sine.hpp | cosine = c[i] + times_high(cosine, square);
# code: src/lattice/sine.hpp | cosine = c[0] + static_cast<int32_t>((static_cast<int64_t>(cosine) * square + half) >> 32);
c0 = @sine.hpp:c[0]@ / @2**30@; c1 = @sine.hpp:c[1]@ / @2**32@; c2 = @sine.hpp:c[2]@ / @2**34@;
c3 = @sine.hpp:c[3]@ / @2**36@; c4 = @sine.hpp:c[4]@ / @2**38@;
off = (c0 - 1) + q * ((c1 - t1) + q * ((c2 - t2) + q * ((c3 - t3) + q * ((c4 - t4) - q * (t5 + q * (t6 + rest))))));
e3 = c3 + q * c4; e2 = c2 + q * e3; e1 = c1 + q * e2;
d3 = - c4 * u0 - u3;
d2 = d3 * s - e3 * u0 - u2;
d1 = d2 * s - e2 * u0 - u1;
d0 = d1 * s - e1 * u0 + g;
{ y in [-1,1] /\ q in [0,1] /\ s in [0,1] /\ u0 in [0,1b-30] /\ u3 in [0,1b-36] /\ u2 in [0,1b-34] /\
  u1 in [0,1b-32] /\ |g| <= 1b-31 /\ |f| <= 1b-31 /\ |rest| <= 1e-12 /\
  t1 in [-0.30842513753404245684,-0.30842513753404245683] /\
  t2 in [0.01585434424381550085,0.01585434424381550086] /\
  t3 in [-0.00032599188692739002,-0.00032599188692739001] /\
  t4 in [0.00000359086044859151,0.00000359086044859152] /\
  t5 in [-0.00000002461136950495,-0.00000002461136950494] /\
  t6 in [0.00000000011501159127,0.00000000011501159128]
  -> |d0 + off| <= 1b-29 }
$ q in 64;
