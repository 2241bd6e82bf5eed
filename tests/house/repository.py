"""The files of the repository, and how a house check reports what it found."""

import os
import pathlib
import re
import subprocess
import sys

# Looked at by no check; git hides them where there is git.
GENERATED = ("build", "out", ".git", ".cache", "__pycache__")

RAW_STRING = re.compile(r'R"([^\s()\\]{0,16})\(.*?\)\1"', re.DOTALL)


class Repository:
    """A source tree: what git tracks or would track; every file where git or its data are absent."""

    def __init__(self, root):
        self.root = pathlib.Path(root).resolve()
        self.files = sorted(self._git_files() or self._walked_files())

    def under(self, *folders, suffixes):
        """Paths below the folders whose name ends in one of the suffixes."""
        starts = tuple(folder + "/" for folder in folders)
        return [path for path in self.files if path.startswith(starts) and path.endswith(suffixes)]

    def text(self, path):
        return (self.root / path).read_text(encoding="utf-8")

    def code(self, path):
        """The text with the contents of raw strings blanked, lines kept: what the compiler reads as code."""
        return RAW_STRING.sub(lambda match: "\n" * match.group().count("\n"), self.text(path))

    def _git_files(self):
        # The clone may belong to another user, who is trusted here because nothing of it is run.
        command = ["git", "-c", "safe.directory=*", "-C", str(self.root), "ls-files", "-z"]
        command += ["--cached", "--others", "--exclude-standard"]
        try:
            listing = subprocess.run(command, capture_output=True, check=True).stdout.decode()
        except (OSError, subprocess.CalledProcessError):
            return []
        return [path for path in set(listing.split("\0")) if path and (self.root / path).is_file()]

    def _walked_files(self):
        found = []
        for folder, subfolders, names in os.walk(self.root):
            subfolders[:] = [
                name for name in subfolders if name not in GENERATED and not name.startswith("build-")
            ]
            found += [(pathlib.Path(folder) / name).relative_to(self.root).as_posix() for name in names]
        return found


def run(check):
    """Runs check(repository) -> faults on the folder named on the command line; each fault is one line."""
    faults = check(Repository(sys.argv[1]))
    for fault in faults:
        print(fault)
    sys.exit(1 if faults else 0)
