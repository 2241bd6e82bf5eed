"""`./dev lint COMMIT` checks what changed, and does not take a failure to find out for nothing changed: run in a
small tree, with programs in place of git, ninja and the others that answer as each test wants."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

DEV = pathlib.Path(__file__).resolve().parents[2] / "dev"

SOUND = {
    "git": "[[ $1 == rev-parse ]] || { [[ $1 == diff ]] && echo host/a.cpp; true; }",
    "ninja": 'printf "a.o: #deps 1, (VALID)\\n    %s/host/a.cpp\\n\\n" "$ROOT"',
    "cmake": "true",
    "clang-format": "true",
    "dpkg-query": 'for package in "${@:3}"; do echo "installed $package"; done',
    "run-clang-tidy": 'echo "tidy: ${@: -1}"',
}


class LintCommand(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name).resolve()
        for name in ("programs", "kernels", "host", "present", "mesh_tools", "tests", "examples", "python"):
            (self.root / name).mkdir()
        shutil.copy(DEV, self.root)

    def lint(self, **changed):
        for name, body in {**SOUND, **changed}.items():
            program = self.root / "programs" / name
            program.write_text(f"#!/usr/bin/env bash\n{body}\n", encoding="utf-8")
            program.chmod(0o755)
        environment = {**os.environ, "PATH": f"{self.root}/programs:{os.environ['PATH']}", "ROOT": str(self.root)}
        return subprocess.run(
            ["bash", "./dev", "lint", "HEAD"], cwd=self.root, env=environment, capture_output=True, text=True
        )

    def test_checks_what_changed(self):
        result = self.lint()
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, f"tidy: ^{self.root}/host/a.cpp\n")

    def test_says_that_nothing_changed(self):
        result = self.lint(git="true")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, "dev: no C++ changed since HEAD\n")

    def assert_fails(self, result):
        self.assertEqual(result.returncode, 1)
        self.assertNotIn("no C++ changed", result.stdout)
        self.assertIn("error: ./dev lint: cannot tell what changed since HEAD", result.stderr)

    def test_git_that_fails(self):
        self.assert_fails(self.lint(git="[[ $1 == rev-parse ]]"))

    def test_ninja_that_fails(self):
        self.assert_fails(self.lint(ninja="false"))


if __name__ == "__main__":
    unittest.main()
