"""Ensembles of small seas: order, bits, files, workers that die."""

import functools
import os
import pathlib
import signal
import subprocess
import sys

import numpy as np
import pytest

import offing
from offing import ensemble, result_files

pytest.importorskip("xarray")
distributed = pytest.importorskip("distributed")

SEA = {"wind": {"speed_mps": 8}, "ocean": {"size": 16, "choppiness": 0, "cascade": [{"patch_m": 200}]}}
SPECTRUM = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "example_sea.data_spec"


def heights(world):
    times_s = np.arange(3) * 0.5
    series = [world.at(time_s).sample([[0, 0], [70, 30]], flow=False).height_m for time_s in times_s]
    return {"time_s": ("time_s", times_s), "height_m": (("time_s", "point"), series), "hs_m": world.sea_state()["hs_m"]}


def heights_but_die_once(world, mark, fatal_seed):
    """A worker dies in the middle of one member, the first time that this member is computed."""
    if world.scene.values["world"]["seed"] == fatal_seed and not os.path.exists(mark):
        pathlib.Path(mark).touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return heights(world)


def fail_on_three(world):
    if world.scene.values["world"]["seed"] == 3:
        raise ValueError("three")
    return heights(world)


def same_bits(one, other):
    assert list(one.variables) == list(other.variables)
    for name in one.variables:
        assert one[name].dims == other[name].dims
        assert one[name].values.tobytes() == other[name].values.tobytes(), name


def files_in(folder):
    return {file: file.stat().st_mtime_ns for file in pathlib.Path(folder).iterdir()}


# Fails if results depend on the processes that compute them, or on the order in which they are done.
def test_two_workers_equal_serial(tmp_path):
    serial = ensemble.run(heights, SEA, seeds=range(200), client="serial")
    parallel = ensemble.run(heights, SEA, seeds=range(200), client=2, folder=tmp_path)
    same_bits(serial, parallel)
    assert serial["height_m"].dims == ("seed", "time_s", "point")
    assert list(serial["seed"]) == list(range(200))
    assert len({value.tobytes() for value in serial["height_m"].values}) == 200  # each seed has a sea of its own
    # Fails if what was written is not what was computed: now all is read.
    calls = []
    same_bits(
        serial, ensemble.run(heights, SEA, seeds=range(200), folder=tmp_path, progress=lambda *call: calls.append(call))
    )
    assert calls == [(200, 200)]


def spectrum_bits(world):
    spectrum = offing.Spectrum.of_scene(world.scene, world.scene._spectrum.frequencies_hz)
    return {"density": (("frequency", "direction"), spectrum.density)}


# Fails if the spectrum of an array differs in a worker: its values are rounded when they are pickled.
def test_spectrum_of_arrays_has_the_same_bits():
    scene = offing.Scene(SEA).with_spectrum(offing.Spectrum.read(SPECTRUM)[0])
    same_bits(*(ensemble.run(spectrum_bits, scene, seeds=[1], client=client) for client in ("serial", 1)))


UNGUARDED = """
import offing.ensemble

def hs(world):
    return {"hs_m": world.sea_state()["hs_m"]}

print(offing.ensemble.run(hs, {"ocean": {"size": 16}}, seeds=range(4), client=2))
"""


# Fails if a script without a guard gets more than its own traceback and the line with the fix.
def test_script_without_guard(tmp_path):
    (tmp_path / "study.py").write_text(UNGUARDED)
    result = subprocess.run([sys.executable, "study.py"], capture_output=True, text=True, cwd=tmp_path, check=False)
    assert result.returncode == 1 and not result.stdout
    assert result.stderr.count("Traceback") == 1 and "distributed" not in result.stderr, result.stderr
    assert result.stderr.splitlines()[-2:] == [
        "offing.errors.Error: ensemble: worker processes could not be started",
        'hint: put the call of run() below `if __name__ == "__main__":` in the script, or use client="serial"',
    ]


# Fails if a terminal shows nothing while workers start, or a file gets a progress line.
def test_progress_line(tmp_path):
    guarded = UNGUARDED.replace("print(", "if __name__ == '__main__':\n    print(")
    (tmp_path / "study.py").write_text(guarded.replace("client=2", "client=1"))
    command = [sys.executable, "study.py"]
    terminal, its_end = os.openpty()
    subprocess.run(command, stdout=subprocess.DEVNULL, stderr=its_end, cwd=tmp_path, check=True)
    shown = os.read(terminal, 10000).decode()
    os.close(its_end)
    os.close(terminal)
    lines = [line.strip() for line in shown.split("\r") if line.strip()]
    assert lines[:2] == ["seeds 0/4", "seeds 0/4: starting workers"] and lines[-1] == "seeds 4/4", shown
    assert subprocess.run(command, capture_output=True, cwd=tmp_path, check=True).stderr == b""


# Fails if a worker's death loses members, or changes them.
def test_killed_worker(tmp_path):
    function = functools.partial(heights_but_die_once, mark=str(tmp_path / "died"), fatal_seed=7)
    found = ensemble.run(function, SEA, seeds=range(1, 13), client=2, folder=tmp_path / "members")
    assert (tmp_path / "died").exists()
    assert len(files_in(tmp_path / "members")) == 12
    same_bits(found, ensemble.run(heights, SEA, seeds=range(1, 13), client="serial"))


# Fails if an interrupted run computes finished members again, or takes files that are damaged.
def test_restart(tmp_path):
    with pytest.raises(ValueError, match="three"):
        ensemble.run(fail_on_three, SEA, seeds=range(1, 6), client="serial", folder=tmp_path)
    before = files_in(tmp_path)
    assert len(before) == 2 and all(file.suffix == ".npz" for file in before)

    calls = []
    ensemble.run(
        fail_on_three,
        SEA,
        seeds=[1, 2, 4, 5],
        client="serial",
        folder=tmp_path,
        progress=lambda done, count: calls.append((done, count)),
    )
    assert calls == [(2, 4), (3, 4), (4, 4)]
    assert before.items() <= files_in(tmp_path).items()

    damaged, *others = sorted(files_in(tmp_path))
    damaged.write_bytes(damaged.read_bytes()[:-40])
    before = files_in(tmp_path)
    again = ensemble.run(fail_on_three, SEA, seeds=[1, 2, 4, 5], client="serial", folder=tmp_path)
    assert [file for file, time in files_in(tmp_path).items() if before[file] != time] == [damaged]
    same_bits(again, ensemble.run(heights, SEA, seeds=[1, 2, 4, 5], client="serial"))


# Fails if the error of a member does not say which, or hides its kind.
def test_error_names_member():
    with pytest.raises(ValueError) as caught:
        ensemble.run(fail_on_three, SEA, seeds=range(1, 6), client="serial")
    assert caught.value.__notes__ == ["in member 2 of the ensemble: seed 3"]


# Fails if an error in a worker is lost or retried.
def test_error_in_worker():
    with pytest.raises(ValueError, match="three") as caught:
        ensemble.run(fail_on_three, SEA, seeds=range(1, 6), client=1)
    assert caught.value.__notes__ == ["in member 2 of the ensemble: seed 3"]


# Fails if parameters do not reach the scene, or their coordinates are wrong.
def test_parameters():
    parameters = [
        {"wind": {"speed_mps": speed}, "world": {"seed": seed}} for speed in np.array([6.0, 9.0]) for seed in (1, 2)
    ]
    parameters.append({"wind": {"direction_deg": 90.0}})
    found = ensemble.run(heights, SEA, parameters=parameters, client="serial")
    assert found["hs_m"].dims == ("member",)
    assert list(found["wind.speed_mps"].values) == [6, 6, 9, 9, 8]
    assert list(found["world.seed"].values[:4]) == [1, 2, 1, 2]
    assert np.isnan(found["wind.direction_deg"].values[:4]).all() and found["wind.direction_deg"].values[4] == 90
    assert found["hs_m"].values[0] == found["hs_m"].values[1] < found["hs_m"].values[2]


# Fails if records do not choose spectra of the file.
def test_records():
    found = ensemble.run(
        heights, {"ocean": {"size": 16, "spectrum_file": str(SPECTRUM)}}, records=range(3), client="serial"
    )
    asked = [spectrum.hs_m for spectrum in offing.Spectrum.read(SPECTRUM)]
    np.testing.assert_allclose(found["hs_m"], asked, rtol=0.01)


# Fails if a bad value is found only after hours of good members.
def test_bad_values_first():
    with pytest.raises(offing.BadInput, match="speed_mps"):
        ensemble.run(pytest.fail, SEA, parameters=[{}, {"wind": {"speed_mps": -1}}], client="serial")
    with pytest.raises(offing.BadInput, match="one of seeds, records and parameters"):
        ensemble.run(pytest.fail, SEA, seeds=[1], records=[1])
    with pytest.raises(offing.BadInput, match="seeds: expected whole numbers"):
        ensemble.run(pytest.fail, SEA, seeds=[1.5])
    with pytest.raises(offing.BadInput, match="at least 1 process"):
        ensemble.run(pytest.fail, SEA, seeds=[1], client=0)


@pytest.mark.parametrize(
    "found, match",
    [
        (3.0, "dict of results"),
        ({"a": ("x", 3.0)}, "1 dimensions"),
        ({"a": ("x", [object()])}, "numbers or text"),
        ({"a": ("seed", [1.0])}, "stands for the members"),
    ],
)  # Fails if results that no data set can hold are taken, or refused without a reason.
def test_bad_results(found, match):
    with pytest.raises(offing.BadInput, match=match):
        ensemble.run(lambda world: found, SEA, seeds=[1], client="serial")


# Fails if members of unequal shapes are joined.
def test_unequal_shapes():
    with pytest.raises(offing.BadInput, match="in member 1"):
        ensemble.run(
            lambda world: {"a": ("x", [0] * world.scene.values["world"]["seed"])}, SEA, seeds=[1, 2], client="serial"
        )


FACTOR = 3


def helper():
    return 1


def uses_helper(world):
    return {"a": [helper() for _ in range(2)]}


def uses_constant(world):
    return {"a": FACTOR}


class Study:
    def __init__(self, value):
        self.value = value

    def low(self, world):
        return {"a": self.value}

    def high(self, world):
        return {"a": self.value + 1}


# Fails if equal inputs get two names, or other inputs the same name.
def test_names(tmp_path):
    scene = offing.Scene(SEA)

    def name(function=heights, scene=scene, device=None):
        return result_files.names(function, [scene], tmp_path, device)[0]

    def closing_over(value):
        return lambda world: {"a": value}

    partial = functools.partial
    names = [
        name(),
        name(scene=scene.with_values({"world": {"seed": 2}})),
        name(device="cpu"),
        name(uses_helper),
        name(closing_over(1)),
        name(closing_over(2)),
        name(Study(1).low),
        name(Study(1).high),
        name(Study(2).high),
        name(partial(fail_on_three)),
        name(partial(heights, a=1)),
        name(partial(heights, a=np.arange(3))),
        name(scene=scene.with_spectrum(offing.Spectrum.read(SPECTRUM)[0])),
    ]
    assert len(set(names)) == len(names)
    assert name() == name() and name(partial(heights, a=1)) == name(partial(heights, a=1))
    assert name(closing_over(1)) == name(closing_over(1)) and name(Study(1).low) == name(Study(1).low)


# Fails if a name is made of what has another text in each process.
def test_values_without_hash(tmp_path):
    function = functools.partial(heights, lock=object())
    with pytest.raises(offing.BadInput, match="hash") as caught:
        ensemble.run(function, SEA, seeds=[1], client="serial", folder=tmp_path)
    assert "leave out folder" in caught.value.hint


# Fails if a changed helper, constant or file leaves the name as it was.
def test_names_follow_helpers_and_files(tmp_path, monkeypatch):
    def name(function, values=SEA):
        return result_files.names(function, [offing.Scene(values, folder=tmp_path)], tmp_path / "members", None)[0]

    before = name(uses_helper)
    monkeypatch.setitem(globals(), "helper", lambda: 2)
    assert name(uses_helper) != before
    before = name(uses_constant)
    monkeypatch.setitem(globals(), "FACTOR", 4)
    assert name(uses_constant) != before

    for file in SPECTRUM.parent.glob("example_sea.*"):
        (tmp_path / file.name).write_bytes(file.read_bytes())
    values = {"ocean": {"spectrum_file": "example_sea.data_spec"}}
    before = name(heights, values)
    directions = tmp_path / "example_sea.swdir"
    directions.write_text(directions.read_text().replace("315.0", "314.0"))
    assert name(heights, values) != before


# Fails if a run on somebody's cluster closes it, or does not run there.
def test_cluster_of_the_caller():
    with distributed.LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
        serial = ensemble.run(heights, SEA, seeds=[1, 2], client="serial")
        for of_caller in (cluster, cluster.scheduler_address):
            same_bits(serial, ensemble.run(heights, SEA, seeds=[1, 2], client=of_caller))
        with distributed.Client(cluster) as client:
            same_bits(serial, ensemble.run(heights, SEA, seeds=[1, 2], client=client))
            assert client.submit(sum, (1, 2)).result() == 3
