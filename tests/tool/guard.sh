#!/bin/sh
# A robot's guard along trajectories that are free, warned of and stopped; motions from line to line;
# and files that are none.
. "$SOURCES/common.sh"

# An arm of boxes on a column that turns on and on; its forearm folds back on to the upper arm; the
# fingers of its hand follow each other.
link() {
  printf '<link name="%s"><collision><origin xyz="%s"/><geometry><box size="%s"/></geometry>' "$@"
  echo '</collision></link>'
}
joint() {
  printf '<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/>%s</joint>\n' "$@"
}
y='<axis xyz="0 1 0"/>'
arm() {
  echo '<robot name="arm">'
  link column "0 0 0" "0.2 0.2 0.1"
  link upper "0.25 0 0" "0.4 0.05 0.05"
  link fore "0.2 0 0" "0.3 0.04 0.04"
  link left "0 0 0" "0.02 0.02 0.1"
  link right "0 0 0" "0.02 0.02 0.1"
  joint turn continuous column upper '<origin xyz="0 0 0.2"/><axis xyz="0 0 1"/>'
  joint fold revolute upper fore "<origin xyz=\"0.5 0 0\"/>$y<limit lower=\"-3\" upper=\"3\"/>"
  joint grip prismatic fore left '<origin xyz="0.4 0.1 0"/><axis xyz="0 1 0"/>
    <limit lower="-0.09" upper="0.1"/>'
  joint other prismatic fore right '<origin xyz="0.4 -0.1 0"/><axis xyz="0 1 0"/>
    <limit lower="-0.1" upper="0.09"/><mimic joint="grip" multiplier="-1"/>'
  echo '</robot>'
}
arm >arm.urdf

# lines NAMES FIRST LAST STEPS: three values each; a line a step on the straight way between.
lines() {
  echo "$1"
  awk -v first="$2" -v last="$3" -v steps="$4" 'BEGIN {
    split(first, p, ","); split(last, q, ",")
    for (i = 0; i <= steps; ++i) {
      for (k = 1; k <= 3; ++k) {
        printf "%.6f%s", p[k] + (q[k] - p[k]) * i / steps, k < 3 ? ", " : "\n"
      }
    }
  }'
}
lines fold,turn,grip -0.5,0,0.05 0.5,3,0.05 300 >free.csv
lines turn,grip,fold 0,0.05,0 0,0.05,3 300 >folded.csv
lines turn,grip,fold 0,0.05,1.5 0,0.05,0.1 200 >back.csv
distances="--stop 0.01 --warn 0.05"

# Free in any order of columns, with comments and other line ends; the first line primes.
exits 0 guard arm.urdf free.csv $distances --motion
grep -q '^301 periods, [0-9]* pairs of links guarded$' stdout || fail "$(cat stdout)"
grep -q '^stop  *0$' stdout && grep -q '^not yet known  *0$' stdout || fail "$(cat stdout)"
grep -q '^motions from line to line: 300 free, 0 not$' stdout || fail "$(cat stdout)"
cp stdout text

# An image in place of the URDF: the same answers, for options that it was baked with.
exits 0 robot arm.urdf -o image $distances --format image
exits 0 guard image/arm.robot free.csv --motion
diff stdout text || fail "another answer of the image"
{ printf '\357\273\277# where it goes\r\n'; awk '{ printf "%s # %d\r\n", $0, NR }' free.csv; } >other.csv
exits 0 guard image/arm.robot other.csv --motion
sed 's/line 4[0-9]*//; s/line [0-9]*,//' stdout >other
sed 's/line 4[0-9]*//; s/line [0-9]*,//' text | diff - other || fail "other columns"

printf 'turn,fold,grip\n0,3.5,0\n' >over.csv
exits 3 guard image/arm.robot over.csv
grep -q "over.csv:2: joint 'fold' can't be at 3.5: its limits are -3 and 3; mend" stderr ||
  fail "$(cat stderr)"
exits 3 guard image/arm.robot over.csv --json
grep -q '"verdict":"refused","a":null' stdout || fail "$(cat stdout)"
refused "arm.robot: is baked already, --stop is for a URDF; leave it out" \
  guard image/arm.robot free.csv --stop 0.02

# Warned of, then stopped, in this order, before the links touch; a motion hits where they do.
exits 1 guard image/arm.robot folded.csv --json --motion
[ "$(wc -l <stdout)" -eq 301 ] || fail "not a line a period"
cp stdout first
exits 1 guard image/arm.robot folded.csv --json --motion
diff first stdout || fail "another answer"
seen=$(sed 's/.*"verdict":"\([a-z_]*\)".*/\1/' first | uniq | tr '\n' ' ')
[ "$seen" = "free warn stop " ] || fail "$seen"
line_of() { sed -n "/$1/{s/{\"line\":\([0-9]*\),.*/\1/p;q;}" first; }
stop=$(line_of '"verdict":"stop"')
hit=$(line_of '"outcome":"hit"')
[ "$stop" -lt "$hit" ] || fail "stops at $stop, hits at $hit"
grep -q '"verdict":"stop","a":"upper","b":"fore","distance":0.0,"work":[0-9]*,"status":"ok"' first ||
  fail "$(tail -1 first)"
grep -q '"outcome":"hit","part":0.[0-9]*,"a":"upper","b":"fore","triangles":\[[0-9]*,[0-9]*\],"values":{"turn":0.0,"fold":2.[0-9]*,"grip":0.0' \
  first || fail "$(tail -1 first)"
# What is told of a period with a distance is a bound on what the meshes are apart.
grep '"verdict":"warn"' first | awk -F'"distance":' '{ d = $2 + 0
  if (d <= 0.01 || d > 0.05) { print d; exit 1 } }' || fail "warned at another distance"
exits 1 guard image/arm.robot folded.csv --motion
grep -q "^stop  *[1-9][0-9]*  first at line $stop, upper - fore$" stdout || fail "$(cat stdout)"
grep -q "^  to line $hit: upper - fore hit 0.[0-9]* of the way on, at turn 0, fold 2.[0-9]*, grip 0.05$" \
  stdout || fail "$(cat stdout)"
grep -q 'more: --json has all$' stdout || fail "$(cat stdout)"
grep -q "^closest: line $hit, upper - fore intersect$" stdout || fail "$(cat stdout)"
# From far to further it is warned of until it is free.
exits 0 guard image/arm.robot back.csv
grep -q '^closest: line 2, ' stdout || fail "$(cat stdout)"

# A budget too small shows as what is not known, never as free.
exits 1 guard image/arm.robot folded.csv --json --work 1
grep -q '"verdict":"not_yet_known"' stdout || fail "all is known for nothing"
sed 's/.*"verdict":"\([a-z_]*\)".*/\1/' first >full
sed 's/.*"verdict":"\([a-z_]*\)".*/\1/' stdout | paste full - >both
grep -q "stop.free" both && fail "a small budget promises more"

# A jump through the upper arm is not free, though both of its ends are.
printf 'turn,fold,grip\n0,0,0.05\n0,2.9,0.05\n0,0,0.05\n0,0.1,0.05\n' >jump.csv
exits 1 guard image/arm.robot jump.csv --motion --report page.html
holds page.html '>3 to 4</th><td>hit</td><td>upper - fore</td>' '>4 to 5</th><td>free</td>'
grep -q 'first at line 3' stdout || fail "$(cat stdout)"
# From 6 units of 2^-28 of a turn below 0 to 6 below half a turn.
printf 'turn,fold,grip\n-1.404e-7,0,0.05\n3.1415925,0,0.05\n' >half.csv
exits 3 guard image/arm.robot half.csv
grep -q 'half.csv:3: a joint without limits turns by half a turn' stderr || fail "$(cat stderr)"

# A page: the same bytes of the URDF, elsewhere; nothing from elsewhere, no folder; not over an input.
exits 1 guard image/arm.robot folded.csv --motion --work 40 --report page.html
cp stdout text
exits 1 guard image/arm.robot folded.csv --motion --work 40
diff stdout text || fail "--report changes what is told"
mkdir elsewhere
cp arm.urdf folded.csv elsewhere/
(cd elsewhere && "$FLASHBVH" guard arm.urdf folded.csv $distances --motion --work 40 \
  --report ../again.html >/dev/null) || :
cmp page.html again.html || fail "another page"
self_contained page.html
grep -q "^<section><h2>Closest at line $hit: upper - fore intersect</h2>$" page.html || fail "no moment"
grep -q '<path class=k0 d="M' page.html && grep -q 'data:image/png' page.html || fail "no pictures"
# What it counts is what is told; of work, what may be spent is drawn; motions as in the table.
for kind in free warn stop 'not yet known'; do
  holds page.html "<dt>$kind</dt><dd>$(sed -n "s/^$kind  *\([0-9]*\).*/\1/p" text)<"
done
holds page.html "<dt>work a period</dt><dd>$(sed -n 's/^work: .*at most //p' text)<" \
  'what a period may spend, 40' '<path class=k4 d="M' 'In m of the base&#39;s frame, a point of both: '
[ "$(grep -c '<path class=stop ' page.html)" -eq 2 ] || fail "no line at the budget"
holds page.html "<th scope=row>$((hit - 1)) to $hit</th><td>hit</td><td>upper - fore</td><td class=n>0." \
  "<th scope=row>2 to $((hit - 1))</th><td>free</td>"
[ "$(grep -c '</th><td>\(hit\|close\|refused\)</td>' page.html)" -eq \
  "$(sed -n 's/^motions .* free, \([0-9]*\) not/\1/p' text)" ] || fail "motions"
# Pairs that stay far away are no lines, and links apart have two nearest points.
exits 0 guard image/arm.robot free.csv --report page.html
[ "$(sed -n '/^<section><h2>Distances/,/What the guard says/p' page.html | grep -c 'key c[0-3]')" -lt 4 ] ||
  fail "lines of pairs far away"
holds page.html 'the nearest points: <code>(' 'class=ends'
grep -q 'Motions from line to line' page.html && fail "motions that were not asked for"
code=0
"$FLASHBVH" guard image/arm.robot folded.csv --report folded.csv >stdout 2>stderr || code=$?
[ $code -eq 2 ] && grep -q '^fold\|^turn' folded.csv || fail "the trajectory is replaced"

# What firmware refuses is told by line, and the rest is answered.
printf 'turn,fold,grip\n0,3.5,0\n0,0,0\n0,0.1,0.2\n60,0,0\n0,0,0\n' >limits.csv
exits 3 guard arm.urdf limits.csv --json --motion
[ "$(sed 's/.*"status":"\([a-z_]*\)".*/\1/' stdout | tr '\n' ' ')" = \
  "joint_out_of_limits ok joint_out_of_limits not_a_coordinate ok " ] || fail "$(cat stdout)"
grep -q '^{"line":3,"verdict":"free",' stdout || fail "$(cat stdout)"
grep -q "limits.csv:2: joint 'fold' can't be at 3.5: its limits are -3 and 3; mend" stderr ||
  fail "$(cat stderr)"
grep -q "limits.csv:4: joint 'grip' can't be at 0.2: its limits are -0.09 and 0.1; mend" stderr ||
  fail "$(cat stderr)"
grep -q "limits.csv:5: joint 'turn' can't be at 60: firmware takes less than 8 turns" stderr ||
  fail "$(cat stderr)"

# No trajectory, and no robot.
bad() {
  printf "$1" >bad.csv
  refused "$2" guard arm.urdf bad.csv
}
bad 'turn,fold\n0,0\n' "bad.csv:1: has no column 'grip'; the first line names all joints that move: turn,fold,grip"
bad '# a comment\nturn,fold,turn,grip\n' "bad.csv:2: has two columns 'turn'; leave one out"
bad 'time,turn,fold,grip\n' "bad.csv:1: the column 'time' is no joint of the robot that moves"
bad 'turn,fold,grip,other\n' "bad.csv:1: the column 'other' is a joint that follows 'grip'; leave it out"
bad 'turn,fold,grip\n0,0,0\n\n0,0\n' "bad.csv:4: has 2 values, the first line names 3 joints; give each one"
bad 'turn,fold,grip\n0,0,0,\n' "bad.csv:2: has 4 values"
bad 'turn,fold,grip\n0,,0\n' "bad.csv:2: '' is no finite number"
bad 'turn,fold,grip\n0,nan,0\n' "bad.csv:2: 'nan' is no finite number"
bad 'turn,fold,grip\n0,1e39,0\n' "bad.csv:2: '1e39' is no finite number"
bad 'turn,fold,grip\n' "bad.csv: has no line of values; give one a period"
bad '# nothing\n' "bad.csv: has no line that names the joints: turn,fold,grip"
bad '' "bad.csv"
refused "gone.csv" guard arm.urdf gone.csv
refused "gone.urdf" guard gone.urdf free.csv
refused "--work" guard arm.urdf free.csv --work 0
refused "is nearer than --stop" guard arm.urdf free.csv --stop 0.1 --warn 0.01
sed '/<joint/,/<\/joint>/d; /link name="\(upper\|fore\|left\|right\)"/d' arm.urdf >still.urdf
refused "the robot has no joint that moves" guard still.urdf free.csv
