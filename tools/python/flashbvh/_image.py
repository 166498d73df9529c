"""The common part of baked meshes and robots: an image."""
from __future__ import annotations

import os
from typing import Generic, TypeVar, Union

from . import _native

Path = Union[str, bytes, "os.PathLike[str]"]
Native = TypeVar("Native", _native.Baked, _native.Robot)


class Image(Generic[Native]):
    """A binary image, which firmware uses in place."""

    def __init__(self, native: Native) -> None:
        self._native: Native = native

    def save(self, path: Path) -> None:
        """Writes the image (.fbvh, .robot), completely or not at all. Raises Error on failure."""
        self._native.save(path)

    @property
    def image(self) -> bytes:
        """The bytes of the image file."""
        return self._native.image

    @property
    def name(self) -> str:
        """Name of the mesh, without folder and extension, or of the robot."""
        return self._native.name

    @property
    def cell(self) -> float:
        """Size of a lattice cell: of a mesh in its unit, of a robot in metres."""
        return self._native.cell
