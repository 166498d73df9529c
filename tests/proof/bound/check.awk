# check.awk BOUND MEASURED: holds what the firmware measured against what was proven. Of each kind
# of run it prints the most instructions, the bound on that run, and the largest part of its own
# bound that a run of the kind took:
#   measured NAME INSTRUCTIONS of BOUND, nearest PART
# boxes-KIND-N: runs of N work that came to no pair of leaves; run-KIND-N: those that did.
FNR == NR {
  if ($1 == "bound") {
    value[$2] = $3
  }
  next
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
  what = $5 ? "run" : "boxes"
  # The trees are binary: a later sibling in each.
  hold(what "-" $2 "-" $3, $8, $2 == "itself" ? most_of_itself(value, $6, 2, $7, $3) : \
    most_instructions(value, $6, 2, $7, $3))
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
