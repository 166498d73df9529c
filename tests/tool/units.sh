#!/bin/sh
# Files of different units end up in one; every length given and printed is in it.
. "$SOURCES/common.sh"

# The same box three times: in millimetres, in metres, in inches.
box() {
  awk -v s="$1" 'BEGIN {
    for (i = 0; i < 8; ++i)
      printf "v %s %s %s\n", int(i / 4) * s, int(i / 2) % 2 * s, i % 2 * s
    print "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4"
  }'
}
mkdir parts
box 254 >parts/mm.obj
box 0.254 >parts/m.obj
box 10 >parts/in.obj
"$FLASHBVH" bake parts/mm.obj parts/m.obj parts/in.obj -o out --cell 0.5 --unit mm \
  --unit m.obj=m --unit parts/in.obj=in >table 2>warnings
[ ! -s warnings ] || fail "$(cat warnings)"
"$FLASHBVH" info out/mm.fbvh --json | sed 's/"name":"mm"/"name":"in"/' >of_mm
"$FLASHBVH" info out/in.fbvh --json >of_in
cmp of_mm of_in
grep -q '"unit":"mm"' of_in || fail "$(cat of_in)"
"$FLASHBVH" info out/in.fbvh | grep -q '^cell  *0.5  mm$' || fail "$("$FLASHBVH" info out/in.fbvh)"
grep -q '^cell 0.5 mm;' table || fail "$(cat table)"
grep -q 'kCell = 0.5;  ///< in mm' out/m.fbvh.hpp || fail "$(cat out/m.fbvh.hpp)"
for name in mm m in; do
  "$FLASHBVH" export --cells out/$name.fbvh -o $name.obj
  cmp mm.obj $name.obj
done

# A common unit alone changes no number, whichever it is; the image knows it.
"$FLASHBVH" bake parts/in.obj -o plain --cell 0.5 --format image >table
grep -q '^cell 0.5;' table || fail "$(cat table)"
for unit in nm um mm cm m mil in ft; do
  "$FLASHBVH" bake parts/in.obj -o alone --cell 0.5 --unit $unit --format image >table
  grep -q "^cell 0.5 $unit;" table || fail "$(cat table)"
  "$FLASHBVH" info alone/in.fbvh --json | sed "s/\"unit\":\"$unit\"/\"unit\":\"\"/" >found
  "$FLASHBVH" info plain/in.fbvh --json | cmp - found
  "$FLASHBVH" export alone/in.fbvh -o alone.obj
  head -n 1 alone.obj | grep -q "^# in $unit$" || fail "$(cat alone.obj)"
  grep -q '^v 10 10 10$' alone.obj || fail "$(cat alone.obj)"
done

# To feet and back: 12 inches to a foot.
"$FLASHBVH" bake parts/in.obj -o feet --cell 0.5 --unit in.obj=in --unit ft --format image >/dev/null \
  2>warnings
"$FLASHBVH" export --cells feet/in.fbvh -o feet.obj
grep -q '^v 2 2 2$' feet.obj || fail "10 in are not 2 cells of half a foot: $(cat feet.obj)"

# check reads the mesh as bake did.
exits 1 check out/in.fbvh --mesh parts/in.obj
exits 0 check out/in.fbvh --mesh parts/in.obj --unit mm --unit in.obj=in

rm -r out
refused "--unit yard: 'yard' is no unit; give nm, um" bake parts/mm.obj -o out --unit yard
refused "--unit mm.obj=yard: 'yard' is no unit" bake parts/mm.obj -o out --unit mm.obj=yard
refused "--unit cm: the unit is mm already; give a file's own unit as --unit FILE=cm" \
  bake parts/mm.obj -o out --unit mm --unit cm
refused "--unit other.obj=mm: no mesh 'other.obj' is given" \
  bake parts/mm.obj -o out --unit m --unit other.obj=mm
refused "--unit parts/mm.obj=in: parts/mm.obj is in cm already" \
  bake parts/mm.obj -o out --unit m --unit mm.obj=cm --unit parts/mm.obj=in
refused "--unit mm.obj=mm: says nothing of the unit of the results; add it" \
  bake parts/mm.obj -o out --unit mm.obj=mm
refused "--unit" bake parts/mm.obj -o out --unit
