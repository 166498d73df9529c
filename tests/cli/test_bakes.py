"""What bakes give: equal bytes, in any unit; and no time that is quadratic."""
import os
import resource
import shutil
from pathlib import Path

from cli import Case, elsewhere, fixture, flashbvh, long, refuse, refuse_each, same, search, text, write
from inputs import box, box_in_cells, large_meshes, meshes


@fixture
def ten_inches():
    Path("parts").mkdir()
    for name, side in (("mm", 254), ("m", 0.254), ("in", 10)):
        write(f"parts/{name}.obj", box(size=side))


class BakesTest(Case):
    inputs = meshes,

    @long
    def test_nothing_is_quadratic_in_the_number_of_triangles(self):
        large_meshes()
        # Of processor time, per process.
        resource.setrlimit(resource.RLIMIT_CPU, (30, 30))
        out = flashbvh("bake meshes/many_triangles.stl -o baked --index-bits 32 --format image")
        self.assertEqual(out.err, "")
        flashbvh("info baked/many_triangles.fbvh").matches("^triangles  *66000$")

    def test_equal_input_gives_equal_bytes_in_any_folder_and_with_any_other_meshes(self):
        shutil.copytree("meshes", "elsewhere/meshes")
        for options in ("", "--layout pre", "--builder median", "--leaf-size 3 --arity 5", "--index-bits 32"):
            with self.subTest(options):
                flashbvh(f"bake meshes/ring.stl -o one --cell 0.01 {options}")
                elsewhere(f"bake ../meshes/coarse.stl meshes/ring.stl -o ../two --cell 0.01 {options}")
                for file in ("ring.fbvh", "ring.fbvh.h", "ring.fbvh.c"):
                    same(f"one/{file}", f"two/{file}")
                self.assertTrue(all(len(line) <= 100 for kind in "hc"
                                    for line in text(f"one/ring.fbvh.{kind}").splitlines()))
        self.assertNotRegex(text("two/ring.fbvh.h"), "elsewhere|20[0-9][0-9]-")
        self.assertNotIn(os.getcwd(), text("two/ring.fbvh.h"))

    def test_without_cell_the_finest_cell_that_fits_all_meshes_passing_it_changes_nothing(self):
        out = flashbvh("bake meshes/tetrahedron.stl meshes/ring.stl -o one")
        cell = search("^cell ([^;]*);", out)
        flashbvh(f"bake meshes/tetrahedron.stl meshes/ring.stl -o two --cell {cell}")
        same("one", "two")

    def test_a_failed_bake_leaves_older_files_unchanged(self):
        flashbvh("bake meshes/ring.stl -o one --format image")
        shutil.copy("one/ring.fbvh", "before")
        flashbvh("bake meshes/ring.stl meshes/nan.stl -o one --cell 1", code=2)
        same("before", "one/ring.fbvh")
        self.assertEqual(os.listdir("one"), ["ring.fbvh"])

    def test_files_of_different_units_are_converted_to_one_unit_which_all_given_and_printed_lengths_use(self):
        ten_inches()
        out = flashbvh("bake parts/mm.obj parts/m.obj parts/in.obj -o out --cell 0.5 --unit mm --unit m.obj=m "
                       "--unit parts/in.obj=in")
        self.assertEqual(out.err, "")
        out.matches("^cell 0.5 mm;")
        flashbvh("info out/in.fbvh").matches("^cell  *0.5  mm$")
        text("out/m.fbvh.h").contains("m_CELL 0.5 /* in mm */")
        for name in ("mm", "m", "in"):
            self.assertEqual(box_in_cells(f"out/{name}.fbvh"), [[0, 0, 0], [508, 508, 508]])
        # To feet and back: 12 inches to a foot; 10 inches are 2 cells of half a foot.
        flashbvh("bake parts/in.obj -o feet --cell 0.5 --unit in.obj=in --unit ft --format image")
        self.assertEqual(box_in_cells("feet/in.fbvh"), [[0, 0, 0], [2, 2, 2]])

    def test_a_common_unit_changes_no_number_the_image_stores_it(self):
        ten_inches()
        flashbvh("bake parts/in.obj -o plain --cell 0.5 --format image").matches("^cell 0.5;")
        plain = flashbvh("info plain/in.fbvh --json")
        for unit in ("nm", "um", "mm", "cm", "m", "mil", "in", "ft"):
            with self.subTest(unit):
                flashbvh(f"bake parts/in.obj -o alone --cell 0.5 --unit {unit} --format image")
                out = flashbvh("info alone/in.fbvh --json")
                self.assertEqual(out.replace(f'"unit":"{unit}"', '"unit":""'), plain)

    def test_units_that_are_none_or_contradict_each_other(self):
        ten_inches()
        refuse_each("bake parts/mm.obj -o out --unit", {
            "mm.obj=yard": "--unit mm.obj=yard: 'yard' is no unit",
            "mm --unit cm": "--unit cm: the unit is mm already; give a file's own unit as --unit FILE=cm",
            "m --unit other.obj=mm": "--unit other.obj=mm: no mesh 'other.obj' is given",
            "m --unit mm.obj=cm --unit parts/mm.obj=in": "--unit parts/mm.obj=in: parts/mm.obj is in cm already",
            "mm.obj=mm": "--unit mm.obj=mm: says nothing of the unit of the results; add it",
            "": "--unit",
        })

    def test_a_mesh_50_times_as_long_as_the_others_is_one_of_another_unit_by_the_look_of_it(self):
        for name in "ab":
            write(f"{name}.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        for size, warnings in ((1, 0), (49, 0), (51, 1)):
            with self.subTest(size):
                write("c.obj", f"v 0 0 0\nv {size} 0 0\nv 0 1 0\nf 1 2 3\n")
                out = flashbvh("bake a.obj b.obj c.obj -o odd --unit mm")
                self.assertEqual(out.err.count("times as long"), warnings)
        out.err.contains("c.obj: warning: is 51 x 1 x 0 mm, 51 times as long as the other meshes; if its unit or "
                         "its scale is another one, --unit FILE=UNIT converts it")
        flashbvh("info odd/c.fbvh").matches("^size  *51 x 0.999 x 0  mm$")
        flashbvh("bake a.obj b.obj c.obj --dry-run --json").contains('{"place":"c.obj","warning":"is 51 x 1 x 0,')
