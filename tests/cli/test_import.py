"""Each format gives equal trees for equal meshes; nothing is lost. What readers read and refuse: tests/mesh."""
from cli import Case, flashbvh, write
from inputs import faces

CORNERS = ["-1 -1 -1", "1 -1 -1", "1 1 -1", "-1 1 -1", "-1 -1 1", "1 -1 1", "1 1 1", "-1 1 1"]
SIDES = ["3 2 1 0", "4 5 6 7", "0 1 5 4", "2 3 7 6", "2 3 7 6", "3 0 4 7"]


class ImportTest(Case):
    def test_a_box_in_obj_and_ply_is_one_mesh(self):
        # With a weight, a colour, a normal, texture coordinates, groups and materials.
        points = "".join(f"v {corner}\n" for corner in CORNERS[:4]) + (
            "vn 0 0 1\nv -1 -1 1 1.0\nv 1 -1 1\nv 1 1 1 0.5 0.5 0.5\nv -1 1 1\n")
        write("box.obj", f"# a box\nmtllib missing.mtl\no first\n{points}usemtl red\nf 4 3 2 1\nusemtl blue\ng one\n"
              "f 5//1 6//1 7//1 8//1\n  f 1 2 6 5\no second\nf 3 4 8 7\no first\nf 3 4 8 7\ng one\nf 4 1 5 8\n")
        write("box.ply", "\n".join(["ply", "format ascii 1.0", "comment a box", "element vertex 8", *(
            f"property float {axis}" for axis in "xyz"), "element face 6", "property list uchar int vertex_indices",
            "end_header", *CORNERS, *(f"4 {side}" for side in SIDES), ""]))
        for kind in ("obj", "ply"):
            with self.subTest(kind):
                out = flashbvh(f"bake box.{kind} -o {kind} --cell 0.25")
                out.err.lacks("without area")
                out.err.contains(f"flashbvh: box.{kind}: warning: with the three vertices of an earlier one, once "
                                 "rounded: 2 triangles (8 and 9); kept")
        flashbvh("check obj/box.fbvh --mesh box.ply")
        flashbvh("export --cells ply/box.fbvh -o ply.obj")
        self.assertEqual(len(faces("ply.obj")), 12)

    def test_one_triangle_is_a_tree_so_is_one_that_rounding_makes_a_point(self):
        write("point.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n")
        flashbvh("bake point.obj -o point --cell 1").err.contains("without area once rounded: 1 triangle (0); kept")
        flashbvh("check point/point.fbvh --mesh point.obj")
        flashbvh("bake point.obj -o point")
