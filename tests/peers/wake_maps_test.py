"""OpenEXR's Python reader finds baked wake windows where their headers say: their heights are what a window adds to
`offing ocean query`, to the digits of its table."""

import pathlib
import tempfile

import peer

offing, scenes = peer.enter("OpenEXR")

import numpy as np  # noqa: E402
import OpenEXR  # noqa: E402

SEA = "version = 1\n[ocean]\nsize = 32\nhs_m = 0.3\ntp_s = 4\nchoppiness = 0\n[time]\nfps = 8\n"
WAKE = """[[ocean.wake]]
length_m = 64
cells = 64
x_m = 100
z_m = -30
history_s = 4
[[ocean.wake.hull]]
length_m = 10
x_m = 100
z_m = -30
speed_mps = 3
"""


def heights_m(scene, points, time_s):
    """At this time, of a wake that begins as that of the bake."""
    rows = peer.run(offing, "ocean", "query", scene, "--points", points, "--times", f"0.25:{time_s}:0.125", "--exact")
    table = np.loadtxt(rows.splitlines(), delimiter=",", skiprows=1)
    return table[np.isclose(table[:, 0], time_s), 3]


def main(out):
    (out / "open.toml").write_text(SEA)
    (out / "wake.toml").write_text(SEA + WAKE)
    peer.run(offing, "ocean", "bake", out / "wake.toml", "--wakes", "--frames", "2:6", "-o", out / "maps", "--quiet")
    worst_m = 0.0
    for frame in range(2, 7):
        part = OpenEXR.File(str(out / "maps" / f"ocean.w0.{frame:04}.exr")).parts[0]
        header = {name: np.ravel(part.header[name])[0]
                  for name in ("texel_m", "time_s", "origin_x_m", "origin_z_m")}
        height_m, texel_m, time_s = part.channels["height"].pixels, header["texel_m"], header["time_s"]
        assert height_m.shape == (64, 64) and time_s == frame / 8, (height_m.shape, time_s)
        rows, columns = (grid.ravel() for grid in np.mgrid[4:60:6, 4:60:6])
        places = np.column_stack([header["origin_x_m"] + texel_m * columns, header["origin_z_m"] + texel_m * rows])
        np.savetxt(out / "points.csv", places, delimiter=",", header="x_m,z_m", comments="")
        added_m = heights_m(out / "wake.toml", out / "points.csv", time_s) - heights_m(
            out / "open.toml", out / "points.csv", time_s)
        np.testing.assert_allclose(height_m[rows, columns], added_m, atol=1e-5)
        assert np.abs(added_m).max() > 0.01
        worst_m = max(worst_m, np.abs(height_m[rows, columns] - added_m).max())
    print(f"wake maps: 5 frames agree with queries within {worst_m:.1e} m")


with tempfile.TemporaryDirectory() as folder:
    main(pathlib.Path(folder))
