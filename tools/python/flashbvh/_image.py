"""What baked meshes and robots have in common: an image."""
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
    """An image, which firmware opens in place."""

    def __init__(self, native: _Native) -> None:
        self._image = native

    def save(self, path: Path) -> None:
        """Writes the image (.fbvh, .robot), whole or not at all. Raises Error if that fails."""
        self._image.save(path)

    @property
    def image(self) -> bytes:
        """The image, the bytes of a file."""
        return self._image.image

    @property
    def name(self) -> str:
        """Name of the mesh, without folder and extension, or of the robot."""
        return self._image.name

    @property
    def cell(self) -> float:
        """Size of a lattice cell: of a mesh in its unit, of a robot in metres."""
        return self._image.cell
