#!/bin/sh
# What `flashbvh robot` believes and says: pairs that no guard looks at, what an SRDF disables, sizes
# and cells, and what is no robot.
. "$SOURCES/common.sh"

# says TEXT...: on standard error.
says() { holds stderr "$@"; }

# A gantry whose feet stand on its table, so that the two always intersect; a post in the beam's way,
# of the table's own or a link of its own.
gantry() {
  echo '<robot name="gantry">'
  post=$(box '0.05 0.05 0.5' '0.3 0 0.25')
  [ "$1" = post ] && own=$post || own=
  link table "$(box '1 1 0.1' '0 0 -0.05')$([ "$own" ] || echo "$post")"
  link bridge "$(box '0.05 0.1 0.4' '-0.4 -0.4 0.199')$(box '0.05 0.1 0.4' '-0.4 0.4 0.199')$(
    box '0.05 0.9 0.05' '-0.4 0 0.375')"
  link carriage "$(box '0.04 0.04 0.2' '-0.33 0 0.3')"
  [ -z "$own" ] || link post "$own"
  [ -z "$own" ] || joint stands fixed table post ''
  joint x prismatic table bridge "<axis xyz=\"1 0 0\"/>$(limits 0 0.8)"
  joint y prismatic bridge carriage "<axis xyz=\"0 1 0\"/>$(limits -0.3 0.3)"
  echo '</robot>'
}
gantry none >gantry.urdf
gantry post >post.urdf
{ echo x,y; seq 0 50 | awk '{ print $1 * 0.016 ",0.2" }'; } >drive.csv

unguarded='warning: not guarded: table - bridge (neighbours that intersect at all configurations tried)'
exits 0 robot gantry.urdf -o baked --stop 0.003 --format both
says "gantry.urdf: $unguarded: a collision of these is never detected; make a part that stands in"
[ "$(head -n 1 stdout)" = "not guarded: table - bridge" ] || fail "$(cat stdout)"
holds baked/gantry.robot.hpp 'kUnguardedCount = 1;' \
  '{links::table, links::bridge, flashbvh::WhyUnguarded::intersecting, 0},'
"$CXX" -std=c++17 -Wall -Wextra -Wconversion -pedantic -Werror -I"$INCLUDE" -c baked/gantry.robot.cpp \
  -o object || fail "does not compile"
exits 0 robot gantry.urdf -o baked --stop 0.003 --format c --json
json='"not_guarded":[{"a":"table","b":"bridge","reason":"neighbours that intersect at all configurations tried"}]'
holds stdout "$json" '"size":[1.0,1.0,0.6' '"deviation":'
holds baked/gantry.robot.h ' * table - bridge */' 'gantry_UNGUARDED_COUNT = 1'
"${CC:-cc}" -std=c99 -Wall -Wextra -pedantic -Werror -I"$INCLUDE" -c baked/gantry.robot.c -o object ||
  fail "does not compile as C"
# The image has the list, too, and guard says it of both.
exits 0 info baked/gantry.robot
holds stdout 'not guarded: table - bridge'
exits 0 info baked/gantry.robot --json
holds stdout "$json"
"$FLASHBVH" guard baked/gantry.robot drive.csv >stdout 2>stderr || true
says "baked/gantry.robot: $unguarded"
"$FLASHBVH" guard gantry.urdf drive.csv --stop 0.003 >stdout 2>stderr || true
says "gantry.urdf: $unguarded"
# As the warning says: the post is a link of its own, and the beam stops.
exits 1 guard post.urdf drive.csv --stop 0.003
says "$unguarded"
grep -q '^stop  *[1-9].*bridge - post$' stdout || fail "$(cat stdout)"
exits 0 robot post.urdf -o baked
grep -q '^table - post *fixed *no joint moves them, intersecting$' stdout || fail "$(cat stdout)"
grep -q '^not guarded: table - bridge$' stdout || fail "$(cat stdout)"
# A pair with distances of its own is decided, whatever it is.
exits 0 robot gantry.urdf -o baked --pair table,bridge=0
grep -q '^table - bridge *can ' stdout || fail "$(cat stdout)"
says "a guard would always say stop; leave out its --pair, or"
grep -q 'not guarded' stdout stderr && fail "$(cat stderr)"
refused "--pair is for a URDF" guard baked/gantry.robot drive.csv --pair table,bridge=0

# What an SRDF disables is decided all the same.
srdf() { printf '<robot name="gantry">\n%s\n</robot>\n' "$1" >gantry.srdf; }
disables() { printf '<disable_collisions link1="%s" link2="%s" reason="Never"/>' "$@"; }
srdf "$(disables post carriage)
$(disables bridge post)
$(disables table bridge)$(disables bridge carriage)"
refused 'gantry.srdf:2: disables carriage - post as "Never", but they intersect at x ' \
  robot post.urdf -o out --srdf gantry.srdf
says 'y 0' '; delete the line, or stand by it with --believe carriage,post' 'So can: bridge - post (line 3)'
refused 'gantry.srdf:3: disables bridge - post' robot post.urdf -o out --srdf gantry.srdf \
  --believe post,carriage
refused 'gantry.srdf:3: disables bridge - post' guard post.urdf drive.csv --srdf gantry.srdf \
  --believe post,carriage
exits 0 robot post.urdf -o baked --srdf gantry.srdf --believe post,carriage --believe bridge,post \
  --stop 0.05 --format image
grep -q '^bridge - post *believed *intersect at the witness; disabled in the SRDF and believed$' stdout ||
  fail "$(cat stdout)"
# Never is no more than that: not guarded for --stop, and no lack.
grep -q '^bridge - carriage *never *proven[^;]*$' stdout || fail "$(cat stdout)"
[ "$(head -n 1 stdout)" = "not guarded: table - bridge, bridge - post, carriage - post" ] ||
  fail "$(cat stdout)"
says 'not guarded: bridge - post, carriage - post (disabled in the SRDF and believed, though they may collide)'
"$FLASHBVH" guard baked/gantry.robot drive.csv >stdout 2>stderr || true
says 'not guarded: bridge - post, carriage - post (disabled in the SRDF and believed, though they may collide)'
refused "--believe table,carriage: names a pair that no SRDF disables" robot post.urdf -o out \
  --srdf gantry.srdf --believe table,carriage
refused "names a pair that no SRDF disables" robot post.urdf -o out --believe bridge,post
refused "names 'beam', which is no link that collides; these are table,bridge" robot post.urdf -o out \
  --srdf gantry.srdf --believe bridge,beam
refused "does not name LINK,LINK" robot post.urdf -o out --srdf gantry.srdf --believe bridge
refused "guards what --believe leaves out" robot post.urdf -o out --srdf gantry.srdf \
  --believe post,bridge --pair bridge,post=0.01
srdf '<disable_default_collisions link="post"/><enable_collisions link1="post" link2="bridge"/>'
refused 'gantry.srdf:2: disables carriage - post as "disable_default_collisions"' \
  robot post.urdf -o out --srdf gantry.srdf
srdf "<enable_collisions link1=\"table\" link2=\"bridge\"/>$(disables bridge table)"
exits 0 robot post.urdf -o baked --srdf gantry.srdf
says 'gantry.srdf:2: warning: disables table - bridge, which is enabled as well; it counts as disabled'
srdf "$(disables bridge carriage)"
exits 0 robot post.urdf -o baked --srdf gantry.srdf --believe carriage,bridge --pair table,post=0.01
says 'gantry.srdf:2: warning: bridge - carriage is never, with or without --believe bridge,carriage; leave that out' \
  "links 'table' and 'post' have a --pair, but no joint moves them; leave it out"

# Sizes: of a link whose scale was forgotten, and of a robot where all were; cells too coarse.
sized() {
  { echo '<robot name="sized">'
    link a "$(box "$1" '0 0 0')"
    link b "$(box "$2" '0 0 0')"
    link c "$(box "$3" '0 0 0')"
    joint one revolute a b "<origin xyz=\"0 0 0.3\"/><axis xyz=\"0 0 1\"/>$(limits -1 1)"
    joint two prismatic b c "<origin xyz=\"0 0 0.3\"/><axis xyz=\"0 0 1\"/>$(limits 0 "$4")"
    echo '</robot>'; } >sized.urdf
  exits 0 robot sized.urdf -o baked --stop 0.005
}
sized '0.2 0.1 0.1' '0.1 0.2 0.1' '78 20 21' 0.1
says "link 'c': warning: is 78 x 20 x 21 m, 390 times as long as the other links" 'scale="0.001 0.001 0.001"'
sized '0.2 0.1 0.1' '0.1 0.2 0.1' '0.001 0.002 0.003' 0.1
says "link 'c': warning: is 0.001 x 0.002 x 0.003 m, 1/66.7 times as long as the other links" 'leave out the scale'
sized '0.2 0.1 0.1' '0.1 0.2 0.1' '0.01 0.005 0.005' 0.1
grep -q warning stderr && fail "$(cat stderr)"
sized '200 100 100' '100 200 100' '100 100 150' 0.1
says 'has links of 200 m on joints at most 0.3 m apart; URDF is in metres'
sized '1 1 1' '1 1 1' '1 1 1' 1e9
says 'makes a cell of 1.91e+03 m, coarser than a tenth of the stop distance, 0.005 m, since a joint lies or slides 1e+09 m far' \
  "m for link 'a' of 1 x 1 x 1 m, since"

# Flash that is much: what larger leaves save.
{ echo '<robot name="large">'
  link a "$(for i in $(seq 130); do shape '<sphere radius="1"/>' "<origin xyz=\"$i 0 0\"/>"; done)"
  echo '</robot>'; } >large.urdf
exits 0 robot large.urdf -o baked --format image
flash=$(sed -n 's/.*; \([0-9]*\) bytes of flash, .*/\1/p' stdout)
saving=$(sed -n 's/^--leaf-size 5: \([0-9]*\) bytes of flash; .*/\1/p' stdout)
[ "$flash" -gt 1048576 ] && [ "$saving" -lt $((flash * 4 / 5)) ] || fail "$(cat stdout)"

# Limits that do not count, and a safety controller that only repeats them.
soft() {
  { echo '<robot name="soft">'; link a "$(box '1 1 1' '0 0 0')"; link b "$(box '1 1 1' '0 0 2')"
    joint turn revolute a b "$(limits -1 1)<safety_controller soft_lower_limit=\"$1\" soft_upper_limit=\"1.0\"/>"
    echo '</robot>'; } >soft.urdf
  exits 0 robot soft.urdf -o baked
}
soft -0.9
says 'has a <safety_controller> whose soft limits do not count, the <limit> does, of turn'
soft -1.0
grep -q safety stderr && fail "$(cat stderr)"

# What is no robot, and what is no name.
echo 'ISO-10303-21;' >x.step
refused "x.step: is a mesh or a model of CAD, which has no joints; name a URDF" robot x.step -o out
refused "is a mesh or a model of CAD" robot meshes/ring.stl -o out
echo '<mujoco/>' >x.xml
refused "x.xml: is a model of MuJoCo (MJCF), not a URDF; take the URDF" robot x.xml -o out
echo '<sdf/>' >x.sdf
refused "x.sdf: is a model of Gazebo (SDF" robot x.sdf -o out
refused "--name" robot gantry.urdf -o out --name ''
