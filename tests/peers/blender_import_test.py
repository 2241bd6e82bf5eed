"""A scene that Blender exports as glTF: a camera, two lights, and a mesh with a shape key, a skin and a moving parent.
Fails if the imported camera projects places to other pixels than Blender's, if lights stand elsewhere, or if the
highlights of the deforming mesh are not those of its vertices as Blender has them, given to the C++ interface."""

import json
import math
import pathlib
import subprocess
import tempfile

import peer

offing, dump, _ = peer.enter("bpy")

import bpy  # noqa: E402
import bpy_extras.object_utils  # noqa: E402
from mathutils import Euler, Vector  # noqa: E402

FPS, FRAMES, WIDTH, HEIGHT = 60, 49, 1280, 720
MOST_PX = 0.1
MOST_SHARE = 1e-4  # of the diagonal


def keyed(owner, path, keys):
    """Keyframes (frame, value) of a property, by Blender's own curves."""
    for frame, value in keys:
        setattr(owner, path, value)
        owner.keyframe_insert(path, frame=frame)


def make_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.fps, scene.frame_start, scene.frame_end = FPS, 0, FRAMES - 1
    scene.render.resolution_x, scene.render.resolution_y = WIDTH, HEIGHT

    bpy.ops.mesh.primitive_torus_add(major_radius=1.0, minor_radius=0.4, major_segments=60, minor_segments=24)
    torus = bpy.context.object
    torus.data.polygons.foreach_set("use_smooth", [True] * len(torus.data.polygons))
    torus.shape_key_add(name="Basis")
    key = torus.shape_key_add(name="Bulge")
    for point in key.data:
        point.co = point.co * (1.0 + 0.3 * math.exp(-4.0 * (point.co.x - 1.0) ** 2))
    keyed(key, "value", [(0, 0.0), (20, 1.0), (FRAMES - 1, 0.2)])

    bpy.ops.object.armature_add(location=(0, 0, 0))
    armature = bpy.context.object
    bpy.ops.object.mode_set(mode="EDIT")
    root = armature.data.edit_bones[0]
    root.head, root.tail = (-1.5, 0, 0), (0, 0, 0)
    tip = armature.data.edit_bones.new("Tip")
    tip.head, tip.tail, tip.parent = (0, 0, 0), (1.5, 0, 0), root
    names = root.name, tip.name
    bpy.ops.object.mode_set(mode="OBJECT")
    groups = [torus.vertex_groups.new(name=name) for name in names]
    for vertex in torus.data.vertices:
        share = 1.0 / (1.0 + math.exp(-4.0 * vertex.co.x))
        for group, weight in zip(groups, (1.0 - share, share)):
            group.add([vertex.index], weight, "REPLACE")
    torus.parent = armature
    torus.modifiers.new("Armature", "ARMATURE").object = armature
    bone = armature.pose.bones["Tip"]
    bone.rotation_mode = "XYZ"
    keyed(bone, "rotation_euler", [(0, (0, 0, 0)), (FRAMES - 1, (0.5, 0.3, -0.2))])
    keyed(armature, "location", [(0, (0, 0, 0.5)), (FRAMES - 1, (0.3, 0.2, 0.9))])

    camera = bpy.data.objects.new("Shot", bpy.data.cameras.new("Shot"))
    camera.data.lens = 40.0
    scene.collection.objects.link(camera)
    scene.camera = camera
    keyed(camera, "location", [(0, (0, -6, 2)), (FRAMES - 1, (2, -5, 3))])
    keyed(camera, "rotation_euler", [(0, (1.3, 0.05, 0.1)), (FRAMES - 1, (1.1, -0.1, 0.4))])
    for name, kind, place in (("Key", "SUN", (0, 0, 5)), ("Fill", "POINT", (-3, -4, 4))):
        light = bpy.data.objects.new(name, bpy.data.lights.new(name, kind))
        light.data.energy = 3.0 if kind == "SUN" else 4000.0
        light.location, light.rotation_euler = place, Euler((0.7, 0.2, 0.4))
        scene.collection.objects.link(light)
    return torus, camera


def in_offing(place):
    """Blender's z points up, glTF's and Offing's y."""
    return [place.x, place.z, -place.y]


def vertices(torus):
    evaluated = torus.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    places = [in_offing(evaluated.matrix_world @ vertex.co) for vertex in mesh.vertices]
    mesh.calc_loop_triangles()
    faces = [list(triangle.vertices) for triangle in mesh.loop_triangles]
    evaluated.to_mesh_clear()
    return places, faces


def dumped(what, scene, folder, values):
    file = folder / f"{what}_input.json"
    file.write_text(json.dumps(values))
    output = subprocess.run([dump, what, scene, file], check=True, stdout=subprocess.PIPE, text=True).stdout
    return json.loads(output)


def compare_pixels(scene, folder, camera):
    corners, expected = [], []
    for frame in range(FRAMES):
        bpy.context.scene.frame_set(frame)
        box = [Vector((x, y, z)) for x in (-1, 1) for y in (-1, 1) for z in (0, 2)]
        seen = [bpy_extras.object_utils.world_to_camera_view(bpy.context.scene, camera, corner) for corner in box]
        corners.append([in_offing(corner) for corner in box])
        expected.append([(each.x * WIDTH, (1 - each.y) * HEIGHT) for each in seen])
    found = dumped("pixels", scene, folder, {"places_m": corners, "fps": FPS, "width_px": WIDTH, "height_px": HEIGHT})
    worst = max(math.dist(a, b) for one, other in zip(found, expected) for a, b in zip(one, other))
    print(f"camera: eight corners in {FRAMES} frames, {worst:.5f} px apart at most, gate {MOST_PX}")
    assert len(found) == FRAMES and worst <= MOST_PX


def compare_highlights(scene, folder, torus):
    forms, faces = [], []
    for frame in range(FRAMES):
        bpy.context.scene.frame_set(frame)
        form, faces = vertices(torus)
        forms.append(form)
    expected = dumped("highlights", scene, folder, {"forms_m": forms, "faces": faces, "fps": FPS})
    file = folder / "highlights.json"
    peer.run(offing, "highlights", scene, "-o", file, "--frames", f"0:{FRAMES - 1}", "--fps", FPS, "--quiet")
    frames = json.loads(file.read_text())["meshes"][0]["frames"]
    assert len(frames) == len(expected) == FRAMES
    worst, count, way = 0.0, 0, 0.0
    start = {each["id"]: each["position_m"] for each in expected[0]}
    for found, wanted in zip(frames, expected):
        found = {each["id"]: each for each in found["highlights"]}
        assert sorted(found) == sorted(each["id"] for each in wanted), (sorted(found), wanted)
        for each in wanted:
            share = math.dist(found[each["id"]]["position_m"], each["position_m"]) / each["diagonal_m"]
            worst, count = max(worst, share), count + 1
            if each["id"] in start:
                way = max(way, math.dist(each["position_m"], start[each["id"]]) / each["diagonal_m"])
    print(f"highlights: {count} in {FRAMES} frames, {worst:.2e} of the diagonal apart at most, gate {MOST_SHARE}")
    assert worst <= MOST_SHARE
    assert count > FRAMES and way > 0.05, "highlights hardly move: this would prove nothing"


def compare_lights(scene):
    text = pathlib.Path(scene).read_text()
    sun = Euler((0.7, 0.2, 0.4)).to_matrix() @ Vector((0, 0, 1))
    x, y, z = in_offing(sun)
    azimuth, elevation = math.degrees(math.atan2(x, -z)), math.degrees(math.asin(y))
    values = dict(line.split(" = ") for line in text.split('name = "Key"')[1].split("[[")[0].strip().splitlines())
    assert abs(float(values["azimuth_deg"]) - azimuth) < 1e-3 and abs(float(values["elevation_deg"]) - elevation) < 1e-3
    assert abs(float(values["illuminance_klx"]) - 3.0 * 0.683) < 1e-3, values  # 683 lm/W
    place = dict(line.split(" = ") for line in text.split('name = "Fill"')[1].split("[[")[0].strip().splitlines())
    found = [float(place[f"{axis}_m"]) for axis in "xyz"]
    assert math.dist(found, in_offing(Vector((-3, -4, 4)))) < 1e-5, found
    print(f"lights: from {azimuth:.2f}, {elevation:.2f} degrees and at {found}")


with tempfile.TemporaryDirectory() as name:
    here = pathlib.Path(name)
    mesh, shot = make_scene()
    bpy.ops.export_scene.gltf(filepath=str(here / "made.glb"), export_cameras=True, export_lights=True,
                              export_normals=False, export_texcoords=False)
    imported = here / "made.toml"
    print(peer.run(offing, "scene", "import", here / "made.glb", "-o", imported, "--fps", FPS))
    print(peer.run(offing, "scene", "check", imported))
    compare_lights(imported)
    compare_pixels(imported, here, shot)
    compare_highlights(imported, here, mesh)
