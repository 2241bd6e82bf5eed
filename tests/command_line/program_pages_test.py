"""program_pages_test.py PROGRAM...: the pages of docs/reference are those of the programs."""

import unittest

from reference_modules import PROGRAMS, ROOT

import command_trees as trees
import program_pages


class ProgramPagesTest(unittest.TestCase):
    # Fails if an option or a help text changed and `./dev docs` was not run.
    def test_pages_are_up_to_date(self):
        for tree in trees.read(PROGRAMS):
            path = ROOT / f"docs/reference/{tree['program']}.md"
            self.assertEqual(
                path.read_text(encoding="utf-8").splitlines(),
                program_pages.page(tree).splitlines(),
                f"{path.relative_to(ROOT)} is not that of the program: run ./dev docs and commit it",
            )

    # Fails if a sign in a help text ends a cell of a table or begins a tag or a formatted part.
    def test_signs_of_markdown_are_plain_in_tables(self):
        self.assertEqual(program_pages.cell("a|b <c> *d*\nx"), r"a\|b \<c> \*d\*<br>x")


if __name__ == "__main__":
    unittest.main(argv=["program_pages_test.py"])
