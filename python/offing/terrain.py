"""Terrain: height maps, and what is seen of them and from them."""

import math
import os
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from offing import _core
from offing.arrays import rows
from offing.device import Device

EARTH_RADIUS_M = 6371008.8  # mean
HIT_KINDS = ("none", "surface", "side", "inside")


class Ground(NamedTuple):
    """The ground at points."""

    height_m: np.ndarray  # [n], NaN beyond the map
    normal: np.ndarray  # [n, 3], unit, NaN beyond the map
    is_measured: np.ndarray  # [n], False beyond the map and where the height is made of filled voids


class Hits(NamedTuple):
    """What rays hit first."""

    distance_m: np.ndarray  # [n], along the ray; infinity where it hits nothing
    point_m: np.ndarray  # [n, 3], NaN where it hits nothing
    normal: np.ndarray  # [n, 3], unit, NaN where it hits nothing
    kind: np.ndarray  # [n], index into offing.HIT_KINDS: the side is the map's edge, inside starts in the ground


class SightLines(NamedTuple):
    """Lines of sight."""

    is_visible: np.ndarray  # [n]
    distance_m: np.ndarray  # [n], from end to end
    hidden_at_m: np.ndarray  # [n], from the first end to what hides the other; NaN where visible
    hidden_by_m: np.ndarray  # [n, 3], the place of the ground there; NaN where visible


class Terrain:
    """A height map on a device: the surface of bilinear patches between its posts. The north-west post is at x = z = 0; x
    is east of it, z south, in m. Use it in one thread at a time: two at once raise Busy.

    Answers about rays have an accuracy of 1e-3 cells across the surface; heights at points are in double precision.
    `earth_radius_m`, such as offing.EARTH_RADIUS_M, makes the ground fall away by (1 - refraction) d^2 / (2 radius) at a
    distance d; 0 is flat ground.
    """

    def __init__(self, source: str | os.PathLike | npt.ArrayLike, *, device: Device | str | int | None = None,
                 spacing_m: float | tuple[float, float] | None = None, vertical_scale: float = 1.0, offset_m: float = 0.0,
                 nodata: float | None = None, void_height_m: float | None = None, reproject_to: str | None = None,
                 untrusted: bool = False, band: int = 1):
        """`source` is a height map's file (GeoTIFF, SRTM, ASCII grid ...) or an array [rows, columns] of heights in m,
        row 0 at the north edge. spacing_m, one number or (x, z), is needed for arrays and overrides that of a file. The
        other values are for files: metres a unit and what to add, a value that marks voids, the height of voids (None:
        filled from their surroundings), a system to resample to ("utm", "EPSG:32719")."""
        self.device = device if isinstance(device, Device) else Device(device)
        spacing_x_m, spacing_z_m = np.broadcast_to(0.0 if spacing_m is None else spacing_m, 2).tolist()
        if isinstance(source, (str, os.PathLike)):
            self._terrain = _core.Terrain.open(
                self.device._device, os.fspath(source), spacing_x_m, spacing_z_m, vertical_scale, offset_m, nodata,
                void_height_m, reproject_to, untrusted, band)
        else:
            heights_m = np.ascontiguousarray(source, dtype=np.float32)
            if heights_m.ndim != 2 or spacing_m is None:
                raise ValueError("source: expected an array [rows, columns] and its spacing_m")
            self._terrain = _core.Terrain.make(self.device._device, heights_m, spacing_x_m, spacing_z_m)

    @property
    def info(self) -> dict:
        """What the map is: a dict of columns, rows, spacing_x_m, spacing_z_m, lowest_m, highest_m, void_posts, where
        post (column, row) is in the map's own coordinates (origin_x + column step_x, origin_y + row step_y),
        centre_latitude_deg, centre_longitude_deg, coordinate_system, coordinate_system_wkt, format and
        is_spacing_assumed. NaN and "" stand for not known."""
        return self._terrain.info()

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)"""
        info = self.info
        return info["rows"], info["columns"]

    @property
    def heights_m(self) -> np.ndarray:
        """Heights of all posts, float32 [rows, columns], with voids filled."""
        return self._terrain.read()[0]

    @property
    def is_void(self) -> np.ndarray:
        """bool [rows, columns]: the file had no height there."""
        return self._terrain.read()[1]

    def sample(self, points_m: npt.ArrayLike, *, smooth_normals: bool = False) -> Ground:
        """The Ground at points [n, 2] of x and z. Smooth normals are of the posts around, without creases."""
        return Ground(*self._terrain.sample(rows("points_m", points_m, 2), smooth_normals))

    def cast(self, origins_m: npt.ArrayLike, directions: npt.ArrayLike, *, limit_m: float = math.inf,
             smooth_normals: bool = False, earth_radius_m: float = 0.0, refraction: float = 0.0) -> Hits:
        """The Hits of rays from origins [n, 3] along unit directions [n, 3]."""
        return Hits(*self._terrain.cast(rows("origins_m", origins_m, 3), rows("directions", directions, 3), limit_m,
                                        smooth_normals, earth_radius_m, refraction))

    def sight_lines(self, from_m: npt.ArrayLike, to_m: npt.ArrayLike, *, earth_radius_m: float = 0.0,
                    refraction: float = 0.13) -> SightLines:
        """The SightLines between places [n, 3], each x, z and the height above ground in m. One row in `from_m` stands
        for all of `to_m`."""
        to_m = rows("to_m", to_m, 3)
        from_m = np.ascontiguousarray(np.broadcast_to(rows("from_m", from_m, 3), to_m.shape))
        return SightLines(*self._terrain.trace_sight_lines(from_m, to_m, earth_radius_m, refraction))

    def viewshed(self, x_m: float, z_m: float, *, observer_height_m: float = 1.7, target_height_m: float = 0.0,
                 radius_m: float = 0.0, earth_radius_m: float = 0.0, refraction: float = 0.13) -> np.ndarray:
        """Which posts are seen from a place: bool [rows, columns]. Heights are above ground; beyond radius_m, if it is
        not 0, nothing is seen."""
        return self._terrain.viewshed(x_m, z_m, observer_height_m, target_height_m, radius_m, earth_radius_m, refraction)

    def __repr__(self):
        count_of_rows, columns = self.shape
        return f"<offing.Terrain {columns} x {count_of_rows} posts on {self.device!r}>"
