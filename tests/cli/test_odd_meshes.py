"""Each kind of defect gets a line with triangle ids; the triangles stay unless --drop names them, and remaining
triangles keep their numbers."""
import shutil

from cli import Case, fixture, FLASHBVH, flashbvh, refuse, refuse_each, run, search, write
from inputs import box, meshes, numbers

BOX = box(size=8)


def closed_box():
    write("box.obj", BOX)


# Triangle 12 lies on a line, 13 is smaller than a cell, 14 and 15 repeat 0 and 2 with rotated corners.
@fixture
def odd():
    closed_box()
    meshes()
    write("mesh.obj", BOX + "v 0.1 0.2 0\nv 0.2 0.1 0\nf 1 3 3\nf 1 9 10\nf 3 4 1\nf 6 8 5\n")
    flashbvh("bake box.obj -o box --cell 1")


class OddMeshesTest(Case):
    inputs = closed_box,

    def test_triangles_without_area_and_duplicates_are_kept_or_left_out(self):
        odd()
        for drop, degenerate, duplicate, triangles in (
                ("", "kept (--drop degenerate leaves them out)", "kept (--drop duplicate leaves them out)", 16),
                ("--drop degenerate", "left out", "kept (--drop duplicate leaves them out)", 14),
                ("--drop degenerate,duplicate", "left out", "left out", 12)):
            with self.subTest(drop):
                self.assertEqual(flashbvh(f"bake mesh.obj -o odd --cell 1 {drop}").err.splitlines(), [
                    f"flashbvh: mesh.obj: warning: without area: 1 triangle (12); {degenerate}",
                    f"flashbvh: mesh.obj: warning: without area once rounded: 1 triangle (13); {degenerate}",
                    "flashbvh: mesh.obj: warning: with the three vertices of an earlier one, once rounded: 2 triangles "
                    f"(14 and 15); {duplicate}"])
                self.assertEqual(flashbvh("info odd/mesh.fbvh --json").json["triangles"], triangles)

    def test_triangles_left_out_that_lie_on_no_others_count_in_the_deviation(self):
        write("wire.obj", BOX + "v 0 0 90\nv 0 0.2 90\nv 0.2 0 90\nf 9 10 11\n")
        out = flashbvh("bake wire.obj -o wire --cell 1 --drop degenerate --json")
        out.err.contains("wire.obj: warning: triangles left out lie up to")
        self.assertTrue(82 <= out.json["meshes"][0]["deviation"] < 84)
        refuse("bake wire.obj -o out --cell 1 --drop degenerate --max-deviation 2",
               "wire.obj: triangles to drop lie up to 8")
        refuse("bake wire.obj -o out --cell 1 --drop degenerate --max-deviation 2 --simplify 0.9",
               "--max-deviation allows 2")

    def test_answers_speak_of_the_files_numbers_whatever_was_left_out_before_them(self):
        odd()
        late = "".join(line for line in BOX.splitlines(True) if line[0] == "v")
        write("late.obj", late + "f 1 1 1\nf 1 2 2\n" + BOX[len(late):])
        flashbvh("bake late.obj -o late --cell 1 --drop degenerate")
        write("pose", "1 0 0 0 1 0 0 0 1  8 1 1\n")
        for name in "late", "box":
            flashbvh(f"collide {name}/{name}.fbvh box/box.fbvh --poses pose --pairs {name}_pairs")
        self.assertEqual(sorted(numbers("late_pairs")), sorted([0, a + 2, b] for _, a, b in numbers("box_pairs")))
        self.assertTrue(numbers("box_pairs"))
        refuse_each("bake late.obj -o out", {
            "--cell 100 --drop degenerate": "late.obj: --drop leaves no triangle",
            "--drop sharp": "--drop",
            "--drop": "--drop",
        })

    def test_a_surface_that_is_open_non_manifold_or_twisted_is_said_to_be_so(self):
        is_open = "no closed surface"
        inside = "what lies inside the solid is unknown"
        last = "f 2 4 8 6\n"
        for mesh, wanted in (
                (BOX.replace(last, ""), f"{is_open} (4 boundary edges of one triangle): {inside}"),
                (BOX + "v 4 4 12\nf 7 8 9\n",
                 f"{is_open} (2 boundary edges of one triangle, 1 non-manifold edge of more than two): {inside}"),
                (BOX.replace(last, "f 6 8 4 2\n"),
                 f"{is_open} (4 edges of two that face opposite ways): {inside}, nor which way normals face")):
            with self.subTest(wanted):
                write("mesh.obj", mesh)
                out = flashbvh("bake mesh.obj -o odd --cell 1")
                self.assertEqual(out.err, f"flashbvh: mesh.obj: warning: {wanted}\n")

    # By the volume, at any place of the mesh; also a part beside others, overlapping one, or in a cavity. A hollow box
    # is no defect, nor is a part in its cavity.
    def test_inside_out(self):
        turned = box(size=8, inwards=True)
        hollow = box(size=32) + box(2, 2, 2, 28, first=8, inwards=True)
        one_part = "has 1 part that is inside out"
        for mesh, warning in (
                (turned, "is inside out: normals face into the solid; turn the triangles round in the program that "
                    "made it, or leave them if it is a room, seen from within"),
                (box(-1000, -1000, -1000, 8, inwards=True), "is inside out"),
                (box(1000, 1000, 1000, 8, inwards=True), "is inside out"),
                (turned + box(100, 100, 100, 4, first=8), "is inside out"),
                (box(size=8) + box(20, 0, 0, 4, first=8, inwards=True), one_part),
                (box(size=8) + box(6, 6, 6, 4, first=8, inwards=True), one_part),
                (box(size=8) + box(6, 6, 6, 4, first=8, inwards=True) + box(-3, 0, 0, 4, first=16, inwards=True),
                 "has 2 parts that are inside out"),
                (hollow + box(8, 8, 8, 4, first=16, inwards=True), one_part),
                (box(size=8) + box(2, 2, 2, 4, first=8, inwards=True), None),
                (hollow + box(8, 8, 8, 4, first=16) + box(9, 9, 9, 2, first=24, inwards=True), None)):
            with self.subTest(mesh):
                write("mesh.obj", mesh)
                baked = flashbvh("bake mesh.obj -o odd --cell 1").err
                self.assertTrue(baked.startswith(f"flashbvh: mesh.obj: warning: {warning}") if warning else not baked)

    def test_two_boxes_side_by_side_that_rounding_joins_along_a_wall(self):
        write("mesh.obj", box(size=8) + box(8.25, size=8, first=8))
        self.assertEqual(flashbvh("bake mesh.obj -o odd --cell 0.25").err, "")
        out = flashbvh("bake mesh.obj -o odd --cell 1")
        out.err.matches(r"once rounded no closed surface \(.*what lies inside the solid is unknown; a finer --cell "
                        "keeps it closed")

    # 2^18 cells are near enough, along all axes together.
    def test_far_from_its_frames_origin(self):
        far = ("flashbvh: mesh.obj: warning: lies far from its frame's origin: rotated, it is placed within 0.54 cells "
               "instead of 0.51{}; move it nearer to the origin\n")
        for x, warning in ((262132, ""), (262133, far.format("")),
                           (262140, far.format(", and no motion of it can be queried"))):
            write("mesh.obj", box(x, size=8))
            self.assertEqual(flashbvh("bake mesh.obj -o near --cell 1").err, warning)
        refuse('motion near/mesh.fbvh near/mesh.fbvh --from "0 0 0" --to "0 0 1"', "nearer to their origins")

    def test_how_far_rounding_may_move_a_vertex(self):
        write("thin.obj", "v 0 0 0\nv 1 0 0\nv 0 0.25 1\nf 1 2 3\n")
        flashbvh("bake thin.obj -o thin --cell 0.5 --max-deviation 0.25")
        flashbvh("bake thin.obj -o thin --cell 0.25 --max-deviation 0")
        out = refuse("bake thin.obj -o out --cell 0.5 --max-deviation 0.125",
                     "thin.obj: rounding moves a vertex by 0.25, --max-deviation allows 0.125; a cell of 0.144")
        cell = search("a cell of ([^ ]*) ", out.err)
        flashbvh(f"bake thin.obj -o thin --cell {cell} --max-deviation 0.125")
        refuse("bake thin.obj -o out --cell 0.5 --max-deviation 1e-9",
               "thin.obj: rounding moves a vertex by 0.25, --max-deviation allows 1e-09; the mesh is too "
               "large for so fine a cell: cut or convert it: --unit")
        refuse_each("bake thin.obj -o out", {
            f"--max-deviation {length}": "--max-deviation" for length in ("-1", "nan", "abc", '""')})

    def test_quick_work_shows_no_bar_on_a_terminal(self):
        if shutil.which("script"):
            said = run("script", "-qec", f"'{FLASHBVH}' bake box.obj -o bar --cell 1", "/dev/null")
            self.assertNotIn("%", said)

    def test_one_triangle_is_a_tree_so_is_one_that_rounding_makes_a_point(self):
        write("point.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3")
        flashbvh("bake point.obj -o point --cell 1").err.contains("without area once rounded: 1 triangle (0); kept")
        flashbvh("info point/point.fbvh")
        flashbvh("bake point.obj -o point")
