# SPDX-License-Identifier: GPL-3.0-or-later (part of offing-bench)
"""What docs/results.md says around its tables, a text a section."""

INTRODUCTION = """# Results

Written by `tests/bench/results/record_results.py`; `tests/bench/README.md` says how things are measured and what the
peers are.
"""

SECTIONS = {
    "ocean": """## Transform, frame, Gerstner waves and queries

{machine}

`offing-bench fft`, `ocean`, `gerstner` and `queries`: medians of {blocks} interleaved blocks. Ratio = peer / ours, above 1
ours is faster; low = lower bound of the ratio's 95 % confidence interval; spread = interquartile range of the
blocks' ratios over their median. `fft_batch16` times 16 transforms at once, `ocean_3_cascades` three cascades;
`gerstner` 16 waves on n x n points; `_alone` waits for the device after each transform or surface, where the
others are queued 16 in a row. `queries` is one call for 100,000 points of a sea with 16 waves and two cascades of
n x n, transfers included (`queries_surface`: without velocity and pressure); 20 ms are 5 million points a second.

{rows}
""",
    "previews": """## Previews of bakes

{machine}

`offing-bench previews`: what `offing ocean bake --preview` adds to a frame of scenes/storm.toml with three cascades of
n x n and 64 Gerstner waves: the map from above, drawn, compressed, written, and kept for the contact sheet.
`preview_draw` is the drawing alone, `preview_sheet` the contact sheet of 24 frames, once a bake.

{previews}
""",
    "frames": """## Frames of the presenter

{machine}

`offing-bench render`, drawn by {renderer}. `render_rough` is scenes/rough.toml as its window draws it, 640 x 360
pixels, three cascades of 256 x 256 and 64 Gerstner waves; `render_valley_fly` and `render_valley_walk` are those scenes of ground, of so
many lines. The rows below each are its stages, one by one, which add up to more, since stages overlap where nobody waits
for their ends.

{frames}
""",
    "terrain": """## Terrain

{machine}

`offing-bench terrain`: primary rays of the cameras of scenes/bench_terrain.toml, 1280 x 720, to distances, against the best way to
cast the same rays with Embree 3; a row a camera, four that fly (300, 1000, 2000 and 4000 m above the highest post) and four that
walk. `terrain_build` is the pyramid against Embree's grid, `terrain_load` all from heights in host memory on. Geometric means of
the ratios: {terrain_means}.

{terrain}

Steps, iterations of a ray's walk, of the same cameras' rays, every method (`paper`: T4 and T5 as printed; `pdm`: never up; `linear`:
patch by patch; `picture`: the default's packets of pixels on a CPU, a ray's share), and the milliseconds of four pictures:

{terrain_steps}

Park, Oh & Cho (2007) print frames a second on a Radeon 2900 and seconds of preprocessing on a CPU at 2.33 GHz; ours are whole
frames, rays and light, on the CPU named above, over the same made ground at every size, one ray a pixel (`smooth_frame`: with edges
smoothed). From 256 to 4096 {terrain_growth}; the paper's frame takes about 2.5 times as long:

{terrain_paper}

Powers of the size that times grow by, from the smallest to the largest: {growths}.

{plot}
""",
    "viewsheds": """## Viewsheds

{machine}

`offing-bench viewshed`: which posts of a whole map an eye 30 m above the ground sees, into host memory, on a flat and on the curved Earth,
against `GDALViewshedGenerate`, which runs on one core and is approximate.

{viewsheds}
""",
    "highlights": """## Highlights

{machine}

`offing-bench curvature`: all vertices of a torus with noise, n x n / 2 of them, against CGAL's jet fitting on one core:

{curvature}

`offing-bench highlights`: a search for highlight points against a loop over the faces on one core, and whole frames of meshes that
turn: search, tracks, projectors and regions, without drawing. `size` is faces.

{highlights}

Lee & Choi (2006) print frames a second on an Athlon XP 3200 with a GeForce 7800, drawing included:

{highlights_paper}

Powers of the number of faces that times grow by: {growths}.

{plot}
""",
    "clouds": """## Clouds

{machine}

`offing-bench clouds`: clouds of so many particles (`n`) made, lit, sorted and drawn, and whole frames of the presenter, without a peer.

{clouds}

Do, Baek, Lee & Ryu (2009) print frames a second at 1280 x 1024 on a Pentium 4 at 3.2 GHz with a GeForce 6600 (C16 of
[sources](sources.md)). Ours are a sampled cumulus that covers half of the picture, {renderer}; its frame sorts, lights toward the
eye and draws. Times in ms:

{clouds_paper}

Powers of the number of particles that times grow by, from the smallest to the largest: {growths}.

{plot}
""",
    "wakes": """## Wakes

{machine}

`offing-bench wake`: one step of a window of n x n cells with a hull in it, by either method, against the dispersive step in C++ with
FFTW, which is given what the hull displaces and has no border. Most of a small window's step is the hull, 36 places of each cell.

{wakes}
""",
    "world": """## One world

{machine}

`offing-bench world`: frames of scenes/world.toml, 640 x 360, drawn by {renderer}, beside the sum of what its parts take alone, each
with its own sky; the eye moves, and a fifth of the map of the cloudy sky is drawn anew with every fourth frame, as in a window. Times are medians of
means over four frames in a row; the ship comes nearer meanwhile, alike in all rows but those of stages, which come last. These are
the rows below the frame, each stage with its end waited for. What is in no part is the island and the clouds mirrored in the sea,
and that map. No stage but that of clouds waits for something to come back from a device: it reads the
picture's depth, once for the eye and once for its mirror image, which costs nothing where the CPU draws.

{world}
""",
    "papers": """## Ocean beside the paper

{machine}

Tables of Lee & Lee (2006, 2007), which print frames a second on a GeForce 6800 Ultra and on a Pentium 4 at 3 GHz
with FFTW; here in milliseconds. One complex two-dimensional transform (at 64 and 128 ours and FFTW here do 16 at
once, shown is a sixteenth):

{transforms}

Simulation only. The paper's frame is height, displacement and slopes by three transforms of one patch, with 16
Gerstner waves on 256 x 256 (GPU) or 64 x 64 (CPU) points; ours is one patch with eight fields by four
transforms, without Gerstner waves. The peer is the same frame as ours in C++ with FFTW:

{simulation}

Simulation and rendering: one patch, 16 Gerstner waves on 128 x 128 points, 1280 x 1024 pixels, on a graphics card
there; here {renderer}, sky, light and foam worked out for each pixel:

{rendering}

Powers of n that times grow by, from the smallest to the largest: {growths}.

{plot}
""",
}
