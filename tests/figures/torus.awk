# awk -v around=N -v across=N -v ring=R -v tube=R -f torus.awk: a torus round the z axis in OBJ, its
# 2 * around * across triangles on whole numbers.
function rounded(value) {
  return int(value < 0 ? value - 0.5 : value + 0.5)
}

function vertex(i, j) {
  return (i % around) * across + j % across + 1
}

BEGIN {
  turn = 6.283185307179586
  for (i = 0; i < around; ++i) {
    for (j = 0; j < across; ++j) {
      radius = ring + tube * cos(turn * j / across)
      print "v", rounded(radius * cos(turn * i / around)), rounded(radius * sin(turn * i / around)),
        rounded(tube * sin(turn * j / across))
    }
  }
  for (i = 0; i < around; ++i) {
    for (j = 0; j < across; ++j) {
      print "f", vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)
      print "f", vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)
    }
  }
}
