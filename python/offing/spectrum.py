"""Wave spectra from files, arrays, models and xarray data sets of wavespectra."""

from __future__ import annotations

import math
import os

import numpy as np
import numpy.typing as npt

from offing import _core
from offing.errors import BadInput
from offing.scene import Scene

# numpy 2 has another name for it.
_integral = getattr(np, "trapezoid", None) or np.trapz


class Spectrum:
    """The energy of a sea over frequency and direction. A spectrum does not change. Its attributes:

    frequencies_hz [nf]; energy is linear between them and zero outside.
    energy [nf], m^2/Hz.
    directions_rad [nd], of travel, from +x (east) toward +z (south); empty if not known.
    density [nf, nd], m^2/Hz/rad; None if directions are not known.
    latitude_deg, longitude_deg, depth_m: NaN if not known.
    station, time_utc: "" if not known.
    """

    def __init__(self, spectra, index=0):
        """Wraps one spectrum of the core's list. Use the class methods instead."""
        self._spectra, self._index = spectra, index
        self.__dict__.update(spectra.at(index))

    @classmethod
    def read(cls, file: str | os.PathLike) -> "list[Spectrum]":
        """All spectra of a file, as a list: NDBC, WAVEWATCH III, SWAN, Datawell, TRIAXYS, Octopus, Spotter or
        NetCDF, as wavespectra writes it too, also compressed by gzip."""
        spectra = _core.Spectra.read(file)
        return [cls(spectra, index) for index in range(len(spectra))]

    @classmethod
    def from_arrays(cls, frequencies_hz: npt.ArrayLike, energy: npt.ArrayLike | None = None,
                    directions_rad: npt.ArrayLike | None = None, density: npt.ArrayLike | None = None, *,
                    latitude_deg: float = math.nan, longitude_deg: float = math.nan, depth_m: float = math.nan,
                    station: str = "", time_utc: str = "") -> "Spectrum":
        """A spectrum from arrays: `energy` [nf] alone, or `density` [nf, nd] at `directions_rad` [nd] in any order.
        Uneven directions, or those of a part of the circle, are resampled to 360 directions. Truncated Fourier series
        have negative densities. Then each frequency keeps its energy and its first two circular moments, and takes the
        spreading of maximum entropy."""
        return cls(_core.Spectra.make(
            np.ascontiguousarray(frequencies_hz, dtype=np.float64),
            None if energy is None else np.ascontiguousarray(energy, dtype=np.float64),
            None if directions_rad is None else np.ascontiguousarray(directions_rad, dtype=np.float64),
            None if density is None else np.ascontiguousarray(density, dtype=np.float64),
            latitude_deg, longitude_deg, depth_m, station, time_utc))

    @classmethod
    def of_scene(cls, scene: Scene, frequencies_hz: npt.ArrayLike | None = None, directions: int = 36) -> "Spectrum":
        """The spectrum of a scene's sea, without swells that are one wave, at these frequencies and at `directions` evenly spaced
        directions. With 0 directions it has energies alone."""
        if frequencies_hz is None:
            frequencies_hz = np.geomspace(0.03, 1.0, 100)
        return cls(scene._scene.tabulate_spectrum(np.ascontiguousarray(frequencies_hz, dtype=np.float64), directions))

    @classmethod
    def model(cls, name: str, *, wind_speed_mps: float | None = None, wind_direction_rad: float = 0.0,
              frequencies_hz: npt.ArrayLike | None = None, directions: int = 36, **values) -> "Spectrum":
        """A model spectrum: "jonswap", "pm", "tma" or "phillips". `values` are other keys of [ocean], such as fetch_m,
        depth_m and gamma. hs_m with tp_s or tz_s replaces wind and fetch. swell=[{"hs_m": 1.0, "tp_s": 14.0,
        "direction_deg": 60.0}] adds a swell. Without wind_speed_mps the wind is 10 m/s, or with hs_m it is computed from
        height and period. It blows toward wind_direction_rad, from +x (east) toward +z (south)."""
        wind = {"direction_deg": math.degrees(wind_direction_rad) % 360.0}
        if wind_speed_mps is not None:
            values["wind_speed_mps"] = float(wind_speed_mps)
        return cls.of_scene(Scene({"wind": wind, "ocean": {"spectrum": name, **values}}), frequencies_hz, directions)

    @property
    def hs_m(self) -> float:
        """Significant wave height, 4 sqrt(m0)."""
        return 4.0 * math.sqrt(_integral(self.energy, self.frequencies_hz))

    @property
    def mean_direction_rad(self) -> float:
        """Mean direction of travel, from the first circular moment of all energy; NaN if directions are not known."""
        if self.density is None:
            return math.nan
        by_direction = _integral(self.density, self.frequencies_hz, axis=0)
        return math.atan2(by_direction @ np.sin(self.directions_rad), by_direction @ np.cos(self.directions_rad))

    @property
    def peak_period_s(self) -> float:
        """The period at which the energy density is largest; NaN without energy."""
        largest = np.argmax(self.energy)
        return 1.0 / self.frequencies_hz[largest] if self.energy[largest] > 0.0 else math.nan

    @property
    def tz_s(self) -> float:
        """The mean zero-crossing period Tm02, sqrt(m0 / m2); NaN without energy."""
        m2 = _integral(self.energy * self.frequencies_hz**2, self.frequencies_hz)
        return math.sqrt(_integral(self.energy, self.frequencies_hz) / m2) if m2 > 0.0 else math.nan

    @property
    def peak_direction_rad(self) -> float:
        """Mean direction of travel at the peak period; NaN if directions are not known."""
        if self.density is None:
            return math.nan
        at_peak = self.density[np.argmax(self.energy)]
        return math.atan2(at_peak @ np.sin(self.directions_rad), at_peak @ np.cos(self.directions_rad))

    @property
    def spread_rad(self) -> float:
        """Directional spread, sqrt(2 (1 - r)) with r the length of the mean direction vector of all energy; NaN if
        directions are not known."""
        if self.density is None:
            return math.nan
        by_direction = _integral(self.density, self.frequencies_hz, axis=0)
        r = abs(by_direction @ np.exp(1j * self.directions_rad)) / by_direction.sum()
        return math.sqrt(max(2.0 * (1.0 - r), 0.0))

    @staticmethod
    def to_xarray(spectra: "Spectrum | list[Spectrum]"):
        """A data set as wavespectra has it: efth (time, freq, dir) in m^2/Hz/degree. `dir` is where waves come from, in
        degrees clockwise from north. `spectra` is a Spectrum, or a list on one grid. Needs xarray."""
        spectra = [spectra] if isinstance(spectra, Spectrum) else list(spectra)
        if not spectra:
            raise BadInput("spectra: expected at least one, got none", "pass a Spectrum, or a list of them")
        import xarray as xr

        first = spectra[0]
        for other in spectra[1:]:
            if not (np.array_equal(other.frequencies_hz, first.frequencies_hz)
                    and np.array_equal(other.directions_rad, first.directions_rad)):
                raise BadInput("spectra: expected one grid of frequencies and directions, found two",
                               "convert them one by one")
        times = [np.datetime64(spectrum.time_utc.rstrip("Z") or "NaT", "ns") for spectrum in spectra]
        coordinates = {"time": times, "freq": ("freq", first.frequencies_hz, {"units": "Hz"})}
        if first.density is None:
            return xr.Dataset({"efth": (("time", "freq"), np.stack([spectrum.energy for spectrum in spectra]),
                                        {"units": "m^2/Hz"})}, coordinates)
        from_deg = (270.0 + np.degrees(first.directions_rad)) % 360.0
        order = np.argsort(from_deg)
        efth = np.stack([spectrum.density[:, order] for spectrum in spectra]) * (np.pi / 180.0)
        coordinates["dir"] = ("dir", from_deg[order], {"units": "degree", "standard_name": "sea_surface_wave_from_direction"})
        data = xr.Dataset({"efth": (("time", "freq", "dir"), efth, {"units": "m^2/Hz/degree"})}, coordinates)
        for name, values in (("lat", "latitude_deg"), ("lon", "longitude_deg"), ("dpt", "depth_m")):
            numbers = [getattr(spectrum, values) for spectrum in spectra]
            if np.isfinite(numbers).any():
                data[name] = ("time", numbers)
        return data

    @classmethod
    def from_xarray(cls, data) -> "list[Spectrum]":
        """Spectra of a data set with efth, or of efth itself, as wavespectra has it. efth is in m^2/Hz/degree by the
        direction that waves come from, or in m^2/Hz without `dir`. The list has one spectrum for each index along the
        other dimensions, the last of them fastest."""
        efth = data["efth"] if hasattr(data, "data_vars") else data
        others = [name for name in efth.dims if name not in ("freq", "dir")]
        has_directions = "dir" in efth.dims
        efth = efth.transpose(*others, "freq", *(["dir"] if has_directions else []))
        frequencies_hz = np.asarray(efth["freq"], dtype=np.float64)
        travel_rad = np.radians(np.asarray(efth["dir"], dtype=np.float64) + 90.0) if has_directions else None
        values = np.asarray(efth, dtype=np.float64)

        def along(name, alias, place, default):
            for source in (name, alias):
                if source in getattr(data, "variables", {}) or source in efth.coords:
                    found = data[source] if source in getattr(data, "variables", {}) else efth.coords[source]
                    return np.asarray(found.isel({of: i for of, i in place.items() if of in found.dims})).item()
            return default

        spectra = []
        for index in np.ndindex(*(efth.sizes[name] for name in others)):
            place = dict(zip(others, index))
            time_utc = ""
            if "time" in efth.coords:
                time = np.asarray(efth.coords["time"].isel({of: i for of, i in place.items() if of in efth.coords["time"].dims}))
                time_utc = "" if np.isnat(time) else f"{np.datetime_as_string(time.astype('datetime64[s]'))}Z"
            about = {"latitude_deg": along("lat", "latitude", place, math.nan),
                     "longitude_deg": along("lon", "longitude", place, math.nan),
                     "depth_m": along("dpt", "depth", place, math.nan), "time_utc": time_utc}
            if has_directions:
                density = np.nan_to_num(values[index]) * (180.0 / np.pi)
                spectra.append(cls.from_arrays(frequencies_hz, directions_rad=travel_rad, density=density, **about))
            else:
                spectra.append(cls.from_arrays(frequencies_hz, np.nan_to_num(values[index]), **about))
        return spectra

    def __getstate__(self):
        names = ("frequencies_hz", "energy", "directions_rad", "density", "latitude_deg", "longitude_deg", "depth_m",
                 "station", "time_utc")
        return {name: self.__dict__[name] for name in names}

    def __setstate__(self, state):
        directional = state["density"] is not None
        made = Spectrum.from_arrays(
            state["frequencies_hz"], state["energy"], state["directions_rad"] if directional else None, state["density"],
            **{name: state[name] for name in ("latitude_deg", "longitude_deg", "depth_m", "station", "time_utc")})
        self.__dict__.update(made.__dict__)

    def __repr__(self):
        return f"<offing.Spectrum {self.station or 'of arrays'} {self.time_utc} Hs {self.hs_m:.2f} m>"
