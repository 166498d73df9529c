# From what longest_path.sh prints to the terms of the bound, "bound NAME VALUE" a line:
# flashbvh::RunCosts (bound.hpp), for poses that translate and for those that rotate;
# triangle-pair-general is for triangles with area that do not lie in one plane.
function term(name,    i) {
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

function read_walk(kind) {
  visit[kind] = term("visit")
  ascent[kind] = term("ascent")
  sibling[kind] = term("sibling")
  enter[kind] = term("fixed")
}

# The walk's own part of a run and of a pair of leaves: in at one end, out at the other.
function report(kind) {
  print "bound run-" kind, run + enter[kind]
  print "bound visit-" kind, visit[kind]
  print "bound ascent-" kind, ascent[kind]
  print "bound leaf-pair-" kind, again + enter[kind]
  print "bound later-sibling-" kind, sibling[kind]
}

$1 ~ /17TranslatedOverlap/ { read_walk("translated") }
$1 ~ /11RotatedTest/ { read_walk("rotated") }
$1 ~ /^general_/ { general = most(term("fixed"), term("triangle")) }
$1 ~ /^next_triangles/ { tests = most(term("fixed"), term("triangle")) }
$1 ~ /bound_run/ { again = term("walk"); test = term("test"); run = term("fixed") }
$1 ~ /bound_make_query/ { make = $2 }

END {
  if (failed || !again || !tests || !general || !make) {
    exit 1
  }
  report("translated")
  report("rotated")
  print "bound triangle-pair", test + tests
  print "bound triangle-pair-general", test + general
  print "bound make-query", make
}
