"""Our panel method against Capytaine's: motions in head and beam waves of five hulls of the same mass, inertia and mass
centre. Limits: heave 10 % or 1 mm/m, pitch and roll 20 % where |T / Tn - 1| > 0.25, heave - 1 30 % where it is above 0.1,
natural periods 5 %."""

import json

import peer

dump, _ = peer.enter("capytaine")

import capytaine as cpt  # noqa: E402
import numpy as np  # noqa: E402
import xarray as xr  # noqa: E402

cpt.set_logging("ERROR")
DENSITY, GRAVITY = 1025.0, 9.81
# From Capytaine's axes (x forward, y to port, z up) to the hull's (x forward, y up, z to starboard).
TURN = np.kron(np.eye(2), np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]]))
DOFS = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]


def theirs(hull, periods):
    triangles = np.array(hull["triangles"])
    vertices = triangles.reshape(-1, 3)
    faces = np.arange(len(vertices)).reshape(-1, 3)[:, [0, 1, 2, 2]]
    mesh = cpt.Mesh(vertices=vertices, faces=faces)
    centre = (0.0, 0.0, -hull["centre_below_m"])
    body = cpt.FloatingBody(mesh=mesh, lid_mesh=mesh.generate_lid(), center_of_mass=centre,
                            dofs=cpt.rigid_body_dofs(rotation_center=centre))
    omegas = np.sort(2 * np.pi / np.array(periods))
    data = cpt.BEMSolver().fill_dataset(xr.Dataset(coords={
        "omega": omegas, "wave_direction": [0.0, -np.pi / 2], "radiating_dof": list(body.dofs), "rho": [DENSITY],
        "g": [GRAVITY], "water_depth": [np.inf]}), body, n_jobs=1, progress_bar=False).squeeze()
    order = {"influenced_dof": DOFS, "radiating_dof": DOFS}
    a = data.added_mass.sel(order).transpose("omega", "influenced_dof", "radiating_dof").values
    b = data.radiation_damping.sel(order).transpose("omega", "influenced_dof", "radiating_dof").values
    force = data.excitation_force if "excitation_force" in data else data.Froude_Krylov_force + data.diffraction_force
    force = force.sel(influenced_dof=DOFS, wave_direction=[0.0, -np.pi / 2])
    x = force.transpose("omega", "wave_direction", "influenced_dof").values
    return omegas, TURN @ a @ TURN.T, TURN @ b @ TURN.T, x @ TURN.T


def natural(omegas, added, mass, restoring, motion):
    omega = omegas[len(omegas) // 2]
    for _ in range(60):
        a = np.stack([[np.interp(omega, omegas, added[:, i, j]) for j in range(6)] for i in range(6)])
        values, vectors = np.linalg.eig(np.linalg.solve(mass + a, restoring))
        energy = np.where(values.real > 1e-9, np.abs(vectors[motion]) ** 2 / np.maximum(
            np.einsum("ik,ij,jk->k", vectors.conj(), restoring, vectors).real, 1e-30), 0)
        omega = 0.5 * (omega + np.sqrt(values.real[np.argmax(energy)]))
    return 2 * np.pi / omega


failures = []
for name in ["cube", "shallow", "barge", "cylinder", "coaster"]:
    hull = json.loads(peer.run(dump, name))
    mass, restoring = (np.array(hull[key]).reshape(6, 6) for key in ("mass", "restoring"))
    omegas, a, b, x = theirs(hull, [row["period_s"] for row in hull["responses"]])
    periods = {}
    for index, (mode, motion) in enumerate({"heave": 1, "roll": 3, "pitch": 5}.items()):
        if restoring[motion, motion] <= 0:
            continue
        ours, peers = hull["natural_s"][index], natural(omegas, a, mass, restoring, motion)
        periods[mode] = peers
        print(f"{name} natural {mode}: {ours:.3f} for {peers:.3f} s, {100 * (ours / peers - 1):+.1f} %")
        if abs(ours / peers - 1) > 0.05:
            failures.append(f"{name} natural {mode}")
    for row in hull["responses"]:
        k = np.argmin(abs(omegas - 2 * np.pi / row["period_s"]))
        left = restoring - omegas[k] ** 2 * (mass + a[k]) - 1j * omegas[k] * b[k]
        head, beam = (abs(np.linalg.solve(left, x[k, direction])) for direction in (0, 1))
        for mode, value, limit in (("heave", head[1], 0.1), ("pitch", head[5], 0.2), ("roll", beam[3], 0.2)):
            ratio = row[mode] / value
            apart = mode in periods and abs(row["period_s"] / periods[mode] - 1) > 0.25
            fails = apart and abs(ratio - 1) > limit and (mode != "heave" or abs(row[mode] - value) > 1e-3)
            if apart and mode == "heave" and abs(value - 1) > 0.1:
                fails = fails or abs((row[mode] - 1) / (value - 1) - 1) > 0.3
            print(f"{name} {row['period_s']:4.1f} s {mode}: {row[mode]:.4f} for {value:.4f}, {100 * (ratio - 1):+.1f} %"
                  + ("" if apart else " (near its period)") + (" FAILS" if fails else ""))
            if fails:
                failures.append(f"{name} {row['period_s']} s {mode}")
    print(f"{name}: {hull['cost_s']:.2f} s", flush=True)
assert not failures, failures
