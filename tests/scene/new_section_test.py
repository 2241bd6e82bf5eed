"""new_section_test.py SOURCES [build]: docs/architecture.md shows by two patches what a new section and a new
parameter cost. They apply to the tree and have no more lines than it says. With `build` a copy of the tree
with both is built, and its tests of scenes pass."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "house"))
from repository import Repository  # noqa: E402

MOST_OUTSIDE_SECTION, MOST_FOR_PARAMETER = 12, 3
PATCH = re.compile(r"^```diff\n(.*?)^```", re.DOTALL | re.MULTILINE)


def copied_tree(sources, folder):
    """Without pictures of the documentation."""
    for name in Repository(sources).files:
        if name.startswith("docs/") and not name.endswith(".md"):
            continue
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(sources / name, folder / name)


def apply(patch, folder, *options):
    """Outside a repository git applies to the files as they are, so none must be found above the folder."""
    outside = os.environ | {"GIT_CEILING_DIRECTORIES": str(folder.parent)}
    command = ["git", "apply", *options]
    done = subprocess.run(command, cwd=folder, env=outside, input=patch, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"docs/architecture.md: a patch does not apply: {done.stderr}\nhint: update its context lines")
    return done.stdout


def added_lines(patch, folder):
    lines = apply(patch, folder, "--numstat").splitlines()
    return {path: int(added) for added, _, path in (line.split("\t") for line in lines)}


def require_at_most(most, found, what):
    print(f"{what}: {found} lines, at most {most}")
    if found > most:
        sys.exit(f"{what}: expected at most {most} lines, found {found}")


def build_and_test(folder, sources_built):
    build = folder / "build"
    options = ["BUILD_BENCH=OFF", "BUILD_MESH_TOOLS=OFF", "INSTALL=OFF", "PRECOMPILE_HEADERS=ON"]
    configure = ["cmake", "-S", folder, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug"]
    configure += ["-DCMAKE_CXX_FLAGS_DEBUG="]  # no debug information, which takes time and is never read
    subprocess.run(configure + [f"-DOFFING_{option}" for option in options], check=True)
    jobs = os.environ.get("OFFING_JOBS", str(os.cpu_count()))
    objects = [f"{folder / source}^" for source in sources_built]  # Ninja's name for what is made of a source
    make = ["cmake", "--build", build, "--parallel", jobs, "--target", "scene_tests"]
    subprocess.run(make + objects, check=True)
    tests = build / "tests/scene_tests"
    writing = os.environ | {"OFFING_WRITE_GUIDE": "1"}
    subprocess.run([tests, "--gtest_filter=SceneGuide.ListsEveryKey"], env=writing, check=True)
    subprocess.run([tests, "--gtest_brief=1"], check=True)
    page = (folder / "docs/reference/scene_keys.md").read_text(encoding="utf-8")
    if not re.search(r"^## `\[buoy\]`\n\n.*\n.*\n\| `height_m` .*\n\| `width_m` ", page, re.MULTILINE):
        sys.exit("docs/reference/scene_keys.md: expected the tables to list [buoy] and its two keys")


def main(sources, *mode):
    section, parameter = PATCH.findall((sources / "docs/architecture.md").read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary).resolve()
        copied_tree(sources, folder)
        cost = added_lines(section, folder)
        outside = {path: lines for path, lines in cost.items() if (folder / path).exists()}
        require_at_most(MOST_OUTSIDE_SECTION, sum(outside.values()), "a section outside its own files")
        apply(section, folder)
        lines = sum(added_lines(parameter, folder).values())
        require_at_most(MOST_FOR_PARAMETER, lines, "a parameter outside its use")
        apply(parameter, folder)
        if mode == ("build",):
            build_and_test(folder, [path for path in cost if path.endswith(".cpp")])


main(pathlib.Path(sys.argv[1]).resolve(), *sys.argv[2:])
