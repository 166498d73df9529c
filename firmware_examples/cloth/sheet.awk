# awk -v columns=N -v rows=N -v pitch=MM -v lean=MM -v height=MM -f sheet.awk: a square-meshed sheet in
# OBJ, in millimetres, 2 * columns * rows triangles, their diagonals in turns. It stands on one edge
# along y, `height` over the origin, and leans: each column is `lean` further along x.
BEGIN {
  up = sqrt(pitch * pitch - lean * lean)
  for (j = 0; j <= rows; ++j) {
    for (i = 0; i <= columns; ++i) {
      printf "v %.3f %.3f %.3f\n", i * lean, (j - rows / 2) * pitch, height + i * up
    }
  }
  for (j = 0; j < rows; ++j) {
    for (i = 0; i < columns; ++i) {
      a = j * (columns + 1) + i + 1
      b = a + 1
      c = a + columns + 1
      d = c + 1
      if ((i + j) % 2 == 0) {
        print "f", a, b, c
        print "f", b, d, c
      } else {
        print "f", a, b, d
        print "f", a, d, c
      }
    }
  }
}
