#!/bin/sh
# Where triangles intersect, in the images' unit and A's frame; poses as firmware makes them of
# floats; and what poses needed, in work and in instructions.
. "$SOURCES/common.sh"

# A blade in the upper face of a block, each a metre off its frame's origin: along x = 1003.1,
# z = 1010, from y = 1003 to 1005 (tests/c_api/program.c has the same).
"$FLASHBVH" bake "$SOURCES/../c_api/block.obj" "$SOURCES/../c_api/blade.obj" -o mm --cell 0.1 \
  --unit mm >/dev/null 2>&1
echo "1 0 0 0 1 0 0 0 1  2000 2000 2000" >poses
exits 0 collide mm/block.fbvh mm/blade.fbvh --poses poses --contacts contacts --pairs pairs
awk -v cell=0.1 '
  BEGIN { low = 1e9 }
  function is(x, y) { return x - y <= cell / 256 && y - x <= cell / 256 }
  !is($4, 1003.1) || !is($7, 1003.1) || !is($6, 1010) || !is($9, 1010) { wrong = 1 }
  { for (i = 5; i <= 8; i += 3) { low = $i < low ? $i : low; high = $i > high ? $i : high } }
  END { exit wrong || !is(low, 1003) || !is(high, 1005) }' contacts || fail "$(cat contacts)"
cut -d ' ' -f 1-3 contacts | cmp - pairs
# Rotated half a turn about z, the blade stands where it stood, seen from the block.
echo "-1 0 0 0 -1 0 0 0 1  6.2 8 2000" >poses
exits 0 collide mm/block.fbvh mm/blade.fbvh --poses poses --contacts rotated
awk '$4 != 1003.1 || $6 != 1010 { exit 1 }' rotated && [ -s rotated ] || fail "$(cat rotated)"
refused "poses" collide mm/block.fbvh mm/blade.fbvh --poses poses --contacts poses
refused "same file" collide mm/block.fbvh mm/blade.fbvh --poses poses --contacts out --pairs out

# 500.005 mm are 50000.5 cells but for a float's rounding, and for a double's: to the side of either.
"$FLASHBVH" bake "$SOURCES/../c_api/blade.obj" -o fine --cell 0.01 >/dev/null 2>&1
for t in 500.005 500.015 499.995 123.455 87.345; do
  echo "1 0 0 0 1 0 0 0 1  $t 0 0"
done >poses
echo "0 -1 0 1 0 0 0 0 1  0.1 0.2 0.3" >>poses
exits 0 collide fine/blade.fbvh fine/blade.fbvh --poses poses --float --json
# As firmware has them, tests/tool/float_poses.cpp.
"$TOOLS/tool_test_float_poses" 0.01 <poses >wanted
for i in 1 2 3 4 5; do
  t=$(sed -n "${i}s/.*1  \([0-9.]*\) .*/\1/p" poses)
  "$FLASHBVH" export --cells fine/blade.fbvh -o blade.obj --float --pose "1 0 0 0 1 0 0 0 1  $t 0 0"
  awk '$1 == "v" { print $2 + 99690; exit }' blade.obj
done >found
cut -d ' ' -f 1 wanted | head -n 5 | cmp - found
for i in 1 2 3 4 5; do
  t=$(sed -n "${i}s/.*1  \([0-9.]*\) .*/\1/p" poses)
  "$FLASHBVH" export --cells fine/blade.fbvh -o blade.obj --pose "1 0 0 0 1 0 0 0 1  $t 0 0"
  awk '$1 == "v" { print $2 + 99690; exit }' blade.obj
done >of_doubles
cmp -s found of_doubles && fail "floats and doubles round alike: $(cat found)"

# A summary says what --bound says of the same poses, and what that takes at most.
"$TOOLS/tool_test_meshes" meshes
"$FLASHBVH" bake meshes/ring.stl meshes/coarse.stl -o post --cell 0.01 >/dev/null
python3 "$SOURCES/poses.py" 40 5 20 >poses
exits 0 collide post/ring.fbvh post/coarse.fbvh --poses poses --bound --json
cp stdout bound
exits 0 collide post/ring.fbvh post/coarse.fbvh --poses poses --summary --json
number() { sed "s/.*\"$1\":{\"mean\":\([0-9]*\),\"percentile_99\":\([0-9]*\),\"most\":\([0-9]*\)}.*/\\$2/"; }
[ "$(number work 3 <stdout)" -eq "$(sed 's/.*"poses_most_work":\([0-9]*\).*/\1/' bound)" ] &&
  [ "$(number work 1 <stdout)" -eq "$(sed 's/.*"poses_mean_work":\([0-9]*\).*/\1/' bound)" ] ||
  fail "$(cat stdout bound)"
cp stdout summary
# With one triangle a leaf and two children a node little is added to the constants.
least=$(sed -n 's/^constexpr RunCosts kCortexM4F = .* \([0-9]*\)};/\1/p' "$INCLUDE/flashbvh/detail/run_costs.hpp")
awk -v work="$(number work 3 <summary)" -v least="$least" -v most=$((least + 12)) -v found="$(number Cortex-M4F 3 <summary)" '
  BEGIN { exit !(found > work * least && found < work * most + 20000) }' || fail "$(cat summary)"
exits 0 collide post/ring.fbvh post/coarse.fbvh --poses poses --summary
grep -q '^work  *[0-9]* *[0-9]* *[0-9]*$' stdout && grep -q '^Cortex-M0 ' stdout &&
  grep -q '^RV32IMAC ' stdout || fail "$(cat stdout)"
exits 0 collide post/ring.fbvh post/coarse.fbvh --poses poses --summary --algorithm leaf
grep -q Cortex stdout && fail "proven of ranked alone: $(cat stdout)"
refused "excludes" collide post/ring.fbvh post/coarse.fbvh --poses poses --summary --pairs out
