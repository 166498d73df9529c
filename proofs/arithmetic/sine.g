# sine of up to an eighth of a turn is within 2^-29: polynomial and rounding together
#
# y: the angle in eighths of a turn; q: its square. t0 to t6: the terms of the sine's series, in intervals; `rest`: all
# terms after them, which is less than the next one (terms shrink and alternate). `off`: the polynomial less the series.
# c0 to c4: the code's coefficients; e1 to e3: its sums, exact; u0 to u3: the losses of the square and of each product
# by rounding down; f, g: half a unit added or lost by rounding to the nearest; d0 to d3: the errors of the code's sums.
# code: src/lattice/sine.hpp | constexpr int32_t s[5] = {
# code: src/lattice/sine.hpp | const int32_t square = times_high(y, y);
# code: src/lattice/sine.hpp | sine = s[i] + times_high(sine, square);
# code: src/lattice/sine.hpp | sine = s[0] + static_cast<int32_t>((static_cast<int64_t>(sine) * square + half) >> 32);
# code: src/lattice/sine.hpp | sine = static_cast<int32_t>((static_cast<int64_t>(sine) * y + (half >> 1)) >> 31);
c0 = @sine.hpp:s[0]@ / @2**30@; c1 = @sine.hpp:s[1]@ / @2**32@; c2 = @sine.hpp:s[2]@ / @2**34@;
c3 = @sine.hpp:s[3]@ / @2**36@; c4 = @sine.hpp:s[4]@ / @2**38@;
off = (c0 - t0) + q * ((c1 - t1) + q * ((c2 - t2) + q * ((c3 - t3) + q * ((c4 - t4) - q * (t5 + q * (t6 + rest))))));
e3 = c3 + q * c4; e2 = c2 + q * e3; e1 = c1 + q * e2;
d3 = - c4 * u0 - u3;
d2 = d3 * s - e3 * u0 - u2;
d1 = d2 * s - e2 * u0 - u1;
d0 = d1 * s - e1 * u0 + g;
{ y in [-1,1] /\ q in [0,1] /\ s in [0,1] /\ u0 in [0,1b-30] /\ u3 in [0,1b-36] /\ u2 in [0,1b-34] /\
  u1 in [0,1b-32] /\ |g| <= 1b-31 /\ |f| <= 1b-31 /\ |rest| <= 1e-12 /\
  t0 in [0.78539816339744830961,0.78539816339744830962] /\
  t1 in [-0.08074551218828078171,-0.08074551218828078170] /\
  t2 in [0.00249039457019272016,0.00249039457019272017] /\
  t3 in [-0.00003657620418217726,-0.00003657620418217725] /\
  t4 in [0.00000031336168903781,0.00000031336168903782] /\
  t5 in [-0.00000000175724767345,-0.00000000175724767344] /\
  t6 in [0.00000000000694845327,0.00000000000694845328]
  -> |(d0 + off) * y + f| <= 1b-29 }
$ q in 1024;
