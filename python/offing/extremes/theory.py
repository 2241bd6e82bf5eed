"""The theory of crest heights in linear seas. Heights are in standard deviations of the elevation."""

import math

import numpy as np


def rayleigh(height):
    """Share of crests above a height. For any spectrum it is an upper bound (Rice 1945), and close at high levels."""
    return np.exp(-0.5 * np.square(height))


def cartwright_longuet_higgins(height, epsilon):
    """Share of positive maxima above a height >= 0.

    It is the share of all maxima above the height, divided by the share above 0. Source: Cartwright & Longuet-Higgins
    1956, The statistical distribution of the maxima of a random function. The bandwidth is epsilon^2 = 1 - m2^2 /
    (m0 m4). As it goes to 0, the distribution becomes Rayleigh's."""
    normal = np.vectorize(lambda x: 0.5 * math.erfc(-x / math.sqrt(2.0)))  # the normal distribution function
    regular = math.sqrt(1.0 - epsilon**2)
    height = np.asarray(height, dtype=float)
    above = normal(-height / epsilon) + regular * rayleigh(height) * normal(height * regular / epsilon)
    return above / (0.5 * (1.0 + regular))
