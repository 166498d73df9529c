"""Meaningless command lines are refused with one line that names the help."""
import itertools
import os
import shutil
import struct
import zlib
from pathlib import Path

from cli import Case, flashbvh, refuse, refuse_each, write
from inputs import box_of, images, joint, link, robot, shape


def damaged(offset, content, target):
    """A copy of images/t.fbvh with these bytes at the offset and a checksum that matches; or, if they are None, with
    one inverted byte and a checksum that does not."""
    data = bytearray(Path("images/t.fbvh").read_bytes())
    if content is None:
        data[offset] ^= 255
    else:
        data[offset:offset + len(content)] = content
        data[12:16] = struct.pack("<I", zlib.crc32(data[:12] + data[16:]))
    Path(target).write_bytes(data)


def kept(file, link, command):
    """With `link`, another name of a file, as output, the command is refused and the file unchanged."""
    Path(link).parent.mkdir(exist_ok=True)
    os.link(file, link)
    before = Path(file).read_bytes()
    flashbvh(command, code=2).err.matches("would replace|is an image, which would be replaced")
    assert Path(file).read_bytes() == before
    os.remove(link)


class RefusalsTest(Case):
    inputs = images,

    def test_of_bake_before_any_file_is_read(self):
        refuse_each("", {
            "": "a command is missing",
            "bake": "required",
            "info": "required",
            "bake meshes/ring.stl": "--output",
            "bake meshes/ring.stl meshes/coarse.stl -o out --name both": "--name",
            "bake missing.stl -o out --max-deviation abc": "--max-deviation abc",
            "bake missing.stl -o out --cell abc": "--cell abc",
        })
        refuse_each("bake meshes/ring.stl -o out", {
            **{option: option.split()[0] for option in (
                "--layout random", "--builder sah2", "--leaf-size 0", "--leaf-size 17",
                "--arity 1", "--arity 9", "--index-bits 8", "--cell 0", "--cell -1", "--cell nan", "--cell inf",
                "--cell 1e-300", "--cell 1e300", "--cell abc", "--cell ''")},
            "--index-bits x": "--index-bits: x not in {16,32}",
            '--name ""': "--name: is empty; give a name",
            "--name __x": "--name __x: is a name that C or C++ takes; use another, such as m__x",
            "--name 2nd": "--name 2nd",
        })

    # For each byte: tests/golden/damage_test.cpp. The root's link is at 0x58; the last words are the vertices (four of
    # six bytes), the shell's first vertex with two zeros, and the name.
    def test_damaged_images(self):
        flashbvh("bake meshes/tetrahedron.stl -o images --name t --format image")
        whole = Path("images/t.fbvh").read_bytes()
        for offset, content, wanted in (
                (len(whole) // 2, None, "is corrupt"),
                (0x58, b"\1\0\1\0", "is invalid"),
                (4, b"\t\0\1\x10", "is written in version 9")):
            damaged(offset, content, "bad.fbvh")
            for command in ("info bad.fbvh", "collide bad.fbvh images/t.fbvh --poses home --pairs out",
                            "collide images/t.fbvh bad.fbvh --poses home --pairs out"):
                refuse(command, f"bad.fbvh: {wanted}")
        for content, wanted in (
                (whole[:-1], "bad.fbvh: is truncated"),
                (whole[:20], "bad.fbvh: is truncated"),
                (whole * 2, f"bad.fbvh: has {len(whole)} bytes after its end")):
            Path("bad.fbvh").write_bytes(content)
            refuse("info bad.fbvh", wanted)
        # `info` detects a wrong deviation and a wrong shell of a vertex; the library does not.
        for offset, content, wanted in (
                (68, b"\7\0", "its deviation in cells is not that in its unit; bake it again"),
                (len(whole) - 8, b"\2\0\0\0",
                 "its vertices of shells are not those that its triangles make; bake it again")):
            damaged(offset, content, "wrong.fbvh")
            refuse("info wrong.fbvh", f"wrong.fbvh: is invalid: {wanted}")

    def test_images_that_are_none(self):
        write("empty.fbvh", "")
        refuse_each("", {
            "info missing.fbvh": "missing.fbvh: can't be opened",
            "info empty.fbvh": "empty.fbvh: is empty",
            "collide post/ring.fbvh post/ring.fbvh --poses home --pairs meshes": "meshes: is a folder",
        })

    def test_a_slip_costs_no_image(self):
        shutil.copy("post/ring.fbvh", "kept.fbvh")
        os.symlink("post/ring.fbvh", "link")
        refuse_each("collide post/ring.fbvh post/ring.fbvh --poses home --pairs", {
            **{file: f"{file}: is an image, which would be replaced; write elsewhere"
               for file in ("post/ring.fbvh", "kept.fbvh", "link")},
            "./home": "./home: would replace home, which is read; write elsewhere",
        })

    def test_no_command_replaces_a_file_that_it_reads_every_output_with_every_input(self):
        flashbvh("bake meshes/ring.stl -o images --format image")
        Path("elsewhere").mkdir()
        shutil.copy("meshes/tetrahedron.stl", "elsewhere/part.stl")
        robot("arm", link("base", shape('<mesh filename="elsewhere/part.stl" scale="0.1 0.1 0.1"/>')),
              link("tip", box_of("0.1 0.1 0.1")),
              joint("turn", "revolute", "base", "tip", '<origin xyz="2 0 0"/><axis xyz="0 0 1"/>', (-1, 1)))
        write("arm.srdf", '<robot name="arm"></robot>')
        write("way.csv", "turn\n0")
        flashbvh("robot arm.urdf -o baked --format image")
        two = "images/ring.fbvh images/ring.fbvh"
        robot_files = "arm.urdf arm.srdf elsewhere/part.stl"
        for inputs, outputs, arguments in (
                ("meshes/ring.stl", "to/ring.fbvh to/ring.fbvh.h to/ring.fbvh.c",
                 "bake meshes/ring.stl -o to --format both"),
                ("images/ring.fbvh home", "to/x", f"report {two} --poses home -o to/x"),
                ("images/ring.fbvh home", "to/x", f"collide {two} --poses home --pairs to/x"),
                (robot_files, "to/arm.robot to/arm.robot.h to/arm.robot.c",
                 "robot arm.urdf --srdf arm.srdf -o to --format both"),
                (robot_files, "to/x", "robot arm.urdf --srdf arm.srdf -o to --depfile to/x"),
                (robot_files, "to/x", "robot arm.urdf --srdf arm.srdf -o to --report to/x"),
                ("arm.urdf elsewhere/part.stl way.csv", "to/x", "guard arm.urdf way.csv --report to/x"),
                ("baked/arm.robot way.csv", "to/x", "guard baked/arm.robot way.csv --report to/x")):
            for file, output in itertools.product(inputs.split(), outputs.split()):
                with self.subTest((file, output, arguments)):
                    kept(file, output, arguments)

    def test_where_nothing_can_be_written_nothing_is_left_over(self):
        write("plain_file", "")
        refuse("bake meshes/ring.stl -o plain_file/out", "plain_file: is no folder; write elsewhere")
        Path("taken/ring.fbvh.c").mkdir(parents=True)
        refuse("bake meshes/ring.stl -o taken", "ring.fbvh.c: is a folder")
        self.assertEqual(os.listdir("taken"), ["ring.fbvh.c"])

    def test_version(self):
        flashbvh("--version").matches(r"\Aflashbvh [0-9]*\.[0-9]*\.[0-9]*$")

    # Refused with the line, before any file is written.
    def test_poses_that_cant_be_answered(self):
        no_rotation = "the first 9 numbers are no rotation"
        for line, wanted in (
                ("1 0 0 0 1 0 0 0 1 0 0 x", "'x'"),
                ("2 0 0 0 1 0 0 0 1 0 0 0", no_rotation),
                ("0.67 -0.33 0.67 0.67 0.67 -0.33 -0.33 0.67 0.67 0 0 0", no_rotation),
                ("1 0 0 5 0 1 0 6 0 0 1 7", no_rotation),  # row by row with the translation
                ("1 0 0 0 1 0 0 0 -1 0 0 0", "the matrix mirrors"),
                ("0 -1 0 1 0 0 0 0 1 0 0 5368709.13", "the pose translates B"),
                ("1 0 0 0 1 0 0 0 1 0 -1e300 0", "the pose translates B")):
            with self.subTest(line):
                write("poses", f"# comment\n1 0 0 0 1 0 0 0 1 0 0 0 # comment\n\n{line}\n")
                refuse("collide post/ring.fbvh post/coarse.fbvh --poses poses --pairs out --json", f"poses:4: {wanted}")
        # The last cell that a pose can reach, and Windows line ends.
        write("poses", "1 0 0 0 1 0 0 0 1 5368709.12 0 0\r\n0 -1 0 1 0 0 0 0 1 0 0 -5368709.12\r\n")
        flashbvh("collide post/ring.fbvh post/coarse.fbvh --poses poses --json")

    def test_pairs_of_images_that_cant_be_answered(self):
        write("none", "# nothing\n")
        write("empty", "")
        refuse_each("collide", {
            "post/ring.fbvh post/coarse.fbvh --poses none": "none: has no poses",
            "post/ring.fbvh post/coarse.fbvh --poses empty": "empty: is empty",
            "post/ring.fbvh post/coarse.fbvh --poses missing": "missing: can't be opened",
            "post/ring.fbvh pre/coarse.fbvh --poses home --pairs out": "bake both",
            "wide/ring.fbvh post/coarse.fbvh --poses home --pairs out": "bake both",
            "post/ring.fbvh post/coarse.fbvh": "required",
            "post/ring.fbvh --poses home": "required",
        })
