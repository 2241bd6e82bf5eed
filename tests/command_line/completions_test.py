"""completions_test.py PROGRAM...: completions of bash, zsh and fish, tried as a user types them: a terminal, a line
with a tab, and what the program would get."""

import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import tempfile
import time
import unittest

from reference_modules import PROGRAMS

import command_trees as trees
import completions

PACKAGE = pathlib.Path("/usr/share/bash-completion/bash_completion")
LONGEST_S = 60
# Typed line, and the arguments that the program gets. A tab completes what is the only choice, or as far as all agree.
TYPED = (
    ("offing oc\t", ["ocean"]),
    ("offing ocean ba\t", ["ocean", "bake"]),
    ("offing ocean bake --wind-s\t", ["ocean", "bake", "--wind-speed-mps"]),
    ("offing ocean bake --spectrum jo\t", ["ocean", "bake", "--spectrum", "jonswap"]),
    ("offing ocean bake --json --compression zips\t-o", ["ocean", "bake", "--json", "--compression", "zips", "-o"]),
    ("offing ocean bake --device cp\t", ["ocean", "bake", "--device", "cpu"]),
    ("offing ocean bake my\t", ["ocean", "bake", "my sea.toml"]),  # a file with a space
    ("offing ocean bake -o fr\t", ["ocean", "bake", "-o", "frames/"]),  # a folder
    ("offing ocean bake --spectrum-file my\t", ["ocean", "bake", "--spectrum-file", "my sea.toml"]),
    ("offing ocean bake --wind-speed-mps my\t", ["ocean", "bake", "--wind-speed-mps", "my"]),  # a number
    ("offing my\t", ["my"]),  # a command
    ("offing dev\t", ["devices"]),
    ("offing-view --head\t", ["--headless"]),
    ("offing-view my\t", ["my sea.toml"]),
    ("offing-mesh generate tor\t-", ["generate", "torus-"]),
    ("offing-mesh generate torus-knot --tu\t", ["generate", "torus-knot", "--tube-m"]),  # another name of knot
)


class Terminal:
    """A shell in a pseudo terminal, which prints the arguments of the programs instead of running them."""

    def __init__(self, command, folder, environment):
        self.text = ""
        self.process, self.end = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.execvpe(command[0], command, environment)

    def send(self, text):
        os.write(self.end, text.encode())

    def read_until(self, pattern):
        """The first match in what the shell prints from now on."""
        deadline = time.monotonic() + LONGEST_S
        while not (match := re.search(pattern, self.text)):
            if time.monotonic() > deadline or not select.select([self.end], [], [], LONGEST_S)[0]:
                raise AssertionError(f"{pattern} not found in {self.text!r}")
            try:
                self.text += os.read(self.end, 65536).decode(errors="replace")
            except OSError as error:  # the shell ended
                raise AssertionError(f"{pattern} not found in {self.text!r}") from error
        self.text = self.text[match.end() :]
        return match

    def arguments(self, typed):
        self.send(typed + "\n")
        return re.findall(r"<([^>]*)>", self.read_until(r"\x02((?:<[^>]*>)*)\x03")[1])

    def close(self):
        os.kill(self.process, 9)
        os.close(self.end)
        os.waitpid(self.process, 0)


class CompletionsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.data = pathlib.Path(folder.name) / "share"
        cls.files = pathlib.Path(folder.name) / "files"
        cls.files.mkdir()
        (cls.files / "my sea.toml").touch()
        (cls.files / "frames.txt").touch()
        (cls.files / "frames").mkdir()
        cls.trees = trees.read(PROGRAMS)
        cls.shells = completions.files(cls.trees)
        cls.names = [tree["program"] for tree in cls.trees]
        places = {"bash": "bash-completion/completions", "zsh": "zsh", "fish": "fish/vendor_completions.d"}
        for shell, place in places.items():
            (cls.data / place).mkdir(parents=True)
            for name, text in cls.shells[shell].items():
                (cls.data / place / name).write_text(text, encoding="utf-8")
        cls.environment = {
            "PATH": "/usr/bin:/bin",
            "HOME": folder.name,
            "TERM": "dumb",
            "LC_ALL": "C.UTF-8",
            "XDG_DATA_DIRS": str(cls.data),
            "INPUTRC": "/dev/null",
        }

    def try_typed(self, command, *setup):
        terminal = Terminal(command, self.files, self.environment)
        self.addCleanup(terminal.close)
        for line in setup:
            terminal.send(line + "\n")
        for name in self.names:
            terminal.send(f"{name}() {{ printf '\\002'; printf '<%s>' \"$@\"; printf '\\003\\n'; }}\n")
        terminal.send("printf '\\001ready\\001\\n'\n")
        terminal.read_until("\x01ready\x01")
        for typed, expected in TYPED:
            if typed.split(" ")[0] not in self.names:
                continue
            with self.subTest(typed):
                self.assertEqual(terminal.arguments(typed), expected)

    # Fails if a completion is wrong, needs the package bash-completion, or loses the space in a file's name.
    def test_bash_alone(self):
        sources = [f"source {self.data}/bash-completion/completions/{name}" for name in self.names]
        self.try_typed(["bash", "--norc", "--noprofile", "-i"], *sources)

    # Fails if the package does not find the files by the programs' names, or its functions disturb ours.
    @unittest.skipUnless(PACKAGE.exists(), "no package bash-completion")
    def test_bash_with_its_package(self):
        self.try_typed(["bash", "--norc", "--noprofile", "-i"], f"source {PACKAGE}")

    # Fails if a list is not whole, or words that bash takes apart are not put together.
    def test_bash_lists(self):
        def listed(*words):
            script = (
                f"source {self.data}/bash-completion/completions/offing; compopt() {{ :; }}\n"
                'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _offing; printf "%s\\n" "${COMPREPLY[@]}"'
            )
            run = subprocess.run(
                ["bash", "--norc", "-c", script, "bash", *words], capture_output=True, text=True, check=True
            )
            self.assertEqual(run.stderr, "")
            return run.stdout.split()

        tree = next(tree for tree in self.trees if tree["program"] == "offing")
        for command in tree["commands"]:
            with self.subTest(command["name"]):
                words = command["name"].split(" ")
                names = {name for option in command["options"] for name in option["names"]}
                self.assertEqual(set(listed(*words, "-")), names)
                inner = [below["name"].split(" ")[-1] for below in trees.inner_commands(tree, command)]
                self.assertEqual(listed(*words, ""), inner)
        self.assertEqual(listed("offing", "ocean", "bake", "--mesh", "=", "o"), ["obj"])
        self.assertEqual(listed("offing", "ocean", "bake", "--mesh", "="), ["none", "obj", "ply"])
        self.assertEqual(listed("offing", "ocean", "bake", "--seed", ""), [])

    # Fails if _arguments does not understand a specification, or a completion is wrong.
    @unittest.skipUnless(shutil.which("zsh"), "no zsh (package zsh)")
    def test_zsh(self):
        self.try_typed(
            ["zsh", "-f", "-i"],
            f"unsetopt auto_remove_slash; fpath=({self.data}/zsh $fpath)",
            "autoload -U compinit; compinit -u -D",
        )

    # Fails if fish lists another thing than the commands, options and values of the place.
    @unittest.skipUnless(shutil.which("fish"), "no fish (package fish)")
    def test_fish(self):
        sources = "; ".join(f"source {self.data}/fish/vendor_completions.d/{name}.fish" for name in self.names)

        def listed(line):
            run = subprocess.run(
                ["fish", "--no-config", "-c", f"{sources}; complete -C '{line}'"],
                cwd=self.files,
                env=self.environment,
                capture_output=True,
                text=True,
            )
            self.assertEqual((run.returncode, run.stderr), (0, ""))
            return [found.split("\t")[0] for found in run.stdout.splitlines()]

        self.assertEqual(listed("offing oc"), ["ocean"])
        self.assertEqual(listed("offing ocean bake --wind-s"), ["--wind-speed-mps"])
        self.assertEqual(listed("offing ocean bake --spectrum p"), ["phillips", "pm"])
        self.assertEqual(listed("offing ocean bake -o f"), ["frames/"])
        self.assertEqual(listed("offing ocean bake m"), ["my sea.toml"])
        self.assertEqual(listed("offing ocean bake --spectrum-file f"), ["frames.txt", "frames/"])
        self.assertEqual(listed("offing ocean bake --seed m"), [])
        tree = next(tree for tree in self.trees if tree["program"] == "offing")
        below = [command["name"].split(" ")[1] for command in trees.inner_commands(tree, tree["commands"][0])]
        self.assertEqual(listed("offing "), sorted(below))
        bake = next(command for command in tree["commands"] if command["name"] == "offing ocean bake")
        self.assertEqual(
            sorted(listed("offing ocean bake --")),
            sorted(name for option in bake["options"] for name in option["names"] if name.startswith("--")),
        )


if __name__ == "__main__":
    unittest.main(argv=["completions_test.py"])
