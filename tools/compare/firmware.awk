# awk -f firmware.awk: of the lines that compare_firmware prints, instructions a query.
{ core = $1; mean[$2, $3, $4] = $5; most[$2, $3, $4] = $6; found[$2, $3, $4] = $7 }
function row(motion, class, title,    i, library, line) {
  line = sprintf("%-10s  %-23s", motion, title)
  for (i = split("float opcode flashbvh", library); i > 0; --i)
    line = line sprintf("  %9d  %9d", mean[motion, class, library[i]], most[motion, class, library[i]])
  print line
}
END {
  if (core == "") exit 1
  printf "%s, instructions a query\n\n", core
  print "                                                  flashbvh                OPCODE         a tree in floats"
  print "B           class                         mean       most       mean       most       mean       most"
  for (i = 1; i <= 2; ++i) {
    motion = i == 1 ? "translated" : "rotated"
    row(motion, "separated", "separated")
    row(motion, "small", "small")
    row(motion, "close", "close")
    row(motion, "intersecting", "intersecting, all pairs")
    row(motion, "first", "intersecting, first hit")
  }
  printf "pairs found: flashbvh %d and %d, OPCODE %d and %d, the tree in floats %d and %d\n\n",
    found["translated", "intersecting", "flashbvh"], found["rotated", "intersecting", "flashbvh"],
    found["translated", "intersecting", "opcode"], found["rotated", "intersecting", "opcode"],
    found["translated", "intersecting", "float"], found["rotated", "intersecting", "float"]
}
