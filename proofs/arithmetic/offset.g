# where B's origin lies: the sum of its rotation and the translation is below 2^54
# code: src/bounds/rotated_transform.cpp | const int32_t fraction = pose.fraction(axis) * (1 << (kRotationBits - 16));
# code: src/bounds/rotated_transform.cpp | const int64_t sum = fraction + (1 << (kRestBits - 1)) + product(x, origin_b[0]) + product(y, origin_b[1]) + product(z, origin_b[2]) + product(cells, 1 << kRotationBits);
# `cells`: 32 bits. Entries: at most 1 + 2^-13 (pose.cpp refuses others).
t1 = cells * @2**kRotationBits@;
t2 = part * @2**(kRotationBits - 16)@;
s = t1 + t2 + @2**(kRestBits - 1)@ + x * u + y * v + z * w;
{ |cells| <= @2**31@ /\ |part| <= @2**15@ /\ |x| <= @2**kRotationBits + 2**9@ /\
  |y| <= @2**kRotationBits + 2**9@ /\ |z| <= @2**kRotationBits + 2**9@ /\
  |u| <= @kMaxOrigin@ /\ |v| <= @kMaxOrigin@ /\ |w| <= @kMaxOrigin@
  -> |s| <= @2**54@ }
