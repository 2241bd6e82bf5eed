"""Worlds: the simulations of a scene on a device, at any time."""

from __future__ import annotations

import functools
import os
from collections.abc import Callable, Iterable

import numpy as np
import numpy.typing as npt

from offing import _core
from offing.arrays import rows
from offing.device import Device
from offing.errors import BadInput
from offing.scene import Scene
from offing.spectrum import Spectrum

# Names of fields, in the order of OffingField in offing.h.
FIELDS = (
    "displacement_x", "displacement_y", "displacement_z", "slope_x", "slope_z", "jacobian", "foam", "gradient_xx",
    "gradient_xz", "gradient_zz", "jacobian_min_eigenvalue", "velocity_x", "velocity_y", "velocity_z",
)


# How sample() finds the waves of the cascades, in the order of OffingAccuracy in offing.h.
ACCURACIES = ("automatic", "exact", "maps", "frame_maps")


class Water:
    """The water at points, float32. All arrays but `normal` are views of one array, which the device wrote.

    height_m [n]: of the surface, above the mean sea level. velocity_mps [n, 3], pressure_pa [n], relative to the air, and
    acceleration_mps2 [n, 3]: of the water at depth_m; None without flow. residual_m [n]: horizontal distance of the sample
    from its point, large where the surface folds. error_rms_m [n]: expected root mean square error of height_m, without
    what residual_m adds.
    """

    def __init__(self, samples, has_flow):
        self._slopes = samples[:, 1:3]  # dh/dx and dh/dz of the displaced surface
        self.height_m: np.ndarray = samples[:, 0]
        self.velocity_mps: np.ndarray | None = samples[:, 4:7] if has_flow else None
        self.pressure_pa: np.ndarray | None = samples[:, 7] if has_flow else None
        self.acceleration_mps2: np.ndarray | None = samples[:, 8:11] if has_flow else None
        self.residual_m: np.ndarray = samples[:, 3]
        self.error_rms_m: np.ndarray = samples[:, 11]

    @functools.cached_property
    def normal(self) -> np.ndarray:
        """[n, 3]: the upward unit normal of the surface."""
        normal = np.empty((len(self.height_m), 3), np.float32)
        normal[:, 1] = 1.0 / np.sqrt(1.0 + np.square(self._slopes).sum(axis=1))
        normal[:, ::2] = -self._slopes * normal[:, 1:2]
        return normal

    def __len__(self) -> int:
        return len(self.height_m)

    def __repr__(self):
        return f"<offing.Water at {len(self)} points>"


class World:
    """The world of a scene on a device. Use a world in one thread at a time; a second one gets Busy."""

    def __init__(self, scene=None, *, device: Device | str | int | None = None,
                 progress: Callable[[float], object] | None = None):
        """`scene` is a Scene or what Scene() takes. `device` is a Device or what Device() takes. The world begins at the
        scene's start. Clouds take long to make, and those that would take longer than 45 s, or than
        $OFFING_LONGEST_WAIT_S, raise BadInput. Meanwhile progress(share) gets the share that is done, 0 to 1; if it
        returns False, the call raises Cancelled. If it raises, the call raises the same exception."""
        self.scene = scene if isinstance(scene, Scene) else Scene(scene)
        self.device = device if isinstance(device, Device) else Device(device)
        self._world = _core.World(self.device._device, self.scene._scene, progress)
        self._renderer = None

    def at(self, time_s: float) -> "World":
        """Moves the world to a time in s, and returns the world. Times may come in any order."""
        self._world.frame(float(time_s))
        return self

    @property
    def time_s(self) -> float:
        """The time of the last at(), in s; before that, the scene's start."""
        return self._world.time_s

    def sample(self, points_m: npt.ArrayLike, *, depth_m: float = 0.0, min_wavelength_m: float = 0.0,
               flow: bool = True, accuracy: str = "automatic") -> Water:
        """The Water at points [n, 2] of x (east) and z (south) in m: cascades, Gerstner waves, rings of raindrops and wakes
        together, with the effect of shores. Velocity, pressure and acceleration are those at depth_m below the moving
        surface. Without `flow` they are None, which is faster. Waves shorter than min_wavelength_m are left out, as for a
        large hull.

        `accuracy` is "exact", "maps", "frame_maps" or "automatic". "exact" sums all waves for each point. "maps" are splines
        on fine maps, made once for each time. "frame_maps" is linear interpolation of the maps of fields(): the fastest, but
        short waves lose a quarter of their slopes, and the acceleration is 0. "automatic" is "exact" for up to 16 points,
        else "maps"."""
        samples = self._world.sample(rows("points_m", points_m, 2), depth_m, min_wavelength_m, flow, _accuracy_of(accuracy))
        return Water(samples, flow)

    @property
    def size(self) -> int:
        """The side of a field: fields are arrays [size, size]."""
        return self._world.map_size

    @property
    def patch_lengths_m(self) -> list[float]:
        """The sides of the cascades' patches, the longest first."""
        return [self._world.patch_length_m(cascade) for cascade in range(self._world.cascade_count)]

    def fields(self, names: Iterable[str], cascade: int = 0) -> dict[str, np.ndarray]:
        """Fields of one cascade, as a dict of float32 arrays [size, size]: row = z, column = x, the first at (0, 0).
        `names` are from offing.FIELDS: displacements in m, slopes, gradients, the Jacobian (below 0 the surface folds),
        foam 0 to 1, and velocities at the surface in m/s. All are at the places where the water is at rest. Several
        at once are faster than one by one. The scene's Gerstner waves are not in the fields."""
        names = list(names)
        return dict(zip(names, self._world.read_fields([_number_of(name) for name in names], cascade)))

    def field(self, name: str, cascade: int = 0) -> np.ndarray:
        """One field of fields()."""
        return self.fields([name], cascade)[name]

    def copy_field(self, name: str, target, *, first: int = 0, cascade: int = 0) -> None:
        """Enqueues the copy of a field to an array or buffer of PyOpenCL, in the context of the adopted device. It gets
        size * size floats from index `first` on. There is no transfer and no wait: later commands of the same queue see
        the field. Foam and velocity cannot be copied so."""
        buffer, offset = _buffer_of(target)
        if hasattr(target, "base_data"):
            room = first + self.size**2
            if target.dtype != np.float32 or not target.flags.c_contiguous or target.size < room:
                raise BadInput(f"target: expected a contiguous array of {room} float32 or more, "
                               f"got {target.size} of {target.dtype}",
                               f"make one with pyopencl.array.empty(queue, {room}, numpy.float32)")
        self._world.copy_field(_number_of(name), buffer, first + offset // 4, cascade)

    def write_modes(self, file: str | os.PathLike) -> None:
        """Writes all single waves of the sea: NetCDF if the name ends in ".nc", which xarray reads, else CSV. A scene with
        {"ocean": {"modes_file": file}} has the same waves. The file has no wind: add wind_speed_mps for the same foam."""
        self._world.write_modes(str(file))

    def sample_on_device(self, points, count: int, samples, *, depth_m: float = 0.0,
                         min_wavelength_m: float = 0.0, accuracy: str = "automatic", full: bool = False) -> None:
        """sample() with arrays or buffers of PyOpenCL, without a transfer or a wait. See
        offing_sample_water_on_device() in offing.h for their layout. A sample has eight floats, or with `full` twelve:
        acceleration and expected error too."""
        self._world.sample_on_device(_whole_buffer_of(points), count, _whole_buffer_of(samples), depth_m, min_wavelength_m,
                                     _accuracy_of(accuracy), full)

    def render(self, width_px: int = 1280, height_px: int = 720, *, light: bool = False) -> np.ndarray:
        """What the scene's camera sees at the time of the last at(), as `offing-view --headless` draws it: uint8
        [height, width, 3], sRGB, row 0 at the top. With `light` it is float32, linear Rec.709 in kcd/m^2. The first
        picture takes some seconds, because pictures have a world of their own. Needs OpenGL but no display; Mesa draws on
        the CPU. Raises NoDevice without OpenGL."""
        if self._renderer is None:
            self._renderer = _core.Renderer(self.device._device, self.scene._scene)
        render = self._renderer.render_light if light else self._renderer.render
        return render(self.time_s, width_px, height_px)

    @property
    def camera(self) -> dict:
        """The scene's camera at the time of the last at(), as a dict of eye_m, yaw_rad (0 along -z, growing toward +x),
        pitch_rad, roll_rad and vertical_field_of_view_rad."""
        return _core.camera(self._world)

    def body_poses(self) -> dict:
        """Poses of the floating bodies, as a dict of name (a list) and arrays. mass_centre_m, velocity_mps and, in body axes,
        spin_radps are [n, 3], displaced_m3 is [n]. turn [n, 4] is a quaternion w, x, y, z from body axes to world axes.
        Body axes are x forward, y up, z to starboard."""
        return _core.body_poses(self._world)

    def body_forces(self) -> dict:
        """Forces on the bodies in the last sub-step, which ends at time_s, as a dict. pressure_n, drag_n,
        pressure_moment_nm and drag_moment_nm are [n, 3] in world axes, moments about the mass centre. displaced_m3 and
        wetted_m2 are [n]. forces is a dict of arrays [n, 6] by kind: pressure, drag, radiation, excitation, propeller,
        rudder, gravity, wind, mooring. Each row is force x, y, z in N, then moment x, y, z in N m."""
        return _core.body_forces(self._world)

    def meshes(self) -> list[dict]:
        """Poses of the meshes: a list of dicts of name, position_m and turn (quaternion w, x, y, z from mesh to world axes)."""
        return [_core.mesh_pose(self._world, mesh) for mesh in range(_core.mesh_count(self._world))]

    def highlights(self, mesh: int = 0, *, first_s: float | None = None) -> dict[str, np.ndarray]:
        """The projectors of a mesh's highlights for the scene's camera, as a dict of arrays in mesh axes. Its names are id,
        rule, copy, light, position_m, right, up, normal, width_m, height_m, opacity, texture, softness and colour. See
        OffingHighlights in offing.h. `first_s` is the time of the sequence's first frame; highlights keep their ids in a
        sequence. None makes each frame a sequence of its own."""
        _core.find_highlights(self._world, self.time_s if first_s is None else first_s)
        return _core.highlights(self._world, mesh)

    def sea_state(self) -> dict[str, float]:
        """The sea state of the scene's spectrum: Scene.sea_state()."""
        return self.scene.sea_state()

    def stats(self, seeds: int = 8, *, progress: Callable[[float], object] | None = None) -> dict[str, dict]:
        """Statistics of the sea, averaged over `seeds` seeds, with the names of `offing ocean stats --json`. It has five
        dicts. "asked" is the spectrum's, without swells that are one wave. "resolved" is expected of the waves that the
        fields hold and of all swells. "measured" is the surface's. "standard_error" is that of "measured" from "resolved".
        "foam" has "asked" and "measured", the share of the sea that foam covers. The mean direction is of travel, from
        east toward south, in degrees (mean_direction_deg) and, as in sea_state(), in radians (mean_direction_rad).
        progress(share) is as in World()."""
        return self.scene._scene.measure(self.device._device, seeds, progress)

    def __repr__(self):
        return f"<offing.{type(self).__name__} {self.scene!r} on {self.device!r}>"


class Ocean(World):
    """A world made from a spectrum or from keys of [ocean]."""

    def __init__(self, sea=None, *, device=None, progress=None, **values):
        """`sea` is a Spectrum, a Scene or what Scene() takes. `values` are keys of [ocean], such as size and choppiness,
        or `seed` of [world]. `progress` is as in World()."""
        spectrum = sea if isinstance(sea, Spectrum) else None
        scene = Scene() if spectrum is not None or sea is None else Scene(sea)
        changes = {"ocean": {name: value for name, value in values.items() if name != "seed"}}
        if "seed" in values:
            changes["world"] = {"seed": values["seed"]}
        if values:
            scene = scene.with_values(changes)
        if spectrum is not None:
            scene = scene.with_spectrum(spectrum)
        super().__init__(scene, device=device, progress=progress)


def _number_of(name):
    try:
        return FIELDS.index(name)
    except ValueError:
        raise BadInput(f"field: expected a name in offing.FIELDS, got {name!r}", f"choose from {', '.join(FIELDS)}") from None


def _accuracy_of(name):
    try:
        return ACCURACIES.index(name)
    except ValueError:
        raise ValueError(f"accuracy: expected one of {', '.join(ACCURACIES)}; got {name!r}") from None


def _buffer_of(target):
    """The cl_mem of an array or buffer of PyOpenCL, as a number, and the array's offset in it, in bytes."""
    if hasattr(target, "base_data"):
        return target.base_data.int_ptr, target.offset
    return target.int_ptr, 0


def _whole_buffer_of(target):
    buffer, offset = _buffer_of(target)
    if offset:
        raise BadInput("points and samples: expected arrays at the start of their buffers, got one at an offset",
                       "copy the array to one of its own")
    return buffer
