"""Cycles renders an exported cumulus as our reference does (cloud_pictures.py). It takes cloud, light and camera only from
files and output of our programs, and scatters as docs/clouds.md says under "The same cloud in Cycles and Mitsuba".

Measured with Blender 4.5: mean 1.001, error 0.035; noise of blocks is 0.03 of Cycles and 0.02 of ours, of means 0.005. A
volume half a cell from its place has an error of 0.11. It takes 2 minutes of one core."""

import json
import math
import pathlib
import tempfile

import peer

offing, view, scenes = peer.enter("bpy")

import bpy  # noqa: E402, before what it brings along
import addon_utils  # noqa: E402
import cloud_pictures  # noqa: E402
from mathutils import Matrix, Vector  # noqa: E402

OUR_SAMPLES, THEIR_SAMPLES, PARTS = 2048, 2048, 4


def turned(vector):
    """From axes with y up to Blender's, with z up."""
    x, y, z = vector
    return Vector((x, -z, y))


def add(name, data):
    thing = bpy.data.objects.new(name, data)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def add_cloud(vdb, facts):
    volume = bpy.data.volumes.new("cloud")
    volume.filepath = str(vdb)
    volume.render.precision = "FULL"
    cloud = add("cloud", volume)
    cloud.rotation_euler = (math.pi / 2, 0, 0)
    # Cycles has the value of a cell at the corner of greatest coordinates, not in the middle.
    cloud.location = turned([-0.5 * facts["cell_m"]] * 3)
    material = bpy.data.materials.new("cloud")
    material.use_nodes = True
    nodes, link = material.node_tree.nodes, material.node_tree.links.new
    nodes.clear()
    density, both = nodes.new("ShaderNodeAttribute"), nodes.new("ShaderNodeAddShader")
    density.attribute_name = "density"
    for i, (anisotropy, share) in enumerate(((0.85, 0.95), (-0.3, 0.05))):
        scatter, product = nodes.new("ShaderNodeVolumeScatter"), nodes.new("ShaderNodeMath")
        product.operation = "MULTIPLY"
        product.inputs[1].default_value = share * facts["extinction_per_m"]
        scatter.inputs["Color"].default_value = (1, 1, 1, 1)
        scatter.inputs["Anisotropy"].default_value = anisotropy
        link(density.outputs["Fac"], product.inputs[0])
        link(product.outputs[0], scatter.inputs["Density"])
        link(scatter.outputs[0], both.inputs[i])
    link(both.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Volume"])
    volume.materials.append(material)


def add_light(setting):
    for light in setting["lights"]:
        sun = bpy.data.lights.new("sun", "SUN")
        sun.angle = 0
        sun.energy = max(light["illuminance_klx"])
        sun.color = [channel / sun.energy for channel in light["illuminance_klx"]]
        add("sun", sun).rotation_euler = turned(light["direction"]).to_track_quat("Z", "Y").to_euler()
    world = bpy.data.worlds.new("sky")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, link = world.node_tree.nodes, world.node_tree.links.new
    place, parts = nodes.new("ShaderNodeTexCoord"), nodes.new("ShaderNodeSeparateXYZ")
    is_up, mix = nodes.new("ShaderNodeMath"), nodes.new("ShaderNodeMix")
    is_up.operation, is_up.inputs[1].default_value, mix.data_type = "GREATER_THAN", 0, "RGBA"
    below, above = (socket for socket in mix.inputs if socket.type == "RGBA")
    below.default_value, above.default_value = setting["ground_kcdpm2"] + [1], setting["sky_kcdpm2"] + [1]
    link(place.outputs["Generated"], parts.inputs[0])
    link(parts.outputs["Z"], is_up.inputs[0])
    link(is_up.outputs[0], mix.inputs["Factor"])
    link(next(socket for socket in mix.outputs if socket.type == "RGBA"), nodes["Background"].inputs["Color"])


def add_camera(camera):
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit, lens.clip_end = "VERTICAL", 1e6
    lens.angle = math.radians(camera["vertical_field_of_view_deg"])
    eye = bpy.context.scene.camera = add("camera", lens)
    forward, up = turned(camera["forward"]), turned(camera["up"])
    eye.matrix_world = Matrix.Translation(turned(camera["eye_m"])) @ Matrix(
        (forward.cross(up), up, -forward)).transposed().to_4x4()


def render(file, seed):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", THEIR_SAMPLES // PARTS, seed
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.volume_bounces = 1024
    cycles.sample_clamp_indirect = 0
    cycles.pixel_filter_type = "BOX"
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = cloud_pictures.WIDTH, cloud_pictures.HEIGHT
    scene.render.resolution_percentage = 100
    output = scene.render.image_settings
    output.file_format, output.color_depth, output.color_mode = "OPEN_EXR", "32", "RGBA"
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)
    return cloud_pictures.pixels(file)


def main(out):
    scene, vdb = scenes / "cumulus.toml", out / "cloud.vdb"
    reference = cloud_pictures.Reference(view, scene, OUR_SAMPLES, out)
    peer.run(offing, "clouds", "build", scene, "-o", vdb, "--cell-m", reference.setting["cell_m"], "--quiet")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    addon_utils.enable("cycles")
    add_cloud(vdb, json.loads(peer.run(offing, "clouds", "info", vdb, "--json")))
    add_light(reference.setting)
    add_camera(reference.setting["camera"])
    assert reference.agrees_with([render(out / f"cycles{part}.exr", part) for part in range(PARTS)])


with tempfile.TemporaryDirectory() as folder:
    main(pathlib.Path(folder))
