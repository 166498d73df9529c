#!/bin/sh
# The page about images holds what it promises, is the same wherever the images lie, and needs nothing
# from elsewhere. What cannot be read is refused, and no image is overwritten.
. "$SOURCES/common.sh"

holds() {
  page=$1
  shift
  for text; do
    grep -qF -- "$text" "$page" || fail "no '$text' in $page"
  done
}

# self_contained PAGE: no address but those that hold their data, and no path.
self_contained() {
  if grep -noE '(https?:|file:|src=|url\(|@import|<script|<link)[^>]{0,40}' "$1"; then
    fail "$1 needs something from elsewhere"
  fi
  if grep -oE 'href="[^"]{5}' "$1" | grep -vE 'href="(data:|#m[0-9]|#quer)'; then
    fail "$1 leads elsewhere"
  fi
  if grep -nE "$PWD|20[0-9][0-9]-[0-9][0-9]-" "$1" | cut -c 1-200 | grep .; then
    fail "a path or a date in $1"
  fi
}

# Every kind of image, several at once, of one cell.
for options in "" "--layout pre" "--index-bits 32" "--index-bits 32 --layout pre" \
  "--leaf-size 4 --arity 8" "--builder median"; do
  # shellcheck disable=SC2086
  "$FLASHBVH" bake meshes/ring.stl meshes/tetrahedron.stl -o baked --cell 0.01 --format image \
    $options >/dev/null
  exits 0 report baked/ring.fbvh baked/tetrahedron.fbvh -o page.html --poses 4
  [ ! -s stdout ] && [ ! -s stderr ] || fail "$(cat stdout stderr)"
  self_contained page.html
  case $options in
    *pre*) algorithm=stackless climb=parents ;;
    *) algorithm=ranked climb='right child levels' ;;
  esac
  holds page.html '<!DOCTYPE html>' '<html lang=en>' '<h2>ring</h2>' '<h2>tetrahedron</h2>' \
    'Bytes by part' "$climb" 'Nodes by depth' 'Nodes by number of children' 'largest deviation' \
    'None: the surface is closed' "ring and tetrahedron <small>$algorithm</small>" \
    'small proximity' 'close proximity' 'intersecting, to the first pair' 'prefers-color-scheme'
  [ "$(grep -o 'role=img aria-label="ring, From' page.html | wc -l)" -eq 4 ] || fail "views of ring"
  [ "$(grep -c 'data:image/png;base64,' page.html)" -eq 8 ] || fail "pictures"
done

# Figures agree with those of the other commands.
"$FLASHBVH" bake meshes/ring.stl -o baked --cell 0.01 --leaf-size 4 --format image >/dev/null
exits 0 report baked/ring.fbvh -o page.html --poses 0
holds page.html '<dd>400</dd>' "<td class=n>$(wc -c <baked/ring.fbvh | sed 's/\(...\)$/,\1/')</td>" \
  'Leaves by number of triangles'
if grep -q 'small proximity' page.html; then
  fail "queries with --poses 0"
fi
leaves=$("$FLASHBVH" info baked/ring.fbvh --json | sed 's/.*"leaves":\([0-9]*\).*/\1/')
holds page.html "$leaves leaves"
# Four bars, whose leaves add up.
sed -n '/Leaves by number/,/<\/table>/p' page.html |
  sed -n 's/.*<th scope=row class=n>\([0-9]*\)<\/th><td class=n>\([0-9]*\)<.*/\1 \2/p' |
  awk -v leaves="$leaves" '{ n += $2; t += $1 * $2 } END { exit n != leaves || t != 400 }' ||
  fail "leaves by size"

# The picture's pixels: a byte before each of 480 rows, then places in a palette of 81 colours.
grep -o 'base64,[^"]*' page.html | head -n 1 | cut -c 8- | base64 -d >picture.png
[ "$(head -c 8 picture.png | od -An -tx1 | tr -d ' ')" = 89504e470d0a1a0a ] || fail "no PNG"
{
  printf '\037\213\010\000\000\000\000\000\000\003' # gzip for zlib: the same within
  tail -c +392 picture.png
} | gzip -dc 2>/dev/null >pixels || :
[ "$(wc -c <pixels)" -eq $((480 * 481)) ] || fail "$(wc -c <pixels) bytes of pixels"
od -An -v -tu1 -w481 pixels |
  awk '{ bad += $1 != 0; for (i = 2; i <= NF; ++i) { bad += $i > 80; drawn += $i > 0 } }
    END { exit bad != 0 || drawn < 20000 }' || fail "strange pixels"

# The same page from another folder, at another time; names that are the same are told apart.
mkdir -p elsewhere other
cp baked/ring.fbvh elsewhere/ring.fbvh
cp baked/ring.fbvh other/ring.fbvh
exits 0 report baked/ring.fbvh baked/ring.fbvh -o one.html --poses 4
TZ=Asia/Tokyo LC_ALL=C "$FLASHBVH" report elsewhere/ring.fbvh other/ring.fbvh -o two.html --poses 4
cmp one.html two.html
holds one.html 'ring (2)'

# What is odd is told: an open surface, a non-manifold one, no area, duplicates, triangles left out.
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
exits 0 report odd/odd.fbvh -o odd.html --poses 4
holds odd.html '1 triangle (0) without area' '1 triangle (2) with the three vertices' \
  '6 boundary edges' '1 non-manifold edge'
"$FLASHBVH" bake odd.obj -o odd --cell 1 --drop degenerate,duplicate >/dev/null 2>&1
exits 0 report odd/odd.fbvh -o odd.html --poses 4
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
  'Every leaf holds one triangle' 'boundary edges'

# Images that can't be queried together are drawn all the same.
"$FLASHBVH" bake meshes/coarse.stl -o baked --cell 0.02 --format image >/dev/null
exits 0 report baked/ring.fbvh baked/coarse.fbvh -o page.html --poses 4
holds page.html "1 pair can&#39;t be queried" '<h2>coarse</h2>'

# Far from the origin of its file, a mesh intersects itself all the same; where most rotations would
# take it out
# of range, that is said.
for far in 1000000 500000000; do
  awk -v far=$far '$1 == "v" { print $1, $2 + far, $3, $4; next } { print }' odd.obj >far.obj
  "$FLASHBVH" bake far.obj -o odd --cell 1 >/dev/null 2>&1
  exits 0 report odd/far.fbvh -o far.html --poses 20
  grep -q '<th scope=row>intersecting</th><td class=n>[1-9]' far.html || fail "disjoint at $far"
done
holds far.html 'passed over'

# Refusals.
refused "required" report
refused "--output" report baked/ring.fbvh
refused "missing.fbvh: can't be opened" report baked/ring.fbvh missing.fbvh -o out.html
refused "ring.stl: is no flashbvh image" report meshes/ring.stl -o out.html
refused "--poses" report baked/ring.fbvh -o out.html --poses -1
refused "--poses" report baked/ring.fbvh -o out.html --poses many
refused "meshes: is a folder" report baked/ring.fbvh -o meshes
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
