# Prints the firmware's lines (firmware_examples/robot_arm/main.cpp) as tables: a configuration each,
# then the traversals. Compares each result with the host's line. Status 1 if one differs, if one
# side has another number of them, or if two traversals of a pair find other triangles.
BEGIN {
  split("base_link shoulder bicep elbow forearm wrist palm", chain, " ")
  for (i = 1; i < 7; ++i) neighbours[chain[i] " " chain[i + 1]] = 1
  print "\nLinks next to each other share a bearing: there they intersect in every configuration. Whether the"
  print "arm hits itself is asked of the other pairs. Neighbours are shown once, at home, for what they cost."
  print "ms: at 168 MHz and one instruction a cycle; wait states of the flash come on top."
  while ((getline line < host) > 0) {
    on_host[line] = 1
    ++hosts
  }
}
$1 == "arm" {
  angles = $3 " " $4 " " $5 " " $6 " " $7 " " $8
}
$1 == "answer" {
  end_configuration()
  printf "\n%s: joints at %s degrees\n", name($2), angles
  head()
  answer = $3
  check = $4
  ++configurations
  hits += answer == "yes"
}
$1 == "kinematics" { kinematics = $3 }
$1 == "result" {
  ++results
  same = ($1 " " $2 " " $3 " " $4 " " $5 " " $6 " " $7 " " $8 " " $9) in on_host
  pair = $2 " " $3 " " $4
  if (pair != last) {
    end_pair()
    last = pair
    row = columns($3 " against " $4 (($3 " " $4) in neighbours ? " *" : ""), $6, $7, $8, $9, $11, $10)
    beside += ($3 " " $4) in neighbours
    visits_of_row = $6
    pairs_found = $9
    row_is_same = 1
  }
  if (pairs_found != $9) same = 0
  if (!($5 in visits)) order[++traversals] = $5
  visits[$5] += $6
  overlaps[$5] += $7
  leaf_pairs[$5] += $8
  found[$5] += $9
  instructions[$5] += $11
  if ($10 > deepest[$5]) deepest[$5] = $10
  if (!same) {
    differs[$5] = bad = 1
    row_is_same = 0
  }
}
function head() {
  printf "%-30s %7s %8s %6s %9s %12s %7s %5s  %s\n", "", "visits", "overlaps", "leaf", "triangle",
    "instructions", "ms", "stack", "same as"
  printf "%-30s %7s %8s %6s %9s %12s %7s %5s  %s\n", "", "", "", "pairs", "pairs", "", "", "bytes", "the host"
}
function columns(what, visited, overlapped, leaves, triangles, instructed, stack) {
  return sprintf("  %-28s %7d %8d %6d %9d %12d %7.2f %5d  ", what, visited, overlapped, leaves, triangles,
    instructed, milliseconds(instructed), stack)
}
function milliseconds(instructed) { return instructed / 168000 }
function name(text) { gsub(/_/, " ", text); return text }
# A row a pair; those that were disjoint at the roots are only counted.
function end_pair() {
  if (last == "") return
  if (visits_of_row == 1 && row_is_same) ++disjoint
  else print row (row_is_same ? "yes" : "DIFFERS")
  last = ""
}
function end_configuration() {
  end_pair()
  if (answer == "") return
  if (disjoint) printf "  %d pairs of links disjoint after one visit, on both\n", disjoint
  if (beside) print "  * neighbours, which share a bearing: not asked about"
  printf "  Does it hit itself? %s: %d instructions for the answer, %.2f ms, of these %d for the kinematics\n",
    answer == "yes" ? "YES" : "no", check, milliseconds(check), kinematics
  disjoint = beside = 0
}
END {
  end_configuration()
  printf "\n%d of %d configurations hit. All of their questions, by traversal:\n", hits, configurations
  head()
  for (i = 1; i <= traversals; ++i) {
    t = order[i]
    print columns(t, visits[t], overlaps[t], leaf_pairs[t], found[t], instructions[t], deepest[t]) \
      (differs[t] ? "DIFFERS" : "yes")
  }
  print "Instructions: of whole queries, poses prepared and triangles tested. Stack: of a call of run()."
  if (results != hosts) print "demo: " results + 0 " results of the board, " hosts + 0 " of the host"
  exit bad || results == 0 || results != hosts
}
