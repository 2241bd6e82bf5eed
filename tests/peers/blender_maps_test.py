"""Cycles moves a grid by the plain maps of `offing ocean bake --layout rgb`, put together by ocean.json alone, and its
position pass lies on the water of `offing ocean query`, with y up and with z up; foam that it shows has the mean of the
foam channel. Fails if a map is mirrored, shifted by a texel, scaled or in other axes than ocean.json says.

Heights: the facets of the grid and the query's interpolation are off by k^2 A dx^2 / 8 = 0.4 mm at most with waves of
k = 0.25 rad/m and 0.35 m on texels of 0.39 m; measured 0.04 mm rms, gate 1 mm. Foam: 64 random samples a texel;
measured 0.01 % of the mean, gate 1 %."""

import csv
import json
import pathlib
import struct
import tempfile

import peer

offing, scenes = peer.enter("bpy")

import bpy  # noqa: E402
import numpy  # noqa: E402

SWELL = """version = 1
[ocean]
spectrum = "swell"
swell_hs_m = 1
swell_period_s = 4
size = 256
[[ocean.cascade]]
patch_m = 100
"""
GALE = """version = 1
[wind]
speed_mps = 20
[ocean]
size = 128
[[ocean.cascade]]
patch_m = 60
[ocean.foam]
onset_jacobian = 0.9
"""
FRAME, FPS, SIDE_M, PIXELS = 7, 8, 40, 128


def channels_of(file):
    """The channels of an EXR file of uncompressed 32-bit floats, [rows][columns] each."""
    content = file.read_bytes()
    assert struct.unpack_from("<i", content)[0] == 20000630
    place, names, window = 8, [], None
    while content[place]:
        name, kind = content[place:].split(b"\0", 2)[:2]
        place += len(name) + len(kind) + 2
        (length,) = struct.unpack_from("<i", content, place)
        value = content[place + 4 : place + 4 + length]
        place += 4 + length
        if name == b"dataWindow":
            window = struct.unpack("<4i", value)
        elif name == b"compression":
            assert value == b"\0", "compressed"
        while name == b"channels" and value != b"\0":
            channel, value = value.split(b"\0", 1)
            assert struct.unpack_from("<i", value)[0] == 2, "not 32-bit floats"
            names.append(channel.decode())
            value = value[16:]
    columns, rows = window[2] - window[0] + 1, window[3] - window[1] + 1
    values = numpy.empty((rows, len(names), columns), dtype="<f4")
    for place in struct.unpack_from(f"<{rows}Q", content, place + 1):
        row, _ = struct.unpack_from("<2i", content, place)
        values[row - window[1]] = numpy.frombuffer(content, "<f4", values[0].size, place + 8).reshape(values[0].shape)
    return {name: values[:, i] for i, name in enumerate(names)}


def baked(folder, scene, *flags):
    """The folder and the description of a bake of one frame."""
    (folder / "sea.toml").write_text(scene)
    out = pathlib.Path(tempfile.mkdtemp(dir=folder))
    peer.run(offing, "ocean", "bake", folder / "sea.toml", "--frames", f"{FRAME}:{FRAME}", "--fps", FPS, "--quiet", *flags,
             "-o", out)
    return out, json.loads((out / "ocean.json").read_text())


class Studio:
    """A scene with a square of water below an orthographic camera, and a material to fill in."""

    def __init__(self, sea, side_m, is_flat=False):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.sea = sea
        self.is_z_up = sea["axes"]["up"] == "+z"
        self.scene = bpy.context.scene
        self.scene.render.engine = "CYCLES"
        self.scene.view_settings.view_transform = "Raw"
        self.scene.render.image_settings.file_format = "OPEN_EXR"
        self.scene.render.image_settings.color_depth = "32"
        self.scene.render.image_settings.exr_codec = "NONE"
        self.material = bpy.data.materials.new("water")
        self.material.use_nodes = True
        self.material.displacement_method = "DISPLACEMENT"
        self.nodes, self.links = self.material.node_tree.nodes, self.material.node_tree.links
        self.nodes.clear()
        self.output = self.nodes.new("ShaderNodeOutputMaterial")
        self.add_water(side_m, is_flat)
        camera = bpy.data.cameras.new("camera")
        camera.type, camera.ortho_scale = "ORTHO", side_m
        self.scene.camera = bpy.data.objects.new("camera", camera)
        self.scene.collection.objects.link(self.scene.camera)
        # A camera looks along its -z, with y up in the picture; turned about x it looks along -y.
        self.scene.camera.location = (0, 0, 50) if self.is_z_up else (0, 50, 0)
        self.scene.camera.rotation_euler = (0, 0, 0) if self.is_z_up else (-numpy.pi / 2, 0, 0)

    def add_water(self, side_m, is_flat):
        """A grid around the origin that reaches beyond the camera's edges: of two by two cells, or with vertices at texels."""
        texel_m = self.sea["cascades"][0]["texel_m"]
        half, step_m = (1, side_m) if is_flat else (int(side_m / 2 / texel_m) + 10, texel_m)
        places = [i * step_m for i in range(-half, half + 1)]
        across = len(places)
        vertices = [(a, b, 0) if self.is_z_up else (a, 0, -b) for b in places for a in places]
        faces = [(j * across + i, j * across + i + 1, (j + 1) * across + i + 1, (j + 1) * across + i)
                 for j in range(across - 1) for i in range(across - 1)]
        mesh = bpy.data.meshes.new("water")
        mesh.from_pydata(vertices, [], faces)
        mesh.materials.append(self.material)
        self.scene.collection.objects.link(bpy.data.objects.new("water", mesh))

    def socket(self, kind, operation, *inputs):
        """A node of arithmetic: its inputs are sockets or values."""
        node = self.nodes.new(kind)
        node.operation = operation
        for target, value in zip(node.inputs, inputs):
            if isinstance(value, bpy.types.NodeSocket):
                self.links.new(value, target)
            else:
                target.default_value = value
        return node.outputs[0]

    def map(self, folder, cascade, name):
        """The colour of a map at the water's places at rest, by texels of ocean.json."""
        place = self.nodes.new("ShaderNodeSeparateXYZ")
        self.links.new(self.nodes.new("ShaderNodeTexCoord").outputs["Object"], place.inputs[0])
        texels, row_axis = self.sea["texels"], self.sea["texels"]["row_axis"]
        sign = 1 if row_axis[0] == "+" else -1
        half = 0.5 / texels["columns"]
        u = self.socket("ShaderNodeMath", "MULTIPLY_ADD", place.outputs["X"], 1 / cascade["patch_m"], half)
        along_rows = place.outputs[row_axis[1].upper()]
        # Rows run down a picture, v runs up.
        v = self.socket("ShaderNodeMath", "MULTIPLY_ADD", along_rows, -sign / cascade["patch_m"], -half)
        uv = self.nodes.new("ShaderNodeCombineXYZ")
        self.links.new(u, uv.inputs["X"])
        self.links.new(v, uv.inputs["Y"])
        image = self.nodes.new("ShaderNodeTexImage")
        image.image = bpy.data.images.load(str(folder / (cascade["maps"][name]["file"] % FRAME)))
        image.image.colorspace_settings.name = "Non-Color"
        assert tuple(image.image.size) == (texels["columns"], texels["rows"])
        self.links.new(uv.outputs[0], image.inputs["Vector"])
        return image.outputs["Color"]

    def render(self, file, pixels, samples):
        self.scene.cycles.samples, self.scene.cycles.use_denoising = samples, False
        self.scene.cycles.use_adaptive_sampling = False
        self.scene.render.resolution_x = self.scene.render.resolution_y = pixels
        self.scene.render.filepath = str(file)
        bpy.ops.render.render(write_still=True)
        return channels_of(file)


def positions(folder, out, sea):
    """Where the camera sees the moved water, (pixels, 3) in the axes of the files."""
    studio = Studio(sea, SIDE_M)
    total = (0, 0, 0)
    for cascade in sea["cascades"]:
        total = studio.socket("ShaderNodeVectorMath", "ADD", total, studio.map(out, cascade, "displacement"))
    displacement = studio.nodes.new("ShaderNodeVectorDisplacement")
    displacement.space = "OBJECT"
    displacement.inputs["Midlevel"].default_value, displacement.inputs["Scale"].default_value = 0, 1
    studio.links.new(total, displacement.inputs["Vector"])
    studio.links.new(displacement.outputs[0], studio.output.inputs["Displacement"])
    studio.links.new(studio.nodes.new("ShaderNodeEmission").outputs[0], studio.output.inputs["Surface"])
    bpy.context.view_layer.use_pass_position = True
    studio.scene.use_nodes = True
    tree = studio.scene.node_tree
    tree.nodes.clear()
    layers, composite = tree.nodes.new("CompositorNodeRLayers"), tree.nodes.new("CompositorNodeComposite")
    tree.links.new(layers.outputs["Position"], composite.inputs["Image"])
    found = studio.render(folder / "position.exr", PIXELS, 1)
    return numpy.stack([found[name].ravel() for name in "RGB"], axis=1)


def heights(folder, points_xz):
    with open(folder / "points.csv", "w", newline="") as file:
        csv.writer(file).writerows([("x_m", "z_m"), *points_xz.tolist()])
    time = FRAME / FPS
    peer.run(offing, "ocean", "query", folder / "sea.toml", "--points", folder / "points.csv", "--times",
             f"{time}:{time}:1", "-o", folder / "water.csv", "--force", "--quiet")
    with open(folder / "water.csv", newline="") as file:
        return numpy.array([float(row["height_m"]) for row in csv.DictReader(file)])


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for axes in ("y-up", "z-up"):
        out, sea = baked(folder, SWELL, "--layout", "rgb", "--axes", axes)
        places = positions(folder, out, sea).astype(float)
        height, xz = (places[:, 2], places[:, :2] * (1, -1)) if axes == "z-up" else (places[:, 1], places[:, [0, 2]])
        error_mm = 1000 * (height - heights(folder, xz))
        rms_mm = numpy.sqrt(numpy.mean(error_mm**2))
        print(f"{axes}: {len(height)} places, heights of {height.std():.3f} m rms, off by {rms_mm:.3f} mm rms, "
              f"{numpy.abs(error_mm).max():.3f} mm at most")
        assert height.std() > 0.15 and xz.std() > 5 and rms_mm < 1

    expected = channels_of(baked(folder, GALE)[0] / f"ocean.c0.{FRAME:04}.exr")["foam"].mean()
    out, sea = baked(folder, GALE, "--layout", "rgb", "--axes", "z-up")
    studio = Studio(sea, sea["cascades"][0]["patch_m"], is_flat=True)
    emission = studio.nodes.new("ShaderNodeEmission")
    studio.links.new(studio.map(out, sea["cascades"][0], "foam"), emission.inputs["Color"])
    studio.links.new(emission.outputs[0], studio.output.inputs["Surface"])
    shown = studio.render(folder / "foam.exr", sea["texels"]["columns"], 64)["G"].mean()
    print(f"foam: mean {expected:.5f}, shown {shown:.5f}")
    assert expected > 0.01 and abs(shown / expected - 1) < 0.01
