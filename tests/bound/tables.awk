# See tables.sh.
$1 == "core" {
  core = $2
  known = core in seen
  if (!known) {
    seen[core] = 1
    name[++cores] = core
  }
}

$1 == "bound" && !known { value["bound", $2, core] = $3 }
$1 == "measured" && !known {
  sub(/,$/, "", $5)
  value["measured", $2, core] = $3 " of " $5
}

function line(title, kind, key,    i) {
  printf "| %s |", title
  for (i = 1; i <= cores; ++i) {
    printf " %s |", value[kind, key, name[i]]
  }
  printf "\n"
}

function head(title,    i) {
  printf "| %s |", title
  for (i = 1; i <= cores; ++i) {
    printf " %s |", name[i]
  }
  printf "\n|---|"
  for (i = 1; i <= cores; ++i) {
    printf "---|"
  }
  printf "\n"
}

END {
  head("at most, proven")
  line("`run`, moved", "bound", "run-translated")
  line("`visit`, moved", "bound", "visit-translated")
  line("`ascent`, moved", "bound", "ascent-translated")
  line("`leaf_pair`, moved", "bound", "leaf-pair-translated")
  line("`run`, turned", "bound", "run-rotated")
  line("`visit`, turned", "bound", "visit-rotated")
  line("`ascent`, turned", "bound", "ascent-rotated")
  line("`leaf_pair`, turned", "bound", "leaf-pair-rotated")
  line("`later_sibling`", "bound", "later-sibling-rotated")
  line("`triangle_pair`", "bound", "triangle-pair")
  line("`triangle_pair`, general position", "bound", "triangle-pair-general")
  line("making a query", "bound", "make-query")
  printf "\n"
  head("measured, of the bound on that run")
  for (visits = 1; visits <= 100; visits *= 10) {
    line("boxes alone, moved, N = " visits, "measured", "boxes-translated-" visits)
    line("boxes alone, turned, N = " visits, "measured", "boxes-rotated-" visits)
    line("pairs of leaves, too, moved, N = " visits, "measured", "run-translated-" visits)
    line("pairs of leaves, too, turned, N = " visits, "measured", "run-rotated-" visits)
  }
}
