"""Crest statistics: theory, counting, the band, and the sea itself."""

import json
import math
import pathlib
import subprocess
import sys

import numpy as np
import pytest

xarray = pytest.importorskip("xarray")
pytest.importorskip("dask")

from offing import extremes  # noqa: E402

SPECTRUM = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "example_sea.data_spec"


def gaussian_series(random, steps, points, step_s=0.5, peak_hz=0.1, highest_hz=0.27):
    """Series [time, point] of a linear sea of sigma about 1 m: waves of random amplitude at random frequencies of a
    JONSWAP spectrum, which is cut as a grid cuts it. Computed without Offing, from the sums themselves."""
    grid = np.linspace(0.5 * peak_hz, highest_hz, 400)
    width = np.where(grid <= peak_hz, 0.07, 0.09)
    energy = (
        grid**-5 * np.exp(-1.25 * (peak_hz / grid) ** 4) * 3.3 ** np.exp(-0.5 * ((grid / peak_hz - 1) / width) ** 2)
    )
    frequencies = random.choice(grid, 100, p=energy / energy.sum()) + random.uniform(-0.5, 0.5, 100) * (
        grid[1] - grid[0]
    )
    phases = 2 * np.pi * np.outer(np.arange(steps) * step_s, frequencies)
    amplitudes = random.standard_normal((2, 100, points)) / 10
    return np.cos(phases) @ amplitudes[0] + np.sin(phases) @ amplitudes[1]


def study_of(random, seeds, steps=700, points=4):
    members = [
        extremes.counted(gaussian_series(random, steps + 80, points), unit_m=1.0, step_s=0.5, end=steps)
        for _ in range(seeds)
    ]
    return xarray.Dataset(
        {
            name: (
                ("seed", *(() if name == "highest_m" else (members[0][name][0],))),
                np.stack([member[name] if name == "highest_m" else member[name][1] for member in members]),
            )
            for name in members[0]
        }
    )


# Fails if the theory is not Rayleigh's for a narrow spectrum, not half a Gaussian for a broad one, or no distribution.
def test_theory():
    heights = np.linspace(0, 5, 101)
    np.testing.assert_allclose(
        extremes.cartwright_longuet_higgins(heights, 1e-6), extremes.rayleigh(heights), atol=1e-9
    )
    half_gaussian = [math.erfc(height / math.sqrt(2)) for height in heights]
    np.testing.assert_allclose(extremes.cartwright_longuet_higgins(heights, 1 - 1e-12), half_gaussian, atol=1e-5)
    for epsilon in (0.2, 0.6, 0.9):
        shares = extremes.cartwright_longuet_higgins(heights, epsilon)
        assert shares[0] == pytest.approx(1) and (np.diff(shares) < 0).all()
        # Far out, there are as many maxima as up-crossings: sqrt(1 - epsilon^2) maxima a maximum of any sign.
        regular = math.sqrt(1 - epsilon**2)
        assert shares[-1] == pytest.approx(2 * regular / (1 + regular) * math.exp(-12.5), rel=0.02)


# Fails if a crest is not the highest point of its wave, is cut short by the time step, or an unfinished wave counts.
def test_crests_of_known_series():
    times_s = np.arange(0, 40, 0.5)
    wave = 2.0 * np.sin(2 * np.pi * times_s / 8.3 + 0.4)[:, None]
    fine = extremes.refined(extremes.refined(wave))
    np.testing.assert_allclose(extremes.crest_heights(fine, len(fine)), [2.0] * 3, atol=1e-5)
    np.testing.assert_allclose(extremes.maximum_heights(fine, len(fine)), [2.0] * 4, atol=1e-5)
    two_maxima = np.array([-1, 1, 3, 2, 4, 1, -1, -3, -1, 2, 1, -1, 1, 5, 9.0])[:, None]
    crests = extremes.crest_heights(two_maxima, len(two_maxima))
    np.testing.assert_allclose(crests, [4 + 1 / 40, 2 + 1 / 8])  # 9 stands in a wave that does not end
    assert len(extremes.maximum_heights(two_maxima, len(two_maxima))) == 3
    assert len(extremes.crest_heights(two_maxima, 5)) == 1


# Fails if the times between are shifted, or less exact than sin(w dt / 2)^8 35 / 128: 1.1e-3 of the height at 6 steps a
# period, 6e-6 at 12, which the second refinement finds.
def test_refined():
    def wave(times):
        return np.sin(2 * np.pi * times / 6.0 + 1)[:, None]

    fine = extremes.refined(wave(np.arange(100.0)))
    assert np.abs(fine - wave(np.arange(3, 96.25, 0.5))).max() < 1.3e-3
    fine = extremes.refined(wave(np.arange(200.0) / 2))
    assert np.abs(fine - wave(np.arange(1.5, 98.1, 0.25))).max() < 1e-5


# Fails if moments are not those of the spectrum: of a sum of waves, sum of a^2 / 2 w^n. At 7 steps a period differences
# lose 0.11 % of m2 and 0.02 % of m4; limit 0.2 %.
def test_moments():
    times_s, rates = np.arange(0, 8000, 0.5), np.array([0.6, 0.9, 1.8])
    series = np.cos(np.outer(times_s, rates) + [0, 1, 2]).sum(axis=1)[:, None]
    expected = [np.sum(rates**order) / 2 for order in (0, 2, 4)]
    np.testing.assert_allclose(extremes.moments(series, 0.5), expected, rtol=2e-3)


# Fails if shares above a level are not those of the counted heights.
def test_exceedance():
    heights = np.sqrt(np.random.default_rng(1).exponential(2.0, 200_000))
    edges = np.append(np.arange(0, extremes.BINS_SIGMA, extremes.BIN_SIGMA), np.inf)
    counts = np.histogram(heights * 0.9, edges)[0]
    shares = extremes.exceedance(counts, 1 / 0.9, extremes.LEVELS_SIGMA)
    expected = [(heights > level).mean() for level in extremes.LEVELS_SIGMA]
    np.testing.assert_allclose(shares, expected, atol=3e-4)


# Fails if the band does not hold Gaussian series as often as it says. Of 60 studies 3 should be outside; more than 9
# have a probability of 0.1 %. A wrong theory, Rayleigh's for maxima, must be outside in all.
def test_band_holds_gaussian_series(monkeypatch):
    random = np.random.default_rng(7)
    studies = [study_of(random, seeds=20) for _ in range(60)]
    for kind in ("maxima", "crests"):
        outside = [not extremes.analyse(study, 1.0)[kind]["in_band"] for study in studies]
        assert sum(outside) <= 9, kind
    monkeypatch.setattr(extremes.band, "cartwright_longuet_higgins", lambda height, epsilon: extremes.rayleigh(height))
    assert not any(extremes.analyse(study, 1.0)["maxima"]["in_band"] for study in studies)


# Fails if a limit runs off the plot: lower limits of 0 lie at the end of a logarithmic axis, out of sight.
def test_limits_stay_on_the_plot(monkeypatch):
    figure = pytest.importorskip("matplotlib.figure").Figure
    figures = []
    monkeypatch.setattr(figure, "savefig", lambda self, *arguments, **options: figures.append(self))
    found = extremes.analyse(study_of(np.random.default_rng(3), seeds=10), 1.0)
    assert any(row["crests"] > 0 and row["crests_low"] == 0 for row in extremes.table_rows(found))
    extremes.plot(found | {"seeds": 10, "duration_s": 350, "points": 4}, "unused.png")
    (axes,) = figures[0].axes
    ends = np.concatenate([segment[:, 1] for bars in axes.collections for segment in bars.get_segments()])
    assert len(ends) > 20 and ends.min() > axes.get_ylim()[0] and ends.max() < axes.get_ylim()[1]


# Fails if the wavelength does not solve w^2 = g k tanh(k D).
@pytest.mark.parametrize("depth_m", [2.0, 10.0, 50.0, 1000.0, math.inf])
def test_wavelength(depth_m):
    k = 2 * math.pi / extremes.peak_wavelength_m(9.0, depth_m)
    assert 9.81 * k * math.tanh(k * depth_m) == pytest.approx((2 * math.pi / 9.0) ** 2)


# Fails if crest heights of a linear sea, simulated by Offing from a buoy's spectrum, leave the 95 % band: all maxima
# that of Rayleigh's distribution corrected for bandwidth, crests above Hs / 2 that of Rayleigh's. 40 seeds of 20 min.
def test_linear_sea_in_band(tmp_path):
    scene = {"ocean": {"spectrum_file": str(SPECTRUM)}}
    found = extremes.run_study(scene, seeds=range(1, 41), client=2, folder=tmp_path)
    assert found["maxima"]["in_band"] and found["maxima"]["levels_compared"] >= 12, found["maxima"]
    assert found["crests"]["in_band"] and found["crests"]["levels_compared"] >= 6, found["crests"]
    assert 0.9 < found["energy_simulated"] < 1.02
    # Rice's bound for crests of any height, within the sampling error.
    table = found["table"]
    assert (table["crests_low"] <= table["crests_theory"]).all()


# Fails if the band is so wide that the sharper crests of a choppy sea fit in, or if choppiness lowers them.
def test_choppy_sea_leaves_band():
    found = extremes.run_study({"wind": {"speed_mps": 12}}, seeds=range(1, 11), duration_s=200, choppiness=1, client=2)
    table = found["table"]
    is_high = table["crests"] * found["crests"]["count"] > 100
    assert not found["maxima"]["in_band"] and not found["crests"]["in_band"]
    assert (table["crests"] > table["crests_theory"])[is_high & (table["level_sigma"] >= 1)].all()


def program(*arguments, folder):
    command = [sys.executable, "-m", "offing.extremes", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, cwd=folder, check=False)


# Fails if the program does not write its files, prints no JSON, repeats finished seeds, or replaces files unasked.
def test_program(tmp_path):
    options = (SPECTRUM, "--seeds", 10, "--duration-s", 60, "--size", 64, "--client", "serial", "-o", "crests")
    result = program(*options, "--json", folder=tmp_path)
    assert result.returncode == 0, result.stderr
    printed = json.loads(result.stdout)
    assert printed["seeds"] == 10 and printed["asked"]["hs_m"] == pytest.approx(3.7, abs=0.1)
    assert json.loads((tmp_path / "crests.json").read_text()) == printed
    assert (tmp_path / "crests.png").read_bytes().startswith(b"\x89PNG")
    header, *rows = (tmp_path / "crests.csv").read_text().splitlines()
    assert header.startswith("level_sigma,level_m,crests,crests_low,crests_high,crests_theory") and len(rows) > 8

    again = program(*options, folder=tmp_path)
    assert again.returncode == 2
    assert again.stderr.splitlines() == [
        "error: crests.csv: expected a new file, found an existing one",
        "hint: name another with -o, or add --force: it replaces the files, and uses finished seeds again",
    ]
    again = program(*options, "--force", folder=tmp_path)
    assert again.returncode == 0 and again.stderr == "seeds 10/10\n"
    assert json.loads((tmp_path / "crests.json").read_text()) == printed


# Fails if an option that has no effect is passed over.
@pytest.mark.parametrize(
    "options, warning",
    [
        ((), ""),
        (("--record", "1"), "warning: --record: not used without a file\n"),
        ((str(SPECTRUM), "--record", "1"), ""),
        ((str(SPECTRUM), "--fetch-m", "1000"), "warning: --fetch-m: not used with a spectrum file\n"),
        ((str(SPECTRUM.with_name("storm.toml")), "--record", "0"), "warning: --record: not used with a scene\n"),
    ],
)
def test_unused_options(options, warning, capsys):
    extremes.scene_of(extremes.parse(options))
    assert capsys.readouterr().err == warning


# Fails if bad input does not end with exit code 2 or 3 and two lines.
@pytest.mark.parametrize(
    "options, code, text",
    [
        (("--seeds", 3), 2, "--seeds: expected at least 10"),
        (("--seeds", "many"), 2, "argument --seeds"),
        (("--choppiness", "nan"), 2, "--choppiness: expected"),
        (("nowhere.spec",), 2, "error: nowhere.spec: expected"),
        ((SPECTRUM, "--record", 3), 2, "error: --record: expected one within [0, 2], got 3"),
        (("--client", 0), 2, "client: expected at least 1 process"),
        (("--size", 100), 2, "size"),
        (("--device", "nothing", "--client", "serial"), 3, "nothing"),
    ],
)
def test_bad_input(tmp_path, options, code, text):
    result = program(*options, folder=tmp_path)
    lines = result.stderr.splitlines()
    assert result.returncode == code and len(lines) == 2, result.stderr
    assert lines[0].startswith("error: ") and text in lines[0] and lines[1].startswith("hint: ")
    assert not result.stdout
