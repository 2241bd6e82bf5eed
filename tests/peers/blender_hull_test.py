"""Blender puts a ship on the sea by files alone: the hull of `offing highlights`, which moves by its keys, and the maps of
`offing ocean bake --layout rgb --wakes` with ocean.json. Beside its bow, stern and sides the hull is as high above the water as
`offing bodies motion` and `offing ocean query` have it. Fails if frames, axes, places or turns of these files do not fit.

Facets of 0.2 m miss waves of 4 s by k^2 A dx^2 / 8 < 1 mm, but the short, steep waves at the stern by more. Gate 10 mm."""

import json
import pathlib
import tempfile

import peer

offing, scenes = peer.enter("bpy")

import bpy  # noqa: E402
import numpy as np  # noqa: E402
from mathutils import Quaternion, Vector  # noqa: E402
from mathutils.bvhtree import BVHTree  # noqa: E402

SCENE = """version = 1
[time]
fps = 8
[ocean]
spectrum = "swell"
swell_hs_m = 1
swell_period_s = 4
size = 256
[[ocean.cascade]]
patch_m = 100
[[ocean.wake]]
length_m = 100
cells = 256
centre = "body"
body = "ship"
behind_m = 25
[sun]
elevation_deg = 30
[[mesh]]
name = "hull"
shape = "ship"
size_m = 12
[[mesh.highlight]]
light = "sun"
[[body]]
name = "ship"
mesh = "hull"
draught_m = 0.7
speed_mps = 4
thrust_n = 2e3
heading_deg = 35
"""
FIRST, LAST, FPS = 16, 35, 8
# Places in the axes of the hull, metres: beside the bow, the stern and both sides, where there is water.
BESIDE = np.array([(7.5, 0, 0), (-8, 0, 0), (0, 0, 3), (0, 0, -3)])


def table(text):
    return np.genfromtxt(text.splitlines(), delimiter=",", names=True, dtype=None, encoding="utf-8")


def pixels(file):
    """(rows, columns, 4) from the first row of the file on, which Blender keeps last."""
    image = bpy.data.images.load(str(file))
    image.colorspace_settings.name = "Non-Color"
    values = np.empty(len(image.pixels), dtype=np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)[::-1]


def between(values, column, row):
    """Of an array [rows][columns], bilinear between its texels."""
    i, j = np.floor(column).astype(int), np.floor(row).astype(int)
    u, v = ((part - whole).reshape(part.shape + (1,) * (values.ndim - 2)) for part, whole in ((column, i), (row, j)))
    rows, columns = values.shape[:2]
    left, right, near, far = i % columns, (i + 1) % columns, j % rows, (j + 1) % rows
    return ((1 - v) * ((1 - u) * values[near, left] + u * values[near, right]) +
            v * ((1 - u) * values[far, left] + u * values[far, right]))


def sea_at(out, sea, frame, around):
    """The water of a frame as a tree of faces, with z up, near a place: vertices at texels and halfway between them."""
    (cascade,), (wake,) = sea["cascades"], sea["wakes"]
    texel_m, reach = cascade["texel_m"], 90
    middle = np.round(np.array([around.x, -around.y]) / texel_m)
    column, row = np.meshgrid(*(middle[i] + 0.5 * np.arange(-reach, reach + 1) for i in (0, 1)))
    at_rest = texel_m * np.stack([column, -row, 0 * row], -1)
    places = at_rest + between(pixels(out / (cascade["maps"]["displacement"]["file"] % frame))[..., :3], column, row)

    # A wake is on top of the water that is at rest where its texels are, as all maps have it.
    file = out / (wake["maps"]["height"]["file"] % frame)
    texel_m = peer.header_of(file, "texel_m")
    east, south = at_rest[..., 0] - peer.header_of(file, "origin_x_m"), peer.header_of(file, "origin_y_m") - at_rest[..., 1]
    places[..., 2] += between(pixels(file)[..., 0], east / texel_m, south / texel_m)
    across = len(places)
    corners = [r * across + c for r in range(across - 1) for c in range(across - 1)]
    return BVHTree.FromPolygons(places.reshape(-1, 3).tolist(), [(i, i + across, i + across + 1, i + 1) for i in corners])


def freeboards_in_blender(folder):
    """[frames][places], metres, from files alone."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    sea = json.loads((folder / "sea" / "ocean.json").read_text())
    scene.render.fps = round(sea["frames_per_second"])
    bpy.ops.import_scene.gltf(filepath=str(folder / "hull.glb"))
    hull, found = bpy.data.objects["hull"], []
    for frame in range(FIRST, LAST + 1):
        scene.frame_set(frame)
        pose = hull.matrix_world
        water = sea_at(folder / "sea", sea, frame, pose.translation)
        # The importer turned x, y up, z to x, -z, y.
        places = [pose @ Vector((x, -z, y)) for x, y, z in BESIDE]
        found.append([place.z - water.ray_cast(Vector((place.x, place.y, 50)), Vector((0, 0, -1)))[0].z for place in places])
    return np.array(found)


def freeboards_of_commands(folder):
    scene, times = folder / "ship.toml", f"{FIRST / FPS}:{LAST / FPS}:{1 / FPS}"
    motion = table(peer.run(offing, "bodies", "motion", scene, "--times", times, "--quiet"))
    found = []
    for row in motion:
        turn = Quaternion([row[f"turn_{part}"] for part in "wxyz"])
        places = np.array([turn @ Vector(place) for place in BESIDE]) + [row[f"origin_{axis}_m"] for axis in "xyz"]
        np.savetxt(folder / "points.csv", places[:, [0, 2]], delimiter=",", header="x_m,z_m", comments="")
        # A query simulates bodies from time 0 on, as the bake does: their wakes are the same.
        water = table(peer.run(offing, "ocean", "query", scene, "--points", folder / "points.csv", "--times",
                               f"{row['time_s']}:{row['time_s']}:1", "--quiet"))
        found.append(places[:, 1] - water["height_m"])
    return np.array(found)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "ship.toml").write_text(SCENE)
    frames = ("--frames", f"{FIRST}:{LAST}", "--quiet")
    peer.run(offing, "highlights", folder / "ship.toml", *frames, "-o", folder / "hull.glb")
    peer.run(offing, "ocean", "bake", folder / "ship.toml", *frames, "--layout", "rgb", "--axes", "z-up", "--wakes",
             "-o", folder / "sea")
    shown, asked = freeboards_in_blender(folder), freeboards_of_commands(folder)
    error_mm = 1000 * (shown - asked)
    print(f"{len(shown)} frames, {shown.shape[1]} places beside the hull: {asked.min():.3f} to {asked.max():.3f} m above the water, "
          f"off by {np.sqrt(np.mean(error_mm**2)):.2f} mm rms, {np.abs(error_mm).max():.2f} mm at most")
    assert shown.shape == (LAST - FIRST + 1, len(BESIDE)) and np.ptp(asked) > 0.3 and np.abs(error_mm).max() < 10
