"""Files of an ensemble's results: one for each member, named by a hash of all that the result depends on."""

import functools
import glob
import hashlib
import inspect
import itertools
import json
import numbers
import os
import pathlib
import tempfile
import types
import zipfile

import numpy as np

from offing import _core
from offing.errors import BadInput


def name_of(function):
    return getattr(function, "__name__", None) or type(function).__name__


def names(function, scenes, folder, device):
    """The file of each member, or None without a folder."""
    if folder is None:
        return [None] * len(scenes)
    from dask.tokenize import TokenizationError, tokenize

    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    digest = functools.cache(_digest)
    about = [_core.version(), _identity(function, set()), repr(device)]
    files = []
    try:
        for scene in scenes:
            spectrum = scene._spectrum and scene._spectrum.__getstate__()
            contents = [digest(file) for file in _files_of(scene.values, scene.folder)]
            name = tokenize(about, scene.values, spectrum, contents, ensure_deterministic=True)
            files.append(folder / f"{name}.npz")
    except TokenizationError as error:
        raise BadInput(
            f"{name_of(function)}: expected a function that can be hashed for file names: {error}",
            "keep only numbers, text, arrays and functions in its defaults and closure, or leave out folder",
        ) from None
    return files


def _identity(function, seen):
    """Everything but the world that the function's results depend on, for the hash."""
    if isinstance(function, functools.partial):
        values = [*function.args, *itertools.chain(*sorted(function.keywords.items()))]
        return ["partial", _identity(function.func, seen), [_value(value, seen) for value in values]]
    if isinstance(function, types.MethodType):
        return ["method", _identity(function.__func__, seen), _identity(function.__self__, seen)]
    if isinstance(function, type):
        return _text(function)
    if not isinstance(function, types.FunctionType):
        return [_text(type(function)), _value(getattr(function, "__dict__", None), seen)]
    if function in seen:
        return function.__qualname__
    seen.add(function)
    named = [function.__globals__.get(name) for name in sorted(_names_in(function.__code__))]
    named = [of for of in named if _is_plain(of) or _is_in_package_of(function, of)]
    cells = [cell.cell_contents for cell in function.__closure__ or ()]
    values = [*cells, *(function.__defaults__ or ()), *(function.__kwdefaults__ or {}).values(), *named]
    return [_text(function), [_value(value, seen) for value in values]]


def _names_in(code):
    """The names that a function's code uses, with the code of comprehensions and functions in it."""
    inner = [constant for constant in code.co_consts if isinstance(constant, types.CodeType)]
    return set(code.co_names).union(*map(_names_in, inner))


def _is_in_package_of(function, value):
    def package(of):
        return of.__module__.partition(".")[0]

    return isinstance(value, types.FunctionType) and package(value) == package(function)


def _is_plain(value):
    """Whether a value is a number, text or array, or holds only those."""
    if isinstance(value, dict):
        return all(map(_is_plain, [*value, *value.values()]))
    if isinstance(value, (tuple, list, set, frozenset)):
        return all(map(_is_plain, value))
    return isinstance(value, (numbers.Number, str, bytes, np.ndarray, np.generic))


def _value(value, seen):
    is_function = isinstance(value, (types.FunctionType, types.MethodType, functools.partial))
    return _identity(value, seen) if is_function else value


def _text(source):
    """The source of a function or class; the byte code of a function without a source file."""
    try:
        return inspect.getsource(source)
    except (OSError, TypeError):
        code = getattr(source, "__code__", None)
        return _code(code) if code else source.__qualname__


def _code(code):
    constants = [_code(value) if isinstance(value, types.CodeType) else repr(value) for value in code.co_consts]
    return f"{code.co_code.hex()} {code.co_names} {constants}"


def _files_of(values, folder):
    """The files that a scene names, and files of the same stem beside them: NDBC keeps directions there."""
    if isinstance(values, list):
        for value in values:
            yield from _files_of(value, folder)
    elif isinstance(values, dict):
        for key, value in values.items():
            if isinstance(value, str) and (key == "file" or key.endswith("_file")):
                file = pathlib.Path(folder, value)
                yield from sorted(
                    beside
                    for beside in file.parent.glob(f"{glob.escape(file.name.split('.')[0])}.*")
                    if beside.is_file()
                )
            else:
                yield from _files_of(value, folder)


def _digest(file):
    with open(file, "rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


def write(file, result):
    """Writes a result. The file gets its name only when it is complete."""
    about = json.dumps([[name, dimensions] for name, (dimensions, _) in result.items()])
    with tempfile.NamedTemporaryFile(dir=file.parent, prefix=".", suffix=".part", delete=False) as part:
        try:
            np.savez(part, about=np.array(about), **{str(i): values for i, (_, values) in enumerate(result.values())})
            part.flush()
            os.fsync(part.fileno())
            os.replace(part.name, file)
        except BaseException:
            os.unlink(part.name)
            raise


def read(file):
    """Reads what _write() wrote; None for a missing or damaged file."""
    try:
        with np.load(file, allow_pickle=False) as data:
            return {
                name: (tuple(dimensions), data[str(i)])
                for i, (name, dimensions) in enumerate(json.loads(str(data["about"])))
            }
    except FileNotFoundError:
        return None
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        return None
