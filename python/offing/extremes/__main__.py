"""Runs `python -m offing.extremes`. Workers import this file too, and must not run the program."""

import sys

from offing.extremes.program import main

if __name__ == "__main__":
    sys.exit(main())
