# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Tables of docs/results.md: rows of offing-bench beside one another and beside the figures that papers print."""

import math
import re

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

# Do, Baek, Lee & Ryu 2009 on a Pentium 4 at 3.2 GHz with a GeForce 6600, 1280 x 1024: particles -> frames a second; None: an
# example whose frames are not printed.
PAPER_CLOUDS = {
    100: 400, 108: None, 128: None, 193: None, 946: None, 1000: 251, 1321: None, 1325: None, 1998: None, 2000: 201, 2449: None,
    2568: None, 3000: 140, 30000: None,
}


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


def clouds_paper_table(rows):
    ours = {(row["name"].removeprefix("clouds_"), row["size"]): row["ours_ms"] for row in rows}
    made = {name: [row for row in rows if row["name"] == f"clouds_{name}"] for name in ("sample", "grow")}
    lines = []
    for index, (count, fps) in enumerate(PAPER_CLOUDS.items()):
        # Made clouds have about as many particles as asked for, in the same order.
        making = [number(made[name][index]["ours_ms"], 0) for name in ("sample", "grow")]
        parts = [number(ours[name, count], 2) for name in ("relight", "see", "sort", "draw")]
        frames_ms = [ours.get((name, count)) for name in ("frame_360", "frame_1024")]
        lines.append([str(count), number(fps, 0), *making, *parts, *(number(ms and 1000 / ms, 1) for ms in frames_ms)])
    return table(
        ["n", "paper fps", "sampled", "grown", "relight", "see", "sort", "draw", "fps 640 x 360", "fps 1280 x 1024"], lines
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
