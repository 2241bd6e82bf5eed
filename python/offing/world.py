"""Worlds: what a scene describes, at any time, on a device."""

from typing import NamedTuple

import numpy as np

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


class Water(NamedTuple):
    """The water at points. All arrays are float32."""

    height_m: np.ndarray  # [n], of the surface
    normal: np.ndarray  # [n, 3], of the surface, unit, upward
    velocity_mps: np.ndarray | None  # [n, 3], x east, y up, z south, at the depth that was asked for
    pressure_pa: np.ndarray | None  # [n], there, above that of the air
    residual_m: np.ndarray  # [n], by how much a point was missed sideways; large where the surface folds


class World:
    """The world of a scene on a device. Use it in one thread at a time: two at once raise Busy."""

    def __init__(self, scene=None, *, device=None, progress=None):
        """`scene` is a Scene or whatever Scene() takes, `device` a Device or what Device() takes. The world is at the
        scene's start. While it is made, which takes long with clouds, progress(share) gets the share that is done, 0 to
        1. If it returns False, the call raises Cancelled; what it raises comes out of the call."""
        self.scene = scene if isinstance(scene, Scene) else Scene(scene)
        self.device = device if isinstance(device, Device) else Device(device)
        self._world = _core.World(self.device._device, self.scene._scene, progress)
        self._renderer = None
        self._time_s = float(self.scene.values.get("time", {}).get("start_s", 0.0))

    def at(self, time_s):
        """Brings the world to a time in s, in any order of times; returns the world."""
        self._world.frame(float(time_s))
        self._time_s = float(time_s)
        return self

    def sample(self, points_m, *, depth_m=0.0, min_wavelength_m=0.0, flow=True):
        """The Water at points [n, 2] of x (east) and z (south) in m: all cascades and Gerstner waves. Velocity and
        pressure are those `depth_m` below the moving surface; without `flow` they are None, which is faster. Waves
        shorter than min_wavelength_m do not count, as for a large hull."""
        return Water(*self._world.sample(rows("points_m", points_m, 2), depth_m, min_wavelength_m, flow))

    @property
    def size(self):
        """n: fields are arrays [n, n]."""
        return self._world.map_size

    @property
    def patch_lengths_m(self):
        """The side of each cascade's patch, the longest first."""
        return [self._world.patch_length_m(cascade) for cascade in range(self._world.cascade_count)]

    def fields(self, names, cascade=0):
        """Fields of one cascade, a dict of float32 arrays [n, n]: row = z, column = x, the first at (0, 0). `names` are
        those of offing.FIELDS: displacements in m, slopes and gradients at rest labels, the Jacobian (below 0 the
        surface folds), foam 0 to 1, velocities at the surface in m/s. Several at once are cheaper than one by one. Waves
        that the scene gives to Gerstner waves are not in the fields."""
        names = list(names)
        return dict(zip(names, self._world.read_fields([_number_of(name) for name in names], cascade)))

    def field(self, name, cascade=0):
        """One of fields()."""
        return self.fields([name], cascade)[name]

    def copy_field(self, name, target, *, first=0, cascade=0):
        """Enqueues the copy of a field of the surface to an array or buffer of PyOpenCL, of the context that the device
        was adopted from; [n, n] floats from index `first` on. No transfer, no wait: work in the same queue sees it."""
        buffer, offset = _buffer_of(target)
        if hasattr(target, "base_data"):
            room = first + self.size**2
            if target.dtype != np.float32 or not target.flags.c_contiguous or target.size < room:
                raise BadInput(f"target: expected a contiguous array of {room} float32 or more, "
                               f"got {target.size} of {target.dtype}",
                               f"make one with pyopencl.array.empty(queue, {room}, numpy.float32)")
        self._world.copy_field(_number_of(name), buffer, first + offset // 4, cascade)

    def sample_on_device(self, points, count, samples, *, depth_m=0.0, min_wavelength_m=0.0):
        """sample() with arrays or buffers of PyOpenCL, without a transfer: offing.h says how they are laid out
        (offing_sample_water_on_device)."""
        self._world.sample_on_device(_whole_buffer_of(points), count, _whole_buffer_of(samples), depth_m, min_wavelength_m)

    def render(self, width_px=1280, height_px=720, *, light=False):
        """A picture of the scene by its own camera at the time of the last at(), without a display, as
        `offing-view --headless` draws it: uint8 [height, width, 3], sRGB, the first row at the top. With `light`
        float32, linear Rec.709 in kcd/m^2. The first picture takes some seconds: pictures have a world of their own.
        Needs OpenGL (Mesa draws on the CPU); raises NoDevice without it."""
        if self._renderer is None:
            self._renderer = _core.Renderer(self.device._device, self.scene._scene)
        render = self._renderer.render_light if light else self._renderer.render
        return render(self._time_s, width_px, height_px)

    @property
    def camera(self):
        """The scene's camera at the time of the last at(): a dict of eye_m, yaw_rad (0 along -z, growing toward +x),
        pitch_rad, roll_rad and vertical_field_of_view_rad."""
        return _core.camera(self._world)

    def body_poses(self):
        """Where floating bodies are, a dict of arrays: name [n], mass_centre_m [n, 3], turn [n, 4] (quaternion w, x, y, z
        from body axes x forward, y up, z to starboard), velocity_mps [n, 3], spin_radps [n, 3] in body axes and
        displaced_m3 [n]."""
        return _core.body_poses(self._world)

    def body_forces(self):
        """What the water does to the bodies in the last sub-step, which ends at time_s: a dict of pressure_n and drag_n,
        pressure_moment_nm and drag_moment_nm about the mass centre, all [n, 3] in world axes, displaced_m3 and wetted_m2
        [n]."""
        return _core.body_forces(self._world)

    def meshes(self):
        """Where the meshes are: a list of dicts of name, position_m and turn, a quaternion w, x, y, z."""
        return [_core.mesh_pose(self._world, mesh) for mesh in range(_core.mesh_count(self._world))]

    def highlights(self, mesh=0, *, first_s=None):
        """The projectors of a mesh's highlights for the scene's eye, a dict of arrays in the mesh's axes: id, rule, copy,
        light, position_m, right, up, normal, width_m, height_m, opacity, texture, softness and colour (offing.h,
        OffingHighlights). `first_s` is the time of the first frame of a sequence, in which they keep their ids."""
        _core.find_highlights(self._world, self._time_s if first_s is None else first_s)
        return _core.highlights(self._world, mesh)

    def sea_state(self):
        """What the spectrum asks for: Scene.sea_state()."""
        return self.scene.sea_state()

    def stats(self, seeds=8, *, progress=None):
        """What the surface of the sea has, averaged over so many seeds, as `offing ocean stats --json` finds it: a dict of
        "asked" (by the spectrum, without swells), "resolved" (expected of the waves that the fields hold and of swells),
        "measured" and "standard_error" (of measured from resolved), each a dict. Directions are in degrees, of travel from
        east toward south. progress(share) is as in World()."""
        return self.scene._scene.measure(self.device._device, seeds, progress)

    def __repr__(self):
        return f"<offing.{type(self).__name__} {self.scene!r} on {self.device!r}>"


class Ocean(World):
    """A sea alone."""

    def __init__(self, sea=None, *, device=None, progress=None, **values):
        """`sea` is a Spectrum, a Scene or whatever Scene() takes. `values` are keys of [ocean], such as size and
        choppiness; `seed` is that of [world]. `progress` is as in World()."""
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
        raise ValueError(f"field: expected one of {', '.join(FIELDS)}; got {name!r}") from None


def _buffer_of(target):
    """The cl_mem of an array or buffer of PyOpenCL as a number, and where the array begins in it, in bytes."""
    if hasattr(target, "base_data"):
        return target.base_data.int_ptr, target.offset
    return target.int_ptr, 0


def _whole_buffer_of(target):
    buffer, offset = _buffer_of(target)
    if offset:
        raise ValueError("expected an array at the start of its buffer, got a part of one")
    return buffer
