"""every_function.py NM LIBRARY... -- OBJECT...: checks that the objects, those of the tests against C++, call each C
function that the libraries define. At most 64: what a firmware in C calls, and one way to do a thing."""
import subprocess
import sys


def names(nm, files, kinds):
    lines = subprocess.run([nm, *files], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
    fields = [line.split()[-2:] for line in lines if len(line.split()) >= 2]
    return {name for kind, name in fields if kind in kinds and name.startswith("flashbvh_")}


def main(nm, *files):
    end = files.index("--")
    defined = names(nm, files[:end], "T")
    missing = sorted(defined - names(nm, files[end + 1:], "U"))
    print(f"{len(defined)} functions, not called: {' '.join(missing) or 'none'}")
    sys.exit(1 if missing or not 50 < len(defined) <= 64 else 0)


main(*sys.argv[1:])
