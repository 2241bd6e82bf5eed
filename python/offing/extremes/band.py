"""The distribution of heights over all seeds, its limits, and the band in which theory lies."""

import math

import numpy as np

from offing.extremes.crests import BIN_SIGMA
from offing.extremes.theory import cartwright_longuet_higgins, rayleigh

LEVELS_SIGMA = np.arange(1, 25) * 0.25
FEWEST_COUNTED = 30  # a level with fewer heights above it is not compared with theory
HIGH_SIGMA = 2.0  # Hs / 2: crests above it follow Rayleigh
RESAMPLES = 2000  # of the bootstrap


def exceedance(counts, unit_in_sigma, levels):
    """Share of heights above each level. Levels are in sigma; counts [..., bin] have bins of BIN_SIGMA units."""
    above = np.concatenate(
        [np.cumsum(counts[..., ::-1], axis=-1)[..., ::-1], np.zeros((*counts.shape[:-1], 1))], axis=-1
    )
    # The last bin has no upper end: its heights lie above every level.
    place = np.clip(levels / unit_in_sigma / BIN_SIGMA, 0, counts.shape[-1] - 1)
    index = np.minimum(place.astype(int), counts.shape[-1] - 2)
    low = np.take_along_axis(above, index, axis=-1)
    high = np.take_along_axis(above, index + 1, axis=-1)
    return (low + (place - index) * (high - low)) / above[..., :1]


def analyse(members, unit_m, seed=1):
    """The results of a study: its table, a dict with an array over levels for each column, and single numbers.

    `members` is the data set of all study_member() results; `seed` is that of the bootstrap."""
    spectral = members["moments"].values
    random = np.random.default_rng(seed)
    count = len(spectral)
    weights = random.multinomial(count, np.full(count, 1.0 / count), size=RESAMPLES).astype(float)

    def epsilon_of(values):
        return np.sqrt(1.0 - values[..., 1] ** 2 / (values[..., 0] * values[..., 2]))

    m = spectral.mean(axis=0)
    resampled = weights @ spectral / count
    sigma_m, epsilon = math.sqrt(m[0]), float(epsilon_of(m))
    found = {"sigma_m": sigma_m, "epsilon": epsilon, "tm02_s": 2.0 * math.pi * math.sqrt(m[0] / m[1])}
    table = {"level_sigma": LEVELS_SIGMA, "level_m": LEVELS_SIGMA * sigma_m}
    theories = {
        "crests": lambda e: rayleigh(LEVELS_SIGMA),
        "maxima": lambda e: cartwright_longuet_higgins(LEVELS_SIGMA, e),
    }
    for kind, theory in theories.items():
        counts = members[kind].values.astype(float)
        total = counts.sum(axis=0)
        share = exceedance(total, unit_m / sigma_m, LEVELS_SIGMA)
        sigmas_m = np.sqrt(resampled[:, :1])
        shares = exceedance(
            weights @ counts, unit_m / sigmas_m, np.broadcast_to(LEVELS_SIGMA, (RESAMPLES, len(LEVELS_SIGMA)))
        )
        expected = theory(epsilon)
        # The theory's slope in epsilon, because each resample has an epsilon of its own.
        slope = (theory(epsilon + 1e-4) - theory(epsilon - 1e-4)) / 2e-4
        differences = shares - expected - (epsilon_of(resampled)[:, None] - epsilon) * slope
        error = differences.std(axis=0)
        is_compared = (share * total.sum() >= FEWEST_COUNTED) & (error > 0.0)
        if kind == "crests":
            is_compared &= LEVELS_SIGMA >= HIGH_SIGMA
        deviation = np.zeros(len(LEVELS_SIGMA))
        deviation[is_compared] = (share - expected)[is_compared] / error[is_compared]
        # Half the width of the band in standard errors: 95 % of resamples lie inside it at all levels at once.
        largest = np.abs((differences - (share - expected))[:, is_compared] / error[is_compared]).max(
            axis=1, initial=0.0
        )
        width = float(np.quantile(largest, 0.95))
        # With few seeds the band is wider, as Student's t is wider than the normal distribution.
        width *= math.sqrt(count / (count - 1)) * (1.0 + (width**2 + 1.0) / (4.0 * (count - 1)))
        table[kind] = share
        table[f"{kind}_low"], table[f"{kind}_high"] = np.quantile(shares, [0.025, 0.975], axis=0)
        table[f"{kind}_theory"] = expected
        table[f"{kind}_band_low"] = np.where(is_compared, expected - width * error, np.nan)
        table[f"{kind}_band_high"] = np.where(is_compared, expected + width * error, np.nan)
        found[kind] = {
            "count": int(total.sum()),
            "levels_compared": int(is_compared.sum()),
            "band_standard_errors": width,
            "largest_standard_errors": float(np.abs(deviation).max()),
            "in_band": bool(is_compared.any() and np.abs(deviation).max() <= width),
        }
    found["highest_m"] = float(members["highest_m"].max())
    found["table"] = table
    return found
