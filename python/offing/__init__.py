"""Offing: calibrated seas, terrain and clouds on any OpenCL device.

Axes are x east, y up, z south; units are metres, seconds, radians. Calls release Python's lock. Errors are exceptions of
offing.errors, most with a hint. In shapes, n is the number of points or elements.
"""

import atexit

from offing import _core
from offing.clouds import Clouds
from offing.device import Device, list_devices
from offing.errors import BadInput, Busy, Cancelled, Error, NoDevice
from offing.mesh import Curvature, Mesh
from offing.scene import Scene
from offing.spectrum import Spectrum
from offing.terrain import (EARTH_RADIUS_M, HIT_KINDS, Ground, Hits, Lake, Points, SightCounts, SightLines, SunHours,
                            Terrain, read_points)
from offing.world import FIELDS, Ocean, Water, World

__version__ = _core.version()
__all__ = [
    "EARTH_RADIUS_M", "FIELDS", "HIT_KINDS", "BadInput", "Busy", "Cancelled", "Clouds", "Curvature", "Device", "Error",
    "Ground", "Hits", "Lake", "Mesh", "NoDevice", "Ocean", "Points", "Scene", "SightCounts", "SightLines", "Spectrum",
    "SunHours", "Terrain", "Water", "World", "list_devices", "read_points", "set_log",
]

LOG_LEVELS = ("error", "warning", "info", "debug")


def set_log(callback):
    """Sends the log of the process to callback(level, line); level is one of offing.LOG_LEVELS. None restores the
    default: warnings and errors go to stderr. The callback must not call Offing. Call set_log() while no other thread
    uses Offing."""
    if callback is None:
        _core.set_log(None)
    else:
        _core.set_log(lambda level, line: callback(LOG_LEVELS[level], line))


atexit.register(_core.forget_log)
