"""Makes a sea from a buoy's spectrum, checks its significant wave height, and draws the spectrum and the surface.

usage: python sea_from_buoy.py [FILE [RECORD]]   writes sea_from_buoy.png
"""

import pathlib
import sys

import matplotlib
import numpy as np

import offing

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

EXAMPLE = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "example_sea.data_spec"
file = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else EXAMPLE
record = int(sys.argv[2]) if len(sys.argv) > 2 else 0

spectrum = offing.Spectrum.read(file)[record]
# One patch of 2.2 km, which is long enough for swell. Its 1024 samples a side leave out waves shorter than 4.3 m.
sea = offing.Ocean(spectrum, size=1024, seed=3, cascade=[{"patch_m": 2200.0}])
height_m = sea.at(10.0).field("displacement_y")
[patch_m] = sea.patch_lengths_m

# The patch holds few waves, so Hs of one seed differs from that of the spectrum by some per cent.
asked = sea.sea_state()
print(f"{spectrum.station or file.name} {spectrum.time_utc}")
print(f"Hs of the spectrum {asked['hs_m']:.2f} m, of the map {4 * height_m.std():.2f} m; Tp {asked['tp_s']:.1f} s")

figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
left.plot(spectrum.frequencies_hz, spectrum.energy)
left.set(xlabel="frequency, Hz", ylabel="energy, m²/Hz", title=f"{file.name} {spectrum.time_utc}", ylim=(0, None))
left.grid(alpha=0.3)
limit_m = np.abs(height_m).max()
# Row 0 is z = 0, and z points south: north is up.
image = right.imshow(height_m, extent=(0, patch_m, patch_m, 0), cmap="RdBu_r", vmin=-limit_m, vmax=limit_m)
right.set(xlabel="east, m", ylabel="south, m", title=f"Hs {4 * height_m.std():.2f} m, spectrum {asked['hs_m']:.2f} m")
figure.colorbar(image, ax=right, label="height, m")
figure.savefig("sea_from_buoy.png", dpi=110)
