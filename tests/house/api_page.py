"""docs/api.md: its code stands in the examples that it names, which are compiled, and its table has every folder whose
headers are installed."""

import re

from repository import run

PAGE = "docs/api.md"
EXAMPLE = re.compile(r"\bFrom `(examples/[\w.]+)`")
BLOCK = re.compile(r"^```(?:c|cpp)\n(.*?)^```", re.M | re.S)
NOT_INSTALLED = ("host/cli", "host/command_line", "host/install")


def code_faults(repository, text):
    # A block is from the example that was named last.
    for block in BLOCK.finditer(text):
        named = EXAMPLE.findall(text, 0, block.start())
        if not named:
            yield f"{PAGE}: a block of code is from no example"
            continue
        lines = [line.strip() for line in repository.text(named[-1]).splitlines()]
        place = 0
        for line in block.group(1).splitlines():
            if line.strip() not in lines[place:]:
                yield f"{PAGE}: {named[-1]} has no line, or not there: {line.strip()}"
                break
            place = lines.index(line.strip(), place) + 1


def folder_faults(repository, text):
    found = {"/".join(path.split("/")[:2]) for path in repository.under("host", "kernels/shared", suffixes=(".h",))}
    for folder in sorted(found - set(NOT_INSTALLED)):
        if f"| `{folder}` |" not in text:
            yield f"{PAGE}: no row for {folder}"


def check(repository):
    if PAGE not in repository.files:
        return []
    text = repository.text(PAGE)
    return [*code_faults(repository, text), *folder_faults(repository, text)]


if __name__ == "__main__":
    run(check)
