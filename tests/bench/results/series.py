# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""One value a size from the rows of benchmarks and of papers, for tables and curves."""

import collections
import math
import re

TRANSFORMS_A_BATCH = 16

# A size with times in ms and their ratio, None where there is no peer.
Value = collections.namedtuple("Value", "size ours_ms peer_ms ratio")


def geometric_mean(values):
    return None if None in values else math.exp(sum(map(math.log, values)) / len(values))


def series(rows, names, several="fastest peer"):
    """Values of the rows whose whole name matches, by size. Of several rows a size take the one with the "fastest
    peer", or the geometric "mean", as of cameras and maps. Batches count as one transform."""
    of_size = collections.defaultdict(list)
    for row in rows:
        if re.fullmatch(names, row["name"]):
            share = TRANSFORMS_A_BATCH if "batch16" in row["name"] else 1
            peer_ms = row["peer_ms"] and row["peer_ms"] / share
            of_size[row["size"]].append(Value(row["size"], row["ours_ms"] / share, peer_ms, row["ratio"]))
    if several == "mean":
        return [Value(size, *(geometric_mean(column) for column in list(zip(*values))[1:]))
                for size, values in sorted(of_size.items())]  # fmt: skip
    return [min(values, key=lambda value: value.peer_ms or 0.0) for _, values in sorted(of_size.items())]


def ours(rows, names, several="fastest peer"):
    """Curve of our times: pairs of size and ms."""
    return [(value.size, value.ours_ms) for value in series(rows, names, several)]


def peers(rows, names, several="fastest peer"):
    return [(value.size, value.peer_ms) for value in series(rows, names, several) if value.peer_ms]


def ratios(rows, names, several="fastest peer"):
    return [(value.size, value.ratio) for value in series(rows, names, several) if value.ratio]


def printed_ms(line):
    """The time that a line of papers.csv prints; of a range of frames a second its middle."""
    if line["time_s"]:
        return 1000.0 * float(line["time_s"])
    return 2000.0 / (float(line["frames_per_s_low"]) + float(line["frames_per_s_high"]))


def paper(lines, paper_name, measured, processor=""):
    """Curve of a paper's times on the processors that match; the first of several lines a size."""
    curve = {}
    for line in lines:
        if line["paper"].startswith(paper_name) and re.fullmatch(measured, line["measured"]) and line["size"]:
            if re.match(processor, line["processor"]):
                curve.setdefault(int(line["size"]), printed_ms(line))
    return sorted(curve.items())


def growth(curve):
    """The power of the size that a time grows by, from the smallest size to the largest."""
    (small, small_ms), (large, large_ms) = curve[0], curve[-1]
    return math.log(large_ms / small_ms) / math.log(large / small)
