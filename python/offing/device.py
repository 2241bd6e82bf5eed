"""OpenCL devices."""

from __future__ import annotations

from offing import _core
from offing.drivers import find_installed_drivers


def list_devices() -> list[dict]:
    """All OpenCL devices of this machine: a list of dicts with index, name, type, vendor, platform, driver, memory_bytes
    and compute_units. Raises NoDevice if there is none."""
    find_installed_drivers()
    return _core.list_devices()


class Device:
    """An open OpenCL device. Threads may share one."""

    def __init__(self, selector: str | int | None = None):
        """`selector` is "cpu", "gpu", or an index or part of a name from list_devices(). None takes $OFFING_DEVICE, else
        the first GPU, else the CPU."""
        find_installed_drivers()
        self._device = _core.Device(None if selector is None else str(selector))

    @classmethod
    def adopt(cls, context, queue) -> "Device":
        """Uses a context of PyOpenCL and an in-order command queue of it. Offing enqueues its commands in that queue, and
        takes arrays and buffers of that context."""
        device = cls.__new__(cls)
        device._device = _core.Device.adopt(context.int_ptr, queue.int_ptr)
        return device

    @property
    def info(self) -> dict:
        """What the device reports: a dict as in list_devices()."""
        return self._device.info()

    @property
    def name(self) -> str:
        return self.info["name"]

    def finish(self) -> None:
        """Waits until the device has done all enqueued commands."""
        self._device.finish()

    def __repr__(self):
        return f"<offing.Device {self.name!r}>"
