"""program.py: prints a printer's program, one block per line: {{start}, {end}, speed}, in micrometres and per second.

It prints a star between finished parts: layers of perimeters and infill, with travels between them. Some
travels are bad: they come from a slicer that knows neither the clamps nor the gantry.
"""
from math import cos, pi, sin

MIDDLE = 125, 55
FAST, SLOW = 150, 60
at = (125, 10, 60)


def go(x, y, z, speed=FAST):
    global at
    start, end = ("{{%s}}" % ", ".join(str(round(100 * value) * 10) for value in place) for place in (at, (x, y, z)))
    print(f"{{{start}, {end}, {1000 * speed}}},")
    at = x, y, z


def perimeter(radius, z, parts=24):
    for i in range(parts + 1):
        turn = 2 * pi * i / parts
        r = radius * (1 + 0.15 * cos(5 * turn))
        go(MIDDLE[0] + r * cos(turn), MIDDLE[1] + r * sin(turn), z, SLOW if i else FAST)


def infill(z):
    for i in range(-6, 7):
        half = (13 ** 2 - (2 * i) ** 2) ** 0.5 * (1 if i % 2 else -1)
        go(MIDDLE[0] - half, MIDDLE[1] + 2 * i, z, FAST)
        go(MIDDLE[0] + half, MIDDLE[1] + 2 * i, z, SLOW)


def tour(*points):
    """A travel up from the star, through the points, and back."""
    begin, above = at, (*MIDDLE, 95)
    for point in above, *points, above, begin:
        go(*point)


BAD = [
    [(205, 60, 95), (205, 60, 6), (205, 150, 6), (205, 150, 95)],      # through a clamp
    [(94, 150, 95), (94, 150, 12), (94, 150, 95)],                     # next to the vase, but the heater is wide
    [(190, 60, 30), (190, 100, 30), (190, 100, 95)],                   # the head is far from the vase, the gantry not
    [(60, 60, 70), (60, 200, 70), (60, 200, 95)],                      # over the vase, but too low
    [(-6, 60, 95), (-6, 60, 2), (-6, 60, 95)],                         # next to the arch, but the duct is wide
]

for layer in range(6):
    height = 0.2 + 3 * layer
    perimeter(16, height)
    perimeter(15.5, height)
    infill(height)
    if layer < len(BAD):
        tour(*BAD[layer])
    # Good travels: along the bed, and down onto the wheel, like a probe.
    tour((200, 40, 95), (20, 190, 95), (165, 165, 95), (165, 165, 15), (165, 165, 95))
