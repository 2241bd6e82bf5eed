"""OpenCL drivers that pip has installed beside this Python, which the loader does not look for by itself."""

import functools
import os
import pathlib
import sys
import sysconfig

# Libraries of drivers, as their packages on PyPI install them below the environment's folder of libraries.
LIBRARIES = ("libintelocl.so", "pocl_binary_distribution/.libs/libpocl.so")


def candidates():
    """Folders that packages put libraries into."""
    yield pathlib.Path(sys.prefix) / "lib"
    yield pathlib.Path(sysconfig.get_path("platlib"))


@functools.cache
def find_installed_drivers():
    """Makes the loader offer drivers from PyPI where the system has none. Variables that are set stay."""
    if "OCL_ICD_VENDORS" in os.environ or "OCL_ICD_FILENAMES" in os.environ:
        return
    if any(pathlib.Path("/etc/OpenCL/vendors").glob("*.icd")):
        return
    for folder in candidates():
        for name in LIBRARIES:
            if (folder / name).exists():
                # One loader reads the first, the other one the second.
                os.environ["OCL_ICD_VENDORS"] = os.environ["OCL_ICD_FILENAMES"] = str(folder / name)
                return
