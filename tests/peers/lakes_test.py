"""SciPy's labels of connected ground agree with the lakes of `offing terrain lake`: level, area and volume of the largest
basins of made valleys and, where OFFING_TEST_DATA has them, of real maps. Fails if a lake is filled from the wrong posts, its
spill level is not the highest that stays on the map, or its area or volume is not that of the ground's surface."""

import json
import os
import pathlib
import tempfile
import zipfile

import peer

offing, scenes = peer.enter("scipy")

import numpy as np  # noqa: E402
from scipy import ndimage  # noqa: E402

MOST_LAKES = 10
PARTS = 4  # of a cell's side, so that water finds its way over saddles within cells


def finer(heights):
    """The bilinear surface at PARTS x PARTS places of each cell."""
    rows, columns = heights.shape
    z, x = np.meshgrid(np.arange((rows - 1) * PARTS + 1) / PARTS, np.arange((columns - 1) * PARTS + 1) / PARTS, indexing="ij")
    return ndimage.map_coordinates(heights, [z, x], order=1)


def joined(ground, row, column, level):
    """Ground below a level joined to a place, and whether it comes to the map's edge."""
    labels, _ = ndimage.label(ground < level)
    wet = labels == labels[row, column]
    edge = wet[0].any() or wet[-1].any() or wet[:, 0].any() or wet[:, -1].any()
    return wet, edge


def spill_level(ground, row, column):
    low, high = ground[row, column] + 1e-3, ground.max()
    if joined(ground, row, column, low)[1]:
        return None
    while high - low > 1e-3:
        middle = 0.5 * (low + high)
        if joined(ground, row, column, middle)[1]:
            high = middle
        else:
            low = middle
    return low


def compare(name, file, heights, spacing_x, spacing_z):
    """The basins around posts that are the lowest of those near to them, as many as MOST_LAKES."""
    ground = finer(heights)
    compared = worst_level = worst_area = worst_volume = 0
    done = np.zeros(ground.shape, bool)
    lowest = np.argwhere(heights == ndimage.minimum_filter(heights, 9))
    for top, left in lowest[np.random.default_rng(1).permutation(len(lowest))]:
        if compared == MOST_LAKES:
            break
        row, column = top * PARTS, left * PARTS
        level = None if done[row, column] else spill_level(ground, row, column)
        if level is None or level - ground[row, column] < 2.0:
            continue
        wet, _ = joined(ground, row, column, level)
        done |= wet
        if wet.sum() < 300:
            continue
        place = f"{column / PARTS * spacing_x},{row / PARTS * spacing_z}"
        lake = json.loads(peer.run(offing, "terrain", "lake", file, "--at", place, "--json"))
        worst_level = max(worst_level, abs(lake["level_m"] - level))
        # Measures are compared below the saddles, where both have the same water.
        level = ground[row, column] + 0.7 * (lake["level_m"] - ground[row, column])
        lake = json.loads(peer.run(offing, "terrain", "lake", file, "--at", place, "--level-m", level, "--json"))
        wet, _ = joined(ground, row, column, level)
        cell = spacing_x * spacing_z / PARTS**2
        area, volume = wet.sum() * cell, (level - ground[wet]).sum() * cell
        worst_area = max(worst_area, abs(lake["area_m2"] / area - 1.0))
        worst_volume = max(worst_volume, abs(lake["volume_m3"] / volume - 1.0))
        compared += 1
    print(f"{name}: {compared} lakes: level {worst_level:.4f} m, area {100 * worst_area:.2f} %, volume {100 * worst_volume:.2f} %")
    # Between finer places saddles are a little lower than these. The smallest lakes have 150 of them, whose sum is as exact.
    assert compared > 0 and worst_level < 0.5 and worst_area < 0.05 and worst_volume < 0.12
    return compared


def grid_of(file, heights, spacing):
    rows, columns = heights.shape
    head = f"ncols {columns}\nnrows {rows}\nxllcenter 0\nyllcenter 0\ncellsize {spacing}\n"
    file.write_text(head + "\n".join(" ".join(f"{h:.4f}" for h in row) for row in heights))


with tempfile.TemporaryDirectory() as folder:
    out = pathlib.Path(folder)
    posts, side = 257, 6000.0
    raw = out / "valleys.r32"
    peer.run(offing, "terrain", "generate", "--posts", posts, "--side-m", side, "--erosion", "0.5", "--seed", "11", "-o", raw)
    heights = np.fromfile(raw, np.float32).reshape(posts, posts).astype(float)
    grid_of(out / "valleys.asc", heights, side / (posts - 1))
    written = np.loadtxt(out / "valleys.asc", skiprows=5)
    compare("made valleys", out / "valleys.asc", written, side / (posts - 1), side / (posts - 1))
    data = pathlib.Path(os.environ.get("OFFING_TEST_DATA", ".")) / "terrain"
    real = {"andes_1025_75m.r16": ("<u2", 0.1), "N42E001.hgt.zip": (">i2", 1.0)}
    for name, (numbers, metres) in real.items():
        if not (data / name).exists():
            print(f"{name}: not in OFFING_TEST_DATA")
            continue
        content = (data / name).read_bytes()
        if name.endswith(".zip"):
            with zipfile.ZipFile(data / name) as archive:
                content = archive.read(archive.namelist()[0])
        whole = np.frombuffer(content, numbers)
        side = int(len(whole) ** 0.5)
        part = metres * whole.reshape(side, side)[600:1001, 600:1001]
        part[part < 0.0] = 3000.0  # voids
        file = out / f"{name}.asc"
        grid_of(file, part, 75)
        compare(name, file, part, 75.0, 75.0)
