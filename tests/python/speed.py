"""speed.py PEER [--json]: what the Python package costs beside C++ (speed_peer.cpp), numpy.fft and scipy.fft, in medians of
20 interleaved blocks on a quiet machine. Each block repeats one task, as those of offing-bench do: just after another process
has run, the scheduler may have put both threads of the device on one core, which takes some milliseconds to correct."""

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


def block_ms(call, warm_up_s=0.015, block_s=0.030):
    """The median of what a call takes, repeated for a block after a warm-up."""
    took_s = []
    begin = time.perf_counter()
    while time.perf_counter() - begin < warm_up_s:
        call()
    begin = now = time.perf_counter()
    while now - begin < block_s:
        before, _ = now, call()
        now = time.perf_counter()
        took_s.append(now - before)
    return 1e3 * statistics.median(took_s)


class NumpySea:
    """The same eight fields by transforms of numpy or scipy, as one would write it: amplitudes h0(K) turned to a time,
    h = h0(K) exp(i w t) + h0*(-K) exp(-i w t), and a field for each factor of h. `transform` takes the spectra of all
    fields [8, n, n / 2 + 1]."""

    def __init__(self, transform, dtype):
        random = np.random.default_rng(1)
        shape = (N, N // 2 + 1)
        draw = lambda: (random.standard_normal(shape) + 1j * random.standard_normal(shape)).astype(dtype)  # noqa: E731
        self.amplitude, self.opposite = draw(), draw().conj()
        kx = np.arange(N // 2 + 1)[None, :] * (2.0 * np.pi / 1000.0)
        kz = np.fft.fftfreq(N, 1.0 / N)[:, None] * (2.0 * np.pi / 1000.0)
        k = np.maximum(np.hypot(kx, kz), 1e-9)
        self.omega = np.sqrt(9.81 * k).astype(self.amplitude.real.dtype)
        one = np.ones(shape)
        factors = [1j * kx / k, one, 1j * kz / k, 1j * kx * one, 1j * kz * one, kx * kx / k, kx * kz / k, kz * kz / k]
        self.factors = np.stack(factors).astype(dtype)
        self.transform = transform

    def at(self, time_s):
        turn = np.exp(1j * self.omega * self.omega.dtype.type(time_s))
        height = self.amplitude * turn + self.opposite * turn.conj()
        return self.transform(self.factors * height)


def main():
    cpp = Cpp(sys.argv[1])
    world = offing.World(TEXT)
    i = np.arange(SAMPLES)
    points = np.column_stack([0.37 * (i % 1000), 0.41 * (i // 1000)])
    seas = {
        "numpy.fft": NumpySea(lambda modes: [np.fft.irfft2(mode, (N, N)) for mode in modes], np.complex128),
        "numpy.fft, single": NumpySea(lambda modes: [np.fft.irfft2(mode, (N, N)) for mode in modes], np.complex64),
        "scipy.fft, two workers": NumpySea(lambda modes: scipy.fft.irfft2(modes, (N, N), workers=2), np.complex128),
        "scipy.fft, two workers, single": NumpySea(lambda modes: scipy.fft.irfft2(modes, (N, N), workers=2), np.complex64),
    }
    now = [0.0]

    def frame(names):
        now[0] += 0.1
        return world.at(now[0]).fields(names)

    tasks = {
        "sample, C++": lambda: cpp.ms("sample"),
        "sample, Python": lambda: block_ms(lambda: world.sample(points)),
        "frame with displacement, C++": lambda: cpp.ms("frame_and_displacement"),
        "frame with displacement, Python": lambda: block_ms(lambda: frame(ALL[:3])),
        "frame with one field": lambda: block_ms(lambda: frame(ALL[1:2])),
        "frame with eight fields": lambda: block_ms(lambda: frame(ALL)),
    }
    for name, sea in seas.items():
        tasks[f"eight fields, {name}"] = lambda sea=sea: block_ms(lambda: sea.at(3.0))
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
    }
    for name in seas:
        least = 5 if name.startswith("numpy") else 3
        ratios[f"{name} over ours (at least {least})"] = median[f"eight fields, {name}"] / median["frame with eight fields"]
    if "--json" in sys.argv:
        print(json.dumps({"median_ms": median, "ratio": ratios}, indent=1))
        return
    for name, value in median.items():
        print(f"{name:45} {value:8.2f} ms")
    for name, value in ratios.items():
        print(f"{name:45} {value:8.2f}")


if __name__ == "__main__":
    main()
