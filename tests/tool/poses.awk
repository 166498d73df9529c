# awk -v count=N -v seed=S -v reach=R -f poses.awk: N poses, one a line, of 17 digits: a unit
# quaternion of any direction, every fourth about an axis by whole quarters, and a translation within
# +-R.
function entries(w, x, y, z) {
  r[1] = w * w + x * x - y * y - z * z; r[2] = 2 * (x * y - z * w); r[3] = 2 * (x * z + y * w)
  r[4] = 2 * (x * y + z * w); r[5] = w * w - x * x + y * y - z * z; r[6] = 2 * (y * z - x * w)
  r[7] = 2 * (x * z - y * w); r[8] = 2 * (y * z + x * w); r[9] = w * w - x * x - y * y + z * z
}
function between(size) { return size * (2 * rand() - 1) }
BEGIN {
  srand(seed)
  for (n = 0; n < count; ++n) {
    for (i = 0; i < 4; ++i) q[i] = n % 4 == 0 ? 0 : between(1)
    if (n % 4 == 0) q[1 + int(rand() * 3)] = int(rand() * 3) - 1
    if (n % 4 == 0) q[0] = 1
    length2 = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])
    entries(q[0] / length2, q[1] / length2, q[2] / length2, q[3] / length2)
    line = ""
    for (i = 1; i <= 9; ++i) line = line sprintf("%.17g ", r[i])
    for (i = 0; i < 3; ++i) line = line sprintf("%.17g ", between(reach))
    print line
  }
}
