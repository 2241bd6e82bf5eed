# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Writes docs/results.md and its plots from the CSV files of docs/results. At the top of the sources:
python3 tests/bench/results/results_page.py"""

import argparse
import collections
import hashlib
import pathlib

import records
import result_plots
import result_tables
from series import growth, ours, paper

PAGE = """# Results

This page compares Offing's speed with other programs ("peers") and with the papers. `./dev bench` measures everything in an
hour on a quiet machine. `./dev bench --page` writes this page from the CSV files, which hold all rows.
[tests/bench/README.md](../tests/bench/README.md) describes each benchmark and its peer.

## How to read it

- Times are medians of interleaved blocks: Offing and its peer take turns in one process. Their results are compared
  first, before anything is timed.
- Ratio = peer / Offing: above 1 Offing is faster. If two peers do the same work, the faster one counts.
- "a to b" are the values at the smallest and at the largest size. Samples, points, posts and cells are counted along
  one side of a square.
- For several cameras or maps of one size, the table shows the geometric mean.
- In the CSV files, `ratio_low` is the lower bound of the ratio's 95 % confidence interval. `spread` is the interquartile
  range of the blocks' ratios over their median, or of our times where there is no peer.

## Runs

{runs}

This page was written from {row_count} rows; the SHA-256 of all CSV files begins with {digest}.

## Summary

{summary}

100,000 points in 20 ms are 5 million points per second. GDAL's viewshed is an approximation. The peer of a wake step gets what
the hull displaces as input; its water has the absorbing border too. The world's parts are drawn one by one, so that the sea of
"sum of its parts" mirrors no island and no clouds.

## Plots

![Ratio of the peer's time to Offing's over size](results/ratios.svg)

Above the line at 1, Offing is faster than its peer.

![Times of a transform and of an ocean frame](results/ocean.svg)

Times grow with n to the power {transform_growth} for a transform and {ocean_growth} for a frame.

![Times of terrain rays and frames](results/terrain.svg)

All maps show the same valleys. The time of a flying frame grows with n posts per side to the power {terrain_growth}, the paper's to
the power {terrain_paper_growth}.

![Steps of terrain rays by method](results/steps.svg)

A step is one iteration along a ray. "Never up" is pyramidal displacement mapping. "Packets" are 64 pixels that step together
on a CPU; each ray counts its share of the steps.

![Stages of frames](results/frames.svg)

{renderer} draws. The benchmark waits for each stage separately, so stages need not add up to the whole frame.

![Times of highlights](results/highlights.svg)

The time of the search grows with the number of faces to the power {search_growth}.

![Times of clouds](results/clouds.svg)

The cumulus covers half of the picture or more. Drawing time grows with the number of particles to the power {draw_growth}.

![Times of a wake step](results/wakes.svg)

The hull lies still, so that what it displaces is computed once. In a small window, most of a step's time goes to launching kernels.

## Beside the papers

The papers give frames per second on the hardware of their time ([papers.csv](results/papers.csv)). The table has times at
the smallest and the largest size that they give. Rows O15, T13, H12 and C16 of [sources.md](sources.md) describe how the
frames differ. The papers draw on a graphics card; here it is {renderer}.

{papers}
"""

# How a run's fields read in a sentence.
FIELDS = {
    "date": "{}",
    "commit": "commit {}",
    "processor": "{}",
    "load_before": "load {} before",
    "cores": "{} cores",
    "memory_gib": "{} GiB",
    "linux": "Linux {}",
    "huge_pages": "transparent huge pages {}",
    "opencl_platform": "{}",
    "compiler": "{}",
    "fftw": "FFTW {}",
}


def numbered_runs(runs):
    """Text, and benchmark -> number: benchmarks of the same day, commit and machine share one. What all have is said once."""
    benchmarks_of = collections.defaultdict(list)
    for benchmark, run in runs.items():
        benchmarks_of[tuple(run[field] for field in FIELDS)].append(benchmark)
    shared = [field for column, field in enumerate(FIELDS) if len({key[column] for key in benchmarks_of}) == 1]

    def text(key, fields):
        return ", ".join(FIELDS[field].format(value) for field, value in zip(FIELDS, key) if field in fields)

    lines = [f"All: {text(next(iter(benchmarks_of)), shared)}.", ""]
    numbers = {}
    for number, (key, benchmarks) in enumerate(benchmarks_of.items(), 1):
        lines.append(f"{number}. {', '.join(benchmarks)}: {text(key, set(FIELDS) - set(shared))}")
        numbers |= {benchmark: str(number) for benchmark in benchmarks}
    return "\n".join([*lines, "", "[runs.csv](results/runs.csv) has them as a table."]), numbers


def read(folder):
    """Benchmark -> its rows, none for those without a file; and what the papers print."""
    rows = {benchmark: records.read_rows(folder, benchmark) for benchmark in records.read_runs(folder)}
    return collections.defaultdict(list, rows), records.read_table(folder / "papers.csv")


def digest(folder):
    """Twelve digits that change with any change of a CSV file, so that the page tells which rows it was written from."""
    files = (path.name.encode() + b"\0" + path.read_bytes() for path in sorted(folder.glob("*.csv")))
    return hashlib.sha256(b"".join(files)).hexdigest()[:12]


def page(folder):
    rows, papers = read(folder)
    runs, numbers = numbered_runs(records.read_runs(folder))

    def power(curve):
        return f"{growth(curve):.2f}"

    return PAGE.format(
        row_count=sum(map(len, rows.values())),
        digest=digest(folder),
        runs=runs,
        summary=result_tables.summary_table(rows, numbers),
        papers=result_tables.papers_table(rows, papers),
        transform_growth=power(ours(rows["fft"], "fft|fft_batch16")),
        ocean_growth=power(ours(rows["ocean"], "ocean")),
        terrain_growth=power(ours(rows["terrain"], "terrain_frame_fly_valleys")),
        terrain_paper_growth=power(paper(papers, "Park", "frame, flying")),
        search_growth=power(ours(rows["highlights"], "highlights_search_.*")),
        draw_growth=power(ours(rows["clouds"], "clouds_draw")),
        renderer=rows["render"][0]["peer"],
    )


def main():
    parser = argparse.ArgumentParser(description="Writes the page of results and its plots from the CSV files.")
    parser.add_argument("--docs", type=pathlib.Path, default="docs", help="folder of results.md: %(default)s")
    docs = parser.parse_args().docs
    for name, script in result_plots.scripts(*read(docs / "results")).items():
        (docs / "results" / f"{name}.svg").write_bytes(result_plots.drawn(script))
    (docs / "results.md").write_text(page(docs / "results"), encoding="utf-8")


if __name__ == "__main__":
    main()
