# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""The CSV files of docs/results: a file a benchmark with its rows, and runs.csv with the machine of each run."""

import csv

ROW = ("name", "size", "ours_ms", "peer_ms", "ratio", "ratio_low", "spread", "peer")
STEPS = ("mean", "of_90", "of_95", "of_99", "within_16", "over_80")
TEXTS = ("name", "peer")
RUN = (
    "benchmark", "date", "commit", "blocks", "processor", "cores", "memory_gib", "linux", "huge_pages", "opencl_device",
    "opencl_platform", "compiler", "fftw", "load_before",
)  # fmt: skip


def read_table(path):
    """Dictionaries of texts; none where there is no file."""
    if not path.exists():
        return []
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write_table(path, columns, lines):
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows(lines)


def number(text):
    return float(text) if text else None


def read_rows(folder, benchmark):
    """Rows as offing-bench prints them by --json, with steps_mean and the like beside the other fields."""
    rows = []
    for line in read_table(folder / f"{benchmark}.csv"):
        row = {key: text if key in TEXTS else number(text) for key, text in line.items()}
        rows.append({**row, "size": int(row["size"])})
    return rows


def write_rows(folder, benchmark, rows):
    """rows: as offing-bench prints them by --json."""
    lines = []
    for row in rows:
        line = {key: row[key] for key in ROW}
        if "steps" in row:
            # The peer's text repeats the steps.
            line |= {"peer": "none"} | {f"steps_{key}": row["steps"][key] for key in STEPS}
        lines.append(line)
    has_steps = any("steps" in row for row in rows)
    write_table(folder / f"{benchmark}.csv", ROW + (tuple(f"steps_{key}" for key in STEPS) if has_steps else ()), lines)


def read_runs(folder):
    """Benchmark -> its run, in the order of the file."""
    return {run["benchmark"]: run for run in read_table(folder / "runs.csv")}


def write_run(folder, run):
    write_table(folder / "runs.csv", RUN, (read_runs(folder) | {run["benchmark"]: run}).values())
