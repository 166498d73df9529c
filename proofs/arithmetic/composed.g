# composed poses: a product's defect is the sum of both and less than kRoundingDefect more, where it is not measured again
#
# a, b: defects of A and B; f: the norm of F, nine entries of half of 2^-22. By norms, of which
# |A|^2 <= 1 + a: |(AB + F)^T (AB + F) - 1| <= a |B|^2 + b + 2 |F| |A| |B| + |F|^2.
# code: src/lattice/pose.cpp | set_rotation(entries, defects > kMaxSummedDefect ? defect_of(entries) : defects);
# code: src/lattice/pose.cpp | defects += kRoundingDefect;
f = 3 * @2**(kDefectBits - kRotationBits - 1)@ / @2**kDefectBits@;
more = a * b + 2 * f * ((1 + a) * (1 + b)) + f * f;
{ a in [0,@kMaxSummedDefect@b-@kDefectBits@] /\ b in [0,@kMaxSummedDefect@b-@kDefectBits@]
  -> more in [0,@kRoundingDefect@b-@kDefectBits@] }
