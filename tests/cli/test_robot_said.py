"""The beliefs and messages of `flashbvh robot`: unguarded pairs, pairs that an SRDF disables, sizes and cells, and
invalid robots."""
from cli import Case, fixture, flashbvh, headlines, page_data, refuse, refuse_each, search, text, write
from inputs import box_of, disables, joint, link, robot, shape


# A gantry whose feet stand on its table, so that the two always intersect; a post that blocks the beam, part of the
# table or a separate link.
@fixture
def gantry():
    post = box_of("0.05 0.05 0.5", "0.3 0 0.25")
    table = box_of("1 1 0.1", "0 0 -0.05")
    feet = [box_of("0.05 0.1 0.4", f"-0.4 {y} 0.199") for y in (-0.4, 0.4)]
    links = [link("bridge", *feet, box_of("0.05 0.9 0.05", "-0.4 0 0.375")),
             link("carriage", box_of("0.04 0.04 0.2", "-0.33 0 0.3"))]
    joints = [joint("x", "prismatic", "table", "bridge", '<axis xyz="1 0 0"/>', (0, 0.8)),
              joint("y", "prismatic", "bridge", "carriage", '<axis xyz="0 1 0"/>', (-0.3, 0.3))]
    robot("post", link("table", table), *links, link("post", post), joint("stands", "fixed", "table", "post"), *joints)
    robot("gantry", link("table", table, post), *links, *joints)
    write("drive.csv", "x,y\n" + "\n".join(f"{i * 0.016},0.2" for i in range(51)))


def sized(first, second, third, reach):
    """A robot of three boxes, whose last joint slides by up to `reach`."""
    return robot("sized", link("a", box_of(first)), link("b", box_of(second)), link("c", box_of(third)),
                 joint("one", "revolute", "a", "b", '<origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>', (-1, 1)),
                 joint("two", "prismatic", "b", "c", '<origin xyz="0 0 0.3"/><axis xyz="0 0 1"/>', (0, reach)))


class RobotSaidTest(Case):
    inputs = gantry,

    def test_a_joint_zone_is_said_and_listed_in_the_header_json_and_images_a_post_outside_is_guarded(self):
        out = flashbvh("robot gantry.urdf -o baked --stop 0.003 --format both --report page.html")
        zone = search(r"within ([0-9.]* m about x)", out)
        drawing = page_data("page.html")["drawing"]
        self.assertTrue(drawing is None or [zone[0] for zone in drawing["zones"]] == [0])
        self.assertEqual(headlines("page.html")[:4], [
            "Protect otherwise: at 1 of 3 pairs of links no guard looks, or only outside a joint zone",
            "stop: links nearer than 3 mm", "warn: links nearer than 3 mm", f"Not guarded: table - bridge within {zone}"])
        unguarded = f"warning: not guarded: table - bridge within {zone} (neighbours touch about their joint)"
        listed = '"not_guarded":[{"a":"table","b":"bridge","reason":"touch within %s","joint":"x","radius":0.' % zone
        out.err.contains(f"gantry.urdf: {unguarded}: a collision of these is never detected; what may collide "
                         "outside is guarded; another zone by")
        out.matches(
            rf"\Anot guarded: table - bridge within {zone}$",
            f"^table - bridge *can *outside {zone}: intersect at the witness$",
            f"^bridge *x .* outside {zone}$",
            # What the zone leaves of the joint's range: the beam is stopped at the post.
            "^zone about  pair  *middle  *radius  hides  stops$",
            "^x  *table - bridge  0 0 0 *0.[0-9]* *0 % *1[0-9] %$")
        out.err.matches("warning: links 'table' and 'bridge' outside their joint's zone stop a guard in 1[0-9] % of the "
                        "range of 'x'; give a larger --zone x=LENGTH, or disable the pair in an SRDF and name it by "
                        "--believe table,bridge$")
        text("baked/gantry.robot.h").matches("gantry_UNGUARDED_COUNT 1", rf"^ \* table - bridge within {zone}$")
        out = flashbvh("robot gantry.urdf --dry-run --stop 0.003 --json")
        out.contains(listed, '"size":[1.0,1.0,0.6', '"deviation":')
        [found] = out.json["zones"]
        self.assertTrue(0.1 < found["stops"] < 0.2 and 0.4 < found["radius"] < 0.5)
        self.assertEqual([found[name] for name in ("joint", "a", "b", "middle", "hides")],
                         ["x", "table", "bridge", [0, 0, 0], 0])
        # The image contains the list, too.
        flashbvh("info baked/gantry.robot").contains("not guarded: table - bridge")
        flashbvh("info baked/gantry.robot --json").contains(listed)
        out = flashbvh("guard baked/gantry.robot drive.csv", code=1)
        out.err.contains(f"baked/gantry.robot: {unguarded}")
        out.matches(rf"\Anot guarded: table - bridge within {zone}$", "^51 periods, [0-9]* pairs of links guarded$",
                    "^stop  *[1-9].*table - bridge$")
        self.assertEqual(flashbvh("guard baked/gantry.robot drive.csv --json", code=1).count(listed), 1)

    def test_zones_and_distances_of_pairs_that_are_given(self):
        # With the post as a separate link.
        flashbvh("robot post.urdf -o baked").matches(
            "^table - post *fixed *no joint moves them, intersecting$",
            r"^not guarded: table - bridge within [0-9.]* m about x \(never outside zone\)$")
        text("baked/post.robot.h").matches(r"^ \* table - bridge within [0-9.]* m about x, never outside zone$")
        # Without a zone, the whole links are tested.
        out = flashbvh("robot gantry.urdf -o baked --zone x=0")
        out.matches("^table - bridge *can *intersect at the witness$")
        out.err.contains("a guard would always say stop; disable the pair")
        self.assertNotIn("not guarded", out + out.err)
        flashbvh("robot gantry.urdf -o baked --zone x=2").matches(
            r"\Anot guarded: table - bridge within 2 m about x$", "^table - bridge *can *outside 2 m about x: intersect")
        refuse_each("robot gantry.urdf -o out", {
            "--zone x": "--zone x: is no JOINT=LENGTH",
            "--zone x=-1": "--zone x=-1: '-1' is no length",
            "--zone x=1e5": "--zone x=1e5: is out of range: 0 to 512.031 m, 16777215 cells; lengths are in metres: "
                "1e+05 mm is 100",
            "--pair table,bridge=1e30": "--pair table,bridge=1e30: is out of range: 0 to ",
            "--pair table,bridge=0.1,x": "--pair table,bridge=0.1,x: 'x' is no length",
            "--pair table,bridge=0.1,0.01": "--pair table,bridge=0.1,0.01: warns nearer than it stops",
            "--warn 1e30": "--warn 1e30: is out of range: 0 to ",
            "--zone x=1 --zone x=2": "--zone x=2: is a second zone of x",
            "--time 0": "--time 0: is no time; give a number of seconds above 0",
        })

    def test_what_an_srdf_disables_is_decided_all_the_same(self):
        write("gantry.srdf",
              "\n".join(['<robot name="gantry">', disables("post", "carriage"), disables("bridge", "post"),
                         disables("table", "bridge") + disables("bridge", "carriage"), "</robot>"]))
        out = refuse("robot post.urdf -o out --srdf gantry.srdf",
                     'gantry.srdf:2: disables carriage - post as "Never", but they intersect at x')
        out.err.contains(
            "y 0",
            "; delete the line, or stand by it with --believe carriage,post",
            "So can: bridge - post (line 3)")
        refuse("robot post.urdf -o out --srdf gantry.srdf --believe post,carriage",
               "gantry.srdf:3: disables bridge - post")
        out = flashbvh("robot post.urdf -o baked --srdf gantry.srdf --believe post,carriage --believe bridge,post "
                       "--stop 0.05 --format image")
        out.matches("^bridge - post *believed *intersect at the witness; disabled in the SRDF and believed$")
        # `never` covers collisions only: such pairs are not guarded for --stop, and not missing.
        out.matches(
            "^bridge - carriage *never outside zone *outside [^;]*: proven[^;]*; disabled in the SRDF, "
                "so not kept --stop apart$",
            r"\Anot guarded: table - bridge within [0-9.]* m about x \(never outside zone\), bridge - "
                r"carriage within [0-9.]* m about y \(never outside zone\), bridge - post, carriage - post$")
        believed = ("not guarded: bridge - post, carriage - post (disabled in the SRDF and believed, though they may "
                    "collide)")
        out.err.contains(believed)
        flashbvh("guard baked/post.robot drive.csv").err.contains(believed)
        refuse_each("robot post.urdf -o out", {
            "--srdf gantry.srdf --believe table,carriage":
                "--believe table,carriage: names a pair that no SRDF disables",
            "--believe bridge,post": "names a pair that no SRDF disables",
            "--srdf gantry.srdf --believe bridge,beam":
                "names 'beam', which is no link that collides; these are table,bridge",
            "--srdf gantry.srdf --believe bridge": "does not name LINK,LINK",
            "--srdf gantry.srdf --believe post,bridge --pair bridge,post=0.01": "guards what --believe leaves out",
        })

    def test_warnings_of_what_an_srdf_has(self):
        enabled = '<enable_collisions link1="table" link2="bridge"/>'
        lines = [enabled, disables("bridge", "table"), disables("bridge", "carriage")]
        write("odd.srdf", "\n".join(['<robot name="gantry">', *lines, "</robot>"]))
        out = flashbvh("robot post.urdf -o baked --srdf odd.srdf --believe carriage,bridge --believe table,bridge "
                       "--pair table,post=0.01")
        out.err.contains(
            "odd.srdf:3: warning: disables table - bridge, which is enabled as well; it counts as disabled",
            "odd.srdf:3: warning: table - bridge is never outside their joint's zone, with or without --believe "
                "table,bridge; leave",
            "odd.srdf:4: warning: bridge - carriage is never, with or without --believe "
                "bridge,carriage; leave that out",
            "links 'table' and 'post' have a --pair, but no joint moves them; leave it out",
            "not guarded: table - bridge within")

    def test_sizes_of_a_link_whose_scale_was_forgotten_and_cells_too_coarse(self):
        for sizes, wanted, fix in (
                (("0.2 0.1 0.1", "0.1 0.2 0.1", "78 20 21", 0.1),
                 "link 'c': warning: is 78 x 20 x 21 m, 390 times as long as the other links",
                 'scale="0.001 0.001 0.001"'),
                (("0.2 0.1 0.1", "0.1 0.2 0.1", "0.001 0.002 0.003", 0.1),
                 "link 'c': warning: is 0.001 x 0.002 x 0.003 m, 1/66.7 times as long as the other links",
                 "leave out the scale"),
                (("1 1 1", "1 1 1", "1 1 1", 1e9),
                 "makes a cell of 1.91e+03 m, coarser than a tenth of the stop distance, 0.005 m, since a joint lies "
                 "or slides 1e+09 m far", "m for link 'a' of 1 x 1 x 1 m, since")):
            with self.subTest(sizes):
                sized(*sizes)
                flashbvh("robot sized.urdf -o baked --stop 0.005").err.contains(wanted, fix)
        sized("0.2 0.1 0.1", "0.1 0.2 0.1", "0.01 0.005 0.005", 0.1)
        flashbvh("robot sized.urdf -o baked --stop 0.005").err.lacks("warning")
        flashbvh("robot sized.urdf -o baked --stop 0.005 --cell 0.002").err.contains(
            "--cell 0.002: warning: makes a cell of 0.002 m, coarser than a tenth of the stop "
                "distance, 0.005 m; give a finer one, or",
            "--cell 0.002: warning: makes a cell of 0.002 m for link 'c' of 0.01 x 0.005 x 0.005 m; "
                "give a finer one")

    def test_what_no_image_holds_is_refused_before_any_pair_is_decided(self):
        pair = [link("base", box_of("1 1 1")), link("arm", box_of("0.1 0.1 1", "0 0 2"))]
        robot("many", *pair, joint("j", "revolute", "base", "arm", "", (-1, 1)),
              *(link(f"l{i}") + joint(f"f{i}", "fixed", "base", f"l{i}") for i in range(254)))
        name = "l" * 300
        robot("long", link("base", box_of("1 1 1")),
              *(link(f"{name}{i}", box_of("0.1 0.1 1", "0 0 2") if i < 3 else "") for i in range(254)),
              joint("j", "revolute", "base", f"{name}0", "", (-1, 1)),
              *(joint(f"{name}{i}", "fixed", "base", f"{name}{i}") for i in range(1, 254)))
        robot("narrow", *pair, joint("j", "prismatic", "base", "arm", '<axis xyz="0 1 0"/>', (0.3333337, 0.3333337)))
        write("at.csv", "j\n0.5\n")
        refuse_each("robot -o out --cell 0.01", {
            "many.urdf": "many.urdf: has 256 links, an image holds 255; leave out those without a shape and a tool",
            "long.urdf": "bytes together, an image holds 65,535; shorten them",
            "narrow.urdf": "narrow.urdf, joint 'j': has limits so narrow that no value keeps them; make it fixed",
        })
        refuse("guard many.urdf at.csv", "many.urdf: has 256 links, an image holds 255")
        # A guard's slack holds twice the links' deviations.
        robot("pair", *pair, joint("j", "revolute", "base", "arm", "", (-1, 1)))
        out = refuse("robot pair.urdf -o out --simplify 1",
                     "--simplify 1: is out of range: a guard would stop this robot wherever it is")
        most = search("give ([0-9.]*) or less", out.err)
        flashbvh(f"robot pair.urdf -o baked --simplify {most}")

    def test_a_lattice_too_fine_for_a_long_chain_is_refused_before_any_pair_is_decided(self):
        links = [link(f"l{i}", box_of("0.02 0.02 0.1")) for i in range(60)]
        joints = [joint(f"j{i}", "revolute", f"l{i - 1}", f"l{i}", '<origin xyz="0.12 0 0"/>', (-1, 1))
                  for i in range(1, 60)]
        robot("chain", *links, *joints)
        refuse("robot chain.urdf -o out --time 1 --cell 1.5e-5",
               "robot: its joints move links too far for so fine a lattice: give --cell 1.9")
        # The chosen cell suffices, and pairs without time are guarded.
        flashbvh("robot chain.urdf -o out --time 1 --format image").contains("bytes of RAM for a guard")
