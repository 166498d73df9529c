#!/usr/bin/env python3
"""mutations.py: breaks the library's arithmetic in many ways, one at a time, and fails unless a known-answer test
detects each. Run by hand; 2 minutes. Compiles the portable forms, as for cores without special instructions.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

LIB = pathlib.Path(__file__).resolve().parents[2] / "lib"
# A file of lib, a text that occurs once in it, and its replacement.
MUTATIONS = [
    ("include/flashbvh/detail/bounds/box.hpp", "below(low_half(both_z), zero + z)",
     "below(low_half(both_z), zero + z + 1)"),
    ("include/flashbvh/detail/bounds/box.hpp", "join_halves(threshold(z), threshold(-z))",
     "join_halves(threshold(z), threshold(z))"),
    ("include/flashbvh/detail/walk/ranked.hpp", "if (b_.parent_rank <= a_.parent_rank)",
     "if (b_.parent_rank < a_.parent_rank)"),
    ("src/predicates/triangle.cpp", "bits(height[0] < 0, height[1] < 0, height[2] < 0)",
     "bits(height[0] < 0, height[1] < 0, height[1] < 0)"),
    ("src/predicates/triangle_distance.cpp", "sign_of(area - first) >= 0", "sign_of(area - first) > 9"),
    ("src/predicates/triangle_distance.cpp", "compare(candidate, *least_) < 0", "compare(candidate, *least_) > 0"),
    ("src/bounds/slab.cpp", "set_row(seen, of_a ? -along : along", "set_row(seen, of_a ? along : along"),
    ("src/bounds/slab.cpp", "d.x() * cells(0)", "d.x() * cells(1)"),
    ("src/lattice/pose.cpp", "pose.set_product(left, right, outer.defect() + inner.defect());",
     "pose.set_product(right, left, outer.defect() + inner.defect());"),
    ("src/query/ray.cpp", "order < 0 || (order == 0", "order > 0 || (order == 0"),
    ("src/query/solid.cpp", "p.y <= box.upper[1] - kBoundBias", "p.y + 900 <= box.upper[1] - kBoundBias"),
    ("src/robot/kinematics.cpp", "- fixed_product(x, at.sine)", "+ fixed_product(x, at.sine)"),
    ("src/robot/kinematics.cpp", "fixed_product(frame.rotation[i][2], coordinate)",
     "fixed_product(frame.rotation[i][1], coordinate)"),
    ("src/robot/spheres.cpp", "between > radii ? between - radii : 0", "between"),
    ("src/robot/guard.cpp", "now.left = difference_of(now.distance, pair.stop)", "now.left = now.distance"),
    ("src/robot/guard_measure.cpp", "*to++ = at[joint];", "*to++ = at[0];"),
]
PROGRAM = """
#include "flashbvh/robot/self_test.hpp"
#include "flashbvh/self_test.hpp"
int main() {
  using namespace flashbvh;
  const Status ends[] = {test_known_pairs(), test_known_distances(), test_known_rays(), test_known_guard()};
  int failed = 0;
  for (int i = 0; i < 4; ++i) {
    failed |= ends[i] == Status::done ? 0 : 1 << i;
  }
  return failed;
}
"""
TESTS = "pairs", "distances", "rays", "guard"


def failures(folder):
    """The known-answer tests that fail with the library in `folder`."""
    sources = sorted(path for path in (folder / "src").glob("*/*.cpp") if path.parent.name != "c")
    source = folder / "all.cpp"
    source.write_text("".join(f'#include "{path}"\n' for path in sources) + PROGRAM)
    subprocess.run(["c++", "-std=c++17", "-O0", "-DFLASHBVH_PORTABLE", f"-I{folder}/include", source, "-o",
                    folder / "all"], check=True)
    try:
        status = subprocess.run([folder / "all"], timeout=20).returncode
    except subprocess.TimeoutExpired:
        return ["no end"]
    return ["a crash"] if status < 0 else [name for i, name in enumerate(TESTS) if status >> i & 1]


def main():
    missed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name) / "lib"
        shutil.copytree(LIB, folder)
        if failures(folder):
            sys.exit("mutations.py: a test fails on the library as it is")
        for file, text, broken in MUTATIONS:
            path = folder / file
            whole = path.read_text()
            if whole.count(text) != 1:
                sys.exit(f"mutations.py: {file} has {whole.count(text)} times: {text}")
            path.write_text(whole.replace(text, broken))
            found = failures(folder)
            path.write_text(whole)
            print(f"{file}: {broken}: {', '.join(found) or 'NOT FOUND'}", flush=True)
            missed += not found
    sys.exit(f"mutations.py: {missed} not found" if missed else 0)


if __name__ == "__main__":
    main()
