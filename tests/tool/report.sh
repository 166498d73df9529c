#!/bin/sh
# The page about images holds what it promises, agrees with the other commands and with the proven
# constants, is the same wherever the images lie, and needs nothing from elsewhere. What cannot be read
# is refused, and no image is overwritten.
. "$SOURCES/common.sh"

# faces PAGE NUMBER: the classes of a picture in the page, a line for each triangle, the furthest first.
# f27 is of triangles that intersect.
faces() {
  grep '^<g class="faces">' "$1" | sed -n "$2p" | sed 's/<path/\n<path/g' |
    awk -F '"' '/^<path/ { for (n = gsub("z", "", $4); n > 0; --n) print $2 }'
}

# Every kind of image, several at once, of one cell; with FLASHBVH_THOROUGH in every combination.
for options in "--layout pre --leaf-size 4 --arity 8" "--index-bits 32 --builder median" "" \
  "--layout pre" "--index-bits 32" "--index-bits 32 --layout pre" "--leaf-size 4 --arity 8" \
  "--builder median"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/tetrahedron.stl -o baked --cell 0.01 \
    $options >/dev/null
  exits 0 report baked/ring.fbvh baked/tetrahedron.fbvh -o page.html --samples 40
  [ ! -s stdout ] && [ ! -s stderr ] || fail "$(cat stdout stderr)"
  self_contained page.html
  holds page.html '<!DOCTYPE html>' '<html lang=en>' '<h1>ring and tetrahedron</h1>' '<h2>ring</h2>' \
    '<h2>tetrahedron</h2>' 'largest deviation' 'Nothing odd: the surface is closed' \
    'ring and tetrahedron: Do they touch?' 'intersecting: the first pair' 'prefers-color-scheme' \
    'Costliest pose:' 'First contact:' 'image format 2'
  case $options in
    *32*) holds page.html 'a query object of 136' ;;
    *) holds page.html 'a query object of 128' ;;
  esac
  case $options in
    *pre*) holds page.html 'pre, ' ;;
    *) holds page.html 'post, ' ;;
  esac
  [ "$(grep -o 'role=img aria-label="ring, From' page.html | wc -l)" -eq 4 ] || fail "views of ring"
  [ "$(grep -c '<g class="faces">' page.html)" -eq 10 ] || fail "pictures"
  # Each view of a mesh has the same scale.
  [ "$(grep -o 'class=axis d="M[0-9]* [0-9]*v28m0-14h[0-9]*' page.html | tail -n 4 | sort -u |
    wc -l)" -eq 1 ] || fail "scales"
  # What firmware links, by the C++ output; what the image takes.
  for mesh in ring tetrahedron; do
    flash=$(sed -n 's/.*kFlashBytes = \([0-9]*\);.*/\1/p' baked/$mesh.fbvh.hpp)
    grep -A 4 "#m[0-9]\">$mesh" page.html | tr -d ',\n' |
      grep -q "<td class=n>$flash</td><td class=n>$(wc -c <baked/$mesh.fbvh)</td>" ||
      fail "flash of $mesh is not $flash"
  done
  [ "${options#--index}" = "$options" ] || thorough || break
done

# No boxes at first; each level can be chosen, be it as large as it may.
"$FLASHBVH" bake meshes/many_nodes.stl -o baked --format image >/dev/null
exits 0 report baked/many_nodes.fbvh -o page.html --samples 0
holds page.html 'id=v0-n class="R Rn" checked' 'boxes overlapped' '; one in '
depth=$("$FLASHBVH" info baked/many_nodes.fbvh --json | sed 's/.*"depth":\([0-9]*\).*/\1/')
[ "$(grep -c 'input type=radio' page.html)" -eq $((depth + 2)) ] || fail "levels"
for level in $(seq 0 "$depth"); do
  [ "$(grep -c "<g class=\"L L$level[ \"]" page.html)" -eq 4 ] || fail "level $level is not drawn"
done
# However many triangles there are, so many are drawn.
for picture in 1 2 3 4; do
  count=$(faces page.html $picture | wc -l)
  [ "$count" -gt 100 ] && [ "$count" -le 1900 ] || fail "$count triangles drawn"
done
if grep -qE 'First contact|mean of the poses' page.html; then
  fail "poses with --samples 0"
fi

# The work at given poses and at any, as `collide` has it; the bounds of bound.hpp, worked out here.
"$FLASHBVH" bake meshes/ring.stl meshes/tetrahedron.stl meshes/coarse.stl -o baked --cell 0.01 \
  --leaf-size 12 --arity 4 >/dev/null
a=baked/ring.fbvh
b=baked/coarse.fbvh
for i in $(seq 0 104); do
  echo "0.6 -0.8 0  0.8 0.6 0  0 0 1  $((i % 9 - 4)).25 0.5 0.$i"
done >poses
# cards OPTION...: work, instructions and verdicts of the eight cards, a line each.
cards() {
  exits 0 report $a $b --poses poses -o page.html "$@"
  sed -n 's/.*<\/h4><b>\([^<]*\)<.*<small>\([0-9,]*\) work<br>at most \([0-9.,]*\)[a-z ]* instr.*/\2 \3 \1/p' \
    page.html | tr -d , >cards
}
cards
"$FLASHBVH" collide $a $b --poses poses --bound --json >bound
of() { sed "s/.*\"$1\":\([0-9]*\).*/\1/" bound; }
[ "$(sed -n 's/ .*//; 5,8p' cards | tr '\n' ' ')" = "$(of poses_mean_work) $(of \
  poses_99_percent_work) $(of poses_most_work) $(of most_work) " ] || fail "work: $(cat cards bound)"
holds page.html 'Poses: 105 poses as given' 'Cortex-M4F at 168 MHz: 168,000 instructions'
# To the first pair it takes less, unless there is none.
sed -n 's/ .*//; 1,3p; 5,7p' cards | paste -s -d ' ' - |
  awk '{ exit !($1 > 0 && $1 < $4 && $2 < $5 && $3 < $6) }' || fail "to the first pair: $(cat cards)"
mkdir asked
cp poses asked/ring-coarse
head -n 1 poses >asked/tetrahedron-ring
exits 0 report $a baked/tetrahedron.fbvh $b --poses asked -o page.html
holds page.html 'All 2 pairs' '1 pair is not asked about: no poses' 'takes at most ' "$(of poses_most_work | sed \
  's/\(...\)$/,\1/')</td>"
[ "$(grep -o 'class="n heat"' page.html | wc -l)" -eq 2 ] || fail "matrix"

# check_instructions NAME CONSTANT HZ MHZ
check_instructions() {
  cards --core "$1" --hz "$3" --mhz "$4"
  sed -n "s/.*$2 = {\(.*\)};/\1/p" "$INCLUDE/flashbvh/detail/walk/run_costs.hpp" | tr -d , >costs
  awk -v period="$(awk "BEGIN { print int($4 * 1000000 / $3) }")" -v depths="$(of depths)" \
    -v siblings="$(of later_siblings)" -v leaf="$(of leaf_size)" '
    function up(x) { return x == int(x) ? x : int(x) + 1 }
    FNR == NR {
      start = $1 + depths * $2 + siblings * $3 + (leaf - 1) * $4
      unit = $5 + up(siblings * $3 / 32)
      step = leaf + 8 > 32 ? leaf + 8 : 32
      within = int((period - start - (step - 1) * unit) / unit)
      next
    }
    {
      most = start + $1 * unit
      slices = up($1 / within)
      if ($2 != most && $2 != sprintf("%.3g", most / 1e6)) { print "instructions: " $2 ", not " most; bad = 1 }
      wanted = most > period ? "needs at most " slices " slices of " within " work" : \
        sprintf("fits in %.*f %% of the period", most < period / 10 ? 1 : 0, 100 * most / period)
      said = $0
      sub(/^[0-9]+ [0-9.]+ /, "", said)
      if (said != wanted) { print said ", not " wanted; bad = 1 }
      seen[most > period] = 1
    }
    END { exit bad || !seen[0] || !seen[1] }' costs cards || fail "--core $1 --hz $3 --mhz $4"
}
if thorough; then
  check_instructions Cortex-M4F kCortexM4F 5 168
  check_instructions cortex-m0 kCortexM0 1 48
fi
check_instructions rv32imac kRV32IMAC 3.5 108.5
# Every core that has constants can be chosen.
sed -n 's/^constexpr RunCosts k\([^ ]*\) .*/\1/p' "$INCLUDE/flashbvh/detail/walk/run_costs.hpp" >cores
while read -r core; do
  "$FLASHBVH" report --help | tr -d - | grep -q "[{,]$core[,}]" || fail "no core $core"
done <cores
# Where not even a slice fits, that is said.
cards --hz 100000
holds page.html 'no slice fits'

# Pictures: drawn, and what intersects is lit, in front of the rest.
for picture in 1 2; do
  faces page.html $picture >drawn
  [ "$(sort -u drawn | wc -l)" -gt 10 ] && [ "$(tail -n 1 drawn)" = f27 ] || fail "picture $picture"
done
echo "1 0 0  0 1 0  0 0 1  200 0 0" >apart
exits 0 report $a $b --poses apart -o page.html
holds page.html 'At none of the poses do they intersect' 'no triangles intersect'
if faces page.html 1 | grep -qx f27; then
  fail "lit, but disjoint"
fi

# The nearer of two triangles hides the other one; of a closed surface only the front is drawn.
printf 'v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n' >flat.obj
printf 'v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >solid.obj
"$FLASHBVH" bake flat.obj solid.obj -o flat --cell 0.01 >/dev/null 2>&1
for height in 1 -1; do
  echo "1 0 0  0 1 0  0 0 1  0 0 $height" >above
  exits 0 report flat/flat.fbvh flat/flat.fbvh --poses above -o page.html
  [ "$(faces page.html 1 | tr -d '[:digit:]' | wc -l)" -eq 2 ] || fail "not two triangles"
  last=$(faces page.html 1 | tail -n 1 | tr -d f)
  [ $((last / 9)) -eq $((height > 0)) ] || fail "at a height of $height, $last is in front"
done
exits 0 report flat/solid.fbvh -o page.html --samples 0
[ "$(faces page.html 1 | wc -l)" -eq 2 ] && [ "$(faces page.html 2 | wc -l)" -eq 1 ] ||
  fail "backs are drawn: $(faces page.html 1)"

# As far apart as a pose can be, the picture's arithmetic still holds.
echo "1 0 0  0 1 0  0 0 1  -5368709 5368709 5368709" >apart
exits 0 report $a $b --poses apart -o page.html
holds page.html 'no triangles intersect'

# The same page from another folder, at another time; names that are the same are told apart.
mkdir -p elsewhere other
cp baked/tetrahedron.fbvh elsewhere/tetrahedron.fbvh
cp baked/tetrahedron.fbvh other/tetrahedron.fbvh
cp poses elsewhere/other_name
for options in "--samples 40" "--poses poses"; do
  # shellcheck disable=SC2086
  exits 0 report baked/tetrahedron.fbvh baked/tetrahedron.fbvh -o one.html $options
  TZ=Asia/Tokyo LC_ALL=C "$FLASHBVH" report elsewhere/tetrahedron.fbvh other/tetrahedron.fbvh -o two.html \
    $(echo "$options" | sed 's|poses poses|poses elsewhere/other_name|')
  cmp one.html two.html
  holds one.html 'tetrahedron (2)'
done

# What is odd is told and marked: an open surface, a non-manifold one, no area, duplicates, triangles left out.
cat >odd.obj <<'OBJ'
v 0 0 0
v 8 0 0
v 0 8 0
v 0 0 8
v 8 8 8
f 1 1 2
f 1 2 3
f 3 1 2
f 1 2 4
f 1 2 5
OBJ
"$FLASHBVH" bake odd.obj -o odd --cell 1 >/dev/null 2>&1
exits 0 report odd/odd.fbvh -o odd.html --samples 0
# marked PAGE PAINT...
marked() {
  page=$1
  shift
  for paint; do
    faces "$page" 1 | grep -qx "f$((9 * paint))" || fail "nothing in $page has the paint $paint"
    holds "$page" ".paint$paint{background:rgb(" ".faces .f$((9 * paint)){"
  done
}
marked odd.html 4 5 6 7
holds odd.html '1 triangle (0) without area' '1 triangle (2) with the three vertices' \
  '6 boundary edges' '1 non-manifold edge'
"$FLASHBVH" bake odd.obj -o odd --cell 1 --drop degenerate,duplicate >/dev/null 2>&1
exits 0 report odd/odd.fbvh -o odd.html --samples 0
marked odd.html 6 7
holds odd.html '2 triangles were left out'

# A single triangle, and one that is a point; names that HTML or UTF-8 would stumble over.
printf 'v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n' >'a<b>&"c".obj'
"$FLASHBVH" bake 'a<b>&"c".obj' -o odd --cell 0.1 --name single >/dev/null 2>&1
mv odd/single.fbvh "odd/a<b>&\"$(printf '\377')\".fbvh"
printf 'v 5 5 5\nf 1 1 1\n' >point.obj
"$FLASHBVH" bake point.obj -o odd --cell 0.1 >/dev/null 2>&1
exits 0 report odd/a*.fbvh odd/point.fbvh -o single.html
self_contained single.html
holds single.html "<h2>a&lt;b&gt;&amp;&quot;$(printf '\357\277\275')&quot;</h2>" '<h2>point</h2>' \
  'boundary edges'

# Images that can't be queried together are drawn all the same.
"$FLASHBVH" bake meshes/coarse.stl -o baked --cell 0.02 --format image >/dev/null
exits 0 report baked/ring.fbvh baked/coarse.fbvh -o page.html --samples 4
holds page.html "1 pair is not asked about: baked with another cell" '<h2>coarse</h2>'

# Far from the origin of its file, a mesh intersects itself all the same; where most rotations would
# take it out
# of range, that is said.
for far in 1000000 500000000; do
  awk -v far=$far '$1 == "v" { print $1, $2 + far, $3, $4; next } { print }' odd.obj >far.obj
  "$FLASHBVH" bake far.obj -o odd --cell 1 >/dev/null 2>&1
  exits 0 report odd/far.fbvh -o far.html --samples 200
  grep -q '<th scope=row>intersecting: the first pair</th><td class=n>[1-9]' far.html || fail "disjoint at $far"
done
holds far.html 'passed over'

# Refusals.
refused "required" report
refused "--output" report baked/ring.fbvh
refused "missing.fbvh: can't be opened" report baked/ring.fbvh missing.fbvh -o out.html
refused "ring.stl: is no flashbvh image" report meshes/ring.stl -o out.html
refused "--samples" report baked/ring.fbvh -o out.html --samples -1
refused "--samples" report baked/ring.fbvh -o out.html --samples many
refused "--samples" report baked/ring.fbvh -o out.html --samples 4 --poses poses
refused "missing: can't be opened" report baked/ring.fbvh -o out.html --poses missing
refused "names no file" report baked/ring.fbvh -o out.html --poses ""
echo "1 0 0 0 1 0 0 0 1 0 0" >short
refused "short:1: has 11 numbers" report baked/ring.fbvh -o out.html --poses short
refused "coarse.fbvh: has a cell of 0.02, but" report baked/ring.fbvh baked/coarse.fbvh -o out.html \
  --poses poses
refused "give two, or a folder" report baked/ring.fbvh baked/ring.fbvh baked/coarse.fbvh -o out.html \
  --poses poses
refused "asked: has poses of no two of the images; name a file after them: ring-ring (2)" \
  report baked/ring.fbvh baked/ring.fbvh -o out.html --poses asked
for rate in 0 -1 nan inf many 1e10; do
  refused "--hz: must be a number" report baked/ring.fbvh -o out.html --hz $rate
  refused "--mhz: must be a number" report baked/ring.fbvh -o out.html --mhz=$rate
done
refused "--core" report baked/ring.fbvh -o out.html --core cortex-m5
refused "meshes: is a folder" report baked/tetrahedron.fbvh -o meshes --samples 0
head -c 200 baked/ring.fbvh >cut.fbvh
refused "cut.fbvh: is truncated" report cut.fbvh -o out.html
cp baked/ring.fbvh before
ln -s baked/ring.fbvh link
for page in baked/ring.fbvh link before; do
  refused "$page: is an image, which would be replaced; write elsewhere" \
    report baked/ring.fbvh -o $page
done
cmp before baked/ring.fbvh
"$FLASHBVH" report --help | grep -q Usage || fail "no help"
