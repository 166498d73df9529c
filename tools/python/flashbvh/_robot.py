"""Robots and their guards. Lengths are in metres, angles in radians."""
import enum
import functools
import math
import struct
import tempfile
from ctypes import byref, c_uint32
from pathlib import Path
from types import SimpleNamespace
from typing import NamedTuple, Optional

import numpy as np

from . import _c, _program
from ._image import Image, numbers

ALL_WORK = _c.NO_LIMIT - 1
"""The largest work of a period."""
_CHECKED = np.dtype([("verdicts", "u1"), ("pairs", "i4"), ("distances", "f8"), ("work", "u4")])


class Verdict(enum.IntEnum):
    """A guard's verdict on a period, from the best to the worst. Up to WARN the robot may move; if LEAVING, only where
    `Guard.limit` lets it."""

    FREE = 0
    WARN = 1
    LEAVING = 2
    NOT_YET_KNOWN = 3
    STOP = 4
    REFUSED = 5


class LimitVerdict(enum.IntEnum):
    """What a guard made of a command."""

    GRANTED = 0
    SHORTENED = 1
    HELD = 2
    NOT_YET_KNOWN = 3
    REFUSED = 4


class Robot(Image):
    """A baked robot: an image, which firmware uses in place. Made by `from_urdf` or `load`.

    cell, the step of the lattice. matrix: rows for all pairs of links, a, b, verdict (never, never outside zone, can,
    undecided, fixed or believed), reason, guarded, and witness, values at which they collide; None for a loaded robot,
    because the image has only the result.
    """
    _baked_by = "robot"

    def __init__(self, image: bytes, place: str = "image") -> None:
        super().__init__(image, place)
        self._robot, self._meshes = _c.Robot(), (_c.Mesh * 255)()
        _c.check(_c.open_robot(*self._view, self._meshes, len(self._meshes), byref(self._robot)), place)
        self.cell: float = struct.unpack_from("<d", image, 24)[0]
        self.matrix = None

    @classmethod
    def from_urdf(cls, path, **options) -> "Robot":
        """Bakes a URDF and decides which pairs of links can collide, by `flashbvh robot`.

        options: of the program: stop, warn, srdf, believe=[(link, link)], packages={name: folder}, visual_too, cell,
        leaf_size, simplify, fit, pairs={(link, link): (stop, warn)}, zones={joint: length}, time.

        Warns (BakeWarning) of pairs that are not guarded, and raises Error with the program's messages.
        """
        with tempfile.TemporaryDirectory(prefix="flashbvh_") as folder:
            table = _program.run("robot", [path], output=folder, format="image", **options)
            file, = Path(folder).glob("*.robot")
            robot = cls(file.read_bytes())
        robot.matrix = _rows(table["pairs"])
        return robot

    @functools.cached_property
    def _description(self):
        with tempfile.TemporaryDirectory(prefix="flashbvh_") as folder:
            self.save(Path(folder, "image.robot"))
            return _program.run("info", [Path(folder, "image.robot")])

    @property
    def _variables(self):
        joints = [joint for joint in self._description["joints"] if "multiplier" not in joint]
        return sorted(joints, key=lambda joint: joint["variable"])

    @functools.cached_property
    def _units(self):
        """A unit of firmware's coordinates of each variable, in radians or metres."""
        return np.array([self.cell / _c.FRAME_CELL if joint["type"] == "prismatic" else math.tau / _c.FULL_TURN
                         for joint in self._variables])

    @property
    def name(self) -> str:
        """The robot's name."""
        return self._description["name"]

    @property
    def joint_names(self) -> list:
        """The n joints that values move, in the values' order; without mimics, which follow other joints."""
        return [joint["name"] for joint in self._variables]

    @property
    def limits(self) -> np.ndarray:
        """(n, 2): lower and upper, both allowed; infinite for a joint without limits."""
        return np.array([(-math.inf, math.inf) if joint["type"] == "continuous" else (joint["lower"], joint["upper"])
                         for joint in self._variables])

    @property
    def link_names(self) -> list:
        """The links with a mesh."""
        return [link["name"] for link in self._description["links"]]

    @functools.cached_property
    def pairs(self) -> list:
        """The guarded pairs, in the order of the numbers that guards report: rows of a, b, stop, warn."""
        return _rows(self._description["pairs"])

    @property
    def unguarded(self) -> list:
        """Pairs that no guard tests, or only outside a joint zone: collisions there are not detected. Rows of a, b,
        reason, and of a zone joint and radius."""
        return _rows(self._description["not_guarded"])


def _rows(objects):
    return [SimpleNamespace(**row) for row in objects]


class GuardAnswer(NamedTuple):
    """A guard's answer for a period. The pair's links stayed `distance` metres apart at least, whatever the verdict."""

    verdict: Verdict
    pair: Optional[int]
    """Index into `Robot.pairs`: the pair of the least clearance with this verdict; None if every pair is free."""
    links: Optional[tuple]
    distance: float
    work: int
    """The work that was spent."""
    status: str
    """done, or why the values were refused."""


class LimitAnswer(NamedTuple):
    """A guard's answer to a command."""

    verdict: LimitVerdict
    granted: np.ndarray
    """(n,): the values to send, in radians and metres."""
    share: float
    """The part of the way to the wanted values, 0 to 1."""
    pair: Optional[int]
    """Index into `Robot.pairs`: the pair that allows no more; None if there is none."""
    links: Optional[tuple]
    floor: float
    """The largest distance of the pair so far, in metres; 0 also while it touches, or is released."""
    distance: float
    """The pair's distance at the granted values, at least."""
    work: int
    status: str


class Guard:
    """Keeps a robot from hitting itself: firmware's guard with its state. Only one thread at a time may call it.

    Values are rounded to 32-bit floats, as firmware gets them.
    """

    def __init__(self, robot: Robot) -> None:
        if not isinstance(robot, Robot):
            raise TypeError("robot: give a Robot")
        self.robot = robot
        about, (between,) = robot._robot, struct.unpack_from("<I", robot.image, 32)
        self._state = (c_uint32 * (_c.guard_state_size(about.joint_count, about.pair_count, between) // 4))()
        self._guard = _c.GuardObject()
        self.forget()

    def update(self, values, work: int = ALL_WORK) -> GuardAnswer:
        """Checks a period: from the last values to these, (n,), in radians and metres, in `joint_names` order.

        work: the budget; the first period needs ALL_WORK. Raises ValueError for another shape or a number that is not
        finite. Values out of limits raise no exception: the verdict is REFUSED.
        """
        row = self._coordinates(values, "values", 1)
        return self._answer(_c.guard_update(byref(self._guard), row.ctypes.data, _budget(work)))

    def go_on(self, work: int = ALL_WORK) -> GuardAnswer:
        """Continues the last period with more work."""
        return self._answer(_c.guard_go_on(byref(self._guard), _budget(work)))

    def limit(self, values, work: int = ALL_WORK) -> LimitAnswer:
        """Lets a command through as far as no pair comes nearer than its stop distance, or gets deeper inside it.

        The command begins at the values granted last, the first time at those of the first `update`.
        """
        wanted = self._coordinates(values, "values", 1)
        granted = np.zeros_like(wanted)
        answer = _c.guard_limit(byref(self._guard), wanted.ctypes.data, granted.ctypes.data, _budget(work))
        pair, links = self._pair(answer)
        lengths = (fine * self.robot.cell / _c.FINE_ONE for fine in (answer.floor, answer.distance))
        return LimitAnswer(LimitVerdict(answer.verdict), granted * self.robot._units, answer.share / 4096, pair, links,
                           *lengths, answer.work, _c.name_of(answer.status))

    def release(self, pair: int, a_command: float) -> None:
        """Lets a pair that touches move, by at most this many metres in each command, until it is apart again."""
        _c.check(_c.guard_release(byref(self._guard), pair,
                                  _c.FineLength(int(a_command / self.robot.cell * _c.FINE_ONE))), "pair")

    def forget(self) -> None:
        """Forgets the robot's position and all known distances."""
        size = len(self._state) * 4
        _c.check(_c.guard_init(byref(self._guard), byref(self.robot._robot), self._state, size), "robot")

    def check(self, trajectory, work: int = ALL_WORK) -> np.recarray:
        """Checks a trajectory, (T, n), one period per row, like `flashbvh guard`: starts without knowledge.

        work: the budget of each period except the first accepted one, which has no limit. Afterwards the guard is at
        the end. Returns an array (T,) with the fields verdicts, numbers of Verdict; pairs, as GuardAnswer.pair, -1 if
        every pair is free; distances, in metres; work.
        """
        rows = self._coordinates(trajectory, "trajectory", 2)
        budget, granted = _budget(work), ALL_WORK
        found = np.recarray(len(rows), _CHECKED)
        self.forget()
        for i, row in enumerate(rows):
            answer = _c.guard_update(byref(self._guard), row.ctypes.data, granted)
            granted = budget if answer.status == _c.DONE else granted
            found[i] = (answer.verdict, -1 if answer.pair == _c.NO_PAIR else answer.pair,
                        answer.distance * self.robot.cell / _c.FINE_ONE, answer.work)
        return found

    def _coordinates(self, values, name, dimensions):
        """Firmware's coordinates of values: the last axis is that of the variables."""
        given = numbers(values, (self.robot._robot.variable_count,), name)
        if given.ndim != dimensions:
            raise ValueError(f"{name}: has the shape {given.shape}; give one of {dimensions} dimensions")
        with np.errstate(over="ignore"):
            floats = np.ascontiguousarray(given, np.float32)
        coordinates = np.empty(floats.shape, np.int32)
        for row in np.ndindex(floats.shape[:-1]):
            _c.set_values(byref(self.robot._robot), floats[row].ctypes.data, coordinates[row].ctypes.data)
        return coordinates

    def _pair(self, answer):
        pair = None if answer.pair == _c.NO_PAIR else answer.pair
        return pair, None if pair is None else (self.robot.pairs[pair].a, self.robot.pairs[pair].b)

    def _answer(self, answer):
        pair, links = self._pair(answer)
        return GuardAnswer(Verdict(answer.verdict), pair, links, answer.distance * self.robot.cell / _c.FINE_ONE,
                           answer.work, _c.name_of(answer.status))


def _budget(work):
    if not 1 <= work <= ALL_WORK:
        raise ValueError(f"work: is {work}; give 1 to {ALL_WORK}")
    return int(work)
