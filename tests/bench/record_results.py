# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Runs all benchmarks and prints docs/results.md. On a machine that does nothing else:
python3 tests/bench/record_results.py build/bin > docs/results.md"""

import datetime
import json
import math
import os
import pathlib
import re
import subprocess
import sys

# Frames a second that Lee & Lee 2007 print, tables 2 and 3: size -> (GeForce 6800 Ultra, Pentium 4 at 3 GHz with FFTW).
PAPER_TRANSFORM_FPS = {64: (1925, 3300), 128: (600, 970), 256: (178, 222), 512: (39, 13), 1024: (8, 3)}
PAPER_RENDER_FPS = {64: (48, 14), 128: (37, 14), 256: (28, 12), 512: (14, 2)}
PAPER_SIMULATION_FPS = {64: (399, 75), 128: (220, 52), 256: (85, 23), 512: (21, 3), 1024: (4, 0.8)}

# Park, Oh & Cho 2007, on a Radeon 2900 and a CPU at 2.33 GHz: size -> (preprocessing s, frames a second that fly, that walk).
PAPER_TERRAIN = {
    256: (0.7, "105 to 115", "55 to 98"),
    512: (2.0, "69 to 99", "54 to 85"),
    1024: (4.5, "53 to 75", "40 to 82"),
    2048: (11, "47 to 56", "37 to 80"),
    4096: (45, "40 to 44", "32 to 67"),
}

# Lee & Choi 2006 on an Athlon XP 3200 with a GeForce 7800, drawing included: mesh -> (faces, highlights, frames a second),
# and our mesh of about that size.
PAPER_HIGHLIGHTS = {
    "sphere": ("-", "1", "2164", "sphere"),
    "torus knot": ("2880", "6 / 7", "808 / 750", "knot"),
    "Karlos": ("23829", "9 / 11", "147 / 137", "fine_knot"),
}

PAGE = """# Results

Written by `tests/bench/record_results.py`; `tests/bench/README.md` says how things are measured and what the
peers are.

## Machine

{machine}

## Transform, frame, trochoids and queries

`offing-bench fft`, `ocean`, `gerstner` and `queries`: medians of {blocks} interleaved blocks. Ratio = peer / ours, above 1
ours is faster; low = lower bound of the ratio's 95 % confidence interval; spread = interquartile range of the
blocks' ratios over their median. `fft_batch16` times 16 transforms at once, `ocean_3_cascades` three cascades;
`gerstner` 16 waves on n x n points; `_alone` waits for the device after each transform or surface, where the
others are queued 16 in a row. `queries` is one call for 100,000 points of a sea with 16 waves and two cascades of
n x n, transfers included (`queries_surface`: without velocity and pressure); 20 ms are 5 million points a second.

{rows}

## Frames of the presenter

`offing-bench render`, drawn by {renderer}. `render_rough` is scenes/rough.toml as its window draws it, 640 x 360
pixels, three cascades of 256 x 256 and 64 Gerstner waves; `render_valley_fly` and `render_valley_walk` are those scenes of ground, of so
many lines. The rows below each are its stages, one by one, which add up to more, since stages overlap where nobody waits
for their ends.

{frames}

## Terrain

`offing-bench terrain`: primary rays of the cameras of scenes/bench_terrain.toml, 1280 x 720, to distances, against the best way to
cast the same rays with Embree 3; a row a camera, four that fly (300, 1000, 2000 and 4000 m above the highest post) and four that
walk. `terrain_build` is the pyramid against Embree's grid, `terrain_load` all from heights in host memory on. Geometric means of
the ratios: {terrain_means}.

{terrain}

Steps, iterations of a ray's walk, of the same cameras' rays, every method (`paper`: T4 and T5 as printed; `pdm`: never up; `linear`:
patch by patch; `picture`: the default's packets of pixels on a CPU, a ray's share), and the milliseconds of four pictures:

{terrain_steps}

Park, Oh & Cho (2007) print frames a second on a Radeon 2900 and seconds of preprocessing on a CPU at 2.33 GHz; ours are whole
frames, rays and light, on the CPU named above, over the same made ground at every size, one ray a pixel (`smooth_frame`: with edges
smoothed). From 256 to 4096 {terrain_growth}; the paper's frame takes about 2.5 times as long:

{terrain_paper}

## Viewsheds

`offing-bench viewshed`: which posts of a whole map an eye 30 m above the ground sees, into host memory, on a flat and on the curved Earth,
against `GDALViewshedGenerate`, which runs on one core and is approximate.

{viewsheds}

## Highlights

`offing-bench curvature`: all vertices of a torus with noise, n x n / 2 of them, against CGAL's jet fitting on one core:

{curvature}

`offing-bench highlights`: a search for highlight points against a loop over the faces on one core, and whole frames of meshes that
turn: search, tracks, projectors and regions, without drawing. `size` is faces.

{highlights}

Lee & Choi (2006) print frames a second on an Athlon XP 3200 with a GeForce 7800, drawing included:

{highlights_paper}

## Beside the paper

Tables of Lee & Lee (2006, 2007), which print frames a second on a GeForce 6800 Ultra and on a Pentium 4 at 3 GHz
with FFTW; here in milliseconds. One complex two-dimensional transform (at 64 and 128 ours and FFTW here do 16 at
once, shown is a sixteenth):

{transforms}

Simulation only. The paper's frame is height, displacement and slopes by three transforms of one patch, with 16
Gerstner waves on 256 x 256 (GPU) or 64 x 64 (CPU) points; ours is one patch with eight fields by four
transforms, without Gerstner waves. The peer is the same frame as ours in C++ with FFTW:

{simulation}

Simulation and rendering: one patch, 16 Gerstner waves on 128 x 128 points, 1280 x 1024 pixels, on a graphics card
there; here {renderer}, sky, light and foam worked out for each pixel:

{rendering}
"""


def output_of(*command):
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, check=True, text=True).stdout


def machine_lines(programs):
    processor = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text()).group(1)
    memory_kib = int(re.search(r"MemTotal:\s*(\d+)", pathlib.Path("/proc/meminfo").read_text()).group(1))
    huge_pages = pathlib.Path("/sys/kernel/mm/transparent_hugepage/enabled").read_text().strip()
    devices = json.loads(output_of(programs / "offing", "devices", "--json"))
    device = next(device for device in devices if device["is_default"])
    fftw = output_of("pkg-config", "--modversion", "fftw3f").strip()
    kernel = ".".join(os.uname().release.split(".")[:2])  # what follows may name the machine
    return "\n".join(
        [
            f"- {datetime.date.today().isoformat()}, commit {output_of('git', 'rev-parse', '--short', 'HEAD').strip()}",
            f"- {processor}, {len(os.sched_getaffinity(0))} cores, {memory_kib / 2**20:.0f} GiB, "
            f"Linux {kernel}, transparent huge pages {huge_pages}",
            f"- OpenCL device: {device['name']} ({device['platform']} {device['driver_version']})",
            f"- {output_of('c++', '--version').splitlines()[0]}; FFTW {fftw}",
            f"- load of the machine before the run: {os.getloadavg()[0]:.1f}",
        ]
    )


def table(heading, lines):
    rule = "|" + "---|" * len(heading)
    return "\n".join(["| " + " | ".join(heading) + " |", rule, *("| " + " | ".join(line) + " |" for line in lines)])


def number(value, decimals):
    return "-" if value is None else f"{value:.{decimals}f}"


def rows_table(rows):
    return table(
        ["name", "n", "ours ms", "peer ms", "ratio", "low", "spread", "peer"],
        [
            [
                row["name"],
                str(row["size"]),
                number(row["ours_ms"], 4),
                number(row["peer_ms"], 4),
                number(row["ratio"], 2),
                number(row["ratio_low"], 2),
                f"{100 * row['spread']:.1f} %",
                row["peer"],
            ]
            for row in rows
        ],
    )


def paper_table(paper_fps, rows):
    lines = []
    for size, (gpu_fps, cpu_fps) in paper_fps.items():
        row = min((row for row in rows if row["size"] == size), key=lambda row: row["peer_ms"])
        batch = int(re.search(r"\d*$", row["name"]).group() or 1)
        times_ms = (1000 / gpu_fps, 1000 / cpu_fps, row["ours_ms"] / batch, row["peer_ms"] / batch)
        lines.append([str(size), *(f"{time_ms:.3g}" for time_ms in times_ms)])
    return table(["n", "paper GPU ms", "paper CPU ms", "ours ms", "peer here ms"], lines)


def frames_table(rows):
    return table(
        ["name", "n", "ms", "frames a second", "spread"],
        [
            [row["name"], str(row["size"]), number(row["ours_ms"], 2), number(1000 / row["ours_ms"], 1), f"{100 * row['spread']:.1f} %"]
            for row in rows
        ],
    )


def rendering_table(rows):
    return table(
        ["n", "paper GPU fps", "paper CPU fps", "ours fps"],
        [
            [str(row["size"]), *(str(fps) for fps in PAPER_RENDER_FPS[row["size"]]), number(1000 / row["ours_ms"], 1)]
            for row in rows
            if row["name"] == "render_paper"
        ],
    )


def cast_times_ms(rows, name, size):
    return [row["ours_ms"] for row in rows if row["name"] == name and row["size"] == size]


def geometric_mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


def terrain_means(rows):
    ratios = {}
    for row in rows:
        if row["ratio"] is not None and re.match("terrain_(fly|walk)_", row["name"]):
            ratios.setdefault(f"{row['name']} {row['size']}", []).append(row["ratio"])
    return ", ".join(f"{name} {geometric_mean(of):.2f}" for name, of in ratios.items())


def terrain_steps_table(rows):
    return table(
        ["rays", "posts a side", "mean", "90 %", "95 %", "99 %", "within 16", "over 80", "ms"],
        [
            [
                row["name"].removeprefix("terrain_"),
                str(row["size"]),
                f"{row['steps']['mean']:.1f}",
                *(str(row["steps"][share]) for share in ("of_90", "of_95", "of_99")),
                f"{100 * row['steps']['within_16']:.1f} %",
                f"{100 * row['steps']['over_80']:.2f} %",
                number(row["ours_ms"], 0),
            ]
            for row in rows
            if "steps" in row
        ],
    )


def terrain_paper_table(rows):
    lines = []
    for size, (load_s, fly_fps, walk_fps) in PAPER_TERRAIN.items():
        load_ms, *frames_ms = (
            cast_times_ms(rows, name, size + 1)[0]
            for name in ("terrain_load_valleys", "terrain_frame_fly_valleys", "terrain_frame_walk_valleys",
                         "terrain_smooth_frame_fly_valleys", "terrain_smooth_frame_walk_valleys")
        )
        fps = (f"{1000 / frame_ms:.0f}" for frame_ms in frames_ms)
        lines.append([str(size), f"{load_s:g}", fly_fps, walk_fps, f"{load_ms / 1000:.3g}", *fps])
    return table(
        ["n", "paper s", "paper fly fps", "paper walk fps", "ours s", "ours fly fps", "ours walk fps", "smooth fly fps", "smooth walk fps"],
        lines,
    )


def highlights_paper_table(rows):
    lines = []
    for mesh, (faces, count, fps, ours) in PAPER_HIGHLIGHTS.items():
        row = next(row for row in rows if row["name"] == f"highlights_frame_{ours}")
        our_count = re.search(r"([\d.]+) highlights", row["peer"]).group(1)
        lines.append([mesh, faces, count, fps, ours, str(row["size"]), our_count, number(1000 / row["ours_ms"], 0)])
    return table(
        ["paper", "faces", "highlights", "fps", "ours", "faces", "highlights", "fps, without drawing"], lines
    )


def terrain_growth(rows):
    smallest, largest = min(PAPER_TERRAIN) + 1, max(PAPER_TERRAIN) + 1
    growth = {
        f"{what} that {way}s": geometric_mean(cast_times_ms(rows, f"{name}_{way}_valleys", largest))
        / geometric_mean(cast_times_ms(rows, f"{name}_{way}_valleys", smallest))
        for what, name in (("a frame", "terrain_frame"), ("a cast", "terrain"))
        for way in ("fly", "walk")
    }
    return ", ".join(f"{name} becomes {times:.2f} times as long" for name, times in growth.items()).replace("flys", "flies")


def main(programs):
    machine = machine_lines(programs)
    blocks = 15
    transforms, frames, trochoids, queries = (
        json.loads(output_of(programs / "offing-bench", command, "--blocks", blocks, "--json"))
        for command in ("fft", "ocean", "gerstner", "queries")
    )
    sizes = ",".join(map(str, PAPER_RENDER_FPS))
    frames_drawn = json.loads(output_of(programs / "offing-bench", "render", "--sizes", sizes, "--json"))
    terrain = json.loads(
        output_of(programs / "offing-bench", "terrain", "--sizes", ",".join(map(str, PAPER_TERRAIN)), "--blocks", blocks, "--json")
    )
    viewsheds = json.loads(output_of(programs / "offing-bench", "viewshed", "--sizes", 1024, "--blocks", blocks, "--json"))
    curvature = json.loads(output_of(programs / "offing-bench", "curvature", "--sizes", "256,512", "--blocks", blocks, "--json"))
    highlights = json.loads(output_of(programs / "offing-bench", "highlights", "--blocks", blocks, "--json"))
    page = PAGE.format(
        curvature=rows_table(curvature),
        highlights=rows_table(highlights),
        highlights_paper=highlights_paper_table(highlights),
        viewsheds=rows_table(viewsheds),
        terrain=rows_table([row for row in terrain if "steps" not in row]),
        terrain_means=terrain_means(terrain),
        terrain_steps=terrain_steps_table(terrain),
        terrain_growth=terrain_growth(terrain),
        terrain_paper=terrain_paper_table(terrain),
        renderer=frames_drawn[0]["peer"],
        frames=frames_table([row for row in frames_drawn if not row["name"].startswith("render_paper")]),
        rendering=rendering_table(frames_drawn),
        machine=machine,
        blocks=blocks,
        rows=rows_table(transforms + frames + trochoids + queries),
        transforms=paper_table(
            PAPER_TRANSFORM_FPS, [row for row in transforms if not row["name"].endswith("_alone")]
        ),
        simulation=paper_table(PAPER_SIMULATION_FPS, [row for row in frames if row["name"] == "ocean"]),
    )
    print(page, end="")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
