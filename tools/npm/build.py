#!/usr/bin/env python3
"""build.py    The program as npm package, for node: build/npm/flashbvh-VERSION.tgz. Equal commits give equal bytes.

Needs Debian's packages emscripten, binaryen, clang, lld, wasi-libc, libclang-rt-14-dev-wasm32, dpkg-dev, libutfcpp-dev,
libcli11-dev and nlohmann-json3-dev, and the sources of other libraries, which it fetches as Debian has them.
"""
import gzip
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
BUILD = ROOT / "build/npm"
SOURCES = "assimp console-bridge expat meshoptimizer tinyxml urdfdom urdfdom-headers zlib".split()


def run(*command, **more):
    return subprocess.run([str(word) for word in command], check=True, text=True, **more).stdout


def fetch(folder):
    """Debian's source packages. Own package lists: those of the machine do not change."""
    (folder / "apt/lists/partial").mkdir(parents=True, exist_ok=True)
    found = run("apt-get", "indextargets", "--format", "deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)",
                "Created-By: Packages", "Label: Debian", capture_output=True)
    (folder / "apt/list").write_text("\n".join(sorted(set(found.splitlines()))) + "\n")
    own = [word for setting in (f"sourcelist={folder}/apt/list", "sourceparts=-") for word in ("-o", f"Dir::Etc::{setting}")]
    own += ["-o", f"Dir::State::lists={folder}/apt/lists"]
    run("apt-get", "-q", *own, "update")
    run("apt-get", "-q", *own, "source", *SOURCES, cwd=folder)
    (folder / "complete").touch()


def build(time):
    """The folders of the program and of its libraries, which are static."""
    # NODE_PATH: the modules of Emscripten's scripts; Debian's own node finds them there.
    made = {"env": {**os.environ, "NODE_PATH": "/usr/share/nodejs", "SOURCE_DATE_EPOCH": str(time)}}
    sources, prefix, program = BUILD / "sources", BUILD / "libraries", BUILD / "program"
    if not (sources / "complete").exists():
        fetch(sources)
    by_emscripten = ["-G", "Ninja", "--toolchain", HERE / "wasm.cmake", "-DCMAKE_BUILD_TYPE=Release"]
    run("cmake", *by_emscripten, "-S", HERE / "dependencies", "-B", prefix / "build", f"-DSOURCES={sources}",
        f"-DCMAKE_INSTALL_PREFIX={prefix}", **made)
    run("cmake", "--build", prefix / "build", "--target", "install", **made)
    run("cmake", *by_emscripten, "-S", ROOT, "-B", program, "-DFLASHBVH_BUILD_TOOL=ON", "-DFLASHBVH_BUILD_TESTS=OFF",
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCMAKE_FIND_ROOT_PATH={prefix}",
        f"-DCMAKE_CXX_STANDARD_INCLUDE_DIRECTORIES={prefix}/include", **made)
    run("cmake", "--build", program, "--target", "flashbvh_tool", **made)
    return program / "bin", prefix


def pack(archive, files, time):
    """A tar of npm's form from texts by their names: dated, and owned by nobody."""
    with open(archive, "wb") as raw, gzip.GzipFile("", "wb", mtime=time, fileobj=raw) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.GNU_FORMAT) as tar:
        for name, text in sorted(files.items()):
            entry = tarfile.TarInfo(f"package/{name}")
            entry.size, entry.mtime, entry.mode = len(text), time, 0o755 if name == "flashbvh.js" else 0o644
            tar.addfile(entry, io.BytesIO(text))


def main():
    if not shutil.which("emcc"):
        sys.exit(f"{__file__}: no Emscripten; {__doc__.split(chr(10) * 2)[1]}")
    time = int(run("git", "-C", ROOT, "log", "-1", "--format=%ct", capture_output=True))
    programs, prefix = build(time)
    version = ".".join(re.findall(r"_(?:MAJOR|MINOR|PATCH) (\d+)", (ROOT / "lib/include/flashbvh/version.hpp").read_text()))
    manifest = {**json.loads((HERE / "package.json").read_text()), "version": version}
    files = {f"licenses/{path.name}": path.read_bytes() for path in (prefix / "licenses").iterdir()}
    files |= {"LICENSE": (ROOT / "LICENSE").read_bytes(), "README.md": (HERE / "README.md").read_bytes(),
              "package.json": (json.dumps(manifest, indent=2) + "\n").encode(),
              "flashbvh.wasm": (programs / "flashbvh.wasm").read_bytes(),
              "flashbvh.js": b"#!/usr/bin/env node\n" + (programs / "flashbvh.js").read_bytes()}
    pack(BUILD / f"flashbvh-{version}.tgz", files, time)


if __name__ == "__main__":
    main()
