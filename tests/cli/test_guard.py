"""A robot's guard along free, warned and stopped trajectories; motions from line to line; and invalid files."""
import os
import shutil

from cli import (ROOT, Case, elsewhere, fixture, flashbvh, headlines, page_data, refuse, same, search,
                 self_contained, text, write)
from inputs import ARM, robot


@fixture
def arm():
    robot("still", ARM[0])
    robot("arm", *ARM)
    flashbvh("robot arm.urdf -o image --stop 0.01 --warn 0.05 --format image")
    line_up("free.csv", "fold,turn,grip", (-0.5, 0, 0.05), (0.5, 3, 0.05), 300)
    line_up("folded.csv", "turn,grip,fold", (0, 0.05, 0), (0, 0.05, 3), 300)
    line_up("back.csv", "turn,grip,fold", (0, 0.05, 1.5), (0, 0.05, 0.1), 200)


def line_up(file, names, first, last, steps):
    """A trajectory on the straight line in between, one line per step."""
    write(file, "\n".join([names, *(", ".join(f"{a + (b - a) * i / steps:.6f}" for a, b in zip(first, last))
                                    for i in range(steps + 1))]))


class GuardTest(Case):
    inputs = arm,

    def test_free_of_a_urdf_or_an_image(self):
        out = flashbvh("guard arm.urdf free.csv --stop 0.01 --warn 0.05 --motion")
        out.matches(
            "^301 periods, 6 pairs of links guarded$",
            "^stop  *0$",
            "^not yet known  *0$",
            "^motions from line to line: 300 free, 0 not$")
        self.assertEqual(flashbvh("guard image/arm.robot free.csv --motion"), out)
        refuse("guard image/arm.robot free.csv --stop 0.02",
               "arm.robot: is baked already, --stop is for a URDF; leave it out")

    def test_warned_of_then_stopped_in_this_order_before_the_links_touch_a_motion_hits_where_they_do(self):
        out = flashbvh("guard image/arm.robot folded.csv --json --motion", code=1)
        self.assertEqual(flashbvh("guard image/arm.robot folded.csv --json --motion", code=1), out)
        periods, verdicts = out.lines, out.each("verdict")
        self.assertEqual(len(periods), 301)
        self.assertEqual(list(dict.fromkeys(verdicts)), ["free", "warn", "stop"])
        self.assertEqual(verdicts, sorted(verdicts, key=["free", "warn", "stop"].index))
        stop = next(period["line"] for period in periods if period["verdict"] == "stop")
        hit = next(period["line"] for period in periods if period.get("motion", {}).get("outcome") == "hit")
        self.assertLess(stop, hit)
        out.matches(
            '"verdict":"stop","a":"upper","b":"fore","distance":0.0,"work":[0-9]*,"status":"ok"',
            r'"outcome":"hit","part":0.[0-9]*,"a":"upper","b":"fore","triangles":\[[0-9]*,[0-9]*\],'
                r'"values":{"turn":0.0,"fold":2.[0-9]*,"grip":0.0')
        # A period's reported distance is a lower bound of the meshes' distance.
        self.assertTrue(all(0.01 < period["distance"] <= 0.05 for period in periods if period["verdict"] == "warn"))
        flashbvh("guard image/arm.robot folded.csv --motion", code=1).matches(
            f"^stop  *[1-9][0-9]*  first at line {stop}, upper - fore$",
            f"^  to line {hit}: upper - fore hit 0.[0-9]* of the way on, at turn 0, fold 2.[0-9]*, grip 0.05$",
            "more: --json has all$",
            f"^closest: line {hit}, upper - fore intersect$")
        # While moving from far to farther, it warns until it is free.
        flashbvh("guard image/arm.robot back.csv").matches("^closest: line 2,")
        # A budget that is too small shows as not yet known, never as free.
        out = flashbvh("guard image/arm.robot folded.csv --json --work 1", code=1)
        small = out.each("verdict")
        self.assertIn("not_yet_known", small)
        self.assertFalse(any(a == "stop" and b == "free" for a, b in zip(verdicts, small)))

    def test_a_jump_through_the_upper_arm_is_not_free_though_both_of_its_ends_are(self):
        write("jump.csv", "turn,fold,grip\n0,0,0.05\n0,2.9,0.05\n0,0,0.05\n0,0.1,0.05\n")
        out = flashbvh("guard image/arm.robot jump.csv --motion --report page.html", code=1)
        motions = page_data("page.html")["facts"][0]["motions"]
        self.assertEqual([(motion["from"], motion["to"], motion["outcome"]) for motion in motions][1:], [(3, 4, "hit")])
        out.contains("first at line 3")
        # From 6 units of 2^-28 turn below 0 to 6 units below half a turn.
        write("half.csv", "turn,fold,grip\n-1.404e-7,0,0.05\n3.1415925,0,0.05\n")
        flashbvh("guard image/arm.robot half.csv", code=3).err.contains(
            "half.csv:3: a joint without limits turns by half a turn")

    def test_an_arm_that_begins_inside_its_stop_distance_goes_where_limit_lets_it_and_gets_no_deeper(self):
        # Folded 4 mm beyond its stop distance, then further, then out, then folded until it would touch.
        line_up("in.csv", "turn,grip,fold", (0, 0.05, 2.2), (0, 0.05, 2.28), 10)
        line_up("way.csv", "turn,grip,fold", (0, 0.05, 2.28), (0, 0.05, 1.2), 200)
        rows = text("in.csv").splitlines() + text("way.csv").splitlines()[1:] + text("folded.csv").splitlines()[121:]
        write("wanted.csv", "\n".join(rows))
        self.assertIn("leaving", flashbvh("guard image/arm.robot wanted.csv", code=1))
        out = flashbvh("guard image/arm.robot wanted.csv --limit granted.csv --json")
        limits = [line["limit"] for line in out.lines]
        self.assertLessEqual({"granted", "shortened"}, {limit["verdict"] for limit in limits})
        self.assertEqual(set(out.each("verdict")), {"free", "warn", "leaving"})
        self.assertEqual({kind["verdict"]: kind["periods"] for kind in out.lines[0]["limits"]},
                         {kind: sum(limit["verdict"] == kind for limit in limits)
                          for kind in ("granted", "shortened", "held", "not_yet_known", "refused")})
        floors = [limit["floor"] for limit in limits if limit.get("a") == "upper"]
        self.assertTrue(0 < floors[0] < 0.01 < floors[-1] <= 0.0115, floors)
        self.assertEqual(floors, sorted(floors))
        # What was granted is a trajectory of its own.
        self.assertIn("leaving", flashbvh("guard image/arm.robot granted.csv --json", code=1).each("verdict"))
        flashbvh("guard image/arm.robot wanted.csv --limit granted.csv").matches("^shortened  .* upper - fore$")
        line_up("inside.csv", "turn,grip,fold", (0, 0.05, 3), (0, 0.05, 2), 20)
        flashbvh("guard image/arm.robot inside.csv --limit granted.csv", code=1).contains(
            "upper - fore, which touch: only release() lets them apart")
        refuse("guard image/arm.robot wanted.csv --limit granted.csv --core cortex-m4f --hz 1000 --clock 100",
               "--core excludes --limit")

    def test_a_page_has_what_json_says(self):
        out = flashbvh("guard image/arm.robot folded.csv --motion --work 40 --json --report page.html", code=1)
        said = {name: out.lines[0][name] for name in ("periods", "not_guarded", "stretches", "deviation", "motions")}
        self.assertEqual(page_data("page.html")["facts"], [said])
        verdicts = out.each("verdict")
        self.assertEqual(said["periods"],
                         {kind: verdicts.count(kind) for kind in ("free", "warn", "leaving", "stop", "not_yet_known", "refused")})
        outcomes = [line["motion"]["outcome"] for line in out.lines if "motion" in line]
        self.assertEqual(len(said["motions"]), len(outcomes) - outcomes.count("free"))
        shutil.copytree(".", "elsewhere")
        os.remove("elsewhere/page.html")
        elsewhere("guard arm.urdf folded.csv --stop 0.01 --warn 0.05 --motion --work 40 --report ../again.html", code=1)
        same("page.html", "again.html")
        self_contained("page.html")
        # The headlines name what occurs, the worst first, and nothing else.
        flashbvh("guard image/arm.robot free.csv --report page.html")
        count = len(text("free.csv").splitlines()) - 1
        self.assertEqual(headlines("page.html"), [f"Run it; free: {count} of {count} periods"])
        # Periods that are all warned of are not free.
        rows = text("folded.csv").splitlines()
        warned = len(verdicts) - verdicts[::-1].index("warn")
        write("warned.csv", "\n".join([rows[0]] + 5 * [rows[warned]]))
        flashbvh("guard image/arm.robot warned.csv --report warn.html").matches("^warn  *5")
        self.assertEqual(headlines("warn.html"), [
            "Look where links come near before it runs; warn: 5 of 5 periods, first at line 2, upper - fore"])

    def test_what_firmware_refuses_is_said_by_line_and_the_rest_is_answered(self):
        write("limits.csv", "turn,fold,grip\n0,3.5,0\n0,0,0\n0,0.1,0.2\n60,0,0\n0,0,0\n")
        out = flashbvh("guard arm.urdf limits.csv --json --motion", code=3)
        self.assertEqual(out.each("verdict"), ["refused", "free", "refused", "refused", "free"])
        self.assertEqual(out.each("status"),
                         ["joint_out_of_limits", "ok", "joint_out_of_limits", "not_a_coordinate", "ok"])
        out.matches('^{"line":3,"verdict":"free",')
        for run in (out, flashbvh("guard arm.urdf limits.csv --limit granted.csv", code=3)):
            run.err.contains(
                "limits.csv:2: joint 'fold' can't be at 3.5: its limits are -3 and 3; correct",
                "limits.csv:4: joint 'grip' can't be at 0.2: its limits are -0.09 and 0.1; correct",
                "limits.csv:5: joint 'turn' can't be at 60: firmware takes less than 8 turns, 50.27 "
                    "radians; leave full turns out; in degrees? give radians: 1.0472")
        # Of a value just beyond a limit, as many digits as it takes.
        write("just.csv", "turn,fold,grip\n0,3.000002,0\n")
        flashbvh("guard arm.urdf just.csv", code=3).err.contains(
            "just.csv:2: joint 'fold' can't be at 3.000002: its limits are -3 and 3; correct")
        write("over.csv", "turn,fold,grip\n0,3.5,0\n")
        out = flashbvh("guard image/arm.robot over.csv --json", code=3)
        out.err.contains("over.csv:2: joint 'fold' can't be at 3.5: its limits are -3 and 3; correct")
        out.contains('"verdict":"refused","a":null')

    def test_stretches_from_and_to_a_line_and_its_time_printed_in_json_on_the_page(self):
        csv = text("folded.csv").splitlines()
        write("timed.csv", "\n".join([f"secs,{csv[0]}", *(f"{i / 8:g},{row}" for i, row in enumerate(csv[1:]))]))
        first, *others = flashbvh("guard image/arm.robot timed.csv --json --report page.html", code=1).lines
        self.assertFalse(any("stretches" in line for line in others))
        warn, stop = stretches = first["stretches"]
        self.assertEqual(page_data("page.html")["facts"][0]["stretches"], stretches)
        for stretch, verdict in (warn, "warn"), (stop, "stop"):
            self.assertEqual([line["line"] for line in others if line["verdict"] == verdict],
                             list(range(stretch["from"], stretch["to"] + 1)))
            self.assertEqual([stretch[name] for name in ("verdict", "from_time", "to_time", "a", "b")],
                             [verdict, (stretch["from"] - 2) / 8, (stretch["to"] - 2) / 8, "upper", "fore"])
        # The known distance is a lower bound of the measured one; where the guard stops, the links go on to intersect.
        self.assertTrue(0.01 < warn["distance"] <= warn["closest"] <= 0.05)
        self.assertEqual(stop["closest"], 0)
        flashbvh("guard image/arm.robot timed.csv", code=1).matches(
            "^from .*  closest mm  links  *secs$",
            f"^ *{stop['from']}  *302  *stop  *0  *0  *upper - fore  {stop['from_time']:g} to 37.5$")
        # From near to far: the closest line comes first.
        closest = search("^closest: line 2, .*, (.*) m$", flashbvh("guard image/arm.robot back.csv"))
        [stretch] = flashbvh("guard image/arm.robot back.csv --json").lines[0]["stretches"]
        self.assertEqual(f"{stretch['closest']:.4g}", closest)
        # Refused values belong to no pair.
        write("refused.csv", "turn,fold,grip\n0,0,0\n0,9,0\n")
        flashbvh("guard image/arm.robot refused.csv", code=3).matches("^ *3  *3  refused .*  -$")
        stretch = flashbvh("guard image/arm.robot refused.csv --json", code=3).lines[0]["stretches"][0]
        self.assertEqual((stretch["verdict"], stretch["closest"]), ("refused", None))

    def test_what_periods_cost_on_a_core_is_the_sum_of_the_parts_that_were_measured(self):
        [cores, *rows] = [row.split(",") for row in text(ROOT / "tests/figures/budgets.csv").splitlines()]
        part = {name: int(cells[cores.index("RV32IMAC") - 1] or 0) for name, *cells in rows}
        # 13 joints between: column - left 3, - right 3, upper - fore 1, - left 2, - right 2, left - right 2.
        fixed = (part["guard.fixed.period"] + 4 * part["guard.fixed.joint"] + 6 * part["guard.fixed.pair"]
                 + 13 * part["guard.fixed.between"])
        with_work = 2 * fixed + part["guard.kinematics"] * 4 / 6
        a_work = part["guard.work.max"]
        for hz, said in ((200, "work fits a period of 500000 instructions, and all periods here\n"),
                         (2000, "work fits a period of 50000 instructions, too little for some here, which take up to "
                                "{} and would be `not yet known`; take a faster --clock or fewer --hz, or bake"),
                         (20000, "\n0 work fits a period of 5000 instructions, too little for some here")):
            command = f"guard image/arm.robot folded.csv --core rv32imac --clock 100 --hz {hz}"
            out = flashbvh(command + " --json", code=1)
            work = sorted(out.each("work")[1:])
            cost = out.lines[0]["cost"]
            for row, periods in zip(cost["costs"], (work, work[-1:], work[-1:])):
                self.assertAlmostEqual(
                    row["fixed"], sum(with_work if of else fixed for of in periods) / len(periods), delta=1)
                self.assertAlmostEqual(row["of_work"], a_work * sum(periods) / len(periods), delta=1)
                self.assertEqual(row["instructions"], row["fixed"] + row["of_work"])
            fits = max(0, int((1e8 / hz - with_work) / a_work))
            self.assertEqual((cost["a_work"], cost["most_work"], cost["a_period"], cost["work"]),
                             (a_work, work[-1], 1e8 / hz, fits))
            out = flashbvh(command, code=1)
            out.contains(said.format(work[-1]), f"\n{fits} work fits", "\nan estimate, by what a KUKA KR5 takes")
            out.matches(*("^{periods}  *{instructions}  *{fixed}  *{0:.0f} %  *{of_work}  *{1:.0f} %$".format(
                *(100 * row[part] / row["instructions"] for part in ("fixed", "of_work")), **row)
                for row in cost["costs"]))
