#!/bin/sh
# info, check and export agree with what was baked.
. "$SOURCES/common.sh"

cat >mesh.obj <<'OBJ'
v 0.24 -0.26 0
v 10 0.5 -0.5
v 3.74 10.01 1.5
v 0.3 -0.2 4
v 9.99 9.99 9.99
f 3 2 1
f 1 2 4
f 5 4 2
OBJ
"$FLASHBVH" bake mesh.obj -o baked --cell 0.5 --leaf-size 1 >table
"$FLASHBVH" export --cells baked/mesh.fbvh -o lattice.obj
# Corner by corner in source order: round(coordinate / 0.5), halves away from zero.
awk '$1 == "v" { v[++n] = $2 " " $3 " " $4 } $1 == "f" { print v[$2]; print v[$3]; print v[$4] }' \
  lattice.obj >found
awk 'function cells(x) { x /= 0.5; return x < 0 ? -int(0.5 - x) : int(x + 0.5) }
  $1 == "v" { v[++n] = cells($2) " " cells($3) " " cells($4) }
  $1 == "f" { print v[$2]; print v[$3]; print v[$4] }' mesh.obj | sed 's/-0/0/g' >wanted
cmp wanted found
# Corners that --deformable turned are the mesh's, and make refits cheaper.
"$FLASHBVH" bake mesh.obj -o soft --cell 0.5 --deformable >/dev/null
"$FLASHBVH" bake mesh.obj -o hard --cell 0.5 >/dev/null
"$FLASHBVH" check soft/mesh.fbvh --mesh mesh.obj
refit() { "$FLASHBVH" info "$1/mesh.fbvh" | awk '/^refit instructions/ { print $3 }'; }
[ "$(refit soft)" -lt "$(refit hard)" ]
# Halves of a cell go up.
"$FLASHBVH" export --cells baked/mesh.fbvh -o translated.obj --pose "1 0 0 0 1 0 0 0 1 1.25 -1.25 100"
awk '$1 == "v" { print $2 - 3, $3 + 2, $4 - 200 } $1 == "f" { print }' translated.obj >found
awk '$1 == "v" { print $2, $3, $4 } $1 == "f" { print }' lattice.obj >wanted
cmp wanted found
"$FLASHBVH" export --cells baked/mesh.fbvh -o rotated.obj --pose "0 -1 0 1 0 0 0 0 1 1.25 -1.25 100"
awk '$1 == "v" { print $3 + 2, 3 - $2, $4 - 200 } $1 == "f" { print }' rotated.obj >found
cmp wanted found

# Rotated any way, near A or a kilometre off, and however far B is from its own origin: each
# coordinate is what the pose's numbers give, rounded, give or take 1/100 cell (and what 22 bits of
# a rotation are at that distance).
awk '$1 == "v" { $2 += 30000; $3 -= 2000000; $4 += 7 } { print }' lattice.obj >distant.obj
"$FLASHBVH" bake distant.obj -o distant --cell 1 >/dev/null
"$FLASHBVH" export --cells distant/distant.fbvh -o distant_lattice.obj
# transformed_right IMAGE LATTICE.obj CELL SLACK REACH
transformed_right() {
  python3 "$SOURCES/poses.py" 20 3 "$5" >transformed_poses
  while read -r pose; do
    "$FLASHBVH" export --cells "$1" -o rotated.obj --pose "$pose"
    awk -v pose="$pose" -v cell="$3" -v slack="$4" '
      BEGIN { split(pose, p, " ") }
      FNR == NR { if ($1 == "v") { x[++n] = $2; y[n] = $3; z[n] = $4 } next }
      $1 == "v" {
        ++m
        for (i = 0; i < 3; ++i) {
          off = p[3 * i + 1] * x[m] + p[3 * i + 2] * y[m] + p[3 * i + 3] * z[m] + p[10 + i] / cell
          off -= $(2 + i)
          if (off > 0.5 + slack || off < -0.5 - slack) { print FILENAME, $0, off; bad = 1 }
        }
      }
      END { exit bad || m == 0 || m != n }' "$2" rotated.obj || fail "misplaced by $pose"
  done <transformed_poses
}
transformed_right baked/mesh.fbvh lattice.obj 0.5 0.01 30
transformed_right baked/mesh.fbvh lattice.obj 0.5 0.01 1e6
transformed_right distant/distant.fbvh distant_lattice.obj 1 1 100

# The exported mesh bakes to itself.
"$FLASHBVH" bake lattice.obj -o again --cell 1 >/dev/null
"$FLASHBVH" export --cells again/lattice.fbvh -o again.obj
"$FLASHBVH" check again/lattice.fbvh --mesh lattice.obj >/dev/null

for options in "--layout post" "--layout pre" "--leaf-size 4 --arity 3" "--builder median" \
  "--builder median --leaf-size 3 --arity 8" "--builder sah --arity 2" "--index-bits 32 --layout pre"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o rings $options >/dev/null
  exits 0 check rings/ring.fbvh
  exits 0 check rings/ring.fbvh --mesh meshes/ring.stl
  grep -q '^ring: well-formed' stdout || fail "$(cat stdout)"
  exits 1 check rings/ring.fbvh --mesh meshes/coarse.stl
  grep -q 'but not' stdout || fail "$(cat stdout)"
done
# One corner moved by one cell, or two triangles changed round: another mesh.
sed 's/^v 9.99 9.99 9.99$/v 9.99 9.99 9.49/' mesh.obj >moved_corner.obj
exits 1 check baked/mesh.fbvh --mesh moved_corner.obj
grep -q 'corner 0 of triangle 2 lies at (20 20 20) in the image, at (20 20 19)' stdout ||
  fail "$(cat stdout)"
{ grep '^v' mesh.obj; grep '^f' mesh.obj | sort; } >other_order.obj
exits 1 check baked/mesh.fbvh --mesh other_order.obj
exits 2 check baked/mesh.fbvh --mesh missing.obj

info=$("$FLASHBVH" info baked/mesh.fbvh --json)
size=$(wc -c <baked/mesh.fbvh)
for wanted in '"name":"mesh"' '"layout":"post"' '"index_bits":16' '"nodes":4' '"leaves":3' \
  '"depth":1' '"triangles":3' '"vertices":5' '"leaf_size":1' '"arity":3' "\"bytes\":$((size))" \
  '"cell":0.5' '"box":{"lower":[0.0,-0.5,-0.5],"upper":[10.0,10.0,10.0]}' \
  '"box_cells":{"lower":[0,-1,-1],"upper":[20,20,20]}' '"stack_need":2'; do
  case $info in
    *"$wanted"*) ;;
    *) fail "no $wanted in $info" ;;
  esac
done
"$FLASHBVH" info baked/mesh.fbvh >text
for wanted in nodes depth 'bytes per triangle' box deviation; do
  grep -q "^$wanted  " text || fail "no $wanted in $(cat text)"
done
# The deviation is that of (0.24 -0.26 0): to (0 -0.5 0), and so printed by bake, with four digits.
deviation=$(sed -n 's/^deviation *\([^ ]*\) .*/\1/p' text)
awk -v d="$deviation" 'BEGIN { exit !(d > 0.339411 && d < 0.339412) }' || fail "deviation $deviation"
grep -q '^mesh .*  0.3394  ' table || fail "$(cat table)"
