# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Plots of docs/results.md as scripts of gnuplot: how times grow with size, and what frames are made of."""

import collections
import subprocess

from series import ours, paper, peers, ratios

BLUE, ORANGE, GREEN, PINK, SKY, YELLOW, GREY, BLACK = (
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#888888", "#222222",
)  # fmt: skip
# Line and point of what a curve shows: ours, the peer here, the paper.
OURS, PEER, PAPER = "dt 1 lw 2 pt 7", "dt 2 lw 1.5 pt 5", "dt 3 lw 1.5 pt 9"

Curve = collections.namedtuple("Curve", "title color style points")
Panel = collections.namedtuple("Panel", "title across up curves")

EQUAL_AT_ONE = "peer ms / Offing ms"

# The background is white on dark pages too.
HEADING = """set terminal svg size {width},{height} font "sans-serif,13" background "white"
set border 3 lc rgb "#333333"
set tics nomirror
set grid lc rgb "#dddddd" lt 1
set key Left reverse samplen 3 spacing 1.15 {key}
"""


def label(value):
    """100, 1000, 10k, 1M."""
    return f"{value / 1e6:g}M" if value >= 1e6 else f"{value / 1e3:g}k" if value >= 1e4 else f"{value:g}"


def axis(name, values, room, is_doubled=False):
    """Range and tics of a logarithmic axis: powers of ten, also 2 and 5 times these on a short one, or of two."""
    low, high = min(values) / room, max(values) * room
    if is_doubled:
        tics = [2**power for power in range(6, 13)]
    else:
        is_short = high / low < 300
        tics = [digit * 10.0**power for power in range(-4, 8) for digit in ((1, 2, 5) if is_short else (1,))]
    texts = ", ".join(f'"{label(tic)}" {tic:g}' for tic in tics if low <= tic <= high)
    return f"set {name}range [{low:.6g}:{high:.6g}]\nset {name}tics ({texts})\n"


def panel_script(panel, first_index):
    """Data and plot command of a panel on logarithmic axes; curves without points are left out."""
    curves = [curve for curve in panel.curves if curve.points]
    data = "".join(
        f"$curve_{index} << end\n" + "".join(f"{size} {value:.4g}\n" for size, value in curve.points) + "end\n"
        for index, curve in enumerate(curves, first_index)
    )
    lines = [
        f'$curve_{index} using 1:2 with linespoints {curve.style} ps 0.5 lc rgb "{curve.color}" title "{curve.title}"'
        for index, curve in enumerate(curves, first_index)
    ]
    if panel.up == EQUAL_AT_ONE:
        lines.insert(0, f'1 with lines lw 1.5 lc rgb "{GREY}" notitle')
    sizes, values = zip(*(point for curve in curves for point in curve.points))
    return (
        f'{data}set title "{panel.title}"\nset xlabel "{panel.across}" offset 0,0.6\nset ylabel "{panel.up}"\nset logscale xy\n'
        + axis("x", sizes, 1.25, panel.across.endswith("a side"))
        + axis("y", values, 1.4)
        + "plot "
        + ", \\\n  ".join(lines)
        + "\n"
    )


def curves_script(panels):
    # One panel has its key at the right, two have theirs below.
    key, width, height = ("outside right center", 760, 400) if len(panels) == 1 else ("below maxrows 3", 960, 460)
    heading = HEADING.format(width=width, height=height, key=key)
    scripts = [panel_script(panel, 100 * index) for index, panel in enumerate(panels)]
    return heading + f"set multiplot layout 1,{len(panels)}\n" + "".join(scripts) + "unset multiplot\n"


def ratios_panels(rows, papers):
    return [Panel("How much faster than the peer", "samples, posts or cells a side", EQUAL_AT_ONE, [
        Curve("transform, FFTW", BLUE, OURS, ratios(rows["fft"], "fft|fft_batch16")),
        Curve("ocean frame, C++ and FFTW", ORANGE, OURS, ratios(rows["ocean"], "ocean")),
        Curve("16 Gerstner waves, C++ by hand", GREEN, OURS, ratios(rows["gerstner"], "gerstner")),
        Curve("queries, C++", PINK, OURS, ratios(rows["queries"], "queries")),
        Curve("terrain rays flying, Embree", BLACK, OURS, ratios(rows["terrain"], "terrain_fly_valleys", "mean")),
        Curve("terrain rays walking, Embree", GREY, OURS, ratios(rows["terrain"], "terrain_walk_valleys", "mean")),
        Curve("wake step, C++ and FFTW", YELLOW, OURS, ratios(rows["wake"], "wake_dispersive")),
    ])]  # fmt: skip


def ocean_panels(rows, papers):
    def panel(title, ours_rows, names, measured):
        return Panel(title, "samples a side", "ms", [
            Curve("Offing", BLUE, OURS, ours(ours_rows, names)),
            Curve("FFTW here", ORANGE, PEER, peers(ours_rows, names)),
            Curve("paper, GPU", GREY, PAPER, paper(papers, "Lee & Lee", measured, "GeForce")),
            Curve("paper, CPU", BLACK, PAPER, paper(papers, "Lee & Lee", measured, "Pentium")),
        ])  # fmt: skip

    return [
        panel("One complex transform", rows["fft"], "fft|fft_batch16", "transform"),
        panel("One ocean frame, without drawing", rows["ocean"], "ocean", "simulation"),
    ]


def terrain_panels(rows, papers):
    terrain = rows["terrain"]
    return [
        Panel("Rays of 1280 x 720 pixels", "posts a side", "ms", [
            Curve("Offing, flying", BLUE, OURS, ours(terrain, "terrain_fly_valleys", "mean")),
            Curve("Embree, flying", BLUE, PEER, peers(terrain, "terrain_fly_valleys", "mean")),
            Curve("Offing, walking", ORANGE, OURS, ours(terrain, "terrain_walk_valleys", "mean")),
            Curve("Embree, walking", ORANGE, PEER, peers(terrain, "terrain_walk_valleys", "mean")),
        ]),
        Panel("Whole frames, beside the paper's", "posts a side", "ms", [
            Curve("Offing, flying", BLUE, OURS, ours(terrain, "terrain_frame_fly_valleys")),
            Curve("paper, flying", BLUE, PAPER, paper(papers, "Park", "frame, flying")),
            Curve("Offing, walking", ORANGE, OURS, ours(terrain, "terrain_frame_walk_valleys")),
            Curve("paper, walking", ORANGE, PAPER, paper(papers, "Park", "frame, walking")),
        ]),
    ]  # fmt: skip


def steps_panels(rows, papers):
    methods = (("parity", "Offing", BLUE, OURS), ("picture", "Offing, packets", SKY, OURS),
               ("paper", "the paper's", BLACK, PAPER), ("pdm", "never up", GREEN, PEER),
               ("linear", "patch by patch", ORANGE, PEER))  # fmt: skip

    def panel(title, way):
        def steps(method):
            name = f"terrain_{way}_valleys_{method}"
            return [(row["size"], row["steps_mean"]) for row in rows["terrain"] if row["name"] == name]

        curves = [Curve(label, color, style, steps(method)) for method, label, color, style in methods]
        return Panel(title, "posts a side", "mean steps of a ray", curves)

    return [panel("Steps of rays, flying", "fly"), panel("Steps of rays, walking", "walk")]


def highlights_panels(rows, papers):
    highlights = rows["highlights"]
    return [Panel("Highlights", "faces", "ms", [
        Curve("search, Offing", BLUE, OURS, ours(highlights, "highlights_search_.*")),
        Curve("search, C++ on one core", BLUE, PEER, peers(highlights, "highlights_search_.*")),
        Curve("frame without drawing, Offing", ORANGE, OURS, ours(highlights, "highlights_frame_.*")),
        Curve("frame with drawing, paper", ORANGE, PAPER, paper(papers, "Lee & Choi", "frame.*")),
    ])]  # fmt: skip


def clouds_panels(rows, papers):
    clouds = rows["clouds"]
    parts = (("sample", "sample", PINK), ("grow", "grow", GREEN), ("draw", "draw", BLUE), ("see", "light to the eye", ORANGE),
             ("relight", "light from the sun", YELLOW), ("sort", "sort", GREY))  # fmt: skip
    return [
        Panel("Making a cloud and drawing it", "particles", "ms", [
            Curve(title, color, OURS, ours(clouds, f"clouds_{part}")) for part, title, color in parts
        ]),
        Panel("Whole frames with a cloud", "particles", "ms", [
            Curve("Offing on a CPU, 640 x 360", BLUE, OURS, ours(clouds, "clouds_frame_360")),
            Curve("Offing on a CPU, 1280 x 1024", ORANGE, OURS, ours(clouds, "clouds_frame_1024")),
            Curve("paper on a GPU, 1280 x 1024", ORANGE, PAPER, paper(papers, "Do,", "frame")),
        ]),
    ]  # fmt: skip


def wakes_panels(rows, papers):
    return [Panel("One step of a wake window", "cells a side", "ms", [
        Curve("dispersive", BLUE, OURS, ours(rows["wake"], "wake_dispersive")),
        Curve("Verlet", ORANGE, OURS, ours(rows["wake"], "wake_verlet")),
        Curve("dispersive, C++ and FFTW", BLUE, PEER, peers(rows["wake"], "wake_dispersive")),
    ])]  # fmt: skip


# Frames of 640 x 360 pixels: name of the row, and what stands below its bar.
FRAMES = (
    ("render_valley_fly_360", "valley,\\nflying"),
    ("render_valley_walk_360", "valley,\\nwalking"),
    ("clouds_frame_alone", "clouds"),
    ("render_rough", "rough\\nsea"),
    ("clouds_frame_cumulus", "sea and\\nclouds"),
    ("world_frame", "world"),
)
STAGES = (
    ("simulate", BLUE), ("terrain", GREEN), ("transfer", GREY), ("sky", SKY), ("water", "#004a73"), ("meshes", ORANGE),
    ("clouds", PINK), ("tone", YELLOW),
)  # fmt: skip


def frames_script(rows):
    """Bars of stages, one on top of the other, and a mark at the time of the whole frame."""
    ms = {row["name"]: row["ours_ms"] for benchmark in ("render", "clouds", "world") for row in rows[benchmark]}
    frames = [(name, label) for name, label in FRAMES if name in ms]
    data = "".join(
        f'"{label}" ' + " ".join(f"{ms.get(f'{name}_{stage}', 0):.4g}" for stage, _ in STAGES) + f" {ms[name]:.4g}\n"
        for name, label in frames
    )
    bars = [f'$frames using {column} lc rgb "{color}" title "{stage}"' for column, (stage, color) in enumerate(STAGES, 2)]
    bars[0] = bars[0].replace("using 2", "using 2:xtic(1)")
    # A white ring, so that the mark is seen on every colour.
    at = f"$frames using 0:{len(STAGES) + 2} with points pt 7"
    marks = [f'{at} ps 0.9 lc rgb "white" notitle', f'{at} ps 0.6 lc rgb "{BLACK}" title "whole frame"']
    return (
        f"$frames << end\n{data}end\n"
        + HEADING.format(width=860, height=440, key="outside right center invert vertical")
        + 'set bmargin 4\nset style data histograms\nset style histogram rowstacked\n'
        + 'set style fill solid 0.9 noborder\nset boxwidth 0.6\nset title "Stages of a frame, 640 x 360 pixels"\n'
        + 'set ylabel "ms"\nset yrange [0:*]\nset grid noxtics ytics\nplot '
        + ", \\\n  ".join([*bars, *marks])
        + "\n"
    )


PANELS = {
    "ratios": ratios_panels,
    "ocean": ocean_panels,
    "terrain": terrain_panels,
    "steps": steps_panels,
    "highlights": highlights_panels,
    "clouds": clouds_panels,
    "wakes": wakes_panels,
}


def scripts(rows, papers):
    """Name of a plot -> what gnuplot draws it from. rows: benchmark -> its rows, none for those without a file."""
    curves = {name: curves_script(panels(rows, papers)) for name, panels in PANELS.items()}
    return {**curves, "frames": frames_script(rows)}


def drawn(script):
    """The SVG, as bytes."""
    return subprocess.run(["gnuplot"], input=script.encode(), stdout=subprocess.PIPE, check=True).stdout
