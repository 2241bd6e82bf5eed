"""wheel_test.py PROGRAM SOURCES: the package as users install it, in fresh virtual environments made by the Python
PROGRAM: by `pip install` of the folder and from a wheel. Needs PyPI; takes some minutes."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
ENVIRONMENT = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}


def run(*words, **options):
    result = subprocess.run(words, capture_output=True, text=True, env=ENVIRONMENT, **options)
    if result.returncode != 0:
        raise AssertionError(f"{words}: exit {result.returncode}\n{result.stdout[-3000:]}\n{result.stderr[-3000:]}")
    return result.stdout


class WheelTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def new_python(self, name):
        run(PROGRAM, "-m", "venv", self.folder / name)
        return self.folder / name / "bin/python"

    def check(self, python):
        """All quick tests of the package, and the lines of the README."""
        for subject in ("package", "parts"):
            run(python, "-B", SOURCES / f"tests/python/{subject}_test.py", cwd=self.folder)
        lines = re.search(r"```python\n(.*?)```", (SOURCES / "README.md").read_text(), re.S)[1]
        self.assertRegex(run(python, "-c", lines, cwd=SOURCES), r"\(\d+, \d+\)")

    # Fails if the sources cannot be built into a wheel, or the wheel forgets a file.
    def test_wheel(self):
        python = self.new_python("wheel")
        run(python, "-m", "pip", "wheel", "--quiet", "--no-deps", "-w", self.folder / "wheels", SOURCES / "python")
        (wheel,) = (self.folder / "wheels").glob("offing-*.whl")
        run(python, "-m", "pip", "install", "--quiet", wheel)
        self.check(python)
        modules = "import offing, pathlib; print(sorted(p.stem for p in (pathlib.Path(offing.__file__).parent / 'offing').iterdir()))"
        self.assertEqual(run(python, "-c", modules).strip(), "['cairo', 'gdal', 'netcdf', 'openvdb', 'present']")

    # Fails if pip cannot install the folder as the documentation says.
    def test_folder(self):
        python = self.new_python("folder")
        run(python, "-m", "pip", "install", "--quiet", SOURCES / "python")
        self.check(python)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
