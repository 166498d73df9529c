"""joints.py URDF: prints the joints between the arm's links, from its URDF file, as C++ (joints.hpp).

Exits with 1 and the reason unless six revolute joints connect the seven links to a chain, in order, and none of
them is rotated at rest.
"""
import re
import sys
import xml.etree.ElementTree as xml

LINKS = "base_link shoulder bicep elbow forearm wrist palm".split()


class Unexpected(Exception):
    pass


def value(joint, tag, name):
    found = joint.find(tag)
    if found is None or found.get(name) is None:
        raise Unexpected(f"a joint without {tag} {name}")
    return found.get(name)


def literals(text, count):
    """`count` numbers as C++ floats."""
    words = text.split()
    if len(words) != count:
        raise Unexpected(f"not {count} numbers: {text}")
    for word in words:
        if not re.fullmatch(r"-?\d+(\.\d*)?([eE][-+]?\d+)?", word):
            raise Unexpected(f"no number: {word}")
    shown = [f"{float(word):.9g}" for word in words]
    return ", ".join(number + ("f" if re.search("[.e]", number) else ".0f") for number in shown)


def row(joint, number):
    a, b = LINKS[number - 1:number + 1]
    if value(joint, "parent", "link") != a or value(joint, "child", "link") != b:
        raise Unexpected(f"joint {number} is not between {a} and {b}")
    if value(joint, "origin", "rpy").split() != ["0", "0", "0"]:
        raise Unexpected(f"joint {number} is rotated at rest")
    origin, axis = (literals(value(joint, tag, "xyz"), 3) for tag in ("origin", "axis"))
    least, most = (literals(value(joint, "limit", name), 1) for name in ("lower", "upper"))
    return f"    {{{{{origin}}}, {{{axis}}}, {least}, {most}}},  // {joint.get('name')}"


def main():
    try:
        joints = [j for j in xml.parse(sys.argv[1]).iter("joint") if j.get("type") == "revolute"]
        if len(joints) != len(LINKS) - 1:
            raise Unexpected(f"{len(joints)} revolute joints, not {len(LINKS) - 1}")
        rows = [row(joint, number) for number, joint in enumerate(joints, 1)]
    except (Unexpected, xml.ParseError) as why:
        sys.exit(f"{sys.argv[1]}: not the arm that was expected: {why}")
    print("// Written by joints.py; the numbers are those of the URDF file.\n#pragma once\n\n#include \"arm.hpp\"\n\n"
          "constexpr Joint kJoints[kJointCount] = {", *rows, "};", sep="\n")


if __name__ == "__main__":
    main()
