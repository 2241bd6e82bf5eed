"""Finds an OpenCL driver that pip installed. The OpenCL loader does not look for it there."""

import functools
import os
import pathlib
import sys

LIBRARY = pathlib.Path(sys.prefix) / "lib" / "libintelocl.so"  # of intel-opencl-rt


@functools.cache
def find_installed_drivers():
    """Makes the loader use the driver from PyPI if the system has none. Does nothing if a loader's variable is set."""
    if "OCL_ICD_VENDORS" in os.environ or "OCL_ICD_FILENAMES" in os.environ:
        return
    if LIBRARY.exists() and not any(pathlib.Path("/etc/OpenCL/vendors").glob("*.icd")):
        # Each of the two common loaders reads one of these.
        os.environ["OCL_ICD_VENDORS"] = os.environ["OCL_ICD_FILENAMES"] = str(LIBRARY)
