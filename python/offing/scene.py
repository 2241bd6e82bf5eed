"""Scenes: the settings of a world, as files, text or dicts."""

from __future__ import annotations

import copy
import datetime
import json
import math
import numbers
import os
import pathlib
import tomllib

from offing import _core
from offing.errors import BadInput


def toml_value(value):
    """A value as TOML, with inline tables."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {toml_value(of)}" for key, of in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()
    if isinstance(value, (str, pathlib.PurePath)):
        return json.dumps(str(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, numbers.Integral):  # numpy's too
        return str(int(value))
    number = float(value)
    if math.isfinite(number):
        return repr(number)
    return "nan" if math.isnan(number) else ("inf" if number > 0 else "-inf")


def toml_text(values):
    """A nested dict as the text of a scene file."""
    return "".join(f"{json.dumps(str(key))} = {toml_value(value)}\n" for key, value in values.items())


def merged(values, changes):
    """A copy of `values` in which `changes` replace values, table by table. None removes a key."""
    result = copy.deepcopy(values)
    for key, value in changes.items():
        if value is None:
            result.pop(key, None)
        elif isinstance(value, dict):
            table = result.get(key)
            result[key] = merged(table if isinstance(table, dict) else {}, value)
        else:
            result[key] = copy.deepcopy(value)
    return result


class Scene:
    """The settings of a world. A scene does not change; with_values() and with_spectrum() return new ones."""

    def __init__(self, source: "Scene | str | os.PathLike | dict | None" = None, *, folder: str | os.PathLike | None = None):
        """`source` is the path of a scene file, its text, or a nested dict with its keys, such as
        {"wind": {"speed_mps": 12}, "ocean": {"size": 256}}. None is a sea with the defaults. A str with "=" or a line
        break is text; for such a path use pathlib.Path. File names in text and dicts are relative to `folder`, else to
        the working folder. Raises BadInput, which names the key."""
        self._spectrum = None
        folder = os.path.abspath(folder or ".")  # scenes may go to other processes and folders
        if source is None:
            source = {"ocean": {}}
        if isinstance(source, Scene):
            self.values, self.folder, self._spectrum = source.values, source.folder, source._spectrum
        elif isinstance(source, dict):
            self.values, self.folder = copy.deepcopy(source), folder
        elif isinstance(source, str) and ("\n" in source or "=" in source):
            self._scene = _parsed(source, folder, is_made=False)  # its errors have lines
            self.values, self.folder = tomllib.loads(source), folder
            return
        else:
            path = pathlib.Path(source).absolute()
            self._scene = _core.Scene.load(source)
            self.values, self.folder = tomllib.loads(path.read_text(encoding="utf-8-sig")), path.parent
            return
        self.values.setdefault("version", 1)
        self._make()

    def _make(self):
        self._scene = _parsed(toml_text(self.values), self.folder, is_made=True)
        if self._spectrum is not None:
            self._scene.set_spectrum(self._spectrum._spectra, self._spectrum._index)

    def with_values(self, changes: dict) -> "Scene":
        """A new scene in which values of a nested dict replace those of this one. None removes a key."""
        scene = Scene.__new__(Scene)
        scene.values, scene.folder, scene._spectrum = merged(self.values, changes), self.folder, self._spectrum
        scene._make()
        return scene

    def with_spectrum(self, spectrum) -> "Scene":
        """A new scene whose sea has this Spectrum in place of a model or a file."""
        scene = Scene.__new__(Scene)
        scene.values, scene.folder, scene._spectrum = self.values, self.folder, spectrum
        scene._make()
        return scene

    def sea_state(self) -> dict[str, float]:
        """The sea state of the spectrum, without swells that are one wave. It is a dict of hs_m, peak_period_s, tp_s, tm01_s,
        tm02_s and its other name tz_s, mean_direction_rad, peak_direction_rad, spread_rad and mss (mean square slope).
        peak_period_s is where the density E(f) is largest. tp_s is the integral of E^4 df over that of f E^4 df.
        peak_direction_rad is that of the waves at the peak period. spread_rad is the standard deviation of directions over
        all waves. Directions are of travel, from east toward south."""
        return self._scene.sea_state()

    def __getstate__(self):
        return {"values": self.values, "folder": self.folder, "_spectrum": self._spectrum}

    def __setstate__(self, state):
        self.__dict__.update(state)
        self._make()

    def __repr__(self):
        return f"<offing.Scene {', '.join(self.values)}>"


def _parsed(text, folder, *, is_made):
    if not text.isascii():
        try:
            text.encode()
        except UnicodeEncodeError as error:
            raise BadInput(f"scene: expected texts in UTF-8, got {text[error.start - 20 : error.end + 20]!r}",
                           "rename the file, or make a link to it with another name") from None
    return _core.Scene.parse(text, folder, is_made)
