"""What the host program bakes: images and code."""
import os
import re
import resource
import shutil
from pathlib import Path

import meshes
from checks import (HOME, THOROUGH, TOOLS, any_poses, box, compiled, damaged, edit_vertices, elsewhere, flashbvh,
                    hold, other_version, refused, run, same, size, write)


def large():
    """66,000 triangles, with FLASHBVH_THOROUGH 200,000, bake and check; anything quadratic in their number would
    not end."""
    mesh, count, seconds = "meshes/many_triangles", 66000, 30  # of computing, a process
    if THOROUGH:
        Path("large").mkdir()
        meshes.write_stl("large/large.stl", meshes.torus(400, 250))
        mesh, count, seconds = "large/large", 200000, 90
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
    name = mesh.split("/")[1]
    hold(not flashbvh("bake", f"{mesh}.stl", "-o", "baked", "--index-bits", 32, "--format", "image").warnings,
         "warnings")
    flashbvh("check", f"baked/{name}.fbvh", "--mesh", f"{mesh}.stl").holds(f"{count} triangles, .* nodes, equal to")
    refused(f"{name}.stl: is too large for a cell of 1e-06: out of range are {count} triangles (0, 1, 2, 3, 4 and "
            f"{count - 5} more)", "bake", f"{mesh}.stl", "-o", "out", "--cell", "1e-6")


def scales():
    """A mesh in a unit a thousand times smaller or larger is the same lattice mesh and gives the same answers
    under the same poses: nothing in the library knows a length."""
    flashbvh("bake", "meshes/ring.stl", "-o", "plain", "--cell", 0.013)
    flashbvh("export", "--cells", "plain/ring.fbvh", "-o", "ring.obj")
    poses = any_poses(15, 7, 25).splitlines()
    for exponent, cell in (0, "8"), (3, "8e3"), (-3, "8e-3"):
        # The mesh's own lattice points as lengths, times ten to the exponent.
        folder = Path(f"by{exponent}")
        folder.mkdir()
        edit_vertices("ring.obj", folder / "ring.obj", lambda *point: (f"{x}e{exponent}" for x in point))
        write(folder / "poses", "\n".join(" ".join([*words[:9], *(f"{x}e{exponent}" for x in words[9:])])
                                          for words in map(str.split, poses)))
        flashbvh("bake", folder / "ring.obj", "-o", folder, "--cell", cell)
        flashbvh("export", "--cells", folder / "ring.fbvh", "-o", folder / "lattice.obj")
        write(folder / "answers", flashbvh("collide", folder / "ring.fbvh", folder / "ring.fbvh", "--poses",
                                           folder / "poses", "--json", "--pairs", folder / "pairs"))
    for folder in "by3", "by-3":
        for file in "lattice.obj", "pairs", "answers":
            same(f"by0/{file}", f"{folder}/{file}")
    hold(len(Path("by0/pairs").read_text().splitlines()) > 100, "hardly a pair was found")


def cpp_output():
    """The C++ output answers like the image, links no levels that are not used, refuses another version of the
    library, and names its namespace after the mesh."""
    flashbvh("bake", "meshes/ring.stl", "-o", "images", "--format", "image", "--cell", 0.125)
    write("poses", f"{HOME} 6 2 1")
    flashbvh("collide", "images/ring.fbvh", "images/ring.fbvh", "--poses", "poses", "--pairs", "tool_pairs")
    write("cpp_pairs", run(TOOLS / "cli_cpp_query"))
    same("tool_pairs", "cpp_pairs")

    run(TOOLS / "cli_tree_alone")
    symbols = run(os.environ["NM"], TOOLS / "cli_tree_alone")
    symbols.holds("kNodes")
    hold(not re.search("kLevels|kRightChildLevels|levelled_tree", symbols), "levels linked without use")

    Path("names").mkdir()
    names = {"base link-2": "base_link_2", "3rd": "_3rd", "class": "class_"}
    for name in names:
        shutil.copy("meshes/tetrahedron.stl", f"names/{name}.stl")
    flashbvh("bake", *(f"names/{name}.stl" for name in names), "-o", "named")
    for name, space in names.items():
        hold(f"\nnamespace {space} {{\n" in Path(f"named/{name}.fbvh.hpp").read_text(), name)
        compiled("-std=c++17", "-c", f"named/{name}.fbvh.cpp", "-o", "object")

    other_version("other_library")
    said = compiled("-std=c++17", "-c", "named/class.fbvh.cpp", "-o", "object", include="other_library", code=1)
    hold("bake it again" in said.warnings, said.warnings)


def determinism():
    """The same input gives the same bytes, wherever it lies and whatever is baked with it; a failed bake leaves
    older files as they were."""
    shutil.copytree("meshes", "elsewhere/meshes")
    for options in "", "--layout pre", "--builder median", "--leaf-size 3 --arity 5", "--index-bits 32":
        flashbvh("bake", "meshes/ring.stl", "-o", "one", "--cell", 0.01, *options.split())
        elsewhere("bake", "../meshes/coarse.stl", "meshes/ring.stl", "-o", "../two", "--cell", 0.01, *options.split())
        for file in "ring.fbvh", "ring.fbvh.hpp", "ring.fbvh.cpp":
            same(f"one/{file}", f"two/{file}", options)
        for file in "ring.fbvh.hpp", "ring.fbvh.cpp":
            hold(all(len(line) <= 100 for line in Path("one", file).read_text().splitlines()), "lines over 100")
    header = Path("two/ring.fbvh.hpp").read_text()
    hold(not re.search(f"{re.escape(os.getcwd())}|elsewhere|20[0-9][0-9]-", header), "a path or a date")

    # Without --cell, the finest that all fit; given back, it changes nothing.
    both = "meshes/tetrahedron.stl", "meshes/ring.stl"
    cell = re.search("^cell ([^;]*);", flashbvh("bake", *both, "-o", "one"), re.M)[1]
    flashbvh("bake", *both, "-o", "two", "--cell", cell)
    for file in "ring.fbvh", "tetrahedron.fbvh", "tetrahedron.fbvh.cpp":
        same(f"one/{file}", f"two/{file}")

    shutil.copy("one/ring.fbvh", "before")
    flashbvh("bake", "meshes/ring.stl", "meshes/nan.stl", "-o", "one", "--cell", 1, code=2)
    flashbvh("bake", "meshes/ring.stl", "meshes/many_triangles.stl", "-o", "one", "--cell", 0.5, code=2)
    same("before", "one/ring.fbvh")
    hold(not any(Path("one").rglob("*.tmp*")), "temporary files left")

    # Only what is requested.
    for form, files in ("image", ["ring.fbvh"]), ("cpp", ["ring.fbvh.cpp", "ring.fbvh.hpp"]):
        flashbvh("bake", "meshes/ring.stl", "-o", form, "--format", form)
        hold(sorted(os.listdir(form)) == files, f"{form}: {os.listdir(form)}")


def damaged_images():
    """An image is refused if any byte of it is missing, added or changed, and if it is well checksummed nonsense.
    Of the bytes every seventh, with FLASHBVH_THOROUGH each; damage_test has each of them and more for what opens
    images."""
    flashbvh("bake", "meshes/tetrahedron.stl", "-o", "images", "--format", "image")
    image = Path("images/tetrahedron.fbvh")
    whole = image.read_bytes()
    flashbvh("check", image)
    step = 1 if THOROUGH else 7
    for length in [*range(1, len(whole), step), len(whole) - 1]:
        Path("cut.fbvh").write_bytes(whole[:length])
        refused("cut.fbvh: is", "check", "cut.fbvh")
    refused("truncated", "info", "cut.fbvh")
    Path("twice.fbvh").write_bytes(whole + whole)
    refused("twice.fbvh", "check", "twice.fbvh")

    for offset in [*range(0, len(whole), step), len(whole) - 1]:
        damaged(image, offset, None, "flipped.fbvh")
        refused("flipped.fbvh: ", "check", "flipped.fbvh")
    write("poses", f"{HOME} 0 0 0")
    refused("flipped.fbvh: is corrupt", "info", "flipped.fbvh")
    refused("flipped.fbvh: is corrupt", "export", "flipped.fbvh", "-o", "out.obj")
    for pair in ("flipped.fbvh", image), (image, "flipped.fbvh"):
        refused("flipped.fbvh: is corrupt", "collide", *pair, "--poses", "poses", "--pairs", "out")

    # With a matching checksum it is the contents that count: the root's link.
    damaged(image, 0x58, b"\1\0\1\0", "nonsense.fbvh", checksum=True)
    refused("nonsense.fbvh: is invalid", "check", "nonsense.fbvh")
    # Version 9.
    damaged(image, 4, b"\t\0\1\x10", "later.fbvh", checksum=True)
    refused("later.fbvh: is written in version 9", "check", "later.fbvh")
    # What the library leaves to `check`: of which shell a vertex is. The last words of the image are the vertices
    # (four of six bytes), the shell's first vertex with two zeros, and the name.
    flashbvh("bake", "meshes/tetrahedron.stl", "-o", "images", "--name", "t", "--format", "image")
    damaged("images/t.fbvh", size("images/t.fbvh") - 8, b"\2\0\0\0", "shell.fbvh", checksum=True)
    flashbvh("info", "shell.fbvh")
    refused("shell.fbvh: is invalid: its vertices of shells are not those that its triangles make; bake it again",
            "check", "shell.fbvh")


def units():
    """Files of different units end up in one; every length given and printed is in it."""
    Path("parts").mkdir()
    for name, side in ("mm", 254), ("m", 0.254), ("in", 10):
        write(f"parts/{name}.obj", box(size=side))
    parts = [f"parts/{name}.obj" for name in ("mm", "m", "in")]
    said = flashbvh("bake", *parts, "-o", "out", "--cell", 0.5, "--unit", "mm", "--unit", "m.obj=m", "--unit",
                    "parts/in.obj=in")
    hold(not said.warnings, said.warnings)
    said.holds("^cell 0.5 mm;")
    of_mm, of_in = (flashbvh("info", f"out/{name}.fbvh", "--json") for name in ("mm", "in"))
    hold(of_mm.replace('"name":"mm"', '"name":"in"') == of_in, f"{of_mm}{of_in}")
    of_in.holds('"unit":"mm"')
    flashbvh("info", "out/in.fbvh").holds("^cell  *0.5  mm$")
    hold("kCell = 0.5;  ///< in mm" in Path("out/m.fbvh.hpp").read_text(), "out/m.fbvh.hpp")
    for name in "mm", "m", "in":
        flashbvh("export", "--cells", f"out/{name}.fbvh", "-o", f"{name}.obj")
        same("mm.obj", f"{name}.obj")

    # A common unit alone changes no number, whichever it is; the image knows it.
    flashbvh("bake", "parts/in.obj", "-o", "plain", "--cell", 0.5, "--format", "image").holds("^cell 0.5;")
    plain = flashbvh("info", "plain/in.fbvh", "--json")
    for unit in "nm", "um", "mm", "cm", "m", "mil", "in", "ft":
        flashbvh("bake", "parts/in.obj", "-o", "alone", "--cell", 0.5, "--unit", unit, "--format", "image").holds(
            f"^cell 0.5 {unit};")
        found = flashbvh("info", "alone/in.fbvh", "--json")
        hold(found.replace(f'"unit":"{unit}"', '"unit":""') == plain, found)
        flashbvh("export", "alone/in.fbvh", "-o", "alone.obj")
        lines = Path("alone.obj").read_text().splitlines()
        hold(lines[0] == f"# in {unit}" and "v 10 10 10" in lines, lines)

    # To feet and back: 12 inches to a foot.
    flashbvh("bake", "parts/in.obj", "-o", "feet", "--cell", 0.5, "--unit", "in.obj=in", "--unit", "ft", "--format",
             "image")
    flashbvh("export", "--cells", "feet/in.fbvh", "-o", "feet.obj")
    hold("v 2 2 2" in Path("feet.obj").read_text().splitlines(), "10 in are not 2 cells of half a foot")

    # check reads the mesh as bake did.
    flashbvh("check", "out/in.fbvh", "--mesh", "parts/in.obj", code=1)
    flashbvh("check", "out/in.fbvh", "--mesh", "parts/in.obj", "--unit", "mm", "--unit", "in.obj=in")

    shutil.rmtree("out")
    for what, options in (
            ("--unit yard: 'yard' is no unit; give nm, um", "yard"),
            ("--unit mm.obj=yard: 'yard' is no unit", "mm.obj=yard"),
            ("--unit cm: the unit is mm already; give a file's own unit as --unit FILE=cm", "mm --unit cm"),
            ("--unit other.obj=mm: no mesh 'other.obj' is given", "m --unit other.obj=mm"),
            ("--unit parts/mm.obj=in: parts/mm.obj is in cm already",
             "m --unit mm.obj=cm --unit parts/mm.obj=in"),
            ("--unit mm.obj=mm: says nothing of the unit of the results; add it", "mm.obj=mm"),
            ("--unit", "")):
        refused(what, "bake", "parts/mm.obj", "-o", "out", "--unit", *options.split())
