"""OpenCL drivers that pip has installed beside this Python, which the loader does not look for by itself."""

import functools
import os
import pathlib
import sys

LIBRARY = pathlib.Path(sys.prefix) / "lib" / "libintelocl.so"  # of intel-opencl-rt


@functools.cache
def find_installed_drivers():
    """Makes the loader offer the driver from PyPI where the system has none. Variables that are set stay."""
    if "OCL_ICD_VENDORS" in os.environ or "OCL_ICD_FILENAMES" in os.environ:
        return
    if LIBRARY.exists() and not any(pathlib.Path("/etc/OpenCL/vendors").glob("*.icd")):
        # One loader reads the first, the other one the second.
        os.environ["OCL_ICD_VENDORS"] = os.environ["OCL_ICD_FILENAMES"] = str(LIBRARY)
