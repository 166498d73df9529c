"""Queries of baked meshes, a call of the C interface for each pose or point."""
import ctypes
import math
from ctypes import byref

import numpy as np

from . import _c
from ._c import Error
from ._image import numbers, rounded
from ._mesh import Baked

_DISTANCES = np.dtype([("distance", "f8"), ("upper", "f8"), ("point_a", "f8", 3), ("point_b", "f8", 3),
                       ("triangles", "i8", 2)])


class _Posed:
    """Two meshes at each pose of a batch."""

    def __init__(self, a, b, poses):
        for mesh in a, b:
            if not isinstance(mesh, Baked):
                raise TypeError(f"{getattr(mesh, 'name', mesh)!r} is no Baked; bake it: flashbvh.bake(mesh)")
        if a.unit != b.unit or a.cell != b.cell:
            raise Error(f"{b.name}: has a cell of {b.cell!r} {b.unit}, but {a.name} one of {a.cell!r} {a.unit}; bake "
                        "both in one call or with the same cell and unit", "cell_mismatch")
        matrices = numbers(poses, (4, 4), "poses")
        self.shape = matrices.shape[:-2]
        matrices = matrices.reshape(-1, 4, 4)
        if not np.allclose(matrices[:, 3], [0, 0, 0, 1], rtol=0, atol=1e-9):
            raise ValueError("poses: a last row is not 0 0 0 1; give homogeneous matrices")
        fractions = rounded(matrices[:, :3, 3] / a.cell * 65536)
        cells = np.floor((fractions + 32768) / 65536)
        for status, wrong in (("not_a_rotation", np.abs(matrices[:, :3, :3]).max((1, 2), initial=0) >= 1.5),
                              ("translation_out_of_range", np.abs(cells).max(1, initial=0) > _c.MAX_TRANSLATION)):
            if wrong.any():
                raise Error(f"poses[{wrong.argmax()}]: {status}", status)
        self._rotations = rounded(matrices[:, :3, :3] * _c.ROTATION_ONE).astype(np.int32)
        self._cells = cells.astype(np.int32)
        self._fractions = (fractions - cells * 65536).astype(np.int16)
        self._meshes = byref(a._mesh), byref(b._mesh)

    def __len__(self):
        return len(self._cells)

    def __iter__(self):
        """Numbers, names for messages, and the arguments of C: both meshes and the pose."""
        pose = _c.Pose()
        for i in range(len(self)):
            place = f"poses[{i}]"
            _c.check(_c.pose_rigid(self._rotations[i].ctypes.data, self._cells[i].ctypes.data,
                                   self._fractions[i].ctypes.data, byref(pose)), place)
            yield i, place, (*self._meshes, byref(pose))


def _decide(call, posed, *more) -> np.ndarray:
    found = np.empty(len(posed), bool)
    yes = ctypes.c_bool()
    for i, place, arguments in posed:
        _c.check(call(*arguments, *more, byref(yes)), place)
        found[i] = yes.value
    return found.reshape(posed.shape)


def intersects(a: Baked, b: Baked, poses) -> np.ndarray:
    """Whether any triangles of A and B intersect; touching counts. Surfaces, not solids.

    poses: (4, 4) or (N, 4, 4), B in A's frame, in the meshes' unit. Returns bool, () or (N,).
    Raises Error if the meshes have different cells or units, or a matrix is not a rotation with a translation.
    """
    return _decide(_c.intersects, _Posed(a, b, poses))


def solids_intersect(a: Baked, b: Baked, poses) -> np.ndarray:
    """Whether A and B have a point in common, insides included; Error `not_closed`. Else as `intersects`."""
    posed = _Posed(a, b, poses)
    return _decide(_c.one_is_inside, posed) | _decide(_c.intersects, posed)


def closer_than(a: Baked, b: Baked, poses, length: float) -> np.ndarray:
    """Whether any points of A and B are at most `length` apart, in the meshes' unit: it is rounded up to 1/256 cell, so
    that none within it is missed. Faster than `distance`. Else as `intersects`."""
    return _decide(_c.closer_than, _Posed(a, b, poses), _fine_length_rounded_up(length, a.cell))


def _fine_length_rounded_up(length, cell):
    """The least number of 1/256 cell that is not below `length`, apart from the 2^-50 of it that doubles of decimals
    may be off, as the program rounds."""
    if not 0 <= length < math.inf:
        raise ValueError("length: is no length; give a number from 0")
    steps = float(length) / cell * _c.FINE_ONE * (1 - 2.0 ** -50)
    return _c.FineLength(math.ceil(steps) if steps < _c.TOO_LONG else _c.TOO_LONG)


def distance(a: Baked, b: Baked, poses, *, is_motion: bool = False) -> np.recarray:
    """The distance of A and B, and their nearest points: an array of the poses' leading shape with these fields.

    distance: rounded down to 1/256 cell, in the meshes' unit; 0 if they intersect. upper: rounded up.
    point_a, point_b: the nearest points, in A's frame. triangles: A's and B's, by id.
    Meshes 2^20 cells or more apart: bounds that are not sharp, points of NaN, triangles -1.

    poses and errors: as in `intersects`. is_motion: each pose starts with the last nearest pair as a hint, which is
    faster if poses are close together. Distances do not change; of several nearest pairs, another may be reported.
    """
    posed = _Posed(a, b, poses)
    found = np.recarray(len(posed), _DISTANCES)
    known, hint = _c.Clearance(), None

    def length(fine):
        return fine * a.cell / _c.FINE_ONE

    for i, place, arguments in posed:
        _c.check(_c.distance(*arguments, hint, byref(known)), place)
        points = [tuple(map(length, point)) for point in (known.point_a, known.point_b)]
        found[i] = (length(known.lower), math.inf if known.upper == _c.TOO_LONG else length(known.upper),
                    *(points if known.in_range else [(math.nan,) * 3] * 2),
                    (known.triangles.a, known.triangles.b) if known.in_range else (-1, -1))
        if is_motion and known.in_range:
            hint = byref(_c.Witness(known.witness.a, known.witness.b))
    return found.reshape(posed.shape)


def pairs(a: Baked, b: Baked, pose) -> np.ndarray:
    """All pairs of intersecting triangles: (k, 2), ids of A's and B's, in the query's order. pose: (4, 4)."""
    posed = _Posed(a, b, pose)
    if posed.shape:
        raise ValueError("pose: is a batch; give one matrix, (4, 4)")
    block, query, found = np.empty((4096, 2), np.uint16), _c.Query(), []
    for _, place, arguments in posed:
        _c.query_start(byref(query), *arguments)
        status = _c.FULL
        while status == _c.FULL:
            step = _c.query_run(byref(query), _c.NO_LIMIT, block.ctypes.data, len(block))
            status = step.status
            found.append(block[:step.count].astype(np.int64))
        _c.check(status, place)
    return np.concatenate(found)


def inside(mesh: Baked, points) -> np.ndarray:
    """Whether points are inside a closed mesh or on its surface.

    points: (3,) or (N, 3), in the mesh's frame and unit, rounded to the nearest cells. Returns bool, () or
    (N,). Raises Error if the mesh is not closed.
    """
    given = numbers(points, (3,), "points")
    cells = rounded(given / mesh.cell).reshape(-1, 3)
    wrong = np.abs(cells).max(1, initial=0) > _c.MAX_TRANSLATION
    if wrong.any():
        raise Error(f"points[{wrong.argmax()}]: translation_out_of_range", "translation_out_of_range")
    found, side = np.empty(len(cells), bool), ctypes.c_int()
    for i, point in enumerate(cells.astype(int).tolist()):
        _c.check(_c.inside(byref(mesh._mesh), byref(_c.Point(tuple(point))), byref(side)), f"points[{i}]")
        found[i] = side.value != _c.OUTSIDE
    return found.reshape(given.shape[:-1])
