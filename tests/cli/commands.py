"""The program's help texts with their examples, and shell completions."""
import re
import shlex
import shutil
from pathlib import Path

from checks import ROOT, flashbvh, hold, run

# Each script reads `lines`, the text after `flashbvh ` up to the cursor, and prints each completed last word.
DRIVERS = {
    "bash": r"""
        compopt() { :; }  # there is no cursor
        source ./script
        while IFS= read -r line; do
          read -ra COMP_WORDS <<<"flashbvh ${line/=/ = }"
          [[ $line != *' ' ]] || COMP_WORDS+=('')
          COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
          COMPREPLY=()
          _flashbvh
          echo "${COMPREPLY[@]}"
        done <lines""",
    "fish": r"""
        source script
        while read -l line
          echo (complete -C "flashbvh $line" | cut -f 1)[1]
        end <lines""",
    "zsh": r"""
        zmodload zsh/zpty
        zpty terminal zsh -fi
        zpty -w terminal 'autoload -U compinit; compinit -D -u; source ./script'
        zpty -w terminal 'flashbvh() { print -r -- "$@[-1]" >>answers }'
        while IFS= read -r line; do zpty -w terminal "flashbvh $line"$'\t'; done <lines
        zpty -w terminal exit
        while zpty -r terminal >seen; do :; done
        cat answers"""}


def names():
    return re.findall(r"^  (\w+)  ", flashbvh("--help").split("Subcommands:")[1], re.M)


def files_here():
    return set(Path(".").rglob("*"))


def try_example(*command):
    """A command's help ends in an example that works: it prints something or makes files, and the files that it names
    exist."""
    text = flashbvh(*command, "--help")
    found = re.search(r"\n\nExample:\n  flashbvh (.*)  # (.+)\n\Z", text)
    hold(found, f"no example: {text}")
    before = files_here()
    said = flashbvh(*shlex.split(found[1]))
    hold(said or files_here() > before, f"prints and makes nothing: {found[1]}")
    for name in re.findall(r"\S+\.\w+", found[2]):
        hold(Path(name).exists(), f"no {name}: {found[0]}")


def try_examples():
    for folder in "quick_start/plate.obj", "quick_start/peg.obj", "robot_guard/cell_arm/cell_arm.urdf":
        shutil.copy(ROOT / "firmware_examples" / folder, ".")
    Path("cell_arm.urdf").rename("arm.urdf")
    Path("poses.txt").write_text("1 0 0 0 1 0 0 0 1 0 0 -5\n1 0 0 0 1 0 0 0 1 0 0 5\n")
    Path("points.txt").write_text("0 0 -5\n0 0 5\n")
    Path("rays.txt").write_text("0 0 5 0 0 -5\n")
    Path("motion.csv").write_text("turn,shoulder,elbow,roll\n0,0,0,0\n0.01,0,0,0\n")
    try_example()
    for name in names():
        try_example(name)


def completed(shell, lines):
    """The completed last word of each line; None if the shell is not installed."""
    script = flashbvh("completion", shell)
    for name in names():
        hold(re.search(rf"\b{name}\b", script), f"{shell}: no {name}")
    if not shutil.which(shell):
        return None
    Path("script").write_text(script)
    Path("lines").write_text("".join(line + "\n" for line in lines))
    said = run(shell, "-c", DRIVERS[shell])
    hold(not said.warnings, f"{shell}: {said.warnings[:500]}")
    return said.splitlines()


def try_completion(shell, wanted):
    """wanted: the expected completion of each line's last word."""
    found = completed(shell, wanted)
    for line, word, answer in zip(wanted, wanted.values(), found or ()):
        hold(answer.removesuffix("/").endswith(word), f"{shell}: '{line}' becomes '{answer}', not '{word}'")
    hold(found is None or len(found) == len(wanted), f"{shell}: {found}")
