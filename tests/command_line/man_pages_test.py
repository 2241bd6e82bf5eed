"""man_pages_test.py PROGRAM...: manual pages are set without warnings, and say what the help says."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from reference_modules import PROGRAMS, ROOT

import command_trees as trees
import man_pages

TREES = trees.read(PROGRAMS)
PAGES = man_pages.pages(TREES)


def words(text):
    return " ".join(text.split())


class ManPagesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        for name, text in PAGES.items():
            (cls.folder / name).write_text(text, encoding="utf-8")

    def rendered(self, name):
        """The page as text of unlimited width, and what was said about it."""
        run = subprocess.run(
            ["man", "--warnings=w", "-E", "UTF-8", "-l", self.folder / name],
            capture_output=True,
            encoding="utf-8",
            env={"PATH": "/usr/bin:/bin", "MANWIDTH": "500", "LC_ALL": "C.UTF-8"},
        )
        self.assertEqual(run.returncode, 0, run.stderr)
        return run.stdout, run.stderr

    # Fails if a text is taken for a request of the formatter or loses a sign, a flag is missing, or groff warns.
    @unittest.skipUnless(shutil.which("man") and shutil.which("groff"), "no man, no groff (packages man-db, groff-base)")
    def test_pages_are_set_as_they_are_written(self):
        for tree in TREES:
            for command in tree["commands"]:
                with self.subTest(command["name"]):
                    text, errors = self.rendered(f"{trees.page_name(command)}.1")
                    self.assertEqual(errors, "")
                    lines = [line.strip() for line in text.splitlines()]
                    for example in trees.examples(command):
                        self.assertIn(example.strip(), lines)
                    flat = words(text)
                    for option in command["options"]:
                        self.assertIn(trees.flags_with_value(option), flat)
                        self.assertIn(words(option["help"]), flat)
                    for block in trees.prose(command):
                        for part in [block] if isinstance(block, str) else [text for _, text in block]:
                            self.assertIn(words(part), flat)

    # Fails if a sign that means something to the formatter gets through.
    @unittest.skipUnless(shutil.which("man") and shutil.which("groff"), "no man, no groff (packages man-db, groff-base)")
    def test_signs_of_the_formatter_are_plain(self):
        text = ".TH x\n'br \\fB a-b `c' \"d\" ~^ \\ m\u00b3"
        page = '.TH X 1 "" "" ""\n.SH NAME\nx \\- x\n.SH DESCRIPTION\n' + man_pages.paragraph_lines(text) + "\n"
        (self.folder / "signs.1").write_text(page, encoding="utf-8")
        rendered, errors = self.rendered("signs.1")
        self.assertEqual(errors, "")
        for line in text.split("\n"):
            self.assertIn(line, [line.strip() for line in rendered.splitlines()])

    # Fails if a minus is written as a hyphen, which some systems show as another sign: flags cannot be copied then.
    def test_every_minus_is_one(self):
        for name, text in PAGES.items():
            self.assertNotRegex(text, r"(?<!\\)-", name)

    # Fails if a page is no valid manual page for programs other than groff.
    @unittest.skipUnless(shutil.which("mandoc"), "no mandoc (package mandoc)")
    def test_mandoc_finds_no_errors(self):
        run = subprocess.run(
            ["mandoc", "-T", "lint", "-W", "error", *sorted(self.folder.glob("offing*.1"))],
            capture_output=True,
            text=True,
        )
        self.assertEqual((run.returncode, run.stdout), (0, ""))

    # Fails if a program reads a variable of ours that the pages do not list, or no longer reads one.
    def test_environment_is_that_of_the_sources(self):
        read = set()
        for folder in ("host", "present", "mesh_tools"):
            for path in (ROOT / folder).rglob("*.cpp"):
                source = path.read_text(encoding="utf-8")
                if "getenv(" in source:
                    read |= set(re.findall(r'"(OFFING_[A-Z_]+)"', source))
        self.assertEqual(set(trees.ENVIRONMENT), read)


if __name__ == "__main__":
    unittest.main(argv=["man_pages_test.py"])
