"""Pages answer like the firmware, in node; browsers show them and drive them like a reader. Without Clang for WebAssembly,
node or Debian's chromium, what needs them is skipped."""
import json
import re
import shutil
import unittest
from pathlib import Path

from cli import Case, flashbvh, HERE, page_data, ROOT, run, text, TOOLS, write
from inputs import box_of, images, joint, link, meshes, robot

ARM = ROOT / "firmware_examples/robot_guard/cell_arm/cell_arm.urdf"

# Checks the style's effects: the page is not wider than its window, tables scroll.
PROBE = """
const drawn = () => {
  if (!window.live) return true;
  const { canvas, view } = live, { gl } = view;
  view.draw(live.matrices(), live.colours(), live.colour("--ground"), live.marks());
  const pixels = new Uint8Array(4 * canvas.width * canvas.height);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  return new Set(new Uint32Array(pixels.buffer)).size > 4;
};
onload = () => setTimeout(() => {
  const matrix = document.querySelector('.matrix');
  parent.postMessage(JSON.stringify({
    wide: document.documentElement.scrollWidth > innerWidth, drawn: drawn(),
    matrix: innerWidth > 400 || !matrix || (matrix.parentNode.scrollWidth > matrix.parentNode.clientWidth &&
      matrix.querySelector('tbody th').offsetWidth < matrix.parentNode.clientWidth / 2),
    live: [...document.querySelectorAll('#live *')].every(part => part.getBoundingClientRect().right <= innerWidth),
    ground: getComputedStyle(document.body).backgroundColor }), '*');
}, 500);
"""


def robot_page():
    flashbvh(f"robot {ARM} -o . --format image --stop 0.01 --warn 0.05 --report page.html")


def pair_page():
    meshes()
    write("small.obj", "v 0 0 0\nv 5 0 0\nv 0 5 0\nv 0 0 5\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4")
    flashbvh("bake meshes/ring.stl small.obj -o . --format image --unit mm")
    write("poses", "\n".join(f"0.6 -0.8 0  0.8 0.6 0  0 0 1  {i % 9 * 3 - 4}.25 {i % 7 * 4} 0.{i}" for i in range(105)))
    flashbvh("report ring.fbvh small.fbvh --poses poses -o page.html")


def skip_without(program, page):
    if not page_data(page)["drawing"]:
        raise unittest.SkipTest("built without Clang for WebAssembly")
    if not shutil.which(program):
        raise unittest.SkipTest(f"there is no {program}")


def browse(page, *options):
    """The page after its scripts have run."""
    return run("timeout", 300, "chromium", "--headless=new", "--no-sandbox", "--hide-scrollbars", "--use-gl=angle",
               "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage",
               f"--user-data-dir={Path('profile').resolve()}", "--window-size=1000,900", "--virtual-time-budget=20000",
               *options, "--dump-dom", Path(page).resolve().as_uri())


def with_script(page, script, target):
    write(target, text(page).replace("</body>", f"<script>\n{script}</script>\n</body>"))


class PagesTest(Case):
    def answers(self, *images):
        skip_without("node", "page.html")
        write("known.json", run(TOOLS / "cli_page_answers", *images))
        run("node", HERE / "answers.mjs", "page.html", "known.json")

    def test_a_robots_page_answers_like_the_guard(self):
        robot_page()
        self.assertLess(len(text("page.html")), 1000000)
        self.answers(*Path(".").glob("*.robot"))

    def test_a_page_of_meshes_answers_like_the_queries(self):
        pair_page()
        self.answers("ring.fbvh", "small.fbvh")

    def drive(self, page, claims):
        skip_without("chromium", page)
        with_script(page, (HERE / "drive.js").read_text(), "driven.html")
        found = re.findall("<p>claim ([^<]*)", browse("driven.html"))
        self.assertEqual([claim for claim in found if not claim.endswith(": true")], [])
        self.assertEqual(len(found), claims, found)

    def test_a_reader_moves_a_robot(self):
        robot_page()
        self.drive("page.html", 9)

    # To a collision of two links, straight from values without one.
    def test_a_reader_plays_a_trajectory(self):
        robot_page()
        witness = next(pair["witness"] for pair in page_data("page.html")["facts"][0]["pairs"] if pair["witness"])
        write("way.csv", "\n".join([",".join(witness), *(
            ",".join(str(i / 100 * value) for value in witness.values()) for i in range(101))]))
        [image] = Path(".").glob("*.robot")
        flashbvh(f"guard {image} way.csv --report guard.html", code=1)
        self.drive("guard.html", 9)

    def test_a_reader_moves_a_mesh(self):
        pair_page()
        self.drive("page.html", 17)

    # Light and dark, wide and narrow; a matrix of long names scrolls in its card, and the names at its left leave space
    # for it. Canvases show meshes in more than one colour. A window is at least 500 pixels wide; a frame may be narrower.
    def test_a_browser_shows_each_page(self):
        if not shutil.which("chromium"):
            self.skipTest("there is no chromium")
        base, *others = "a_link_with_a_rather_long_name", *(f"another_link_whose_name_is_long_{i}" for i in range(1, 6))
        robot("gantry", link(base, box_of("0.1 0.1 0.1")), *(
            link(name, box_of("0.1 0.1 0.1")) + joint(f"slide_{i}", "prismatic", base, name, (
                f'<origin xyz="0 {10 * i + 1} 0"/><axis xyz="0 1 0"/>'), (-1, 1)) for i, name in enumerate(others)))
        write("way.csv", "slide_0,slide_1,slide_2,slide_3,slide_4\n0,0,0,0,0\n-1,0,0,0,0\n")
        flashbvh("robot gantry.urdf -o gantry --format image --stop 0.01 --report robot.html")
        flashbvh("guard gantry/gantry.robot way.csv --report guard.html", code=1)
        pair_page()
        frames = ["robot.400", "guard.400", "page.400", "page.500", "page.1400"]
        for page in "robot", "guard", "page":
            with_script(f"{page}.html", PROBE, f"probe_{page}.html")
        write("frames.html", "\n".join([
            "<script>onmessage = event => { document.body.append(Object.assign(document.createElement('p'),",
            "{ textContent: event.data })); }</script>", *(
                f"<iframe src='probe_{frame.split('.')[0]}.html' style='width:{frame.split('.')[1]}px;height:900px;"
                "border:0'></iframe>" for frame in frames)]))
        for scheme, ground in (1, "rgb(246, 247, 249)"), (0, "rgb(13, 17, 23)"):
            with self.subTest(scheme):
                dom = browse("frames.html", f"--blink-settings=preferredColorScheme={scheme}")
                self.assertEqual([json.loads(found) for found in re.findall("<p>({[^<]*)", dom)], 5 * [
                    {"wide": False, "drawn": True, "matrix": True, "live": True, "ground": ground}])
