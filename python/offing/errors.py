"""Exceptions of Offing."""


class Error(RuntimeError):
    """A call failed. `message` is one line with the reason. `hint` is one line with a fix, or "". str() has both."""

    def __init__(self, message, hint=""):
        super().__init__(message if not hint else f"{message}\nhint: {hint}")
        self.message = message
        self.hint = hint


class BadInput(Error, ValueError):
    """A wrong argument or scene, or a value out of range. Nothing has changed."""


class NoDevice(Error):
    """No such OpenCL device, or no OpenGL for a picture."""


class Cancelled(Error):
    """A callback asked to stop."""


class Busy(Error):
    """Another thread is in a call with the same object. Nothing has changed."""


DRIVER_HINT = (
    "install a driver: `apt install pocl-opencl-icd` on Debian and Ubuntu, "
    "or `pip install intel-opencl-rt intel-cmplr-lib-rt` for processors of Intel and AMD"
)


def from_status(status, message, hint):
    """The exception of an OffingStatus."""
    kind = {2: BadInput, 3: NoDevice, 4: Cancelled, 5: Busy}.get(status, Error)
    if kind is NoDevice and message.startswith("no OpenCL"):
        hint = DRIVER_HINT
    return kind(message, hint)
