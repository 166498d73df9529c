"""release.py DIR FLASHBVH [PACKAGE...]    The packages of this tree in DIR, a folder each, or only those
named; FLASHBVH is the host program, which bakes what the examples need. tools/release.sh calls it, and
makes Debian's binary packages.

A package is the library's headers and sources, and the files of tools/release/<package>, in which
@version@ and its like are filled in and a line with @source@ stands for as many as there are sources:
all of lib/src. The same commit gives the same bytes.
"""
from __future__ import annotations

import gzip
import lzma
import os
import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from email.utils import formatdate
from pathlib import Path

from amalgamation import write_amalgamation

ROOT = Path(__file__).resolve().parents[2]
TEMPLATES = ROOT / "tools" / "release"
LIBRARIES = ["arduino", "platformio", "zephyr", "esp-idf", "cmsis"]


def read_sources() -> tuple[list[str], list[str]]:
    """The library's sources, and those of its layer for robots, divided as in lib/CMakeLists.txt."""
    found = sorted(path.relative_to(ROOT / "lib").as_posix() for path in ROOT.glob("lib/src/*/*.cpp"))
    robot = [name for name in found if re.search(r"/(robot/|c/c_robot_)", name)]
    return [name for name in found if name not in robot], robot


def git(*arguments: str) -> str:
    return subprocess.run(["git", "-C", str(ROOT), *arguments], check=True, capture_output=True,
                          text=True).stdout


def read_facts() -> dict[str, str]:
    version = (ROOT / "lib/include/flashbvh/version.hpp").read_text()
    licence = (ROOT / "LICENSE").read_text().rstrip().split("\n", 4)
    return {
        "version": ".".join(re.search(rf"_{part} (\d+)", version)[1]
                            for part in ("MAJOR", "MINOR", "PATCH")),
        "author": os.environ.get("FLASHBVH_AUTHOR", "The flashbvh authors"),
        "email": os.environ.get("FLASHBVH_EMAIL", "flashbvh@flashbvh.example"),
        "url": os.environ.get("FLASHBVH_URL", "https://flashbvh.example"),
        "sentence": "Exact mesh-against-mesh collision and distance queries on a microcontroller.",
        "paragraph": "Triangle meshes and robots, baked on the desktop, lie in flash; answers come "
                     "without a heap, in constant memory, in slices of bounded time, and are the "
                     "same on every core.",
        "copyright": licence[2].removeprefix("Copyright (c) "),
        "license": "\n".join(f" {line or '.'}" for line in licence[4].split("\n")),
        # Debian's changelog needs a date; the commit's date is the same on every machine.
        "date": formatdate(commit_time()).replace("-0000", "+0000"),
    }


def commit_time() -> int:
    return int(git("log", "-1", "--format=%ct"))


def fill(text: str, facts: dict[str, str], lists: dict[str, list[str]]) -> str:
    for name, values in lists.items():
        text = re.sub(rf"^.*@{name}@.*\n",
                      lambda line: "".join(line[0].replace(f"@{name}@", value) for value in values),
                      text, flags=re.M)
    return re.sub(r"@(\w+)@", lambda name: facts[name[1]], text)


def fill_templates(package: str, target: Path, facts: dict[str, str],
                   lists: dict[str, list[str]]) -> None:
    for template in sorted((TEMPLATES / package).rglob("*")):
        if template.is_file():
            file = target / template.relative_to(TEMPLATES / package)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(fill(template.read_text(), facts, lists))
            file.chmod(template.stat().st_mode & 0o755)


def write_package(package: str, target: Path, facts: dict[str, str],
                  lists: dict[str, list[str]]) -> None:
    shutil.copytree(ROOT / "lib/include", target / ("src" if package == "arduino" else "include"))
    shutil.copytree(ROOT / "lib/src", target / "src", dirs_exist_ok=True)
    write_documents(target)
    fill_templates(package, target, facts, lists)


def write_documents(target: Path) -> None:
    shutil.copy(ROOT / "LICENSE", target)
    shutil.copy(ROOT / "README.md", target)
    shutil.copy(ROOT / "lib/docs/changelog.md", target / "CHANGELOG.md")


def sketch_of(program: str) -> str:
    """The firmware as a sketch: main() becomes setup(), which prints its status."""
    sketch, mains = re.subn(r"^int main\(\) \{\n", "void setup() {\n  Serial.begin(115200);\n", program,
                            flags=re.M)
    sketch, ends = re.subn(r"  return (.*) \? 0 : 1;\n\}\n\Z",
                           r'  port::print(\1 ? "as it should be\\n" : "WRONG\\n");\n}\n\nvoid loop() {}\n',
                           sketch)
    if (mains, ends) != (1, 1):
        sys.exit("release: an example's main() is not what becomes a sketch")
    # Arduino finds a library by its header, which must be the first include.
    return sketch.replace("#include", "#include <flashbvh.h>\n#include", 1)


def write_examples(target: Path, flashbvh: str) -> None:
    examples = ROOT / "firmware_examples"
    bakes = {
        "quick_start": ["bake", "plate.obj", "peg.obj", "--format", "c"],
        "robot_guard": ["robot", "cell_arm/cell_arm.urdf", "--stop", "0.005", "--warn", "0.03"],
    }
    for name, command in bakes.items():
        folder = target / name
        folder.mkdir(parents=True)
        (folder / f"{name}.ino").write_text(sketch_of((examples / name / "main.cpp").read_text()))
        shutil.copy(TEMPLATES / "sketch/text.hpp", folder)
        subprocess.run([flashbvh, *command, "-o", folder], cwd=examples / name, check=True,
                       stdout=subprocess.DEVNULL)
    for header in ["quick_start/query.hpp", "robot_guard/cell_arm/arm.hpp", "robot_guard/motion.hpp"]:
        shutil.copy(examples / header, target / header.split("/")[0])
    shutil.copy(examples / "host/timer.hpp", target / "robot_guard")


def files_below(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if path.is_file())


def write_zip(archive: Path, folder: Path, prefix: str) -> None:
    with zipfile.ZipFile(archive, "w") as file:
        for path in files_below(folder):
            entry = zipfile.ZipInfo(prefix + path.relative_to(folder).as_posix())  # dated 1980
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o100644 << 16
            file.writestr(entry, path.read_bytes())


def write_tar(archive: Path, folder: Path, time: int) -> None:
    def owned_by_nobody(entry: tarfile.TarInfo) -> tarfile.TarInfo:
        entry.mtime, entry.uid, entry.gid, entry.uname, entry.gname = time, 0, 0, "", ""
        entry.mode = 0o755 if entry.mode & 0o100 else 0o644
        return entry

    with open(archive, "wb") as raw, \
            (lzma.open(raw, "wb") if archive.suffix == ".xz" else
             gzip.GzipFile("", "wb", mtime=time, fileobj=raw)) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as file:
        for path in files_below(folder):
            file.add(path, f"{folder.name}/{path.relative_to(folder)}", filter=owned_by_nobody)


def copy_tracked(tree: Path, *below: str) -> None:
    for name in git("ls-files", *below).splitlines():
        if not name.startswith(".") and (ROOT / name).is_file():
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, tree / name)


def write_python(target: Path, facts: dict[str, str]) -> None:
    tree = target / f"flashbvh-{facts['version']}"
    copy_tracked(tree, "CMakeLists.txt", "LICENSE", "README.md", "lib", "tools",
                 "tests/reference", "tests/figures/budgets.csv", "tests/figures/cycles.csv",
                 "ports/cycles/tables/flash.csv")  # the paper's trees; sources of the costs
    for name in "pyproject.toml", "setup.py":
        shutil.move(tree / "tools/python" / name, tree)
    fill_templates("python", tree, facts, {})
    write_tar(target / f"{tree.name}.tar.gz", tree, commit_time())
    shutil.rmtree(tree)


def write_debian(target: Path, facts: dict[str, str]) -> None:
    tree = target / f"flashbvh-{facts['version']}"
    copy_tracked(tree)
    time = commit_time()
    write_tar(target / f"flashbvh_{facts['version']}.orig.tar.gz", tree, time)
    fill_templates("debian", tree / "debian", facts, {})
    subprocess.run(["dpkg-source", "-b", tree.name], cwd=target, check=True, stdout=subprocess.DEVNULL,
                   env={**os.environ, "SOURCE_DATE_EPOCH": str(time)})


def write(package: str, target: Path, flashbvh: str) -> None:
    facts = read_facts()
    sources, robot_sources = read_sources()
    folder = target / "flashbvh"
    if package == "amalgamation":
        write_amalgamation(ROOT / "lib", target, sources, robot_sources)
        write_documents(target)
    elif package in ("debian", "python"):
        {"debian": write_debian, "python": write_python}[package](target, facts)
    else:
        write_package(package, folder, facts, {"source": sources, "robot_source": robot_sources})
    if package == "arduino":
        write_examples(folder / "examples", flashbvh)
        write_zip(target / f"flashbvh-{facts['version']}.zip", folder, "flashbvh/")
    elif package == "cmsis":
        write_zip(target / f"flashbvh.flashbvh.{facts['version']}.pack", folder, "")


def main(target: Path, flashbvh: str, packages: list[str]) -> None:
    for package in packages or [*LIBRARIES, "amalgamation", "debian", "python"]:
        shutil.rmtree(target / package, ignore_errors=True)
        (target / package).mkdir(parents=True)
        write(package, target / package, flashbvh)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]).resolve(), str(Path(sys.argv[2]).resolve()), sys.argv[3:])
