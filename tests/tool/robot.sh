#!/bin/sh
# A robot from its URDF to C++ that compiles: tables, JSON, the same bytes each time, and what can't be
# made is refused before anything is written.
. "$SOURCES/common.sh"

# A base, a shoulder turned by -y with a mesh, a slide, and two fingers of which one follows the
# other, on a link without geometry.
link() { printf '<link name="%s">%s</link>\n' "$1" "$2"; }
shape() { printf '<collision>%s<geometry>%s</geometry></collision>' "${2-}" "$1"; }
joint() {
  printf '<joint name="%s" type="%s"><parent link="%s"/><child link="%s"/>%s</joint>\n' "$@"
}
limit='<limit lower="-1" upper="1.5" effort="1" velocity="1"/>'
arm() {
  echo '<robot name="two fingers">'
  link base "$(shape '<box size="0.2 0.2 0.1"/>')"
  link upper-arm "$(shape '<mesh filename="package://parts/ring.stl" scale="0.01 0.01 0.01"/>')"
  link class "$(shape '<cylinder radius="0.02" length="0.3"/>' '<origin rpy="0 1 0"/>')"
  link hand ""
  link finger.l "$(shape '<box size="0.01 0.02 0.05"/>')"
  link finger.r "$(shape '<sphere radius="0.02"/>')"
  joint turn revolute base upper-arm "<origin xyz=\"0 0 0.4\"/><axis xyz=\"0 -1 0\"/>$limit"
  joint slide prismatic upper-arm class "<axis xyz=\"0 0 1\"/>$limit"
  joint wrist continuous class hand '<axis xyz="0 0 1"/>'
  joint left revolute hand finger.l "<origin xyz=\"0 0.05 0\"/>$limit"
  joint right revolute hand finger.r \
    "<origin xyz=\"0 -0.05 0\"/>$limit<mimic joint=\"left\" multiplier=\"-0.5\"/>"
  echo '</robot>'
}
mkdir parts
cp meshes/ring.stl parts/
arm >arm.urdf
printf '<robot name="two fingers"><disable_collisions link1="base" link2="class" %s/></robot>\n' \
  'reason="Never"' >arm.srdf

exits 0 robot arm.urdf -o first --srdf arm.srdf --stop 0.005 --warn 0.01
grep -q '^upper-arm  turn  *[0-9]* *[0-9]*  package://parts/ring.stl$' stdout || fail "$(cat stdout)"
grep -q '^right  wrist  *revolute  *-0.75 to 0.5 rad, as left by -0.5$' stdout || fail "$(cat stdout)"
grep -q '^base - class *always *disabled in the SRDF: Never$' stdout || fail "$(cat stdout)"
grep -q '^base - finger.l *can *intersect at the witness$' stdout || fail "$(cat stdout)"
grep -q '^base - upper-arm *never *proven' stdout || fail "$(cat stdout)"
# It comes as near as 5 mm.
grep -q '^upper-arm - class *never *proven .*; guarded: may come within --stop$' stdout ||
  fail "$(cat stdout)"
grep -q "past its own limits" stderr && fail "$(cat stderr)"
[ "$(ls first | tr '\n' ' ')" = "two_fingers.robot.cpp two_fingers.robot.hpp " ] || fail "$(ls first)"

# The same bytes again, from elsewhere, with another locale; and no word of where or when.
mkdir elsewhere
cp -r arm.urdf arm.srdf parts elsewhere/
(cd elsewhere && LC_ALL=C.UTF-8 TZ=Asia/Tokyo "$FLASHBVH" robot arm.urdf -o ../second \
  --package parts=parts --srdf arm.srdf --stop 0.005 --warn 0.01 >/dev/null 2>&1)
diff -r first second || fail "other bytes"
grep -E 'arm\.|parts|/tmp|20[0-9][0-9]-' first/two_fingers.robot.?pp && fail "a path or a date"

# Strict compilers take it, and firmware finds its names.
cat >use.cpp <<'CPP'
#include "two_fingers.robot.hpp"
#include <cstdio>
using namespace two_fingers;
static_assert(kLinkCount == 5 && kJointCount == 5 && kVariableCount == 4 && kPairCount == 5, "");
static_assert(variables::left == 3 && links::finger_l == 3 && links::class_ == 2, "");
int main() {
  const flashbvh::Robot& r = robot;
  bool good = r.link_count == kLinkCount && r.pair_count == kPairCount && kFlashBytes > 1000;
  good = good && r.joints[0].fixed.rotation[1][2] == -flashbvh::kRotationOne;
  good = good && r.joints[4].multiplier / 0.5 == -static_cast<double>(1LL << r.joints[4].shift);
  good = good && r.links[0].joint == flashbvh::kBase && r.links[4].joint == 4;
  good = good && r.meshes[0].triangle_count == 12 && r.meshes[4].triangle_count == 320;
  good = good && r.meshes[0].unit == flashbvh::Unit::m;
  const double stop = r.pairs[0].stop / 256.0 * kCell;
  good = good && stop >= 0.005 && stop < 0.005 + kCell && r.pairs[0].warn >= 2 * r.pairs[0].stop - 1;
  std::printf("%s %zu\n", good ? "good" : "bad", sizeof(GuardState));
}
CPP
"$CXX" -std=c++17 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -I"$INCLUDE" -Ifirst \
  use.cpp first/two_fingers.robot.cpp -o use || fail "does not compile"
[ "$(./use)" = "good $(sed -n 's/.* flash, \([0-9]*\) bytes of RAM.*/\1/p' stdout)" ] ||
  fail "other numbers: $(./use)"

# One object.
exits 0 robot arm.urdf -o json --json --cell 0.0001
[ "$(wc -l <stdout)" -eq 1 ] || fail "not one line"
for part in '"pairs":\[{"a":"base","b":"upper-arm","verdict":"never","reason":"proven for all' \
  '"b":"finger.l","verdict":"can","reason":"intersect at the witness","witness":{"turn":' \
  '"links":\[{"name":"base","joint":null,"triangles":12,' '"cell":0.0001,' \
  '"flash_bytes":[0-9]*,"ram_bytes":[0-9]' \
  '"joints":\[{"name":"turn","type":"revolute","parent":null,"lower":-1.0,"upper":1.5,"variable":0}' \
  '"name":"right","type":"revolute","parent":"wrist","lower":-0.75,"upper":0.5,"variable":3,"multip'; do
  grep -q -- "$part" stdout || fail "no $part in $(cat stdout)"
done

# What is nearer than --stop wherever the robot stands makes a guard useless; --stop 0 does not.
exits 0 robot arm.urdf -o stopped --stop 0.5
grep -q "arm.urdf: warning: links 'base' and 'upper-arm' are nowhere found farther apart than the stop" \
  stderr || fail "$(cat stderr)"
exits 0 robot arm.urdf -o stopped
grep -q "nowhere found" stderr && fail "$(cat stderr)"

# A robot without joints, and one that is a keyword.
{ echo '<robot name="class">'; link only "$(shape '<box size="1 1 1"/>')"; echo '</robot>'; } >box.urdf
exits 0 robot box.urdf -o boxed
"$CXX" -std=c++17 -Wall -Wextra -Wconversion -Werror -I"$INCLUDE" -c boxed/class.robot.cpp -o object
grep -q '^namespace class_ {' boxed/class.robot.hpp || fail "$(cat boxed/class.robot.hpp)"

# A visual alone is said once.
sed 's/<link name="hand">/&<visual\/>/' arm.urdf >seen.urdf
exits 0 robot seen.urdf -o seen
grep -q "seen.urdf, link 'hand': warning: has a <visual> but no <collision>" stderr ||
  fail "$(cat stderr)"

refused "--output" robot arm.urdf
refused "gone.urdf" robot gone.urdf -o out
refused "give another --package parts=DIR" robot arm.urdf -o out --package parts=gone
refused "is no NAME=DIR" robot arm.urdf -o out --package parts
refused "is a second folder of parts" robot arm.urdf -o out --package parts=a --package parts=b
refused "the finest that does is --cell" robot arm.urdf -o out --cell 1e-9
refused "link 'base': is too large" robot arm.urdf -o out --cell 5.1e-6
refused "is no length" robot arm.urdf -o out --stop -1
refused "is nearer than --stop" robot arm.urdf -o out --stop 0.1 --warn 0.01
sed '/slide/s/<limit[^>]*>//' arm.urdf >unlimited.urdf
refused "joint 'slide': is prismatic without limits" robot unlimited.urdf -o out
