"""Compares the spectrum of probes with the spectrum that the sea was made from. It samples the elevation at 64 points
for half an hour.

usage: python probes.py   writes probes.png; takes some 20 s on two cores
"""

import matplotlib
import numpy as np

import offing

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

STEP_S, STEPS, SEGMENT = 0.5, 3600, 512

# Choppiness would move the probes' water sideways, and add bound waves that the spectrum does not have.
scene = offing.Scene(
    {
        "world": {"seed": 5},
        "wind": {"speed_mps": 14},
        "ocean": {"fetch_m": 150e3, "size": 256, "choppiness": 0, "cascade": [{"patch_m": 1536.0}]},
    }
)
sea = offing.World(scene)

# The probes are at least two peak wavelengths apart.
places_m = np.arange(8) * 190.0
points_m = np.stack(np.meshgrid(places_m, places_m), axis=-1).reshape(-1, 2)
elevation_m = np.stack([sea.at(step * STEP_S).sample(points_m, flow=False).height_m for step in range(STEPS)])

# Welch's method (1967): the mean periodogram of all probes, from half-overlapping segments with a Hann window.
window = np.hanning(SEGMENT)[:, None]
segments = [elevation_m[start : start + SEGMENT] for start in range(0, STEPS - SEGMENT + 1, SEGMENT // 2)]
power = np.mean([np.abs(np.fft.rfft(window * segment, axis=0)) ** 2 for segment in segments], axis=(0, 2))
frequencies_hz = np.fft.rfftfreq(SEGMENT, STEP_S)
measured = 2.0 * STEP_S * power / np.sum(window**2)

asked = offing.Spectrum.of_scene(scene, np.linspace(0.03, 1.0, 500), directions=0)
shortest_hz = np.sqrt(9.81 / (2 * np.pi) / (2 * 1536.0 / 256))  # waves of two samples: the grid has no shorter ones
print(f"Hs of the spectrum {asked.hs_m:.2f} m, of the probes {4 * elevation_m.std():.2f} m")

figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
axes.plot(asked.frequencies_hz, asked.energy, label=f"spectrum, Hs {asked.hs_m:.2f} m")
axes.plot(frequencies_hz, measured, ".", label=f"64 probes, Hs {4 * elevation_m.std():.2f} m")
axes.axvline(shortest_hz, color="grey", linewidth=0.8, linestyle="--", label="two samples a wavelength")
axes.set(
    xlabel="frequency, Hz", ylabel="energy, m²/Hz", yscale="log", xlim=(0, 0.6), ylim=(1e-3, 2 * asked.energy.max())
)
axes.grid(alpha=0.3)
axes.legend()
figure.savefig("probes.png", dpi=110)
