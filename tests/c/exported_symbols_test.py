"""exported_symbols_test.py LIBRARY HEADER MAP: liboffing.so shows the calls of its header and nothing else, and loads no
large library by itself."""

import ctypes
import pathlib
import re
import subprocess
import sys
import unittest

LIBRARY, HEADER, MAP = (pathlib.Path(argument) for argument in sys.argv[1:4])


def without_comments(path):
    return re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)


class ExportedSymbolsTest(unittest.TestCase):
    # Fails if a call is missing from the library, or anything else of ours or of a static library can be seen.
    def test_calls_of_the_header_alone(self):
        lines = subprocess.run(
            ["nm", "--dynamic", "--defined-only", LIBRARY], check=True, capture_output=True, text=True
        ).stdout.splitlines()
        shown = sorted(name.split("@")[0] for name in (line.split()[-1] for line in lines) if not name.startswith("OFFING_"))
        declared = sorted(set(re.findall(r"\b(offing_\w+)\(", without_comments(HEADER))))
        self.assertEqual(shown, declared)

    # Fails if a call that was released is taken away: the map lists all that ever were.
    def test_map_lists_them(self):
        listed = re.findall(r"\b(offing_\w+);", without_comments(MAP))
        declared = set(re.findall(r"\b(offing_\w+)\(", without_comments(HEADER)))
        self.assertEqual(set(listed), declared)
        self.assertEqual(listed, sorted(listed))

    # Fails if a program that only opens the library waits for GDAL, OpenVDB or NetCDF.
    def test_loads_no_large_library(self):
        library = ctypes.CDLL(str(LIBRARY))
        library.offing_interface.restype = ctypes.c_int
        self.assertGreaterEqual(library.offing_interface(), 1)
        loaded = pathlib.Path("/proc/self/maps").read_text()
        for name in ("libgdal", "libopenvdb", "libnetcdf", "libcairo", "libtbb"):
            self.assertNotIn(name, loaded)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
