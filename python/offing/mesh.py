"""Meshes: triangles from files and arrays, and how their surface bends."""

import os
from typing import NamedTuple

import numpy as np

from offing import _core
from offing.device import Device
from offing.errors import BadInput


class Curvature(NamedTuple):
    """How a surface bends at its vertices. Curvatures are positive where it is convex seen from outside: both are 1/r on a
    sphere of radius r. Directions are lines: their sign means nothing. Curvatures, vectors and confidence are 0 where a
    vertex has no triangle with an area."""

    k_max_per_m: np.ndarray  # [n], the largest curvature, 1/m
    k_min_per_m: np.ndarray  # [n], the smallest curvature, 1/m
    e_max: np.ndarray  # [n, 3], unit direction of the largest
    e_min: np.ndarray  # [n, 3], unit direction of the smallest
    normal: np.ndarray  # [n, 3], unit, outward: e_max x e_min
    area_m2: np.ndarray  # [n], a third of the triangles around
    confidence: np.ndarray  # [n], 0 to 1: how far to trust directions; near 0 on spheres


class Mesh:
    """Triangles of a surface, whose corners are anticlockwise seen from outside. A mesh does not change: threads may share
    it."""

    def __init__(self, source, triangles=None, *, untrusted=False):
        """`source` is the name of a file (OBJ, PLY, OFF, STL, glTF), or vertices [n, 3] in m; `triangles` [m, 3] are then
        indices of vertices from 0 on. Polygons of a file are cut into triangles. An untrusted file may lead to files in its
        folder and below alone."""
        if isinstance(source, (str, os.PathLike)):
            if triangles is not None:
                raise ValueError("triangles: expected None beside a file")
            self._mesh = _core.Mesh.open(os.fspath(source), untrusted)
        elif triangles is None:
            raise ValueError("triangles: expected an array [m, 3] beside vertices")
        else:
            vertices_m = _table("vertices", np.asarray(source, dtype=np.float64))
            self._mesh = _core.Mesh.make(vertices_m, _indices(_table("triangles", np.asarray(triangles)), len(vertices_m)))

    @property
    def info(self):
        """What the mesh is: a dict of vertices and triangles (how many), lowest_m and highest_m (x, y, z of the box around
        all vertices), and format, which is "" for arrays."""
        return self._mesh.info()

    @property
    def vertices_m(self):
        """The places of vertices, float64 [n, 3], m: a copy."""
        return self._mesh.read()[0]

    @property
    def triangles(self):
        """The vertices of triangles, uint32 [m, 3]: a copy."""
        return self._mesh.read()[1]

    def curvature(self, *, device=None, rounds=3):
        """The Curvature at all vertices, computed on a device (a Device, or what Device() takes). Angles at edges are
        averaged with those of neighbours for some rounds, 1 to 1000: more smooth a noisy surface.

        Measured errors of curvatures in % of the larger one at a vertex, mean and largest: 0.1 and 1.4 on an icosphere of
        10,242 vertices, 0.5 and 4.8 on an uneven ellipsoid of as many, 3.4 and 18 on one of 642. Noise off the surface of
        0.02 edges costs 5 and 46, with 10 rounds 1.4 and 8.6. offing.h has errors of directions and normals.
        """
        device = device if isinstance(device, Device) else Device(device)
        return Curvature(*self._mesh.curvature(device._device, rounds))

    def save(self, file, *, replace=False):
        """Writes what the name says: .ply, .obj, .off or .stl. An existing file raises BadInput unless `replace` is True."""
        self._mesh.save(os.fspath(file), replace)

    def __repr__(self):
        info = self.info
        return f"<offing.Mesh {info['vertices']} vertices, {info['triangles']} triangles>"


def _table(name, values):
    if values.ndim != 2 or values.shape[1] != 3:
        raise ValueError(f"{name}: expected an array [n, 3], got one of shape {values.shape}")
    return np.ascontiguousarray(values)


def _indices(triangles, vertices):
    """As unsigned numbers of 32 bits, to which numpy would wrap any others."""
    if not np.issubdtype(triangles.dtype, np.integer):
        raise ValueError(f"triangles: expected whole numbers, got {triangles.dtype}")
    is_outside = ((triangles < 0) | (triangles >= vertices)).any(axis=1)
    if is_outside.any():
        first = int(np.argmax(is_outside))
        raise BadInput(f"triangles[{first}]: expected vertices 0 ... {vertices - 1}, got {triangles[first].tolist()}",
                       "count vertices from 0 on, and give all vertices that triangles name")
    return triangles.astype(np.uint32)
