"""Arrays of PyOpenCL are filled on the device. Needs pyopencl from PyPI."""

import sys
import unittest

import numpy as np

import offing

try:
    import pyopencl
    import pyopencl.array
except ImportError:
    print("no pyopencl: ./dev test --slow installs it")
    sys.exit(77)

N = 64
SCENE = {"wind": {"speed_mps": 9}, "ocean": {"size": N}}


class PyopenclTest(unittest.TestCase):
    def setUp(self):
        device = pyopencl.get_platforms()[0].get_devices()[0]
        self.context = pyopencl.Context([device])
        self.queue = pyopencl.CommandQueue(self.context)
        self.world = offing.World(SCENE, device=offing.Device.adopt(self.context, self.queue)).at(4.0)

    # Fails if a field in an array of the caller's differs from the one on the host, or lies elsewhere in it.
    def test_fields_are_copied_on_the_device(self):
        array = pyopencl.array.zeros(self.queue, 2 * N * N + 5, np.float32)
        for name in ("displacement_y", "jacobian", "gradient_xz"):
            expected = self.world.field(name).ravel()
            self.world.copy_field(name, array, first=5)
            np.testing.assert_array_equal(array.get()[5 : 5 + N * N], expected)
            self.assertEqual(array.get()[:5].max(), 0.0)
            # A part of an array begins where it begins; a kernel of PyOpenCL that follows sees the field.
            self.world.copy_field(name, array[5 + N * N :])
            doubled = 2.0 * array[5 + N * N :]
            np.testing.assert_array_equal(doubled.get(), 2.0 * expected)

    # Fails if the copy goes through the host: PyOpenCL's queue is the one of the copy, and nothing waits. The event of
    # the array's last use in that queue comes after it.
    def test_nothing_waits(self):
        array = pyopencl.array.empty(self.queue, (N, N), np.float32)
        self.world.copy_field("slope_x", array)
        marker = pyopencl.enqueue_marker(self.queue)
        marker.wait()
        np.testing.assert_array_equal(array.get(), self.world.field("slope_x"))

    # Fails if samples on the device are not those on the host.
    def test_samples_on_the_device(self):
        places = np.zeros(3, dtype=[("tile_x", np.int32), ("tile_z", np.int32), ("x_m", np.float32), ("z_m", np.float32)])
        places["tile_x"], places["tile_z"], places["x_m"], places["z_m"] = [0, 1, -2], [0, -1, 5], [1.5, 0.0, 3.0], [2.5, 3.0, 0.25]
        points = pyopencl.array.to_device(self.queue, places.view(np.int32))
        samples = pyopencl.array.zeros(self.queue, (3, 8), np.float32)
        self.world.sample_on_device(points, 3, samples)
        metres = np.column_stack([64.0 * places["tile_x"] + places["x_m"], 64.0 * places["tile_z"] + places["z_m"]])
        water = self.world.sample(metres)
        np.testing.assert_array_equal(samples.get()[:, 0], water.height_m)
        np.testing.assert_array_equal(samples.get()[:, 4:7], water.velocity_mps)
        full = pyopencl.array.zeros(self.queue, (3, 12), np.float32)
        self.world.sample_on_device(points, 3, full, full=True)
        np.testing.assert_array_equal(full.get()[:, 8:11], water.acceleration_mps2)

    # Fails if a buffer that is too small or of another context is written.
    def test_refuses_other_buffers(self):
        with self.assertRaises(offing.BadInput):
            self.world.copy_field("slope_x", pyopencl.array.empty(self.queue, N, np.float32))
        other = pyopencl.Context(self.context.devices)
        with self.assertRaisesRegex(offing.BadInput, "context"):
            self.world.copy_field("slope_x", pyopencl.array.empty(pyopencl.CommandQueue(other), (N, N), np.float32))


if __name__ == "__main__":
    unittest.main()
