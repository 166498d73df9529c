"""`flashbvh audit`: the valid lines of an SRDF, and a corrected SRDF."""
import re

from cli import Case, fixture, flashbvh, long, refuse, refuse_each, same, text, write
from inputs import box_of, disables, joint, large_meshes, link, robot, shape


# A turret in its base; a hook that slides in the base, too, but is not its neighbour; an arm that can be lowered into
# the base and onto the hook.
@fixture
def crane():
    robot("crane", link("base", box_of("1 1 0.1")), link("turret", box_of("0.1 0.1 0.5", "0 0 0.21")),
          link("hook", box_of("0.02 0.02 0.3", "0.2 0 0.1")),
          link("arm", shape('<sphere radius="0.02"/>', "0.6 0 0"), box_of("0.4 0.02 0.02", "0.4 0 0")),
          joint("spin", "revolute", "base", "turret", '<axis xyz="0 0 1"/>', (-1, 1)),
          joint("slide", "prismatic", "turret", "hook", '<axis xyz="0 0 1"/>', (0, 0.02)),
          joint("lift", "revolute", "turret", "arm", '<origin xyz="0 0 0.4"/><axis xyz="0 1 0"/>', (-1, 1)))
    write("crane.srdf", """
        <?xml version="1.0"?>
        <!-- By hand: <disable_collisions link1="hook" link2="arm"/> -->
        <robot name="crane">
            <group name="all"><joint name="lift"/></group>
            <disable_collisions link1="base" link2="turret" reason="Adjacent" />
            <disable_collisions link1="arm" link2="base" reason="Never"/>
            <disable_collisions link1="hook" link2="base" reason="User"/> <!-- in a slot -->
            <group_state name="rest" group="all"><joint name="lift" value="-0.5"/></group_state>
        </robot>""")


def summary(lines, missing, **counts):
    """The last line of an audit."""
    kinds = ("proven", "contact", "default", "believed", "refuted", "undecided")
    return f"{lines} lines: {', '.join(f'{counts.get(kind, 0)} {kind}' for kind in kinds)}; {missing} pairs are missing"


class AuditTest(Case):
    inputs = crane,

    def test_each_line_is_proven_in_contact_or_refuted_by_a_witness_that_the_guard_confirms(self):
        out = flashbvh("audit crane.urdf crane.srdf", code=1)
        out.matches(
            "^pair  *line  SRDF  *verdict  reason$",
            "^base - turret  *5  *Adjacent  contact  outside 0[.][0-9]* m about spin: proven.*; touch inside at "
                "spin 0$",
            "^base - arm  *6  *Never  *refuted  intersect at spin [-0-9.e]*, lift [0-9.]*; triangle "
                "[0-9]+ of .*box.* and triangle [0-9]+ of .*$",
            "^base - hook  *7  *User  *contact  intersect at the default configuration and wherever "
                "tried; sampled, not proven$",
            "^turret - hook  *Adjacent  proven",
            "^turret - arm  *Adjacent  proven",
            f"^crane.srdf: {summary(3, 2, contact=2, refuted=1)}$")
        out.lacks("hook - arm")
        said = flashbvh("audit crane.urdf crane.srdf --json", code=1).json
        self.assertEqual((said["ok"], said["refuted"], said["missing"][0]["b"]), (False, 1, "hook"))
        self.assertEqual([line["witness"] for line in said["lines"][::2]], 2 * [{"spin": 0, "slide": 0.01, "lift": 0}])
        bad = said["lines"][1]
        self.assertEqual((bad["verdict"], bad["line"], bad["srdf_reason"]), ("refuted", 6, "Never"))
        self.assertEqual(["box" in triangle["source"] for triangle in bad["triangles"]], [True, True])
        at = bad["witness"]
        write("at.csv", ",".join(at) + "\n" + ",".join(map(str, at.values())))
        write("slot.srdf", f'<robot name="crane">{disables("base", "hook")}</robot>')
        flashbvh("robot crane.urdf -o image --format image --srdf slot.srdf --believe base,hook")
        flashbvh("guard image/crane.robot at.csv --json", code=1).contains('"a":"base","b":"arm","distance":0.0')

    def test_what_there_is_no_time_for_is_undecided_and_no_line_is_refuted_or_missing_for_it(self):
        out = flashbvh("audit crane.urdf crane.srdf --time 1e-9")
        out.matches(
            "^base - turret .* undecided  no time was left to find a zone about spin$",
            "^base - arm  *6  *Never  *undecided  neither proven nor found to intersect after 0 joint "
                "boxes, when its time was up$",
            f"^crane.srdf: {summary(3, 0, undecided=3)}$")
        out.err.contains("no time was left to find a zone about spin: links that touch there are undecided; give more "
                         "--time")
        flashbvh("audit crane.urdf crane.srdf --time 1000", code=1).contains(summary(3, 2, contact=2, refuted=1))

    def test_write_makes_one_of_which_every_line_holds_with_an_srdf_or_without(self):
        flashbvh("audit crane.urdf crane.srdf --write out/fixed.srdf", code=1)
        flashbvh("audit crane.urdf out/fixed.srdf").contains(summary(4, 0, proven=2, contact=2))
        flashbvh("audit crane.urdf --write made.srdf").contains(f"crane.urdf: {summary(0, 4)}")
        write("wanted.srdf", """
            <?xml version="1.0"?>
            <robot name="crane">
              <disable_collisions link1="base" link2="turret" reason="Adjacent"/>
              <disable_collisions link1="base" link2="hook" reason="Default"/>
              <disable_collisions link1="turret" link2="hook" reason="Adjacent"/>
              <disable_collisions link1="turret" link2="arm" reason="Adjacent"/>
            </robot>""")
        same("made.srdf", "wanted.srdf")
        same("out/fixed.srdf", "wanted.srdf")

    # Fingers that meet when closed, which is the default; a tip that meets the palm at all other values.
    def test_what_is_not_in_contact_both_at_the_default_and_elsewhere_is_refuted_with_the_triangles_of_its_files(self):
        write("pad.obj", "v 0 0.001 0.05\nv 0 0.001 0.1\nv 0 -0.01 0.08\nf 1 2 3\n")
        robot("fist", link("palm", box_of("0.2 0.2 0.02")),
              link("left", box_of("0.02 0.02 0.04", "-0.08 0 0.1"), shape('<mesh filename="pad.obj"/>')),
              link("right", box_of("0.02 0.02 0.1", "0 0.01 0.1")),
              link("tip", box_of("0.02 0.02 0.08", "0.05 0 0.05005")),
              joint("grip", "prismatic", "palm", "left", '<axis xyz="0 -1 0"/>', (0, 0.05)),
              joint("other", "prismatic", "palm", "right", '<axis xyz="0 1 0"/>', (0, 0.05)),
              joint("reach", "prismatic", "left", "tip", '<axis xyz="0 0 -1"/>', (0, 0.08)))
        write("fist.srdf", f'<robot name="fist">{disables("left", "right")}{disables("palm", "tip")}</robot>')
        flashbvh("audit fist.urdf fist.srdf", code=1).matches(
            "^left - right .* refuted .*; triangle 0 of pad.obj and triangle [0-9]* of box", "^palm - tip .* refuted")
        # What "Default" promises holds of the fingers alone. A believed line stays, a needless one is warned of.
        lines = disables("left", "right", "Default") + disables("palm", "tip", "Default")
        write("fist.srdf", f'<robot name="fist">{lines}{disables("palm", "left")}</robot>')
        flashbvh("audit fist.urdf fist.srdf --write kept.srdf", code=1).matches(
            "^left - right .* default  *intersect at the default configuration, grip 0, other 0, as it says; at "
                "others they may be apart$",
            "^palm - tip .* refuted")
        text("kept.srdf").lacks('link1="left" link2="right"')
        out = flashbvh("audit fist.urdf fist.srdf --believe tip,palm --believe left,palm --write kept.srdf")
        out.matches("^palm - tip .* believed  *intersect at grip 0[.0-9]*, reach 0[.0-9]*$",
                    f"^fist.srdf: {summary(3, 3, proven=1, default=1, believed=1)}$")
        out.err.contains("fist.srdf:1: warning: is proven, with or without --believe; leave that out")
        text("kept.srdf").contains('link1="palm" link2="tip"')
        said = flashbvh("audit fist.urdf fist.srdf --believe tip,palm --json").json
        self.assertEqual((said["ok"], said["default"], said["believed"]), (True, 1, 1))
        refuse("audit fist.urdf fist.srdf --believe tip,left", "--believe tip,left: names a pair that no SRDF disables")

    def test_adjacent_is_said_of_links_that_one_joint_joins_never_of_whole_links_always_of_what_no_joint_moves(self):
        robot("desk", link("top", box_of("1 1 0.1")), link("near", box_of("0.1 0.1 0.1", "0.1 0 0.1")),
              link("far", box_of("0.1 0.1 0.1", "0 0.4 0.1")), link("drop", box_of("0.1 0.1 0.1", "0.18 0 0.1")),
              link("bare", ""), link("arm", box_of("0.05 0.05 1", "0 0 0.5")), joint("a", "fixed", "top", "near"),
              joint("b", "fixed", "top", "far"), joint("c", "fixed", "top", "drop"), joint("d", "fixed", "bare", "arm"),
              joint("turn", "revolute", "top", "bare", '<origin xyz="-0.4 0 0"/><axis xyz="0 1 0"/>', (-0.5, 0.1)))
        flashbvh("audit desk.urdf --write desk.srdf")
        reasons = re.findall('link1="([a-z]*)" link2="([a-z]*)" reason="([A-Za-z]*)"', text("desk.srdf"))
        self.assertEqual(sorted(reasons), sorted([
            ("top", "near", "Adjacent"), ("top", "far", "Adjacent"), ("top", "drop", "Adjacent"),
            ("top", "arm", "Default"), ("near", "far", "Never"), ("near", "drop", "Always"), ("near", "arm", "Never"),
            ("far", "drop", "Never"), ("far", "arm", "Never"), ("drop", "arm", "Never")]))
        flashbvh("audit desk.urdf desk.srdf").matches(
            "^near - drop  *[0-9]*  *Always  *contact  *no joint moves them, intersecting$")

    def test_what_is_refused_names_the_place_and_the_fix(self):
        write("macro.srdf", '<robot xmlns:xacro="http://ros.org/wiki/xacro" name="crane">\n<disable_collisions '
              'link1="arm" link2="hook"/>\n<xacro:include filename="more.srdf"/></robot>')
        write("cut.srdf", '<robot name="crane">\n<disable_collisions link1="base"\n')
        refuse_each("audit crane.urdf", {
            "cut.srdf": "cut.srdf:2: is no XML: unclosed token in <'robot'>; correct it there",
            "macro.srdf": "macro.srdf:3: is a xacro (it has <xacro:include>), not yet expanded; write `xacro "
                "macro.srdf > OUT.srdf` and name OUT.srdf",
            "gone.srdf": "gone.srdf",
            "crane.srdf --time 0": "--time 0: is no time; give a number of seconds above 0",
            "crane.srdf --write crane.srdf": "crane.srdf: would replace",
            "crane.srdf --write crane.urdf": "crane.urdf: would replace",
        })
        refuse("robot crane.urdf -o out --srdf macro.srdf", "macro.srdf:3: is a xacro")
        flashbvh("robot crane.urdf -o image --format image")
        write("low.csv", "spin,slide,lift\n0,0,0.3")
        refuse("guard image/crane.robot low.csv --package a=b", "--package is for a URDF")

    @long
    def test_a_link_of_more_triangles_than_firmwares_indices_reach_is_audited_and_refused_for_firmware_alone(self):
        large_meshes()
        base = link("base", shape('<mesh filename="meshes/many_triangles.stl" scale="0.01 0.01 0.01"/>'))
        robot("large", base, link("arm", box_of("0.3 0.02 0.02", "0.35 0 0.1")),
              joint("lift", "revolute", "base", "arm", '<axis xyz="0 1 0"/>', (-1, 1)))
        write("large.srdf", f'<robot name="large">{disables("base", "arm")}</robot>')
        write("at.csv", "lift\n0\n")
        [line] = flashbvh("audit large.urdf large.srdf --json", code=1).json["lines"]
        self.assertEqual((line["verdict"], line["triangles"][0]["source"]), ("refuted", "meshes/many_triangles.stl"))
        refusal = "large.urdf, link 'base': 66000 triangles, but 16-bit indices reach 65535; use --simplify"
        # Refused before any decision, or the message would be the SRDF's.
        refuse("robot large.urdf -o out --srdf large.srdf", refusal)
        refuse("guard large.urdf at.csv", refusal)
        refuse("robot large.urdf -o out --simplify 0.001 --time 1e-9",
               "--time 1e-9: left too little to simplify 'base' to what firmware holds; give more")
