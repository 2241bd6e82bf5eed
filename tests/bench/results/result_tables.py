# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Tables of docs/results.md: a summary of all benchmarks, and the papers' figures beside ours."""

import collections

from series import ours, paper, series

# names: of rows that are summed up, as series() has it; limit_ms: what Offing must not exceed, or None.
Summary = collections.namedtuple("Summary", "what names peer several limit_ms", defaults=("", "fastest peer", None))

# Benchmark -> what its sizes count, and its lines of the table.
SUMMARIES = {
    "fft": ("samples", [
        Summary("complex transform, 16 queued", "fft|fft_batch16", "FFTW"),
    ]),
    "ocean": ("samples", [
        Summary("ocean frame, one cascade", "ocean", "C++ and FFTW"),
        Summary("ocean frame, three cascades", "ocean_3_cascades", "C++ and FFTW"),
        Summary("new process to its first frame, kernels not cached", "cold_start"),
        Summary("the same, kernels cached", "warm_start", limit_ms=300),
    ]),
    "gerstner": ("points", [
        Summary("16 Gerstner waves, 16 queued", "gerstner", "C++ by hand"),
    ]),
    "queries": ("samples", [
        Summary("100,000 points of the water", "queries", "C++", limit_ms=20),
    ]),
    "previews": ("samples", [
        Summary("preview of a baked frame", "preview"),
        Summary("contact sheet of 24 frames", "preview_sheet"),
    ]),
    "render": ("", [
        Summary("frame of scenes/rough.toml, 640 x 360", "render_rough"),
        Summary("frame of scenes/valley_fly.toml, 1280 x 720", "render_valley_fly_720"),
    ]),
    "terrain": ("posts", [
        Summary("maximum mipmap", "terrain_build_valleys", "Embree"),
        Summary("map loaded from heights in host memory", "terrain_load_valleys", "Embree"),
        Summary("1280 x 720 rays, flying", "terrain_fly_valleys", "Embree", "mean"),
        Summary("1280 x 720 rays, walking", "terrain_walk_valleys", "Embree", "mean"),
        Summary("the same over real maps", "terrain_(fly|walk)_(andes|cape_flattery)", "Embree", "mean"),
        Summary("frame, flying", "terrain_frame_fly_valleys"),
    ]),
    "viewshed": ("posts", [
        Summary("viewshed, flat Earth", "viewshed_(valleys|andes|cape_flattery)", "GDAL, one core", "mean"),
        Summary("viewshed, curved Earth", "viewshed_.*_curved", "GDAL, one core", "mean"),
    ]),
    "curvature": ("", [
        Summary("curvature of 32,768 vertices, fit", "curvature_fit", "CGAL, one core"),
        Summary("curvature, diffused", "curvature_diffused", "CGAL, one core"),
        Summary("curvature, diffused, OpenCL", "curvature_opencl", "CGAL, one core"),
    ]),
    "highlights": ("faces", [
        Summary("search for highlights", "highlights_search_.*", "C++, one core"),
        Summary("frame, without drawing", "highlights_frame_.*"),
    ]),
    "clouds": ("particles", [
        Summary("cloud grown", "clouds_grow"),
        Summary("drawn, 640 x 360", "clouds_draw"),
        Summary("frame, 640 x 360", "clouds_frame_360"),
        Summary("frame, 1280 x 1024", "clouds_frame_1024"),
        Summary("volume of 512^3 cells, to a file", "clouds_vdb_512"),
    ]),
    "wake": ("cells", [
        Summary("wake step, dispersive", "wake_dispersive", "C++ and FFTW"),
        Summary("wake step, Verlet", "wake_verlet", "the above"),
    ]),
    "world": ("", [Summary("frame of scenes/world.toml, 640 x 360", "world_frame", "sum of its parts")]),
}  # fmt: skip


def table(heading, lines):
    rule = "|" + "---|" * len(heading)
    return "\n".join(["| " + " | ".join(heading) + " |", rule, *("| " + " | ".join(line) + " |" for line in lines)])


def digits(value):
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"


def ends(values, text=digits):
    """The first and the last of the values, those of the smallest and the largest size; a dash where there is none."""
    if not values or None in values:
        return "-"
    first, last = text(values[0]), text(values[-1])
    return first if first == last else f"{first} to {last}"


def limit(limit_ms, values):
    """The limit, and where it is exceeded."""
    worst = max(values, key=lambda value: value.ours_ms)
    return digits(limit_ms) + (f"; {digits(worst.ours_ms)} at {worst.size:,}" if worst.ours_ms > limit_ms else "")


def summary_table(rows, run_numbers):
    """run_numbers: benchmark -> number of its run."""
    lines = []
    for benchmark, (unit, summaries) in SUMMARIES.items():
        for summary in summaries:
            values = series(rows[benchmark], summary.names, summary.several)
            if not values:
                continue
            _, times_ms, _, ratios = zip(*values)
            lines.append([
                f"[{benchmark}](results/{benchmark}.csv)",
                summary.what,
                ends([value.size for value in values], "{:,}".format) + f" {unit}" if unit else "-",
                ends(times_ms),
                summary.peer or "-",
                ends(ratios, "{:.2f}".format) if summary.peer else "-",
                limit(summary.limit_ms, values) if summary.limit_ms else "-",
                run_numbers[benchmark],
            ])  # fmt: skip
    return table(["benchmark", "what", "size", "ours ms", "peer", "ratio", "limit ms", "run"], lines)


# Paper, what it measured, and the benchmark and names of our rows.
PAPERS = (
    ("Lee & Lee 2007", "transform", "fft", "fft|fft_batch16"),
    ("Lee & Lee 2007", "simulation", "ocean", "ocean"),
    ("Lee & Lee 2007", "simulation and drawing", "render", "render_paper"),
    ("Park, Oh & Cho 2007", "preprocessing", "terrain", "terrain_load_valleys"),
    ("Park, Oh & Cho 2007", "frame, flying", "terrain", "terrain_frame_fly_valleys"),
    ("Park, Oh & Cho 2007", "frame, walking", "terrain", "terrain_frame_walk_valleys"),
    ("Lee & Choi 2006", "frame, torus knot", "highlights", "highlights_frame_knot"),
    ("Lee & Choi 2006", "frame, Karlos", "highlights", "highlights_frame_fine_knot"),
    ("Do, Baek, Lee & Ryu 2009", "frame", "clouds", "clouds_frame_1024"),
)
GPU, CPU = "GeForce|Radeon", "Pentium|CPU"


def papers_table(rows, papers):
    """Times at the smallest and the largest size that the paper prints; ours of those sizes, or of the nearest."""
    lines = []
    for name, measured, benchmark, names in PAPERS:
        here = ours(rows[benchmark], names)
        if not here:
            continue
        on_gpu, on_cpu = (paper(papers, name, measured, processor) for processor in (GPU, CPU))
        sizes = [size for size, _ in on_gpu or on_cpu]
        beside_ms = [min(here, key=lambda point: abs(point[0] - size))[1] for size in (sizes[0], sizes[-1])]
        times = [ends([ms for _, ms in curve]) for curve in (on_gpu, on_cpu)]
        lines.append([name, measured, ends(sizes, "{:,}".format), *times, ends(beside_ms)])
    return table(["paper", "measured", "size", "its GPU ms", "its CPU ms", "ours ms"], lines)
