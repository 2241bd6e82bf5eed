"""Links and file names in the documentation lead somewhere."""

import pathlib
import re

from repository import run

LINK = re.compile(r"\]\(([^)\s]+)\)")
# A path in backticks that starts at a folder of the root and names one file or folder.
NAMED_PATH = re.compile(r"`((?:kernels|host|tests|examples|docs|scenes|present|mesh_tools)/[\w./-]*)`")


def check(repository):
    faults = []
    for path in repository.files:
        if not path.endswith(".md"):
            continue
        folder = (repository.root / path).parent
        for number, line in enumerate(repository.text(path).splitlines(), 1):
            targets = [(folder, link) for link in LINK.findall(line) if not re.match(r"[a-z]+:|#", link)]
            targets += [(repository.root, name) for name in NAMED_PATH.findall(line)]
            for base, target in targets:
                if not (pathlib.Path(base) / target.split("#")[0]).exists():
                    faults.append(f"{path}:{number}: {target} does not exist")
    return faults


if __name__ == "__main__":
    run(check)
