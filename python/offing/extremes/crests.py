"""Crests and maxima of time series: elevations [time, point], m."""

import numpy as np

BIN_SIGMA, BINS_SIGMA = 0.02, 8.0  # width of the bins of heights, and the highest level


def with_peaks(elevation_m):
    """The series with raised local maxima, and a mask of these maxima.

    Each is raised to the top of the parabola through it and its two neighbours."""
    before, here, after = elevation_m[:-2], elevation_m[1:-1], elevation_m[2:]
    is_maximum = np.zeros(elevation_m.shape, dtype=bool)
    is_maximum[1:-1] = (here > before) & (here >= after)
    bend = np.where(is_maximum[1:-1], 2.0 * here - before - after, 1.0)
    raised = np.array(elevation_m)
    raised[1:-1] += np.where(is_maximum[1:-1], np.square(after - before) / (8.0 * bend), 0.0)
    return raised, is_maximum


def refined(elevation_m):
    """The series at half its time step. A polynomial of degree 7 through 8 samples gives each new one; 3 samples at
    each end are lost."""
    count = len(elevation_m) - 7
    between = sum(
        weight * (elevation_m[3 - i : 3 - i + count] + elevation_m[4 + i : 4 + i + count])
        for i, weight in enumerate((1225 / 2048, -245 / 2048, 49 / 2048, -5 / 2048))
    )
    both = np.empty((2 * count + 1, *elevation_m.shape[1:]))
    both[::2], both[1::2] = elevation_m[3 : 4 + count], between
    return both


def crest_heights(elevation_m, end):
    """Crest heights at all points: the highest elevation between one zero up-crossing and the next.

    It counts waves that begin before index `end`. The series must be longer, so that it cuts off none of these: long
    waves, which are higher, would be cut off more often."""
    raised, _ = with_peaks(elevation_m)
    heights = [np.zeros(0)]
    for series, peaks in zip(elevation_m.T, raised.T, strict=True):
        starts = np.flatnonzero((series[:-1] <= 0.0) & (series[1:] > 0.0)) + 1
        if len(starts) > 1:
            heights.append(np.maximum.reduceat(peaks[: starts[-1]], starts[:-1])[starts[:-1] < end])
    return np.concatenate(heights)


def maximum_heights(elevation_m, end):
    """Heights of positive local maxima at all points, before index `end`."""
    raised, is_maximum = with_peaks(elevation_m)
    heights = raised[:end][is_maximum[:end]]
    return heights[heights > 0.0]


def moments(elevation_m, step_s):
    """m0 (m^2), m2 (m^2/s^2) and m4 (m^2/s^4): mean squares of the elevation and its first two derivatives.

    Central differences of eighth order give the derivatives."""
    first = np.array([0.0, 4 / 5, -1 / 5, 4 / 105, -1 / 280]) / step_s
    second = np.array([-205 / 72, 8 / 5, -1 / 5, 8 / 315, -1 / 560]) / step_s**2
    inner = slice(4, len(elevation_m) - 4)

    def shifted(by):
        return elevation_m[inner.start + by : inner.stop + by]

    velocity = sum(first[i] * (shifted(i) - shifted(-i)) for i in range(1, 5))
    acceleration = second[0] * shifted(0) + sum(second[i] * (shifted(i) + shifted(-i)) for i in range(1, 5))
    return [float(np.mean(np.square(values))) for values in (elevation_m, velocity, acceleration)]


def counted(elevation_m, *, unit_m, step_s, end):
    """Counts of crests and maxima before index `end` of elevations [time, point], and the moments.

    The bins of heights are BIN_SIGMA * unit_m wide."""
    # A quarter of the time step: a low crest may be shorter than a step and fall between two samples.
    fine = refined(refined(elevation_m))
    edges = np.append(np.arange(0.0, BINS_SIGMA, BIN_SIGMA), np.inf) * unit_m
    crests, maxima = crest_heights(fine, 4 * end), maximum_heights(fine, 4 * end)
    return {
        "crests": ("height", np.histogram(crests, edges)[0]),
        "maxima": ("height", np.histogram(maxima, edges)[0]),
        "moments": ("order", moments(elevation_m, step_s)),
        "highest_m": crests.max(initial=0.0),
    }
