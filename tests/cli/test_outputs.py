"""All files are written and listed, or none: if writing fails, or if standard output is full."""
import os
import subprocess
from pathlib import Path

from cli import Case, FLASHBVH, flashbvh, refuse_each, same, search, size, text, write
from inputs import images, meshes

PAIRS = "collide post/ring.fbvh post/coarse.fbvh --poses home --pairs"


class OutputsTest(Case):
    inputs = meshes,

    def test_a_dry_run_prints_what_a_real_one_prints_fails_where_it_fails_and_writes_nothing(self):
        for options, code in (
                ("", 0), ("--format c", 0), ("--format image --leaf-size 5", 0), ("--cell 0.0001", 2)):
            with self.subTest(options):
                bake = f"bake meshes/ring.stl meshes/tetrahedron.stl --unit mm {options}"
                wet = flashbvh(f"{bake} -o wet", code=code)
                for folder in ("", "-o out"):
                    out = flashbvh(f"{bake} {folder} --dry-run", code=code)
                    self.assertTrue(out.startswith(wet))
                    self.assertEqual(out.err, wet.err)
                    self.assertFalse(Path("out").exists())

    def test_the_table_of_what_was_baked_what_firmware_links_first_a_row_for_all_the_unit_of_each_length(self):
        bake = "bake meshes/ring.stl meshes/tetrahedron.stl --cell 0.25 --unit mm"
        out = flashbvh(f"{bake} -o table")
        out.matches(r"\Amesh +flash  bytes/triangle  triangles", "^cell 0.25 mm;")
        rows = [line.split() for line in out.splitlines()]
        self.assertEqual([row[0] for row in rows], ["mesh", "ring", "tetrahedron", "total", "cell"])
        self.assertTrue(all(int(rows[3][i]) == int(rows[1][i]) + int(rows[2][i]) for i in (1, 3, 4, 5)))
        self.assertEqual(rows[3][2], f"{int(rows[3][1]) / int(rows[3][3]):.1f}")
        self.assertEqual(float(rows[3][7]), max(float(row[7]) for row in rows[1:3]))
        self.assertEqual(rows[1][1], search("_IMAGE_BYTES ([0-9]*) ", text("table/ring.fbvh.h")))
        said = flashbvh(f"{bake} --dry-run --json").json
        self.assertEqual((said["unit"], said["cell"], said["warnings"]), ("mm", 0.25, []))
        for mesh, row in zip(said["meshes"], rows[1:3], strict=True):
            self.assertEqual([mesh["name"], str(mesh["flash_bytes"]), str(mesh["triangles"])], [row[0], row[1], row[3]])
            self.assertAlmostEqual(mesh["deviation"], float(row[7]), delta=1e-4)
            self.assertEqual([*(f"{side:.3g}" for side in mesh["size"]), row[8], row[14]], [*row[9:14:2], "mm", "mm"])
        out = flashbvh("bake meshes/ring.stl --cell 0.25 --format image -o table")
        out.matches(f"^ring  *{size('table/ring.fbvh')} ")
        out.lacks("total")
        refuse_each("bake meshes/ring.stl -o out --unit mm", {
            "--cell 0.0001": "meshes/ring.stl: is too large for a cell of 1e-04 mm;",
            "--cell 1 --max-deviation 0.1": "--max-deviation allows 0.1 mm; a cell of 0.1154700538379",
        })

    def test_a_link_is_written_through_one_that_leads_to_no_file_is_refused(self):
        images()
        flashbvh(f"{PAIRS} plain")
        write("far/target", "old")
        os.symlink("far/target", "link")
        flashbvh(f"{PAIRS} link")
        self.assertTrue(os.path.islink("link"))
        same("far/target", "plain")
        os.symlink("missing", "dangling")
        os.symlink("loop", "loop")
        refuse_each(PAIRS, {
            "dangling": "dangling: is a link that leads to no file: No such file or directory; remove it or write "
                "elsewhere",
            "loop": "loop: is a link that leads to no file: Too many levels of symbolic links",
        })

    def test_standard_output_has_other_names_as_a_file_it_holds_the_output_too(self):
        images()
        wanted = flashbvh(f"{PAIRS} pairs")
        self.assertEqual(flashbvh(f"{PAIRS} /proc/self/fd/1"), text("pairs") + wanted)
        with open("whole", "w") as file:
            subprocess.run([FLASHBVH, *PAIRS.split(), "/proc/self/fd/1"], stdout=file, check=True)
        self.assertEqual(text("whole"), text("pairs") + wanted)

    def test_standard_output_that_takes_nothing_no_file_is_left(self):
        images()
        for arguments in ("bake meshes/ring.stl -o out", "bake meshes/ring.stl --dry-run", "info post/ring.fbvh",
                          "collide post/ring.fbvh post/ring.fbvh --poses home --pairs out", "--help", "--version",
                          "bake --help"):
            with self.subTest(arguments):
                with open("/dev/full", "w") as full:
                    done = subprocess.run([FLASHBVH, *arguments.split()], stdout=full, stderr=subprocess.PIPE,
                                          text=True)
                self.assertEqual((done.returncode, done.stderr), (2, "flashbvh: standard output can't be written\n"))
                self.assertFalse(Path("out").exists())
        reader, writer = os.pipe()
        os.close(reader)
        self.assertEqual(subprocess.run([FLASHBVH, "bake", "meshes/ring.stl", "-o", "out"], stdout=writer).returncode, 2)
        os.close(writer)
        self.assertFalse(Path("out").exists())
