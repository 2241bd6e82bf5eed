"""Blender's importer takes the highlights of a scene: every node becomes an object, every material a material, and a
hull is where its body floats. Fails if the importer stops, as it does at an unlit material without a name."""

import json
import pathlib
import struct
import tempfile

import peer

offing, scenes = peer.enter("bpy")

import bpy  # noqa: E402


def document(file):
    """The JSON of a .glb: behind its header of 12 bytes and that of its first chunk."""
    content = file.read_bytes()
    (length,) = struct.unpack_from("<I", content, 12)
    return json.loads(content[20 : 20 + length])


def imported(scene, frames):
    """The document of the scene's highlights, once Blender has all of its nodes and materials."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "highlights.glb"
        peer.run(offing, "highlights", scenes / scene, "-o", file, "--frames", frames, "--quiet")
        written = document(file)
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.import_scene.gltf(filepath=str(file))
    objects, materials = len(bpy.data.objects), [each.name for each in bpy.data.materials]
    nodes, names = len(written["nodes"]), [each["name"] for each in written["materials"]]
    print(f"{scene}: {objects} of {nodes} objects, {len(materials)} of {len(names)} materials")
    assert objects == nodes and sorted(materials) == sorted(names)
    return written


assert len(imported("knot.toml", "0:11")["materials"]) > 5
hull = next(node for node in imported("afloat.toml", "24:35")["nodes"] if node["name"] == "hull")
x, y, z = hull["translation"]
# Blender's z points up; before its first key an object is at that.
place = bpy.data.objects["hull"].matrix_world.translation
assert max(abs(place.x - x), abs(place.y + z), abs(place.z - y)) < 1e-4, (place, hull["translation"])
assert x > 3.0, "the coaster is not under way"
