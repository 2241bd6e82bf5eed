"""xarray reads the series and the waves that Offing writes: NetCDF and CSV agree to the digits that CSV has, times and
units are those of the CF conventions, and a sum over the waves gives the heights of the series. Fails if a digit, a
unit, an order of points or times, or a wave is lost."""

import pathlib
import tempfile

import peer

offing, scenes = peer.enter("xarray")

import numpy as np  # noqa: E402
import xarray as xr  # noqa: E402

# Choppiness 0: points stand at their labels, so that heights are plain sums. Two cascades and Gerstner waves.
SEA = ["--choppiness", "0", "--size", "128", "--cascades", "2", "--gerstner-count", "8", "--wind-speed-mps", "9"]
TIMES = "1000:1004:0.5"


def columns_of(file, **options):
    with open(file) as text:
        lines = [line for line in text if not line.startswith("#")]
    return np.genfromtxt(lines, delimiter=",", names=True, **options)


def agree(found, expected, digits):
    """To half a unit of the last digit printed, and rounding of that."""
    np.testing.assert_allclose(found, expected, rtol=0.5000001 * 10.0 ** (1 - digits), atol=1e-30)


def series(out):
    points = out / "points.csv"
    points.write_text("x_m,z_m\n0,0\n12.5,-40\n-300.25,77\n1000,-2000\n")
    query = ["ocean", "query", *SEA, "--points", points, "--times", TIMES, "--velocity-depth-m", "2", "--quiet"]
    peer.run(offing, *query, "-o", out / "water.csv")
    peer.run(offing, *query, "-o", out / "water.nc")
    table = columns_of(out / "water.csv")
    water = xr.open_dataset(out / "water.nc")
    assert dict(water.sizes) == {"time": 9, "point": 4}, dict(water.sizes)
    assert water.attrs["Conventions"] == "CF-1.8" and water.attrs["featureType"] == "timeSeries"
    assert water.height_m.attrs["standard_name"] == "sea_surface_height_above_mean_sea_level"
    assert all("units" in water[name].attrs for name in table.dtype.names if name != "time_s")
    seconds = (water.time.values - np.datetime64("1970-01-01")) / np.timedelta64(1, "s")
    agree(np.repeat(seconds, 4), table["time_s"], 10)
    for name in table.dtype.names[1:3]:
        agree(np.tile(water[name].values, 9), table[name], 12)
    for name in table.dtype.names[3:]:
        assert water[name].dims == ("time", "point") and water[name].dtype == np.float32, name
        agree(water[name].values.ravel(), table[name], 7)
    print(f"series: {table.size} answers of {len(table.dtype.names)} columns agree")
    return water, seconds


def waves(out, water, seconds):
    peer.run(offing, "ocean", "modes", *SEA, "-o", out / "sea.csv", "--quiet")
    peer.run(offing, "ocean", "modes", *SEA, "-o", out / "sea.nc", "--quiet")
    table = columns_of(out / "sea.csv")
    modes = xr.open_dataset(out / "sea.nc")
    for name, digits in (("amplitude_m", 9), ("kx_radpm", 12), ("kz_radpm", 12), ("omega_radps", 12), ("phase_rad", 9)):
        agree(modes[name].values, table[name], digits)
        assert modes[name].attrs["units"]
    assert np.array_equal(modes.patch.values, table["patch"])
    phases = (modes.kx_radpm.values[:, None] * water.x_m.values + modes.kz_radpm.values[:, None] * water.z_m.values
              + modes.phase_rad.values[:, None])
    height = np.array([modes.amplitude_m.values @ np.cos(phases - modes.omega_radps.values[:, None] * time)
                       for time in seconds])
    hs = 4.0 * np.sqrt(0.5 * (modes.amplitude_m.values**2).sum())
    off = np.sqrt(np.mean((height - water.height_m.values) ** 2))
    # Points between samples are interpolated, which loses short waves: the lattice's own points are exact (C++ tests).
    print(f"waves: {modes.sizes['mode']} of Hs {hs:.3f} m; sums differ from the series by {off / hs:.2e} Hs")
    assert off < 0.02 * hs
    peer.run(offing, "ocean", "query", "--modes-file", out / "sea.nc", "--points", out / "points.csv", "--times", TIMES,
             "--velocity-depth-m", "2", "--quiet", "-o", out / "again.nc")
    again = xr.open_dataset(out / "again.nc")
    worst = float(np.abs(again.height_m - water.height_m).max())
    print(f"the sea of the file differs by {worst:.1e} m at most")
    assert worst < 1e-5 * hs


with tempfile.TemporaryDirectory() as folder:
    waves(pathlib.Path(folder), *series(pathlib.Path(folder)))
