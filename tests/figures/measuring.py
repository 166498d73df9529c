"""What tools/figures.sh runs: builds and runs what measures, gathers what that leaves in build folders."""
import json
import os
import re
import shutil
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build"
FOLDER = BUILD / "figures"
# What measures: the figures, the memory (proofs/stack) and the bounds (proofs/time).
TESTS = "figures: measured|memory, and both stacks|bound: no run takes more"
# Each pair of links that no joint connects, of those that fit 256 KB together.
LINKS = "bicep", "forearm", "palm", "wrist"
PAIRS = "bicep-palm", "forearm-palm", "bicep-forearm", "bicep-wrist"
# A pose in poses.cpp: its entries; the last numbers are the visits and the work.
POSE = re.compile(r" *\{\{.*\}, \{.*\}, (\d+), \d+, \d+, (\d+)\},?$")


def quietly(*command, **environment):
    """What it prints is shown if it fails."""
    done = subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}, text=True, errors="replace",
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        sys.exit(f"{done.stdout}figures: this failed: {' '.join(map(str, command))}")
    return done.stdout


def boards():
    """The presets that have one, and are measured (tests/CMakeLists.txt)."""
    presets = json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]
    return [preset["name"] for preset in presets if "FLASHBVH_BOARD" in preset.get("cacheVariables", {})
            and preset["name"] not in ("lx106", "rv32im")]


def poses_in(file):
    """The pair of links, and the visits and work of each pose."""
    pair, poses = "", defaultdict(list)
    for line in file.read_text().splitlines():
        links = re.search(r"&(\w+)::mesh, &(\w+)::mesh,", line)
        pose = POSE.match(line)
        if links:
            pair = "-".join(links.groups())
        elif pose:
            poses[pair].append(tuple(map(int, pose.groups())))
    return poses


def leaves_of(link):
    header = (FOLDER / f"{link}.fbvh.hpp").read_text()
    return int(re.search(r"uint32_t kLeafCount = (\d+)", header)[1])


class Robot:
    """The KR5, whose links and poses are measured."""
    def __init__(self, urdf, native):
        self.urdf, self.meshes, self.native = urdf, urdf.parent / "meshes", native
        self.flashbvh = BUILD / native / "bin/flashbvh"

    def bake(self, folder, *options):
        """The links' trees; returns their bytes and their triangles."""
        table = quietly(self.flashbvh, "bake", *(self.meshes / f"{link}.STL" for link in LINKS), "-o", folder,
                        *options).splitlines()
        head = next(i for i, line in enumerate(table) if line.split()[:2] == ["mesh", "flash"])
        total = next(line for line in table[head:] if line.split()[0] == "total")
        row = dict(zip(table[head].split(), total.split()))
        return int(row["flash"]), int(row["triangles"])

    def write_poses(self, folder):
        quietly(BUILD / self.native / "bin/write_poses", folder, FOLDER / "leaf1", *PAIRS)

    def visits(self):
        """Of each pair what bounds a query's visits, and the most that any pose takes."""
        poses = poses_in(FOLDER / "poses.cpp")
        for pair in PAIRS:
            a, b = pair.split("-")
            bound = json.loads(quietly(self.flashbvh, "collide", FOLDER / f"{a}.fbvh", FOLDER / f"{b}.fbvh",
                                       "--bound", "--json"))
            for name, field in (("ranked", "most_visits"), ("work", "most_work"), ("depths", "depths"),
                                ("siblings", "later_siblings"), ("leaf_size", "leaf_size")):
                yield f"all visits.{pair}.{name} {bound[field]}"
            yield f"all visits.{pair}.any {2 * leaves_of(a) * leaves_of(b) - 1}"
            yield f"all visits.{pair}.observed {max(visits for visits, _ in poses[pair])}"

    def leaf_size(self, size):
        """What trees of that leaf size take, and the work that the rotated poses need with them."""
        folder = FOLDER / f"leaf{size}"
        flash, triangles = self.bake(folder, "--leaf-size", str(size))
        self.write_poses(folder)
        yield f"all leaf.{size}.flash {flash / triangles:.1f}"
        # 16 poses of each class and each pair, translated, then rotated.
        poses = poses_in(folder / "poses.cpp").values()
        for of_class, begin in ("close", 96), ("intersecting", 112):
            work = [work for of_pair in poses for _, work in of_pair[begin:begin + 16]]
            yield f"all leaf.{size}.work.{of_class}.mean {sum(work) / len(work):.0f}"
            yield f"all leaf.{size}.work.{of_class}.max {max(work)}"

    def prepare(self, for_boards_alone):
        """The links as arrays, the poses, and what they take of flash."""
        quietly("cmake", "--preset", self.native)
        quietly("cmake", "--build", "--preset", self.native, "--target", "flashbvh_tool", "write_poses")
        FOLDER.mkdir(parents=True, exist_ok=True)
        host = FOLDER / "host.txt"
        host.unlink(missing_ok=True)
        flash, triangles = self.bake(FOLDER)
        self.bake(FOLDER / "leaf1", "--leaf-size", "1")
        self.write_poses(FOLDER)
        quietly(self.flashbvh, "robot", self.urdf, "--name", "kr5_arm", "-o", FOLDER / "robot")
        if not for_boards_alone:
            lines = [line for size in range(1, 9) for line in self.leaf_size(size)]
            lines += [f"all flash.default {flash / triangles:.1f}", f"all flash.triangles {triangles}",
                      f"all flash.bytes {flash}", *self.visits()]
            host.write_text("".join(f"{line}\n" for line in lines))

    def configure(self, preset, folder):
        quietly("cmake", "--preset", preset, f"-DFLASHBVH_HOST_TOOL={self.flashbvh}",
                f"-DFLASHBVH_KR5_FIGURES={folder}")

    def measure(self, preset):
        """Its tests leave figures.txt, memory.txt and bound.txt in its build folder."""
        print(f"Measuring {preset}", flush=True)
        self.configure(preset, FOLDER)
        quietly("cmake", "--build", "--preset", preset, "--target", "figures")
        quietly("ctest", "--preset", preset, "-R", TESTS)

    def trees(self, preset):
        """A row for each leaf size and arity; the build is left as it was."""
        folder = FOLDER / "trees"
        folder.mkdir(exist_ok=True)
        (folder / "robot").unlink(missing_ok=True)
        (folder / "robot").symlink_to("../robot")
        cache = (BUILD / preset / "CMakeCache.txt").read_text()
        run, shift = (re.search(f"^FLASHBVH_{name}:INTERNAL=(.*)$", cache, re.M)[1].replace(";", " ")
                      for name in ("RUN", "ICOUNT_SHIFT"))
        print("| leaf size | arity | bytes a triangle | close, mean | most | intersecting, mean | most | "
              "rotated: close, mean | most | intersecting, mean | most |\n" + "|--:" * 11 + "|")
        for size, arity in ((size, arity) for size in range(1, 5) for arity in (2, 3, 4, 6, 8)):
            flash, triangles = self.bake(folder, "--leaf-size", str(size), "--arity", str(arity))
            self.write_poses(folder)
            self.configure(preset, folder)
            quietly("cmake", "--build", "--preset", preset, "--target", "figures_kr5")
            lines = quietly(sys.executable, "-B", "tests/figures/figures.py", "run", folder / "figures.txt",
                            BUILD / preset / "bin/figures_kr5.elf", RUN=run, FLASHBVH_ICOUNT=shift)
            value = dict(line.split()[1:] for line in lines.splitlines())
            cells = [value[f"kr5.query.{motion}.{of_class}.{of}"] for motion in ("translated", "rotated")
                     for of_class in ("close", "intersecting") for of in ("mean", "max")]
            print("|", " | ".join([str(size), str(arity), f"{flash / triangles:.1f}", *cells]), "|", flush=True)
        self.configure(preset, FOLDER)


def lines_of(file):
    return [line.split() for line in file.read_text().splitlines()] if file.exists() else []


def gather(preset):
    """Writes a preset's figures to one file, which is returned."""
    build = BUILD / preset
    if not (build / "figures.txt").exists():
        sys.exit(f"figures: nothing measured in build/{preset}: run its tests, or tools/figures.sh without "
                 "--compare")
    gathered = build / "measured.txt"
    shutil.copyfile(build / "figures.txt", gathered)
    core = next((words[0] for words in lines_of(gathered) if words[0] != "all"), "")
    lines = [f"{core} {'.'.join(words[:-1])} {words[-1]}"
             for name in ("memory.txt", "bound.txt") for words in lines_of(build / name)
             if re.fullmatch("[0-9.]+", words[-1])]
    if (build / "bound.txt").exists():
        for words in lines_of(build / "bound_measured.txt"):
            if words[0] == "measured":
                _, name, observed, _, proven, *_ = words
                lines += [f"{core} runs.{name}.observed {observed}",
                          f"{core} runs.{name}.proven {proven.rstrip(',')}"]
    if preset == "native":
        lines += map(" ".join, lines_of(FOLDER / "host.txt"))
    with gathered.open("a") as file:
        file.writelines(f"{line}\n" for line in lines)
    return gathered
