"""Terrain, bodies, clouds and meshes of the Python package, with numpy alone."""

import pathlib
import tempfile
import unittest

import numpy as np

import offing

# A ridge along z = 500 m, 50 m high, on a plane that falls to the east by 1 in 100.
X_M, Z_M = np.meshgrid(10.0 * np.arange(101), 10.0 * np.arange(101))
RIDGE_M = (50.0 * np.exp(-(((Z_M - 500.0) / 60.0) ** 2)) - 0.01 * X_M).astype(np.float32)


class TerrainTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.device = offing.Device()
        cls.ridge = offing.Terrain(RIDGE_M, spacing_m=10.0, device=cls.device)

    # Fails if rows and columns are swapped, or heights between posts are not bilinear.
    def test_heights(self):
        self.assertEqual(self.ridge.shape, (101, 101))
        np.testing.assert_array_equal(self.ridge.heights_m, RIDGE_M)
        self.assertFalse(self.ridge.is_void.any())
        ground = self.ridge.sample([[200.0, 300.0], [205.0, 300.0], [-5.0, 0.0]])
        np.testing.assert_allclose(ground.height_m[:2], [RIDGE_M[30, 20], (RIDGE_M[30, 20] + RIDGE_M[30, 21]) / 2], atol=1e-6)
        self.assertTrue(np.isnan(ground.height_m[2]))
        self.assertEqual(ground.is_measured.tolist(), [True, True, False])
        np.testing.assert_allclose(np.linalg.norm(ground.normal[:2], axis=1), 1.0)

    # Fails if the ridge does not hide what is behind it, or hides what stands above it.
    def test_sight(self):
        lines = self.ridge.sight_lines([500.0, 900.0, 2.0], [[500.0, 100.0, 2.0], [500.0, 100.0, 150.0], [500.0, 600.0, 2.0]])
        self.assertEqual(lines.is_visible.tolist(), [False, True, True])
        # The ridge is 2 m high, as the eye, 60 m sqrt(ln 25) before its crest.
        self.assertAlmostEqual(lines.hidden_at_m[0], 400.0 - 60.0 * np.sqrt(np.log(25.0)), delta=2.0)
        self.assertTrue(np.isnan(lines.hidden_at_m[1]))
        seen = self.ridge.viewshed(500.0, 900.0, observer_height_m=2.0)
        self.assertEqual((seen.shape, seen.dtype), ((101, 101), np.bool_))
        self.assertTrue(seen[80, 50])
        self.assertFalse(seen[10, 50])
        self.assertFalse(self.ridge.viewshed(500.0, 900.0, radius_m=50.0)[80, 50])

    # Fails if rays straight down miss the ground, or upward ones hit it.
    def test_rays(self):
        hits = self.ridge.cast([[200.0, 500.0, 300.0]] * 2, [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]])
        self.assertAlmostEqual(hits.distance_m[0], 500.0 - RIDGE_M[30, 20], places=2)
        self.assertEqual(hits.distance_m[1], np.inf)
        self.assertEqual([offing.HIT_KINDS[kind] for kind in hits.kind], ["surface", "none"])

    # Fails if a file is another map than the array it holds, or options do not reach it.
    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "map.asc"
            path.write_text("ncols 3\nnrows 2\nxllcenter 1000\nyllcenter 2000\ncellsize 10\n1 2 3\n4 5 6\n")
            terrain = offing.Terrain(path, spacing_m=10.0, vertical_scale=2.0, device=self.device)
        np.testing.assert_array_equal(terrain.heights_m, [[2, 4, 6], [8, 10, 12]])
        self.assertEqual(terrain.info["origin_y"], 2010.0)
        for arguments in ({"source": "no/such.tif"}, {"source": RIDGE_M}, {"source": RIDGE_M[0], "spacing_m": 1.0}):
            with self.assertRaises(ValueError):
                offing.Terrain(device=self.device, **arguments)


class PartsTest(unittest.TestCase):
    # Fails if a box does not float where Archimedes says: 800 kg/m^3 in water of 1025 kg/m^3.
    def test_bodies(self):
        world = offing.World({
            "wind": {"speed_mps": 1}, "ocean": {"size": 16},
            "mesh": [{"name": "crate", "shape": "box", "size_m": 2.0}],
            "body": [{"mesh": "crate", "mass_kg": 1000.0}],
        }).at(1.0)
        poses = world.body_poses()
        self.assertEqual(poses["mass_centre_m"].shape, (1, 3))
        self.assertAlmostEqual(float(np.linalg.norm(poses["turn"][0])), 1.0, places=6)
        self.assertAlmostEqual(poses["displaced_m3"][0], 1000.0 / 1025.0, delta=0.1)
        self.assertEqual(world.body_forces()["pressure_n"].shape, (1, 3))
        self.assertEqual(world.meshes()[0]["name"], "crate")

    # Fails if clouds have no particles, density is elsewhere than these, or a picture is empty.
    def test_clouds(self):
        clouds = offing.Clouds(CUMULUS)
        self.assertEqual(len(clouds), 1)
        particles = clouds.particles()
        middle = particles["place_m"][np.argmax(particles["optical_mass_m2"])]
        extinction = clouds.extinction([middle, middle + [0.0, 1e5, 0.0]])
        self.assertGreater(extinction[0], 0.0)
        self.assertEqual(extinction[1], 0.0)
        light, distance_m = clouds.draw(32, 18)
        self.assertEqual(light.shape, (18, 32, 4))
        self.assertGreater(light[..., 3].max(), 0.5)
        self.assertGreater(distance_m.max(), 100.0)

    # Fails if highlights of a sphere are not on it.
    def test_highlights(self):
        world = offing.World(SPHERE)
        found = world.highlights()
        self.assertGreater(len(found["id"]), 0)
        self.assertEqual(found["position_m"].shape, (len(found["id"]), 3))


SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
CUMULUS, SPHERE = SCENES / "cumulus.toml", SCENES / "sphere.toml"


if __name__ == "__main__":
    unittest.main()
