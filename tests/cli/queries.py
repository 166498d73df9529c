"""The host program's answers, computed by the firmware's code, and the queries that it refuses."""
import os
import re
import shutil
from math import cos, hypot, sin
from pathlib import Path

from checks import (HERE, HOME, INCLUDE, THOROUGH, TOOLS, any_poses, box, edit_vertices, flashbvh, hold, refused, run,
                          same, vertices, write)

RING_AND_COARSE = "meshes/ring.stl", "meshes/coarse.stl"


def bake(folder, *meshes, options=""):
    flashbvh("bake", *meshes, "-o", folder, *options.split())


def refused_lines(command, lines):
    """Each line is refused as the only line of the file `bad`."""
    for what, line in lines:
        write("bad", line)
        refused(what, *command)


def inside():
    """Points inside a mesh, in its frame and unit."""
    # A ring of radii 20 and 6 about the z axis, 100 mm off its frame's origin.
    bake("near", "meshes/ring.stl", options="--cell 0.01")
    flashbvh("export", "near/ring.fbvh", "-o", "ring.obj")
    edit_vertices("ring.obj", "far.obj", lambda x, y, z: (f"{float(x) + 100:g}", y, f"{float(z) - 1000:g}"))
    bake("far", "far.obj", options="--cell 0.01 --unit mm")
    write("points", """100 0 -1000   # the hole
120 0 -1000
120 0 -994.5
126 0 -1000   # a corner
126.01 0 -1000
100 20 -1002
1e4 0 0""")
    command = "inside", "far/far.fbvh", "--points"
    found = [answer["where"] for answer in flashbvh(*command, "points", "--json").json()]
    hold(found == ["outside", "inside", "inside", "surface", "outside", "inside", "outside"], found)
    said = flashbvh(*command, "points")
    hold(sum(line.split()[1:2] == ["inside"] for line in said.splitlines()) == 3, said)

    write("open.obj", "\n".join(Path("far.obj").read_text().splitlines()[:-1]))
    bake("open", "open.obj", options="--cell 0.01")
    refused("is no closed surface and has no inside", "inside", "open/open.fbvh", "--points", "points", "--json")
    bake("pre", "far.obj", options="--layout pre --cell 0.01")
    refused("pre-indexed", "inside", "pre/far.fbvh", "--points", "points", "--json")
    refused_lines([*command, "bad", "--json"], (
        ("bad:1: has 2 numbers; a point has 3", "1 2"), ("bad:1: 'x' is no finite number", "1 2 x"),
        ("bad:1: the point lies at 1e+09", "1 2 1e9"), ("bad: is empty", "# none")))


def ray():
    """Hits of rays, in the mesh's frame and unit; rays have two points, or an origin and a direction."""
    # Two boxes of 10 mm, one after the other along x, 100 mm off their frame's origin.
    write("boxes.obj", box(100, size=10) + box(120, size=10, first=8))
    bake("shut", "boxes.obj", options="--cell 0.01 --unit mm")
    write("rays", """90 5 4  150 5 4       # through both
90 5 4  105 5 4       # into the first one
90 0 0  150 0 0       # along edges
115 5 4  150 5 4      # between them
90 11 4  150 11 4     # past them
90 5 4  2 0 0  60     # the first again, by a direction of any length
90 5 4  1 0 0  9.5    # too short""")
    command = "ray", "shut/boxes.fbvh", "--rays"
    answers = flashbvh(*command, "rays", "--json").json()
    hold([answer["hit"] for answer in answers] == [True, True, True, True, False, True, False], answers)
    hold([answers[0][name] for name in ("distance", "point", "side")] == [10, [100, 5, 4], "front"], answers[0])
    hold([answers[i]["distance"] for i in (3, 5)] == [5, 10], answers)
    hold([answer["crossings"] for answer in answers] == [0, -1, 0, 0, 0, 0, 0], answers)
    hold([answer["unit"] for answer in answers] == ["mm"] * 7, answers)

    first = flashbvh(*command, "rays", "--all", "--json").splitlines()[0]
    hold(re.findall('"distance":([0-9.]*)', first) == ["10.0", "20.0", "30.0", "40.0"], first)
    hold(re.findall('"side":"([a-z]*)"', first) == ["front", "back"] * 2, first)
    said = flashbvh(*command, "rays")
    said.holds(r"\Aboxes, distances in mm$")
    hold(sum(line.split()[1:2] == ["10"] for line in said.splitlines()) == 4, said)

    # An open mesh is hit, and has no crossings.
    write("open.obj", "\n".join(Path("boxes.obj").read_text().splitlines()[:-1]))
    bake("open", "open.obj", options="--cell 0.01")
    hold("crossings" not in flashbvh("ray", "open/open.fbvh", "--rays", "rays", "--json"), "crossings")
    bake("pre", "boxes.obj", options="--layout pre --cell 0.01")
    refused("pre-indexed", "ray", "pre/boxes.fbvh", "--rays", "rays")
    refused_lines([*command, "bad"], (
        ("bad:1: has 5 numbers; a ray has 6", "1 2 3 4 5"), ("bad:1: 'x' is no finite number", "1 2 3 4 5 x"),
        ("bad:1: is no ray", "1 2 3 0 0 0 1"), ("bad:1: is no ray", "1 2 3 0 0 1 -1"),
        # As a float it is 0.
        ("bad:1: is no ray: the reach is negative; give one from 0", "1 2 3 0 0 1 -1e-50"),
        ("ray 0 ends too far off", "0 0 0 9000 0 0"), ("bad: is empty", "")))


def contacts():
    """Segments where triangles intersect, in the images' unit and A's frame; poses that firmware makes of floats; the
    needed work and instructions of poses."""
    # A blade in the upper face of a block, each a metre off its frame's origin: along x = 1003.1, z = 1010, from
    # y = 1003 to 1005 (as in tests/c_api/story.c).
    meshes = [HERE.parent / f"c_api/{name}.obj" for name in ("block", "blade")]
    bake("mm", *meshes, options="--cell 0.1 --unit mm")
    pair = "mm/block.fbvh", "mm/blade.fbvh"
    write("poses", f"{HOME}  2000 2000 2000")
    flashbvh("collide", *pair, "--poses", "poses", "--contacts", "contacts", "--pairs", "pairs")
    lines = [line.split() for line in Path("contacts").read_text().splitlines()]

    def near(text, value):
        return abs(float(text) - value) <= 0.1 / 256

    for line in lines:
        hold(near(line[3], 1003.1) and near(line[6], 1003.1) and near(line[5], 1010) and near(line[8], 1010), line)
    along = [float(line[i]) for line in lines for i in (4, 7)]
    hold(near(min(along), 1003) and near(max(along), 1005), lines)
    hold([line[:3] for line in lines] == [line.split() for line in Path("pairs").read_text().splitlines()], lines)
    # Rotated half a turn about z, the blade keeps its place, seen from the block.
    write("poses", "-1 0 0 0 -1 0 0 0 1  6.2 8 2000")
    flashbvh("collide", *pair, "--poses", "poses", "--contacts", "rotated")
    lines = [line.split() for line in Path("rotated").read_text().splitlines()]
    hold(lines and all(float(line[3]) == 1003.1 and float(line[5]) == 1010 for line in lines), lines)
    refused("poses", "collide", *pair, "--poses", "poses", "--contacts", "poses")
    refused("same file", "collide", *pair, "--poses", "poses", "--contacts", "out", "--pairs", "out")

    # 500.005 mm are 50000.5 cells, plus a float's rounding or a double's: the two may round to different cells.
    bake("fine", meshes[1], options="--cell 0.01")
    places = "500.005", "500.015", "499.995", "123.455", "87.345"
    along_x = [f"{HOME}  {place} 0 0" for place in places]
    text = "\n".join([*along_x, "0 -1 0 1 0 0 0 0 1  0.1 0.2 0.3\n"])
    write("poses", text)
    flashbvh("collide", "fine/blade.fbvh", "fine/blade.fbvh", "--poses", "poses", "--float", "--json")
    # The firmware's translations, by tests/cli/float_poses.cpp.
    wanted = [float(line.split()[0]) for line in
              run(TOOLS / "cli_float_poses", 0.01, input=text).splitlines()[:5]]

    def found(*options):
        for pose in along_x:
            flashbvh("export", "--cells", "fine/blade.fbvh", "-o", "blade.obj", *options, "--pose", pose)
            yield vertices("blade.obj")[0][0] + 99690

    of_floats = list(found("--float"))
    hold(of_floats == wanted, f"{of_floats}, not {wanted}")
    hold(list(found()) != of_floats, "floats and doubles round alike")

    # A summary equals --bound for the same poses, and the bound for all poses.
    bake("post", *RING_AND_COARSE, options="--cell 0.01")
    command = "collide", "post/ring.fbvh", "post/coarse.fbvh", "--poses", write("poses", any_poses(40, 5, 20))
    bound = flashbvh(*command, "--bound", "--json").json()[0]
    said = flashbvh(*command, "--summary", "--json")

    def number(name, of):
        return int(re.search(rf'"{name}":\{{[^}}]*"{of}":(\d+)', said)[1])

    hold(number("work", "most") == bound["poses_most_work"] and number("work", "mean") == bound["poses_mean_work"],
         f"{said}{bound}")
    # With one triangle per leaf and two children per node, little is added to the constants.
    costs = Path(INCLUDE, "flashbvh/plain/core_costs.h").read_text()
    least = int(re.search(r'"Cortex-M4F".* (\d+)\)', costs)[1])
    work = number("work", "most")
    hold(work * least < number("Cortex-M4F", "most") < work * (least + 12) + 20000, said)
    flashbvh(*command, "--summary").holds("^work  *[0-9]* *[0-9]* *[0-9]*$", "^Cortex-M0 ", "^RV32IMAC ")
    hold("Cortex" not in flashbvh(*command, "--summary", "--algorithm", "leaf"), "proven of ranked alone")
    refused("excludes", *command, "--summary", "--pairs", "out")


def kept_inputs():
    """No command replaces a file that it reads. Tries every output of every command with every input."""
    bake("images", "meshes/ring.stl", options="--format image")
    write("poses", f"{HOME} 0 0 0")
    for folder in "queried", "elsewhere":
        Path(folder).mkdir()
    shutil.copy("poses", "queried/ring-ring")
    shutil.copy("meshes/tetrahedron.stl", "elsewhere/part.stl")
    write("arm.urdf", """<robot name="arm"><link name="base"><collision><geometry>
<mesh filename="elsewhere/part.stl" scale="0.1 0.1 0.1"/></geometry></collision></link>
<link name="tip"><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>
<joint name="turn" type="revolute"><parent link="base"/><child link="tip"/><origin xyz="2 0 0"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1"/></joint></robot>""")
    write("arm.srdf", '<robot name="arm"></robot>')
    write("way.csv", "turn\n0")
    flashbvh("robot", "arm.urdf", "-o", "baked", "--format", "image")

    def kept(inputs, link, *arguments):
        """With `link`, another name of an input, as output, the command is refused and the input unchanged."""
        for file in map(Path, inputs):
            Path(link).parent.mkdir(exist_ok=True)
            os.link(file, link)
            before = file.read_bytes()
            said = flashbvh(*arguments, code=2)
            hold(re.search("would replace|is an image, which would be replaced", said.warnings), said.warnings)
            hold(file.read_bytes() == before, f"{file} is replaced: {arguments}")
            os.remove(link)

    a = "images/ring.fbvh"
    for ending in "", ".h", ".c":
        kept(["meshes/ring.stl"], f"to/ring.fbvh{ending}", "bake", "meshes/ring.stl", "-o", "to", "--format", "both")
    kept([a], "to/x.obj", "export", a, "-o", "to/x.obj")
    for command, *options in (("report", "-o"), ("collide", "--pairs"), ("clearance", "--within", "1", "--pairs"),
                              ("collide", "--contacts")):
        kept([a, "poses"], "to/x", command, a, a, "--poses", "poses", *options, "to/x")
    kept(["queried/ring-ring"], "to/x", "report", a, a, "--poses", "queried", "-o", "to/x")
    robot = "robot", "arm.urdf", "--srdf", "arm.srdf", "-o", "to"
    read = "arm.urdf", "arm.srdf", "elsewhere/part.stl"
    for ending in "", ".h", ".c":
        kept(read, f"to/arm.robot{ending}", *robot, "--format", "both")
    for option in "--depfile", "--report":
        kept(read, "to/x", *robot, option, "to/x")
    kept([*read, "way.csv"], "to/x", "guard", "arm.urdf", "way.csv", "--srdf", "arm.srdf", "--report", "to/x")
    kept(["baked/arm.robot", "way.csv"], "to/x", "guard", "baked/arm.robot", "way.csv", "--report", "to/x")


def clearance():
    """Distances in the unit, with points, within a length, for every combination of options; and invalid queries are
    refused."""
    # Two boxes of 8 mm, the second one's lower corner at (0, 0, 0) of its own frame, a metre off the first one's.
    write("there.obj", box(1000, 1000, 1000, 8))
    write("here.obj", box(size=8))
    bake("mm", "there.obj", "here.obj", options="--cell 0.01 --unit mm")
    command = "clearance", "mm/there.fbvh", "mm/here.fbvh", "--poses"
    # Face to face, edge to edge, corner to corner, touching, intersecting, and one inside the other.
    write("poses", "\n".join(f"{HOME}  {place}" for place in (
        "1020.5 1001 1002", "1011 1012 1002", "1010 1014 1011", "1008 1000 1000", "1004 1003 1002")))
    answers = flashbvh(*command, "poses", "--json").json()
    for name, wanted in (("distance", [12.5, 5, 7, 0, 0]), ("lower", [12.5, 5, 7, 0, 0]),
                         ("upper", [12.5, 5, 7, 0, 0]), ("status", ["ok"] * 5), ("unit", ["mm"] * 5)):
        hold([answer[name] for answer in answers] == wanted, f"{name}: {answers}")
    # In A's frame, as drawn.
    hold([answers[2]["point_a"], answers[2]["point_b"]] == [[1008, 1008, 1008], [1010, 1014, 1011]], answers[2])
    a, b = answers[0]["point_a"], answers[0]["point_b"]
    hold([a[0], b[0]] == [1008, 1020.5] and a[1:] == b[1:], answers[0])
    flashbvh(*command, "poses").holds("^ *2 *7 mm ")
    cold = [answer["distance"] for answer in flashbvh(*command, "poses", "--cold", "--json").json()]
    hold(cold == [12.5, 5, 7, 0, 0], cold)

    # Within is closed, to the last digit, with all pairs.
    for length, third in (7, True), (6.999, False):
        said = flashbvh(*command, "poses", "--within", length, "--json")
        hold([answer["within"] for answer in said.json()] == [False, True, third, True, True], said)
        hold("distance" not in said, f"that of any pair is not the meshes': {said}")
    flashbvh(*command, "poses", "--within", 0, "--pairs", "near")
    flashbvh("collide", *command[1:], "poses", "--pairs", "found")
    same("near", "found", ": within nothing at all are the pairs that intersect")
    hold(Path("near").stat().st_size, "nothing touches")
    flashbvh(*command, "poses", "--within", 13, "--pairs", "near")
    hold({line.split()[0] for line in Path("near").read_text().splitlines()} == set("01234"), "not all poses")

    # Any tree and rotation of the meshes gives one answer.
    write("any", any_poses(30, 3, 35))
    first = None
    for options in "", "--leaf-size 5 --arity 6", "--builder median --leaf-size 1", "--index-bits 32":
        bake("post", *RING_AND_COARSE, options=f"{options} --cell 0.01")
        said = flashbvh("clearance", "post/ring.fbvh", "post/coarse.fbvh", "--poses", "any", "--json")
        distances = re.findall('"distance":([^,}]*)', said)
        first = first or distances
        hold(distances == first, options)
    hold(sum(float(d) > 1 for d in first) > 5 and sum(float(d) == 0 for d in first) > 2, first)
    flashbvh("clearance", "post/ring.fbvh", "post/coarse.fbvh", "--poses", "any", "--float", "--json")

    # As far away as 400,000 cells, still exact; then so far that the answer is only "at least". The truth is 19,043.7,
    # from 18,992, 992 and 992; each reported bound holds.
    write("far", f"{HOME}  5000 0 0\n{HOME}  20000 0 0")
    exact, answer = flashbvh(*command, "far", "--json").json()
    hold(abs(exact["distance"] - hypot(3992, 992, 992)) < 1e-9 and exact["status"] == "ok", exact)
    hold(exact["lower"] <= exact["distance"] <= exact["upper"] and exact["triangles"] is not None, exact)
    hold(answer["status"] == "out_of_range" and 0 < answer["lower"] <= 19043 and 19044 <= answer["upper"] < 19200,
         answer)
    hold([answer[name] for name in ("distance", "triangles", "point_a", "point_b")] == [None] * 4, answer)
    flashbvh(*command, "far").holds(">= .* out of range")
    # Farther than 1/256 cells can express; the next pose starts without a hint.
    write("farther", f"{HOME}  5000000 0 0\n{HOME}  1020.5 1001 1002")
    answers = flashbvh(*command, "farther", "--json").json()
    hold(answers[0]["upper"] is None and answers[-1]["distance"] == 12.5, answers)
    flashbvh(*command, "far", "--within", 5)
    near = flashbvh(*command, "far", "--within", 4300, "--json").json()
    hold([answer["within"] for answer in near] == [True, False], near)
    write("beyond", f"{HOME}  20000 1000 1000")
    refused("not decidable; use less than 10000", *command, "beyond", "--within", 10485)
    said = flashbvh(*command, "beyond", "--within", 10000, "--json")
    hold(not said.json()[0]["within"], said)

    refused("0 to 10485.8, 2^20 cells", *command, "poses", "--within", 10486)
    refused("--within -1: is out of range", *command, "poses", "--within", -1)
    refused("--within", *command, "poses", "--pairs", "out")
    refused("poses", *command[:3])
    refused("excludes", *command, "poses", "--within", 1, "--cold")
    refused("poses", *command, "poses", "--within", 1, "--pairs", "poses")
    bake("pre", "there.obj", "here.obj", options="--cell 0.01 --layout pre")
    refused("pre-indexed, which has no distances", "clearance", "pre/there.fbvh", "pre/here.fbvh",
            "--poses", "poses")


def star(size):
    """Triangles that all contain the origin, each rotated about it."""
    for i in range(size):
        s, c = sin(i), cos(i)
        for point in (9 * c, 9 * s, i), (-9 * s, 9 * c, -i), (9 * s - 9 * c, -9 * s - 9 * c, 0):
            yield "v {:f} {:f} {:f}".format(*point)
        yield f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}"


def bound():
    """No pose makes a query visit more or work more than `collide --bound` prints. If all boxes overlap, `ranked`
    visits exactly this number: for all pairs of sizes 1 to 8 and some other trees, with FLASHBVH_THOROUGH more. The
    printed needs of poses are right."""
    write("here", f"{HOME}  0 0 0")
    for size in range(1, 9):
        write(f"star{size}.obj", "\n".join(star(size)))
    for options in ("", "--leaf-size 1", "--arity 2", "--builder median --arity 8", "--leaf-size 3",
                    "--index-bits 32"):
        bake("baked", *(f"star{size}.obj" for size in range(1, 9)), options=f"--cell 0.01 {options}")
        sizes = range(1, 9) if not options else (1, 2, 5, 8) if THOROUGH else (5, 8)
        for a, b in ((a, b) for a in sizes for b in sizes):
            command = "collide", f"baked/star{a}.fbvh", f"baked/star{b}.fbvh", "--json", "--poses", "here"
            most, found = flashbvh(*command, "--bound").json()[0], flashbvh(*command).json()[0]
            hold(most["most_visits"] == found["visits"] and most["most_leaf_pairs"] == found["leaf_pairs"]
                 and most["most_triangle_pairs"] == a * b
                 and found["visits"] + 32 * a * b <= most["poses_most_work"] <= most["most_work"],
                 f"{options}: {a} and {b}: {most} {found}")

    write("poses", any_poses(40, 5, 20))
    bake("post", *RING_AND_COARSE, options="--cell 0.01")
    bake("pre", *RING_AND_COARSE, options="--layout pre --cell 0.01")
    for images, algorithms in (
            ("post", "ranked ranked-stack volume-stack alternating-stack stackless-post leaf"),
            ("pre", "stackless volume-stack alternating-stack leaf")):
        for algorithm in algorithms.split():
            command = ("collide", f"{images}/ring.fbvh", f"{images}/coarse.fbvh", "--json", "--algorithm", algorithm)
            most = flashbvh(*command, "--bound").json()[0]["most_visits"]
            visits = [answer["visits"] for answer in flashbvh(*command, "--poses", "poses").json()]
            of = flashbvh(*command, "--poses", "poses", "--bound").json()[0]
            hold(0 < of["poses_mean_work"] <= of["poses_99_percent_work"] <= of["poses_most_work"] <= of["most_work"]
                 and of["poses"] == 40, f"{algorithm}: {of}")
            hold(len(visits) == 40 and max(visits) <= most, f"{algorithm}: more than {most}: {visits}")

    command = "collide", "post/ring.fbvh", "post/coarse.fbvh"
    said = flashbvh(*command, "--bound")
    said.holds("^any pose: at most [0-9]* work: [0-9]* visits, of which [0-9]* pairs of leaves")
    hold(said.count("\n") == 3, said)
    said = flashbvh(*command, "--bound", "--poses", "poses")
    said.holds("^40 poses: at most [0-9]* work, 99 % of them at most [0-9]*, the mean [0-9]*$")
    hold(said.count("\n") == 4, said)
    # Of 100 poses, 99 are disjoint and need one visit's work.
    write("hundred", f"{HOME}  100 0 0\n" * 99 + f"{HOME}  0 0 0")
    of = flashbvh("collide", "baked/star8.fbvh", "baked/star8.fbvh", "--bound", "--poses", "hundred",
                  "--json").json()[0]
    hold(of["poses_99_percent_work"] == 1 and of["poses_most_work"] > 64, of)
    refused("--poses or --bound", *command)
    for option in ["--first"], ["--pairs", "found"]:
        refused("excludes", *command, "--bound", *option)
