# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Plots of docs/results.md: how times grow with size, ours beside those of peers and papers, by gnuplot."""

import math
import subprocess

import result_tables as tables

HEADING = """set terminal svg size 720,420 font "sans,11" background "white"
set logscale xy
set format y "%g"
set xlabel "{across}"
set ylabel "ms"
set grid
set key outside right top
set output "{path}"
"""


def gnuplot_script(path, across, curves):
    """curves: name -> [(size, ms)]; those without points are left out."""
    drawn = {name: sorted(points) for name, points in curves.items() if points}
    data = [f"$curve_{index} << end\n" + "".join(f"{size} {ms:.6g}\n" for size, ms in of) + "end\n"
            for index, of in enumerate(drawn.values())]
    lines = [f'$curve_{index} using 1:2 with linespoints lw 1.5 pt 7 ps 0.5 title "{name}"'
             for index, name in enumerate(drawn)]
    return "".join(data) + HEADING.format(path=path, across=across) + "plot " + ", \\\n  ".join(lines) + "\n"


def plot(path, across, curves):
    path.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["gnuplot"], input=gnuplot_script(path, across, curves), check=True, text=True)


def points(rows, name, key="ours_ms"):
    """Sizes and times of the rows of this name; of several of a size their geometric mean."""
    times = {}
    for row in rows:
        if row["name"] == name and row[key]:
            times.setdefault(row["size"], []).append(row[key])
    return [(size, tables.geometric_mean(of)) for size, of in times.items()]


def paper_points(fps):
    """fps: size -> frames a second, a number or a text such as "47 to 56"."""
    found = []
    for size, value in fps.items():
        if value is None:
            continue
        ends = [float(end) for end in str(value).split(" to ")]
        found.append((size, 1000 * len(ends) / sum(ends)))
    return found


def growth(points):
    """The power of the size that a time grows by, from the smallest size to the largest."""
    (small, small_ms), (large, large_ms) = min(points), max(points)
    return math.log(large_ms / small_ms) / math.log(large / small)


def growths(curves):
    return "; ".join(f"{name} {growth(of):.2f}" for name, of in curves.items() if len(of) > 1)


def one_transform(rows):
    """Rows of batches as rows of one transform."""
    return [{**row, "name": "fft", "ours_ms": row["ours_ms"] / 16, "peer_ms": row["peer_ms"] / 16}
            if row["name"] == "fft_batch16" else row for row in rows]


def ocean_curves(transforms, simulation):
    transforms = one_transform(transforms)
    return {
        "frame": points(simulation, "ocean"),
        "frame, FFTW": points(simulation, "ocean", "peer_ms"),
        "frame, paper's CPU": paper_points({n: fps[1] for n, fps in tables.PAPER_SIMULATION_FPS.items()}),
        "frame, paper's GPU": paper_points({n: fps[0] for n, fps in tables.PAPER_SIMULATION_FPS.items()}),
        "transform": points(transforms, "fft"),
        "transform, FFTW": points(transforms, "fft", "peer_ms"),
        "transform, paper's CPU": paper_points({n: fps[1] for n, fps in tables.PAPER_TRANSFORM_FPS.items()}),
        "transform, paper's GPU": paper_points({n: fps[0] for n, fps in tables.PAPER_TRANSFORM_FPS.items()}),
    }


def terrain_curves(rows):
    return {
        "frame, flying": points(rows, "terrain_frame_fly_valleys"),
        "frame, walking": points(rows, "terrain_frame_walk_valleys"),
        "paper, flying": paper_points({n: paper[1] for n, paper in tables.PAPER_TERRAIN.items()}),
        "paper, walking": paper_points({n: paper[2] for n, paper in tables.PAPER_TERRAIN.items()}),
        "preprocessing": points(rows, "terrain_load_valleys"),
        "paper, preprocessing": [(n, 1000 * paper[0]) for n, paper in tables.PAPER_TERRAIN.items()],
    }


def highlights_curves(rows):
    frames = [row for row in rows if row["name"].startswith("highlights_frame_")]
    searches = [row for row in rows if row["name"].startswith("highlights_search_")]
    paper = {int(faces): fps.split(" / ")[0] for faces, _, fps, _ in tables.PAPER_HIGHLIGHTS.values() if faces != "-"}
    return {
        "frame": [(row["size"], row["ours_ms"]) for row in frames],
        "search": [(row["size"], row["ours_ms"]) for row in searches],
        "search, loop in C++": [(row["size"], row["peer_ms"]) for row in searches if row["peer_ms"]],
        "paper, with drawing": paper_points(paper),
    }


def clouds_curves(rows):
    curves = {what: points(rows, f"clouds_{what}") for what in ("sample", "grow", "relight", "see", "sort", "draw")}
    return {**curves, "paper, frame": paper_points(tables.PAPER_CLOUDS)}
