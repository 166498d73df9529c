"""Meshes and baking."""
from __future__ import annotations

from typing import Optional, Sequence, Union, overload

import numpy as np
import numpy.typing as npt

from . import _native
from ._image import Image, Path


class Mesh:
    """A triangle mesh before baking, made by `from_file` or `from_arrays`."""

    def __init__(self, native: _native.Mesh) -> None:
        if not isinstance(native, _native.Mesh):
            raise TypeError("a Mesh is made by Mesh.from_file() or Mesh.from_arrays()")
        self._native = native

    @classmethod
    def from_file(cls, path: Path, *, scale: float = 1.0, cell: Optional[float] = None) -> Mesh:
        """Reads a mesh file: STL, OBJ, PLY, DAE, glTF, GLB or 3MF.

        The last four carry a unit, which `bake` must be given, unless a scale converts them.
        scale: factor of all coordinates. cell: size of a lattice cell for `bake`, in the scaled unit.
        Triangles keep the file's numbers; equal vertices are merged.
        Raises Error if the file is missing, damaged or without triangles.
        """
        return cls(_native.mesh_of_file(path, scale, cell))

    @classmethod
    def from_arrays(cls, vertices: npt.ArrayLike, triangles: npt.ArrayLike, *, name: str = "mesh",
                    cell: Optional[float] = None) -> Mesh:
        """Makes a mesh from arrays.

        vertices: (n, 3) float64. triangles: (m, 3) integers, rows of `vertices`, counter-clockwise seen from
        outside. name: for messages and the image. cell: as in `from_file`.
        Raises ValueError for another shape, a number that is not finite, or an index without a vertex; Error if
        there is no triangle.
        """
        return cls(_native.mesh_of_arrays(vertices, triangles, name, cell))

    @property
    def name(self) -> str:
        """The file, or the given name."""
        return self._native.name

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """(n, 3): the vertices; equal ones are merged."""
        return self._native.vertices

    @property
    def triangles(self) -> npt.NDArray[np.int64]:
        """(m, 3): indices of rows of `vertices`."""
        return self._native.triangles.astype(np.int64)

    @property
    def triangle_count(self) -> int:
        """The number of triangles."""
        return self._native.triangle_count

    @property
    def bounds(self) -> npt.NDArray[np.float64]:
        """(2, 3): the smallest and the largest coordinates."""
        return _bounds(self.vertices)

    @property
    def cell(self) -> Optional[float]:
        """Size of a lattice cell for `bake`, or None."""
        return self._native.cell

    @property
    def finest_cell(self) -> float:
        """The finest possible cell: 32,767 cells along the longest side."""
        return self._native.finest_cell

    def __repr__(self) -> str:
        return f"<flashbvh.Mesh {self.name!r}, {self.triangle_count} triangles>"


class Baked(Image[_native.Baked]):
    """A baked mesh: an image, which firmware uses in place. Made by `bake` or `load`. Can be pickled."""

    def __init__(self, native: _native.Baked) -> None:
        if not isinstance(native, _native.Baked):
            raise TypeError("a Baked is made by flashbvh.bake() or Baked.load()")
        super().__init__(native)

    @classmethod
    def load(cls, source: Path) -> Baked:
        """Opens an image file, or an image as bytes, and validates it.

        Raises Error if it is not an image, damaged, or of another version.
        """
        return cls(_native.Baked.load(source))

    @property
    def unit(self) -> str:
        """The unit of all lengths; empty if none was given."""
        return self._native.unit

    @property
    def deviation(self) -> float:
        """The largest distance of a point from the source mesh, in the unit."""
        return self._native.deviation

    @property
    def is_closed(self) -> bool:
        """True if the surface is closed, so that the mesh has an inside."""
        return self._native.is_closed

    @property
    def triangle_count(self) -> int:
        """The number of triangles."""
        return self._native.triangle_count

    @property
    def bounds(self) -> npt.NDArray[np.float64]:
        """(2, 3): the smallest and the largest coordinates of the rounded mesh, in the unit."""
        return _bounds(self.vertices)

    @property
    def vertices(self) -> npt.NDArray[np.float64]:
        """(n, 3): the rounded vertices, in the unit and the mesh's frame."""
        return self._native.cells * self.cell

    @property
    def triangles(self) -> npt.NDArray[np.int64]:
        """(m, 3): indices of rows of `vertices`, in the order of `triangle_ids`."""
        return self._native.source_triangles["vertices"].astype(np.int64)

    @property
    def triangle_ids(self) -> npt.NDArray[np.int64]:
        """(m,): the triangles' numbers in the source, ascending; queries report these numbers."""
        return self._native.source_triangles["number"].astype(np.int64)

    def __reduce__(self) -> tuple[object, tuple[bytes]]:
        return (Baked.load, (self.image,))

    def __repr__(self) -> str:
        return (f"<flashbvh.Baked {self.name!r}, {self.triangle_count} triangles, "
                f"cell {self.cell:.6g} {self.unit}>").replace(" >", ">")


def _bounds(points: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    return np.stack([points.min(axis=0), points.max(axis=0)])


@overload
def bake(meshes: Mesh, *, cell: Optional[float] = ..., unit: Optional[str] = ..., leaf_size: int = ...,
         arity: int = ..., index_bits: int = ..., max_deviation: Optional[float] = ...,
         simplify: Optional[float] = ...) -> Baked: ...


@overload
def bake(meshes: Sequence[Mesh], *, cell: Optional[float] = ..., unit: Optional[str] = ...,
         leaf_size: int = ..., arity: int = ..., index_bits: int = ...,
         max_deviation: Optional[float] = ..., simplify: Optional[float] = ...) -> list[Baked]: ...


def bake(meshes: Union[Mesh, Sequence[Mesh]], *, cell: Optional[float] = None,
         unit: Optional[str] = "mm", leaf_size: int = 2, arity: int = 4, index_bits: int = 16,
         max_deviation: Optional[float] = None,
         simplify: Optional[float] = None) -> Union[Baked, list[Baked]]:
    """Bakes a mesh, or several meshes for common queries, like `flashbvh bake`.

    cell: size of a lattice cell, which all meshes share; default: the finest that all of them fit.
    unit: name of the unit of all lengths: nm, um, mm, cm, m, mil, in, ft, or None.
    leaf_size: most triangles in a leaf, 1 to 16. arity: most children of a node, 2 to 8.
    index_bits: 16, for meshes of up to 65,535 nodes, or 32; meshes of one query must have the same.
    max_deviation: refuses to move a vertex further. simplify: bakes fewer triangles, within this length of
    the mesh, proven; triangles are numbered again.

    Warns (BakeWarning) of surfaces that are not closed, and of the other problems that `flashbvh bake` reports.
    Raises Error if a mesh is too large for the cell or the indices, ValueError for options out of range.
    """
    several = [meshes] if isinstance(meshes, Mesh) else list(meshes)
    for mesh in several:
        if not isinstance(mesh, Mesh):
            raise TypeError(f"meshes: holds a {type(mesh).__name__}; give Mesh objects")
    baked = [Baked(native) for native in _native.bake(
        [mesh._native for mesh in several], cell, unit, leaf_size, arity, index_bits, max_deviation,
        simplify)]
    return baked[0] if isinstance(meshes, Mesh) else baked
