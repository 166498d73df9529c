"""The common part of baked meshes and robots: an image."""
from __future__ import annotations

import os
from typing import Protocol, Union

Path = Union[str, bytes, "os.PathLike[str]"]


class _Native(Protocol):
    @property
    def image(self) -> bytes: ...
    @property
    def name(self) -> str: ...
    @property
    def cell(self) -> float: ...
    def save(self, path: object) -> None: ...


class Image:
    """A binary image, which firmware uses in place."""

    def __init__(self, native: _Native) -> None:
        self._image = native

    def save(self, path: Path) -> None:
        """Writes the image (.fbvh, .robot), completely or not at all. Raises Error on failure."""
        self._image.save(path)

    @property
    def image(self) -> bytes:
        """The bytes of the image file."""
        return self._image.image

    @property
    def name(self) -> str:
        """Name of the mesh, without folder and extension, or of the robot."""
        return self._image.name

    @property
    def cell(self) -> float:
        """Size of a lattice cell: of a mesh in its unit, of a robot in metres."""
        return self._image.cell
