"""Each #include must go along an arrow of the architecture: lower folders never know higher ones. What includes
a GPL library says so in its first line."""

import re

from repository import run

# Folder -> folders that it may include; what those include follows. Simulations (ocean, terrain, ...) never
# include each other: world composes them.
SIMULATIONS = ("ocean", "terrain", "clouds", "highlights", "bodies", "sky")
ARROWS = {
    "kernels": (),
    "kernels/shared": (),
    "kernels/simd": (),
    "kernels/fft": ("kernels/simd", "kernels/shared"),
    **{f"kernels/{name}": ("kernels/fft",) for name in SIMULATIONS},
    "kernels/clouds": ("kernels/fft", "kernels/sky"),
    "kernels/terrain": ("kernels/fft", "kernels/sky"),
    "host/base": ("kernels", "kernels/shared"),
    "host/io": ("host/base",),
    "host/ocl": ("host/base",),
    "host/fft": ("host/ocl",),
    **{f"host/{name}": ("host/fft",) for name in SIMULATIONS},
    "host/mesh_shapes": ("host/base",),
    "host/world": tuple(f"host/{name}" for name in SIMULATIONS),
    "host/scene": ("host/world", "host/mesh_shapes", "host/io"),
    "host/c": ("host/scene",),
    "host/command_line": ("host/scene",),
    "host/cli": ("host/command_line",),
    "present": ("host/command_line",),
    "mesh_tools": ("host/command_line",),
    "examples": ("host/c",),  # what is installed, and no programs
    "tests": ("host/c", "host/cli", "present", "mesh_tools"),
}

# Headers from outside that only some folders may include.
RESERVED = {
    r"CL/": ("host/ocl",),  # OpenCL objects stay in one folder
    r"(GL|EGL|GLFW|epoxy)/": ("present", "tests"),
    r"fftw3": ("tests",),
    r"(CGAL|OpenMesh)/": ("mesh_tools", "tests"),
}
GPL_HEADERS = re.compile(r"fftw3|CGAL/")
GPL_LINE = "// SPDX-License-Identifier: GPL-3.0-or-later"

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')


def reachable(folder):
    found = {folder}
    for lower in ARROWS[folder]:
        found |= reachable(lower)
    return found


def folder_of(path):
    """The key of ARROWS that the path lies in, or None."""
    parts = path.split("/")
    for key in ("/".join(parts[:2]), parts[0]):
        if key in ARROWS and path.startswith(key + "/"):
            return key
    return None


def fault_of(repository, path, quote, included):
    folder = folder_of(path)
    if quote == "<":
        for header, owners in RESERVED.items():
            if re.match(header, included) and folder not in owners:
                return f"<{included}> is reserved for {', '.join(owners)}"
        if GPL_HEADERS.match(included) and not repository.text(path).startswith(GPL_LINE):
            return f'<{included}> is GPL; begin the file with "{GPL_LINE} (why)"'
        return None
    # Kernels are assembled from paths below kernels/, C++ from paths below the root.
    from_root = f"kernels/{included}" if path.endswith((".cl", ".clh")) else included
    if ".." in included or not (repository.root / from_root).is_file():
        return f'no file "{from_root}"; write includes from the repository root (in kernels from kernels/)'
    if folder_of(from_root) not in reachable(folder):
        return f"{folder} must not include {folder_of(from_root) or from_root}"
    return None


def check(repository):
    faults = []
    for path in repository.under(
        "kernels", "host", "present", "mesh_tools", "tests", "examples", suffixes=(".h", ".cpp", ".cl", ".clh")
    ):
        if folder_of(path) is None:
            faults.append(f"{path}: no row for its folder in tests/house/include_arrows.py")
            continue
        for number, line in enumerate(repository.code(path).splitlines(), 1):
            match = INCLUDE.match(line)
            fault = match and fault_of(repository, path, *match.groups())
            if fault:
                faults.append(f"{path}:{number}: {fault}")
    return faults


if __name__ == "__main__":
    run(check)
