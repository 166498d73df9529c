"""prelude.py LIB OUT FILE...

Writes each proof into OUT with the code's constants, and checks its quotations.

  @EXPRESSION@             a Python expression of constants by their names: kMaxDifference, or
                           triangle.cpp:kMaxNarrow where several files have one, sine.hpp:s[2]
  code: FILE | TEXT        to the end of the line: FILE, below LIB, has TEXT, white space aside

So a proof uses the code's constants, and fails if a quoted line has changed.
"""
import pathlib
import re
import sys

DEFINED = re.compile(r"constexpr\s+[\w:]+\s+(\w+)(\[\d+\])?\s*=\s*([^;]+);")
BUILT_IN = {"INT32_MAX": 2**31 - 1, "INT32_MIN": -(2**31), "UINT32_MAX": 2**32 - 1,
            "INT64_MAX": 2**63 - 1, "UINT64_MAX": 2**64 - 1, "UINT16_MAX": 2**16 - 1}


class Constants:
    def __init__(self, lib):
        self.texts = {}  # name: [(file, text)]
        for path in sorted(lib.rglob("*.[ch]pp")):
            for name, _, text in DEFINED.findall(path.read_text()):
                self.texts.setdefault(name, []).append((path.name, text))

    def value(self, name, file=None, near=None):
        if name in BUILT_IN:
            return BUILT_IN[name]
        found = [(f, t) for f, t in self.texts.get(name, []) if file in (None, f)]
        found = [ft for ft in found if ft[0] == near] or found
        if len(set(found)) != 1:
            raise KeyError(f"{file or ''}:{name}: {len(set(found))} definitions in lib")
        where, text = found[0]
        text = re.sub(r"(?<=\d)'(?=\d)|(?<=\d)[uU]\b|\b\w+_cast<[\w:]+>|\b\w+::", "", text)
        text = re.sub(r"\bu?int\d+_t\b", "", text).replace("/", "//")
        return self.evaluate(text.translate(str.maketrans("{}", "[]")) if text.startswith("{")
                             else text.translate(str.maketrans("{}", "()")), where)

    def evaluate(self, text, near=None):
        known = {}

        def named(match):
            known[f"v{len(known)}"] = self.value(match[2], match[1] and match[1][:-1], near)
            return f"v{len(known) - 1}"

        text = re.sub(r"([\w.]+\.[ch]pp:)?\b([A-Za-z_]\w*)", named, text)
        return eval(text, {"__builtins__": {}}, known)  # only the project's own sources


def main():
    lib, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    constants = Constants(lib)
    squeezed = {}
    status = 0
    for name in sys.argv[3:]:
        text = pathlib.Path(name).read_text()
        for number, line in enumerate(text.split("\n"), 1):
            quoted = re.search(r"\bcode: (\S+) \| (.*?)\s*(\*\))?$", line)
            if quoted:
                file = quoted[1]
                if file not in squeezed:
                    squeezed[file] = re.sub(r"\s+", "", (lib / file).read_text())
                if re.sub(r"\s+", "", quoted[2]) not in squeezed[file]:
                    print(f"{name}:{number}: lib/{file} no longer has: {quoted[2]}\n"
                          "  Does the proof still describe the code? Then quote the code as it is.",
                          file=sys.stderr)
                    status = 1
        try:
            text = re.sub(r"@([^@\n]+)@", lambda m: str(constants.evaluate(m[1])), text)
        except (KeyError, SyntaxError) as error:
            print(f"{name}: {error}", file=sys.stderr)
            status = 1
        (out / pathlib.Path(name).name).write_text(text)
    return status


sys.exit(main())
