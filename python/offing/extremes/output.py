"""What the study writes and prints: table, plot, JSON and text."""

import csv
import json
import math
import os
import pathlib
import tempfile

import numpy as np


def table_rows(found):
    """The rows of the table: a dict for each level that at least one height exceeds."""
    table = found["table"]
    rows = [{name: float(values[i]) for name, values in table.items()} for i in range(len(table["level_m"]))]
    return [row for row in rows if row["maxima"] > 0.0]


def write_table(found, file):
    rows = table_rows(found)
    with open(file, "w", encoding="utf-8", newline="") as opened:
        writer = csv.DictWriter(opened, list(rows[0]), lineterminator="\n")
        writer.writeheader()
        writer.writerows(
            {name: "" if math.isnan(value) else f"{value:.6g}" for name, value in row.items()} for row in rows
        )


def to_json(found):
    def plain(value):
        if isinstance(value, dict):
            return {name: plain(of) for name, of in value.items()}
        return None if isinstance(value, float) and math.isnan(value) else value

    return {name: plain(value) for name, value in found.items() if name != "table"} | {
        "table": [plain(row) for row in table_rows(found)]
    }


def simulated_time(found):
    return f"{found['seeds']} seeds of {found['duration_s']:g} s at {found['points']} points"


def plot(found, file):
    """Writes a PNG of both distributions with their limits and theory."""
    import matplotlib
    from matplotlib.figure import Figure

    rows = table_rows(found)
    column = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    with matplotlib.rc_context({"svg.hashsalt": "offing"}):
        figure = Figure(figsize=(7, 5), layout="constrained")
        axes = figure.add_subplot()
        labels = {
            "crests": ("crests between zero up-crossings", "Rayleigh"),
            "maxima": ("all maxima above the mean level", f"Cartwright & Longuet-Higgins, ε = {found['epsilon']:.2f}"),
        }
        smallest = 1.0 / max(found["maxima"]["count"], 1)
        lower_end = 0.4 * smallest
        # Crests are open and larger, so that maxima do not hide them.
        for kind, colour, size, fill in (("crests", "C0", 6, "none"), ("maxima", "C1", 3, "C1")):
            simulated, theory = labels[kind]
            shown = column[kind] > 0
            names = ("level_m", f"{kind}_low", kind, f"{kind}_high")
            level_m, low, share, high = (column[name][shown] for name in names)
            is_below = low < lower_end  # such a limit, mostly 0, gets an arrow
            low = np.minimum(np.maximum(low, lower_end), share)
            axes.errorbar(
                level_m,
                share,
                [share - low, np.maximum(high, share) - share],
                fmt="o",
                markersize=size,
                markerfacecolor=fill,
                capsize=size - 1,
                color=colour,
                label=f"{simulated}, 95 % limits",
            )
            axes.plot(level_m[is_below], low[is_below], "v", color=colour, markersize=size)
            axes.plot(column["level_m"], column[f"{kind}_theory"], color=colour, linewidth=1, label=theory)
        axes.set(
            yscale="log",
            xlabel="height above the mean level, m",
            ylabel="share of heights above",
            title=f"Hs {4 * found['sigma_m']:.2f} m, {simulated_time(found)}",
            ylim=(0.3 * smallest, 1.3),
            xlim=(0, None),
        )
        axes.grid(alpha=0.3)
        axes.legend()
        figure.savefig(file, format="png", dpi=120, metadata={"Software": None})


def print_results(found):
    print(f"asked     Hs {found['asked']['hs_m']:.3f} m, Tm02 {found['asked']['tm02_s']:.2f} s")
    print(
        f"simulated Hs {4 * found['sigma_m']:.3f} m, Tm02 {found['tm02_s']:.2f} s, bandwidth epsilon "
        f"{found['epsilon']:.3f}, {100 * found['energy_simulated']:.1f} % of the energy asked"
    )
    print(f"{simulated_time(found)}, highest crest {found['highest_m']:.2f} m\n")
    names = ("level, m", "/ sigma", "crests", "low", "high", "Rayleigh", "maxima", "low", "high", "C&LH 1956")
    print(("{:>8} {:>7}" + " {:>9}" * 8).format(*names))
    for row in table_rows(found):
        shares = [row[kind + end] for kind in ("crests", "maxima") for end in ("", "_low", "_high", "_theory")]
        print(f"{row['level_m']:8.3f} {row['level_sigma']:7.2f}", *(f"{share:9.4g}" for share in shares))
    print()
    for kind, text in (
        ("maxima", "all maxima and Cartwright & Longuet-Higgins 1956"),
        ("crests", "crests above Hs / 2 and Rayleigh"),
    ):
        of = found[kind]
        print(
            f"{text}: {'inside' if of['in_band'] else 'outside'} the 95 % band at {of['levels_compared']} levels; "
            f"largest deviation {of['largest_standard_errors']:.1f}, band {of['band_standard_errors']:.1f} standard "
            f"errors, {of['count']} heights"
        )


def write_all(found, name):
    """Writes NAME.csv, .json and .png. Each file gets its name only when it is complete."""
    writers = {
        ".csv": write_table,
        ".png": plot,
        ".json": lambda values, file: pathlib.Path(file).write_text(
            json.dumps(to_json(values), indent=2) + "\n", encoding="utf-8"
        ),
    }
    for ending, write in writers.items():
        with tempfile.TemporaryDirectory(dir=pathlib.Path(name).parent, prefix=".") as folder:
            part = pathlib.Path(folder, "part")
            write(found, part)
            os.replace(part, f"{name}{ending}")
