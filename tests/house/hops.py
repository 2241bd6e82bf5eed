"""Checks the table of docs/architecture.md that follows values of a scene from their row to their formula, kernel
or shader: it lists the files on the way and every other file that names the value."""

import re

from repository import run

PAGE = "docs/architecture.md"
HEADING = "### From its row to its formula"
SOURCES = (".h", ".cpp", ".cl", ".clh", ".glsl", ".vert", ".frag")
PATH = re.compile(r"`((?:kernels|host|present|mesh_tools)/[\w./]*)`")


def pattern(name):
    """A name, or one of its components: sun_direction_x of sun_direction, eye_x_m of eye_m."""
    stem, _, unit = name.rpartition("_")
    return re.compile(rf"\b(?:{name}(?:_[xyz])?|{stem}_[xyz]_{unit})\b")


def section(repository):
    """The lines below the heading, up to the next one."""
    text = repository.text(PAGE) if PAGE in repository.files else ""
    return re.split(r"^#", text.partition(HEADING + "\n")[2], maxsplit=1, flags=re.MULTILINE)[0]


def table_rows(text):
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line[:1] == "|"]
    return cells[2:]


def check(repository):
    text = section(repository)
    prose = "\n".join(line for line in text.splitlines() if line[:1] != "|")
    generic = set(PATH.findall(prose))
    sources = repository.under("kernels", "host", "present", "mesh_tools", suffixes=SOURCES)
    faults = [] if text else [f'{PAGE}: no "{HEADING}"']
    for value, name, most, way, others in table_rows(text):
        name, way, others = name.strip("`"), PATH.findall(way), PATH.findall(others)
        if len(way) > int(most):
            faults.append(f"{PAGE}: {value}: {len(way)} files, expected at most {most}")
        naming = {path for path in sources if pattern(name).search(repository.text(path))}
        folders = tuple(path for path in others if path.endswith("/"))
        for path in [*way, *others]:
            if not any(named == path or path in folders and named.startswith(path) for named in naming):
                faults.append(f"{PAGE}: {value}: {path} does not name {name}")
        for path in sorted(naming - {*way, *others} - generic):
            if not path.startswith(folders):
                faults.append(f"{path}: names {name} and is not in the table of {PAGE}")
    return faults


if __name__ == "__main__":
    run(check)
