"""Clouds of a scene: their particles, their density and pictures of them."""

import numpy as np
import numpy.typing as npt

from offing import _core
from offing.arrays import rows
from offing.device import Device
from offing.world import World


class Clouds:
    """The clouds of a scene at any time. Use them in one thread at a time."""

    def __init__(self, scene, *, device: Device | str | int | None = None, progress=None):
        """`scene` is a World, whose clouds these are then, or what World() takes: a scene with [[cloud]] sections.
        `progress` is as in World()."""
        self.world = scene if isinstance(scene, World) else World(scene, device=device, progress=progress)

    def at(self, time_s: float) -> "Clouds":
        """Brings the world to a time in s; returns the clouds."""
        self.world.at(time_s)
        return self

    def __len__(self) -> int:
        """How many there are: those of [[cloud]], then those of layers."""
        return _core.cloud_count(self.world._world)

    def particles(self) -> dict[str, np.ndarray]:
        """All particles, a dict of arrays: place_m [n, 3], radius_m [n], optical_mass_m2 [n] (extinction in 1/m over the
        volume), albedo [n, 3] (linear Rec.709), cloud [n] and id [n]."""
        return _core.cloud_particles(self.world._world)

    def extinction(self, points_m: npt.ArrayLike, *, cell_m: float = 50.0) -> np.ndarray:
        """The extinction in 1/m at points [n, 3]: particles are laid on a grid of cells of cell_m, which keep their
        optical mass, and values between are trilinear."""
        return _core.sample_clouds(self.world._world, rows("points_m", points_m, 3), cell_m)

    def draw(self, width_px: int = 1280, height_px: int = 720) -> tuple[np.ndarray, np.ndarray]:
        """What the scene's camera sees of the clouds alone: light float32 [height, width, 4], linear Rec.709 in kcd/m^2,
        premultiplied, with opacity, and its mean distance float32 [height, width] in m, 0 where there is none. Needs no
        OpenGL."""
        return _core.draw_clouds(self.world._world, width_px, height_px)
