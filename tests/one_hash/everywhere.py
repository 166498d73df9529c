"""everywhere.py QUERIES PERIODS PROGRAM PYTHON MODULE: compares the hash of these counts by the program one_hash and by
the Python package; fails if they differ."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path


def printed(*command, **environment):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True,
                          env={**os.environ, **environment}).stdout.strip()


def main(queries, periods, program, python, module):
    with tempfile.TemporaryDirectory() as folder:
        in_cpp = printed(program, queries, periods, folder)
        in_python = printed(python, "-B", Path(__file__).with_name("answers.py"), folder, PYTHONPATH=module)
    print(f"{in_cpp} C++\n{in_python} CPython")
    return in_cpp != in_python


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
