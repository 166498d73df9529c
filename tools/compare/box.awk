# awk -v x=X -v y=Y -v z=Z -f box.awk: a box about the origin, its sides twice these, as OBJ.
BEGIN {
  for (i = 0; i < 8; ++i) printf "v %d %d %d\n", (i % 2 ? x : -x), (int(i / 2) % 2 ? y : -y), (i > 3 ? z : -z)
  n = split("1 3 4 2, 5 6 8 7, 1 2 6 5, 3 7 8 4, 1 5 7 3, 2 4 8 6", side, ", ")
  for (i = 1; i <= n; ++i) {
    split(side[i], c, " ")
    print "f", c[1], c[2], c[3] "\nf", c[1], c[3], c[4]
  }
}
