"""Limits a reader relies on: ASCII kernels, no large file in the history, no loose ends."""

import re

from repository import run

MAX_BYTES = 1_000_000  # git keeps each version for ever
SOURCES = (".h", ".cpp", ".cl", ".clh", ".cmake", ".py", ".sh", "CMakeLists.txt")
UNFINISHED = re.compile(r"\b(TO" r"DO|FIX" r"ME|XX" r"X)\b")


def check(repository):
    faults = []
    for path in repository.files:
        size = (repository.root / path).stat().st_size
        if size > MAX_BYTES:
            faults.append(f"{path}: {size} bytes, expected at most {MAX_BYTES}")
    for path in repository.under("kernels", "host", "present", "mesh_tools", "tests", "examples", suffixes=SOURCES):
        for number, line in enumerate(repository.text(path).splitlines(), 1):
            if path.startswith("kernels/") and not line.isascii():
                faults.append(f"{path}:{number}: expected ASCII, which every OpenCL compiler reads")
            if UNFINISHED.search(line):
                faults.append(f"{path}:{number}: unfinished work is an issue, not a comment")
    return faults


if __name__ == "__main__":
    run(check)
