"""A robot from its URDF to an image, for C and C++ and as a file: tables, JSON, equal bytes each time; impossible
requests are refused before any file is written."""
import os
import re
import shutil
from pathlib import Path

from cli import (Case, compiled, elsewhere, fixture, flashbvh, headlines, page_data, refuse, refuse_each, same,
                 self_contained, size, text)
from inputs import box_of, joint, link, OPTIONS, robot, two_fingers


@fixture
def one_box():
    robot("class", link("only", box_of("1 1 1")), link("lid", box_of("1 1 1", "0 0 2")),
          joint("turn", "continuous", "only", "lid", '<axis xyz="0 0 1"/>'))
    os.rename("class.urdf", "box.urdf")


class RobotTest(Case):
    inputs = two_fingers,

    def test_what_it_prints_and_the_same_bytes_again_from_elsewhere_in_any_form_and_with_another_locale(self):
        out = flashbvh(f"robot arm.urdf -o second {OPTIONS}")
        out.matches(
            "^upper-arm  turn  *[0-9]* *[0-9]*  0.52 x 0.52 x 0.114 m  *package://parts/ring.stl$",
            "^right  wrist  *revolute  *-0.75 to 0.5 rad, as left by -0.5$",
            "^base - class *believed *intersect at the witness; disabled in the SRDF and believed$",
            "^base - finger.l *can *intersect at the witness$",
            "^base - upper-arm *never *proven",
            "^upper-arm - class *never *proven .*; guarded: may come within --stop$")
        out.err.lacks("past its own limits")
        self.assertEqual(sorted(os.listdir("first")), ["two_fingers.robot.c", "two_fingers.robot.h"])
        same("first", "second")
        Path("elsewhere").mkdir()
        for name in ("arm.urdf", "arm.srdf", "parts"):
            shutil.move(name, "elsewhere")
        elsewhere(f"robot arm.urdf -o ../second --package parts=parts {OPTIONS} --format both --report ../again.html")
        shutil.move("second/two_fingers.robot", "other.robot")
        same("first", "second")
        same("page.html", "again.html")
        same("image/two_fingers.robot", "other.robot")
        self.assertFalse(any(re.search(r"arm\.|parts|/tmp|20[0-9][0-9]-", text(file))
                             for file in [*Path("first").iterdir(), "other.robot"]))

    def test_the_array_in_c_has_the_bytes_of_the_image(self):
        words = re.findall("0x[0-9a-f]{8}", text("first/two_fingers.robot.c"))
        image = b"".join(int(word, 16).to_bytes(4, "little") for word in words)
        self.assertEqual(image, Path("image/two_fingers.robot").read_bytes())

    def test_info_says_what_is_in_an_image(self):
        flashbvh("info image/two_fingers.robot").matches(
            "^two_fingers: well-formed, a robot$",
            f"^robot two_fingers, format version 5: {size('image/two_fingers.robot')} bytes of flash;",
            "^right  wrist  *revolute  *-0.75 to 0.5 rad, as left by -0.5$",
            "^base - finger.l *0.005 *0.01$")
        flashbvh("info image/two_fingers.robot --json").contains(
            '{"name":"two_fingers","format_version":5,"bytes":',
            '"a":"base","b":"finger.l","stop":0.005',
            '{"name":"finger.r","joint":"right","triangles":320,"size":[0.0407',
            '"name":"right","type":"revolute","parent":"wrist"')

    def test_a_damaged_image_is_refused_by_info_and_guard(self):
        whole = Path("image/two_fingers.robot").read_bytes()
        for content, wanted in (
                (b"X" + whole[1:], "bad.robot: is no image of a robot; name one"),
                (whole[:4] + b"\t" + whole[5:], "bad.robot: is written in version 9 of the image format"),
                (whole[:60] + b"X" + whole[61:],
                 "bad.robot: is corrupt: a checksum does not match; copy or bake it again"),
                (whole + b"XX", "bad.robot: has 2 bytes after its end"),
                (whole[:40], "is truncated: it has 40 bytes and needs a header of 52"),
                (whole[:400], f"is truncated: it has 400 bytes of {len(whole)}")):
            Path("bad.robot").write_bytes(content)
            for command in "info bad.robot", "guard bad.robot nothing.csv":
                refuse(command, wanted)

    def test_a_page_has_what_json_has_on_one_line_and_nothing_from_elsewhere(self):
        self_contained("page.html")
        self.assertEqual(text("json").count("\n"), 1)
        said = text("json").json
        self.assertEqual(page_data("page.html")["facts"], [said])
        self.assertEqual(len(said["pairs"]), 10)
        self.assertEqual(headlines("page.html")[-1], "Guarded: 5 of 10 pairs of links")
        self.assertEqual([said["pairs"][0][name] for name in ("a", "b", "verdict")], ["base", "upper-arm", "never"])
        self.assertEqual((said["links"][0]["joint"], said["links"][0]["triangles"]), (None, 12))
        self.assertEqual(said["joints"][0], {"name": "turn", "type": "revolute", "parent": None, "lower": -1,
                                             "upper": 1.5, "variable": 0})
        self.assertEqual(said["joints"][4], {"name": "right", "type": "revolute", "parent": "wrist", "lower": -0.75,
                                             "upper": 0.5, "variable": 3, "multiplier": -0.5, "offset": 0})

    def test_a_robot_that_is_a_keyword(self):
        one_box()
        flashbvh("robot box.urdf -o boxed")
        compiled("-std=c++17", "-x", "c++", "-c", "boxed/class.robot.c", "-o", "object",
                 strict=("-Wall", "-Wextra", "-Wconversion", "-Werror"))
        text("boxed/class.robot.h").matches(r"^extern const uint32_t class_robot_image\[")
        flashbvh("robot box.urdf --dry-run --json --cell 0.0001").contains('"cell":0.0001,')
        refuse("robot box.urdf -o out --report ./out/class.robot.c", "would be written twice")

    def test_a_depfile_names_what_is_written_and_what_is_read(self):
        one_box()
        flashbvh("robot box.urdf --dry-run --depfile dry.d")
        self.assertTrue(text("dry.d").startswith(str(Path("class.robot.h").resolve()) + ":"))
        os.mkdir("my $ #box")
        os.rename("box.urdf", "my $ #box/box.urdf")
        flashbvh('robot "my $ #box/box.urdf" -o "my box" --format image --depfile box.d')
        self.assertEqual(os.listdir("my box"), ["class.robot"])
        text("box.d").contains("/my\\ box/class.robot:", "/my\\ $$\\ \\#box/box.urdf")

    def test_what_is_nearer_than_stop_wherever_the_robot_stands_makes_a_guard_useless_stop_0_does_not(self):
        robot("two", link("base", box_of("0.2 0.2 0.1")), link("upper-arm", box_of("0.52 0.52 0.114")),
              joint("turn", "revolute", "base", "upper-arm", '<origin xyz="0 0 0.2"/><axis xyz="0 -1 0"/>', (-1, 1.5)))
        flashbvh("robot two.urdf -o stopped --stop 0.5 --zone turn=0").err.contains(
            "two.urdf: warning: links 'base' and 'upper-arm' are nowhere found farther apart than the stop")
        refuse("robot two.urdf -o out --stop 0.5 --zone turn=0 --limit",
               "two.urdf: --limit: links 'base' and 'upper-arm' are nowhere found farther apart than their stop "
               "distance, 0.5 m, and a tenth; limit() could never let them out; lower it")
        flashbvh("robot two.urdf -o stopped --stop 0.5 --limit")
        far = "farther apart than the warn distance, 0.5 m, so "
        flashbvh("robot two.urdf -o stopped --warn 0.5 --zone turn=0").err.contains(
            far + "they are not warned of; --pair base,upper-arm=STOP,WARN warns")
        flashbvh("robot two.urdf -o stopped --pair base,upper-arm=0,0.5 --zone turn=0").err.contains(
            far + "a guard would never say free")
        # Neighbours are not guarded about their joint, where they are near.
        flashbvh("robot two.urdf -o stopped --stop 0.5").err.lacks("nowhere found")
        flashbvh("robot two.urdf -o stopped").err.lacks("nowhere found")

    def test_what_cant_be_made_is_refused(self):
        refuse_each("robot", {
            "arm.urdf": "--output or --dry-run",
            "gone.urdf -o out": "gone.urdf",
            "arm.urdf -o out --format fbx": "--format",
            "arm.urdf -o out --package parts": "is no NAME=DIR",
            "arm.urdf -o out --package parts=a --package parts=b": "is a second folder of parts",
            "arm.urdf -o out --cell 1e-9": "the finest that does is --cell",
            "arm.urdf -o out --cell 5.1e-6": "link 'base': is too large",
        })
