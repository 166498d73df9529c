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
grep -q '^301 periods, 6 pairs of links guarded, 0 not looked at$' stdout || fail "$(cat stdout)"
grep -q '^stop  *0$' stdout && grep -q '^not yet known  *0$' stdout || fail "$(cat stdout)"
grep -q '^motions from line to line: 300 free, 0 not$' stdout || fail "$(cat stdout)"
cp stdout text

# An image in place of the URDF: the same answers, for options that it was baked with.
exits 0 robot arm.urdf -o image $distances --format image
exits 0 guard image/arm.robot free.csv --motion
diff stdout text || fail "another answer of the image"
{ printf '\357\273\277# where it goes\r\n'; awk '{ printf "%s # %d\r\n", $0, NR }' free.csv; } >other.csv
exits 0 guard image/arm.robot other.csv --motion
sed 's/line 4[0-9]*//; s/line [0-9]*,//; s/^[0-9 ]* warn//' stdout >other
sed 's/line 4[0-9]*//; s/line [0-9]*,//; s/^[0-9 ]* warn//' text | diff - other || fail "other columns"

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
grep -q '<path class=l0 d="M' page.html && grep -q '<g class="faces"><path' page.html || fail "no pictures"
# What it counts is what is told; of work, what may be spent is drawn; motions as in the table.
for kind in free warn stop 'not yet known'; do
  holds page.html "<dt>$kind</dt><dd>$(sed -n "s/^$kind  *\([0-9]*\).*/\1/p" text)<"
done
holds page.html "<dt>work a period</dt><dd>$(sed -n 's/^work: .*at most //p' text)<" \
  'what a period may spend, 40' '<path class=l6 d="M' 'In m of the base&#39;s frame, a point of both: '
[ "$(grep -c '<path class=stop ' page.html)" -eq 2 ] || fail "no line at the budget"
holds page.html "<th scope=row>$((hit - 1)) to $hit</th><td>hit</td><td>upper - fore</td><td class=n>0." \
  "<th scope=row>2 to $((hit - 1))</th><td>free</td>"
[ "$(grep -c '</th><td>\(hit\|close\|refused\)</td>' page.html)" -eq \
  "$(sed -n 's/^motions .* free, \([0-9]*\) not/\1/p' text)" ] || fail "motions"
# Pairs that stay far away are no lines, and links apart have two nearest points.
exits 0 guard image/arm.robot free.csv --report page.html
[ "$(sed -n '/^<section><h2>Distances/,/What the guard says/p' page.html | grep -c 'class=sample')" -lt 5 ] ||
  fail "lines of pairs far away"
holds page.html 'the nearest points: <code>(' 'class=ends'
grep -q 'Motions from line to line' page.html && fail "motions that were not asked for"
code=0
"$FLASHBVH" guard image/arm.robot folded.csv --report folded.csv >stdout 2>stderr || code=$?
[ $code -eq 2 ] && grep -q '^fold\|^turn' folded.csv || fail "the trajectory is replaced"

# A gantry's feet stand on its table, whose post is in the beam's way: nobody guards the two, and that
# is said first, wherever it is asked. Seven cubes that stop at once are all in the page, the one that
# the guard names too.
gantry() {
  echo '<robot name="gantry">'
  printf '<link name="table"><collision><geometry><box size="1 1 0.1"/></geometry></collision>'
  echo '<collision><origin xyz="0.4 0 0.2"/><geometry><box size="0.1 0.1 0.3"/></geometry></collision></link>'
  link bridge "0 0 0.1" "0.1 0.8 0.2"
  joint x prismatic table bridge '<axis xyz="1 0 0"/><limit lower="0" upper="0.4"/>'
  for i in 1 2 3 4 5 6 7; do
    link "cube$i" "0 0 0" "0.02 0.02 0.02"
    joint "at$i" fixed table "cube$i" "<origin xyz=\"0.3 $(((i - 4))).0e-1 0.4\"/>"
  done
  link beam "0 0 0.4" "0.02 0.9 0.02"
  joint beam_on fixed bridge beam ''
  echo '</robot>'
}
gantry >gantry.urdf
{ echo x; seq -f '0.%03g' 0 10 300; echo 0.3; seq -f '0.%03g' 290 -10 0; } >gantry.csv
exits 0 robot gantry.urdf -o gantry --stop 0.003 --warn 0.05 --format image --report page.html
holds page.html '<b>Not guarded</b>: table - bridge ('
exits 1 guard gantry/gantry.robot gantry.csv --json
holds stderr "gantry.robot: warning: not guarded: table - bridge"
head -n 1 stdout | grep -q '"not_guarded":\[{"a":"table","b":"bridge","reason":"[a-z ]*"}\]}$' ||
  fail "$(head -n 1 stdout)"
[ "$(grep -c not_guarded stdout)" -eq 1 ] || fail "told of more than one period"
exits 1 guard gantry.urdf gantry.csv --stop 0.003 --warn 0.05 --report page.html
holds stderr "gantry.urdf: warning: not guarded: table - bridge"
head -n 1 stdout | grep -q '^not guarded: table - bridge ([a-z ]*)$' || fail "$(cat stdout)"
grep -q '^62 periods, 7 pairs of links guarded, 1 not looked at$' stdout || fail "$(cat stdout)"
awk '/^from  *to  *verdict/ { seen = 1 } seen && $3 == "stop" { print $1, $2, $5 }' stdout >stops
[ "$(wc -l <stops)" -eq 1 ] || fail "$(cat stdout)"
read -r from to closest <stops
[ "$from" -lt 33 ] && [ "$to" -gt 33 ] && [ "$closest" = 0 ] || fail "$(cat stops)"
holds page.html "<b>Stops at line $from</b>: " '<b>Not guarded</b>: table - bridge (' \
  "<tr><th scope=row>$from</th><td>$to</td><td><i class=\"key v3\"></i>stop</td><td>"
for i in 1 2 3 4 5 6 7; do
  holds page.html "<tr><th scope=row>cube$i - beam</th><td class=n>"
done
[ "$(grep -c '<text class=number ' page.html)" -eq 6 ] && grep -q '<path class=l5 d="M' page.html ||
  fail "not six lines with numbers"
self_contained page.html
# So are pairs that stop between two lines, where the guard names another.
printf 'x\n0.2\n0.4\n' >coarse.csv
exits 1 guard gantry/gantry.robot coarse.csv --report coarse.html
for i in 1 2 3 4 5 6 7; do
  holds coarse.html "<tr><th scope=row>cube$i - beam</th>"
done
# The colours of verdicts and of lines are told apart, light and dark; verdicts have a lane each.
for name in v l; do
  grep -o -- "--$name[0-9]:#[0-9a-f]*" page.html | sed 's/.*://' | sort | uniq -d | grep . && fail "a colour of two"
done
grep -o '<rect class=v[0-9] x=[0-9.]* y=[0-9]*' page.html | awk '{ sub(/.*v/, "", $2); lane[$4 " " $2] = 1 }
  END { for (at in lane) { split(at, p, " "); if (++seen[p[1]] > 1) exit 1; ++lanes } exit lanes < 2 }' ||
  fail "two verdicts in one lane"

# What firmware refuses is told by line, and the rest is answered.
printf 'turn,fold,grip\n0,3.5,0\n0,0,0\n0,0.1,0.2\n60,0,0\n0,0,0\n' >limits.csv
exits 3 guard arm.urdf limits.csv --json --motion
[ "$(sed 's/.*"verdict":"\([a-z_]*\)".*/\1/' stdout | tr '\n' ' ')" = \
  "refused free refused refused free " ] || fail "$(cat stdout)"
[ "$(sed 's/.*"status":"\([a-z_]*\)".*/\1/' stdout | tr '\n' ' ')" = \
  "joint_out_of_limits ok joint_out_of_limits not_a_coordinate ok " ] || fail "$(cat stdout)"
grep -q '^{"line":3,"verdict":"free",' stdout || fail "$(cat stdout)"
grep -q "limits.csv:2: joint 'fold' can't be at 3.5: its limits are -3 and 3; mend" stderr ||
  fail "$(cat stderr)"
grep -q "limits.csv:4: joint 'grip' can't be at 0.2: its limits are -0.09 and 0.1; mend" stderr ||
  fail "$(cat stderr)"
grep -qF "limits.csv:5: joint 'turn' can't be at 60: firmware takes less than 8 turns, 50.27 radians; leave \
full turns out; in degrees? give radians: 1.0472" stderr || fail "$(cat stderr)"
# Degrees and millimetres are asked about, and only where values are that far off.
printf 'fold;turn;grip\n-45;0;0\n0;0;20\n0;0;2\n' >units.csv
exits 3 guard image/arm.robot units.csv --report page.html
grep -v 'units.csv' stderr | grep . && fail "another message"
holds stderr "units.csv:2: joint 'fold' can't be at -45: its limits are -3 and 3 radians; in degrees? give \
radians: -0.785398" \
  "units.csv:3: joint 'grip' can't be at 20: firmware takes less than 6.4 m of this robot; in millimetres? \
give metres: 0.02" \
  "units.csv:4: joint 'grip' can't be at 2: its limits are -0.09" \
  "and 0.1 m; in millimetres? give metres: 0.002"
holds page.html '<b>Firmware refuses the values of line 2</b>: 3 periods' '</i>refused</td>'
grep -q '^2        4        refused        -  ' stdout || fail "$(cat stdout)"
# A column of times, one that mimics, tabs; a mimic elsewhere than its joint puts it.
awk 'NR == 1 { print "time;" $0 ";other"; next }
  { split($0, v, ","); print NR / 100 ";" $0 ";" (-v[3]) }' free.csv | sed 's/, */\t/g; s/;/\t/g' >timed.csv
head -n 1 timed.csv | tr '\t' , | grep -q '^time,fold,turn,grip,other$' || fail "$(head -n 1 timed.csv)"
exits 0 guard image/arm.robot timed.csv --json
cp stdout timed
grep -qF "timed.csv:1: warning: the column 'time' is not used: each line is one period" stderr || fail "$(cat stderr)"
exits 0 guard image/arm.robot free.csv --json
diff stdout timed || fail "another answer with a time"

# No trajectory, and no robot.
bad() {
  printf "$1" >bad.csv
  refused "$2" guard arm.urdf bad.csv
}
bad 'turn,fold\n0,0\n' "bad.csv:1: has no column 'grip'; the first line names all joints that move: turn,fold,grip"
bad '# a comment\nturn,fold,turn,grip\n' "bad.csv:2: has two columns 'turn'; leave one out"
bad 'time,turn,fold,grip\n1,0,0,0\n0.5,0,0,0\n' "bad.csv:3: 'time' goes back from 1 to 0.5; each line is one"
bad 'clock,turn,fold,grip\n' "bad.csv:1: the column 'clock' is no joint of the robot that moves"
bad 'turn,fold,grip,other\n0,0,0.05,0.05\n' "bad.csv:2: 'other' is 0.05, but it follows 'grip', which puts it at -0.05"
bad 'turn;fold;grip\n0;0,5;0\n' "bad.csv:2: '0,5' has a decimal comma; write a point: 0.5"
bad 'turn,fold,grip\n0,0,0\n\n0,0\n' "bad.csv:4: has 2 values, the first line names 3 columns; give each one"
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
