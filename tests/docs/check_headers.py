"""check_headers.py WORK: doxygen reads the public headers' comments without a warning. Every type and every function
has a comment; fields, constants and aliases need none."""
import re
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ALLOWED = re.compile(r"\((variable|typedef|macro definition)\) .* is not documented")


def main(work):
    if not shutil.which("doxygen"):
        sys.exit(77)
    shutil.rmtree(work, ignore_errors=True)
    Path(work).mkdir(parents=True)
    options = (HERE / "Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {work}\n"
    log = subprocess.run(["doxygen", "-"], input=options, cwd=HERE.parents[1] / "lib/include", text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT).stdout
    if not Path(work, "xml/classflashbvh_1_1Pose.xml").exists():
        sys.exit(log)
    warnings = [line for line in log.splitlines() if not ALLOWED.search(line)]
    print("\n".join(warnings))
    sys.exit(bool(warnings))


if __name__ == "__main__":
    main(*sys.argv[1:])
