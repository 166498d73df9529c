# awk -f stand_ins.awk: of the lines that `compare` prints, how often what stands in for a mesh says
# that it collides, in percent of the poses of a class; in the last one that is the truth.
$1 == "stand_in" {
  poses[$5, $4] += $6
  alarms[$5, $4] += $7
  bytes[$5] += $8
  ++lines[$5]
}
function share(kind, class) { return 100 * alarms[kind, class] / poses[kind, class] }
function row(title, kind) {
  printf "%-31s  %6.0f  %8.1f  %8.1f  %8.1f  %14.1f\n", title, bytes[kind] / lines[kind],
    share(kind, "separated"), share(kind, "small"), share(kind, "close"),
    100 - share(kind, "intersecting")
}
END {
  print "                                          false alarms, % of the poses:   collisions missed,"
  print "A and B each as                   bytes  separated    small    close  % of those that are"
  row("a capsule", "capsule")
  row("32 spheres", "spheres")
  row("a convex hull", "hull")
  row("A a field 24 x 24 x 24, B points", "field")
}
