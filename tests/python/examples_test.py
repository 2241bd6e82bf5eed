"""examples_test.py SOURCES PROGRAMS: the examples of the Python package run as written and make their pictures. Needs
matplotlib from PyPI."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCES, PROGRAMS = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
try:
    import matplotlib  # noqa: F401
except ImportError:
    print("no matplotlib: ./dev test --slow installs it")
    sys.exit(77)


class ExamplesTest(unittest.TestCase):
    # Fails if an example does not run where the scenes are, or makes no picture.
    def test_examples(self):
        examples = sorted((SOURCES / "python/examples").glob("*.py"))
        self.assertEqual(len(examples), 3)
        for example in examples:
            with self.subTest(example.name), tempfile.TemporaryDirectory() as folder:
                shutil.copytree(SOURCES / "scenes", pathlib.Path(folder) / "scenes")
                environment = dict(os.environ, PATH=f"{PROGRAMS}{os.pathsep}{os.environ['PATH']}")
                said = subprocess.run([sys.executable, "-B", example], cwd=folder, env=environment, capture_output=True, text=True)
                self.assertEqual(said.returncode, 0, said.stderr)
                self.assertEqual([path.stem for path in pathlib.Path(folder).glob("*.png")], [example.stem])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
