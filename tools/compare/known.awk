# awk -f known.awk: of the lines that `compare` prints, how many questions with known answers each
# library answers wrongly; the boxes, then the other meshes together.
$1 == "known" && !seen[$2, $3, $4]++ {
  kind = $2 " " ($3 ~ /^(crate|brick)/ ? "boxes" : "others")
  asked[kind, $4] += $5
  wrong[kind, $4] += $6
}
function cell(kind, library) {
  return (kind, library) in asked ? wrong[kind, library] " of " asked[kind, library] : "-"
}
function row(title, kind) {
  printf "%-44s  %-10s  %12s  %13s  %10s  %13s\n", title, substr(kind, index(kind, " ") + 1),
    cell(kind, "flashbvh"), cell(kind, "opcode"), cell(kind, "fcl"), cell(kind, "bullet")
}
END {
  printf "%-44s  %-10s  %12s  %13s  %10s  %13s\n", "wrong answers", "meshes", "flashbvh", "OPCODE", "FCL", "Bullet"
  split("boxes others", of_)
  for (i = 1; i <= 2; ++i) {
    row("touching in a vertex, an edge or a face", "touching " of_[i])
    row("the same, a cell farther off", "gap " of_[i])
    if (i == 1) row("distance, to a millionth", "distance boxes")
    row("a ray through a vertex", "vertex " of_[i])
    row("a ray through the middle of an edge", "edge " of_[i])
    row("a ray past a vertex, a cell or less off", "beside " of_[i])
  }
}
