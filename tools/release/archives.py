"""archives.py DIR [TARGET...]    The host program for machines without Debian: DIR/archives, for Linux and Windows, and
DIR/npm, for node. tools/release.sh calls it. Built in build/archives; the same commit gives the same bytes.
"""
from __future__ import annotations

import hashlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

from release import ROOT, commit_time, fill, read_facts, write_tar, write_zip

TARGETS = ("linux", "windows", "wasm")
BUILDS = ROOT / "build" / "archives"
# NODE_PATH: the modules of Emscripten's scripts; Debian's own node finds them there.
ENVIRONMENT = {**os.environ, "NODE_PATH": "/usr/share/nodejs", "SOURCE_DATE_EPOCH": str(commit_time())}


def run(*command: object) -> None:
    subprocess.run([str(word) for word in command], check=True, env=ENVIRONMENT)


def build(target: str) -> tuple[Path, Path]:
    """The folders of the program and of its libraries."""
    prefix, program = BUILDS / target / "libraries", BUILDS / target / "program"
    run(ROOT / "tools/release/dependencies.sh", target, prefix)
    run("cmake", "-G", "Ninja", "-S", ROOT, "-B", program, "--toolchain", ROOT / f"tools/release/targets/{target}.cmake",
        "-DCMAKE_BUILD_TYPE=Release", "-DFLASHBVH_BUILD_TOOL=ON", "-DFLASHBVH_BUILD_TESTS=OFF",
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_FIND_ROOT_PATH={prefix}",
        f"-DCMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES={prefix}/include")
    run("cmake", "--build", program, "--target", "flashbvh_tool")
    return program / "bin", prefix


def fill_folder(folder: Path, programs: list[Path], prefix: Path) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for program in programs:
        shutil.copy(program, folder)
    shutil.copy(ROOT / "LICENSE", folder)
    shutil.copytree(prefix / "licenses", folder / "licenses")


def write_archive(target: str, release: Path, version: str) -> None:
    programs, prefix = build(target)
    name = f"flashbvh-{version}-{target}-x86_64"
    folder = BUILDS / target / name
    fill_folder(folder, [programs / {"linux": "flashbvh", "windows": "flashbvh.exe"}[target]], prefix)
    shutil.copy(ROOT / "README.md", folder)
    if target == "linux":
        write_tar(release / "archives" / f"{name}.tar.xz", folder, commit_time())
    else:
        write_zip(release / "archives" / f"{name}.zip", folder, f"{name}/")


def write_npm(release: Path, facts: dict[str, str]) -> None:
    programs, prefix = build("wasm")
    folder = BUILDS / "wasm" / "package"
    fill_folder(folder, [programs / "flashbvh.wasm"], prefix)
    (folder / "flashbvh.js").write_text("#!/usr/bin/env node\n" + (programs / "flashbvh.js").read_text())
    for name in ("package.json", "README.md"):
        (folder / name).write_text(fill((ROOT / "tools/npm" / name).read_text(), facts, {}))
    write_tar(release / "npm" / f"flashbvh-{facts['version']}.tgz", folder, commit_time())


def main(release: Path, targets: list[str]) -> None:
    facts = read_facts()
    for name in ("archives", "npm"):
        (release / name).mkdir(parents=True, exist_ok=True)
    for target in targets or TARGETS:
        if target == "wasm":
            write_npm(release, facts)
        else:
            write_archive(target, release, facts["version"])
    archives = sorted((release / "archives").glob("flashbvh-*"))
    (release / "archives/SHA256SUMS").write_text(
        "".join(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in archives))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(Path(sys.argv[1]).resolve(), sys.argv[2:])
