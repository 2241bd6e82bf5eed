"""For tests of host/command_line/reference: its modules, and the programs that the test was started with."""

import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = sys.argv[1:]
sys.path.insert(0, str(ROOT / "host/command_line/reference"))
