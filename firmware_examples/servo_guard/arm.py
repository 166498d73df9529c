"""arm.py ROBOT FILE HEADER: writes the table of an arm's servos. ROBOT: the name in the baked robot's header.

A line of FILE: the joint's name, the servo's id, its count at the joint's zero, 1 or -1 (counts grow as the joint's
value falls), its speed in counts a second at most. # begins a comment.
"""
import re
import sys


def servo_of(words):
    joint, *numbers = words
    number, offset, sign, speed = map(int, numbers)
    if not 0 <= number < 254 or not 0 <= offset < 4096 or sign not in (1, -1) or not 0 < speed <= 100000:
        raise ValueError
    return joint, number, offset, sign, speed


def main():
    robot, name, header = sys.argv[1:]
    servos = []
    with open(name) as file:
        for row, line in enumerate(file, 1):
            words = line.split("#")[0].split()
            try:
                servos += [servo_of(words)] if words else []
            except ValueError:
                sys.exit(f"{name}:{row}: give a joint, an id from 0 to 253, an offset from 0 to 4095, 1 or -1, and a "
                         f"speed in counts a second")
    for i in 0, 1:
        if len({servo[i] for servo in servos}) < len(servos):
            sys.exit(f"{name}: a {('joint', 'servo id')[i]} has two lines; give each one")
    lines = [f"    {{{robot}_variable_{re.sub('[^A-Za-z0-9_]', '_', joint)}, {', '.join(map(str, numbers))}}},"
             for joint, *numbers in servos]
    with open(header, "w") as file:
        file.write("\n".join([
            f"// Written by arm.py from {name.split('/')[-1]}.", "#pragma once", f'#include "{robot}.robot.h"',
            '#include "servo_guard.hpp"', f"#define ARM(name) {robot}_##name",
            "constexpr servo::Servo kServos[] = {", *lines, "};",
            "static_assert(sizeof kServos / sizeof *kServos == ARM(VARIABLE_COUNT), \"a joint has no line\");", ""]))


if __name__ == "__main__":
    main()
