# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""Runs benchmarks and writes docs/results.md. At the top of the sources, on a machine that does nothing else:
python3 tests/bench/results/record_results.py build/bin [--sections highlights,clouds]
Sections that are not named stay as they are in the page."""

import argparse
import datetime
import functools
import json
import os
import pathlib
import re
import subprocess

import result_plots as plots
import result_tables as tables
from result_texts import INTRODUCTION, SECTIONS

PAGE = pathlib.Path("docs/results.md")
PLOTS = pathlib.Path("docs/results")
BLOCKS = 15


def output_of(*command):
    return subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, check=True, text=True).stdout


def machine_lines(programs):
    processor = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text()).group(1)
    memory_kib = int(re.search(r"MemTotal:\s*(\d+)", pathlib.Path("/proc/meminfo").read_text()).group(1))
    huge_pages = pathlib.Path("/sys/kernel/mm/transparent_hugepage/enabled").read_text().strip()
    devices = json.loads(output_of(programs / "offing", "devices", "--json"))
    device = next(device for device in devices if device["is_default"])
    fftw = output_of("pkg-config", "--modversion", "fftw3f").strip()
    kernel = ".".join(os.uname().release.split(".")[:2])  # what follows may name the machine
    return "\n".join(
        [
            f"- {datetime.date.today().isoformat()}, commit {output_of('git', 'rev-parse', '--short', 'HEAD').strip()}",
            f"- {processor}, {len(os.sched_getaffinity(0))} cores, {memory_kib / 2**20:.0f} GiB, "
            f"Linux {kernel}, transparent huge pages {huge_pages}",
            f"- OpenCL device: {device['name']} ({device['platform']} {device['driver_version']})",
            f"- {output_of('c++', '--version').splitlines()[0]}; FFTW {fftw}",
            f"- load of the machine before the run: {os.getloadavg()[0]:.1f}",
        ]
    )


class Record:
    """Texts of the sections; each command of offing-bench runs once, when a section first needs its rows."""

    def __init__(self, programs):
        self.programs = programs

    @functools.cache
    def rows(self, command, sizes=(), blocks=BLOCKS):
        chosen = ("--sizes", ",".join(map(str, sizes))) if sizes else ()
        return json.loads(output_of(self.programs / "offing-bench", command, *chosen, "--blocks", blocks, "--json"))

    def plotted(self, section, across, curves):
        """What a section says of its plot, which is drawn anew."""
        plots.plot(PLOTS / f"{section}.svg", across, curves)
        return {"plot": f"![times over sizes](results/{section}.svg)", "growths": plots.growths(curves)}

    def frames_drawn(self):
        return self.rows("render", tuple(tables.PAPER_RENDER_FPS))

    def ocean(self):
        rows = [row for command in ("fft", "ocean", "gerstner", "queries") for row in self.rows(command)]
        return {"blocks": BLOCKS, "rows": tables.rows_table(rows)}

    def previews(self):
        return {"previews": tables.rows_table(self.rows("previews", (256, 512, 1024)))}

    def frames(self):
        drawn = self.frames_drawn()
        return {
            "renderer": drawn[0]["peer"],
            "frames": tables.frames_table([row for row in drawn if not row["name"].startswith("render_paper")]),
        }

    def terrain(self):
        rows = self.rows("terrain", tuple(tables.PAPER_TERRAIN))
        return {
            "terrain": tables.rows_table([row for row in rows if "steps" not in row]),
            "terrain_means": tables.terrain_means(rows),
            "terrain_steps": tables.terrain_steps_table(rows),
            "terrain_growth": tables.terrain_growth(rows),
            "terrain_paper": tables.terrain_paper_table(rows),
            **self.plotted("terrain", "posts a side", plots.terrain_curves(rows)),
        }

    def viewsheds(self):
        return {"viewsheds": tables.rows_table(self.rows("viewshed", (1024,)))}

    def highlights(self):
        rows = self.rows("highlights")
        return {
            # A block of the peer takes seconds.
            "curvature": tables.rows_table(self.rows("curvature", (256,), 5)),
            "highlights": tables.rows_table(rows),
            "highlights_paper": tables.highlights_paper_table(rows),
            **self.plotted("highlights", "faces", plots.highlights_curves(rows)),
        }

    def clouds(self):
        rows = self.rows("clouds")
        return {
            "clouds": tables.rows_table(rows),
            "clouds_paper": tables.clouds_paper_table(rows),
            **self.plotted("clouds", "particles", plots.clouds_curves(rows)),
            "renderer": next(row["peer"] for row in rows if "_frame_" in row["name"]).split(";")[0],
        }

    def papers(self):
        transforms = [row for row in self.rows("fft") if not row["name"].endswith("_alone")]
        simulation = [row for row in self.rows("ocean") if row["name"] == "ocean"]
        return {
            "renderer": self.frames_drawn()[0]["peer"],
            "transforms": tables.paper_table(tables.PAPER_TRANSFORM_FPS, transforms),
            "simulation": tables.paper_table(tables.PAPER_SIMULATION_FPS, simulation),
            "rendering": tables.rendering_table(self.frames_drawn()),
            **self.plotted("ocean", "samples a side", plots.ocean_curves(transforms, simulation)),
        }

    def wakes(self):
        return {"wakes": tables.rows_table(self.rows("wake", (64, 128, 256, 512)))}

    def world(self):
        rows = self.rows("world")
        return {"renderer": rows[0]["peer"], "world": tables.rows_table(rows)}

    def text(self, section):
        return SECTIONS[section].format(machine=machine_lines(self.programs), **getattr(self, section)())


def sections_of(page):
    """Section name -> its text in a page written earlier."""
    texts = re.split(r"^(?=## )", page, flags=re.MULTILINE)[1:]
    headings = {template.split("\n", 1)[0]: name for name, template in SECTIONS.items()}
    return {headings[text.split("\n", 1)[0]]: text.rstrip("\n") + "\n" for text in texts}


def main():
    parser = argparse.ArgumentParser(description="Runs benchmarks and writes docs/results.md.")
    parser.add_argument("programs", type=pathlib.Path, help="folder of offing and offing-bench")
    parser.add_argument("--sections", default=",".join(SECTIONS), help="what to measure anew: %(default)s")
    options = parser.parse_args()
    chosen = options.sections.split(",")
    if unknown := set(chosen) - set(SECTIONS):
        parser.error(f"--sections: expected some of {', '.join(SECTIONS)}, got {', '.join(sorted(unknown))}")

    record = Record(options.programs)
    texts = sections_of(PAGE.read_text()) if PAGE.exists() else {}
    for section in SECTIONS:
        if section not in chosen:
            continue
        texts[section] = record.text(section)
        ordered = [texts[name] for name in SECTIONS if name in texts]
        PAGE.write_text("\n".join([INTRODUCTION, *ordered]))


if __name__ == "__main__":
    main()
