"""The common part of baked meshes and robots: an image; and arrays of arguments."""
import os
from pathlib import Path

import numpy as np

from ._c import Error


class Image:
    """A binary image, which firmware uses in place. May be shared by threads, and pickled."""

    def __init__(self, image: bytes, place: str = "image") -> None:
        size = int.from_bytes(image[8:12], "little")
        if size < len(image):
            raise Error(f"{place}: has bytes after its image")
        self.image = bytes(image)
        """The bytes of the image file."""
        self._words = np.frombuffer(self.image + bytes(-len(image) % 4), "<u4").copy()
        self._view = self._words.ctypes.data, len(image)

    @classmethod
    def load(cls, source):
        """Opens an image file, or an image as bytes, and validates it.

        Raises Error with the status if it is no image of this kind, damaged, or of another version.
        """
        if isinstance(source, bytes):
            return cls(source)
        path = os.fsdecode(source)
        try:
            image = Path(source).read_bytes()
        except OSError as error:
            raise Error(f"{path}: can't be read: {error.strerror}") from None
        kind = {b"FBVH": "Baked", b"FBVR": "Robot"}.get(image[:4])
        if kind not in (None, cls.__name__):
            raise Error(f"{path}: is an image of another kind; open it by {kind}.load()", "image_not_flashbvh")
        if kind is None:
            raise Error(f"{path}: image_not_flashbvh; bake it: flashbvh {cls._baked_by} {path} -o baked --format image",
                        "image_not_flashbvh")
        return cls(image, path)

    def save(self, path) -> None:
        """Writes the image (.fbvh, .robot), completely or not at all. Raises OSError on failure."""
        part = Path(f"{os.fsdecode(path)}.part")
        part.write_bytes(self.image)
        part.replace(os.fsdecode(path))

    def __reduce__(self):
        return (type(self).load, (self.image,))


def numbers(given, ends_in, name):
    """An array of finite float64, of a shape that ends so. Raises ValueError that names the argument."""
    try:
        array = np.asarray(given)
    except ValueError:
        raise ValueError(f"{name}: is no array") from None
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: has the dtype {array.dtype}; give numbers")
    inner = len(ends_in)
    if array.ndim not in (inner, inner + 1) or array.shape[array.ndim - inner:] != ends_in:
        raise ValueError(f"{name}: has the shape {array.shape}; give {ends_in} or {('N', *ends_in)}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: holds a number that is not finite")
    return np.ascontiguousarray(array, float).reshape(array.shape)


def rounded(values):
    """To the nearest integers, halves away from 0, as C rounds."""
    return np.trunc(values + np.copysign(0.5, values))
