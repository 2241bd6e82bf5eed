"""examples_test.py FOLDER OFFING: the examples built in a folder, and examples/probes.sh with this program, print results
that theory or the printed spectrum predicts."""

import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
BUILT, OFFING = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
NUMBER = r"(-?\d+(?:\.\d+)?)"


def run(*command):
    path = f"{OFFING.parent}{os.pathsep}{os.environ['PATH']}"
    return subprocess.run(command, capture_output=True, text=True, env={**os.environ, "PATH": path})


def light_to_hill_m():
    """Along the line from a light at x = -2000 m, 50 m high, to a boat at x = 2000 m, 5 m high, to where it meets
    lines_of_sight.cpp's hill."""
    x_m = -2000.0
    while 50 - 45 * (x_m + 2000) / 4000 > 80 * math.exp(-((x_m / 400) ** 2)):
        x_m += 0.1
    return (x_m + 2000) * math.hypot(4000, 45) / 4000


class ExamplesTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.scene = self.folder / "sea.toml"  # Hs 2.1 m
        self.scene.write_text("version = 1\n[wind]\nspeed_mps = 10\n[ocean]\nsize = 128\ngerstner.count = 32\n")

    def output(self, *command):
        result = run(*command)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def numbers(self, pattern, text):
        """The numbers that stand for each # of a pattern."""
        match = re.search(re.escape(pattern).replace(r"\#", NUMBER), text)
        self.assertIsNotNone(match, f"{pattern}\n{text}")
        return [float(number) for number in match.groups()]

    # Fails if the hull does not float at mass / (density * area), does not move with the sea, or the times of its
    # steps are not printed.
    def test_hull_floats(self):
        text = self.output(BUILT / "buoyancy", self.scene, "20")
        draught, expected, pitch, roll = self.numbers(
            "at rest: draught # m, mass / (density * area) # m; pitch # deg, roll # deg", text
        )
        self.assertAlmostEqual(expected, 49200 / (1025 * 12 * 4), delta=1e-4)
        self.assertAlmostEqual(draught, expected, delta=1e-4)
        self.assertLess(max(abs(pitch), abs(roll)), 0.01)
        (hs,) = self.numbers("significant wave height at the hull # m", text)
        self.assertTrue(1.0 < hs < 3.5, hs)  # 2.1 m by the spectrum; of three waves alone
        low, high = self.numbers("heave: # m to # m", text)
        self.assertTrue(-1.5 * hs < low < -0.2 * hs and 0.2 * hs < high < 1.5 * hs, text)
        for motion in ("pitch", "roll"):
            low, high = self.numbers(f"{motion}: # deg to # deg", text)
            self.assertTrue(-45 < low < -0.5 and 0.5 < high < 45, text)
        median, percentile, worst = self.numbers("latency: median # ms, 99th percentile # ms, worst # ms", text)
        self.assertTrue(0 < median <= percentile <= worst, text)

    # Fails if bad arguments or a bad scene end the program without an error, a hint and their exit code.
    def test_hull_reports_errors(self):
        self.assertEqual(run(BUILT / "buoyancy", "a.toml", "-3").returncode, 2)
        for program in ("buoyancy", "sea_state"):
            result = run(BUILT / program, "no/such.toml")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertRegex(result.stderr, r"error: .*no/such\.toml.*\nhint: .+")

    # Fails if the probes see another sea than the spectrum's. Hs of eight seeds scatters by 2 %; maps are bilinear
    # between their samples, which takes 2 % more.
    def test_probes_agree_with_spectrum(self):
        heights = self.folder / "map.exr"
        text = self.output(BUILT / "sea_state", self.scene, heights)
        self.assertEqual(heights.read_bytes()[:4], b"\x76\x2f\x31\x01")  # an EXR file's first bytes
        hs, period = self.numbers("spectrum: Hs # m, Tm02 # s", text)
        found_hs, found_period = self.numbers("probes: Hs # m, mean period # s", text)
        self.assertAlmostEqual(found_hs / hs, 1.0, delta=0.1)
        self.assertAlmostEqual(found_period / period, 1.0, delta=0.12)

    # Fails if the hill hides other boats than geometry says. Halfway, each line is 27.5 m high. There the line to the
    # boat straight behind the hill is below its top, 80 m; those to the outermost boats pass 1 km aside of it.
    def test_hill_hides_boats(self):
        lines = self.output(BUILT / "lines_of_sight").splitlines()
        self.assertEqual(len(lines), 9)
        self.assertRegex(lines[4], r"boat +0 m south: hidden by the hill")
        (distance,) = self.numbers("the hill # m from", lines[4])
        self.assertAlmostEqual(distance, light_to_hill_m(), delta=5.0)
        for end in (lines[0], lines[-1]):
            self.assertRegex(end, r"-?2000 m south: sees the light")

    # Fails if the pipeline breaks, or the probe has another sea than the certificate.
    def test_pipeline_agrees_with_certificate(self):
        text = self.output("bash", EXAMPLES / "probes.sh", self.scene)
        hs, waves, period = self.numbers("probe: Hs # m; # waves, mean period # s", text)
        (asked,) = self.numbers("certificate: Hs # m asked", text)
        self.assertAlmostEqual(hs / asked, 1.0, delta=0.3)
        self.assertAlmostEqual(waves * period, 600, delta=15)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
