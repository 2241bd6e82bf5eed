"""How a test comes to a package of PyPI: it goes on in the Python that has the package, or skips with the reason."""

import os
import pathlib
import struct
import subprocess
import sys

SKIPPED = 77  # SKIP_RETURN_CODE of the tests


def skip(reason):
    print(f"{sys.argv[0]}: Skipped\n{reason}")
    sys.exit(SKIPPED)


def enter(package):
    """Takes TEST.py PYTHON PROGRAM... SCENES to a process of PYTHON, which has `package`. Returns PROGRAM..., SCENES."""
    python, *programs, scenes = sys.argv[1:]
    if os.environ.get("OFFING_PEER") != package:
        if not pathlib.Path(python).exists():
            skip(f"no virtual environment with {package}: ./dev test --slow makes it")
        found = subprocess.run([python, "-c", f"import {package}"], capture_output=True, text=True)
        if found.returncode != 0:
            skip(f"{package} cannot be imported: {(found.stderr.strip().splitlines() or ['no reason'])[-1]}")
        os.environ["OFFING_PEER"] = package
        os.execv(python, [python, "-B", *sys.argv])
    return *programs, pathlib.Path(scenes)


def run(offing, *arguments):
    """The output of an offing command, which must succeed."""
    return subprocess.run([offing, *map(str, arguments)], check=True, stdout=subprocess.PIPE, text=True).stdout


def header_of(file, name):
    """A number in the header of an EXR file."""
    content, size = file.read_bytes(), 4
    place = content.index(name.encode() + b"\0") + len(name) + 1
    for label, form in ((b"float\0", "<f"), (b"double\0", "<d")):
        if content.startswith(label, place):
            return struct.unpack_from(form, content, place + len(label) + size)[0]
    raise AssertionError(f"{file.name}: {name} is no number")
