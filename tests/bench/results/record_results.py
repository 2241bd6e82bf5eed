# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Runs benchmarks and writes their rows to docs/results. At the top of the sources, on a machine that does nothing else:
python3 tests/bench/results/record_results.py build/bin [--benchmarks highlights,clouds]
Then results_page.py writes the page and its plots. Benchmarks that are not named keep their rows."""

import argparse
import datetime
import json
import os
import pathlib
import re
import subprocess

import records

# Benchmark -> its sizes, () for its own, and its blocks.
BENCHMARKS = {
    "fft": ((), 15),
    "ocean": ((), 15),
    "gerstner": ((), 15),
    "queries": ((), 15),
    "previews": ((256, 512, 1024), 15),
    "render": ((64, 128, 256, 512), 15),
    "terrain": ((256, 512, 1024, 2048, 4096), 15),
    "viewshed": ((1024,), 15),
    "curvature": ((256,), 5),  # a block of the peer takes seconds
    "highlights": ((), 15),
    "clouds": ((), 15),
    "wake": ((64, 128, 256, 512), 15),
    "world": ((), 15),
}


def output_of(*command):
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, check=True, text=True).stdout


def this_run(programs):
    """What runs.csv says of the day and the machine."""
    processor = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text())  # not on Arm
    memory_kib = int(re.search(r"MemTotal:\s*(\d+)", pathlib.Path("/proc/meminfo").read_text()).group(1))
    huge_pages = pathlib.Path("/sys/kernel/mm/transparent_hugepage/enabled")
    devices = json.loads(output_of(programs / "offing", "devices", "--json"))
    device = next(device for device in devices if device["is_default"])
    return {
        "date": datetime.date.today().isoformat(),
        "commit": output_of("git", "rev-parse", "--short", "HEAD").strip(),
        "processor": processor.group(1) if processor else os.uname().machine,
        "cores": len(os.sched_getaffinity(0)),
        "memory_gib": round(memory_kib / 2**20),
        "linux": ".".join(os.uname().release.split(".")[:2]),  # what follows may name the machine
        "huge_pages": huge_pages.read_text().strip() if huge_pages.exists() else "unknown",
        "opencl_device": device["name"],
        "opencl_platform": f"{device['platform']} {device['driver_version']}",
        "compiler": output_of("c++", "--version").splitlines()[0],
        "fftw": output_of("pkg-config", "--modversion", "fftw3f").strip(),
        "load_before": f"{os.getloadavg()[0]:.1f}",
    }


def record(programs, benchmark, folder, run):
    sizes, blocks = BENCHMARKS[benchmark]
    chosen = ("--sizes", ",".join(map(str, sizes))) if sizes else ()
    rows = json.loads(output_of(programs / "offing-bench", benchmark, *chosen, "--blocks", blocks, "--json"))
    records.write_rows(folder, benchmark, rows)
    records.write_run(folder, {"benchmark": benchmark, "blocks": blocks, **run})


def main():
    parser = argparse.ArgumentParser(description="Runs benchmarks and writes their rows to docs/results.")
    parser.add_argument("programs", type=pathlib.Path, help="folder of offing and offing-bench")
    parser.add_argument("--benchmarks", default=",".join(BENCHMARKS), help="what to measure: %(default)s")
    parser.add_argument("--folder", type=pathlib.Path, default="docs/results", help="where the CSV files go: %(default)s")
    options = parser.parse_args()
    chosen = options.benchmarks.split(",")
    if unknown := set(chosen) - set(BENCHMARKS):
        parser.error(f"--benchmarks: expected some of {', '.join(BENCHMARKS)}, got {', '.join(sorted(unknown))}")
    run = this_run(options.programs)
    for benchmark in chosen:
        record(options.programs, benchmark, options.folder, run)


if __name__ == "__main__":
    main()
