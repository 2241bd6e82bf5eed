"""xarray reads the motions of bodies that Offing writes: NetCDF and CSV agree to the digits that CSV has, and the turns
put the mass centre where the columns have it. Fails if a column, a time or a body is lost or in another place."""

import pathlib
import tempfile

import peer

offing, scenes = peer.enter("xarray")

import numpy as np  # noqa: E402
import xarray as xr  # noqa: E402


def main(out):
    motion = ["bodies", "motion", scenes / "afloat.toml", "--times", "0:2:0.25", "--quiet"]
    peer.run(offing, *motion, "-o", out / "motion.csv")
    peer.run(offing, *motion, "-o", out / "motion.nc")
    table = np.genfromtxt(out / "motion.csv", delimiter=",", names=True, dtype=None, encoding="utf-8")
    data = xr.open_dataset(out / "motion.nc")
    names = data.attrs["bodies"].split(",")
    assert dict(data.sizes) == {"time": 9, "body": len(names)}, dict(data.sizes)
    assert list(table["body"]) == names * 9
    seconds = (data.time.values - data.time.values[0]) / np.timedelta64(1, "s")
    np.testing.assert_allclose(np.repeat(seconds, len(names)), table["time_s"], atol=1e-6)
    for name in table.dtype.names[2:]:
        assert data[name].dims == ("time", "body") and "units" in data[name].attrs, name
        np.testing.assert_allclose(data[name].values.ravel(), table[name], rtol=1e-8, atol=1e-12, err_msg=name)
    # The mass centre is a point of the hull: in its axes it stays where it is.
    w, x, y, z = (data[f"turn_{part}"].values for part in "wxyz")
    np.testing.assert_allclose(w * w + x * x + y * y + z * z, 1.0, atol=1e-6)
    arm = np.stack([data[f"{axis}_m"].values - data[f"origin_{axis}_m"].values for axis in "xyz"], -1)
    back = -np.stack([x, y, z], -1)
    cross = np.cross(back, arm)
    in_hull = arm + 2.0 * (w[..., None] * cross + np.cross(back, cross))
    spread = np.ptp(in_hull, axis=0).max()
    assert spread < 1e-4, spread
    print(f"motions: {table.size} rows of {len(table.dtype.names)} columns agree; the mass centre moves {spread:.1e} m")


with tempfile.TemporaryDirectory() as folder:
    main(pathlib.Path(folder))
