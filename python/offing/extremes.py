"""A study of crest heights: `python -m offing.extremes scenes/example_sea.data_spec --seeds 200 -o crests`.

It simulates the elevation at many points for many seeds, and compares the distribution of crest heights with theory.
It counts two kinds of heights above the mean water level:

- A crest is the highest point between two zero up-crossings. In a linear sea P(crest > h) <= exp(-h^2 / 2 m0), the
  Rayleigh distribution. Each wave with a crest above h crosses h upward at least once, and Rice (1945) gives the rate
  of these crossings. A wave may cross a low level twice, so low crests are rarer than Rayleigh. High crests follow
  Rayleigh for any bandwidth.
- A maximum is any local maximum above the mean level. In a linear sea, maxima follow Rayleigh's distribution with a
  correction for bandwidth (Cartwright & Longuet-Higgins 1956). This is exact at every height.

Theory takes the spectral moments m0, m2 and m4, in angular frequency, from the simulated elevations. The limits come
from a bootstrap over seeds. Seeds are independent; points and waves of one seed are not.
"""

import argparse
import csv
import functools
import json
import math
import os
import pathlib
import signal
import sys
import tempfile

import numpy as np

from offing import ensemble
from offing.errors import BadInput, Error, NoDevice
from offing.scene import Scene
from offing.spectrum import Spectrum

GRAVITY_MPS2 = 9.81
PATCH_WAVELENGTHS = 18  # peak wavelengths along a side of the patch: at size 256, each has 14 samples
POINTS_A_SIDE = 8  # these lie more than two peak wavelengths apart
BIN_SIGMA, BINS_SIGMA = 0.02, 8.0  # width of the bins of heights, and the highest level
LEVELS_SIGMA = np.arange(1, 25) * 0.25
FEWEST_COUNTED = 30  # a level with fewer heights above it is not compared with theory
HIGH_SIGMA = 2.0  # Hs / 2: crests above it follow Rayleigh
RESAMPLES = 2000  # of the bootstrap


# The theory of linear seas. Heights are in standard deviations of the elevation


def rayleigh(height):
    """Share of crests above a height. For any spectrum it is an upper bound (Rice 1945), and close at high levels."""
    return np.exp(-0.5 * np.square(height))


def cartwright_longuet_higgins(height, epsilon):
    """Share of positive maxima above a height >= 0.

    It is the share of all maxima above the height, divided by the share above 0. Source: Cartwright & Longuet-Higgins
    1956, The statistical distribution of the maxima of a random function. The bandwidth is epsilon^2 = 1 - m2^2 /
    (m0 m4). As it goes to 0, the distribution becomes Rayleigh's."""
    normal = np.vectorize(lambda x: 0.5 * math.erfc(-x / math.sqrt(2.0)))  # the normal distribution function
    regular = math.sqrt(1.0 - epsilon**2)
    height = np.asarray(height, dtype=float)
    above = normal(-height / epsilon) + regular * rayleigh(height) * normal(height * regular / epsilon)
    return above / (0.5 * (1.0 + regular))


# Time series: elevations [time, point], m


def with_peaks(elevation_m):
    """The series with raised local maxima, and a mask of these maxima.

    Each is raised to the top of the parabola through it and its two neighbours."""
    before, here, after = elevation_m[:-2], elevation_m[1:-1], elevation_m[2:]
    is_maximum = np.zeros(elevation_m.shape, dtype=bool)
    is_maximum[1:-1] = (here > before) & (here >= after)
    bend = np.where(is_maximum[1:-1], 2.0 * here - before - after, 1.0)
    raised = np.array(elevation_m)
    raised[1:-1] += np.where(is_maximum[1:-1], np.square(after - before) / (8.0 * bend), 0.0)
    return raised, is_maximum


def refined(elevation_m):
    """The series at half its time step. A polynomial of degree 7 through 8 samples gives each new one; 3 samples at
    each end are lost."""
    count = len(elevation_m) - 7
    between = sum(
        weight * (elevation_m[3 - i : 3 - i + count] + elevation_m[4 + i : 4 + i + count])
        for i, weight in enumerate((1225 / 2048, -245 / 2048, 49 / 2048, -5 / 2048))
    )
    both = np.empty((2 * count + 1, *elevation_m.shape[1:]))
    both[::2], both[1::2] = elevation_m[3 : 4 + count], between
    return both


def crest_heights(elevation_m, end):
    """Crest heights at all points: the highest elevation between one zero up-crossing and the next.

    It counts waves that begin before index `end`. The series must be longer, so that it cuts off none of these: long
    waves, which are higher, would be cut off more often."""
    raised, _ = with_peaks(elevation_m)
    heights = [np.zeros(0)]
    for series, peaks in zip(elevation_m.T, raised.T, strict=True):
        starts = np.flatnonzero((series[:-1] <= 0.0) & (series[1:] > 0.0)) + 1
        if len(starts) > 1:
            heights.append(np.maximum.reduceat(peaks[: starts[-1]], starts[:-1])[starts[:-1] < end])
    return np.concatenate(heights)


def maximum_heights(elevation_m, end):
    """Heights of positive local maxima at all points, before index `end`."""
    raised, is_maximum = with_peaks(elevation_m)
    heights = raised[:end][is_maximum[:end]]
    return heights[heights > 0.0]


def moments(elevation_m, step_s):
    """m0 (m^2), m2 (m^2/s^2) and m4 (m^2/s^4): mean squares of the elevation and its first two derivatives.

    Central differences of eighth order give the derivatives."""
    first = np.array([0.0, 4 / 5, -1 / 5, 4 / 105, -1 / 280]) / step_s
    second = np.array([-205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560]) / step_s**2
    inner = slice(4, len(elevation_m) - 4)

    def shifted(by):
        return elevation_m[inner.start + by : inner.stop + by]

    velocity = sum(first[i] * (shifted(i) - shifted(-i)) for i in range(1, 5))
    acceleration = second[0] * shifted(0) + sum(second[i] * (shifted(i) + shifted(-i)) for i in range(1, 5))
    return [float(np.mean(np.square(values))) for values in (elevation_m, velocity, acceleration)]


def counted(elevation_m, *, unit_m, step_s, end):
    """Counts of crests and maxima before index `end` of elevations [time, point], and the moments.

    The bins of heights are BIN_SIGMA * unit_m wide."""
    # A quarter of the time step: a low crest may be shorter than a step and fall between two samples.
    fine = refined(refined(elevation_m))
    edges = np.append(np.arange(0.0, BINS_SIGMA, BIN_SIGMA), np.inf) * unit_m
    crests, maxima = crest_heights(fine, 4 * end), maximum_heights(fine, 4 * end)
    return {
        "crests": ("height", np.histogram(crests, edges)[0]),
        "maxima": ("height", np.histogram(maxima, edges)[0]),
        "moments": ("order", moments(elevation_m, step_s)),
        "highest_m": crests.max(initial=0.0),
    }


def study_member(world, *, unit_m, duration_s, spare_s, step_s):
    """The counts for the sea of one seed over duration_s. Waves that have begun by then end during spare_s."""
    [patch_m], size = world.patch_lengths_m, world.size
    places_m = np.arange(POINTS_A_SIDE) * (size // POINTS_A_SIDE) * (patch_m / size)  # samples of the map: exact there
    points_m = np.stack(np.meshgrid(places_m, places_m), axis=-1).reshape(-1, 2)
    times_s = np.arange(round((duration_s + spare_s) / step_s)) * step_s
    elevation_m = np.stack([world.at(time_s).sample(points_m, flow=False).height_m for time_s in times_s]).astype(float)
    # Choppiness moves the mean level at a fixed place. Heights count from the mean.
    elevation_m -= elevation_m.mean() if world.scene.values["ocean"]["choppiness"] else 0.0
    return counted(elevation_m, unit_m=unit_m, step_s=step_s, end=round(duration_s / step_s))


# The distribution


def exceedance(counts, unit_in_sigma, levels):
    """Share of heights above each level. Levels are in sigma; counts [..., bin] have bins of BIN_SIGMA units."""
    above = np.concatenate(
        [np.cumsum(counts[..., ::-1], axis=-1)[..., ::-1], np.zeros((*counts.shape[:-1], 1))], axis=-1
    )
    # The last bin has no upper end: its heights lie above every level.
    place = np.clip(levels / unit_in_sigma / BIN_SIGMA, 0, counts.shape[-1] - 1)
    index = np.minimum(place.astype(int), counts.shape[-1] - 2)
    low = np.take_along_axis(above, index, axis=-1)
    high = np.take_along_axis(above, index + 1, axis=-1)
    return (low + (place - index) * (high - low)) / above[..., :1]


def analyse(members, unit_m, seed=1):
    """The results of a study: its table, a dict with an array over levels for each column, and single numbers.

    `members` is the data set of all study_member() results; `seed` is that of the bootstrap."""
    spectral = members["moments"].values
    random = np.random.default_rng(seed)
    count = len(spectral)
    weights = random.multinomial(count, np.full(count, 1.0 / count), size=RESAMPLES).astype(float)

    def epsilon_of(values):
        return np.sqrt(1.0 - values[..., 1] ** 2 / (values[..., 0] * values[..., 2]))

    m = spectral.mean(axis=0)
    resampled = weights @ spectral / count
    sigma_m, epsilon = math.sqrt(m[0]), float(epsilon_of(m))
    found = {"sigma_m": sigma_m, "epsilon": epsilon, "tm02_s": 2.0 * math.pi * math.sqrt(m[0] / m[1])}
    table = {"level_sigma": LEVELS_SIGMA, "level_m": LEVELS_SIGMA * sigma_m}
    theories = {
        "crests": lambda e: rayleigh(LEVELS_SIGMA),
        "maxima": lambda e: cartwright_longuet_higgins(LEVELS_SIGMA, e),
    }
    for kind, theory in theories.items():
        counts = members[kind].values.astype(float)
        total = counts.sum(axis=0)
        share = exceedance(total, unit_m / sigma_m, LEVELS_SIGMA)
        sigmas_m = np.sqrt(resampled[:, :1])
        shares = exceedance(
            weights @ counts, unit_m / sigmas_m, np.broadcast_to(LEVELS_SIGMA, (RESAMPLES, len(LEVELS_SIGMA)))
        )
        expected = theory(epsilon)
        # The theory's slope in epsilon, because each resample has an epsilon of its own.
        slope = (theory(epsilon + 1e-4) - theory(epsilon - 1e-4)) / 2e-4
        differences = shares - expected - (epsilon_of(resampled)[:, None] - epsilon) * slope
        error = differences.std(axis=0)
        is_compared = (share * total.sum() >= FEWEST_COUNTED) & (error > 0.0)
        if kind == "crests":
            is_compared &= LEVELS_SIGMA >= HIGH_SIGMA
        deviation = np.zeros(len(LEVELS_SIGMA))
        deviation[is_compared] = (share - expected)[is_compared] / error[is_compared]
        # Half the width of the band in standard errors: 95 % of resamples lie inside it at all levels at once.
        largest = np.abs((differences - (share - expected))[:, is_compared] / error[is_compared]).max(
            axis=1, initial=0.0
        )
        width = float(np.quantile(largest, 0.95))
        # With few seeds the band is wider, as Student's t is wider than the normal distribution.
        width *= math.sqrt(count / (count - 1)) * (1.0 + (width**2 + 1.0) / (4.0 * (count - 1)))
        table[kind] = share
        table[f"{kind}_low"], table[f"{kind}_high"] = np.quantile(shares, [0.025, 0.975], axis=0)
        table[f"{kind}_theory"] = expected
        table[f"{kind}_band_low"] = np.where(is_compared, expected - width * error, np.nan)
        table[f"{kind}_band_high"] = np.where(is_compared, expected + width * error, np.nan)
        found[kind] = {
            "count": int(total.sum()),
            "levels_compared": int(is_compared.sum()),
            "band_standard_errors": width,
            "largest_standard_errors": float(np.abs(deviation).max()),
            "in_band": bool(is_compared.any() and np.abs(deviation).max() <= width),
        }
    found["highest_m"] = float(members["highest_m"].max())
    found["table"] = table
    return found


def peak_wavelength_m(period_s, depth_m):
    """The wavelength of linear waves of a period: Newton's method for k tanh(k D) = w^2 / g."""
    deep = (2.0 * math.pi / period_s) ** 2 / GRAVITY_MPS2
    if not math.isfinite(depth_m):
        return 2.0 * math.pi / deep
    k = deep / math.sqrt(math.tanh(min(deep * depth_m, 300.0)))
    for _ in range(50):
        t = math.tanh(k * depth_m)
        k -= (k * t - deep) / (t + k * depth_m * (1.0 - t * t))
    return 2.0 * math.pi / k


def study_scene(scene, depth_m, *, size, choppiness):
    """A scene with only the random sea of another, in one patch.

    Swells, raindrops, Gerstner waves, wakes, foam, shoals and a loop are left out. Samples lie at multiples of 1/64 m,
    which float32 represents exactly."""
    values = {"ocean": {}} | {key: scene.values[key] for key in ("world", "wind", "ocean") if key in scene.values}
    patch_m = PATCH_WAVELENGTHS * peak_wavelength_m(scene.sea_state()["tp_s"], depth_m)
    patch_m = max(round(64.0 * patch_m / size), 1) / 64.0 * size
    ocean = {name: None for name in ("gerstner", "swell", "raindrop", "wake", "foam", "cascade_count")}
    ocean |= {"size": size, "choppiness": float(choppiness), "cascade": [{"patch_m": patch_m}], "shoals": None}
    alone = Scene(values, folder=scene.folder).with_values({"ocean": ocean})
    return alone.with_spectrum(scene._spectrum) if scene._spectrum is not None else alone


def run_study(
    scene,
    *,
    seeds,
    duration_s=1200.0,
    step_s=None,
    choppiness=0.0,
    size=256,
    folder=None,
    client=None,
    device=None,
    progress=None,
):
    """Runs the study for a scene's sea; returns a dict of its results, with the table of crest heights.

    The arguments are options of the program; `folder`, `client`, `device` and `progress` go to ensemble.run()."""
    scene = Scene(scene)
    asked = scene.sea_state()
    scene = study_scene(scene, _depth_m(scene), size=size, choppiness=choppiness)
    unit_m = asked["hs_m"] / 4.0
    if step_s is None:  # in whole 1/64 s: a seventh of the shortest period on the grid's axes
        step_s = max(round(64.0 * asked["tp_s"] / (7.0 * math.sqrt(size / (2.0 * PATCH_WAVELENGTHS)))), 1) / 64.0
    member = functools.partial(
        study_member, unit_m=unit_m, duration_s=duration_s, spare_s=4.0 * asked["tp_s"], step_s=step_s
    )
    members = ensemble.run(member, scene, seeds=seeds, folder=folder, client=client, device=device, progress=progress)
    found = analyse(members, unit_m)
    patch_m = scene.values["ocean"]["cascade"][0]["patch_m"]
    return {
        "seeds": len(members["seed"]),
        "duration_s": duration_s,
        "step_s": step_s,
        "points": POINTS_A_SIDE**2,
        "choppiness": choppiness,
        "size": size,
        "patch_m": patch_m,
        "asked": asked,
        "energy_simulated": (found["sigma_m"] / unit_m) ** 2,
        **found,
    }


def _depth_m(scene):
    """The depth of the scene, else of its spectrum; infinity if neither has one."""
    ocean, spectrum = scene.values.get("ocean", {}), scene._spectrum
    if "depth_m" in ocean:
        return float(ocean["depth_m"])
    if spectrum is None and "spectrum_file" in ocean:
        spectrum = Spectrum.read(pathlib.Path(scene.folder or ".", ocean["spectrum_file"]))[ocean.get("record", 0)]
    return spectrum.depth_m if spectrum is not None and spectrum.depth_m > 0 else math.inf


# Output


def table_rows(found):
    """The rows of the table: a dict for each level that at least one height exceeds."""
    table = found["table"]
    rows = [{name: float(values[i]) for name, values in table.items()} for i in range(len(table["level_m"]))]
    return [row for row in rows if row["maxima"] > 0.0]


def write_table(found, file):
    rows = table_rows(found)
    with open(file, "w", encoding="utf-8", newline="") as opened:
        writer = csv.DictWriter(opened, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(
            {name: "" if math.isnan(value) else f"{value:.6g}" for name, value in row.items()} for row in rows
        )


def to_json(found):
    def plain(value):
        if isinstance(value, dict):
            return {name: plain(of) for name, of in value.items()}
        return None if isinstance(value, float) and math.isnan(value) else value

    return {name: plain(value) for name, value in found.items() if name != "table"} | {
        "table": [plain(row) for row in table_rows(found)]
    }


def simulated_time(found):
    return f"{found['seeds']} seeds of {found['duration_s']:g} s at {found['points']} points"


def plot(found, file):
    """Writes a PNG of both distributions with their limits and theory."""
    import matplotlib
    from matplotlib.figure import Figure

    rows = table_rows(found)
    column = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    with matplotlib.rc_context({"svg.hashsalt": "offing"}):
        figure = Figure(figsize=(7, 5), layout="constrained")
        axes = figure.add_subplot()
        labels = {
            "crests": ("crests between zero up-crossings", "Rayleigh"),
            "maxima": ("all maxima above the mean level", f"Cartwright & Longuet-Higgins, ε = {found['epsilon']:.2f}"),
        }
        for kind, colour in (("crests", "C0"), ("maxima", "C1")):
            simulated, theory = labels[kind]
            low, share, high = (column[kind + end] for end in ("_low", "", "_high"))
            shown = share > 0
            axes.errorbar(
                column["level_m"][shown],
                share[shown],
                [(share - np.minimum(low, share))[shown], (np.maximum(high, share) - share)[shown]],
                fmt="o",
                markersize=3,
                capsize=2,
                color=colour,
                label=f"{simulated}, 95 % limits",
            )
            axes.plot(column["level_m"], column[f"{kind}_theory"], color=colour, linewidth=1, label=theory)
        axes.set(
            yscale="log",
            xlabel="height above the mean level, m",
            ylabel="share of heights above",
            title=f"Hs {4 * found['sigma_m']:.2f} m, {simulated_time(found)}",
            ylim=(0.3 / max(found["maxima"]["count"], 1), 1.3),
            xlim=(0, None),
        )
        axes.grid(alpha=0.3)
        axes.legend()
        figure.savefig(file, format="png", dpi=120, metadata={"Software": None})


def print_results(found):
    print(f"asked     Hs {found['asked']['hs_m']:.3f} m, Tm02 {found['asked']['tm02_s']:.2f} s")
    print(
        f"simulated Hs {4 * found['sigma_m']:.3f} m, Tm02 {found['tm02_s']:.2f} s, bandwidth epsilon "
        f"{found['epsilon']:.3f}, {100 * found['energy_simulated']:.1f} % of the energy asked"
    )
    print(f"{simulated_time(found)}, highest crest {found['highest_m']:.2f} m\n")
    names = ("level, m", "/ sigma", "crests", "low", "high", "Rayleigh", "maxima", "low", "high", "C&LH 1956")
    print(("{:>8} {:>7}" + " {:>9}" * 8).format(*names))
    for row in table_rows(found):
        shares = [row[kind + end] for kind in ("crests", "maxima") for end in ("", "_low", "_high", "_theory")]
        print(f"{row['level_m']:8.3f} {row['level_sigma']:7.2f}", *(f"{share:9.4g}" for share in shares))
    print()
    for kind, text in (
        ("maxima", "all maxima and Cartwright & Longuet-Higgins 1956"),
        ("crests", "crests above Hs / 2 and Rayleigh"),
    ):
        of = found[kind]
        print(
            f"{text}: {'inside' if of['in_band'] else 'outside'} the 95 % band at {of['levels_compared']} levels; "
            f"largest deviation {of['largest_standard_errors']:.1f}, band {of['band_standard_errors']:.1f} standard "
            f"errors, {of['count']} heights"
        )


# The program


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise BadInput(message, f"`{self.prog} --help` lists the options")


def parse(arguments):
    parser = Parser(
        prog="python -m offing.extremes",
        description="Simulate a sea for many seeds, and compare its crest heights with theory, with 95 % limits.",
        allow_abbrev=False,
    )
    parser.add_argument(
        "sea", nargs="?", help="spectrum file of a buoy or model, or scene (.toml); without it, a JONSWAP sea"
    )
    parser.add_argument("--record", type=int, default=0, help="record of the spectrum file, from 0 (0)")
    parser.add_argument("--wind-speed-mps", type=float, default=15.0, help="wind speed of the JONSWAP sea (15)")
    parser.add_argument("--fetch-m", type=float, default=100000.0, help="fetch of the JONSWAP sea (100000)")
    parser.add_argument("--seeds", type=int, default=40, help="number of seeds, at least 10; they start at 1 (40)")
    parser.add_argument("--duration-s", type=float, default=1200.0, help="simulated time for each seed (1200)")
    parser.add_argument("--step-s", type=float, help="time step (a seventh of the grid's shortest period)")
    parser.add_argument(
        "--choppiness", type=float, default=0.0, help="how much crests are sharpened; 0 is a linear sea (0)"
    )
    parser.add_argument(
        "--size", type=int, default=256, help="samples along each side of the patch of 18 peak wavelengths (256)"
    )
    parser.add_argument(
        "--client", help="a number of processes, serial, or the address of a Dask scheduler (a process for each core)"
    )
    parser.add_argument("--device", help="OpenCL device of the workers, as in the list of `offing devices`")
    parser.add_argument(
        "-o",
        "--output",
        metavar="NAME",
        help="write NAME.csv, NAME.json and NAME.png; finished seeds go to NAME.members",
    )
    parser.add_argument("--force", action="store_true", help="replace existing files")
    parser.add_argument("--json", action="store_true", help="print results as JSON")
    parser.add_argument("--quiet", action="store_true", help="print no progress")
    options = parser.parse_args(arguments)
    for name, lowest in (
        ("seeds", 10),
        ("size", 16),
        ("record", 0),
        ("duration_s", 60.0),
        ("step_s", 0.01),
        ("choppiness", 0.0),
    ):
        value = getattr(options, name)
        if value is not None and not lowest <= value < math.inf:
            raise BadInput(
                f"--{name.replace('_', '-')}: expected at least {lowest:g}, got {value:g}", "choose a larger number"
            )
    if options.step_s and options.duration_s < 100 * options.step_s:
        raise BadInput(
            f"--duration-s: expected at least 100 steps, got {options.duration_s / options.step_s:g}", "lower --step-s"
        )
    return options


def scene_of(options):
    if options.sea is None:
        return Scene({"wind": {"speed_mps": options.wind_speed_mps}, "ocean": {"fetch_m": options.fetch_m}})
    if options.sea.endswith(".toml"):
        return Scene(pathlib.Path(options.sea))
    file = pathlib.Path(options.sea)
    return Scene({"ocean": {"spectrum_file": file.name, "record": options.record}}, folder=file.parent)


def write_all(found, name):
    """Writes NAME.csv, .json and .png. Each file gets its name only when it is complete."""
    writers = {
        ".csv": write_table,
        ".png": plot,
        ".json": lambda values, file: pathlib.Path(file).write_text(
            json.dumps(to_json(values), indent=2) + "\n", encoding="utf-8"
        ),
    }
    for ending, write in writers.items():
        with tempfile.TemporaryDirectory(dir=pathlib.Path(name).parent, prefix=".") as folder:
            part = pathlib.Path(folder, "part")
            write(found, part)
            os.replace(part, f"{name}{ending}")


def show_progress(done, count):
    end = "" if sys.stderr.isatty() and done < count else "\n"
    if sys.stderr.isatty() or done == count or done % max(count // 10, 1) == 0:
        print(
            f"\rseeds {done}/{count}" if sys.stderr.isatty() else f"seeds {done}/{count}",
            end=end,
            file=sys.stderr,
            flush=True,
        )


def run_program(arguments):
    options = parse(arguments)
    if options.output is not None:
        import matplotlib  # noqa: F401  fails here, before the work, if it is not installed

        for ending in (".csv", ".json", ".png"):
            if os.path.lexists(options.output + ending) and not options.force:
                raise BadInput(
                    f"{options.output}{ending}: expected a new file, found an existing one",
                    "name another with -o, or add --force",
                )
        if not pathlib.Path(options.output).parent.is_dir():
            raise BadInput(
                f"{options.output}: expected a name in a folder, found no folder {pathlib.Path(options.output).parent}",
                "make the folder first",
            )
    client = int(options.client) if options.client and options.client.isdigit() else options.client
    found = run_study(
        scene_of(options),
        seeds=range(1, options.seeds + 1),
        duration_s=options.duration_s,
        step_s=options.step_s,
        choppiness=options.choppiness,
        size=options.size,
        folder=options.output and f"{options.output}.members",
        client=client,
        device=options.device,
        progress=None if options.quiet else show_progress,
    )
    if options.output is not None:
        write_all(found, options.output)
    if options.json:
        print(json.dumps(to_json(found), indent=2))
    else:
        print_results(found)


def main(arguments=None):
    """Runs the program; returns its exit code: 0, 1 failed, 2 bad input, 3 no device, 130 interrupted."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        run_program(arguments)
        return 0
    except KeyboardInterrupt:
        code, message, hint = (
            130,
            "stopped at the user's request",
            "run the same command again: with -o, finished seeds are kept",
        )
    except BadInput as error:
        code, message, hint = 2, error.message, error.hint
    except NoDevice as error:
        code, message, hint = 3, error.message, error.hint
    except Error as error:
        code, message, hint = 1, error.message, error.hint
    except ModuleNotFoundError as error:
        code, message, hint = 1, f"no Python module {error.name}", "pip install 'offing[ensemble,plot]'"
    except (OSError, MemoryError) as error:
        code, message, hint = (
            1,
            str(error) or type(error).__name__,
            "check folder, disk and memory, then run the same command again",
        )
    print(f"error: {message}\nhint: {hint}", file=sys.stderr)
    return code


if __name__ == "__main__":
    # Workers import functions by module name, and __main__ would name another module there.
    from offing.extremes import main as imported_main

    sys.exit(imported_main())
