"""Mitsuba 3 renders exported clouds as our reference does (cloud_pictures.py). It takes clouds, light and camera only from
files and output of our programs, and scatters as docs/clouds.md says under "The same cloud in Cycles and Mitsuba".

Measured with Mitsuba 3.9: cumulus 1.000 and 0.049 (mean and error), stratus 0.999 and 0.051, cumulonimbus 0.996 and 0.054.
Noise of blocks is 0.04 to 0.05 of Mitsuba and 0.01 to 0.02 of ours, of means 0.007. It takes 7 minutes of one core."""

import pathlib
import tempfile

import peer

offing, view, vdb_dump, scenes = peer.enter("mitsuba")

import cloud_pictures  # noqa: E402
import mitsuba as mi  # noqa: E402
import numpy as np  # noqa: E402

mi.set_variant("scalar_rgb")  # the others need a recent LLVM
from mitsuba import ScalarTransform4f as Transform  # noqa: E402

PARTS = 8  # of Mitsuba's paths
CUMULONIMBUS = """version = 1
[sun]
azimuth_deg = 75
elevation_deg = 35
[camera]
y_m = 1500
z_m = 19000
pitch_deg = 10
fov_deg = 45
[[cloud]]
genus = "cumulonimbus"
y_m = 700
"""


def exported_medium(scene, cell_m, out):
    """A cube of the cloud that `offing clouds build` writes, as Mitsuba takes it."""
    vdb, raw = out / "cloud.vdb", out / "cloud.raw"
    peer.run(offing, "clouds", "build", scene, "-o", vdb, "--cell-m", cell_m, "--quiet")
    words = peer.run(vdb_dump, vdb, raw).split()
    size = np.array(words[:3], int)
    *first_m, cell_m, extinction_per_m = map(float, words[3:])
    density = np.fromfile(raw, np.float32).reshape(*size[::-1], 1)
    box = Transform().translate(np.array(first_m) - 0.5 * cell_m).scale(cell_m * size)
    return {"type": "cube", "to_world": box @ Transform().scale(0.5).translate([1, 1, 1]), "bsdf": {"type": "null"},
            "interior": {
                "type": "heterogeneous", "scale": extinction_per_m, "albedo": 0.9999,
                "sigma_t": {"type": "gridvolume", "grid": mi.VolumeGrid(density), "to_world": box},
                "phase": {"type": "blendphase", "weight": 0.05,
                          "lobe_1": {"type": "hg", "g": 0.85}, "lobe_2": {"type": "hg", "g": -0.3}}}}


def mitsuba_scene(medium, setting):
    """Of clouds in the light, and before the camera, of --compare-reference --json."""
    # Above and below the horizon, in so many rows that their mixture at the horizon has no weight.
    around = np.empty((1024, 2, 3), np.float32)
    around[:512], around[512:] = setting["sky_kcdpm2"], setting["ground_kcdpm2"]
    camera = setting["camera"]
    eye_m, forward = np.array(camera["eye_m"]), np.array(camera["forward"])
    scene = {
        "type": "scene", "cloud": medium,
        # Never ends a path by chance: that adds noise, as nearly all light goes on.
        "integrator": {"type": "volpath", "max_depth": -1, "rr_depth": 1000000, "hide_emitters": True},
        # Sampled by the directions that paths take, so that each collision looks at the sun.
        "around": {"type": "envmap", "bitmap": mi.Bitmap(around), "sampling_weight": 0.0},
        "sensor": {"type": "perspective", "fov_axis": "y", "fov": camera["vertical_field_of_view_deg"],
                   "near_clip": 1.0, "far_clip": 1e6,
                   "to_world": Transform().look_at(eye_m, eye_m + forward, camera["up"]),
                   "film": {"type": "hdrfilm", "width": cloud_pictures.WIDTH, "height": cloud_pictures.HEIGHT,
                            "component_format": "float32", "rfilter": {"type": "box"}}}}
    for i, light in enumerate(setting["lights"]):
        scene[f"light{i}"] = {"type": "directional", "direction": -np.array(light["direction"]),
                              "irradiance": {"type": "rgb", "value": light["illuminance_klx"]}}
    return mi.load_dict(scene)


def agrees(scene, our_samples, their_samples, out):
    reference = cloud_pictures.Reference(view, scene, our_samples, out)
    theirs = mitsuba_scene(exported_medium(scene, reference.setting["cell_m"], out), reference.setting)
    return reference.agrees_with(np.array(mi.render(theirs, spp=their_samples // PARTS, seed=part))
                                 for part in range(PARTS))


def main(out):
    (out / "cumulonimbus.toml").write_text(CUMULONIMBUS)
    wrong = []
    for scene, our_samples, their_samples in ((scenes / "cumulus.toml", 2048, 512),
                                              (scenes / "stratus.toml", 2048, 512),
                                              (out / "cumulonimbus.toml", 2048, 512)):
        folder = out / scene.stem
        folder.mkdir()
        if not agrees(scene, our_samples, their_samples, folder):
            wrong.append(scene.stem)
    assert not wrong, wrong


with tempfile.TemporaryDirectory() as folder:
    main(pathlib.Path(folder))
