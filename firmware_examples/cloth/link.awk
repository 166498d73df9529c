# awk -v around=N -v rings=N -v parts=N -v radius=MM -v tube=MM -f link.awk: a link with rounded ends
# along y in OBJ, in millimetres: two half balls of `rings` rings and between them a tube in `parts`.
function rounded(value) {
  return int(value < 0 ? value * 100 - 0.5 : value * 100 + 0.5) / 100
}

function ring(y, r,    i, turn) {
  for (i = 0; i < around; ++i) {
    turn = 6.283185307179586 * i / around
    print "v", rounded(r * sin(turn)), rounded(y), rounded(r * cos(turn))
  }
}

function vertex(row, i) {
  return row * around + i % around + 2
}

BEGIN {
  quarter = 1.5707963267948966
  print "v", 0, -tube / 2 - radius, 0
  for (i = 1; i <= rings; ++i) {
    turn = quarter * i / rings
    ring(-tube / 2 - radius * cos(turn), radius * sin(turn))
  }
  for (i = 1; i < parts; ++i) {
    ring(tube * (i / parts - 0.5), radius)
  }
  for (i = rings; i >= 1; --i) {
    turn = quarter * i / rings
    ring(tube / 2 + radius * cos(turn), radius * sin(turn))
  }
  print "v", 0, tube / 2 + radius, 0
  rows = 2 * rings + parts - 1
  last = rows * around + 2
  for (i = 0; i < around; ++i) {
    print "f", 1, vertex(0, i + 1), vertex(0, i)
    print "f", last, vertex(rows - 1, i), vertex(rows - 1, i + 1)
    for (j = 0; j < rows - 1; ++j) {
      print "f", vertex(j, i), vertex(j + 1, i + 1), vertex(j + 1, i)
      print "f", vertex(j, i), vertex(j, i + 1), vertex(j + 1, i + 1)
    }
  }
}
