"""Arrays of the caller's as the core takes them."""

import numpy as np
import numpy.typing as npt


def rows(name: str, values: npt.ArrayLike, width: int) -> np.ndarray:
    """Values as float64 [n, width]; one row may come as [width]."""
    array = np.atleast_2d(np.ascontiguousarray(values, dtype=np.float64))
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name}: expected an array [n, {width}], got one of shape {array.shape}")
    return array
