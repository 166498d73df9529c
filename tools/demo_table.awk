# Prints the firmware's result lines as tables, a pair of links and an offset each, and compares
# each with the host's line. Status 1 if one differs or the traversals of a table do not agree.
BEGIN {
  while ((getline line < host) > 0) {
    on_host[++hosts] = line
  }
}
$1 == "result" {
  ++results
  title = $2 " against " $3 ", moved by " $4 " " $5 " " $6 " m"
  if (title != last) {
    printf "\n%s\n%-18s %8s %9s %11s %15s %12s   %s\n", title, "algorithm", "visits", "overlaps",
      "leaf pairs", "triangle pairs", "stack bytes", "same as the host"
    last = title
    pairs = $10 " " $11
  }
  same = ($1 " " $2 " " $3 " " $4 " " $5 " " $6 " " $7 " " $8 " " $9 " " $10 " " $11) == on_host[results]
  if (!same || pairs != $10 " " $11) {
    bad = 1
  }
  printf "%-18s %8d %9d %11d %15d %12d   %s\n", $7, $8, $9, $10, $11, $12, same ? "yes" : "DIFFERS"
}
$1 == "stack" { printf "\nDeepest stack of a query: %d bytes\n", $2 }
END { exit bad || results == 0 || results != hosts }
