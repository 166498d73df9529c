# awk -f table.awk: of the lines that `compare` prints, the ratios of flashbvh's times to the others',
# geometric means over the pairs of meshes, and in how many pairs of triangles, and by how much of a
# distance, the answers differ. Ends with 1 if a twentieth of the pairs does, or a distance by more
# than a cell: then something is set up wrong.

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

function range(motion, kind, ours, theirs,    i, r, least, most) {
  for (i = 1; i <= meshes; ++i) {
    r = ratio(name[i], motion, kind, ours, theirs)
    least = i == 1 || r < least ? r : least
    most = r > most ? r : most
  }
  return sprintf("%.2f to %.2f", least, most)
}

function row(motion, kind, title) {
  printf "%-10s  %-23s  %6.2f  %12s  %5.2f  %9.2f  %10.2f  %6.2f  %6s\n", motion, title,
    mean(motion, kind, "flashbvh", "opcode"), range(motion, kind, "flashbvh", "opcode"),
    mean(motion, kind, "flashbvh_alone", "opcode_alone"),
    mean(motion, kind, "flashbvh_pose", "opcode"), mean(motion, kind, "flashbvh", "opcode_one"),
    mean(motion, kind, "flashbvh", "fcl"),
    kind == "first" ? "-" : sprintf("%.3f", mean(motion, kind, "flashbvh", "bullet"))
}

function rows(motion) {
  row(motion, "separated", "separated")
  row(motion, "small", "small")
  row(motion, "close", "close")
  row(motion, "intersecting", "intersecting, all pairs")
  row(motion, "first", "intersecting, first hit")
}

function length_row(motion, kind) {
  printf "%-10s  %-9s  %6.2f  %12s  %6.2f  %6.2f  %12s\n", motion, kind,
    mean(motion, kind, "distance", "distance_fcl"),
    range(motion, kind, "distance", "distance_fcl"),
    mean(motion, kind, "distance", "distance_rss"),
    mean(motion, kind, "distance_seeded", "distance_fcl"),
    range(motion, kind, "distance_seeded", "distance_fcl")
}

function length_rows(motion) {
  length_row(motion, "separated")
  length_row(motion, "small")
  length_row(motion, "close")
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

$1 == "length" {
  poses[$3, $5] += $6
  differing[$3, $5] += $7
  if ($8 > farthest[$3, $5]) farthest[$3, $5] = $8
}

function lengths(motion, library, title) {
  printf "%-10s  %-15s  %5d  %9d  %8.2g\n", motion, title, poses[motion, library],
    differing[motion, library], farthest[motion, library]
  if (farthest[motion, library] > 1) wrong = 1
}

function all_lengths(motion) {
  lengths(motion, "distance_seeded", "flashbvh seeded")
  lengths(motion, "distance_fcl", "FCL, OBBRSS")
  lengths(motion, "distance_rss", "FCL, RSS")
}

function answers(motion, library, title) {
  printf "%-10s  %-8s  %8d  %8d  %9d\n", motion, title, found[motion, library],
    theirs[motion, library], alone[motion, library]
  if (library != "bullet" && 20 * alone[motion, library] > found[motion, library]) wrong = 1
}

END {
  if (meshes == 0) exit 1
  print "Time of a query of flashbvh, divided by another library's: below 1, flashbvh is faster."
  print ""
  print "                                       OPCODE                                             FCL  Bullet"
  print "B           class                      mean   of one pair  alone  pose made  one matrix    mean    mean"
  rows("translated")
  rows("rotated")
  print ""
  print "Pairs of triangles that intersect, under all poses:"
  print ""
  print "B           library   flashbvh   library   one alone"
  answers("translated", "opcode", "OPCODE")
  answers("translated", "fcl", "FCL")
  answers("translated", "bullet", "Bullet")
  answers("rotated", "opcode", "OPCODE")
  answers("rotated", "fcl", "FCL")
  answers("rotated", "bullet", "Bullet")
  print ""
  print "Time of a distance of flashbvh, divided by FCL's:"
  print ""
  print "                       OBBRSS                   RSS  seeded, OBBRSS"
  print "B           class        mean   of one pair    mean    mean   of one pair"
  length_rows("translated")
  length_rows("rotated")
  print ""
  print "Distances, beside flashbvh's; differing: by more than 1e-6 of it; the most, in cells:"
  print ""
  print "B           library          poses  differing      most"
  all_lengths("translated")
  all_lengths("rotated")
  if (wrong) print "The libraries were not asked the same: DIFFERS"
  exit wrong
}
