"""Terrain, bodies, clouds and meshes of the Python package, with numpy alone."""

import datetime
import json
import os
import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import offing

SPECTRUM = pathlib.Path(__file__).resolve().parents[2] / "scenes" / "example_sea.data_spec"
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
        south = self.ridge.viewshed(500.0, 900.0, observer_height_m=2.0, azimuth_deg=(90.0, 270.0))
        self.assertTrue(south[95, 50])
        self.assertFalse(south[80, 50])
        for nothing in ({"azimuth_deg": (0.0, 0.0)}, {"elevation_deg": (0, 0)}):
            with self.assertRaisesRegex(offing.BadInput, "two zeros"):
                self.ridge.viewshed(500.0, 900.0, **nothing)

    # Fails if counts are not sums of single viewsheds, values of observers are mixed up, or a callback cannot stop the call.
    def test_counts_of_viewsheds(self):
        points_m, heights_m, radii_m = [[500.0, 900.0], [480.0, 100.0], [40.0, 40.0]], [2.0, 30.0, 1.7], [0.0, 700.0, 60.0]
        found = self.ridge.count_viewsheds(points_m, observer_height_m=heights_m, radius_m=radii_m, best=2)
        each = [self.ridge.viewshed(x, z, observer_height_m=height, radius_m=radius)
                for (x, z), height, radius in zip(points_m, heights_m, radii_m)]
        np.testing.assert_array_equal(found.counts, np.sum(each, axis=0))
        np.testing.assert_array_equal(found.seen_posts, [seen.sum() for seen in each])
        np.testing.assert_array_equal(found.only_posts, [(seen & (found.counts == 1)).sum() for seen in each])
        self.assertEqual(found.reached_posts[0], found.counts.size)
        self.assertLess(found.reached_posts[2], 200)
        self.assertTrue(found.is_reached.all())
        self.assertTrue(found.is_best_exhaustive)
        self.assertEqual(found.best_posts[1], (each[found.best[0]] | each[found.best[1]]).sum())
        south = self.ridge.count_viewsheds(points_m[:1], observer_height_m=2.0, azimuth_deg=(90.0, 270.0))
        np.testing.assert_array_equal(
            south.counts, self.ridge.viewshed(500.0, 900.0, observer_height_m=2.0, azimuth_deg=(90.0, 270.0)))
        with self.assertRaisesRegex(offing.BadInput, r"observers\[1\]: .*observer_x_m"):
            self.ridge.count_viewsheds([[500.0, 900.0], [-5.0, 0.0]])
        with self.assertRaisesRegex(offing.BadInput, "radius_m: expected values"):
            self.ridge.count_viewsheds(points_m, radius_m=[1.0, 2.0])
        with self.assertRaises(offing.Cancelled):
            self.ridge.count_viewsheds(points_m, progress=lambda share: share < 0.5)

    # Fails if rows, azimuths or hours are exchanged, times are local, or a flag does nothing: behind the ridge the sun of
    # December is low in the south, and the horizon there is the ridge.
    def test_sky_and_sun(self):
        sky, horizons = self.ridge.sky_view(azimuths=16), self.ridge.horizons(azimuths=16)
        self.assertEqual((sky.shape, horizons.shape), ((101, 101), (16, 101, 101)))
        self.assertLess(sky[44, 50], sky[10, 50])
        self.assertLess(horizons[0, 30, 50], 0.01)
        self.assertGreater(horizons[8, 30, 50], 0.2)
        day = datetime.datetime(2026, 12, 21), datetime.datetime(2026, 12, 22)
        place = {"latitude_deg": 46.5, "longitude_deg": 8.0}
        sun = self.ridge.sun_hours(*day, **place, step_s=900)
        self.assertEqual((sun.hours.shape, sun.energy_kwh.dtype), ((101, 101), np.float32))
        self.assertAlmostEqual(sun.hours[50, 50], 8.53, delta=0.1)
        self.assertLess(sun.hours[42, 50], 5.0)
        self.assertLess(self.ridge.sun_hours(*day, **place, turbidity=6.0).energy_kwh[50, 50], 0.7 * sun.energy_kwh[50, 50])
        zone = datetime.timezone(datetime.timedelta(hours=1))
        morning = [datetime.datetime(2026, 12, 21, hour, tzinfo=zone) for hour in (0, 12)]
        self.assertAlmostEqual(self.ridge.sun_hours(*morning, **place, step_s=900).hours[50, 50], 3.9, delta=0.15)
        with self.assertRaisesRegex(offing.BadInput, "where it lies|place in the world"):
            self.ridge.sun_hours(*day)
        with self.assertRaisesRegex(offing.BadInput, "latitude and a longitude"):
            self.ridge.sun_hours(*day, latitude_deg=46.5)
        with self.assertRaisesRegex(offing.BadInput, "azimuths"):
            self.ridge.sky_view(azimuths=3)

    # Fails if x and z are exchanged, a level is ignored, or an island is no ring of its own. The bowl is an elliptic paraboloid
    # whose volume is half of area times depth; its lowest edge is in the east.
    def test_lakes(self):
        bowl_m = (X_M - 523.0) ** 2 / 2500.0 + (Z_M - 500.0) ** 2 / 1000.0
        bowl = offing.Terrain(bowl_m, spacing_m=10.0, device=self.device)
        full, low = bowl.fill_lake(523.0, 500.0), bowl.fill_lake(523.0, 500.0, level_m=36.0)
        self.assertEqual((full.level_m, full.spill_m), (full.spill_level_m, (1000.0, 500.0)))
        self.assertAlmostEqual(full.spill_level_m, 91.0116, places=4)
        area_m2 = np.pi * 36.0 * np.sqrt(2500.0 * 1000.0)
        self.assertAlmostEqual(low.area_m2 / area_m2, 1.0, delta=0.01)
        self.assertAlmostEqual(low.volume_m3 / (0.5 * area_m2 * 36.0), 1.0, delta=0.01)
        np.testing.assert_allclose(low.depth_m, np.maximum(36.0 - bowl_m, 0.0), atol=1e-4)
        (shore_m,) = low.shore_m
        np.testing.assert_array_equal(shore_m[0], shore_m[-1])
        np.testing.assert_allclose(((shore_m - [523.0, 500.0]) ** 2 / [2500.0, 1000.0]).sum(axis=1), 36.0, atol=0.2)
        bowl_m[45:50, 60:65] = 50.0
        island = offing.Terrain(bowl_m, spacing_m=10.0, device=self.device).fill_lake(523.0, 500.0, level_m=36.0).shore_m
        self.assertEqual(len(island), 2)
        np.testing.assert_allclose(island[1].mean(axis=0), [620.0, 470.0], atol=10.0)
        with self.assertRaisesRegex(offing.BadInput, "spill level"):
            bowl.fill_lake(523.0, 500.0, level_m=100.0)

    # Fails if longitude and latitude change places, or the way back leads elsewhere.
    def test_places(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.asc"
            path.write_text("ncols 2\nnrows 2\nxllcenter -70.5\nyllcenter -32.5\ncellsize 0.01\n1 2\n3 4\n")
            path.with_suffix(".prj").write_text(
                'GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],'
                'UNIT["degree",0.0174532925199433]]')
            terrain = offing.Terrain(path, device=self.device)
            place = [[-70.49, -32.49]]
            np.testing.assert_allclose(terrain.to_local(place), [[terrain.info["spacing_x_m"], 0.0]], atol=1e-6)
            np.testing.assert_allclose(terrain.from_local(terrain.to_local(place), "EPSG:4326"), place, atol=1e-9)
            with self.assertRaisesRegex(offing.BadInput, "expected local, map, lonlat"):
                terrain.to_local(place, "atlantis")
            wells = pathlib.Path(folder) / "wells.geojson"
            wells.write_text(json.dumps({"type": "FeatureCollection", "features": [
                {"type": "Feature", "properties": {"depth_m": depth_m, "name": "spring"},
                 "geometry": {"type": "Point", "coordinates": place[0]}} for depth_m in (7.5, None)]}))
            points = offing.read_points(wells)
            np.testing.assert_array_equal(points.places, place * 2)
            np.testing.assert_array_equal(points.z, [np.nan] * 2)
            np.testing.assert_array_equal(points.attributes["depth_m"], [7.5, np.nan])
            np.testing.assert_array_equal(points.attributes["name"], [np.nan] * 2)
            np.testing.assert_array_equal(
                terrain.to_local(points.places, points.coordinate_system), terrain.to_local(place * 2))
            with self.assertRaisesRegex(offing.BadInput, "nowhere"):
                offing.read_points(wells.with_name("nowhere.gpkg"))

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


class PathTest(unittest.TestCase):
    # Fails if a file is not found because its path is not UTF-8. Only TOML, which is UTF-8, cannot name it.
    def test_paths_of_any_bytes(self):
        with tempfile.TemporaryDirectory() as top:
            folder = pathlib.Path(os.fsdecode(os.path.join(os.fsencode(top), b"m\xe9t\xe9o")))
            folder.mkdir()
            for file in SPECTRUM.parent.glob("example_sea.*"):
                (folder / file.name).write_bytes(file.read_bytes())
            odd = folder / os.fsdecode(b"\xff.toml")
            odd.write_text('version = 1\n[ocean]\nspectrum_file = "example_sea.data_spec"\n')
            expected = offing.Spectrum.read(SPECTRUM)[0].hs_m
            self.assertEqual(offing.Spectrum.read(folder / "example_sea.data_spec")[0].hs_m, expected)
            scenes = [offing.Scene(odd), offing.Scene({"ocean": {"spectrum_file": "example_sea.data_spec"}}, folder=folder)]
            for scene in [*scenes, pickle.loads(pickle.dumps(scenes[1])), scenes[0].with_values({"ocean": {"size": 32}})]:
                self.assertAlmostEqual(scene.sea_state()["hs_m"], expected, places=4)
            mesh = offing.Mesh(np.eye(3), [[0, 1, 2]])
            mesh.save(folder / "a.ply")
            np.testing.assert_array_equal(offing.Mesh(folder / "a.ply").triangles, mesh.triangles)
            (folder / "a.asc").write_text("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n")
            np.testing.assert_array_equal(offing.Terrain(folder / "a.asc").heights_m, [[1, 2], [3, 4]])
            with self.assertRaises(offing.BadInput) as raised:
                offing.Spectrum.read(odd)
            str(raised.exception).encode()  # can be printed
            with self.assertRaisesRegex(offing.BadInput, "UTF-8"):
                offing.Scene({"terrain": {"file": odd}})


class PartsTest(unittest.TestCase):
    # Fails if a box does not float where Archimedes says: 800 kg/m^3 in water of 1025 kg/m^3.
    def test_bodies(self):
        world = offing.World({
            "wind": {"speed_mps": 1}, "ocean": {"size": 16, "hs_m": 0.02, "tp_s": 3.0},
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
        with self.assertRaisesRegex(offing.BadInput, "16384"):
            clouds.draw(20000, 18)

    # Fails if highlights of a sphere are not on it.
    def test_highlights(self):
        world = offing.World(SPHERE)
        found = world.highlights()
        self.assertGreater(len(found["id"]), 0)
        self.assertEqual(found["position_m"].shape, (len(found["id"]), 3))


class MeshTest(unittest.TestCase):
    # Fails if curvatures of a ball of 2 m are not within what offing.h states, or directions are no frame.
    def test_curvature(self):
        vertices_m, triangles = sphere(2.0, 5)
        mesh = offing.Mesh(vertices_m, triangles)
        found = mesh.curvature()
        np.testing.assert_allclose([found.k_max_per_m, found.k_min_per_m], 0.5, rtol=0.014)
        self.assertLess(np.mean(np.abs(found.k_max_per_m - 0.5)), 0.001 * 0.5)
        np.testing.assert_allclose(found.normal, vertices_m / 2.0, atol=0.004)
        np.testing.assert_allclose(np.cross(found.e_max, found.e_min), found.normal, atol=1e-6)
        self.assertAlmostEqual(found.area_m2.sum() / (16.0 * np.pi), 1.0, places=2)
        self.assertEqual((found.e_max.shape, found.confidence.shape), (vertices_m.shape, (len(vertices_m),)))
        noisy = offing.Mesh(vertices_m + np.random.default_rng(1).normal(0.0, 0.001, vertices_m.shape), triangles)
        rough, smooth = noisy.curvature(device=offing.Device()), noisy.curvature(rounds=20)
        self.assertLess(smooth.k_max_per_m.std(), 0.5 * rough.k_max_per_m.std())

    # Fails if a file holds another mesh than the arrays, or saving replaces a file without a word.
    def test_files(self):
        mesh = offing.Mesh([[0, 0, 0], [1, 0, 0], [1, 0.1, -1], [0, 0, -1]], [[0, 1, 2], [0, 2, 3]])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "roof.obj"
            mesh.save(path)
            with self.assertRaisesRegex(offing.BadInput, "roof.obj.*\n.*replace"):
                mesh.save(path)
            mesh.save(path, replace=True)
            read = offing.Mesh(path, untrusted=True)
        np.testing.assert_array_equal(read.vertices_m, mesh.vertices_m)
        np.testing.assert_array_equal(read.triangles, [[0, 1, 2], [0, 2, 3]])
        self.assertEqual((read.vertices_m.dtype, read.triangles.dtype), (np.float64, np.uint32))
        self.assertEqual((read.info["vertices"], read.info["triangles"], read.info["format"]), (4, 2, "OBJ"))
        np.testing.assert_array_equal(read.info["lowest_m"], [0.0, 0.0, -1.0])
        self.assertEqual(repr(read), "<offing.Mesh 4 vertices, 2 triangles>")

    # Fails if bad input is taken, wrapped to other numbers, or refused without a hint.
    def test_bad_input(self):
        corner = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
        nowhere = [[0.0, 0.0, 0.0], [np.nan, 0.0, 0.0], [0.0, 1.0, 0.0]]
        for arguments in (
            ("no/such.obj",), (corner, [[0, 1, 3]]), (corner, [[0, 1, -1]]), (corner, [[0, 1, 2**32]]), (nowhere, [[0, 1, 2]]),
            (corner, np.zeros((0, 3), dtype=int)),
        ):
            with self.assertRaises(offing.BadInput) as caught:
                offing.Mesh(*arguments)
            self.assertTrue(caught.exception.hint, arguments)
        for arguments in ((corner,), (corner, [[0.0, 1.0, 2.0]]), (corner, [0, 1, 2]), ("no/such.obj", [[0, 1, 2]])):
            with self.assertRaises(ValueError):
                offing.Mesh(*arguments)
        with self.assertRaisesRegex(offing.BadInput, "rounds"):
            offing.Mesh(corner, [[0, 1, 2]]).curvature(rounds=-1)
        with self.assertRaisesRegex(ValueError, "rounds"):
            offing.Mesh(corner, [[0, 1, 2]]).curvature(rounds=0)


def sphere(radius_m, level):
    """Vertices and triangles of an icosahedron whose edges are split in halves `level` times, all on a sphere."""
    golden = (1.0 + 5.0**0.5) / 2.0
    vertices = [(a, b, 0.0) for b in (-golden, golden) for a in (-1.0, 1.0)]
    vertices = np.array([np.roll(vertex, turn) for turn in range(3) for vertex in vertices])
    # Its faces are the triples of vertices that are 2 apart.
    near = np.isclose(np.linalg.norm(vertices[:, None] - vertices, axis=2), 2.0)
    triples = np.argwhere(near[:, :, None] & near[:, None, :] & near[None, :, :])
    outward = np.linalg.det(vertices[triples]) > 0.0
    triangles = triples[outward & (triples[:, 0] == triples.min(axis=1))]
    for _ in range(level):
        edges = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        edges, middles = np.unique(edges, axis=0, return_inverse=True)
        middles = middles.reshape(-1, 3) + len(vertices)
        vertices = np.concatenate([vertices, vertices[edges].mean(axis=1)])
        vertices /= np.linalg.norm(vertices, axis=1, keepdims=True)
        (a, b, c), (ab, bc, ca) = triangles.T, middles.T
        triangles = np.concatenate([np.stack(corners, axis=1) for corners in ((a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca))])
    return radius_m * vertices / np.linalg.norm(vertices, axis=1, keepdims=True), triangles


SCENES = pathlib.Path(__file__).resolve().parents[2] / "scenes"
CUMULUS, SPHERE = SCENES / "cumulus.toml", SCENES / "sphere.toml"


if __name__ == "__main__":
    unittest.main()
