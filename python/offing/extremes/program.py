"""The program `python -m offing.extremes`."""

import argparse
import json
import math
import os
import pathlib
import shlex
import signal
import sys

from offing.errors import BadInput, Error, NoDevice
from offing.extremes.output import print_results, to_json, write_all
from offing.extremes.study import run_study
from offing.scene import Scene
from offing.spectrum import Spectrum


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
    parser.add_argument("--record", type=int, help="record of the spectrum file, from 0 (0)")
    parser.add_argument("--wind-speed-mps", type=float, help="wind speed of the JONSWAP sea (15)")
    parser.add_argument("--fetch-m", type=float, help="fetch of the JONSWAP sea (100000)")
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
    parser.add_argument("--force", action="store_true", help="replace existing files; finished seeds are used again")
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
    is_scene = options.sea is not None and options.sea.endswith(".toml")
    if options.sea is None:
        kind, unused = "without a file", ("record",)
    elif is_scene:
        kind, unused = "with a scene", ("record", "wind_speed_mps", "fetch_m")
    else:
        kind, unused = "with a spectrum file", ("wind_speed_mps", "fetch_m")
    for name in unused:
        if getattr(options, name) is not None:
            print(f"warning: --{name.replace('_', '-')}: not used {kind}", file=sys.stderr)
    if options.sea is None:
        wind_speed_mps = 15.0 if options.wind_speed_mps is None else options.wind_speed_mps
        fetch_m = 1e5 if options.fetch_m is None else options.fetch_m
        return Scene({"wind": {"speed_mps": wind_speed_mps}, "ocean": {"fetch_m": fetch_m}})
    if is_scene:
        return Scene(pathlib.Path(options.sea))
    spectra, record = Spectrum.read(options.sea), options.record or 0
    if record >= len(spectra):
        raise BadInput(
            f"--record: expected one within [0, {len(spectra) - 1}], got {record}",
            f"`offing ocean spectrum {shlex.quote(options.sea)}` lists the records",
        )
    return Scene().with_spectrum(spectra[record])


def show_progress(done, count):
    """Prints a line for each tenth of the members; on a terminal, ensemble.run() shows them."""
    if done == count or done % max(count // 10, 1) == 0:
        print(f"seeds {done}/{count}", file=sys.stderr, flush=True)


def run_program(arguments):
    options = parse(arguments)
    if options.output is not None:
        import matplotlib  # noqa: F401  fails here, before the work, if it is not installed

        for ending in (".csv", ".json", ".png"):
            if os.path.lexists(options.output + ending) and not options.force:
                raise BadInput(
                    f"{options.output}{ending}: expected a new file, found an existing one",
                    "name another with -o, or add --force: it replaces the files, and uses finished seeds again",
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
        progress=False if options.quiet else None if sys.stderr.isatty() else show_progress,
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
