"""Terrain: height maps, rays, lines of sight, viewsheds, lakes, sky and sun."""

from __future__ import annotations

import datetime
import math
import os
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from offing import _core
from offing.arrays import rows
from offing.device import Device
from offing.errors import BadInput

EARTH_RADIUS_M = 6371008.8  # mean
HIT_KINDS = ("none", "surface", "side", "inside")


class Ground(NamedTuple):
    """The terrain at points."""

    height_m: np.ndarray  # [n], NaN beyond the map
    normal: np.ndarray  # [n, 3], unit, NaN beyond the map
    is_measured: np.ndarray  # [n], False beyond the map, and where filled voids share in the height


class Hits(NamedTuple):
    """The first hits of rays."""

    distance_m: np.ndarray  # [n], along the ray; infinity: nothing hit
    point_m: np.ndarray  # [n, 3]; NaN: nothing hit
    normal: np.ndarray  # [n, 3], unit; NaN: nothing hit
    kind: np.ndarray  # [n], index into offing.HIT_KINDS. side: the map's edge; inside: the ray starts below ground


class SunHours(NamedTuple):
    """The sun over a terrain in some time."""

    hours: np.ndarray  # [rows, columns]
    energy_kwh: np.ndarray  # [rows, columns], direct sunlight for each square metre of ground as it slopes


class SightLines(NamedTuple):
    """Lines of sight."""

    is_visible: np.ndarray  # [n]
    distance_m: np.ndarray  # [n], from end to end
    hidden_at_m: np.ndarray  # [n], from the first end to the ground that hides the other; NaN: visible
    hidden_by_m: np.ndarray  # [n, 3], the place of that ground; NaN: visible


class SightCounts(NamedTuple):
    """What several observers see."""

    counts: np.ndarray  # uint16 [rows, columns], observers that see the post
    is_reached: np.ndarray  # bool [rows, columns], within the radius and angles of any observer
    seen_posts: np.ndarray  # [n], posts that each observer sees
    reached_posts: np.ndarray  # [n], posts within its radius and angles
    only_posts: np.ndarray  # [n], posts that no other observer sees
    best: np.ndarray  # [k], indices of the observers that together see the most; each adds the most to those before it
    best_posts: np.ndarray  # [k], posts that the first see, the first two, and so on
    is_best_exhaustive: bool  # all choices were compared; False: the next best one was added each time


class Lake(NamedTuple):
    """Water in a basin of a terrain."""

    level_m: float  # height of the water
    spill_level_m: float  # above this level water runs off the map
    spill_m: tuple[float, float]  # x and z of the place where it does
    area_m2: float  # of the surface
    volume_m3: float
    greatest_depth_m: float
    depth_m: np.ndarray  # [rows, columns], 0 outside the lake
    shore_m: list[np.ndarray]  # closed rings [k, 2] of x and z: the outer one first, then islands


class Points(NamedTuple):
    """Points of a GIS file."""

    places: np.ndarray  # [n, 2], east before north
    z: np.ndarray  # [n], NaN where a point has none
    coordinate_system: str  # of the places, as Terrain.to_local() takes it; "" where the file names none
    attributes: dict[str, np.ndarray]  # [n] each, NaN for texts and where a point has none


def read_points(file: str | os.PathLike, layer: str = "") -> Points:
    """The Points of a GeoPackage (.gpkg) or GeoJSON (.geojson, .json); `layer` chooses one of several."""
    return Points(*_core.read_points(file, layer))


class Terrain:
    """A height map on a device: the surface of bilinear patches between its posts. The north-west post is at x = z = 0.
    Use a terrain in one thread at a time; a second one gets Busy.

    Hits of rays are within 1e-3 cells of the surface. Heights at points are in double precision. `earth_radius_m`, such
    as offing.EARTH_RADIUS_M, lowers the ground at a distance d by (1 - refraction) d^2 / (2 earth_radius_m); 0 is a flat
    Earth.
    """

    def __init__(self, source: str | os.PathLike | npt.ArrayLike, *, device: Device | str | int | None = None,
                 spacing_m: float | tuple[float, float] | None = None, vertical_scale: float = 1.0, offset_m: float = 0.0,
                 nodata: float | None = None, void_height_m: float | None = None, reproject_to: str | None = None,
                 untrusted: bool = False, band: int = 1):
        """`source` is the path of a height map (GeoTIFF, SRTM, ASCII grid ...), or an array [rows, columns] of heights in m
        with row 0 at the north edge. spacing_m is the distance between posts, one number or (x, z). Arrays need it; for
        files it replaces the file's.

        The other values are for files. vertical_scale is in metres per unit of the file, offset_m is added after it.
        nodata is another value that marks voids. void_height_m is the height of voids; None fills them from around.
        reproject_to is a system to resample to, such as "utm" or "EPSG:32719". An untrusted file may only refer to files
        in and below its folder. Bands count from 1."""
        self.device = device if isinstance(device, Device) else Device(device)
        spacing_x_m, spacing_z_m = np.broadcast_to(0.0 if spacing_m is None else spacing_m, 2).tolist()
        if isinstance(source, (str, os.PathLike)):
            self._terrain = _core.Terrain.open(
                self.device._device, source, spacing_x_m, spacing_z_m, vertical_scale, offset_m, nodata,
                void_height_m, reproject_to, untrusted, band)
        else:
            heights_m = np.ascontiguousarray(source, dtype=np.float32)
            if heights_m.ndim != 2 or spacing_m is None:
                raise BadInput(f"source: expected an array [rows, columns] and its spacing_m, got shape {heights_m.shape} "
                               f"and spacing_m {spacing_m}", "pass spacing_m=10 for 10 m between posts")
            self._terrain = _core.Terrain.make(self.device._device, heights_m, spacing_x_m, spacing_z_m)

    @property
    def info(self) -> dict:
        """What is known about the map, as a dict of columns, rows, spacing_x_m, spacing_z_m, lowest_m, highest_m, void_posts,
        origin_x, origin_y, step_x, step_y, centre_latitude_deg, centre_longitude_deg, coordinate_system,
        coordinate_system_wkt, format and is_spacing_assumed. Post (column, row) is at (origin_x + column * step_x,
        origin_y + row * step_y) in the map's coordinate system. NaN and "" mean not known."""
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
        """bool [rows, columns], True for posts without a height in the file."""
        return self._terrain.read()[1]

    def sample(self, points_m: npt.ArrayLike, *, smooth_normals: bool = False) -> Ground:
        """The Ground at points [n, 2] of x and z in m. Smooth normals are interpolated from posts, without creases."""
        return Ground(*self._terrain.sample(rows("points_m", points_m, 2), smooth_normals))

    def cast(self, origins_m: npt.ArrayLike, directions: npt.ArrayLike, *, limit_m: float = math.inf,
             smooth_normals: bool = False, earth_radius_m: float = 0.0, refraction: float = 0.0) -> Hits:
        """The Hits of rays from origins [n, 3] in m along unit directions [n, 3], at most limit_m long."""
        return Hits(*self._terrain.cast(rows("origins_m", origins_m, 3), rows("directions", directions, 3), limit_m,
                                        smooth_normals, earth_radius_m, refraction))

    def sight_lines(self, from_m: npt.ArrayLike, to_m: npt.ArrayLike, *, earth_radius_m: float = 0.0,
                    refraction: float = 0.13) -> SightLines:
        """The SightLines between ends [n, 3], each x, z and the height above ground in m. A single row of `from_m` is used
        for all rows of `to_m`."""
        to_m = rows("to_m", to_m, 3)
        from_m = np.ascontiguousarray(np.broadcast_to(rows("from_m", from_m, 3), to_m.shape))
        return SightLines(*self._terrain.trace_sight_lines(from_m, to_m, earth_radius_m, refraction))

    def viewshed(self, x_m: float, z_m: float, *, observer_height_m: float = 1.7, target_height_m: float = 0.0,
                 radius_m: float = 0.0, earth_radius_m: float = 0.0, refraction: float = 0.13,
                 azimuth_deg: tuple[float, float] = (0.0, 360.0),
                 elevation_deg: tuple[float, float] = (-90.0, 90.0)) -> np.ndarray:
        """The posts that are visible from a place, as bool [rows, columns]. Heights are above ground. Nothing is visible
        beyond radius_m, unless it is 0. azimuth_deg is the sector, clockwise from north from the first to the second, and
        elevation_deg the lowest and highest line of sight."""
        _require_angles("azimuth_deg", azimuth_deg, (0, 360))
        _require_angles("elevation_deg", elevation_deg, (-90, 90))
        azimuth_rad = tuple(math.radians(angle) for angle in azimuth_deg)
        elevation_rad = tuple(math.radians(angle) for angle in elevation_deg)
        return self._terrain.viewshed(x_m, z_m, observer_height_m, target_height_m, radius_m, earth_radius_m, refraction,
                                      azimuth_rad, elevation_rad)

    def count_viewsheds(self, points_m: npt.ArrayLike, *, observer_height_m: npt.ArrayLike = 1.7,
                        target_height_m: npt.ArrayLike = 0.0, radius_m: npt.ArrayLike = 0.0, earth_radius_m: float = 0.0,
                        refraction: float = 0.13, azimuth_deg: npt.ArrayLike = (0.0, 360.0),
                        elevation_deg: npt.ArrayLike = (-90.0, 90.0), best: int = 0, progress=None) -> SightCounts:
        """The SightCounts of observers at points [n, 2] of x and z in m. The other values are those of viewshed(), for all
        observers or for each: [n] numbers, [n, 2] angles. `best` is how many observers to choose. Takes a bit for each post
        and observer, 8 GiB at most. progress(share) is called
        as the work goes on and stops it by returning False."""
        points_m = rows("points_m", points_m, 2)
        count = len(points_m)
        settings = np.empty((count, 7))
        for i, (name, values) in enumerate((("observer_height_m", observer_height_m), ("target_height_m", target_height_m),
                                            ("radius_m", radius_m))):
            settings[:, i] = _of_each(name, values, (count,))
        for i, name, angles, every in ((3, "azimuth_deg", azimuth_deg, (0, 360)),
                                       (5, "elevation_deg", elevation_deg, (-90, 90))):
            settings[:, i:i + 2] = np.radians(_of_each(name, angles, (count, 2)))
            for pair in settings[:, i:i + 2]:
                _require_angles(name, pair, every)
        return SightCounts(*self._terrain.count_viewsheds(points_m, settings, earth_radius_m, refraction, best, progress))

    def fill_lake(self, x_m: float, z_m: float, *, level_m: float | None = None) -> Lake:
        """The Lake around a place, filled up to level_m; without it, up to the spill level. Raises an error for a place on a
        slope that drains off the map, and for a level above the spill level."""
        *values, outline_m = self._terrain.fill_lake(x_m, z_m, level_m)
        is_break = np.isnan(outline_m[:, 0])
        rings = np.split(outline_m, np.flatnonzero(is_break))
        return Lake(*values, rings[:1] + [ring[1:] for ring in rings[1:]])

    def sky_view(self, *, azimuths: int = 64, earth_radius_m: float = 0.0, refraction: float = 0.13) -> np.ndarray:
        """The sky-view factor of each post, [rows, columns]. It is the light of an evenly bright sky on the ground as it
        slopes, as a share of that on level ground in the open."""
        return self._terrain.sky_view(azimuths, earth_radius_m, refraction)

    def horizons(self, *, azimuths: int = 64, earth_radius_m: float = 0.0, refraction: float = 0.13) -> np.ndarray:
        """The horizon of each post, [azimuths, rows, columns], clockwise from north: tangents of the angles up from level,
        never below 0."""
        return self._terrain.horizons(azimuths, earth_radius_m, refraction)

    def sun_hours(self, start: datetime.datetime, end: datetime.datetime, *, step_s: int = 3600, turbidity: float = 3.0,
                  latitude_deg: float | None = None, longitude_deg: float | None = None, azimuths: int = 64,
                  earth_radius_m: float = 0.0, refraction: float = 0.13) -> SunHours:
        """The SunHours from start to end, looking at the sun every step_s. Times without a zone are UTC. turbidity is that of
        Linke. A terrain that is no file with a place in the world needs a latitude and a longitude."""
        if (latitude_deg is None) != (longitude_deg is None):
            raise BadInput("place: expected a latitude and a longitude, got one of them", "pass both")
        place = None if latitude_deg is None else (math.radians(latitude_deg), math.radians(longitude_deg))
        times = [time.replace(tzinfo=time.tzinfo or datetime.timezone.utc).timestamp() for time in (start, end)]
        return SunHours(*self._terrain.sun_hours(round(times[0]), round(times[1]), step_s, turbidity, place, azimuths,
                                                 earth_radius_m, refraction))

    def to_local(self, places: npt.ArrayLike, crs: str = "lonlat") -> np.ndarray:
        """Places [n, 2] of a coordinate system as x and z in m on the map. crs is "map" (the map's own coordinates), "lonlat"
        (degrees on WGS 84), or a name such as "EPSG:32719". East comes before north, longitude before latitude. NaN where the
        map's system has no such place."""
        return self._terrain.to_local(rows("places", places, 2), crs)

    def from_local(self, places_m: npt.ArrayLike, crs: str = "lonlat") -> np.ndarray:
        """Points [n, 2] of x and z in m on the map as places of a coordinate system, as to_local() takes them."""
        return self._terrain.from_local(rows("places_m", places_m, 2), crs)

    def __repr__(self):
        count_of_rows, columns = self.shape
        return f"<offing.Terrain {columns} x {count_of_rows} posts on {self.device!r}>"


def _require_angles(name, angles, every):
    # The C interface takes two zeros for no limit.
    if len(angles) == 2 and not any(angles):
        raise BadInput(f"{name}: expected two angles, got two zeros", f"pass {name}={every} for no limit")


def _of_each(name, values, shape):
    """Values for all observers, or for each, as an array of this shape."""
    try:
        return np.broadcast_to(np.asarray(values, dtype=np.float64), shape)
    except ValueError as error:
        raise BadInput(f"{name}: expected values for all observers or an array {list(shape)}, got one of shape "
                       f"{np.shape(values)}", "give one value for each point") from error
