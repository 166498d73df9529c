"""Arms like those that people have are free at home, by the README's own options."""
import math

from cli import Case, flashbvh, write
from inputs import box_of, joint, link, robot

OPTIONS = "--stop 0.005 --warn 0.03"


def arm(name, links, joints):
    """`links`: names and boxes. `joints`: from each to the next or another link, as axis, origin, rpy, limits."""
    parts = [link(name, *(box_of(*box) for box in boxes)) for name, boxes in links.items()]
    for i, (child, (axis, place, rpy, limits, *more)) in enumerate(joints.items()):
        kind, parent = more or ("revolute", list(links)[i])
        parts.append(joint(f"to_{child}", kind, parent, child,
                           f'<origin xyz="{place}" rpy="{rpy}"/><axis xyz="{axis}"/>', limits))
    robot(name, *parts)


def widow():
    """Boxes that pass each other within 5 mm about the joints: fore and wrist only near home."""
    arm("widow", {
        "base": [("0.07 0.07 0.07", "0 0 0.035")], "shoulder": [("0.06 0.06 0.026", "0 0 0.016")],
        "upper": [("0.05 0.05 0.19", "0 0 0.135")], "elbow": [("0.15 0.04 0.04", "0.09 0 0")],
        "fore": [("0.1 0.04 0.04", "0.053 0 0")], "wrist": [("0.11 0.03 0.03", "0.015 0.038 0")],
        "hand": [("0.06 0.09 0.04", "0.06 0.02 0")], "left": [("0.05 0.01 0.02",)], "right": [("0.05 0.01 0.02",)],
    }, {"shoulder": ("0 0 1", "0 0 0.07", "0 0 0", (-3.1, 3.1)), "upper": ("0 1 0", "0 0 0.08", "0 0 0", (-1.8, 1.9)),
        "elbow": ("0 1 0", "0.05 0 0.25", "0 0 0", (-1.6, 1.6)), "fore": ("1 0 0", "0.17 0 0", "0 0 0", (-3.1, 3.1)),
        "wrist": ("0 1 0", "0.13 0 0", "0 0 0", (-1.7, 1.7)), "hand": ("1 0 0", "0.06 0 0", "0 0 0", (-3.1, 3.1)),
        "left": ("0 1 0", "0.118 0.04 0", "0 0 0", (0, 0.03), "prismatic", "hand"),
        "right": ("0 1 0", "0.118 0 0", "0 0 0", (-0.03, 0), "prismatic", "hand")})


def panda():
    """Boxes that reach into each other about the joints, farther when these are bent; the Panda's lengths."""
    up, down, z = "1.570796 0 0", "-1.570796 0 0", "0 0 1"
    arm("panda", {
        "l0": [("0.14 0.14 0.14", "0 0 0.07")], "l1": [("0.11 0.11 0.24", "0 0 -0.07")],
        "l2": [("0.11 0.17 0.11", "0 -0.035 0")],
        "l3": [("0.1 0.1 0.13", "0 0 -0.125"), ("0.1 0.1 0.09", "0.0825 0 0")],
        "l4": [("0.1 0.09 0.1",), ("0.1 0.06 0.1", "-0.0825 0.09 0")], "l5": [("0.07 0.07 0.28", "0 0 -0.12")],
        "l6": [("0.18 0.09 0.09", "0.04 0 0")], "l7": [("0.06 0.06 0.06", "0 0 0.078")],
        "hand": [("0.06 0.2 0.06", "0 0 0.14")],
    }, {"l1": (z, "0 0 0.333", "0 0 0", (-2.9, 2.9)), "l2": (z, "0 0 0", down, (-1.76, 1.76)),
        "l3": (z, "0 -0.316 0", up, (-2.9, 2.9)), "l4": (z, "0.0825 0 0", up, (-3.07, -0.07)),
        "l5": (z, "-0.0825 0.384 0", down, (-2.9, 2.9)), "l6": (z, "0 0 0", up, (-0.0175, 3.75)),
        "l7": (z, "0.088 0 0", up, (-2.9, 2.9)), "hand": (z, "0 0 0", "0 0 -0.785", None, "fixed", "l7")})


class HomeTest(Case):
    def check_free(self, name, home):
        """At home and within 0.1 rad of it, the guard says free. Returns the shares that zones leave stopped."""
        baked = flashbvh(f"robot {name}.urdf -o out {OPTIONS} --json").json
        joints = baked["joints"]
        rows = [[value + 0.05 * math.sin(i * (k + 1) / 9) * (joints[k]["type"] == "revolute")
                 for k, value in enumerate(home)] for i in range(100)]
        write("home.csv", "\n".join(",".join(map(str, row)) for row in ([one["name"] for one in joints], *rows)))
        out = flashbvh(f"guard {name}.urdf home.csv {OPTIONS} --json")
        self.assertEqual(set(out.each("verdict")), {"free"})
        return {zone["joint"]: zone["stops"] for zone in baked["zones"]}

    def test_links_that_nearly_touch_at_joints_are_free_at_home_neighbours_that_never_touch_need_no_guard(self):
        widow()
        shares = self.check_free("widow", 8 * [0])
        self.assertEqual(shares, {f"to_{child}": 0 for child in ("shoulder", "elbow", "wrist", "left", "right")})
        # Without that zone the guard would not let it be at home.
        flashbvh(f"robot widow.urdf -o out {OPTIONS} --zone to_wrist=0 --format image")
        flashbvh("guard out/widow.robot home.csv", code=1).matches("^free  *0$", "^stop  *[1-9].* fore - wrist$")

    def test_hulls_that_reach_into_each_other_are_free_at_home_and_leave_joints_their_range(self):
        panda()
        shares = self.check_free("panda", (0, -0.785, 0, -2.356, 0, 1.571, 0.785))
        self.assertTrue(all(shares[f"to_l{link}"] <= 0.02 for link in (2, 4, 6)), shares)
