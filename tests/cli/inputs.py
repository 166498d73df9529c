"""Inputs of the tests: fixtures, poses, meshes in OBJ and robots."""
import os
import shutil
from pathlib import Path

from cli import fixture, flashbvh, text, write
from meshes import loose, tetrahedron, torus, write_stls

HOME = "1 0 0 0 1 0 0 0 1"  # not rotated


@fixture
def meshes():
    write_stls("meshes", ring=torus(20, 10), many_sides=torus(30, 20), coarse=torus(8, 5),
               tetrahedron=tetrahedron(), nan=tetrahedron(float("nan")), no_triangles=())


@fixture
def large_meshes():
    """Meshes that need more than 16-bit indices."""
    write_stls("meshes", many_nodes=torus(200, 100), many_vertices=loose(22000), many_triangles=torus(200, 165))


@fixture
def images():
    meshes()
    flashbvh("bake meshes/ring.stl meshes/coarse.stl -o post --cell 0.01")
    flashbvh("bake meshes/ring.stl meshes/coarse.stl -o pre --cell 0.01 --layout pre")
    flashbvh("bake meshes/ring.stl -o wide --cell 0.01 --index-bits 32")
    flashbvh("bake meshes/ring.stl -o coarser --cell 0.02")
    write("home", f"{HOME} 0 0 0")


def any_poses(count, reach):
    """Poses, one per line: not rotated, by a quarter, and oblique; each with a translation within +-reach."""
    turns = HOME, "0 -1 0 1 0 0 0 0 1", "0.36 0.48 -0.8 -0.8 0.6 0 0.48 0.64 0.6"
    return "\n".join(" ".join([turns[i % 3], *(f"{(i * step % 41 / 20 - 1) * reach:g}" for step in (7, 12, 17))])
                     for i in range(count))


def numbers(file):
    """The numbers of each line."""
    return [list(map(int, line.split())) for line in text(file).splitlines()]


def box_in_cells(image):
    """The lower and the upper corner of a mesh in an image."""
    return list(flashbvh(f"info {image} --json").json["box_cells"].values())


def box(x=0, y=0, z=0, size=1, first=0, inwards=False):
    """A box in OBJ, from its lower corner; `first`: the number of vertices before it."""
    corners = [(x + size * (i % 2), y + size * (i // 2 % 2), z + size * (i // 4)) for i in range(8)]
    sides = [side[::-1] if inwards else side for side in ("1342", "5687", "1265", "3784", "1573", "2486")]
    return "".join([*("v {:.15g} {:.15g} {:.15g}\n".format(*corner) for corner in corners),
                    *("f " + " ".join(str(first + int(c)) for c in side) + "\n" for side in sides)])


# Parts of URDFs: links with one or several collision primitives, and joints.
def shape(geometry, place="0 0 0", rpy="0 0 0"):
    return f'<collision><origin xyz="{place}" rpy="{rpy}"/><geometry>{geometry}</geometry></collision>'


def box_of(sides, place="0 0 0"):
    return shape(f'<box size="{sides}"/>', place)


def link(name, *shapes):
    return f'<link name="{name}">{"".join(shapes)}</link>\n'


def joint(name, kind, parent, child, inside="", limits=None):
    limit = '<limit lower="{}" upper="{}" effort="1" velocity="1"/>'.format(*limits) if limits else ""
    return (f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>{inside}{limit}'
            "</joint>\n")


def robot(name, *parts):
    """Writes a URDF file."""
    return write(f"{name}.urdf", f'<robot name="{name}">\n{"".join(parts)}</robot>\n')


def disables(a, b, reason="Never"):
    """An SRDF element that disables a pair."""
    return f'<disable_collisions link1="{a}" link2="{b}" reason="{reason}"/>'


ALONG_Y = '<axis xyz="0 1 0"/>'
# An arm of boxes on a column that turns without limits; its forearm folds back onto the upper arm; one finger of its
# hand mimics the other.
ARM = (link("column", box_of("0.2 0.2 0.1")), link("upper", box_of("0.4 0.05 0.05", "0.25 0 0")),
       link("fore", box_of("0.3 0.04 0.04", "0.2 0 0")),
       link("left", box_of("0.02 0.02 0.1")), link("right", box_of("0.02 0.02 0.1")),
       joint("turn", "continuous", "column", "upper", '<origin xyz="0 0 0.2"/><axis xyz="0 0 1"/>'),
       joint("fold", "revolute", "upper", "fore", '<origin xyz="0.5 0 0"/>' + ALONG_Y, (-3, 3)),
       joint("grip", "prismatic", "fore", "left", '<origin xyz="0.4 0.1 0"/>' + ALONG_Y, (-0.09, 0.1)),
       joint("other", "prismatic", "fore", "right",
             f'<origin xyz="0.4 -0.1 0"/>{ALONG_Y}<mimic joint="grip" multiplier="-1"/>', (-0.1, 0.09)))
RING = shape('<mesh filename="package://parts/ring.stl" scale="0.01 0.01 0.01"/>')
OPTIONS = "--srdf arm.srdf --believe base,class --stop 0.005 --warn 0.01 --pair class,upper-arm=0.005,0.01"


# A base, a shoulder turned by -y with a mesh, a slide, and two fingers, one of which mimics the other, on a link
# without geometry.
@fixture
def two_fingers():
    meshes()
    limits = (-1, 1.5)
    robot("two fingers", link("base", box_of("0.2 0.2 0.1")), link("upper-arm", RING),
          link("class", shape('<cylinder radius="0.02" length="0.3"/>', rpy="0 1 0")), link("hand"),
          link("finger.l", box_of("0.01 0.02 0.05")), link("finger.r", shape('<sphere radius="0.02"/>')),
          joint("turn", "revolute", "base", "upper-arm", '<origin xyz="0 0 0.4"/><axis xyz="0 -1 0"/>', limits),
          joint("slide", "prismatic", "upper-arm", "class", '<axis xyz="0 0 1"/>', limits),
          joint("wrist", "continuous", "class", "hand", '<axis xyz="0 0 1"/>'),
          joint("left", "revolute", "hand", "finger.l", '<origin xyz="0 0.05 0"/>', limits),
          joint("right", "revolute", "hand", "finger.r",
                '<origin xyz="0 -0.05 0"/><mimic joint="left" multiplier="-0.5"/>', limits))
    os.rename("two fingers.urdf", "arm.urdf")
    write("arm.srdf", f'<robot name="two fingers">{disables("base", "class")}</robot>')
    Path("parts").mkdir()
    shutil.copy("meshes/ring.stl", "parts")
    write("json", flashbvh(f"robot arm.urdf -o first {OPTIONS} --json --report page.html"))
    flashbvh(f"robot arm.urdf -o image {OPTIONS} --format image")
