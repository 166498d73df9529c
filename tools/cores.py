#!/usr/bin/env python3
"""The list of cores, ports/cores.json, of which presets and test steps are made.

cores.py --presets   writes CMakePresets.json
cores.py --check     fails if CMakePresets.json is not what --presets writes
cores.py --measured  prints the presets of boards that tools/test.sh --all measures: figures, stacks and bounds
cores.py --answers   prints those of all other boards
cores.py PRESET      prints what tools/test.sh --all tests there: measured, answers (all board tests), digest
"""
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
CORES = json.loads((ROOT / "ports/cores.json").read_text())
PRESETS = ROOT / "CMakePresets.json"

BASE = {
    "name": "base", "hidden": True, "generator": "Ninja", "binaryDir": "${sourceDir}/build/${presetName}",
    "cacheVariables": {"CMAKE_BUILD_TYPE": "RelWithDebInfo", "CMAKE_EXPORT_COMPILE_COMMANDS": "ON",
                       "FLASHBVH_TEST_PREFIX": "${presetName}"}}
CLANG = {"CMAKE_CXX_COMPILER": "clang++", "CMAKE_C_COMPILER": "clang", "CMAKE_BUILD_TYPE": "Debug",
         "FLASHBVH_SANITIZE": "ON"}
HOST = [
    ("native", "This machine: the library, the host tool and all host tests",
     {"CMAKE_BUILD_TYPE": "Release", "CMAKE_C_FLAGS_RELEASE": "-O2 -DNDEBUG",
      "CMAKE_CXX_FLAGS_RELEASE": "-O2 -DNDEBUG", "FLASHBVH_BUILD_PYTHON": "ON"}),
    ("native-sanitize", "As native, with Clang's address and undefined-behaviour sanitizers",
     {**CLANG, "CMAKE_C_FLAGS_DEBUG": "-O1 -g1", "CMAKE_CXX_FLAGS_DEBUG": "-O1 -g1",
      "CMAKE_EXE_LINKER_FLAGS": "-fuse-ld=lld -no-pie"}),
    ("dev", "Edit, build, test: what an edit of the library breaks, in a minute",
     {**CLANG, "FLASHBVH_SANITIZE": "OFF", "FLASHBVH_FAST_BUILD": "ON", "FLASHBVH_CCACHE": "ON",
      "CMAKE_C_FLAGS_DEBUG": "-O1 -g1", "CMAKE_CXX_FLAGS_DEBUG": "-O1 -g1", "CMAKE_EXE_LINKER_FLAGS": "-fuse-ld=lld"}),
    ("fuzz", "The fuzzed programs alone, with Clang's libFuzzer (tests/fuzz/run.sh)",
     {**CLANG, "CMAKE_C_FLAGS_DEBUG": "-O1 -g", "CMAKE_CXX_FLAGS_DEBUG": "-O1 -g", "FLASHBVH_FUZZ": "ON",
      "FLASHBVH_BUILD_TOOL": "OFF", "FLASHBVH_BUILD_TESTS": "OFF"}),
]
# An edit of the library breaks these tests first: those with the label `library`.
DEV_BUILD = {"dev": {"targets": ["library_tests"]}}
DEV_TEST = {"dev": {"filter": {"include": {"label": "library"}}, "execution": {"noTestsAction": "error", "jobs": 2}}}


def configure_presets():
    for name, title, variables in HOST:
        yield {"name": name, "inherits": "base", "displayName": title, "cacheVariables": variables}
    for core in CORES:
        machine = core["machine"] if core["machine"] == "node" else f"QEMU {core['machine']}"
        yield {"name": core["preset"], "inherits": "base", "displayName": f"{core['core']} ({machine})",
               "toolchainFile": f"ports/toolchain/{core['toolchain']}.cmake",
               "cacheVariables": {"FLASHBVH_BOARD": core.get("board", core["machine"])}}


def presets():
    """The file's text, one preset per line."""
    configure = list(configure_presets())
    names = [preset["name"] for preset in configure]
    test = {"name": "base", "hidden": True, "output": {"outputOnFailure": True},
            "execution": {"noTestsAction": "error"}}
    lists = {
        "configurePresets": [BASE, *configure],
        "buildPresets": [{"name": name, "configurePreset": name, **DEV_BUILD.get(name, {})} for name in names],
        "testPresets": [test, *({"name": name, "inherits": "base", "configurePreset": name, **DEV_TEST.get(name, {})}
                                for name in names)],
        "workflowPresets": [{"name": name, "steps": [{"type": step, "name": name}
                                                     for step in ("configure", "build", "test")]}
                            for name in names if name != "fuzz"],
    }
    rows = [f'  "{title}": [\n' + ",\n".join(f"    {json.dumps(preset)}" for preset in made) + "\n  ]"
            for title, made in lists.items()]
    head = '{\n  "version": 6,\n  "cmakeMinimumRequired": {"major": 3, "minor": 25, "patch": 0},\n'
    return head + ",\n".join(rows) + "\n}\n"


def main(argument):
    if argument == "--presets":
        PRESETS.write_text(presets())
    elif argument == "--check":
        if PRESETS.read_text() != presets():
            sys.exit("CMakePresets.json is not made of ports/cores.json: tools/cores.py --presets writes it")
    elif argument in ("--measured", "--answers"):
        print(*(core["preset"] for core in CORES if (core["tests"] == "measured") == (argument == "--measured")))
    elif argument in (tests := {core["preset"]: core["tests"] for core in CORES}):
        print(tests[argument])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) == 2 else "")
