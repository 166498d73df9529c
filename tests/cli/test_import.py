"""Each format gives equal trees for equal meshes; nothing is lost. What readers read and refuse: tests/mesh."""
from cli import Case, flashbvh, write
from inputs import faces


class ImportTest(Case):
    # A box of two units, as quadrilaterals with groups, materials, normals and comments.
    def setUp(self):
        super().setUp()
        write("box.obj", """
            # a box
            mtllib missing.mtl
            o first
            v -1 -1 -1
            v 1 -1 -1
            v 1 1 -1
            v -1 1 -1
            vn 0 0 1
            v -1 -1 1 1.0
            v 1 -1 1
            v 1 1 1 0.5 0.5 0.5
            v -1 1 1
            usemtl red
            f 4 3 2 1
            usemtl blue
            g one
            f 5//1 6//1 7//1 8//1
              f 1 2 6 5
            o second
            usemtl red
            f 3 4 8 7
            o first
            f 3 4 8 7
            g one
            f 4 1 5 8""")
        write("box.ply", """
            ply
            format ascii 1.0
            comment a box
            element vertex 8
            property float x
            property float y
            property float z
            element face 6
            property list uchar int vertex_indices
            end_header
            -1 -1 -1
            1 -1 -1
            1 1 -1
            -1 1 -1
            -1 -1 1
            1 -1 1
            1 1 1
            -1 1 1
            4 3 2 1 0
            4 4 5 6 7
            4 0 1 5 4
            4 2 3 7 6
            4 2 3 7 6
            4 3 0 4 7""")

    def test_a_box_in_obj_and_ply_is_one_mesh(self):
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
