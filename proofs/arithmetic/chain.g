# kinematics: a joint adds less than 2^-27 to the norm of a rotation's error, in a chain of kMaxJoints
#
# e: the error so far, of its parent's rotation. By norms: a product of two rotations with errors e and f has the error
# e (1 + f) + f, and rounding n entries by half of 2^-30 adds sqrt(n) 2^-31. The joint's own rotation is rounded, too;
# `turn`: sine and cosine, each within 2^-29 (sine.g, cosine.g).
# code: src/robot/kinematics.cpp | frames[i] = joined(frames[joint.parent], joint.fixed);
# code: src/robot/kinematics.cpp | row[0] = fixed_rounded(fixed_product(x, at.cosine) + fixed_product(y, at.sine));
# code: src/robot/kinematics.cpp | row[1] = fixed_rounded(fixed_product(y, at.cosine) - fixed_product(x, at.sine));
# code: src/lattice/fixed_point.hpp | return (sum + (kRotationOne >> 1)) >> 30;
nine = 3 / @2 * kRotationOne@;
six = 2.44949 / @2 * kRotationOne@;
turn = 1.414214 * 1b-29;
composed = e * nine + nine + nine;                  # in addition to e
more = composed + (e + composed) * turn + turn + six;
{ e in [0,@kMaxJoints@b-27] -> more in [0,1b-27] }
