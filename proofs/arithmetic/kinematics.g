# kinematics: products of frames fit 64 bits, results 32, and each entry is off by half of 2^-30
# code: src/lattice/fixed_point.hpp | return (sum + (kRotationOne >> 1)) >> 30;
# code: src/robot/kinematics.cpp | fixed_rounded(fixed_product(row[0], r[0][j]) + fixed_product(row[1], r[1][j]) + fixed_product(row[2], r[2][j]));
# Rotations' entries: at most 1 + 2^-8, which includes far more than rounding; translations: 30 bits.
@rnd = int<dn>;
sum = a * x + b * y + c * z;
exact = sum / @kRotationOne@;
entry = rnd(exact + 0.5);
moved = a * t + b * u + c * v;
{ |a| <= @kRotationOne + kRotationOne // 256@ /\ |b| <= @kRotationOne + kRotationOne // 256@ /\ |c| <= @kRotationOne + kRotationOne // 256@ /\
  |x| <= @kRotationOne + kRotationOne // 256@ /\ |y| <= @kRotationOne + kRotationOne // 256@ /\ |z| <= @kRotationOne + kRotationOne // 256@ /\
  |t| <= @2 * kMaxFrameTranslation@ /\ |u| <= @2 * kMaxFrameTranslation@ /\ |v| <= @2 * kMaxFrameTranslation@
  -> |sum| <= @INT64_MAX@ /\ |moved| <= @INT64_MAX@ /\
     entry - exact in [-0.5,0.5] }
entry - exact -> (entry - (exact + 0.5)) + 0.5;
