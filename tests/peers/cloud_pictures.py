"""Our reference of a cloud's light, and whether another renderer's pictures of the exported cloud agree with it: mean light
within 3 %, root mean square error of blocks of 4 x 4 pixels at most 0.09 of the mean."""

import json

import numpy as np
import OpenEXR
import peer

WIDTH, HEIGHT, BLOCK = 80, 45, 4


def pixels(file, layer=""):
    """[row][column][RGBA] of an EXR file."""
    channels = OpenEXR.File(str(file), separate_channels=True).parts[0].channels
    return np.stack([channels[layer + name].pixels for name in "RGBA"], -1)


class Reference:
    """What our paths see, and `setting`: what --json prints of camera, light and cells."""

    def __init__(self, view, scene, samples, out):
        self.name = scene.stem
        self.setting = json.loads(peer.run(view, scene, "--compare-reference", "-o", out, "--size", f"{WIDTH}x{HEIGHT}",
                                           "--samples", samples, "--json", "--quiet"))
        image = pixels(out / "compared.exr", "reference.")
        self.has_cloud = blocks(image[..., 3]) >= 0.02
        assert self.has_cloud.sum() > 20
        self.light = self.light_of(image)

    def light_of(self, image):
        """Luminance of the blocks that show cloud."""
        return blocks(image[..., :3] @ [0.2126, 0.7152, 0.0722])[self.has_cloud]

    def agrees_with(self, images):
        """Whether the mean of independent images is as bright. Their differences show their noise."""
        parts = np.array([self.light_of(image) for image in images])
        light = parts.mean(0)
        mean, error = self.light.mean() / light.mean(), np.sqrt(np.mean((self.light - light) ** 2)) / light.mean()
        noise = np.sqrt(np.mean(parts.var(0, ddof=1)) / len(parts)) / light.mean()
        print(f"{self.name}: mean {mean:.3f}, rms error {error:.3f} in {len(light)} blocks, of which the peer's noise "
              f"{noise:.3f}; correlation {np.corrcoef(self.light, light)[0, 1]:.4f}", flush=True)
        return abs(mean - 1.0) <= 0.03 and error <= 0.09


def blocks(image):
    rows, columns = HEIGHT // BLOCK, WIDTH // BLOCK
    return image[:rows * BLOCK, :columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK).mean((1, 3))
