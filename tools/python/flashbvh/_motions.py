"""Motions of a body, and the first contact of two bodies."""
from __future__ import annotations

import enum
from typing import NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _native
from ._columns import columns
from ._meshes import Baked


class ContactOutcome(enum.IntEnum):
    """The outcome of a motion. Only FREE proves that the bodies do not touch."""

    FREE = 0
    CONTACT = 1
    CLOSE = 2


class BodyMotion:
    """A motion of B in A's frame, or a batch of motions, at constant speed.

    start, end: (4, 4) or (N, 4, 4), in the meshes' unit. The origin of B moves along a straight line, and B turns
    about it the shorter way.
    """

    def __init__(self, start: npt.ArrayLike, end: npt.ArrayLike) -> None:
        self.start: npt.ArrayLike = start
        self.end: Optional[npt.ArrayLike] = end
        self.moves: Optional[npt.ArrayLike] = None

    @classmethod
    def of_moves(cls, start: npt.ArrayLike, moves: npt.ArrayLike) -> BodyMotion:
        """A motion composed of simultaneous moves, like the joints of a chain, from the outermost to the innermost.

        start: (4, 4) or (N, 4, 4). moves: (k, 10), up to 64 moves: a point of an axis, its direction, the angle about
        it in radians and the travel, in A's frame at the start of the motion. Directions have any length; if the angle
        is 0, point and direction are ignored.
        """
        motion = cls(start, start)
        motion.end, motion.moves = None, moves
        return motion


class FirstContacts(NamedTuple):
    """First contacts of two bodies; one row per motion, with the poses' leading shape."""

    outcome: npt.NDArray[np.uint8]
    """(...,): a ContactOutcome. CONTACT: they touch at `end`. CLOSE: they come near between `start` and
    `end`, within two cells or little more, and may touch there."""
    start: npt.NDArray[np.float64]
    """(...,): up to here, a share of the motion, they certainly do not touch; 1 if they are free."""
    end: npt.NDArray[np.float64]
    """(...,): as `start`; at most a cell of motion later."""
    triangles: npt.NDArray[np.int64]
    """(..., 2): the triangles of A and B that touch, or are near, by id; -1 if they are free."""
    pose: npt.NDArray[np.float64]
    """(..., 4, 4): where B is at `end`."""

    @property
    def is_free(self) -> npt.NDArray[np.bool_]:
        """True if the bodies never touch: bool, (...,)."""
        return np.asarray(self.outcome == ContactOutcome.FREE)


def first_contact(a: Baked, b: Baked, motion: BodyMotion, within: float = 0.0) -> FirstContacts:
    """Whether A and the moving B are apart at every moment, and if not, their first contact.

    Surfaces, not solids: a body that starts inside the other one does not touch it. within: bodies at most this far
    apart count as touching, in the meshes' unit; one cell also covers poses between, rounded to the lattice.
    Raises Error if the meshes have different cells, a matrix is not a rotation with a translation, or B may get 2^19
    cells or farther from A's origin.
    """
    return FirstContacts(*columns(_native.first_contact(
        a._native, b._native, motion.start, motion.end, motion.moves, within)))
