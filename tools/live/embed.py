"""embed.py OUTPUT FILE...: the files as C++ strings, kViewJs of view.js; of .wasm in base64, kArmWasm."""
import base64
import sys
from pathlib import Path

NAMES = ("view.js", "arm.js", "trajectory.js", "live.js", "live.css", "arm.wasm")
LONGEST = 4000  # of a piece: compilers need not take more


def text_of(path):
    data = path.read_bytes()
    return base64.b64encode(data).decode() if path.suffix == ".wasm" else data.decode()


def main(output, *files):
    found = {Path(file).name: text_of(Path(file)) for file in files}
    lines = ['#include "live/parts.hpp"', "", "namespace flashbvh::tool {", ""]
    for name in NAMES:
        text = found.get(name, "")
        pieces = [text[at:at + LONGEST] for at in range(0, len(text), LONGEST)] or [""]
        stem, kind = name.split(".")
        lines.append(f"const char* const k{stem.title()}{kind.title()} =")
        lines += [f'R"~~({piece})~~"' for piece in pieces]
        lines[-1] += ";"
    Path(output).write_text("\n".join([*lines, "", "}  // namespace flashbvh::tool", ""]))


if __name__ == "__main__":
    main(*sys.argv[1:])
