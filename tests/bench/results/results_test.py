# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""The committed page and plots of results are those of the committed rows, and the recorder writes what benchmarks print."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import unittest.mock

import record_results
import records
import result_plots
import results_page

DOCS = pathlib.Path(__file__).resolve().parents[3] / "docs"
RESULTS = DOCS / "results"
# Programs that stand in for those that the recorder runs.
STAND_INS = {
    "git": "echo abc1234",
    "c++": "echo compiler 1.2",
    "pkg-config": "echo 3.4",
    "offing": """echo '[{"is_default": true, "name": "device", "platform": "OpenCL", "driver_version": "5"}]'""",
    "offing-bench": 'cat "$(dirname "$0")/$1.json"; echo "$@" >> "$(dirname "$0")/arguments"',
}
ROW = {"name": "fft", "size": 64, "ours_ms": 0.12345678901234567, "peer": "FFTW, in place", "peer_ms": 0.2, "ratio": 1.62,
       "ratio_low": 1.5, "spread": 0.05}  # fmt: skip
ALONE = {"name": "terrain_frame", "size": 257, "ours_ms": 2.5, "peer": "none", "peer_ms": None, "ratio": None,
         "ratio_low": None, "spread": 0.01}  # fmt: skip
STEPS = {"mean": 8.125, "of_90": 12, "of_95": 15, "of_99": 23, "within_16": 0.96, "over_80": 0.001}


def temporary_folder(test):
    folder = tempfile.TemporaryDirectory()
    test.addCleanup(folder.cleanup)
    return pathlib.Path(folder.name)


class Page(unittest.TestCase):
    def test_page_is_that_of_the_rows(self):
        self.assertEqual(results_page.page(RESULTS), (DOCS / "results.md").read_text(encoding="utf-8"),
                         "run ./dev bench --page")  # fmt: skip

    def test_change_of_any_row_is_found(self):
        for path in sorted(RESULTS.glob("*.csv")):
            folder = temporary_folder(self) / "results"
            shutil.copytree(RESULTS, folder)
            lines = path.read_text(encoding="utf-8").splitlines(keepends=True)
            lines[-1] = re.sub(r"[1-9](?=[^1-9]*$)", lambda digit: str(int(digit.group()) - 1), lines[-1])
            (folder / path.name).write_text("".join(lines), encoding="utf-8")
            self.assertNotEqual(results_page.page(folder), results_page.page(RESULTS), path.name)

    def test_page_uses_every_benchmark(self):
        for benchmark in records.read_runs(RESULTS):
            folder = temporary_folder(self) / "results"
            shutil.copytree(RESULTS, folder)
            lines = records.read_table(folder / f"{benchmark}.csv")
            records.write_table(folder / f"{benchmark}.csv", tuple(lines[0]),
                                [{**line, "ours_ms": f"{1.5 * float(line['ours_ms']):.6g}"} for line in lines])  # fmt: skip
            with unittest.mock.patch.object(results_page, "digest", lambda _: ""):
                self.assertNotEqual(results_page.page(folder), results_page.page(RESULTS), benchmark)

    def test_plots_are_those_of_the_rows(self):
        scripts = result_plots.scripts(*results_page.read(RESULTS))
        plots = {path.name: path.read_bytes() for path in RESULTS.glob("*.svg")}
        self.assertEqual({f"{name}.svg" for name in scripts}, set(plots))
        for name, plot in plots.items():
            self.assertLess(len(plot), 100_000, name)
            self.assertIn(b"<text>", plot, name)  # letters, not their outlines
            self.assertIn(f"results/{name}", results_page.PAGE)
        if shutil.which("gnuplot") is None:
            self.skipTest("gnuplot is not installed, so that plots cannot be drawn again")
        # gnuplot 5.4 patchlevel 4; plots name it in capitals.
        version = subprocess.run(["gnuplot", "--version"], stdout=subprocess.PIPE, check=True).stdout.strip()
        if version.upper() not in plots["ratios.svg"].upper():
            self.skipTest(f"the plots were drawn by another version than {version.decode()}")
        for name, script in scripts.items():
            self.assertEqual(result_plots.drawn(script), plots[f"{name}.svg"], f"{name}: run ./dev bench --page")


class Recorder(unittest.TestCase):
    def setUp(self):
        self.folder = temporary_folder(self)
        self.programs = self.folder / "programs"
        self.programs.mkdir()
        for name, line in STAND_INS.items():
            (self.programs / name).write_text(f"#!/bin/sh\n{line}\n")
            (self.programs / name).chmod(0o755)

    def record(self, benchmark, rows):
        (self.programs / f"{benchmark}.json").write_text(json.dumps(rows))
        program = [sys.executable, "-B", record_results.__file__, str(self.programs)]
        environment = {**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}"}
        subprocess.run([*program, "--benchmarks", benchmark, "--folder", str(self.folder)], env=environment, check=True)

    def test_rows_read_back_as_printed(self):
        walk = {**ALONE, "name": "terrain_fly_valleys_paper", "peer": "8.12 steps"}
        self.record("terrain", [ROW, ALONE, {**walk, "steps": STEPS}])
        no_steps = {f"steps_{key}": None for key in STEPS}
        steps = {f"steps_{key}": value for key, value in STEPS.items()}
        expected = [ROW | no_steps, ALONE | no_steps, walk | steps | {"peer": "none"}]
        self.assertEqual(records.read_rows(self.folder, "terrain"), expected)

    def test_other_benchmarks_keep_their_run(self):
        self.record("curvature", [ROW])
        self.record("fft", [ROW])
        self.record("fft", [ROW, ROW])
        runs = records.read_runs(self.folder)
        self.assertEqual(list(runs), ["curvature", "fft"])
        self.assertEqual([runs[name]["blocks"] for name in runs], ["5", "15"])
        self.assertEqual(runs["fft"]["commit"], "abc1234")
        self.assertEqual(runs["fft"]["opencl_platform"], "OpenCL 5")
        self.assertEqual(len(records.read_rows(self.folder, "fft")), 2)
        self.assertEqual((self.programs / "arguments").read_text().splitlines()[0], "curvature --sizes 256 --blocks 5 --json")

    def test_every_benchmark_has_a_summary(self):
        self.assertEqual(set(record_results.BENCHMARKS), set(results_page.result_tables.SUMMARIES))


if __name__ == "__main__":
    unittest.main()
