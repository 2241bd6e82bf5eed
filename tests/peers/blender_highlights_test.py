"""Blender shows what an artist does with highlights: it imports the scene of `offing highlights --with-scene`, and it has the
layer of `offing-view --highlights only` over its own picture of the mesh.

Imported: every node is an object with its name and extras, every material, camera and light is there, and they have keys where
the file has them. Eight corners around the mesh are where Offing's camera has them, and a mesh that deforms has Offing's form in every frame. Fails if
names, units, axes or forms are lost.

Layer: Blender draws the mesh without highlights, and with them as it projects the textures of the imported boxes itself. The
layer over the first picture is the second within 2/255 (sRGB), measured 0.99. Fails if the layer is shifted or of another camera, size, opacity or kind of alpha."""

import json
import math
import pathlib
import tempfile

import peer

offing, view, scenes = peer.enter("bpy")

import bpy  # noqa: E402
import numpy as np  # noqa: E402
from bpy_extras.object_utils import world_to_camera_view  # noqa: E402
from mathutils import Vector  # noqa: E402

WIDTH, HEIGHT, FRAME, FPS = 320, 180, 12, 24
BASE = (0.2, 0.3, 0.4)  # on a darker one steps of the 8-bit alpha of textures in glTF would show by 2.6/255
SCENE = f"""version = 1
[time]
fps = {FPS}
end_s = 2
[sun]
azimuth_deg = 150
elevation_deg = 40
[camera]
x_m = 0.5
y_m = 2
z_m = 5
yaw_deg = {{ keys = [{{ t = 0, value = -9 }}, {{ t = 1, value = -3 }}] }}
pitch_deg = -6
fov_deg = {{ keys = [{{ t = 0, value = 32 }}, {{ t = 1, value = 36 }}] }}
[[light]]
name = "key"
kind = "place"
x_m = -4
y_m = 5
z_m = 4
colour = [1, 0.8, 0.5]
illuminance_klx = {{ keys = [{{ t = 0, value = 40 }}, {{ t = 1, value = 80 }}] }}
[[mesh]]
name = "ball"
shape = "ellipsoid"
y_m = 1.5
spin_deg_per_s = 20
[[mesh.highlight]]
softness = 1
opacity = 0.8
[[mesh]]
name = "growing"
file = "form_%d.obj"
sequence_fps = 2
x_m = 30
highlights = "off"
"""
# A tetrahedron at 0 s and at 0.5 s; Offing goes straight from form to form.
FORMS = [[(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 0, 0), (2, 0.5, 0), (0, 1, 0), (0, -0.5, 3)]]
FACES = [(1, 3, 2), (1, 2, 4), (1, 4, 3), (2, 3, 4)]


def imported(folder):
    """The document of the scene, once Blender has all of it."""
    file = folder / "shot.gltf"
    peer.run(offing, "highlights", folder / "shot.toml", "--with-scene", "-o", file, "--quiet")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.context.scene.render.fps = FPS
    bpy.ops.import_scene.gltf(filepath=str(file))
    return json.loads(file.read_text())


def has_keys(data):
    animation = data.animation_data
    return animation is not None and (animation.action is not None or len(animation.nla_tracks) > 0)


def check_import(document):
    nodes, channels = document["nodes"], document["animations"][0]["channels"]
    moved = {channel["target"]["node"] for channel in channels if "node" in channel["target"]}
    pointers = {channel["target"]["extensions"]["KHR_animation_pointer"]["pointer"] for channel in channels
                if channel["target"]["path"] == "pointer"}
    assert len(bpy.data.objects) == len(nodes)
    for i, node in enumerate(nodes):
        thing = bpy.data.objects[node["name"]]
        assert has_keys(thing) == (i in moved), node["name"]
        for key, value in node.get("extras", {}).items():
            assert value is None or thing[key] == value, (node["name"], key)
    animated = {document["materials"][int(pointer.split("/")[2])]["name"] for pointer in pointers
                if pointer.startswith("/materials/")}
    assert sorted(each.name for each in bpy.data.materials) == sorted(each["name"] for each in document["materials"])
    for material in bpy.data.materials:
        assert has_keys(material.node_tree) == (material.name in animated), material.name
    assert "/cameras/0/perspective/yfov" in pointers and has_keys(bpy.data.objects["camera"].data)
    assert "/extensions/KHR_lights_punctual/lights/0/intensity" in pointers and has_keys(bpy.data.objects["key"].data)
    assert bpy.data.objects["key"].data.type == "POINT" and bpy.data.objects["sun"].data.type == "SUN"
    print(f"{len(nodes)} objects, {len(moved)} of them moving; {len(bpy.data.materials)} materials, {len(animated)} animated")


def check_forms():
    """The mesh that deforms, as Blender has it halfway between two forms. Fails if it is at rest."""
    scene, thing = bpy.context.scene, bpy.data.objects["growing"]
    worst = 0
    for frame in (0, 6, 9, 12):
        scene.frame_set(frame)
        evaluated = thing.evaluated_get(bpy.context.evaluated_depsgraph_get())
        mesh = evaluated.to_mesh()
        found = np.array([(vertex.co.x, vertex.co.z, -vertex.co.y) for vertex in mesh.vertices])
        evaluated.to_mesh_clear()
        share = min(frame / FPS / 0.5, 1)
        expected = (1 - share) * np.array(FORMS[0]) + share * np.array(FORMS[1])
        worst = max(worst, np.abs(found - expected).max())
    print(f"forms off by {worst:.1e} m at most")
    assert worst < 1e-5


def pixel_of(place, time_s):
    """Where Offing's camera has a place of its world, pixels from the upper left corner."""
    yaw, pitch = math.radians(-9 + 6 * time_s), math.radians(-6)
    forward = np.array([math.cos(pitch) * math.sin(yaw), math.sin(pitch), -math.cos(pitch) * math.cos(yaw)])
    right = np.array([math.cos(yaw), 0, math.sin(yaw)])
    way = np.array(place) - (0.5, 2, 5)
    scale = HEIGHT / 2 / math.tan(math.radians(32 + 4 * time_s) / 2) / (way @ forward)
    return np.array([WIDTH / 2 + scale * (way @ right), HEIGHT / 2 - scale * (way @ np.cross(right, forward))])


def check_camera(scene):
    worst = 0
    for x in (-1, 1):
        for y in (0.5, 2.5):
            for z in (-1, 1):
                u, v, _ = world_to_camera_view(scene, scene.camera, Vector((x, -z, y)))
                found = np.array([u * WIDTH, (1 - v) * HEIGHT])
                worst = max(worst, np.abs(found - pixel_of((x, y, z), FRAME / FPS)).max())
    print(f"corners off by {worst:.4f} px at most")
    assert worst < 0.1


def pixels(file):
    """(rows, columns, 4) from the upper row on."""
    image = bpy.data.images.load(str(file))
    values = np.empty(len(image.pixels), dtype=np.float32)
    image.pixels.foreach_get(values)
    return values.reshape(image.size[1], image.size[0], 4)[::-1]


def emission(nodes, colour):
    node = nodes.new("ShaderNodeEmission")
    node.inputs["Color"].default_value = (*colour, 1)
    return node


def paint(ball, highlights, light):
    """Gives the ball a plain colour with textures of these projectors over it, (object, opacity), in this light."""
    material = bpy.data.materials.new("painted")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()

    def math_node(operation, first, second):
        node = nodes.new("ShaderNodeMath")
        node.operation = operation
        for socket, value in zip(node.inputs, (first, second)):
            if isinstance(value, (int, float)):
                socket.default_value = value
            else:
                links.new(value, socket)
        return node.outputs[0]

    shader = emission(nodes, BASE).outputs[0]
    for thing, opacity in highlights:
        place = nodes.new("ShaderNodeTexCoord")
        place.object = thing
        axes = nodes.new("ShaderNodeSeparateXYZ")
        links.new(place.outputs["Object"], axes.inputs[0])
        # The importer turned right, up, normal to x, z, -y; the box is -0.5 ... 0.5.
        uv = nodes.new("ShaderNodeCombineXYZ")
        links.new(math_node("ADD", axes.outputs[0], 0.5), uv.inputs[0])
        links.new(math_node("ADD", axes.outputs[2], 0.5), uv.inputs[1])
        texture = nodes.new("ShaderNodeTexImage")
        texture.image = next(node.image for node in thing.material_slots[0].material.node_tree.nodes if node.type == "TEX_IMAGE")
        texture.extension = "CLIP"
        links.new(uv.outputs[0], texture.inputs[0])
        # Of the other side of the ball nothing belongs to the region.
        is_near = math_node("LESS_THAN", axes.outputs[1], 1)
        mix = nodes.new("ShaderNodeMixShader")
        links.new(math_node("MULTIPLY", math_node("MULTIPLY", texture.outputs["Alpha"], is_near), opacity), mix.inputs[0])
        links.new(shader, mix.inputs[1])
        links.new(emission(nodes, light[thing["light"]]).outputs[0], mix.inputs[2])
        shader = mix.outputs[0]
    links.new(shader, nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    ball.material_slots[0].material = material


def rendered(scene, file):
    scene.render.filepath = str(file)
    bpy.ops.render.render(write_still=True)
    return pixels(file)[..., :3]


def srgb(linear):
    linear = np.clip(linear, 0, 1)
    return 255 * np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def check_layer(scene, folder):
    size, time = ("--size", f"{WIDTH}x{HEIGHT}"), ("--time", FRAME / FPS)
    peer.run(view, folder / "shot.toml", "--headless", *size, *time, "--highlights", "only", "-o", folder / "layer.exr", "--quiet")
    peer.run(offing, "highlights", folder / "shot.toml", "-o", folder / "shot.json", "--frames", FRAME, "--quiet")
    layer = pixels(folder / "layer.exr") * np.array([*[peer.header_of(folder / "layer.exr", "exposure")] * 3, 1])
    found = json.loads((folder / "shot.json").read_text())["meshes"][0]["frames"][0]["highlights"]
    ball, highlights, light = bpy.data.objects["ball"], [], {}
    for highlight in found:
        name = f"highlight {highlight['id']}.{highlight['rule']}.{highlight['copy']}"
        highlights.append((bpy.data.objects[name], highlight["opacity"]))
        # The colour where it is opaque is its light.
        u, v, _ = world_to_camera_view(scene, scene.camera, bpy.data.objects[name].matrix_world.translation)
        middle = layer[int((1 - v) * HEIGHT), int(u * WIDTH)]
        assert middle[3] > 0.75, middle
        light[highlight["light"]] = middle[:3] / middle[3]
    assert sorted(light) == [0, 1]
    for thing in bpy.data.objects:
        thing.hide_render = thing is not ball
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 64
    scene.cycles.use_denoising = False
    scene.cycles.pixel_filter_type = "BOX"
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    paint(ball, [], light)
    below = rendered(scene, folder / "below.exr")
    paint(ball, highlights, light)
    expected = rendered(scene, folder / "expected.exr")
    composed = layer[..., :3] + (1 - layer[..., 3:]) * below
    difference = np.abs(srgb(composed) - srgb(expected))
    changed = np.abs(srgb(expected) - srgb(below)).max(-1) > 2
    print(f"{changed.sum()} pixels of highlights: off by {difference[changed].mean():.3f}/255 on the mean, "
          f"{difference.max():.2f}/255 at most")
    assert changed.sum() > 300 and difference.max() <= 2


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "shot.toml").write_text(SCENE)
    for i, form in enumerate(FORMS):
        lines = [f"v {x} {y} {z}" for x, y, z in form] + [f"f {a} {b} {c}" for a, b, c in FACES]
        (folder / f"form_{i}.obj").write_text("\n".join(lines) + "\n")
    check_import(imported(folder))
    check_forms()
    scene = bpy.context.scene
    scene.camera = bpy.data.objects["camera"]
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT
    scene.frame_set(FRAME)
    check_camera(scene)
    check_layer(scene, folder)
