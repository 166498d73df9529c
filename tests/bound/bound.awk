# From what longest_path.sh prints to the terms of the bound, "bound NAME VALUE" a line. A run of at
# most N visits that meets L pairs of leaves and tests P pairs of triangles takes at most
#   run + depths * ascent + (N - L) * (visit + ascent) + L * (visit + leaf-pair) + P * triangle-pair
# instructions, `depths` being the sum of the trees' depths. `arity`: the most children of a node.
function term(name) {
  for (i = 4; i <= NF; i += 2) {
    if ($i == name) {
      return $(i + 1)
    }
  }
  print "bound: no " name " in: " $0 | "cat >&2"
  failed = 1
  exit 1
}
function most(a, b) {
  return a > b ? a : b
}

$1 ~ /17TranslatedOverlap/ { walk("translated") }
$1 ~ /11RotatedTest/ { walk("rotated") }
function walk(kind) {
  visit[kind] = term("visit")
  ascent[kind] = term("ascent")
  enter[kind] = term("fixed") + 2 * (arity - 1) * term("sibling")
}
$1 ~ /next_triangles/ { tests = most(term("fixed"), term("triangle")) }
$1 ~ /bound_run/ { again = term("walk"); test = term("test"); run = term("fixed") }
$1 ~ /bound_make_query/ { make = $2 }

END {
  if (failed || !again || !tests || !make) {
    exit 1
  }
  for (n = 1; n <= 2; ++n) {
    kind = n == 1 ? "translated" : "rotated"
    print "bound run-" kind, run + enter[kind]
    print "bound visit-" kind, visit[kind]
    print "bound ascent-" kind, ascent[kind]
    print "bound leaf-pair-" kind, again + enter[kind]
  }
  print "bound triangle-pair", test + tests
  print "bound make-query", make
}
