"""Ensembles: Dask runs one function of a world for many seeds, records of a spectrum file, or values of a scene.

import offing.ensemble

def highest(world):
    heights_m = [world.at(time_s).field("displacement_y").max() for time_s in range(60)]
    return {"height_m": ("time", heights_m), "highest_m": max(heights_m)}

if __name__ == "__main__":  # Dask starts its workers by importing this script
    found = offing.ensemble.run(highest, "sea.toml", seeds=range(200), folder="members")
    print(found["highest_m"].quantile([0.5, 0.95]))
"""

import contextlib
import functools
import json
import logging
import multiprocessing
import operator
import os
import pickle
import sys

import numpy as np

from offing import _core, result_files
from offing.device import Device
from offing.errors import BadInput, Error
from offing.scene import Scene, merged
from offing.world import World

# A worker has one thread, so its device gets one too. PoCL reads one of these, depending on its version.
ONE_THREAD = {"POCL_MAX_PTHREAD_COUNT": "1", "POCL_CPU_MAX_CU_COUNT": "1"}
# Ctrl-C in a terminal reaches every process. Workers ignore it, and the main process ends them.
NO_INTERRUPT = "import signal\nsignal.signal(signal.SIGINT, signal.SIG_IGN)\n"


def run(
    function, scene, *, seeds=None, records=None, parameters=None, folder=None, client=None, device=None, progress=None
):
    """Calls function(world) for every member of an ensemble, and returns all results as one xarray.Dataset.

    `scene` is a Scene, or anything that Scene() takes. Give one of these for the members:

    - `seeds`: whole numbers for world.seed. The data set gets the dimension "seed".
    - `records`: numbers of records in the scene's spectrum file, from 0, for ocean.record. The dimension is "record".
    - `parameters`: a list of nested dicts of scene values, as Scene.with_values() takes. The dimension is "member".
      Each parameter also becomes a coordinate, such as "wind.speed_mps".

    `function` gets a World at the scene's start time. It returns a dict: name -> number, or, as in xarray, name ->
    (dimensions, array). All members must have the same names, dimensions and shapes. An array whose only dimension
    has the array's name becomes a coordinate. Dask must be able to pickle the function, so define it in a file.

    With `folder`, each result is written there when its member is done. A later call with equal inputs reads it. The
    file's name is a hash of the scene, the files that the scene names, the version of Offing, `device` and the
    function. The function counts with its source, default arguments and closure. Numbers, texts, arrays and collections
    of its module that it uses count too, and so do functions of its module or package.

    `client` sets where members run. Results do not depend on it:

    - None: a process for each core of this machine, each with one thread and its own device.
    - a number: that many such processes.
    - "serial": this process.
    - the address of a Dask scheduler, or a Client or Cluster of dask.distributed: its workers.

    Workers open Device(device). progress(done, count) is called after each member. With None, a line on stderr shows
    the progress if stderr is a terminal; with False, nothing does. When a worker dies, Dask repeats its member elsewhere.
    The first member that raises an error ends the run; finished results stay in the folder.
    """
    if client != "serial" and _is_worker_without_guard():
        sys.exit(1)  # without a word: the main process reports it
    dimension, labels, changes = _members(seeds, records, parameters)
    scene = Scene(scene)
    scenes = [scene.with_values(of_member) for of_member in changes]  # raises for bad values before anything runs
    files = result_files.names(function, scenes, folder, device)
    results = [file and result_files.read(file) for file in files]
    missing = [index for index, result in enumerate(results) if result is None]
    described = [str(of) for of in changes] if dimension == "member" else [f"{dimension} {of}" for of in labels]

    with contextlib.closing(_Progress(progress, dimension, len(scenes))) as shown:
        shown.add(len(scenes) - len(missing))
        if missing:
            shown.note("starting workers")
            with _connected(client, len(missing)) as connection:
                shown.note("")
                computed = _computed(connection, function, scenes, described, missing, device)
                with contextlib.closing(computed):
                    for index, result in computed:
                        if files[index]:
                            result_files.write(files[index], result)
                        results[index] = result
                        shown.add(1)
    return _dataset(dimension, labels, changes, scene, results)


class _Progress:
    """Shows how many members are done, as the argument `progress` of run() says."""

    def __init__(self, progress, name, count):
        self._has_line = progress is None and sys.stderr is not None and sys.stderr.isatty()
        self._call, self._name, self._done, self._count = progress, name, 0, count

    def add(self, members):
        self._done += members
        if self._call and members:
            self._call(self._done, self._count)
        self.note("")

    def note(self, text):
        if self._has_line:
            line = f"{self._name}s {self._done}/{self._count}{text and ': '}{text}"
            print(f"\r{line:<60}", end="", file=sys.stderr, flush=True)

    def close(self):
        if self._has_line:
            print(file=sys.stderr)


# The members


def _members(seeds, records, parameters):
    """The dimension, its labels, and a nested dict of changed scene values for each member."""
    given = [values for values in (seeds, records, parameters) if values is not None]
    if len(given) != 1:
        raise BadInput(
            f"ensemble: expected one of seeds, records and parameters, got {len(given)}",
            'use parameters for several values at once: [{"world": {"seed": 1}, "wind": {"speed_mps": 12}}]',
        )
    if seeds is not None:
        labels = _whole("seeds", seeds)
        members = "seed", labels, [{"world": {"seed": seed}} for seed in labels]
    elif records is not None:
        labels = _whole("records", records)
        members = "record", labels, [{"ocean": {"record": record}} for record in labels]
    else:
        changes = [_plain(values) for values in parameters]
        members = "member", list(range(len(changes))), changes
    if not members[1]:
        raise BadInput("ensemble: expected at least one member, got none", "pass seeds=range(1, 101), for example")
    return members


def _whole(name, values):
    try:
        return [operator.index(value) for value in values]
    except TypeError as error:
        raise BadInput(f"{name}: expected whole numbers: {error}", f"pass {name}=range(10), for example") from None


def _plain(value):
    """The value with Python's numbers in place of numpy's, because scenes take only those."""
    if isinstance(value, dict):
        return {key: _plain(of) for key, of in value.items()}
    if isinstance(value, (list, tuple, np.ndarray)):
        return [_plain(of) for of in value]
    return value.item() if isinstance(value, np.generic) else value


def _computed(connection, function, scenes, described, missing, device):
    """Computes the missing members; yields (index, result) as each is done."""

    def pickled(index):
        # The serial run pickles scenes too, because the values of a spectrum change by rounding then.
        return pickle.dumps(scenes[index])

    if connection is None:
        for index in missing:
            with _naming(index, described):
                result = _compute(function, pickled(index), device)
            yield index, result
        return

    from dask.distributed import KilledWorker, as_completed

    futures = {connection.submit(_compute, function, pickled(index), device, pure=False): index for index in missing}
    try:
        for future in as_completed(list(futures)):
            index = futures[future]
            try:
                with _naming(index, described):
                    result = future.result()
            except KilledWorker as error:
                raise Error(
                    f"member {index}: the workers that computed it died: {error}",
                    "give workers more memory, or start fewer: client=2; then run it again with the same folder",
                ) from None
            del futures[future]
            yield index, result
    finally:
        connection.cancel(list(futures))


@contextlib.contextmanager
def _naming(index, described):
    """Adds a note to an error: the member that raised it."""
    try:
        yield
    except Exception as error:
        error.add_note(f"in member {index} of the ensemble: {described[index]}")
        raise


@contextlib.contextmanager
def _connected(client, member_count):
    """A client of dask.distributed; None for "serial". Processes that it starts end when the context ends."""
    if client == "serial":
        yield None
        return
    from dask.distributed import Client, LocalCluster
    from dask.system import CPU_COUNT

    if isinstance(client, Client):
        yield client
    elif client is None or isinstance(client, int):
        if client is not None and client < 1:
            raise BadInput(f"client: expected at least 1 process, got {client}", "pass None for one for each core")
        environment = {name: os.environ.get(name, value) for name, value in ONE_THREAD.items()}
        try:
            cluster = LocalCluster(
                n_workers=client or min(CPU_COUNT, member_count),
                threads_per_worker=1,
                processes=True,
                dashboard_address=":0",  # any free port: no warning where 8787 is taken
                env=environment,
                preload=[NO_INTERRUPT],
                silence_logs=logging.ERROR,
            )
        except RuntimeError:
            raise Error(
                "ensemble: worker processes could not be started",
                'put the call of run() below `if __name__ == "__main__":` in the script, or use client="serial"',
            ) from None
        with cluster, Client(cluster) as connection:
            yield connection
    else:
        try:
            connection = Client(client)
        except (ValueError, OSError) as error:
            raise BadInput(
                f"client: expected the address of a Dask scheduler that runs, got {client!r}: {error}",
                'start one by "dask scheduler", and give its address such as "tcp://host:8786"',
            ) from None
        with connection:
            yield connection


def _is_worker_without_guard():
    """Whether this is a worker that Dask starts and that, to begin with, imports a script that calls run(): its call is
    not below `if __name__ == "__main__":`."""
    process = multiprocessing.current_process()
    return process.name.startswith("Dask Worker") and getattr(process, "_inheriting", False)


@functools.cache
def _device(selector):
    """The device that all members in this process share."""
    return Device(selector)


def _compute(function, scene, device):
    """The result of a member: a dict of name -> (dimensions, array). `scene` is pickled."""
    found = function(World(pickle.loads(scene), device=device if isinstance(device, Device) else _device(device)))
    if not isinstance(found, dict) or not found:
        raise BadInput(
            f"{result_files.name_of(function)}: expected a dict of results, got {type(found).__name__}",
            'return {"name": number} or {"name": (dimensions, array)}',
        )
    result = {}
    for name, value in found.items():
        dimensions, values = value if isinstance(value, tuple) else ((), value)
        dimensions = (dimensions,) if isinstance(dimensions, str) else tuple(dimensions)
        values = np.array(values)
        if values.ndim != len(dimensions) or values.dtype.hasobject:
            raise BadInput(
                f"{result_files.name_of(function)}: {name}: expected an array of numbers or text with {len(dimensions)} "
                f"dimensions, got {values.ndim} of {values.dtype}",
                'return (dimensions, array) with a name for each axis, such as (("time", "place"), heights)',
            )
        result[name] = dimensions, values
    return result


# The data set


def _dataset(dimension, labels, changes, scene, results):
    import xarray

    variables, coordinates = {}, {dimension: labels}
    for name, (dimensions, first) in results[0].items():
        for index, result in enumerate(results):
            found = result.get(name, (None, None))
            if found[0] != dimensions or found[1].shape != first.shape or result.keys() != results[0].keys():
                raise BadInput(
                    f"ensemble: expected {name} {dimensions} {first.shape} in every member, "
                    f"found a difference in member {index}",
                    "return the same names from all members; pad shorter arrays with NaN",
                )
        values = np.stack([result[name][1] for result in results])
        if dimensions == (name,):
            if not (values == first).all():
                raise BadInput(
                    f"ensemble: {name}: expected the same coordinate in every member, found different ones",
                    f"rename the result, so that its name differs from its dimension {name}",
                )
            coordinates[name] = first
        elif dimension in (name, *dimensions):
            raise BadInput(f"ensemble: {name}: the name {dimension} stands for the members", "choose another name")
        else:
            variables[name] = (dimension, *dimensions), values
    if dimension == "member":
        for path in dict.fromkeys(path for values in changes for path in _paths(values)):
            values = [_at(merged(scene.values, of_member), path) for of_member in changes]
            coordinates[".".join(path)] = dimension, _column(values)
    return xarray.Dataset(variables, coordinates, {"offing_version": _core.version()})


def _paths(values, above=()):
    for key, value in values.items():
        yield from _paths(value, (*above, key)) if isinstance(value, dict) else [(*above, key)]


def _at(values, path):
    for key in path:
        values = values.get(key) if isinstance(values, dict) else None
    return values


def _column(values):
    """The values of one parameter as a coordinate: numbers, with NaN where absent; else text."""
    if all(value is None or isinstance(value, (int, float)) for value in values):
        return np.array([np.nan if value is None else value for value in values])
    return np.array([value if isinstance(value, str) else json.dumps(value, default=str) for value in values])
