# awk -f heap.awk: of the lines that `compare` prints, what each library keeps of a triangle, and
# what is allocated; means over the pairs of meshes.
$1 == "image" && $2 != "crate-brick" { bytes += $3; triangles += $4; ++pairs }
$1 == "heap" && $4 !~ /_/ {
  made[$4] += $5 / 2
  held[$4] += $6 / 2
  query[$4] += $7 / 2
}
function row(title, library, flash) {
  printf "%-9s  %15.1f  %15.1f  %21.0f  %19.2f\n", title, flash, held[library] / triangles,
    made[library] / pairs, query[library] / pairs
}
END {
  print "           bytes a triangle:                  allocations:"
  print "library             flash              RAM     to make two meshes    of a query, mean"
  row("flashbvh", "flashbvh", bytes / triangles)
  row("OPCODE", "opcode", 0)
  row("FCL", "fcl", 0)
  row("Bullet", "bullet", 0)
}
