"""Queries of baked meshes."""
from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from . import _native
from ._columns import columns
from ._meshes import Baked


class Distances(NamedTuple):
    """Distances of two meshes; one row per pose, with the poses' leading shape."""

    distance: npt.NDArray[np.float64]
    """(...,): rounded down to 1/256 cell, in the meshes' unit; 0 if they intersect. Meshes 2^20 cells or more apart:
    a bound that is not sharp."""
    upper: npt.NDArray[np.float64]
    """(...,): rounded up. Meshes 2^20 cells or more apart: a bound that is not sharp."""
    point_a: npt.NDArray[np.float64]
    """(..., 3): the nearest point of A, in A's frame; NaN if they are 2^20 cells or more apart."""
    point_b: npt.NDArray[np.float64]
    """(..., 3): the nearest point of B, in A's frame; NaN as before."""
    triangles: npt.NDArray[np.int64]
    """(..., 2): the triangles of A and B that are nearest, by id; -1 as before."""


class Hits(NamedTuple):
    """First hits of rays; one row per ray, with the rays' leading shape."""

    hit: npt.NDArray[np.bool_]
    """(...,): whether the ray hits the mesh."""
    distance: npt.NDArray[np.float64]
    """(...,): from the origin, in the mesh's unit; infinite if there is no hit."""
    triangle: npt.NDArray[np.int64]
    """(...,): by id; -1 if there is no hit."""


def intersects(a: Baked, b: Baked, poses: npt.ArrayLike) -> npt.NDArray[np.bool_]:
    """Whether any triangles of A and B intersect; touching counts. Surfaces, not solids.

    poses: (4, 4) or (N, 4, 4), B in A's frame, in the meshes' unit. Returns bool, () or (N,).
    Raises Error if the meshes have different cells or a matrix is not a rotation with a translation.
    """
    return _native.intersects(a._native, b._native, poses)


def solids_intersect(a: Baked, b: Baked, poses: npt.ArrayLike) -> npt.NDArray[np.bool_]:
    """Whether A and B have a point in common, insides included; both meshes must be closed.

    poses, result and errors: as in `intersects`. Also raises Error if a mesh is not closed.
    """
    return _native.solids_intersect(a._native, b._native, poses)


def closer_than(a: Baked, b: Baked, poses: npt.ArrayLike, length: float) -> npt.NDArray[np.bool_]:
    """Whether any points of A and B are at most `length` apart, in the meshes' unit.

    Faster than `distance`. poses, result and errors: as in `intersects`.
    """
    return _native.closer_than(a._native, b._native, poses, length)


def distance(a: Baked, b: Baked, poses: npt.ArrayLike, *, is_motion: bool = False) -> Distances:
    """The distance of A and B, and their nearest points.

    poses and errors: as in `intersects`. is_motion: each pose starts with the last nearest pair as a hint, which is
    faster if poses are close together, and slower if not. Distances do not change; of several nearest pairs, another
    may be reported.
    """
    return Distances(*columns(_native.distance(a._native, b._native, poses, is_motion)))


def first_pair(a: Baked, b: Baked, poses: npt.ArrayLike) -> npt.NDArray[np.int64]:
    """The first pair of intersecting triangles that the query finds: (..., 2), ids of A's and B's; -1 if there is none.

    poses and errors: as in `intersects`.
    """
    return _native.first_pair(a._native, b._native, poses)


def pairs(a: Baked, b: Baked, pose: npt.ArrayLike) -> npt.NDArray[np.int64]:
    """All pairs of intersecting triangles: (k, 2), ids of A's and B's, in the query's order.

    pose: (4, 4). Errors: as in `intersects`.
    """
    return _native.pairs(a._native, b._native, pose)


def nearest_hit(mesh: Baked, origins: npt.ArrayLike, directions: npt.ArrayLike,
                length: npt.ArrayLike) -> Hits:
    """Finds the first hit of each ray.

    origins, directions: (3,) or (N, 3), in the mesh's frame; directions of any length but 0. length: the reach of
    the rays, in the mesh's unit, a number or (N,).
    Raises Error if a direction is 0 or a ray ends 524,287 cells or more from the mesh.
    """
    return Hits(*columns(_native.nearest_hit(mesh._native, origins, directions, length)))


def inside(mesh: Baked, points: npt.ArrayLike) -> npt.NDArray[np.bool_]:
    """Whether points are inside a closed mesh or on its surface.

    points: (3,) or (N, 3), in the mesh's frame and unit, rounded to the nearest cells. Returns bool, () or
    (N,). Raises Error if the mesh is not closed.
    """
    return _native.inside(mesh._native, points)
