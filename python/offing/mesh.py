"""Meshes: triangles from files and arrays, and their curvatures."""

from __future__ import annotations

import os
from typing import NamedTuple

import numpy as np

from offing import _core
from offing.arrays import rows
from offing.device import Device
from offing.errors import BadInput


class Curvature(NamedTuple):
    """Curvatures of a surface at its vertices. They are positive where it is convex: both are 1/r on a sphere of radius r.
    The sign of a direction has no meaning. Curvatures, vectors and confidence are 0 at vertices without a triangle that
    has an area."""

    k_max_per_m: np.ndarray  # [n], the largest curvature, 1/m
    k_min_per_m: np.ndarray  # [n], the smallest curvature, 1/m
    e_max: np.ndarray  # [n, 3], unit direction of the largest
    e_min: np.ndarray  # [n, 3], unit direction of the smallest
    normal: np.ndarray  # [n, 3], unit, outward: e_max x e_min
    area_m2: np.ndarray  # [n], a third of the area of the triangles around
    confidence: np.ndarray  # [n], 0 to 1, of directions; near 0 on spheres


class Mesh:
    """A triangle mesh. Corners of triangles are anticlockwise seen from outside. A mesh does not change, so that threads
    may share it."""

    def __init__(self, source, triangles=None, *, untrusted=False):
        """`source` is the path of a file (OBJ, PLY, OFF, STL, glTF), or vertices [n, 3] in m. With vertices, `triangles`
        [m, 3] has indices of vertices from 0 on. Polygons of a file become triangles. An untrusted file may only refer to
        files in and below its folder."""
        if isinstance(source, (str, os.PathLike)):
            if triangles is not None:
                raise BadInput("triangles: expected None beside a file, got some", "pass the file alone")
            self._mesh = _core.Mesh.open(source, untrusted)
        elif triangles is None:
            raise BadInput("triangles: expected an array [m, 3] beside vertices, got None", "pass Mesh(vertices, triangles)")
        else:
            vertices_m = rows("vertices", source, 3)
            self._mesh = _core.Mesh.make(vertices_m, _indices(np.asarray(triangles), len(vertices_m)))

    @property
    def info(self):
        """What is known about the mesh, as a dict. vertices and triangles are their numbers. lowest_m and highest_m are x, y,
        z of the box around all vertices. format is "" for arrays."""
        return self._mesh.info()

    @property
    def vertices_m(self):
        """A copy of the vertices, float64 [n, 3], m."""
        return self._mesh.read()[0]

    @property
    def triangles(self):
        """A copy of the triangles, uint32 [m, 3]: indices of vertices."""
        return self._mesh.read()[1]

    def curvature(self, *, device=None, rounds=3):
        """The Curvature at all vertices, computed on a Device or what Device() takes. Angles at edges are averaged with those
        of neighbours in `rounds`, 1 to 1000; more suit a noisy surface.

        Measured errors of curvatures, mean and largest, are in % of the larger one at a vertex. They are 0.1 and 1.4 on an
        icosphere of 10,242 vertices. On an uneven ellipsoid they are 0.5 and 4.8 with as many vertices, 3.4 and 18 with
        642. Noise off the surface of 0.02 edges raises them to 5 and 46, or with 10 rounds to 1.4 and 8.6. offing.h has
        errors of directions and normals.
        """
        device = device if isinstance(device, Device) else Device(device)
        return Curvature(*self._mesh.curvature(device._device, rounds))

    def save(self, file, *, replace=False):
        """Writes a .ply, .obj, .off or .stl file, by its name. Raises BadInput if the file exists, unless `replace` is True."""
        self._mesh.save(file, replace)

    def __repr__(self):
        info = self.info
        return f"<offing.Mesh {info['vertices']} vertices, {info['triangles']} triangles>"


def _indices(triangles, vertices):
    """Triangles as uint32. Checked first, because numpy would wrap negative and larger numbers."""
    if triangles.ndim != 2 or triangles.shape[1] != 3:
        raise BadInput(f"triangles: expected an array [m, 3], got one of shape {triangles.shape}", "give 3 vertices for each")
    if not np.issubdtype(triangles.dtype, np.integer):
        raise BadInput(f"triangles: expected whole numbers, got {triangles.dtype}", "pass triangles.astype(int)")
    is_outside = ((triangles < 0) | (triangles >= vertices)).any(axis=1)
    if is_outside.any():
        first = int(np.argmax(is_outside))
        raise BadInput(f"triangles[{first}]: expected vertices 0 ... {vertices - 1}, got {triangles[first].tolist()}",
                       "count vertices from 0 on, and give all vertices that triangles name")
    return np.ascontiguousarray(triangles, dtype=np.uint32)
