"""Queries of many objects at once, with the method names of trimesh.collision.CollisionManager."""
from __future__ import annotations

from itertools import combinations, product
from typing import Iterable, Iterator, Literal, NamedTuple, Optional, Protocol, Union, overload

import numpy as np
import numpy.typing as npt

from . import _queries
from ._meshes import Baked, Mesh, bake

Names = set[tuple[str, str]]
Matrix = npt.NDArray[np.float64]


class HasFaces(Protocol):
    """A mesh of trimesh, or another object with its arrays."""

    @property
    def vertices(self) -> npt.ArrayLike: ...
    @property
    def faces(self) -> npt.ArrayLike: ...


AnyMesh = Union[Mesh, HasFaces]


class _Object:
    def __init__(self, mesh: Mesh, transform: Optional[npt.ArrayLike]) -> None:
        self.mesh = mesh
        self.transform = _matrix(transform)
        self.inverse = _inverse(self.transform)
        self.baked: Optional[Baked] = None

    def with_cell(self, cell: float) -> Baked:
        if self.baked is None or self.baked.cell != cell:
            self.baked = bake(self.mesh, cell=cell, unit=None, index_bits=32)
        return self.baked


class _Nearest(NamedTuple):
    distance: float
    a: str
    b: str


class CollisionManager:
    """Rigidly moving meshes, tested against each other by surfaces. Transforms: (4, 4), to the world.

    Objects share a cell: `cell`, or the finest that all of them fit. They are baked when a query needs them, and
    again if a new object needs a coarser cell. Lengths are in the meshes' unit.
    """

    def __init__(self, cell: Optional[float] = None) -> None:
        self._given_cell = cell
        self._objects: dict[str, _Object] = {}

    def add_object(self, name: str, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = None) -> None:
        """Adds an object, or replaces the object of this name. mesh: a Mesh, or any object with vertices and faces."""
        self._objects[name] = _Object(_mesh_of(mesh, name), transform)

    def remove_object(self, name: str) -> None:
        """Removes an object. Raises ValueError if no object has the name."""
        self._object(name)
        del self._objects[name]

    def set_transform(self, name: str, transform: npt.ArrayLike) -> None:
        """Moves an object. Raises ValueError if no object has the name."""
        moved = self._object(name)
        moved.transform = _matrix(transform)
        moved.inverse = _inverse(moved.transform)

    @overload
    def in_collision_single(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = ...,
                            return_names: Literal[False] = ...) -> bool: ...
    @overload
    def in_collision_single(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = ..., *,
                            return_names: Literal[True]) -> tuple[bool, set[str]]: ...

    def in_collision_single(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = None,
                            return_names: bool = False) -> Union[bool, tuple[bool, set[str]]]:
        """Whether a mesh intersects any object; with return_names, also which objects."""
        pairs = _collisions(self._pairs_with(mesh, transform), not return_names)
        return (bool(pairs), {b for _, b in pairs}) if return_names else bool(pairs)

    @overload
    def in_collision_internal(self, return_names: Literal[False] = ...) -> bool: ...
    @overload
    def in_collision_internal(self, return_names: Literal[True]) -> tuple[bool, Names]: ...

    def in_collision_internal(self, return_names: bool = False) -> Union[bool, tuple[bool, Names]]:
        """Whether any two objects intersect; with return_names, also which pairs, each in alphabetical order."""
        pairs = {_sorted(a, b) for a, b in _collisions(self._inner_pairs(), not return_names)}
        return (bool(pairs), pairs) if return_names else bool(pairs)

    @overload
    def in_collision_other(self, other_manager: CollisionManager,
                           return_names: Literal[False] = ...) -> bool: ...
    @overload
    def in_collision_other(self, other_manager: CollisionManager,
                           return_names: Literal[True]) -> tuple[bool, Names]: ...

    def in_collision_other(self, other_manager: CollisionManager,
                           return_names: bool = False) -> Union[bool, tuple[bool, Names]]:
        """Whether any object intersects one of another manager; with return_names, also the pairs (own, other)."""
        pairs = _collisions(self._outer_pairs(other_manager), not return_names)
        return (bool(pairs), pairs) if return_names else bool(pairs)

    @overload
    def min_distance_single(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = ...,
                            return_name: Literal[False] = ...) -> float: ...
    @overload
    def min_distance_single(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = ..., *,
                            return_name: Literal[True]) -> tuple[float, str]: ...

    def min_distance_single(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike] = None,
                            return_name: bool = False) -> Union[float, tuple[float, str]]:
        """The distance of a mesh to the nearest object; with return_name, also the object's name."""
        found = _nearest(self._pairs_with(mesh, transform))
        return (found.distance, found.b) if return_name else found.distance

    @overload
    def min_distance_internal(self, return_names: Literal[False] = ...) -> float: ...
    @overload
    def min_distance_internal(self, return_names: Literal[True]) -> tuple[float, tuple[str, str]]: ...

    def min_distance_internal(self, return_names: bool = False) -> Union[float, tuple[float, tuple[str, str]]]:
        """The smallest distance of two objects; 0 if they intersect."""
        found = _nearest(self._inner_pairs())
        return (found.distance, _sorted(found.a, found.b)) if return_names else found.distance

    @overload
    def min_distance_other(self, other_manager: CollisionManager, return_names: Literal[False] = ...) -> float: ...
    @overload
    def min_distance_other(self, other_manager: CollisionManager,
                           return_names: Literal[True]) -> tuple[float, tuple[str, str]]: ...

    def min_distance_other(self, other_manager: CollisionManager,
                           return_names: bool = False) -> Union[float, tuple[float, tuple[str, str]]]:
        """The smallest distance of an object to one of another manager; with return_names, also (own, other)."""
        found = _nearest(self._outer_pairs(other_manager))
        return (found.distance, (found.a, found.b)) if return_names else found.distance

    def _object(self, name: str) -> _Object:
        if name not in self._objects:
            raise ValueError(f"name: there is no object {name!r}")
        return self._objects[name]

    def _cell(self, *others: _Object) -> float:
        if self._given_cell is not None:
            return self._given_cell
        return max((one.mesh.finest_cell for one in (*self._objects.values(), *others)), default=1.0)

    def _inner_pairs(self) -> Iterator[_Pair]:
        return _pairs(combinations(self._objects.items(), 2), self._cell())

    def _outer_pairs(self, other: CollisionManager) -> Iterator[_Pair]:
        return _pairs(product(self._objects.items(), other._objects.items()), max(self._cell(), other._cell()))

    def _pairs_with(self, mesh: AnyMesh, transform: Optional[npt.ArrayLike]) -> Iterator[_Pair]:
        single = _Object(_mesh_of(mesh, "mesh"), transform)
        return _pairs(product([("", single)], self._objects.items()), self._cell(single))


class _Pair(NamedTuple):
    a: str
    b: str
    first: _Object
    second: _Object
    cell: float

    def posed(self) -> tuple[Baked, Baked, Matrix]:
        """Both meshes, and the second one's pose in the first one's frame."""
        return (self.first.with_cell(self.cell), self.second.with_cell(self.cell),
                self.first.inverse @ self.second.transform)


def _pairs(named: Iterable[tuple[tuple[str, _Object], tuple[str, _Object]]], cell: float) -> Iterator[_Pair]:
    for (a, first), (b, second) in named:
        yield _Pair(a, b, first, second, cell)


def _collisions(pairs: Iterator[_Pair], first_only: bool) -> Names:
    found: Names = set()
    for pair in pairs:
        if _queries.intersects(*pair.posed()):
            found.add((pair.a, pair.b))
            if first_only:
                break
    return found


def _nearest(pairs: Iterator[_Pair]) -> _Nearest:
    """The first of the nearest pairs; infinite without pairs."""
    found = _Nearest(float("inf"), "", "")
    for pair in pairs:
        posed = pair.posed()
        if np.isfinite(found.distance) and not _queries.closer_than(*posed, found.distance):
            continue
        distance = float(_queries.distance(*posed).distance)
        if distance < found.distance:
            found = _Nearest(distance, pair.a, pair.b)
    return found


def _sorted(a: str, b: str) -> tuple[str, str]:
    return (a, b) if a <= b else (b, a)


def _mesh_of(mesh: AnyMesh, name: str) -> Mesh:
    if isinstance(mesh, Mesh):
        return mesh
    if not hasattr(mesh, "vertices") or not hasattr(mesh, "faces"):
        raise TypeError(f"mesh: is a {type(mesh).__name__}; give a Mesh, or what has vertices and faces")
    return Mesh.from_arrays(np.asarray(mesh.vertices), np.asarray(mesh.faces), name=name)


def _matrix(transform: Optional[npt.ArrayLike]) -> Matrix:
    """A copy of a matrix, (4, 4)."""
    if transform is None:
        return np.eye(4)
    try:
        matrix = np.array(transform, dtype=np.float64)
    except (TypeError, ValueError):
        raise ValueError("transform: is no array of numbers; give (4, 4)") from None
    if matrix.shape != (4, 4):
        raise ValueError(f"transform: has the shape {matrix.shape}; give (4, 4)")
    if not np.isfinite(matrix).all():
        raise ValueError("transform: holds a number that is not finite")
    if not np.allclose(matrix[:3, :3] @ matrix[:3, :3].T, np.eye(3), rtol=0, atol=1e-4) or \
            np.linalg.det(matrix[:3, :3]) < 0 or not np.allclose(matrix[3], [0, 0, 0, 1], rtol=0, atol=1e-9):
        raise ValueError("transform: is no rigid motion; give a rotation and a translation, the last row 0 0 0 1")
    return matrix


def _inverse(matrix: Matrix) -> Matrix:
    """The inverse of a rigid motion, by its transposed rotation."""
    inverse = np.eye(4)
    inverse[:3, :3] = matrix[:3, :3].T
    inverse[:3, 3] = -matrix[:3, :3].T @ matrix[:3, 3]
    return inverse
