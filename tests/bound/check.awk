# check.awk BOUND MEASURED: holds what the firmware measured against what was proven.
FNR == NR {
  if ($1 == "bound") {
    value[$2] = $3
  }
  next
}

# The bound on a run of which it is known what it did.
function bound_of(kind, visits, leaf_pairs, pairs, depths) {
  return value["run-" kind] + depths * value["ascent-" kind] + \
    (visits - leaf_pairs) * (value["visit-" kind] + value["ascent-" kind]) + \
    leaf_pairs * (value["visit-" kind] + value["leaf-pair-" kind]) + pairs * value["triangle-pair"]
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
    printf "measured %s %d, bound of that run %d; nearest to its bound: %.2f\n", name, most[name],
      bound_at[name], nearest[name] | "sort"
  }
  close("sort")
  if (held < 1000) {
    print "too little was measured"
    exit 1
  }
  print held " measured, " over + 0 " over the bound"
  exit over != 0
}
