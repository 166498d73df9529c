"""Meshes and baking."""
import os
import struct
import tempfile
from ctypes import byref
from pathlib import Path

import numpy as np

from . import _c, _program
from ._image import Image, numbers


class Mesh:
    """A triangle mesh before baking, made by `from_file` or `from_arrays`."""

    def __init__(self, name: str, obj=None) -> None:
        self.name = name
        """The file, or the given name."""
        self._obj = obj

    @classmethod
    def from_file(cls, path) -> "Mesh":
        """A mesh file of a format that `flashbvh bake` reads. `bake` reads it."""
        return cls(os.fsdecode(path))

    @classmethod
    def from_arrays(cls, vertices, triangles, *, name: str = "mesh") -> "Mesh":
        """A mesh of arrays.

        vertices: (n, 3) float64. triangles: (m, 3) integers, rows of `vertices`, counter-clockwise seen from
        outside. name: of the image and in messages; a file's. Raises ValueError for other arguments.
        """
        points, corners = numbers(vertices, (3,), "vertices").reshape(-1, 3), np.asarray(triangles)
        if corners.dtype.kind not in "iu" or corners.ndim != 2 or corners.shape[1] != 3:
            raise ValueError(f"triangles: {corners.dtype} of the shape {corners.shape}; give integers, (N, 3)")
        if corners.size and not (0 <= corners.min() and corners.max() < len(points)):
            raise ValueError(f"triangles: names a vertex beyond the {len(points)}")
        if name in ("", ".", "..") or "/" in name or "\0" in name:
            raise ValueError(f"name: {name!r} is no name of a file")
        return cls(name, "".join([*(f"v {x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()),
                                  *(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in corners.tolist())]))


class Baked(Image):
    """A baked mesh: an image, which firmware uses in place. Made by `bake` or `load`.

    name; unit, of all lengths, empty if none was given; cell, the step of the lattice; deviation, the largest distance
    of a point of this mesh or of the file's from the other one; is_closed: it has an inside; triangle_count.
    """
    _baked_by = "bake --unit mm"

    def __init__(self, image: bytes, place: str = "image") -> None:
        super().__init__(image, place)
        self._mesh = _c.Mesh()
        _c.check(_c.open_mesh(*self._view, byref(self._mesh)), place)
        size = image[41]
        self.name: str = image[len(image) - (size + 3) // 4 * 4:][:size].decode(errors="replace") or place
        self.unit: str = _c.UNITS[_c.mesh_unit(byref(self._mesh))]
        self.cell: float = struct.unpack_from("<d", image, 56)[0]
        self.deviation: float = struct.unpack_from("<f", image, 64)[0]
        self.is_closed: bool = _c.mesh_is_closed(byref(self._mesh))
        self.triangle_count: int = struct.unpack_from("<I", image, 24)[0]

    @classmethod
    def load(cls, source, *, unit=None) -> "Baked":
        """As Image.load(). unit: raises Error if the image has another one."""
        baked = super().load(source)
        if unit is not None and unit != baked.unit:
            raise _c.Error(f"{baked.name}: is in {baked.unit or 'no unit'}, not in {unit}; bake it with --unit {unit}")
        return baked

    def __repr__(self) -> str:
        return f"<flashbvh.Baked {self.name!r}, {self.triangle_count} triangles, cell {self.cell:.6g} {self.unit}>"


def bake(meshes, *, unit="mm", **options):
    """Bakes a Mesh to a Baked, or several Meshes of different names for common queries to a list, by `flashbvh bake`.

    unit: of all lengths: nm, um, mm, cm, m, mil, in, ft, or None. Files that carry another one are converted.
    options: of the program, such as cell, which all meshes share; leaf_size, arity, max_deviation, simplify.

    Warns (BakeWarning) and raises Error with the program's messages.
    """
    several = [meshes] if isinstance(meshes, Mesh) else list(meshes)
    for mesh in several:
        if not isinstance(mesh, Mesh):
            raise TypeError(f"meshes: holds a {type(mesh).__name__}; give Mesh objects")
    if not several:
        return []
    with tempfile.TemporaryDirectory(prefix="flashbvh_") as folder:
        files = [mesh.name if mesh._obj is None else f"{folder}/{i}/{mesh.name}.obj" for i, mesh in enumerate(several)]
        for file, mesh in zip(files, several):
            if mesh._obj is not None:
                Path(file).parent.mkdir()
                Path(file).write_text(mesh._obj)
        table = _program.run("bake", files, zip(files, (mesh.name for mesh in several)), unit=unit,
                             output=f"{folder}/baked", format="image", **options)
        baked = [Baked(Path(folder, "baked", f"{row['name']}.fbvh").read_bytes()) for row in table["meshes"]]
    return baked[0] if isinstance(meshes, Mesh) else baked
