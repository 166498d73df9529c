"""Results of batches."""
from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt


def columns(rows: npt.NDArray[np.void]) -> list[npt.NDArray[Any]]:
    """An array for each field of a structured array."""
    return [rows[name].copy() for name in rows.dtype.names or ()]
