"""Honest mistakes: each is answered by its place and its fix."""
import re
from pathlib import Path

from cli import Case, flashbvh, hold, write
from inputs import box_of, images, joint, link, robot, shape
from test_guard import arm

NO_IMAGE = "is no flashbvh image; name a .fbvh file, which `flashbvh bake` writes"
POSE = "numbers; a pose has 12: ..., separated by blanks, without a header, such as 1 0 0 0"
# Commands, their exit codes unless they are 2, and the beginnings of their messages; "..." leaves a part out.
TABLE = {
    "bake plate.obj -o out --unit millimetres": "--unit millimetres: 'millimetres' is no unit; give nm, um, mm, cm,",
    "bake plate.obj -o out --units mm": "The following argument was not expected: --units; see flashbvh bake --help",
    "bake plate.obj -o out --unit m --max-deviation 0.001": "plate.obj: rounding ...: cut or convert it: --unit",
    "bake plate.obj -o /proc/out": "/proc/out: can't be made: ...; write elsewhere",
    "collide meshes/ring.stl post/ring.fbvh --poses home": f"meshes/ring.stl: {NO_IMAGE}",
    "collide image/arm.robot post/ring.fbvh --poses home": f"image/arm.robot: {NO_IMAGE}",
    "collide post/ring.fbvh coarser/ring.fbvh --poses home": "coarser/ring.fbvh: has a cell of ...; bake both in",
    "collide post/ring.fbvh post/ring.fbvh --poses poses.csv": f"poses.csv:1: has 1 {POSE}",
    "clearance post/ring.fbvh post/ring.fbvh --poses angles.csv": f"angles.csv:1: has 6 {POSE}",
    "motion post/ring.fbvh post/ring.fbvh --from 0,0,5 --to '0 0 0'": "--from: has 1 numbers; ..., separated by blanks",
    "guard post/ring.fbvh free.csv": "post/ring.fbvh: is no text, so no XML; correct it there, or name a URDF",
    "guard free.csv arm.urdf": "free.csv:1: is no XML: syntax error; correct it there, or name a URDF",
    "guard still.urdf free.csv": "still.urdf: has no joint that moves, ...; give it one, or bake its links'",
    "guard arm.urdf bare.csv": "bare.csv:1: has the value '0' ...; put a first line ... names all ...: turn,fold,grip",
    "guard arm.urdf names.csv": "names.csv:1: the column 'elbow' is no joint ...; its joints are turn,fold,grip",
    "guard arm.urdf two.csv": "two.csv:1: has no column 'grip'; the first line names all joints ...: turn,fold,grip",
    "guard arm.urdf few.csv": "few.csv:2: has 1 value, the first line names 3 columns; give each one",
    "guard arm.urdf nan.csv": "nan.csv:2: 'nan' in the column 'fold' is no finite number; give radians, or metres",
    "guard arm.urdf free.csv --work 0": "--work: Value 0 not in range 1 to 4294967294; see flashbvh guard --help",
    "guard arm.urdf free.csv --core RV32IMAC --clock 100": "--core requires --hz; see flashbvh guard --help",
    "guard arm.urdf free.csv --core Cortex-M4": "--core: Cortex-M4 not in {cortex-m3,cortex-m4f,rv32imac}; see",
    "guard arm.urdf free.csv --stop 0.1 --warn 0.01": "--warn 0.01: is nearer than --stop 0.1; warn from further off",
    "robot arm.urdf -o out --srdf arm.urdf": "arm.urdf: is a URDF; name the SRDF, which has <disable_collisions>",
    "robot arm.urdf -o out --stop -0.005": "--stop -0.005: is no length; give a number from 0, in metres",
    "robot arm.urdf -o out --stop 5": "--stop 5: is out of range: 0 to 0.4... m, 32767 cells; ...: 5 mm is 0.005",
    "robot arm.urdf -o out --zone elbow=0.1": "--zone elbow=0.1: names 'elbow', ...; without --zone the tables",
    "robot packed.urdf -o out": "packed.urdf, link 'base': the mesh ...; say where ... by --package my_arm=DIR",
    "robot packed.urdf -o out --package my_arm=.": "packed.urdf, link 'base': ... no ./base.stl; give another",
    "robot arm.urdf.xacro -o out": "arm.urdf.xacro:1: is a xacro ...; write `xacro arm.urdf.xacro > OUT.urdf`",
    "bake plate.obj -o wide --unit m": (0, "plate.obj: warning: is 100 x 100 x 1 m...; if it is in mm, add --unit"),
    "guard image/arm.robot degrees.csv": (3, "degrees.csv:2: joint 'fold' ...; in degrees? give radians: -0.785398"),
    "guard image/arm.robot mm.csv": (3, "mm.csv:2: joint 'grip' can't be at 20: firmware takes ...; in millimetres? "
        "give metres: 0.02\nflashbvh: mm.csv:3: ... its limits are -0.09...; in millimetres? give metres: 0.002"),
}
FILES = {"degrees": "turn,fold,grip\n0,-45,0", "mm": "fold,turn,grip\n0,0,20\n0,0,2", "bare": "0,0,0.05\n0,0.1,0.05",
         "names": "turn,elbow,grip\n0,0,0", "two": "turn,fold\n0,0", "few": "turn,fold,grip\n0",
         "nan": "turn,fold,grip\n0,nan,0", "poses": "1,0,0,0,1,0,0,0,1,0,0,5", "angles": "x y z roll pitch yaw"}


class MistakesTest(Case):
    inputs = images, arm

    def test_each_is_answered_by_place_and_fix(self):
        for name, content in FILES.items():
            write(f"{name}.csv", content)
        write("plate.obj", "v 0 0 0\nv 100 0 0\nv 0 100 1\nf 1 2 3")
        robot("packed", link("base", shape('<mesh filename="package://my_arm/base.stl"/>')),
              link("tip", box_of("1 1 1")), joint("turn", "revolute", "base", "tip", "", (-1, 1)))
        write("arm.urdf.xacro", '<robot name="arm"><xacro:arm/></robot>')
        for command, row in TABLE.items():
            with self.subTest(command):
                code, beginning = row if isinstance(row, tuple) else (2, row)
                out = flashbvh(command, code=code)
                out.err.matches(r"\Aflashbvh: " + ".*".join(map(re.escape, beginning.split("..."))))
                hold(code != 2 or not out and out.err.count("\n") == 1 and not any(Path(".").rglob("out*")), out.err)
