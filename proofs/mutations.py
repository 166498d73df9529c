"""mutations.py OUT

Makes each change of mutations.txt in a copy; a proof must refuse it. OUT: the folder that check.sh has checked.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
CHANGE = re.compile(r"  (.*?):\s+(.*)\[\[(.*) ==> (.*)\]\](.*)")
REFUSAL = re.compile(r"[A-Za-z_]+\.(?:v|g|smt2)(?=:)|no longer has")


def changes(table):
    """Description, file, old text, new text and proofs of each change."""
    file, proofs = "", []
    for line in table.replace("\n    ", " ").splitlines():
        if found := CHANGE.fullmatch(line):
            what, before, old, new, after = found.groups()
            yield what, file, before + old + after, before + new + after, proofs
        elif not line.startswith("#"):
            file, _, names = line.partition(":")
            proofs = names.split() or [Path(file).name]


def prepare(out, work):
    """A folder for the checks, with the compiled files."""
    shutil.rmtree(work, ignore_errors=True)
    (work / "out").mkdir(parents=True)
    for compiled in out.glob("*.vo"):
        shutil.copy(compiled, work / "out")


def refusal(check, work, proofs):
    """The proof that refuses the library in a folder, or nothing."""
    done = subprocess.run([check, work / "lib", work / "out", *proofs], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    found = REFUSAL.search(done.stdout)
    return (found[0] if found else "?") if done.returncode else ""


def main(out):
    out = Path(out)
    work, survived = out / "mutations", 0
    table = list(changes((ROOT / "proofs/mutations.txt").read_text()))
    prepare(out, work)
    # All proofs accept the unchanged library, so each refusal below is caused by the change.
    shutil.copytree(ROOT / "lib", work / "lib")
    if refused := refusal(ROOT / "proofs/check.sh", work, sorted({name for *_, proofs in table for name in proofs})):
        sys.exit(f"mutations.py: {refused} refuses what is not changed")
    for what, file, old, new, proofs in table:
        prepare(out, work)
        for folder in ("lib", "proofs"):
            shutil.copytree(ROOT / folder, work / folder)
        text = (work / file).read_text()
        if old not in text:
            sys.exit(f"mutations.py: {file} has no: {old}")
        (work / file).write_text(text.replace(old, new, 1))
        refused = refusal(work / "proofs/check.sh", work, proofs)
        survived += not refused
        print(f"refused: {what} ({refused})" if refused else f"SURVIVED: {what}", flush=True)
    shutil.rmtree(work)
    print(f"== {len(table) - survived} changes refused, {survived} survived")
    return survived != 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
