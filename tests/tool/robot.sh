#!/bin/sh
# A robot from its URDF to C++ that compiles: tables, JSON, the same bytes each time, and what can't be
# made is refused before anything is written.
. "$SOURCES/common.sh"

# A base, a shoulder turned by -y with a mesh, a slide, and two fingers of which one follows the
# other, on a link without geometry.
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

exits 0 robot arm.urdf -o first --srdf arm.srdf --believe base,class --stop 0.005 --warn 0.01
grep -q '^upper-arm  turn  *[0-9]* *[0-9]*  0.52 x 0.52 x 0.114 m  *package://parts/ring.stl$' stdout || fail "$(cat stdout)"
grep -q '^right  wrist  *revolute  *-0.75 to 0.5 rad, as left by -0.5$' stdout || fail "$(cat stdout)"
grep -q '^base - class *believed *intersect at the witness; disabled in the SRDF and believed$' stdout || fail "$(cat stdout)"
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
  --package parts=parts --srdf arm.srdf --believe base,class --stop 0.005 --warn 0.01 --format both >/dev/null 2>&1)
mkdir image
mv second/two_fingers.robot image/
diff -r first second || fail "other bytes"
grep -E 'arm\.|parts|/tmp|20[0-9][0-9]-' first/two_fingers.robot.?pp && fail "a path or a date"

# Strict compilers take it, and firmware finds its names.
cat >use.cpp <<'CPP'
#include "two_fingers.robot.hpp"
#include <cstdio>
#include "flashbvh/robot/motion.hpp"
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
  using MotionState = flashbvh::MotionStateOf<kVariableCount, kJointCount>;
  std::fprintf(stderr, "%zu\n", sizeof(MotionState));
}
CPP
"$CXX" -std=c++17 -Wall -Wextra -Wconversion -Wshadow -pedantic -Werror -I"$INCLUDE" -Ifirst \
  use.cpp first/two_fingers.robot.cpp -o use || fail "does not compile"
[ "$(./use 2>motion_bytes)" = "good $(sed -n 's/.* flash, \([0-9]*\) bytes of RAM.*/\1/p' stdout)" ] ||
  fail "other numbers: $(./use)"

# The image is of the same robot.
grep -aE 'arm\.|parts|/tmp|20[0-9][0-9]-' image/two_fingers.robot && fail "a path or a date"
cat >open.cpp <<'CPP'
#include "flashbvh/robot/image.hpp"
#include "two_fingers.robot.hpp"
#include <cstdio>
int main() {
  alignas(4) static unsigned char image[1 << 17];
  flashbvh::PostMesh meshes[two_fingers::kLinkCount];
  flashbvh::Robot robot;
  std::FILE* const file = std::fopen("image/two_fingers.robot", "rb");
  const std::size_t size = std::fread(image, 1, sizeof image, file);
  const bool good = flashbvh::open_robot(image, size, meshes, two_fingers::kLinkCount, robot) ==
                        flashbvh::Status::done &&
                    robot.hash == two_fingers::robot.hash;
  std::printf("%s %s %s\n", good ? "good" : "bad", flashbvh::joint_name(image, 2),
              flashbvh::link_name(image, 1));
}
CPP
lib=$INCLUDE/../src
"$CXX" -std=c++17 -Wall -Wextra -Werror -I"$INCLUDE" -Ifirst open.cpp first/two_fingers.robot.cpp \
  "$lib"/lattice/*.cpp "$lib"/robot/chart.cpp "$lib"/robot/image.cpp "$lib"/robot/robot_check.cpp "$lib"/robot/spheres.cpp \
  "$lib"/predicates/*.cpp "$lib"/bounds/*.cpp -o open || fail "does not compile"
[ "$(./open)" = "good wrist upper-arm" ] || fail "$(./open)"

# What is in it.
exits 0 check image/two_fingers.robot
grep -qE '^two_fingers: well-formed, a robot of [0-9]+ joints, [0-9]+ links with [0-9]+ triangles, [0-9]+ pairs' \
  stdout || fail "$(cat stdout)"
exits 0 check image/two_fingers.robot --json
grep -qF '{"image":"image/two_fingers.robot","ok":true,"kind":"robot","joints":' stdout || fail "$(cat stdout)"
refused "image/two_fingers.robot: is a robot's image, which --mesh can't be compared to" \
  check image/two_fingers.robot --mesh arm.stl
exits 0 info image/two_fingers.robot
grep -q "^robot two_fingers, format version 2: $(wc -c <image/two_fingers.robot) bytes of flash; " stdout ||
  fail "$(cat stdout)"
grep -q '^right  wrist  *revolute  *-0.75 to 0.5 rad, as left by -0.5$' stdout || fail "$(cat stdout)"
grep -q '^base - finger.l  0.005, 0.01$' stdout || fail "$(cat stdout)"
exits 0 info image/two_fingers.robot --json
for part in '^{"name":"two_fingers","format_version":2,"bytes":' '"a":"base","b":"finger.l","stop":0.005' \
  '{"name":"finger.r","joint":"right","triangles":320,"size":\[0.0407' '"name":"right","type":"revolute","parent":"wrist"'; do
  grep -q -- "$part" stdout || fail "no $part in $(cat stdout)"
done

# What is none: told apart.
damaged() {
  printf "$1" | dd of=bad.robot bs=1 seek="$2" conv=notrunc 2>/dev/null
  refused "$3" info bad.robot
  refused "$3" check bad.robot
  refused "$3" guard bad.robot nothing.csv
  cp image/two_fingers.robot bad.robot
}
cp image/two_fingers.robot bad.robot
damaged X 0 "bad.robot: is no image of a robot; name one"
damaged '\011' 4 "bad.robot: is written in version 9 of the robots' image format"
damaged X 60 "bad.robot: is corrupt: a checksum does not match; copy or bake it again"
damaged X "$(($(wc -c <bad.robot) - 9))" "bad.robot: is corrupt"
damaged XX "$(wc -c <bad.robot)" "bad.robot: has 2 bytes after its end"
head -c 40 image/two_fingers.robot >bad.robot
refused "is truncated: it has 40 bytes and needs a header of 52" info bad.robot
head -c 400 image/two_fingers.robot >bad.robot
refused "is truncated: it has 400 bytes of $(wc -c <image/two_fingers.robot)" info bad.robot
refused "gone.robot" info gone.robot
refused "--format" robot arm.urdf -o out --format fbx

# A page: what --json has, nothing from elsewhere.
options="--srdf arm.srdf --believe base,class --stop 0.005 --warn 0.01"
exits 0 robot arm.urdf -o first $options --json --report page.html
[ "$(wc -l <stdout)" -eq 1 ] || fail "not one line"
for part in '"pairs":\[{"a":"base","b":"upper-arm","verdict":"never","reason":"proven for all' \
  '"b":"finger.l","verdict":"can","reason":"intersect at the witness","witness":{"turn":' \
  '"links":\[{"name":"base","joint":null,"triangles":12,' '"cell":[0-9.e-]*,' \
  '"flash_bytes":[0-9]*,"ram_bytes":[0-9]' \
  '"joints":\[{"name":"turn","type":"revolute","parent":null,"lower":-1.0,"upper":1.5,"variable":0}' \
  '"name":"right","type":"revolute","parent":"wrist","lower":-0.75,"upper":0.5,"variable":3,"multip'; do
  grep -q -- "$part" stdout || fail "no $part in $(cat stdout)"
done
diff -r first second || fail "--report changes what is written"
self_contained page.html
value() { sed "s/.*\"$1\":\([0-9]*\).*/\1/" stdout | sed ':a; s/\([0-9]\)\([0-9]\{3\}\)\(,\|$\)/\1,\2\3/; ta'; }
holds page.html '<!DOCTYPE html>' '<h1>two fingers</h1>' '<dd>0.005 m, 0.01 m<' \
  "<dd>$(value flash_bytes) bytes<" "<dd>$(value ram_bytes) bytes<" "<dd>$(cat motion_bytes) bytes<" \
  '<dd>5 of 10<' '-0.75 to 0.5 rad, as left by -0.5' 'package://parts/ring.stl'
# Each pair in words, and twice in the matrix; each that can collide as two pictures at its witness.
sed 's/"links":.*//; s/{"a":/\n&/g' stdout | sed -n 's/^{"a":"\([^"]*\)","b":"\([^"]*\)","verdict":"\([a-z]*\)","reason":"\([^"]*\)","witness":{\(.*\)},"cells":\([0-9]*\),"guarded":\([a-z]*\).*/\1|\2|\3|\4|\6|\7/p' >pairs
[ "$(wc -l <pairs)" -eq 10 ] || fail "$(cat pairs)"
sed 's/<[^>]*>/|/g; s/&ndash;/-/; s/|||*/|/g; s/,//g' page.html >rows
while IFS='|' read -r a b verdict reason cells guarded; do
  [ "$guarded" = true ] && guard=guarded || guard=-
  grep -qxF "|$a - $b|$verdict|$guard|$cells|$(echo "$reason" | tr -d ,)|" rows || fail "no $a - $b, $reason"
done <pairs
for verdict in never can believed; do
  [ "$(grep -o "<td class=is-$verdict>" page.html | wc -l)" -eq $((2 * $(grep -c "|$verdict|" pairs))) ] ||
    fail "$verdict in the matrix"
done
can=$(grep -c '|can|' pairs)
[ "$(grep -c '<g class="faces"><path' page.html)" -eq $((4 + 2 * can)) ] || fail "pictures"
[ "$(grep -c 'paint3\"></i>two triangles that intersect' page.html)" -eq "$can" ] || fail "keys"
[ "$(grep -c '^<p class=note>Joints: <code>turn ' page.html)" -eq "$can" ] || fail "joints of witnesses"
# The same in C, as strict: its names, and what they stand for.
exits 0 robot arm.urdf -o in_c --format c --srdf arm.srdf --believe base,class --stop 0.005 --warn 0.01 --depfile c.d
grep -q '/in_c/two_fingers.robot.h:' c.d || fail "$(cat c.d)"
cat >use.c <<'C'
#include "two_fingers.robot.h"
int main(void) {
  const flashbvh_robot* const r = &two_fingers_robot;
  bool good = r->link_count == two_fingers_LINK_COUNT && r->pair_count == two_fingers_PAIR_COUNT;
  good = good && two_fingers_JOINT_COUNT == 5 && two_fingers_VARIABLE_COUNT == 4;
  good = good && two_fingers_variable_left == 3 && two_fingers_link_finger_l == 3;
  good = good && two_fingers_link_class == 2 && two_fingers_mount_hand.joint == 2;
  good = good && r->reach_count == two_fingers_REACH_COUNT && r->links[0].joint == FLASHBVH_BASE;
  good = good && r->joints[1].type == FLASHBVH_JOINT_PRISMATIC && sizeof(flashbvh_mesh_view) > 0;
  return good && ((const flashbvh_mesh_view*)r->meshes)[4].triangle_count == 320 ? 0 : 1;
}
C
for standard in 99 11; do
  "${CC:-cc}" -std=c$standard -Wall -Wextra -Wconversion -pedantic -Werror -I"$INCLUDE" -Iin_c \
    use.c in_c/two_fingers.robot.c -o use || fail "no C$standard"
  ./use || fail "other numbers in C"
done

# A robot without joints, and one that is a keyword.
{ echo '<robot name="class">'; link only "$(shape '<box size="1 1 1"/>')"; echo '</robot>'; } >box.urdf
exits 0 robot box.urdf -o boxed
"$CXX" -std=c++17 -Wall -Wextra -Wconversion -Werror -I"$INCLUDE" -c boxed/class.robot.cpp -o object
grep -q '^namespace class_ {' boxed/class.robot.hpp || fail "$(cat boxed/class.robot.hpp)"
exits 0 robot box.urdf -o boxed --format c
"${CC:-cc}" -std=c99 -Wall -Wextra -pedantic -Werror -I"$INCLUDE" -c boxed/class.robot.c -o object
grep -q '^extern const flashbvh_robot class_robot;' boxed/class.robot.h || fail "$(cat boxed/class.robot.h)"

exits 0 robot box.urdf -o boxed --json --cell 0.0001
grep -q '"cell":0.0001,' stdout || fail "$(cat stdout)"
exits 0 robot box.urdf -o box_image --format image --depfile box.d
[ "$(ls box_image)" = "class.robot" ] || fail "$(ls box_image)"
grep -q '/box_image/class.robot: ' box.d || fail "$(cat box.d)"

# A visual alone is said once.
{ echo '<robot name="seen">'; link base "$(shape '<box size="1 1 1"/>')"; link hand '<visual/>'
  joint on fixed base hand; echo '</robot>'; } >seen.urdf
exits 0 robot seen.urdf -o seen
grep -q "seen.urdf, link 'hand': warning: has a <visual> but no <collision>" stderr ||
  fail "$(cat stderr)"

# What is nearer than --stop wherever the robot stands makes a guard useless; --stop 0 does not.
{ echo '<robot name="two">'; link base "$(shape '<box size="0.2 0.2 0.1"/>')"
  link upper-arm "$(shape '<mesh filename="package://parts/ring.stl" scale="0.01 0.01 0.01"/>')"
  joint turn revolute base upper-arm "<origin xyz=\"0 0 0.2\"/><axis xyz=\"0 -1 0\"/>$limit"
  echo '</robot>'; } >two.urdf
exits 0 robot two.urdf -o stopped --stop 0.5
grep -q "two.urdf: warning: links 'base' and 'upper-arm' are nowhere found farther apart than the stop" \
  stderr || fail "$(cat stderr)"
exits 0 robot two.urdf -o stopped --warn 0.5
grep -q "farther apart than the warn distance, 0.5 m, so a guard would never say free" stderr ||
  fail "$(cat stderr)"
exits 0 robot two.urdf -o stopped
grep -q "nowhere found" stderr && fail "$(cat stderr)"

# No input is replaced, and no other output.
echo '<robot name="two"/>' | tee two.srdf >same.srdf
for page in two.urdf two.srdf ./parts/ring.stl; do
  refused "$page: would replace" robot two.urdf -o out --srdf two.srdf --report $page
done
cmp two.srdf same.srdf
# A page has the same bytes from elsewhere.
cp two.urdf elsewhere/
exits 0 robot two.urdf -o stopped --report two.html
(cd elsewhere && LC_ALL=C.UTF-8 TZ=Asia/Tokyo "$FLASHBVH" robot two.urdf -o ../stopped \
  --report ../again.html >/dev/null 2>&1)
cmp two.html again.html || fail "another page"
refused "would be written twice" robot box.urdf -o out --report ./out/class.robot.cpp

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
