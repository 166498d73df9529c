"""The page about images says what the other commands say, has the same bytes in any folder, and needs no other file.
Unreadable files are refused; no image is overwritten."""
import os
import shutil

from cli import Case, elsewhere, flashbvh, headlines, page_data, refuse_each, same, self_contained, text, write
from inputs import HOME, images, meshes


def is_live(page):
    """Without a compiler for WebAssembly, pages have tables alone."""
    return page_data(page)["drawing"] is not None


class ReportTest(Case):
    inputs = meshes,

    def test_a_page_of_two_images_what_info_prints_and_whether_they_touch_as_drawn(self):
        for options in "--layout pre --leaf-size 4", "--index-bits 32", "":
            with self.subTest(options):
                flashbvh(f"bake meshes/ring.stl meshes/tetrahedron.stl -o baked --cell 0.01 {options}")
                files = "baked/ring.fbvh", "baked/tetrahedron.fbvh"
                out = flashbvh("report -o page.html", *files)
                self.assertEqual(out + out.err, "")
                self_contained("page.html")
                data = page_data("page.html")
                self.assertEqual((data["title"], data["command"]), ("ring and tetrahedron", "report"))
                self.assertEqual(data["facts"], [flashbvh(f"info {file} --json").json for file in files])
                self.assertEqual(headlines("page.html"), ["Nothing to change: tetrahedron does not touch ring, as drawn"])

    def test_poses_how_many_touch_of_many_poses_one_that_touches_is_shown(self):
        flashbvh("bake meshes/ring.stl meshes/coarse.stl -o baked --cell 0.01")
        write("many", "\n".join(f"{HOME}  {0 if i == 1501 else 1000} 0 0" for i in range(4001)))
        flashbvh("report baked/ring.fbvh baked/ring.fbvh --poses many -o page.html")
        self.assertEqual(headlines("page.html"), ["Move apart: ring (2) touches ring at 1 of 4001 poses"])
        if is_live("page.html"):
            text("page.html").contains('"pose 1501"')
            text("page.html").lacks('"pose 1502"')
        write("apart", f"{HOME}  200 0 0")
        flashbvh("report baked/ring.fbvh baked/coarse.fbvh --poses apart -o page.html")
        self.assertEqual(headlines("page.html"), ["Nothing to change: coarse does not touch ring at any pose"])

    def test_one_mesh_within_the_other_touches_it(self):
        write("large.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        write("small.obj", "v 1 1 1\nv 2 1 1\nv 1 2 1\nv 1 1 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        flashbvh("bake large.obj small.obj -o nested --cell 0.01")
        flashbvh("report nested/large.fbvh nested/small.fbvh -o page.html")
        self.assertEqual(headlines("page.html"), ["Move apart: small touches large, as drawn"])

    def test_the_same_page_from_another_folder_names_that_are_the_same_are_distinguished(self):
        flashbvh("bake meshes/tetrahedron.stl -o baked --cell 0.01")
        for name in ("baked", "other"):
            shutil.copytree("baked", f"elsewhere/{name}")
        flashbvh("report baked/tetrahedron.fbvh baked/tetrahedron.fbvh -o one.html")
        elsewhere("report baked/tetrahedron.fbvh other/tetrahedron.fbvh -o ../two.html")
        same("one.html", "two.html")
        self.assertEqual(page_data("one.html")["title"], "tetrahedron and tetrahedron (2)")

    def test_what_is_odd_is_said_and_marked(self):
        write("odd.obj", "v 0 0 0\nv 8 0 0\nv 0 8 0\nv 0 0 8\nv 8 8 8\nf 1 1 2\nf 1 2 3\nf 3 1 2\nf 1 2 4\nf 1 2 5\n")
        flashbvh("bake odd.obj -o odd --cell 1")
        flashbvh("report odd/odd.fbvh -o odd.html")
        for said in ("odd: 1 triangle (0) without area", "Mend: odd: 1 triangle (2) with the three vertices",
                     "6 boundary edges", "1 non-manifold edge"):
            self.assertIn(said, "\n".join(headlines("odd.html")))
        if is_live("odd.html"):
            text("odd.html").contains(*(f'["--p{i}",' for i in (0, 1, 3, 4)))

    def test_names_that_html_or_utf_8_would_stumble_over_end_no_script(self):
        write('a<b>&"c".obj', "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
        flashbvh("bake 'a<b>&\"c\".obj' -o odd --cell 0.1 --name single")
        os.rename(b"odd/single.fbvh", b'odd/a<b>&"\xff".fbvh')
        flashbvh("report -o single.html", os.fsdecode(b'odd/a<b>&"\xff".fbvh'))
        self_contained("single.html")
        self.assertEqual(page_data("single.html")["title"], 'a<b>&"\ufffd"')
        self.assertNotIn("a<b>", text("single.html"))

    def test_refused(self):
        images()
        refuse_each("report", {
            "": "required",
            "post/ring.fbvh": "--output",
            "meshes/ring.stl -o out.html": "ring.stl: is no flashbvh image",
            'post/ring.fbvh -o out.html --poses ""': "names no file",
            "post/ring.fbvh coarser/ring.fbvh -o out.html --poses home": "ring.fbvh: has a cell of 0.02, but",
            "post/ring.fbvh post/ring.fbvh post/coarse.fbvh -o out.html --poses home": "give two",
            "post/ring.fbvh -o meshes": "meshes: is a folder",
        })
