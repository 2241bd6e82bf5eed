"""One concept, one stem: a kernel file holds the kernel of its name, a host file of the same folder
launches it, kernels/README.md lists it with caller and test; file names are snake_case; each C++ file is part
of the build."""

import pathlib
import re

from repository import run

# A kernel is written out, or made by including a skeleton that reads its name from a ..._KERNEL macro.
KERNEL_NAMES = (
    re.compile(
        r"\b(?:__kernel|kernel)\s+(?:__attribute__\s*\(\(.*?\)\)\)?\s*)?void\s+(\w+)\s*\(", re.DOTALL
    ),
    re.compile(r"#define\s+\w+_KERNEL\s+(\w+)"),
)
INDEX = "kernels/README.md"
SNAKE_CASE = re.compile(r"[a-z0-9_]+\.[a-z0-9]+")


def kernel_faults(repository):
    index = repository.text(INDEX).splitlines() if INDEX in repository.files else []
    for path in repository.under("kernels", suffixes=(".cl",)):
        name = path.removeprefix("kernels/")
        stem = pathlib.PurePosixPath(path).stem
        text = repository.text(path)
        found = {kernel for pattern in KERNEL_NAMES for kernel in pattern.findall(text)}
        if found != {stem}:
            yield f"{path}: expected one kernel, {stem}; found {', '.join(sorted(found)) or 'none'}"
        callers = repository.under(f"host/{name.split('/')[0]}", suffixes=(".cpp",))
        if not any(f'"{name}"' in repository.text(caller) for caller in callers):
            yield f'{path}: no file in host/{name.split("/")[0]} holds the literal "{name}"'
        rows = [line for line in index if name in line]
        if not any("host/" in row and "tests/" in row for row in rows):
            yield f"{path}: {INDEX} has no row that names it, its caller in host/ and its test in tests/"


def name_faults(repository):
    folders = ("kernels", "host", "present", "mesh_tools", "tests", "scenes", "examples")
    for path in repository.under(*folders, suffixes=(".h", ".cpp", ".cl", ".clh", ".py", ".sh", ".toml")):
        if not SNAKE_CASE.fullmatch(pathlib.PurePosixPath(path).name):
            yield f"{path}: file names are snake_case"


def build_faults(repository):
    for path in repository.under("host", "present", "mesh_tools", "tests", "examples", suffixes=(".cpp",)):
        for folder in pathlib.PurePosixPath(path).parents:
            build_file = (folder / "CMakeLists.txt").as_posix()
            relative = re.escape(pathlib.PurePosixPath(path).relative_to(folder).as_posix())
            listed = re.compile(rf"(?<![\w/]){relative}\b")
            if build_file in repository.files and listed.search(repository.text(build_file)):
                break
        else:
            yield f"{path}: no CMakeLists.txt above it compiles it"


def check(repository):
    return [*kernel_faults(repository), *name_faults(repository), *build_faults(repository)]


if __name__ == "__main__":
    run(check)
