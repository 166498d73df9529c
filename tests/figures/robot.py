"""The measured robot, a KUKA KR5, with its links and poses: built and run by tools/figures.sh."""
import json
import os
import re
import subprocess
import sys
from pathlib import Path

from results import measured_in

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
FOLDER = BUILD / "figures"
# Each pair of links without a common joint, of those that fit 256 KB together.
LINKS = "bicep", "forearm", "palm", "wrist"
PAIRS = "bicep-palm", "forearm-palm", "bicep-forearm", "bicep-wrist"
LEAF_SIZES = 1, 2, 3, 4, 8
# Other meshes, made by firmware_examples/meshes.py, in pairs: organic, well-shaped; mechanical, of slivers.
OTHERS = FOLDER / "meshes"
SHAPES = {"lump": "lump 10 9000", "limb": "limb 20 32 2000 14000", "gear": "gear 14 3 8000",
          "cog": "gear 10 3 5000", "spindle": "turned 60 6000 14000", "flange": "turned 48 8000 5000"}
OTHER_PAIRS = "lump-limb", "gear-cog", "spindle-flange"
# The entries of a pose in poses.cpp; the last number is the work.
POSE = re.compile(r" *\{\{.*\}, \{.*\}, \d+, \d+, \d+, (\d+)\},?$", re.M)


def quietly(*command, **environment):
    """Shows the command's output only if it fails."""
    done = subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        sys.exit(f"{done.stdout}figures.py: this failed: {' '.join(map(str, command))}")
    return done.stdout


def boards():
    """The presets of boards that are measured."""
    cores = json.loads((ROOT / "ports/cores.json").read_text())
    return [core["preset"] for core in cores if core["tests"] != "release" and core["machine"] != "node"]


def leaves_of(link):
    header = (FOLDER / f"{link}.fbvh.h").read_text()
    return int(re.search(r"_LEAF_COUNT (\d+)", header)[1])


class Robot:
    def __init__(self, urdf, native):
        self.urdf, self.meshes, self.native = urdf, urdf.parent / "meshes", native
        self.flashbvh = BUILD / native / "bin/flashbvh"

    def bake(self, folder, *options):
        """Bakes the links; returns their trees' bytes and triangles."""
        return self.bake_all([self.meshes / f"{link}.STL" for link in LINKS], folder, *options)

    def bake_all(self, meshes, folder, *options):
        table = quietly(self.flashbvh, "bake", *meshes, "-o", folder, *options).splitlines()
        head = next(i for i, line in enumerate(table) if line.split()[:2] == ["mesh", "flash"])
        total = next(line for line in table[head:] if line.split()[0] == "total")
        row = dict(zip(table[head].split(), total.split()))
        return int(row["flash"]), int(row["triangles"])

    def write_poses(self, folder, searched=FOLDER / "leaf1", pairs=PAIRS):
        quietly(BUILD / self.native / "bin/write_poses", folder, searched, *pairs)

    def prepare_others(self):
        OTHERS.mkdir(parents=True, exist_ok=True)
        files = []
        for name, shape in SHAPES.items():
            files.append(OTHERS / f"{name}.obj")
            files[-1].write_text(quietly(sys.executable, "-B", ROOT / "firmware_examples/meshes.py", *shape.split()))
        self.bake_all(files, OTHERS)
        self.bake_all(files, OTHERS / "leaf1", "--leaf-size", "1", "--format", "image")
        self.write_poses(OTHERS, OTHERS / "leaf1", OTHER_PAIRS)

    def visits(self):
        """The largest number of visits at any pose, for the pair with the largest bound: by `ranked` and any
        traversal."""
        pairs = {}
        for a, b in (pair.split("-") for pair in PAIRS):
            bound = json.loads(quietly(self.flashbvh, "collide", FOLDER / f"{a}.fbvh", FOLDER / f"{b}.fbvh",
                                       "--bound", "--json"))
            pairs[bound["most_visits"]] = 2 * leaves_of(a) * leaves_of(b) - 1
        yield f"visits.ranked {max(pairs)}"
        yield f"visits.any {pairs[max(pairs)]}"

    def leaf_size(self, size):
        """The size of trees with this leaf size, and the work of the rotated poses with them."""
        folder = FOLDER / f"leaf{size}"
        flash, triangles = self.bake(folder, "--leaf-size", str(size))
        self.write_poses(folder)
        yield f"leaf.{size}.flash {flash / triangles:.1f}"
        # 16 poses of each class, translated, then rotated, for each pair.
        work = list(map(int, POSE.findall((folder / "poses.cpp").read_text())))
        for of_class, begin in ("close", 96), ("intersecting", 112):
            found = [of for pair in range(0, len(work), 128) for of in work[pair + begin:pair + begin + 16]]
            yield f"leaf.{size}.work.{of_class}.mean {sum(found) / len(found):.0f}"
            yield f"leaf.{size}.work.{of_class}.max {max(found)}"

    def prepare(self, for_boards_alone):
        """The links as arrays, the poses, and their flash sizes."""
        quietly("cmake", "--preset", self.native)
        quietly("cmake", "--build", "--preset", self.native, "--target", "flashbvh_tool", "write_poses")
        FOLDER.mkdir(parents=True, exist_ok=True)
        host = FOLDER / "host.txt"
        host.unlink(missing_ok=True)
        flash, triangles = self.bake(FOLDER)
        self.bake(FOLDER / "leaf1", "--leaf-size", "1")
        self.write_poses(FOLDER)
        self.prepare_others()
        # Without the neighbours that can collide: the motions avoid contact of all other pairs.
        quietly(self.flashbvh, "robot", self.urdf, "--zone", "shoulder_pitch=0.15", "--name", "kr5_arm", "-o",
                FOLDER / "robot")
        if not for_boards_alone:
            lines = [line for size in LEAF_SIZES for line in self.leaf_size(size)]
            lines += [f"flash.triangles {triangles}", f"flash.bytes {flash}", *self.visits()]
            host.write_text("".join(f"count {line}\n" for line in lines))

    def configure(self, preset, folder):
        quietly("cmake", "--preset", preset, f"-DFLASHBVH_HOST_TOOL={self.flashbvh}",
                f"-DFLASHBVH_KR5_FIGURES={folder}")

    def measure(self, preset, tests):
        """Stores the tests' output in the preset's build folder."""
        print(f"Measuring {preset}", flush=True)
        self.configure(preset, FOLDER)
        quietly("cmake", "--build", "--preset", preset, "--target", "figures")
        quietly("ctest", "--preset", preset, "-R", tests)

    def trees(self, preset):
        """A row for each leaf size and arity; restores the build."""
        folder = FOLDER / "trees"
        folder.mkdir(exist_ok=True)
        (folder / "robot").unlink(missing_ok=True)
        (folder / "robot").symlink_to("../robot")
        print("| leaf size | arity | bytes a triangle | close, mean | most | intersecting, mean | most | "
              "rotated: close, mean | most | intersecting, mean | most |\n" + "|--:" * 11 + "|")
        for size, arity in ((size, arity) for size in range(1, 5) for arity in (2, 3, 4, 6, 8)):
            flash, triangles = self.bake(folder, "--leaf-size", str(size), "--arity", str(arity))
            self.write_poses(folder)
            self.configure(preset, folder)
            quietly("cmake", "--build", "--preset", preset, "--target", "figures_kr5")
            quietly("ctest", "--preset", preset, "-R", "figures: kr5 measured")
            value = {name: text for (_, name), text in
                     measured_in([(BUILD / preset / "figures/kr5.txt").read_text()]).items()}
            cells = [value[f"kr5.{motion}.{of_class}.query.{of}"] for motion in ("translated", "rotated")
                     for of_class in ("close", "intersecting") for of in ("mean", "max")]
            print("|", " | ".join([str(size), str(arity), f"{flash / triangles:.1f}", *cells]), "|", flush=True)
        self.configure(preset, FOLDER)
