"""Runs the programs on mutated files: scenes, meshes, maps, tile stores, volumes, particles, spectra and tables of points.
Each must end by itself within 30 s, with exit code 0 or 2, and with a line `error:` where it is 2.

Usage: mutated_files.py PROGRAMS [--first I] [--count N] [--seed S] [--jobs J] [--keep FOLDER] [--data FOLDER ...]

PROGRAMS is the folder of offing, offing-mesh and offing-view (those that are missing are left out). File I of a seed is
always the same, so that a run can go on with --first where another ended. Files that a program fails on are copied to
FOLDER with the command that did. The seeds are scenes/ and tests/fuzz/corpus, small files that the programs make, and
files of at most 300 kB below each folder of --data."""

import argparse
import concurrent.futures
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LONGEST_S = 30
MOST_SEED_BYTES = 300_000
OF_CORPUS = {"datawell": ".spt", "gltf": ".glb", "netcdf": ".nc", "obj": ".obj", "off": ".off", "ply": ".ply",
             "stl": ".stl", "swan": ".spec", "ww3": ".spec"}
SPECTRA = {".spt", ".nc", ".spec", ".data_spec", ".txt", ".tab"}
MESHES = {".obj", ".off", ".ply", ".stl", ".gltf", ".glb"}
MAPS = {".tif", ".dem", ".asc", ".png", ".exr", ".hgt"}
NUMBERS = ["0", "-1", "1e308", "-1e-308", "nan", "inf", "2147483648", "-9223372036854775808", "1e10", "0.5", '""', "[]", "{}"]
BYTES = [b"\0", b"\xff", b"\x7f", b"\x80", b"\xff\xff\xff\xff", b"\xff\xff\xff\x7f", b"\0\0\0\x80", b"\0\0\0\0", b"\1\0\0\0"]


def run(command, environment):
    """Exit code (minus the signal where one ended it, None where nothing did within LONGEST_S) and stderr."""
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL,
                               env=environment)
    try:
        errors = process.communicate(timeout=LONGEST_S)[1]
        return process.returncode, errors.decode(errors="replace")
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return None, ""


def make_seeds(programs, folder, environment):
    """Small files of the kinds that only programs can make."""
    def made(*command):
        code, errors = run([str(programs / command[0]), *map(str, command[1:])], environment)
        if code != 0:
            sys.exit(f"error: {' '.join(map(str, command))}: exit {code}: {errors}\nhint: build the programs again")
    made("offing", "terrain", "generate", "-o", folder / "map.tif", "--posts", 33)
    made("offing", "terrain", "render", folder / "map.tif", "-o", folder / "picture.png", "--size", "32x18")
    made("offing", "terrain", "tile", folder / "map.tif", "-o", folder / "store")
    (folder / "map.asc").write_text("ncols 3\nnrows 2\nxllcorner 5\nyllcorner 4\ncellsize 30\n1 2.5 3\n-9999 5 6\n")
    (folder / "points.csv").write_text("x_m,z_m\n10,20\n30.5,-4e1\n# far\n1e7,0\n")
    (folder / "sea.toml").write_text("version = 1\n[ocean]\nsize = 16\ncascade_count = 1\n")
    made("offing", "ocean", "bake", folder / "sea.toml", "-o", folder / "frames", "--frames", 0)
    (folder / "cloud.toml").write_text(
        'version = 1\n[clouds]\nquality = 0.05\n[[cloud]]\nmodelling = "sampled"\n[[cloud.ball]]\nradius_m = 100\n')
    for kind in ("vdb", "ply"):
        made("offing", "clouds", "build", folder / "cloud.toml", "-o", folder / f"cloud.{kind}")
    if (programs / "offing-mesh").exists():
        for kind in ("obj", "ply", "off", "stl"):
            made("offing-mesh", "generate", "sphere", "-o", folder / f"sphere.{kind}", "--level", 1)


def seeds_of(made, data):
    """Pairs of file and the name that its reader takes."""
    found = [(path, path.name) for path in sorted((ROOT / "scenes").glob("*.*"))]
    for folder, extension in OF_CORPUS.items():
        found += [(path, f"{folder}{extension}") for path in sorted((ROOT / "tests/fuzz/corpus" / folder).iterdir())]
    for folder in [made, *map(pathlib.Path, data)]:
        found += [(path, path.name) for path in sorted(folder.rglob("*"))]
    known = SPECTRA | MESHES | MAPS | {".toml", ".vdb", ".csv", ".tile", ".r16"}
    return [(path, name) for path, name in found
            if path.is_file() and pathlib.Path(name).suffix in known and 0 < path.stat().st_size <= MOST_SEED_BYTES]


def mutated(content, rng, is_text):
    """One to six changes of bytes, blocks, and in texts of lines and numbers."""
    content = bytearray(content)
    for _ in range(rng.randint(1, 6)):
        if not content:
            break
        at = rng.randrange(len(content))
        kind = rng.randrange(9 if is_text else 6)
        if kind == 0:
            content[at] ^= 1 << rng.randrange(8)
        elif kind == 1:
            value = rng.choice(BYTES)
            content[at:at + len(value)] = value
        elif kind == 2:
            content[at:at] = rng.choice(BYTES) * rng.choice((1, 1, 2, 100))
        elif kind == 3:
            del content[at:at + rng.choice((1, 2, 4, 16, 1000))]
        elif kind == 4:
            to = rng.randrange(len(content))
            block = content[at:at + rng.randint(1, 64)]
            content[to:to + len(block)] = block
        elif kind == 5:
            if rng.randrange(4) == 0:
                del content[at:]
        else:
            lines = content.split(b"\n")
            line = rng.randrange(len(lines))
            if kind == 6:
                lines.insert(rng.randrange(len(lines)), lines[line])
            elif kind == 7:
                del lines[line]
            else:
                words = lines[line].split(b" ")
                words[rng.randrange(len(words))] = rng.choice(NUMBERS).encode()
                lines[line] = b" ".join(words)
            content = bytearray(b"\n".join(lines))
    return bytes(content)


class Trial:
    """One mutated file and the command that reads it."""

    def __init__(self, index, options, seeds, made):
        self.rng = random.Random(f"{options.seed}:{index}")
        self.programs, self.made = options.programs, made
        self.seed, self.name = seeds[self.rng.randrange(len(seeds))]

    def write(self, folder):
        """The mutated file; of a tile or a header, the store that it lies in."""
        suffix = pathlib.Path(self.name).suffix
        is_text = suffix in {".toml", ".csv", ".obj", ".off", ".asc"} | SPECTRA - {".nc"}
        content = mutated(self.seed.read_bytes(), self.rng, is_text)
        if self.made / "store" in self.seed.parents:
            shutil.copytree(self.made / "store", folder / "store")
            path = folder / "store" / self.seed.relative_to(self.made / "store")
            path.write_bytes(content)
            return folder / "store"
        path = folder / self.name
        path.write_bytes(content)
        return path

    def command(self, path, folder):
        suffix = path.suffix
        offing = str(self.programs / "offing")
        if suffix == ".toml":
            choices = [[offing, "ocean", "query", path, "--at", "1,2", "--time", "0.5", "--json"],
                       [offing, "clouds", "info", path],
                       [offing, "highlights", path, "-o", folder / "out.json", "--frames", "0"]]
            if (self.programs / "offing-view").exists():
                choices.append([str(self.programs / "offing-view"), path, "--headless", "--size", "16x9", "--detail", "low",
                                "-o", folder / "out.png"])
            return self.rng.choice(choices)
        if path.is_dir() or suffix in MAPS | {".r16"}:
            return self.rng.choice([[offing, "terrain", "info", path],
                                    [offing, "terrain", "height", path, "--at", "40,40"]])
        if suffix == ".csv":
            return [offing, "terrain", "height", self.made / "map.tif", "--points", path]
        if suffix == ".vdb" or self.seed.name == "cloud.ply":
            return [offing, "clouds", "info", path]
        if suffix in SPECTRA:
            return [offing, "ocean", "spectrum", path]
        if (self.programs / "offing-mesh").exists():
            return [str(self.programs / "offing-mesh"), "check", path]
        return [offing, "clouds", "info", path]


def try_one(index, options, seeds, made, environment):
    """"" or what is wrong with how a program took file `index`."""
    trial = Trial(index, options, seeds, made)
    with tempfile.TemporaryDirectory(prefix="offing-mutated-") as name:
        folder = pathlib.Path(name)
        path = trial.write(folder)
        command = [str(word) for word in trial.command(path, folder)]
        code, errors = run(command, environment)
        if code == 0 or (code == 2 and "error: " in errors):
            return ""
        if options.keep:
            shutil.copytree(folder, pathlib.Path(options.keep) / str(index), dirs_exist_ok=True)
        if code is None:
            how = f"no end within {LONGEST_S} s"
        elif code < 0:
            how = signal.Signals(-code).name
        else:
            how = f"exit {code}"
        return f"{index}: {how}: {' '.join(command)} (from {trial.seed.name}): {errors.strip()[-300:]}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep")
    parser.add_argument("--data", nargs="*", default=[])
    options = parser.parse_args()
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    with tempfile.TemporaryDirectory(prefix="offing-seeds-") as folder:
        made = pathlib.Path(folder)
        environment.setdefault("OFFING_CACHE_DIR", str(made / "kernels"))
        make_seeds(options.programs, made, environment)
        seeds = seeds_of(made, options.data)
        faults = 0
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            indices = range(options.first, options.first + options.count)
            results = pool.map(lambda index: try_one(index, options, seeds, made, environment), indices)
            for index, fault in zip(indices, results):
                if fault:
                    faults += 1
                    print(fault, flush=True)
                if (index + 1) % 500 == 0:
                    print(f"{index + 1} files, {faults} faults", flush=True)
    print(f"{options.count} files from {len(seeds)} seeds, {faults} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
