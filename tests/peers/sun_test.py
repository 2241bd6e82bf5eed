"""pvlib agrees with the sun's position and its direct light under a clear sky (NREL's solar position algorithm; Ineichen
and Perez), and with the hours and the sunlight of maps that `offing terrain sun` writes. Fails if a term of the series, of
the air mass or of the clear-sky model is mistyped, or a map's hours or light are not their integrals over time."""

import json
import pathlib
import tempfile

import peer

offing, dump, scenes = peer.enter("pvlib")

import numpy as np  # noqa: E402
import pandas as pd  # noqa: E402
import pvlib  # noqa: E402


def clear_light(elevation_deg, height_m, turbidity, distance_au):
    zenith = 90.0 - elevation_deg
    mass = pvlib.atmosphere.get_absolute_airmass(
        pvlib.atmosphere.get_relative_airmass(zenith), pvlib.atmosphere.alt2pres(height_m)
    )
    with np.errstate(divide="ignore"):  # at the horizon, whose value is dropped below
        model = pvlib.clearsky.ineichen(zenith, mass, turbidity, altitude=height_m, dni_extra=1361.0 / distance_au**2)
    return np.where(elevation_deg > 0.0, model["dni"], 0.0)


def positions():
    rows = np.array(json.loads(peer.run(dump)))
    time_s, latitude, longitude, azimuth, elevation, lifted, distance, height, turbidity, light = rows.T
    worst_angle = worst_distance = 0.0
    for place in np.unique(np.stack([latitude, longitude], 1), axis=0):
        here = (latitude == place[0]) & (longitude == place[1])
        times = pd.to_datetime(time_s[here], unit="s", utc=True)
        sun = pvlib.solarposition.get_solarposition(times, *place, method="nrel_numpy", delta_t=69.0)
        distances = pvlib.solarposition.nrel_earthsun_distance(times, delta_t=69.0)
        across = (azimuth[here] - sun["azimuth"].values + 180.0) % 360.0 - 180.0
        across *= np.cos(np.radians(elevation[here]))
        worst_angle = max(worst_angle, np.hypot(across, elevation[here] - sun["elevation"].values).max())
        worst_distance = max(worst_distance, np.abs(distance[here] - distances.values).max())
    expected = clear_light(lifted, height, turbidity, distance)
    worst_light = np.abs(light - expected).max()
    print(f"{len(rows)} suns: {worst_angle:.4f} degrees, {worst_distance:.1e} au, {worst_light:.1e} W/m^2")
    # The method promises 0.01 degrees. Its distance is that of the unperturbed ellipse: planets move it by 4e-5 au.
    assert worst_angle < 0.01 and worst_distance < 1e-4 and worst_light < 1e-3


def maps(out):
    """A plane that rises to the south-east by 0.3 along both axes, 1500 m up: 80 x 80 posts, 20 m apart."""
    steps = np.arange(80) * 20.0 - 800.0
    heights = 1500.0 + 0.3 * steps[None, :] + 0.3 * steps[:, None]
    plane = out / "plane.asc"
    plane.write_text(
        "ncols 80\nnrows 80\nxllcorner 0\nyllcorner 0\ncellsize 20\n" + "\n".join(" ".join(f"{h:.3f}" for h in row) for row in heights)
    )
    place = (-32.5, -70.5)
    for day in ("2026-03-20", "2026-06-21", "2026-12-21"):
        made = json.loads(
            peer.run(
                offing, "terrain", "sun", plane, "--spacing-m", "20", "--latitude-deg", place[0], "--longitude-deg", place[1],
                "--from", day, "--to", day, "--step", "5min", "--json", "--quiet", "--force", "-o", out / "sun.tif",
            )
        )  # fmt: skip
        times = pd.date_range(day, periods=24 * 60, freq="1min", tz="UTC") + pd.Timedelta("30s")
        sun = pvlib.solarposition.get_solarposition(times, *place, method="nrel_numpy", delta_t=69.0)
        distance = pvlib.solarposition.nrel_earthsun_distance(times, delta_t=69.0).values
        azimuth, elevation = np.radians(sun["azimuth"].values), np.radians(sun["apparent_elevation"].values)
        east, south = np.cos(elevation) * np.sin(azimuth), -np.cos(elevation) * np.cos(azimuth)
        cosine = (np.sin(elevation) - 0.3 * east - 0.3 * south) / np.sqrt(1.18)
        light = clear_light(np.degrees(elevation), 1500.0, 3.0, distance)
        expected = (np.maximum(cosine, 0.0) * light).sum() / 60e3
        found = made["energy_kwh_per_m2"]["mean"]
        # Up where the true middle of the disc is above -0.833 degrees and before the plane.
        rise = 0.3 * np.sin(azimuth) - 0.3 * np.cos(azimuth)
        hours = ((sun["elevation"].values > -0.833) & (np.tan(elevation + np.radians(0.267)) > rise)).sum() / 60.0
        print(f"{day}: {found:.4f} and {expected:.4f} kWh/m^2, {made['hours']['mean']:.3f} and {hours:.3f} h")
        assert abs(found / expected - 1.0) < 0.01
        # Steps of a minute, at dawn and at dusk, and 0.001 of rise of horizons, less than a minute.
        assert abs(made["hours"]["mean"] - hours) < 0.05


with tempfile.TemporaryDirectory() as folder:
    positions()
    maps(pathlib.Path(folder))
