# check.awk BOUND MEASURED: holds what the firmware measured against what was proven. Of each kind
# of run it prints the most instructions, the bound on that run, and the largest part of its own
# bound that a run of the kind took:
#   measured NAME INSTRUCTIONS of BOUND, nearest PART
# boxes-KIND-N: runs of N visits that met no pair of leaves; run-KIND-N: those that did.
FNR == NR {
  if ($1 == "bound") {
    value[$2] = $3
  }
  next
}

# flashbvh::most_instructions(), of a run of which it is known what it did. The trees are binary.
function bound_of(kind, visits, leaf_pairs, pairs, depths,    walk) {
  walk = 2 * value["later-sibling-" kind]
  return value["run-" kind] + walk + (depths + visits - leaf_pairs) * value["ascent-" kind] + \
    visits * value["visit-" kind] + leaf_pairs * (value["leaf-pair-" kind] + walk) + \
    pairs * value["triangle-pair"]
}

function hold(name, measured, bound) {
  ++held
  if (measured > most[name]) {
    most[name] = measured
    bound_at[name] = bound
  }
  if (measured / bound > nearest[name]) {
    nearest[name] = measured / bound
  }
  if (measured > bound) {
    print "OVER THE BOUND of " bound ": " $0
    ++over
  }
}

$1 == "run" {
  kind = $2 ? "rotated" : "translated"
  what = $5 + $6 ? "run" : "boxes"
  hold(what "-" kind "-" $3, $8, bound_of(kind, $4, $5, $6, $7))
}
$1 == "make" {
  hold("make-query", $2, value["make-query"])
}

END {
  for (name in most) {
    printf "measured %s %d of %d, nearest %.2f\n", name, most[name], bound_at[name],
      nearest[name] | "sort"
  }
  close("sort")
  if (held < 1000) {
    print "too little was measured"
    exit 1
  }
  print held " measured, " over + 0 " over the bound"
  exit over != 0
}
