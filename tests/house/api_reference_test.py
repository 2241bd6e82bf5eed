"""Doxygen understands the comments of the installed headers: no warning, and no type without a comment."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

UNCOMMENTED = re.compile(r"(Compound .*|\(enumeration\) .*) is not documented")


def doxygen(folder, *settings):
    text = "\n".join([(ROOT / "docs/Doxyfile").read_text(), f'OUTPUT_DIRECTORY = "{folder}"', *settings])
    return subprocess.run(["doxygen", "-"], input=text, cwd=ROOT, capture_output=True, text=True)


class ApiReferenceTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    # Fails if a comment names a parameter or a page that is not there, or Doxygen takes part of it for a command.
    def test_no_warnings(self):
        result = doxygen(self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        # The C interface, a page of the main page's own, and what kernels share, which is filtered.
        pages = "".join(page.read_text() for page in (self.folder / "html").glob("*_8h.html"))
        for words in ("What was wrong in this thread", "The water at a point", "Counter-based random numbers"):
            self.assertTrue(words in pages, f"{words}: expected on a page, found on none")

    # Fails if a type of an installed header has no comment.
    def test_types_have_comments(self):
        result = doxygen(self.folder, "EXTRACT_ALL = NO", "WARN_AS_ERROR = NO", "GENERATE_HTML = NO", "GENERATE_XML = YES")
        faults = [line for line in result.stderr.splitlines() if UNCOMMENTED.search(line)]
        self.assertEqual(faults, [])
        self.assertGreater(result.stderr.count("is not documented"), 0)  # it looks for them: members may lack one


if __name__ == "__main__":
    if shutil.which("doxygen") is None:
        print("skipped: no doxygen")
        sys.exit(77)
    unittest.main()
