"""The simulation of a sea for many seeds, and the study made of it."""

import functools
import math
import pathlib

import numpy as np

from offing import ensemble
from offing.extremes.band import analyse
from offing.extremes.crests import counted
from offing.scene import Scene
from offing.spectrum import Spectrum

GRAVITY_MPS2 = 9.81
PATCH_WAVELENGTHS = 18  # peak wavelengths along a side of the patch: at size 256, each has 14 samples
POINTS_A_SIDE = 8  # these lie more than two peak wavelengths apart


def study_member(world, *, unit_m, duration_s, spare_s, step_s):
    """The counts for the sea of one seed over duration_s. Waves that have begun by then end during spare_s."""
    [patch_m], size = world.patch_lengths_m, world.size
    places_m = np.arange(POINTS_A_SIDE) * (size // POINTS_A_SIDE) * (patch_m / size)  # samples of the map: exact there
    points_m = np.stack(np.meshgrid(places_m, places_m), axis=-1).reshape(-1, 2)
    times_s = np.arange(round((duration_s + spare_s) / step_s)) * step_s
    elevation_m = np.stack([world.at(time_s).sample(points_m, flow=False).height_m for time_s in times_s]).astype(float)
    # Choppiness moves the mean level at a fixed place. Heights count from the mean.
    elevation_m -= elevation_m.mean() if world.scene.values["ocean"]["choppiness"] else 0.0
    return counted(elevation_m, unit_m=unit_m, step_s=step_s, end=round(duration_s / step_s))


def peak_wavelength_m(period_s, depth_m):
    """The wavelength of linear waves of a period: Newton's method for k tanh(k D) = w^2 / g."""
    deep = (2.0 * math.pi / period_s) ** 2 / GRAVITY_MPS2
    if not math.isfinite(depth_m):
        return 2.0 * math.pi / deep
    k = deep / math.sqrt(math.tanh(min(deep * depth_m, 300.0)))
    for _ in range(50):
        t = math.tanh(k * depth_m)
        k -= (k * t - deep) / (t + k * depth_m * (1.0 - t * t))
    return 2.0 * math.pi / k


def study_scene(scene, depth_m, *, size, choppiness):
    """A scene with only the random sea of another, in one patch.

    Swells, raindrops, Gerstner waves, wakes, foam, shoals and a loop are left out. Samples lie at multiples of 1/64 m,
    which float32 represents exactly."""
    values = {"ocean": {}} | {key: scene.values[key] for key in ("world", "wind", "ocean") if key in scene.values}
    patch_m = PATCH_WAVELENGTHS * peak_wavelength_m(scene.sea_state()["tp_s"], depth_m)
    patch_m = max(round(64.0 * patch_m / size), 1) / 64.0 * size
    ocean = {name: None for name in ("gerstner", "swell", "raindrop", "wake", "foam", "cascade_count")}
    ocean |= {"size": size, "choppiness": float(choppiness), "cascade": [{"patch_m": patch_m}], "shoals": None}
    alone = Scene(values, folder=scene.folder).with_values({"ocean": ocean})
    return alone.with_spectrum(scene._spectrum) if scene._spectrum is not None else alone


def run_study(
    scene,
    *,
    seeds,
    duration_s=1200.0,
    step_s=None,
    choppiness=0.0,
    size=256,
    folder=None,
    client=None,
    device=None,
    progress=None,
):
    """Runs the study for a scene's sea; returns a dict of its results, with the table of crest heights.

    The arguments are options of the program; `folder`, `client`, `device` and `progress` go to ensemble.run()."""
    scene = Scene(scene)
    asked = scene.sea_state()
    scene = study_scene(scene, _depth_m(scene), size=size, choppiness=choppiness)
    unit_m = asked["hs_m"] / 4.0
    if step_s is None:  # in whole 1/64 s: a seventh of the shortest period on the grid's axes
        step_s = max(round(64.0 * asked["tp_s"] / (7.0 * math.sqrt(size / (2.0 * PATCH_WAVELENGTHS)))), 1) / 64.0
    member = functools.partial(
        study_member, unit_m=unit_m, duration_s=duration_s, spare_s=4.0 * asked["tp_s"], step_s=step_s
    )
    members = ensemble.run(member, scene, seeds=seeds, folder=folder, client=client, device=device, progress=progress)
    found = analyse(members, unit_m)
    patch_m = scene.values["ocean"]["cascade"][0]["patch_m"]
    return {
        "seeds": len(members["seed"]),
        "duration_s": duration_s,
        "step_s": step_s,
        "points": POINTS_A_SIDE**2,
        "choppiness": choppiness,
        "size": size,
        "patch_m": patch_m,
        "asked": asked,
        "energy_simulated": (found["sigma_m"] / unit_m) ** 2,
        **found,
    }


def _depth_m(scene):
    """The depth of the scene, else of its spectrum; infinity if neither has one."""
    ocean, spectrum = scene.values.get("ocean", {}), scene._spectrum
    if "depth_m" in ocean:
        return float(ocean["depth_m"])
    if spectrum is None and "spectrum_file" in ocean:
        spectrum = Spectrum.read(pathlib.Path(scene.folder or ".", ocean["spectrum_file"]))[ocean.get("record", 0)]
    return spectrum.depth_m if spectrum is not None and spectrum.depth_m > 0 else math.inf
