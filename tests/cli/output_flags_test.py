"""Every flag of every program that names what is written, tried: never over an input, never over an existing
file without --force, and "-" is no file. The flags come from the programs' help, so that a new one fails here until it has a case.

usage: output_flags_test.py [--quick] PROGRAM...      --quick: over existing files only, not over inputs
"""

import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

# What stands behind a flag in the help and is no path.
NO_PATHS = set(
    "0 A A:B A:B:DT AZIMUTH_DEG,ELEVATION_DEG B BY C CAMERA CRS D DATE DEG DEVICE DT E EV F FLOAT FORMAT FPS H INT INT,... K "
    "L LEVEL LIST M MB METHOD N NAME ORDER P R S SWITCH SYSTEM T TIME TRANSFER TYPE UINT UNIT V W WHAT WxH X X,Y,Z X,Z X,Z,H "
    "i/n X,...".split()
)
TEXT_COLUMN = 34  # of the help: what begins there tells what a flag does

# Flags that name what is read or is no file, and one of offing-bench that its help does not tell apart.
READ = {"--points", "--compare", "--colour", "--canopy-map", "--terrain", "--sources", "--spectrum-file", "--modes-file", "--swell", "--lake",
        "--device"}

MAP = ["map.r32", "--raw-size", "9x9", "--spacing-m", "10"]
DAY = ["--from", "2026-06-21", "--to", "2026-06-21", "--latitude-deg", "46", "--longitude-deg", "8"]
SPECTRUM = ["41010.data_spec"]
NDBC = ["41010.data_spec", "41010.swdir", "41010.swdir2", "41010.swr1", "41010.swr2"]
SCENE_FILES = ["scene.toml", "ship.gltf", "ship.bin", "ramp.png", "map.asc", "map.prj", *NDBC]
SOME_FILES = ["scene.toml", "ship.bin", "41010.swdir"]  # one query tries all
GLTF = ["ship.gltf", "ship.bin"]


class Case:
    """How a flag is tried: `out` is what it names, `victim` what would be written over."""

    def __init__(self, command, flag, arguments, inputs, out, victim=None, existing=None):
        self.command, self.flag, self.arguments, self.inputs = command.split(), flag, arguments, inputs
        self.out, self.victim, self.existing = out, victim or out, existing or victim or out
        self.is_text = out.endswith(".csv") or (command, flag) == ("offing ocean spectrum", "--export-spectrum")


def mesh_cases():
    faces = ["--faces", "9"]
    for command, flags in (("repair", []), ("remesh", faces), ("simplify", faces), ("subdivide", [])):
        yield Case(f"offing-mesh {command}", "-o", ["ship.gltf", *flags], GLTF, "out.ply")
    yield Case("offing-mesh curvature", "-o", ["ship.gltf"], GLTF, "out.ply")


def batch_cases():
    for command, points in (("height", "points.csv"), ("ray", "pairs.csv"), ("los", "pairs.csv")):
        yield Case(f"offing terrain {command}", "-o", [*MAP, "--points", points], ["map.r32", points], "out.csv")


CASES = [
    Case("offing ocean spectrum", "--plot", [*SPECTRUM, "--record", "0"], NDBC, "out.png"),
    Case("offing ocean spectrum", "--export-spectrum", SPECTRUM, NDBC, "out.spec"),
    Case("offing ocean bake", "-o", ["scene.toml", "--frames", "0"], SOME_FILES, "out", "out/ocean.c0.0000.exr"),
    Case("offing ocean bake", "--export-spectrum", ["scene.toml", "--frames", "0", "-o", "fresh"], SOME_FILES,
         "out.spec"),
    Case("offing ocean modes", "-o", ["scene.toml"], SOME_FILES, "out.csv"),
    Case("offing ocean query", "-o", ["scene.toml", "--points", "points.csv"], [*SCENE_FILES, "points.csv"],
         "out.csv"),
    Case("offing highlights", "-o", ["scene.toml"], SOME_FILES, "out.json"),
    Case("offing scene import", "-o", ["ship.gltf"], GLTF, "out.toml"),
    Case("offing bodies motion", "-o", ["floats.toml", "--times", "0:0:1"], ["floats.toml"], "out.csv"),
    Case("offing bodies rao", "-o", ["floats.toml"], ["floats.toml"], "out.csv"),
    Case("offing bodies rao", "--plot", ["floats.toml", "-o", "fresh"], ["floats.toml"], "out.png"),
    Case("offing clouds build", "-o", ["scene.toml"], SOME_FILES, "out.vdb"),
    Case("offing clouds build", "-o", ["scene.toml", "--frames", "0:9"], SOME_FILES, "out.%04d.vdb", "out.0007.vdb"),
    Case("offing terrain render", "-o", ["map.asc", "--colour", "ramp.png"], ["map.asc", "map.prj", "ramp.png"],
         "out.png"),
    Case("offing terrain render", "--depth", ["map.vrt", "-o", "fresh.png"], ["map.vrt", "source.tif"], "out.exr"),
    Case("offing terrain viewshed", "-o", ["map.asc", "--observer", "1,1"], ["map.asc", "map.prj"], "out.tif"),
    Case("offing terrain viewshed", "-o", ["map.asc", "--points", "points.csv"], ["map.asc", "map.prj", "points.csv"], "out.tif"),
    Case("offing terrain viewshed", "--needed", ["map.asc", "--observer", "1,1", "-o", "fresh.tif"], ["map.asc", "map.prj"],
         "out.tif"),
    Case("offing terrain viewshed", "--union", ["map.asc", "--points", "points.csv", "-o", "fresh.tif"],
         ["map.asc", "map.prj", "points.csv"], "out.tif"),
    Case("offing terrain viewshed", "--shares", ["map.asc", "--points", "points.csv", "-o", "fresh.tif"],
         ["map.asc", "map.prj", "points.csv"], "out.gpkg"),
    Case("offing terrain sky", "-o", ["map.asc"], ["map.asc", "map.prj"], "out.tif"),
    Case("offing terrain sky", "--horizons", ["map.asc", "-o", "fresh.tif"], ["map.asc", "map.prj"], "out.tif"),
    Case("offing terrain sun", "-o", ["map.asc", *DAY], ["map.asc", "map.prj"], "out.tif"),
    Case("offing terrain sun", "--masks", ["map.asc", *DAY, "-o", "fresh.tif"], ["map.asc", "map.prj"], "out.tif"),
    Case("offing terrain lake", "-o", ["basin.asc", "--at", "20,20"], ["basin.asc"], "out.geojson"),
    Case("offing terrain profile", "-o", [*MAP, "--from", "0,0", "--to", "9,9"], ["map.r32"], "out.csv"),
    Case("offing terrain generate", "-o", [], [], "out.tif"),
    Case("offing terrain tile", "-o", MAP, ["map.r32"], "out", "out/0/0000/0000.tile"),
    Case("offing terrain tile", "-o", MAP, ["map.r32"], "out", "out/0/0000/0000.tile", "out/store.toml"),
    Case("offing terrain fly", "-o", ["store", "--every", "1", "--frames", "2", "--size", "16x9"], ["store/store.toml", "store/0/0000/0000.tile"], "out",
         "out/frame.000001.png"),
    *batch_cases(),
    *mesh_cases(),
    Case("offing-view", "-o", ["scene.toml", "--headless", "--size", "16x9"], SOME_FILES, "out.png"),
    Case("offing-view", "-o", ["scene.toml", "--headless", "--size", "16x9"], SOME_FILES, "out.exr"),
    Case("offing-view", "-o", ["scene.toml", "--compare-reference", "--size", "16x9"], SOME_FILES, "out", "out/drawn.png"),
    Case("offing-view", "--record", ["scene.toml", "--frames", "0:9"], SOME_FILES, "out_%d.png", "out_7.png"),
    Case("offing-view", "--video", ["scene.toml"], SOME_FILES, "out.webm"),
]


class Outputs:
    def __init__(self, programs, folder):
        self.programs = {pathlib.Path(program).name: pathlib.Path(program).resolve() for program in programs}
        self.folder = folder
        self.faults = 0
        (folder / "bin").mkdir()
        (folder / "bin" / "ffmpeg").write_text("#!/bin/sh\ncat > /dev/null\n")  # --video looks for one
        (folder / "bin" / "ffmpeg").chmod(0o755)
        self.environment = dict(os.environ, PATH=f"{folder}/bin:{os.environ['PATH']}")

    def fault(self, text):
        self.faults += 1
        print(text, flush=True)

    def run(self, *words):
        command = [self.programs[words[0]], *words[1:]]
        return subprocess.run(command, cwd=self.folder / "work", env=self.environment, capture_output=True, text=True,
                              check=False)

    def help_of(self, command):
        result = self.run(*command, "--help")
        if result.returncode != 0:
            raise RuntimeError(f"{command}: no help: {result.stderr}")
        return result.stdout

    def commands(self, command):
        """The command and all below it."""
        yield command
        section = re.search(r"^Subcommands:\n((?:  .*\n|\n)*)", self.help_of(command), re.MULTILINE)
        for name in re.findall(r"^  ([a-z][\w-]*)", section[1] if section else "", re.MULTILINE):
            yield from self.commands([*command, name])

    def path_flags(self, command):
        """The flags of a command that name files or folders."""
        for flag in re.finditer(r"^  (-[\w,-]+)(?: +(\S+))?", self.help_of(command), re.MULTILINE):
            has_value = flag[2] and flag.start(2) - flag.start() < TEXT_COLUMN and flag[2] != "(required)"
            if has_value and flag[2] not in NO_PATHS:
                yield flag[1].split(",")

    def check_all_have_cases(self):
        tried = {(" ".join(case.command), case.flag) for case in CASES}
        for program in self.programs:
            for command in self.commands([program]):
                for names in self.path_flags(command):
                    name = " ".join(command)
                    if not READ & set(names) and not any((name, flag) in tried for flag in names):
                        self.fault(f"{name} {','.join(names)}: give it a case, or say that it is read")

    def expect_refusal(self, what, words, victim, parts):
        before, status = victim.read_bytes(), victim.stat()
        result = self.run(*words)
        told = f"{what}: {' '.join(words)}: exit {result.returncode}, {result.stderr!r}"
        if result.returncode != 2 or not re.fullmatch(r"(?s)(?:warning: .*\n)?error: [^\n]+\nhint: [^\n]+\n",
                                                      result.stderr):
            self.fault(f"expected exit 2, an error and a hint: {told}")
        elif not any(part in result.stderr for part in parts):
            self.fault(f"expected the rule of outputs: {told}")
        if (not victim.exists() or victim.read_bytes() != before or victim.stat().st_ino != status.st_ino
                or victim.stat().st_mtime_ns != status.st_mtime_ns):
            self.fault(f"the file was changed: {told}")

    def check_existing(self, case):
        self.make_inputs()
        victim = self.folder / "work" / case.existing
        victim.parent.mkdir(parents=True, exist_ok=True)
        victim.write_text("mine")
        self.expect_refusal("existing", [*case.command, *case.arguments, case.flag, case.out], victim, ["--force"])

    def check_standard_output(self, case):
        """"-" is standard output for text, and refused for all else; it never names a file or a folder."""
        self.make_inputs()
        before = sorted(path.name for path in (self.folder / "work").iterdir())
        words = [*case.command, *case.arguments, case.flag, "-"]
        result = self.run(*words)
        told = f"{' '.join(words)}: exit {result.returncode}, {result.stderr!r}"
        if case.is_text:
            if result.returncode != 0 or not result.stdout:
                self.fault(f"expected text on standard output: {told}")
        elif result.returncode != 2 or not re.fullmatch(r"(?s)(?:warning: .*\n)?error: [^\n]+\nhint: [^\n]+\n",
                                                        result.stderr):
            self.fault(f"expected a refusal of standard output: {told}")
        after = sorted(path.name for path in (self.folder / "work").iterdir() if path.name != "fresh")
        if after != before:
            self.fault(f"expected no new files, found {set(after) - set(before)}: {told}")

    def check_inputs(self, case):
        for number, name in enumerate(case.inputs):
            self.make_inputs()
            link = (os.symlink, os.link)[number % 2]
            victim = self.folder / "work" / case.victim
            victim.parent.mkdir(parents=True, exist_ok=True)
            link(self.folder / "work" / name, victim)
            words = [*case.command, *case.arguments, case.flag, case.out, "--force"]
            self.expect_refusal(f"{link.__name__} of {name}", words, victim, ["an input"])
        name = case.inputs[0] if case.inputs else ""
        if name and case.out == "out" + pathlib.Path(name).suffix or case.out == "out.spec":
            self.make_inputs()
            words = [*case.command, *case.arguments, case.flag, name, "--force"]
            self.expect_refusal(f"{name} itself", words, self.folder / "work" / name, ["an input"])

    def make_inputs(self):
        """Fresh inputs in an empty folder."""
        work = self.folder / "work"
        subprocess.run(["rm", "-rf", work], check=True)
        subprocess.run(["cp", "-a", self.folder / "inputs", work], check=True)


def write_inputs(outputs):
    work = outputs.folder / "work"
    work.mkdir()

    def write(name, text):
        (work / name).write_text(text)

    write("points.csv", "1,2\n")
    write("pairs.csv", "10,20,2,50,40,3\n")
    (work / "map.r32").write_bytes(bytes(4 * 81))
    write("map.asc", "ncols 3\nnrows 3\nxllcenter 0\nyllcenter 0\ncellsize 10\n" + "1.5 2 3\n" * 3)
    write("basin.asc", "ncols 5\nnrows 5\nxllcenter 0\nyllcenter 0\ncellsize 10\n" + "9 9 9 9 9\n" * 2 + "9 9 1 9 9\n" + "9 9 9 9 9\n" * 2)
    write("map.prj", 'LOCAL_CS["flat",UNIT["metre",1]]')
    outputs_of = {"source.tif": ["offing", "terrain", "generate", "--posts", "9", "-o", "source.tif"],
                  "store": ["offing", "terrain", "tile", *MAP, "-o", "store"]}
    for words in outputs_of.values():
        result = outputs.run(*words)
        if result.returncode != 0:
            raise RuntimeError(f"{words}: {result.stderr}")
    write("map.vrt", '<VRTDataset rasterXSize="9" rasterYSize="9"><VRTRasterBand dataType="Float32" band="1">'
          '<SimpleSource><SourceFilename relativeToVRT="1">source.tif</SourceFilename><SourceBand>1</SourceBand>'
          "</SimpleSource></VRTRasterBand></VRTDataset>")
    head = "#YY  MM DD hh mm "
    write("41010.data_spec", head + "Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >\n"
          "2020 06 08 03 50 0.225 1.0 (0.050) 4.000 (0.100) 2.000 (0.150) 0.500 (0.200)\n")
    for name, of, value in (("swdir", "alpha1", 225), ("swdir2", "alpha2", 225), ("swr1", "r1", 0.8), ("swr2", "r2", 0.4)):
        values = " ".join(f"{value} ({f:.3f})" for f in (0.05, 0.1, 0.15, 0.2))
        write(f"41010.{name}", f"{head}{of}_1 (freq_1) {of}_2 (freq_2) ... >\n2020 06 08 03 50 {values}\n")
    (work / "ship.bin").write_bytes(struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
    write("ship.gltf", '{"asset":{"version":"2.0"},"buffers":[{"uri":"ship.bin","byteLength":36}],'
          '"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,'
          '"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],'
          '"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]}')
    (work / "ramp.png").write_bytes(picture())
    write("scene.toml", 'version = 1\n[ocean]\nsize = 16\nspectrum_file = "41010.data_spec"\n[terrain]\nfile = "map.asc"\n'
          '[[mesh]]\nfile = "ship.gltf"\nshading = "cartoon"\ncartoon_ramp = "ramp.png"\n[[cloud]]\n')
    write("floats.toml", 'version = 1\n[ocean]\nsize = 16\n[[mesh]]\nshape = "box"\n[[body]]\nmass_centre_m = [0, -0.4, 0]\n')
    work.rename(outputs.folder / "inputs")


def picture():
    """A PNG of two pixels."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", 2, 1, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(bytes([0] + [99] * 6)))
            + chunk(b"IEND", b""))


def main():
    with tempfile.TemporaryDirectory() as folder:
        is_quick = "--quick" in sys.argv
        outputs = Outputs([word for word in sys.argv[1:] if word != "--quick"], pathlib.Path(folder))
        write_inputs(outputs)
        outputs.make_inputs()
        if "offing-mesh" in outputs.programs:
            for command in list(outputs.commands(["offing-mesh", "generate"]))[1:]:
                CASES.append(Case(" ".join(command), "-o", [], [], "out.ply"))
        outputs.check_all_have_cases()
        for case in CASES:
            if case.command[0] in outputs.programs:
                outputs.check_existing(case)
                outputs.check_standard_output(case)
                if not is_quick:
                    outputs.check_inputs(case)
        return 1 if outputs.faults else 0


if __name__ == "__main__":
    sys.exit(main())
