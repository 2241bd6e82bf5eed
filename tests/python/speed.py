"""speed.py PEER [--json]: what the Python package costs beside C++ (speed_peer.cpp), numpy.fft and scipy.fft, in medians of
20 interleaved runs on a quiet machine."""

import json
import statistics
import subprocess
import sys
import time

import numpy as np
import scipy.fft

import offing

RUNS, SAMPLES, N = 20, 100_000, 512
TEXT = f"version = 1\n[wind]\nspeed_mps = 12\n[ocean]\nsize = {N}\ncascade_count = 1\n"
ALL = ["displacement_x", "displacement_y", "displacement_z", "slope_x", "slope_z", "gradient_xx", "gradient_xz", "gradient_zz"]


class Cpp:
    """The same from C++, in a process that waits for its turn."""

    def __init__(self, program):
        self.process = subprocess.Popen([program, TEXT, str(SAMPLES)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ms(self, what):
        self.process.stdin.write(what + "\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline())


def ms_of(call):
    begin = time.perf_counter()
    call()
    return 1e3 * (time.perf_counter() - begin)


def spectra():
    """Half-complex spectra of eight fields, as irfft2 takes them: real fields from n x (n / 2 + 1) modes."""
    random = np.random.default_rng(1)
    shape = (len(ALL), N, N // 2 + 1)
    return (random.standard_normal(shape) + 1j * random.standard_normal(shape)).astype(np.complex64)


def main():
    cpp = Cpp(sys.argv[1])
    world = offing.World(TEXT)
    i = np.arange(SAMPLES)
    points = np.column_stack([0.37 * (i % 1000), 0.41 * (i // 1000)])
    modes = spectra()
    now = [0.0]

    def frame(names):
        now[0] += 0.1
        return world.at(now[0]).fields(names)

    tasks = {
        "sample, C++": lambda: cpp.ms("sample"),
        "sample, Python": lambda: ms_of(lambda: world.sample(points)),
        "frame with displacement, C++": lambda: cpp.ms("frame_and_displacement"),
        "frame with displacement, Python": lambda: ms_of(lambda: frame(ALL[:3])),
        "frame with one field": lambda: ms_of(lambda: frame(ALL[1:2])),
        "frame with eight fields": lambda: ms_of(lambda: frame(ALL)),
        "eight fields, numpy.fft": lambda: ms_of(lambda: [np.fft.irfft2(mode, (N, N)) for mode in modes]),
        "eight fields, scipy.fft, two workers": lambda: ms_of(
            lambda: scipy.fft.irfft2(modes, (N, N), workers=2, overwrite_x=False)
        ),
    }
    times = {name: [] for name in tasks}
    for run in range(RUNS + 2):  # two to warm up
        for name, task in tasks.items():
            took_ms = task()
            if run >= 2:
                times[name].append(took_ms)
    median = {name: statistics.median(values) for name, values in times.items()}
    ratios = {
        "samples, Python over C++ (at most 1.05)": median["sample, Python"] / median["sample, C++"],
        "displacement, Python over C++ (at most 1.10)": median["frame with displacement, Python"]
        / median["frame with displacement, C++"],
        "three fields over one (at most 1.3)": median["frame with displacement, Python"] / median["frame with one field"],
        "numpy.fft over eight fields (at least 5)": median["eight fields, numpy.fft"] / median["frame with eight fields"],
        "scipy.fft over eight fields (at least 3)": median["eight fields, scipy.fft, two workers"]
        / median["frame with eight fields"],
    }
    if "--json" in sys.argv:
        print(json.dumps({"median_ms": median, "ratio": ratios}, indent=1))
        return
    for name, value in median.items():
        print(f"{name:45} {value:8.2f} ms")
    for name, value in ratios.items():
        print(f"{name:45} {value:8.2f}")


if __name__ == "__main__":
    main()
