"""Curvatures of the same meshes by libigl (Panozzo et al. 2010: a quadric through five rings of neighbours) and by `offing-mesh
curvature`. Both against the curvatures of the smooth surface that `offing-mesh generate` writes, and against one another. Errors
are root mean squares of both curvatures, over the larger true one at the vertex.

Fails if ours has another sign, unit or order than the field's most used program, if it has a larger error on any clean mesh, or
if noise of 2 % of an edge makes it worse than libigl's."""

import pathlib
import tempfile

import peer

mesh_program, _ = peer.enter("igl")

import igl  # noqa: E402
import numpy as np  # noqa: E402

MESHES = {
    "sphere": ("sphere", "--level", 4),
    "ellipsoid": ("ellipsoid", "--level", 4, "--jitter", 0.25),
    "torus": ("torus", "--u-cells", 120, "--v-cells", 48, "--jitter", 0.25, "--random-diagonals"),
    "bumpy": ("bumpy", "--level", 6),
}


def read_ply(file):
    """The properties of vertices by name, and the corners of triangles. Offing writes little-endian PLY."""
    content = file.read_bytes()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    counts, fields, element = {}, [], None
    for line in content[:end].decode().splitlines():
        words = line.split()
        if words[0] == "element":
            element = words[1]
            counts[element] = int(words[2])
        elif words[0] == "property" and element == "vertex":
            fields.append((words[2], {"float": "<f4", "double": "<f8", "uchar": "u1"}[words[1]]))
        elif words[0] == "property" and element == "face":
            index = {"int": "<i4", "uint": "<u4"}[words[3]]
    vertices = np.frombuffer(content, fields, counts["vertex"], end)
    faces = np.frombuffer(content, [("count", "u1"), ("corners", index, 3)], counts["face"], end + vertices.nbytes)
    return vertices, faces["corners"].astype(np.int64)


def rms_percent(found, truth):
    size = np.abs(truth).max(axis=0)
    return 100 * np.sqrt(np.mean(((found - truth) / size) ** 2))


def compared(folder, shape, noise):
    made, measured = folder / "made.ply", folder / "measured.ply"
    peer.run(mesh_program, "generate", *shape, "--noise", noise, "-o", made, "--force", "--quiet")
    peer.run(mesh_program, "curvature", made, "-o", measured, "--force", "--quiet")
    vertices, faces = read_ply(made)
    truth = np.stack([vertices["true_k_max"], vertices["true_k_min"]])
    answers, _ = read_ply(measured)
    ours = np.stack([answers["k_max"], answers["k_min"]])
    places = np.stack([vertices[axis] for axis in "xyz"], 1).astype(np.float64)
    theirs = np.stack(igl.principal_curvature(places, faces)[2:4])
    return rms_percent(ours, truth), rms_percent(theirs, truth), rms_percent(ours, theirs)


with tempfile.TemporaryDirectory() as name:
    for label, shape in MESHES.items():
        for noise in (0, 0.02):
            ours, theirs, apart = compared(pathlib.Path(name), shape, noise)
            print(f"{label}, noise {noise}: ours {ours:.2f} %, libigl {theirs:.2f} %, apart {apart:.2f} %")
            assert ours <= theirs
