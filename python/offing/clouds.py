"""Clouds of a scene: their particles, their extinction and pictures of them."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from offing import _core
from offing.arrays import rows
from offing.device import Device
from offing.world import World


class Clouds:
    """The clouds of a scene at any time. Use them in one thread at a time."""

    def __init__(self, scene, *, device: Device | str | int | None = None, progress=None):
        """`scene` is a World with clouds, which is then shared, or a scene as World() takes it. `progress` is as in
        World()."""
        self.world = scene if isinstance(scene, World) else World(scene, device=device, progress=progress)

    def at(self, time_s: float) -> "Clouds":
        """Moves the world to a time in s, and returns the clouds."""
        self.world.at(time_s)
        return self

    def __len__(self) -> int:
        """The number of clouds: those of [[cloud]], then those of layers."""
        return _core.cloud_count(self.world._world)

    def particles(self) -> dict[str, np.ndarray]:
        """All particles, as a dict of arrays:

        - place_m [n, 3] and radius_m [n]
        - optical_mass_m2 [n]: extinction in 1/m, integrated over the volume
        - albedo [n, 3]: linear Rec.709
        - cloud [n]: index of its cloud
        - id [n]: unique in its cloud
        """
        return _core.cloud_particles(self.world._world)

    def extinction(self, points_m: npt.ArrayLike, *, cell_m: float = 50.0) -> np.ndarray:
        """Extinction in 1/m, [n], at points [n, 3]. Particles are rasterised to a grid with cells of cell_m, which keeps
        their optical mass. Values between cell centres are trilinear."""
        return _core.sample_clouds(self.world._world, rows("points_m", points_m, 3), cell_m)

    def draw(self, width_px: int = 1280, height_px: int = 720) -> tuple[np.ndarray, np.ndarray]:
        """The clouds alone, as the scene's camera sees them: a tuple of two float32 arrays. Light [height, width, 4] is
        premultiplied, linear Rec.709 in kcd/m^2, with opacity 0 to 1. Its mean distance [height, width] is in m, 0 where
        there is no light. Row 0 is at the top. Needs no OpenGL."""
        return _core.draw_clouds(self.world._world, width_px, height_px)
