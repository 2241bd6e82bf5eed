"""Arrays of the caller's as the core takes them."""

import numpy as np
import numpy.typing as npt

from offing.errors import BadInput


def rows(name: str, values: npt.ArrayLike, width: int) -> np.ndarray:
    """Values as float64 [n, width]; one row may come as [width]."""
    array = np.atleast_2d(np.ascontiguousarray(values, dtype=np.float64))
    if array.ndim != 2 or array.shape[1] != width:
        raise BadInput(f"{name}: expected an array [n, {width}], got one of shape {array.shape}",
                       f"give {width} numbers for each of the n, such as by numpy.column_stack()")
    return array
