"""The program `flashbvh`, which bakes."""
import json
import os
import shutil
import subprocess
import warnings
from numbers import Integral, Real
from pathlib import Path

from ._c import Error


class BakeWarning(UserWarning):
    """A warning of the program `flashbvh`."""

    __module__ = "flashbvh"


def run(command, files, names=(), **options):
    """The JSON object that a command prints. Its warnings become BakeWarnings, of the caller's caller; its refusal an
    Error. names: pairs of a temporary file's path, and of the text in its place in both.
    """
    beside = Path(__file__).with_name("flashbvh")
    program = os.environ.get("FLASHBVH") or (str(beside) if beside.exists() else shutil.which("flashbvh"))
    if program is None:
        raise Error("the program `flashbvh` is neither beside the package nor in PATH; set FLASHBVH to its file")
    done = subprocess.run([program, command, "--json", *_words(options), "--", *map(os.fsdecode, files)],
                          capture_output=True)
    messages = done.stderr.decode(errors="replace").strip()
    for path, name in names:
        messages = messages.replace(path, name)
    if done.returncode != 0:
        raise Error(messages.removeprefix("flashbvh: ") or f"the program ended with {done.returncode}")
    for line in messages.splitlines():
        warnings.warn(line.removeprefix("flashbvh: "), BakeWarning, stacklevel=3)
    return json.loads(done.stdout)


def _words(options):
    """Options of the command line: none for None and False, a flag for True, one for each element of a list or a
    dictionary, whose option has no `s` at its end."""
    for name, value in options.items():
        option = "--" + name.replace("_", "-")
        if isinstance(value, dict):
            option, value = option.removesuffix("s"), [f"{_text(key)}={_text(one)}" for key, one in value.items()]
        for one in value if isinstance(value, list) else [value]:
            if one is not None and one is not False:
                yield option
                if one is not True:
                    yield _text(one)


def _text(value):
    if isinstance(value, tuple):
        return ",".join(map(_text, value))
    if isinstance(value, (bytes, os.PathLike)):
        return os.fsdecode(value)
    return repr(float(value)) if isinstance(value, Real) and not isinstance(value, Integral) else str(value)
