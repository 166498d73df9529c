# awk -f table.awk: of the lines that `compare` prints, the ratios of flashbvh's times to the others',
# geometric means over the pairs of meshes, and in how many pairs of triangles the answers differ.
# Ends with 1 if a twentieth does: then something is set up wrong.

# The ratio of two libraries' times, each pair of meshes weighing the same.
function mean(motion, kind, ours, theirs,    i, logs) {
  for (i = 1; i <= meshes; ++i) {
    logs += log(ratio(name[i], motion, kind, ours, theirs))
  }
  return exp(logs / meshes)
}

function ratio(pair, motion, kind, ours, theirs) {
  return time[pair, motion, kind, ours] / time[pair, motion, kind, theirs]
}

function range(motion, kind,    i, r, least, most) {
  for (i = 1; i <= meshes; ++i) {
    r = ratio(name[i], motion, kind, "flashbvh", "opcode")
    least = i == 1 || r < least ? r : least
    most = r > most ? r : most
  }
  return sprintf("%.2f to %.2f", least, most)
}

function row(motion, kind, title) {
  printf "%-10s  %-23s  %6.2f  %12s  %9.2f  %10.2f  %6.2f\n", motion, title,
    mean(motion, kind, "flashbvh", "opcode"), range(motion, kind),
    mean(motion, kind, "flashbvh_pose", "opcode"), mean(motion, kind, "flashbvh", "opcode_one"),
    mean(motion, kind, "flashbvh", "fcl")
}

function rows(motion) {
  row(motion, "separated", "separated")
  row(motion, "small", "small")
  row(motion, "close", "close")
  row(motion, "intersecting", "intersecting, all pairs")
  row(motion, "first", "intersecting, first hit")
}

$1 == "time" {
  if (!($2 in known)) {
    known[$2]
    name[++meshes] = $2
  }
  time[$2, $3, $4, $5] = $6
}
$1 == "pairs" {
  found[$3, $4] += $5
  theirs[$3, $4] += $6
  alone[$3, $4] += $7
}

function answers(motion, library, title) {
  printf "%-10s  %-8s  %8d  %8d  %9d\n", motion, title, found[motion, library],
    theirs[motion, library], alone[motion, library]
  if (20 * alone[motion, library] > found[motion, library]) wrong = 1
}

END {
  if (meshes == 0) exit 1
  print "Time of a query of flashbvh, divided by another library's: below 1, flashbvh is faster."
  print ""
  print "                                       OPCODE                                      FCL"
  print "B           class                      mean   of one pair  pose made  one matrix    mean"
  rows("translated")
  rows("rotated")
  print ""
  print "Pairs of triangles that intersect, under all poses:"
  print ""
  print "B           library   flashbvh   library   one alone"
  answers("translated", "opcode", "OPCODE")
  answers("translated", "fcl", "FCL")
  answers("rotated", "opcode", "OPCODE")
  answers("rotated", "fcl", "FCL")
  if (wrong) print "The libraries were not asked the same: DIFFERS"
  exit wrong
}
