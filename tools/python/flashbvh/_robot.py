"""Robots, their guards and motions. Lengths are in metres, angles in radians."""
from __future__ import annotations

import enum
from typing import Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
import numpy.typing as npt

from . import _native
from ._columns import columns
from ._image import Image, Path

ALL_WORK: int = _native.ALL_WORK
"""Work of a period without a limit."""


class Verdict(enum.IntEnum):
    """A guard's verdict on a period, from the best to the worst. The robot may move only up to WARN."""

    FREE = 0
    WARN = 1
    NOT_YET_KNOWN = 2
    STOP = 3
    REFUSED = 4


class MatrixRow(NamedTuple):
    """Two links, and whether they can collide within the joints' limits."""

    a: str
    b: str
    verdict: str
    """never, never outside zone, can, undecided, fixed or believed."""
    reason: str
    is_guarded: bool
    witness: Optional[npt.NDArray[np.float64]]
    """(n,): values at which they collide; only with the verdict `can`."""


class GuardedPair(NamedTuple):
    """Two links that a guard keeps apart, and its distances in metres."""

    a: str
    b: str
    stop: float
    warn: float


class UnguardedPair(NamedTuple):
    """Two links that a joint moves and that no guard tests, or only outside a joint zone."""

    a: str
    b: str
    reason: str


class Robot(Image[_native.Robot]):
    """A baked robot: an image, which firmware uses in place. Made by `from_urdf` or `load`."""

    def __init__(self, native: _native.Robot) -> None:
        if not isinstance(native, _native.Robot):
            raise TypeError("a Robot is made by Robot.from_urdf() or Robot.load()")
        super().__init__(native)

    @classmethod
    def from_urdf(cls, path: Path, *, stop: float = 0.0, warn: Optional[float] = None,
                  srdf: Optional[Path] = None, believe: Sequence[tuple[str, str]] = (),
                  packages: Optional[Mapping[str, str]] = None,
                  visual_too: bool = False, cell: Optional[float] = None, leaf_size: Optional[int] = None,
                  simplify: Optional[float] = None, fit: Optional[int] = None,
                  pairs: Optional[Mapping[tuple[str, str], tuple[float, float]]] = None,
                  zones: Optional[Mapping[str, float]] = None, time: Optional[float] = None) -> Robot:
        """Bakes a URDF and decides which pairs of links can collide, like `flashbvh robot`.

        stop, warn: distances at which two links must stop, or cause a warning; warn is stop by default.
        srdf: pairs that need no guard. believe: pairs of the SRDF to leave unguarded although they can collide.
        packages: folders by package, for meshes at package://NAME/.
        visual_too: links that have only visual shapes collide by them. cell, leaf_size: of the links' meshes.
        simplify, fit: fewer triangles, within a length or a number of bytes. pairs: (stop, warn) of two links.
        zones: radii around joints within which two links may touch. time: seconds; later pairs stay undecided.

        Takes some seconds per pair if proofs are hard. Warns (BakeWarning) of pairs that are not guarded.
        Raises Error, with the program's message, for a URDF, an SRDF or options that can't be used.
        """
        return cls(_native.robot_of_urdf(
            path, _number(stop), _number(warn), srdf, [f"{a},{b}" for a, b in believe],
            [f"{name}={folder}" for name, folder in (packages or {}).items()], visual_too,
            _number(cell), leaf_size, _number(simplify), None if fit is None else str(int(fit)),
            [f"{a},{b}={_number(s)},{_number(w)}" for (a, b), (s, w) in (pairs or {}).items()],
            [f"{joint}={_number(radius)}" for joint, radius in (zones or {}).items()], _number(time)))

    @classmethod
    def load(cls, source: Path) -> Robot:
        """Opens an image file (.robot), or an image as bytes, and validates it.

        Raises Error if it is not an image of a robot, damaged, or of another version.
        """
        return cls(_native.Robot.load(source))

    @property
    def joint_names(self) -> list[str]:
        """The n joints that values move, in the values' order; without mimics, which follow other joints."""
        return self._native.joint_names

    @property
    def limits(self) -> npt.NDArray[np.float64]:
        """(n, 2): lower and upper, both allowed; infinite for a joint without limits."""
        return self._native.limits

    @property
    def link_names(self) -> list[str]:
        """The links with a mesh."""
        return self._native.link_names

    @property
    def matrix(self) -> Optional[list[MatrixRow]]:
        """All pairs of links with their verdicts; None for a loaded robot, because the image has only the result."""
        rows = self._native.matrix
        return None if rows is None else [MatrixRow(*row) for row in rows]

    @property
    def pairs(self) -> list[GuardedPair]:
        """The guarded pairs, in the order of the numbers that guards report."""
        return [GuardedPair(*pair) for pair in self._native.pairs]

    @property
    def unguarded(self) -> list[UnguardedPair]:
        """Pairs that no guard tests, or only outside a joint zone: collisions there are not detected."""
        return [UnguardedPair(*pair) for pair in self._native.unguarded]

    def __reduce__(self) -> tuple[object, tuple[bytes]]:
        return (Robot.load, (self.image,))

    def __repr__(self) -> str:
        return f"<flashbvh.Robot {self.name!r}, {len(self.joint_names)} joints, {len(self.pairs)} pairs guarded>"


class GuardAnswer(NamedTuple):
    """A guard's answer for a period."""

    verdict: Verdict
    pair: Optional[int]
    """Index into `Robot.pairs`: the pair of the least clearance with this verdict; None if every pair is free."""
    links: Optional[tuple[str, str]]
    distance: float
    """The pair's links stayed at least so far apart, in metres, whatever the verdict."""
    work: int
    """The work that was spent."""
    status: str
    """ok, or why the values were refused."""


class Checked(NamedTuple):
    """A guard's answers for a trajectory, one row per period."""

    verdicts: npt.NDArray[np.uint8]
    """(T,): numbers of Verdict."""
    pairs: npt.NDArray[np.int32]
    """(T,): as GuardAnswer.pair; -1 if every pair is free."""
    distances: npt.NDArray[np.float64]
    """(T,): as GuardAnswer.distance, in metres."""
    work: npt.NDArray[np.uint32]
    """(T,): the work that was spent."""


class Guard:
    """Keeps a robot from hitting itself: firmware's guard with its state. Threads may share it."""

    def __init__(self, robot: Robot) -> None:
        if not isinstance(robot, Robot):
            raise TypeError("robot: give a Robot")
        self.robot = robot
        self._native = _native.Guard(robot._native)

    def update(self, values: npt.ArrayLike, work: int = ALL_WORK) -> GuardAnswer:
        """Checks a period: from the last values to these, (n,), in radians and metres, in `joint_names` order.

        work: the budget; the first period needs ALL_WORK. Raises ValueError for another shape or a number that is not
        finite. Values out of limits raise no exception: the verdict is REFUSED.
        """
        return _answer(self._native.update(values, work))

    def go_on(self, work: int = ALL_WORK) -> GuardAnswer:
        """Continues the last period with more work."""
        return _answer(self._native.go_on(work))

    def forget(self) -> None:
        """Forgets the robot's position and all known distances."""
        self._native.forget()

    def check(self, trajectory: npt.ArrayLike, work: int = ALL_WORK) -> Checked:
        """Checks a trajectory, (T, n), one period per row, like `flashbvh guard`: starts without knowledge.

        work: the budget of each period except the first, which has no limit. Afterwards the guard is at the end.
        """
        return Checked(*columns(self._native.check(trajectory, work)))


class MotionAnswer(NamedTuple):
    """The answer for a motion."""

    outcome: str
    """free; hit: a pair intersects at `part`; close: it may, about there; refused."""
    part: float
    """Part of the motion, 0 to 1."""
    values: Optional[npt.NDArray[np.float64]]
    """(n,): the joints' values at `part`."""
    pair: Optional[int]
    """Index into `Robot.pairs`."""
    links: Optional[tuple[str, str]]
    triangles: Optional[tuple[int, int]]
    """Ids of the triangles that intersect; only of a hit."""
    status: str
    """ok, or why the values were refused."""

    @property
    def is_free(self) -> bool:
        """True if no guarded pair intersects at any moment."""
        return self.outcome == "free"


class Motion:
    """Certifies straight motions of a robot in joint space."""

    def __init__(self, robot: Robot) -> None:
        if not isinstance(robot, Robot):
            raise TypeError("robot: give a Robot")
        self.robot = robot

    def certify(self, start: npt.ArrayLike, end: npt.ArrayLike) -> MotionAnswer:
        """Decides if the robot is free at every moment from `start` to `end`, (n,) each, all joints in proportion."""
        return MotionAnswer(*_native.certify(self.robot._native, start, end))


def _answer(native: tuple[int, Optional[int], Optional[tuple[str, str]], float, int, str]) -> GuardAnswer:
    return GuardAnswer(Verdict(native[0]), *native[1:])


def _number(value: Union[float, int, None]) -> Optional[str]:
    """The text of a number for the program's options."""
    return None if value is None else repr(float(value))
