"""The layout: folders that can be taken in at a glance, and headers whose names say which they are."""

import collections
import pathlib

from repository import run

MOST_FILES = 40
FOLDERS = ("kernels", "host", "present", "mesh_tools", "tests", "examples")


def check(repository):
    files = collections.defaultdict(list)
    headers = collections.defaultdict(list)
    for path in repository.files:
        folder, name = str(pathlib.PurePosixPath(path).parent), pathlib.PurePosixPath(path).name
        if not path.startswith(tuple(f"{top}/" for top in FOLDERS)):
            continue
        files[folder].append(name)
        if name.endswith((".h", ".clh")):
            headers[name].append(path)
    faults = [
        f"{folder}: {len(names)} files, expected at most {MOST_FILES}; make subfolders or merge helpers"
        for folder, names in sorted(files.items())
        if len(names) > MOST_FILES
    ]
    faults += [
        f"headers of the same name: {', '.join(paths)}" for paths in headers.values() if len(paths) > 1
    ]
    return faults


if __name__ == "__main__":
    run(check)
