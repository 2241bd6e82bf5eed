"""Draws what an observer on a terrain's summit sees, and the terrain's mean curvature, which shows hollows and ridges.

usage: python viewshed.py [FILE]   writes viewshed.png; without a file, the program `offing` generates a valley
"""

import pathlib
import subprocess
import sys
import tempfile

import matplotlib
import numpy as np

import offing

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

with tempfile.TemporaryDirectory() as folder:
    if len(sys.argv) > 1:
        file = sys.argv[1]
    else:
        file = pathlib.Path(folder, "valley.tif")
        subprocess.run(
            ["offing", "terrain", "generate", "--posts", "513", "--erosion", "0.7", "--seed", "7", "-o", file],
            check=True,
        )
    terrain = offing.Terrain(file)
height_m = terrain.heights_m.astype(float)  # [rows, columns], row 0 north
dx, dz = terrain.info["spacing_x_m"], terrain.info["spacing_z_m"]

row, column = np.unravel_index(np.argmax(height_m), height_m.shape)
seen = terrain.viewshed(column * dx, row * dz, observer_height_m=1.7, earth_radius_m=offing.EARTH_RADIUS_M)
print(f"from the summit, {height_m.max():.0f} m, {100 * seen.mean():.1f} % of the map is visible")

# A Gaussian of 250 m smooths the map, because the curvature at single posts shows only roughness.
for axis, spacing_m in enumerate((dz, dx)):
    reach = round(750.0 / spacing_m)
    weights = np.exp(-0.5 * (np.arange(-reach, reach + 1) * spacing_m / 250.0) ** 2)
    padded = np.pad(height_m, [(reach, reach) if other == axis else (0, 0) for other in (0, 1)], mode="edge")
    height_m = np.apply_along_axis(np.convolve, axis, padded, weights / weights.sum(), mode="valid")

# Mean curvature of the surface y = h(x, z): positive in hollows, negative on ridges.
hz, hx = np.gradient(height_m, dz, dx)
hxz, hxx = np.gradient(hx, dz, dx)
hzz = np.gradient(hz, dz, axis=0)
mean = ((1 + hz**2) * hxx - 2 * hx * hz * hxz + (1 + hx**2) * hzz) / (2 * (1 + hx**2 + hz**2) ** 1.5)

figure, axes = plt.subplots(1, 2, figsize=(11, 4.8), layout="constrained")
extent = (0, (height_m.shape[1] - 1) * dx, (height_m.shape[0] - 1) * dz, 0)
axes[0].imshow(terrain.heights_m, extent=extent, cmap="Greys_r")
axes[0].imshow(np.ma.masked_equal(seen, False), extent=extent, cmap="autumn", alpha=0.5)
axes[0].plot(column * dx, row * dz, "b^")
axes[0].set(xlabel="east, m", ylabel="south, m", title="visible from the summit")
limit = np.quantile(np.abs(mean), 0.98)
image = axes[1].imshow(mean, extent=extent, cmap="PuOr", vmin=-limit, vmax=limit)
axes[1].set(xlabel="east, m", title="mean curvature, smoothed: hollows positive")
figure.colorbar(image, ax=axes[1], label="1/m")
figure.savefig("viewshed.png", dpi=110)
