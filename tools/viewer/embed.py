"""embed.py OUTPUT NAME=FILE,FILE...: writes C++ strings, each with its files concatenated; .wasm files in base64."""
import base64
import sys
from pathlib import Path

LONGEST = 4000  # of a piece: compilers need not accept longer ones


def text_of(path):
    data = path.read_bytes()
    return base64.b64encode(data).decode() if path.suffix == ".wasm" else data.decode()


def main(output, *parts):
    lines = ['#include "viewer/page.hpp"', "", "namespace flashbvh::tool {", ""]
    for part in parts:
        name, files = part.split("=")
        text = "".join(text_of(Path(file)) for file in files.split(",") if file)
        pieces = [text[at:at + LONGEST] for at in range(0, len(text), LONGEST)] or [""]
        lines += [f"const char* const {name} =", *(f'R"~~({piece})~~"' for piece in pieces)]
        lines[-1] += ";"
    Path(output).write_text("\n".join([*lines, "", "}  // namespace flashbvh::tool", ""]))


if __name__ == "__main__":
    main(*sys.argv[1:])
