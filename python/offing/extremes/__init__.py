"""A study of crest heights: `python -m offing.extremes scenes/example_sea.data_spec --seeds 200 -o crests`.

It simulates the elevation at many points for many seeds, and compares the distribution of crest heights with theory.
It counts two kinds of heights above the mean water level:

- A crest is the highest point between two zero up-crossings. In a linear sea P(crest > h) <= exp(-h^2 / 2 m0), the
  Rayleigh distribution. Each wave with a crest above h crosses h upward at least once, and Rice (1945) gives the rate
  of these crossings. A wave may cross a low level twice, so low crests are rarer than Rayleigh. High crests follow
  Rayleigh for any bandwidth.
- A maximum is any local maximum above the mean level. In a linear sea, maxima follow Rayleigh's distribution with a
  correction for bandwidth (Cartwright & Longuet-Higgins 1956). This is exact at every height.

Theory takes the spectral moments m0, m2 and m4, in angular frequency, from the simulated elevations. The limits come
from a bootstrap over seeds. Seeds are independent; points and waves of one seed are not.
"""

from offing.extremes.band import FEWEST_COUNTED, HIGH_SIGMA, LEVELS_SIGMA, RESAMPLES, analyse, exceedance
from offing.extremes.crests import (
    BIN_SIGMA,
    BINS_SIGMA,
    counted,
    crest_heights,
    maximum_heights,
    moments,
    refined,
    with_peaks,
)
from offing.extremes.output import plot, print_results, simulated_time, table_rows, to_json, write_all, write_table
from offing.extremes.program import Parser, main, parse, run_program, scene_of, show_progress
from offing.extremes.study import (
    GRAVITY_MPS2,
    PATCH_WAVELENGTHS,
    POINTS_A_SIDE,
    peak_wavelength_m,
    run_study,
    study_member,
    study_scene,
)
from offing.extremes.theory import cartwright_longuet_higgins, rayleigh

__all__ = [
    "BINS_SIGMA",
    "BIN_SIGMA",
    "FEWEST_COUNTED",
    "GRAVITY_MPS2",
    "HIGH_SIGMA",
    "LEVELS_SIGMA",
    "PATCH_WAVELENGTHS",
    "POINTS_A_SIDE",
    "Parser",
    "RESAMPLES",
    "analyse",
    "cartwright_longuet_higgins",
    "counted",
    "crest_heights",
    "exceedance",
    "main",
    "maximum_heights",
    "moments",
    "parse",
    "peak_wavelength_m",
    "plot",
    "print_results",
    "rayleigh",
    "refined",
    "run_program",
    "run_study",
    "scene_of",
    "show_progress",
    "simulated_time",
    "study_member",
    "study_scene",
    "table_rows",
    "to_json",
    "with_peaks",
    "write_all",
    "write_table",
]
