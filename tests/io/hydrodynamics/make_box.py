"""Writes box.nc, box.1, box.3 and box.hst of this folder with Capytaine 3.0: the data base of a box without planes of
symmetry about its origin. Usage: make_box.py FOLDER"""

import pathlib
import sys

import capytaine
import numpy
import xarray

folder = pathlib.Path(sys.argv[1])
mesh = capytaine.mesh_parallelepiped(size=(4, 2, 2), resolution=(24, 12, 12), center=(0.5, 0.2, -0.2)).immersed_part()
centre = (0.3, 0.0, -0.4)
body = capytaine.FloatingBody(mesh=mesh, dofs=capytaine.rigid_body_dofs(rotation_center=centre), center_of_mass=centre,
                              name="box", lid_mesh=mesh.generate_lid())
problems = xarray.Dataset(coords={"omega": [1.0, 1.5, 2.0, numpy.inf], "wave_direction": numpy.radians([-70, 0, 40]),
                                  "radiating_dof": list(body.dofs), "water_depth": [numpy.inf], "rho": [1025.0]})
data = capytaine.BEMSolver().fill_dataset(problems, body)
data = data.drop_vars(["diffraction_force", "Froude_Krylov_force", "inertia_matrix", "freq", "wavelength", "wavenumber"],
                      errors="ignore")
capytaine.export_dataset(folder / "box.nc", data)
capytaine.export_dataset(folder / "box", data, format="wamit")
