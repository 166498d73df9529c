"""Pages answer like the firmware, in node; a browser shows them and drives them like a reader, in long tests. Without
Clang for WebAssembly, node or Debian's chromium, what needs them is skipped; `tools/test.sh --all` has all."""
import functools
import json
import os
import shutil
import subprocess
import unittest
from pathlib import Path

from cli import Case, flashbvh, HERE, long, page_data, ROOT, run, text, TOOLS, write
from inputs import box_of, joint, link, meshes, robot
from test_robot_said import gantry

ARM = ROOT / "firmware_examples/robot_guard/cell_arm/cell_arm.urdf"
SIZES = (1280, 800), (1300, 800), (390, 844)

# What of a page's style does not hold: nothing is wider than the window, the drawing is in its first screen and is of
# several colours, the matrix shows its names whole and scrolls beside those at its left.
PROBE = """(() => {
  const { canvas, view, section, trajectory } = live, { gl } = view;
  view.draw(live.matrices(), live.colours(), live.colour("--ground"), live.marks());
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  const box = part => part.getBoundingClientRect(), style = getComputedStyle(document.body);
  const whole = part => part.scrollWidth <= part.clientWidth + 1 && part.scrollHeight <= part.clientHeight + 1;
  const table = document.querySelector(".matrix"), scroll = table && table.parentNode;
  if (table) scroll.scrollLeft = 9999;
  const heads = table ? [...table.querySelectorAll("thead span")] : [];
  const holds = {
    narrow: document.documentElement.scrollWidth <= innerWidth,
    first_screen: box(trajectory ? trajectory.bar : canvas).bottom <= innerHeight && box(canvas).height >= 240,
    drawn: new Set(new Uint32Array(pixels.buffer)).size > 4,
    live: [...section.querySelectorAll("*")].every(part => box(part).right <= innerWidth),
    colours: style.getPropertyValue("--v1") !== style.getPropertyValue("--v4"),
    names: heads.every((head, i) => whole(head) && (i === 0 || box(head).left >= box(heads[i - 1]).right)),
    cells: !table || [...table.querySelectorAll("td, th")].every(whole),
    left: !table || [...table.querySelectorAll("tbody th, thead td")].every(part =>
      box(part).left >= box(scroll).left - 1 && box(part).width < scroll.clientWidth / 2) };
  return [style.backgroundColor, Object.keys(holds).filter(name => !holds[name])];
})()"""


def skip_without_drawing(page):
    if not page_data(page)["drawing"]:
        raise unittest.SkipTest("built without Clang for WebAssembly")


class Browser:
    """A headless Chromium, driven by its DevTools protocol through pipes."""

    def __init__(self):
        self.process = subprocess.Popen(
            ["sh", "-c", 'exec timeout 300 chromium "$@" 3<&0 4>&1 >browser.log 2>&1 </dev/null', "-", "--headless=new",
             "--no-sandbox", "--hide-scrollbars", "--use-gl=angle", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--remote-debugging-pipe",
             f"--user-data-dir={Path('profile').resolve()}"],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.number, self.session, self.unread = 0, {}, b""
        target = self("Target.createTarget", url="about:blank")["targetId"]
        self.session = {"sessionId": self("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]}

    def close(self):
        self.process.terminate()
        self.process.communicate()

    def __call__(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters, **self.session}
        self.process.stdin.write(json.dumps(message).encode() + b"\0")
        self.process.stdin.flush()
        answer = {}
        while answer.get("id") != self.number:
            while b"\0" not in self.unread:
                self.unread += self.process.stdout.read1(1 << 20) or b'{"error": "the browser ended"}\0'
            one, _, self.unread = self.unread.partition(b"\0")
            answer = json.loads(one)
            if "error" in answer:
                raise AssertionError(f"{method}: {answer}")
        return answer["result"]

    def tell(self, script):
        """The script's value."""
        found = self("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in found:
            raise AssertionError(found["exceptionDetails"])
        return found["result"].get("value")

    def show(self, page, width, height, scheme="light"):
        skip_without_drawing(page)
        is_phone = width < 500
        self("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=is_phone)
        self("Emulation.setTouchEmulationEnabled", enabled=is_phone)
        self("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self("Page.navigate", url=Path(page).resolve().as_uri())
        self.tell("""new Promise(shown => {
          const look = () => window.live && live.view ? requestAnimationFrame(shown) : setTimeout(look, 20);
          look(); })""")

    def touch(self, *places):
        """A finger on the first of these places, which moves to the others; then the page has come to rest."""
        for i, (x, y) in enumerate(places):
            self("Input.dispatchTouchEvent", type="touchMove" if i else "touchStart", touchPoints=[{"x": x, "y": y}])
        self("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        self.tell("""new Promise(done => {
          const look = before => scrollY === before ? done() : setTimeout(look, 400, scrollY);
          look(); })""")


def in_browser(test):
    """Only a long run has a browser."""
    @functools.wraps(test)
    def with_browser(self):
        if not shutil.which("chromium") and not os.environ.get("FLASHBVH_TEST_ALL"):
            self.skipTest("there is no chromium: apt-get install chromium")
        browser = Browser()
        self.addCleanup(browser.close)
        test(self, browser)
    return long(with_browser)


def robot_page():
    flashbvh(f"robot {ARM} -o . --format image --stop 0.01 --warn 0.05 --report page.html")


def pair_page():
    meshes()
    write("small.obj", "v 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4")
    flashbvh("bake meshes/ring.stl small.obj -o . --format image --unit mm")
    write("poses", "\n".join(f"0.6 -0.8 0  0.8 0.6 0  0 0 1  {i % 9 * 3 - 4}.25 {i % 7 * 4} 0.{i}" for i in range(105)))
    flashbvh("report ring.fbvh small.fbvh --poses poses -o page.html")


class PagesTest(Case):
    def answers(self, *images):
        skip_without_drawing("page.html")
        if not shutil.which("node"):
            raise unittest.SkipTest("there is no node")
        write("known.json", run(TOOLS / "cli_page_answers", *images))
        run("node", HERE / "answers.mjs", "page.html", "known.json")

    def test_a_robots_page_answers_like_the_guard(self):
        robot_page()
        self.assertLess(len(text("page.html")), 1000000)
        self.answers(*Path(".").glob("*.robot"))

    def test_a_page_of_meshes_answers_like_the_queries(self):
        pair_page()
        self.answers("ring.fbvh", "small.fbvh")

    def drive(self, browser, page, claims):
        browser.show(page, *SIZES[0])
        found = browser.tell((HERE / "drive.js").read_text())
        self.assertEqual([claim for claim in found if not claim.endswith(": true")], [])
        self.assertEqual(len(found), claims, found)

    @in_browser
    def test_a_reader_moves_a_robot(self, browser):
        robot_page()
        self.drive(browser, "page.html", 12)

    # To a collision of two links, straight from values without one.
    @in_browser
    def test_a_reader_plays_a_trajectory(self, browser):
        robot_page()
        witness = next(pair["witness"] for pair in page_data("page.html")["facts"][0]["pairs"] if pair["witness"])
        write("way.csv", "\n".join([",".join(witness), *(
            ",".join(str(i / 100 * value) for value in witness.values()) for i in range(101))]))
        [image] = Path(".").glob("*.robot")
        flashbvh(f"guard {image} way.csv --report guard.html", code=1)
        self.drive(browser, "guard.html", 9)
        browser.show("guard.html", *SIZES[0])
        self.assertTrue(browser.tell("live.trajectory.period > 0"), "a page opens where the guard stops")
        self.assertTrue(browser.tell("live.trajectory.period === live.trajectory.verdicts.search(/[2-5]/)"))
        x, y, width, height = browser.tell("Object.values(live.trajectory.line.getBoundingClientRect().toJSON())")[:4]
        click = {"x": x + width / 4, "y": y + height / 2, "button": "left", "clickCount": 1}
        browser("Input.dispatchMouseEvent", type="mousePressed", **click)
        browser("Input.dispatchMouseEvent", type="mouseReleased", **click)
        self.assertIn(browser.tell("live.trajectory.period"), range(24, 27), "a click on the time line goes there")

    @in_browser
    def test_a_reader_moves_a_mesh(self, browser):
        pair_page()
        self.drive(browser, "page.html", 19)

    # Two neighbours outside their zone, nearer than all other links, are not named as the nearest.
    @in_browser
    def test_a_reader_moves_slides(self, browser):
        gantry()
        flashbvh("robot gantry.urdf -o . --format image --stop 0.003 --report page.html")
        self.drive(browser, "page.html", 4)

    @in_browser
    def test_a_swipe_scrolls_a_phones_page_until_a_tap_chooses_the_model(self, browser):
        robot_page()
        browser.show("page.html", *SIZES[-1])
        looks = "[scrollY, live.view.turn.yaw, live.view.turn.pitch]"
        _, yaw, pitch = browser.tell(looks)
        browser.touch(*((60, 500 - 40 * i) for i in range(8)))
        scrolled, *turned = browser.tell(looks)
        self.assertGreater(scrolled, 100)
        self.assertEqual(turned, [yaw, pitch])
        browser.tell("scrollTo(0, 0)")
        browser.touch((60, 400))
        browser.touch(*((60 + 20 * i, 400 - 20 * i) for i in range(5)))
        scrolled, *turned = browser.tell(looks)
        self.assertEqual(scrolled, 0)
        self.assertNotIn(turned[0], (yaw, turned[1]))

    # With eleven links of long names; light and dark.
    @in_browser
    def test_a_browser_shows_each_page(self, browser):
        base, *others = "a_link_of_a_rather_long_name", *(f"another_link_whose_name_is_long_{i}" for i in range(10))
        robot("gantry", link(base, box_of("0.1 0.1 0.1")), *(
            link(name, box_of("0.1 0.1 0.1")) + joint(f"slide_{i}", "prismatic", base, name, (
                f'<origin xyz="0 {10 * i + 1} 0"/><axis xyz="0 1 0"/>'), (-1, 1)) for i, name in enumerate(others)))
        write("way.csv", "\n".join([",".join(f"slide_{i}" for i in range(10)), "0" + 9 * ",0", "-1" + 9 * ",0"]))
        flashbvh("robot gantry.urdf -o gantry --format image --stop 0.01 --report robot.html")
        flashbvh("guard gantry/gantry.robot way.csv --report guard.html", code=1)
        pair_page()
        for page in "robot", "guard", "page":
            for scheme, ground in ("light", "rgb(246, 247, 249)"), ("dark", "rgb(13, 17, 23)"):
                for size in SIZES:
                    with self.subTest(page=page, size=size, scheme=scheme):
                        browser.show(f"{page}.html", *size, scheme)
                        self.assertEqual(browser.tell(PROBE), [ground, []])
