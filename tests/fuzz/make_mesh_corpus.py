"""Writes the meshes that the fuzzers of mesh readers start from into tests/fuzz/corpus: a pyramid in all kinds of each
format. Usage: make_mesh_corpus.py FOLDER"""

import base64
import json
import pathlib
import struct
import sys

POINTS = [(0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1), (0.5, 0.75, 0.5)]
FACES = [(0, 1, 2, 3), (0, 4, 1), (1, 4, 2), (2, 4, 3), (3, 4, 0)]
TRIANGLES = [(0, 1, 2), (0, 2, 3), *FACES[1:]]


def obj():
    vertices = "".join(f"v {x} {y} {z}\n" for x, y, z in POINTS)
    plain = vertices + "".join("f " + " ".join(str(i + 1) for i in face) + "\n" for face in FACES)
    rich = "# a pyramid\no one\ng base\nmtllib none.mtl\nusemtl stone\n" + vertices.replace("0.5\n", "0.5 1 0 0\n")
    rich += "vt 0 0\nvt 1 1\nvn 0 -1 0\nvn 0 1 0\ns off\n"
    rich += "f 1/1/1 2/1/1 \\\n 3/2/1 4/2/1\nf -5//2 -1//2 -4//2\nl 1 2\np 5\nf 1 2\nf 7 6 8\nv 2 0 0\nv 2 1 0\nv 2 0 1\n"
    return {"plain": plain, "rich": rich}


def off():
    points = "".join(f"{x} {y} {z}\n" for x, y, z in POINTS)
    faces = "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in FACES)
    normals = "".join(f"{x} {y} {z} 0 1 0 255 0 0 255\n" for x, y, z in POINTS)
    return {
        "plain": f"OFF\n5 5 8\n{points}{faces}",
        "bare": f"5 5 0\n{points}{faces}",
        "coloured": f"CNOFF 5 5 0 # counts\n{normals}" + faces.replace("\n", " 0.5 0.5 0.5\n"),
    }


def ply():
    def header(encoding, number="float", count="uchar", index="int", extra=""):
        return (
            f"ply\nformat {encoding} 1.0\ncomment a pyramid\nelement vertex 5\nproperty {number} x\n"
            f"property {number} y\nproperty {number} z\n{extra}element face 5\n"
            f"property list {count} {index} vertex_indices\nend_header\n"
        )

    def body(order, number, count, index):
        data = b"".join(struct.pack(order + 3 * number, *point) for point in POINTS)
        return data + b"".join(struct.pack(f"{order}{count}{len(f)}{index}", len(f), *f) for f in FACES)

    more = "property float nx\nproperty float ny\nproperty float nz\nproperty list uchar short rings\n"
    text = header("ascii", extra=more) + "".join(f"{x} {y} {z} 0 1 0 2 7 8\n" for x, y, z in POINTS)
    text += "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in FACES)
    strips = (
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\nproperty double z\n"
        "element edge 1\nproperty int vertex1\nproperty int vertex2\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n"
        + "".join(f"{x} {y} {z}\n" for x, y, z in POINTS) + "0 1\n8\n0 1 2 3 -1 0 4 1\n"
    )
    return {
        "text": text,
        "little": header("binary_little_endian").encode() + body("<", "f", "B", "i"),
        "big": header("binary_big_endian", "double", "int", "ushort").encode() + body(">", "d", "i", "H"),
        "strips": strips,
    }


def stl():
    facets = [[POINTS[i] for i in triangle] for triangle in TRIANGLES]
    text = "solid pyramid\n"
    for facet in facets:
        corners = "".join(f"vertex {x} {y} {z}\n" for x, y, z in facet)
        text += f"facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n"
    binary = b"solid in name".ljust(80) + struct.pack("<I", len(facets))
    for facet in facets:
        binary += struct.pack("<12fH", 0, 0, 1, *(x for point in facet for x in point), 0)
    return {"text": text + "endsolid pyramid\n", "binary": binary}


def glb(document, data):
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def gltf():
    positions = b"".join(struct.pack("<3f", *point) for point in POINTS)
    indices = b"".join(struct.pack("<3H", *triangle) for triangle in TRIANGLES)
    data = positions + indices
    document = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"children": [1, 2]}, {"mesh": 0, "translation": [1, 2, 3], "scale": [1, -1, 1]},
                  {"mesh": 0, "rotation": [0, 0.6, 0, 0.8]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1},
                                   {"attributes": {"POSITION": 0, "NORMAL": 0}, "mode": 5},
                                   {"attributes": {"POSITION": 0}, "mode": 6}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": len(TRIANGLES) * 3, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions), "byteStride": 12},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": len(indices)}],
        "buffers": [{"byteLength": len(data)}],
    }
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    embedded = dict(document, buffers=[{"byteLength": len(data), "uri": uri}])
    return {"embedded": json.dumps(embedded), "binary": glb(document, data), "moving": moving_gltf()}


def moving_gltf():
    """A pyramid with a sparse morph and a skin; one animation of each kind moves joint and weight."""
    parts = [
        ("VEC3", 5126, b"".join(struct.pack("<3f", *point) for point in POINTS), 5),
        ("SCALAR", 5123, b"".join(struct.pack("<3H", *each) for each in TRIANGLES) + bytes(2), len(TRIANGLES) * 3),
        ("VEC4", 5121, bytes((0, 1, 0, 0)) * 5, 5),
        ("VEC4", 5126, struct.pack("<4f", 0.5, 0.5, 0, 0) * 5, 5),
        ("MAT4", 5126, struct.pack("<16f", 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1) * 2, 2),
        ("SCALAR", 5126, struct.pack("<2f", 0, 1), 2),
        ("VEC3", 5126, struct.pack("<6f", 0, 0, 0, 1, 2, 3), 2),
        ("VEC4", 5126, struct.pack("<8f", 0, 0, 0, 1, 0, 0.6, 0, 0.8), 2),
        ("SCALAR", 5126, struct.pack("<6f", 0, 0, 1, 0, 1, 0), 6),
        ("SCALAR", 5121, bytes((4, 0, 0, 0)), 1),
        ("VEC3", 5126, struct.pack("<3f", 0, 1, 0), 1),
    ]
    data, views, accessors = b"", [], []
    for index, (kind, component, content, count) in enumerate(parts):
        views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(content)})
        accessors.append({"bufferView": index, "componentType": component, "count": count, "type": kind})
        data += content
    sparse = {"count": 1, "indices": {"bufferView": 9, "componentType": 5121}, "values": {"bufferView": 10}}
    accessors[9:] = [{"componentType": 5126, "count": 5, "type": "VEC3", "sparse": sparse}]
    moves = [(1, "translation", 6, "LINEAR"), (2, "rotation", 7, "STEP"), (0, "weights", 8, "CUBICSPLINE")]
    document = {
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0, "skin": 0}, {"children": [2]}, {}],
        "skins": [{"joints": [1, 2], "inverseBindMatrices": 4}],
        "meshes": [{"weights": [0.5], "primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 2, "WEIGHTS_0": 3},
                                                      "indices": 1, "targets": [{"POSITION": 9}]}]}],
        "animations": [{"samplers": [{"input": 5, "output": output, "interpolation": kind}],
                        "channels": [{"sampler": 0, "target": {"node": node, "path": path}}]}
                       for node, path, output, kind in moves],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(data)}],
    }
    return glb(document, data)


def gltf_stage():
    """A camera below a node that turns, a parallel one, and a light of each type."""
    data = struct.pack("<2f", 0, 1) + struct.pack("<8f", 0, 0, 0, 1, 0, 0.6, 0, 0.8)
    lights = [{"type": "directional", "intensity": 800, "color": [1, 0.5, 0.25], "name": "sky"},
              {"type": "point", "intensity": 90, "range": 20},
              {"type": "spot", "spot": {"outerConeAngle": 0.5}}]
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0, 2, 3, 4, 5]}],
        "nodes": [{"children": [1], "translation": [0, 2, 0]}, {"camera": 0, "translation": [0, 0, 5], "name": "shot"},
                  {"camera": 1}, *({"extensions": {"KHR_lights_punctual": {"light": i}}} for i in range(3))],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}},
                    {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 9}}],
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": lights}},
        "materials": [{}],
        "animations": [{"name": "pan", "samplers": [{"input": 0, "output": 1}],
                        "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR"},
                      {"bufferView": 1, "componentType": 5126, "count": 2, "type": "VEC4"}],
        "bufferViews": [{"buffer": 0, "byteLength": 8}, {"buffer": 0, "byteOffset": 8, "byteLength": 32}],
        "buffers": [{"byteLength": len(data)}],
    }
    return {"stage": glb(document, data)}


def main():
    for make in (obj, off, ply, stl, gltf, gltf_stage):
        folder = pathlib.Path(sys.argv[1]) / make.__name__
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in make().items():
            (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())


if __name__ == "__main__":
    main()
