"""The runner of documentation pages runs a sound page and finds each fault that is planted in it: a blind runner, under
which broken pages pass, fails here."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

RUNNER = pathlib.Path(__file__).with_name("run_page.py")

SOUND = """# Page

- a list

    goes on

```sh
greet > greeting.txt
grep -q calm scenes/calm.toml
./dev never-run
```

```toml made/two.toml
a = 1
```

```toml made/two.toml
b = 2
```

```text
exit 1
```

```sh
test "$(cat greeting.txt made/two.toml)" = "$(printf 'hello\\na = 1\\nb = 2')"
```

<!-- not run: it waits for its user -->

```sh
exit 1
```
"""


class RunPage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "scenes").mkdir()
        (self.root / "scenes" / "calm.toml").write_text('name = "calm"\n')
        self.program("greet", "echo hello")

    def program(self, name, text):
        file = self.root / "bin" / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(f"#!/bin/sh\n{text}\n")
        file.chmod(0o755)
        return file

    def run_page(self, text, *flags):
        page = self.root / "page.md"
        page.write_text(text, encoding="utf-8")
        command = [sys.executable, "-B", RUNNER, page, "--programs", self.root / "bin", "--sources", self.root, *flags]
        return subprocess.run(command, capture_output=True, text=True, check=False)

    def assert_passes(self, text, *flags):
        result = self.run_page(text, *flags)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def assert_finds(self, text, line, part, *flags):
        result = self.run_page(text, *flags)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(f"page.md:{line}: ", result.stderr)
        self.assertIn(part, result.stderr)

    def test_sound_page(self):
        output = self.assert_passes(SOUND)
        self.assertIn("page.md:31: not run: it waits for its user", output)
        self.assertRegex(output, r"page\.md:7: \d+\.\d s\n")

    def test_scratch_folder(self):
        kept = self.root / "kept"
        self.assert_passes(SOUND, "--keep", kept)
        self.assertEqual((kept / "greeting.txt").read_text(), "hello\n")
        where = self.root / "where.txt"
        self.assert_passes(f"```sh\npwd > {where}\n```\n")
        self.assertFalse(pathlib.Path(where.read_text().strip()).exists(), "the scratch folder was left behind")

    def test_failing_command(self):
        self.assert_finds("\n```sh\necho told >&2\nfalse\ntrue\n```\n", 2, "told")

    def test_failing_command_in_a_pipe(self):
        self.assert_finds("```sh\nfalse | cat\n```\n", 1, "exit code 1")

    def test_failing_command_after_others(self):
        self.assert_finds(SOUND + "\n```sh\ngreet | grep -q bye\n```\n", 35, "exit code 1")

    def test_program_of_no_page(self):
        self.assert_finds("```sh\nno-such-program\n```\n", 1, "exit code 127")

    def test_command_without_end(self):
        self.assert_finds("```sh\nsleep 60 & sleep 60\n```\n", 1, "more than 0.5 s", "--limit-s", "0.5")

    def test_file_beyond_the_folder(self):
        for name in ("../stray.toml", str(self.root / "stray.toml"), "link/stray.toml"):
            page = f"```sh\nln -s '{self.root}' link\n```\n\n```toml {name}\na = 1\n```\n"
            self.assert_finds(page, 5, "expected a file in the reader's folder")
        self.assertFalse((self.root / "stray.toml").exists())

    def test_faults_of_form(self):
        run = "```sh\ntrue\n```\n\n"
        for text, part in (
            ("```sh\ntrue\n", "does not end"),
            ("```\ntrue\n```\n", "without a language"),
            ("```toml\na = 1\n```\n", "a file name"),
            ("```toml a.toml b.toml\na = 1\n```\n", "one file name"),
            ("```sh a.sh\ntrue\n```\n", "one file name"),
            ("    offing devices\n", "use a fence"),
            (" ```sh\ntrue\n```\n", "first column"),
            ("<!-- not run: -->\n\n```sh\ntrue\n```\n", "REASON"),
            ("<!-- run with: maya -->\n\n```sh\ntrue\n```\n", "bpy"),
            ("<!-- not run: for no block -->\n\nText.\n", "no fence follows"),
            ("<!-- not run: for no block -->\n", "no fence follows"),
        ):
            with self.subTest(text=text):
                self.assert_finds(run + text, 5, part)

    def test_syntax_of_what_is_not_run(self):
        self.assert_finds("<!-- not run: a cluster -->\n```sh\nif true\n```\n", 2, "syntax error")
        self.assert_finds("```bash job.sh\nfor i in 1 2\n```\n", 1, "syntax error")

    def test_nothing_to_run(self):
        self.assert_finds("# Page\n\n```text\nfalse\n```\n", 1, "no command")

    def test_missing_program_skips(self):
        output = self.assert_passes("```sh\ntrue\n```\n\n```sh\n# needs: no-such-program\nfalse\n```\n")
        self.assertIn("page.md:5: skipped: no program no-such-program", output)
        self.assert_finds("```sh\n# needs: greet\nfalse\n```\n", 1, "exit code 1")

    def test_blender(self):
        page = "```python a.py\nfalse\n```\n\n<!-- run with: bpy -->\n```sh\nblender --background --python a.py\n```\n"
        self.assertIn("page.md:6: skipped: no Python", self.assert_passes(page))
        self.assertIn("skipped", self.assert_passes(page, "--bpy", self.program("without", "exit 1")))
        # Stands for a Python with bpy: finds the module, and runs the script with the shell.
        bpy = self.program("python with bpy", 'case "$1" in -c) ;; *) sh "$1" ;; esac')
        self.assert_finds(page, 6, "exit code 1", "--bpy", bpy)
        self.assertRegex(self.assert_passes(page.replace("false", "true"), "--bpy", bpy), r"page\.md:6: \d")
        self.assert_finds("<!-- run with: bpy -->\n```sh\ntrue\n```\n", 2, "blender --background --python")


if __name__ == "__main__":
    unittest.main()
