# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Runs a short benchmark and checks its rows: fields and signs. The program itself fails where results of ours
and of the peer differ. Usage: check_rows.py PROGRAM COMMAND"""

import json
import os
import subprocess
import sys

FIELDS = ["name", "size", "ours_ms", "peer", "peer_ms", "ratio", "ratio_low", "spread"]
# command -> size and names of its rows; from 256 on it would also measure start-up, which compiles for seconds.
SIZES = {
    "fft": ("16", ["fft_batch16", "fft_batch16_alone"]),
    "ocean": ("32", ["ocean"]),
    "queries": (
        "64",
        [
            *(f"queries{what}{fields}" for what in ("", "_maps", "_make_maps") for fields in ("", "_surface")),
            "queries_exact",
        ],
    ),
    "viewshed": ("64", ["viewshed_valleys", "viewshed_valleys_curved"]),
    "gerstner": ("64", ["gerstner", "gerstner_alone"]),
    "curvature": (
        "64",
        [
            *(f"curvature_{method}{cores}" for method in ("fit", "tensor", "diffused") for cores in ("", "_all_cores")),
            "curvature_opencl",
        ],
    ),
}


def main(program, command):
    size, names = SIZES[command]
    # Maps of n x n cells have a post more a side.
    rows_size = int(size) + (1 if command == "viewshed" else 0)
    # Real maps take long.
    environment = {name: value for name, value in os.environ.items() if name != "OFFING_TEST_DATA"}
    run = [program, command, "--sizes", size, "--blocks", "3", "--json"]
    rows = json.loads(subprocess.run(run, stdout=subprocess.PIPE, env=environment, check=True).stdout)
    assert {(row["name"], row["size"]) for row in rows} == {(name, rows_size) for name in names}, rows
    for row in rows:
        assert list(row) == FIELDS, row
        assert row["ours_ms"] > 0 and row["peer_ms"] > 0 and row["peer"], row
        assert 0 < row["ratio_low"] <= row["ratio"], row
        assert row["spread"] >= 0, row


if __name__ == "__main__":
    main(*sys.argv[1:])
