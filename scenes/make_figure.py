"""Makes figure.glb, the character of figure.toml: python3 scenes/make_figure.py scenes/figure.glb

A smooth body is the level set of a blend of round cones and ellipsoids. Surface nets (Gibson 1998) cut it into triangles, which
are then made even and put back on the surface. A skin of 17 joints moves it: it waves, sways and bobs in 4 s and begins again."""

import json
import math
import struct
import sys

CELL_M = 0.02          # of the grid, about the edge of a triangle
BLEND_PER_M = 38.0     # of parts into one another
SKIN_PER_M = 26.0      # of the joints of parts into one another
LOOP_S, KEYS_PER_S = 4.0, 24

# Metres, +y up, looking toward +z, the arms down and aside. Parts of a side are mirrored to the other one.
SHOULDER, WRIST = (0.185, 1.13, 0.0), (0.52, 0.79, 0.03)
HIP, KNEE, ANKLE = (0.115, 0.64, 0.0), (0.135, 0.38, 0.01), (0.152, 0.12, 0.0)


def mixed(a, b, t):
    return tuple(x + t * (y - x) for x, y in zip(a, b))


ELBOW = mixed(SHOULDER, WRIST, 0.5)


def cone(a, b, radius_a, radius_b):
    """Distance from two balls and the cone that touches both."""
    length = math.dist(a, b)
    axis = tuple((y - x) / length for x, y in zip(a, b))
    sine = (radius_a - radius_b) / length  # by which the cone's normal leans toward b
    cosine = math.sqrt(1.0 - sine * sine)

    def distance(x, y, z):
        px, py, pz = x - a[0], y - a[1], z - a[2]
        along = px * axis[0] + py * axis[1] + pz * axis[2]
        aside = math.sqrt(max(px * px + py * py + pz * pz - along * along, 0.0))
        foot = along - aside * sine / cosine
        if foot < 0.0:
            return math.hypot(along, aside) - radius_a
        if foot > length:
            return math.hypot(along - length, aside) - radius_b
        return along * sine + aside * cosine - radius_a

    return distance


def ellipsoid(middle, axes):
    """Nearly the distance near the surface."""
    def distance(x, y, z):
        px, py, pz = (x - middle[0]) / axes[0], (y - middle[1]) / axes[1], (z - middle[2]) / axes[2]
        k0 = math.sqrt(px * px + py * py + pz * pz)
        if k0 < 1e-9:
            return -min(axes)
        k1 = math.sqrt((px / axes[0]) ** 2 + (py / axes[1]) ** 2 + (pz / axes[2]) ** 2)
        return k0 * (k0 - 1.0) / k1

    return distance


def roll(middle, radius, depth, thickness):
    """A ring about +y, `depth` times as deep as it is wide."""
    def distance(x, y, z):
        return math.hypot(math.hypot(x - middle[0], (z - middle[2]) / depth) - radius, y - middle[1]) - thickness

    return distance


def mirrored(a):
    return -a[0], a[1], a[2]


def parts():
    """(part, distance): what a primitive belongs to, for the skin."""
    made = [("head", ellipsoid((0, 1.53, 0.0), (0.265, 0.275, 0.255))),
            ("head", ellipsoid((0, 1.44, 0.08), (0.20, 0.17, 0.19))),      # cheeks and chin
            ("head", ellipsoid((0, 1.50, 0.275), (0.045, 0.045, 0.055))),  # nose
            ("head", ellipsoid((0, 1.85, -0.03), (0.05, 0.055, 0.05))),    # a tuft
            ("neck", cone((0, 1.15, 0), (0, 1.34, 0), 0.075, 0.065)),
            ("neck", roll((0, 1.245, 0.01), 0.105, 1.0, 0.048)),           # a scarf
            ("torso", ellipsoid((0, 1.06, 0), (0.165, 0.15, 0.12))),
            ("torso", ellipsoid((0, 0.82, 0.03), (0.205, 0.21, 0.195)))]
    for name, side in (("left", lambda p: p), ("right", mirrored)):
        made += [("arm " + name, cone(side(SHOULDER), side(WRIST), 0.072, 0.05)),
                 ("arm " + name, cone(side(mixed(SHOULDER, WRIST, 0.88)), side(mixed(SHOULDER, WRIST, 0.93)), 0.068, 0.068)),
                 ("arm " + name, ellipsoid(side((0.56, 0.745, 0.035)), (0.068, 0.078, 0.058))),
                 ("arm " + name, cone(side((0.545, 0.77, 0.06)), side((0.555, 0.735, 0.115)), 0.028, 0.022)),  # thumb
                 ("leg " + name, cone(side(HIP), side(ANKLE), 0.1, 0.075)),
                 ("leg " + name, roll(side((0.15, 0.19, 0.0)), 0.072, 1.0, 0.028)),
                 ("leg " + name, ellipsoid(side((0.165, 0.075, 0.06)), (0.09, 0.075, 0.155))),
                 ("head", ellipsoid(side((0.275, 1.50, -0.01)), (0.05, 0.075, 0.05)))]  # ears
    return made


PARTS = parts()
FAR = 0.3  # m: primitives farther than the nearest by this make no difference


def blended(distances):
    least = min(distances)
    return least - math.log(sum(math.exp(BLEND_PER_M * (least - d)) for d in distances)) / BLEND_PER_M


def level(x, y, z, near=None):
    return blended([d(x, y, z) for d in near] if near else [d(x, y, z) for _, d in PARTS])


def near_primitives(p):
    distances = [(d(*p), d) for _, d in PARTS]
    least = min(each[0] for each in distances)
    return [d for distance, d in distances if distance < least + FAR]


def gradient(p, near):
    h = 1e-4
    x, y, z = p
    return ((level(x + h, y, z, near) - level(x - h, y, z, near)) / (2 * h),
            (level(x, y + h, z, near) - level(x, y - h, z, near)) / (2 * h),
            (level(x, y, z + h, near) - level(x, y, z - h, near)) / (2 * h))


def on_surface(p, near):
    for _ in range(3):
        value, slope = level(*p, near), gradient(p, near)
        share = value / sum(s * s for s in slope)
        p = tuple(a - share * s for a, s in zip(p, slope))
    return p


def corner_values():
    """The level at corners of the grid, in blocks that the surface may pass."""
    low, cells, block = (-0.72, -0.06, -0.36), (72, 104, 40), 4
    values = {}
    for bi in range(0, cells[0], block):
        for bj in range(0, cells[1], block):
            for bk in range(0, cells[2], block):
                middle = [low[axis] + (b + block / 2) * CELL_M for axis, b in enumerate((bi, bj, bk))]
                if abs(level(*middle)) > 1.3 * block * CELL_M:
                    continue
                for i in range(bi, bi + block + 1):
                    for j in range(bj, bj + block + 1):
                        for k in range(bk, bk + block + 1):
                            if (i, j, k) not in values:
                                values[i, j, k] = level(low[0] + i * CELL_M, low[1] + j * CELL_M, low[2] + k * CELL_M)
    return low, values


def surface_net():
    low, values = corner_values()
    cube = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    edges = [(a, b) for a in cube for b in cube if a < b and sum(abs(x - y) for x, y in zip(a, b)) == 1]
    number, places = {}, []
    for cell in sorted(values):
        corners = {c: values.get((cell[0] + c[0], cell[1] + c[1], cell[2] + c[2])) for c in cube}
        if None in corners.values() or len({v < 0 for v in corners.values()}) == 1:
            continue
        crossings = [mixed(a, b, corners[a] / (corners[a] - corners[b])) for a, b in edges
                     if (corners[a] < 0) != (corners[b] < 0)]
        middle = [sum(c[axis] for c in crossings) / len(crossings) for axis in range(3)]
        number[cell] = len(places)
        places.append(tuple(low[axis] + (cell[axis] + middle[axis]) * CELL_M for axis in range(3)))
    quads = []
    for corner in sorted(values):
        for axis in range(3):
            end = tuple(c + (a == axis) for a, c in enumerate(corner))
            if end not in values or (values[corner] < 0) == (values[end] < 0):
                continue
            u, w = (axis + 1) % 3, (axis + 2) % 3

            def cell(du, dw):
                at = list(corner)
                at[u] -= du
                at[w] -= dw
                return number[tuple(at)]

            quad = [cell(0, 0), cell(1, 0), cell(1, 1), cell(0, 1)]
            quads.append(quad if values[corner] < 0 else quad[::-1])
    return places, quads


def evened(places, quads):
    """Places in the middles of their neighbours, on the surface."""
    around = [set() for _ in places]
    for quad in quads:
        for i in range(4):
            around[quad[i]].add(quad[(i + 1) % 4])
            around[quad[i]].add(quad[(i + 3) % 4])
    near = [near_primitives(p) for p in places]
    for _ in range(12):
        middles = [tuple(sum(places[o][axis] for o in others) / len(others) for axis in range(3)) for others in around]
        places = [on_surface(mixed(p, m, 0.6), n) for p, m, n in zip(places, middles, near)]
    normals = []
    for p, n in zip(places, near):
        slope = gradient(p, n)
        length = math.sqrt(sum(s * s for s in slope))
        normals.append(tuple(s / length for s in slope))
    return places, normals


def triangles(places, quads):
    made = []
    for a, b, c, d in quads:
        if math.dist(places[a], places[c]) <= math.dist(places[b], places[d]):
            made += [(a, b, c), (a, c, d)]
        else:
            made += [(a, b, d), (b, c, d)]
    return made


# name: (parent, place)
JOINTS = {"hips": (None, (0, 0.66, 0)), "spine": ("hips", (0, 0.80, 0)), "chest": ("spine", (0, 0.98, 0)),
          "neck": ("chest", (0, 1.20, 0)), "head": ("neck", (0, 1.33, 0))}
for _name, _side in (("left", lambda p: p), ("right", mirrored)):
    JOINTS.update({"arm " + _name: ("chest", _side(SHOULDER)), "forearm " + _name: ("arm " + _name, _side(ELBOW)),
                   "hand " + _name: ("forearm " + _name, _side(WRIST)), "leg " + _name: ("hips", _side(HIP)),
                   "shin " + _name: ("leg " + _name, _side(KNEE)), "foot " + _name: ("shin " + _name, _side(ANKLE))})
NAMES = list(JOINTS)


def step(low, high, x):
    t = min(max((x - low) / (high - low), 0.0), 1.0)
    return t * t * (3 - 2 * t)


def chain(shares, names):
    """Weights of joints one after the other; `shares` says how far beyond each of the later ones a place is."""
    weights, rest = {}, 1.0
    for name, share in reversed(list(zip(names[1:], shares))):
        weights[name] = rest * share
        rest *= 1.0 - share
    weights[names[0]] = rest
    return weights


def joint_weights(p):
    """The four joints that move a place most, by name."""
    distances = {}
    for part, d in PARTS:
        distances.setdefault(part, []).append(d(*p))
    nearest = {part: blended(each) for part, each in distances.items()}
    least = min(nearest.values())
    shares = {part: math.exp(SKIN_PER_M * (least - d)) for part, d in nearest.items()}
    total, weights = sum(shares.values()), {}
    for part, share in shares.items():
        if part == "head":
            own = {"head": 1.0}
        elif part == "neck":
            own = chain([step(1.12, 1.28, p[1]), step(1.26, 1.40, p[1])], ["chest", "neck", "head"])
        elif part == "torso":
            own = chain([step(0.70, 0.90, p[1]), step(0.86, 1.10, p[1])], ["hips", "spine", "chest"])
        else:
            kind, side = part.split()
            mirror = mirrored if side == "right" else tuple
            x, y, z = mirror(p)
            if kind == "arm":
                way = [b - a for a, b in zip(SHOULDER, WRIST)]
                t = sum((q - a) * w for q, a, w in zip((x, y, z), SHOULDER, way)) / sum(w * w for w in way)
                own = chain([step(-0.15, 0.22, t), step(0.32, 0.68, t), step(0.85, 1.08, t)],
                            ["chest", "arm " + side, "forearm " + side, "hand " + side])
            else:
                own = chain([step(0.74, 0.52, y), step(0.48, 0.28, y), step(0.17, 0.09, y)],
                            ["hips", "leg " + side, "shin " + side, "foot " + side])
        for name, weight in own.items():
            weights[name] = weights.get(name, 0.0) + weight * share / total
    kept = sorted(weights.items(), key=lambda each: -each[1])[:4]
    total = sum(weight for _, weight in kept)
    return [(name, weight / total) for name, weight in kept]


def turn(axis, degrees):
    half = math.radians(degrees) / 2
    return (*(math.sin(half) * a for a in axis), math.cos(half))


def product(a, b):
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
            aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)


X, Y, Z = (1, 0, 0), (0, 1, 0), (0, 0, 1)


def pose(time_s):
    """Where the hips are, and the turn of each joint, x, y, z, w."""
    phase = 2 * math.pi * time_s / LOOP_S
    sway, bob, wave = math.sin(phase), 0.5 - 0.5 * math.cos(2 * phase), math.sin(3 * phase)
    knee = 4 + 16 * bob
    # Hips come down as far as bent knees ask, so that the feet stay.
    drop = sum(length * (1 - math.cos(math.radians(angle))) for length, angle in
               ((math.dist(HIP, KNEE), knee), (math.dist(KNEE, ANKLE), knee)))
    turns = {"hips": turn(Y, 0), "spine": product(turn(Z, 6 * sway), turn(Y, 8 * sway)),
             "chest": product(turn(Z, 5 * sway), turn(Y, 10 * sway)),
             "neck": turn(Z, -5 * sway), "head": product(turn(Z, -9 * sway), product(turn(Y, -16 * sway), turn(X, 5 * bob - 4))),
             "arm left": product(turn(Z, 76 + 6 * wave), turn(Y, -14)), "forearm left": turn(Z, 24 + 20 * wave),
             "hand left": turn(Z, 10 * math.sin(3 * phase - 0.7)),
             "arm right": product(turn(X, -14 * sway), turn(Z, -14 - 6 * bob)), "forearm right": turn(X, -26 - 12 * sway),
             "hand right": turn(X, -8)}
    for side in ("left", "right"):
        turns.update({"leg " + side: turn(X, -knee), "shin " + side: turn(X, 2 * knee), "foot " + side: turn(X, -knee)})
    return (0, JOINTS["hips"][1][1] - drop, 0), turns


class Buffer:
    def __init__(self):
        self.bytes, self.views, self.accessors = b"", [], []

    def add(self, form, rows, **more):
        """Rows of numbers of one `struct` letter: their accessor."""
        types = {1: "SCALAR", 3: "VEC3", 4: "VEC4", 16: "MAT4"}
        kinds = {"f": 5126, "H": 5123, "B": 5121}
        self.bytes += b"\0" * (-len(self.bytes) % 4)
        packed = b"".join(struct.pack(f"<{len(row)}{form}", *row) for row in rows)
        self.views.append({"buffer": 0, "byteOffset": len(self.bytes), "byteLength": len(packed)})
        self.bytes += packed
        self.accessors.append({"bufferView": len(self.views) - 1, "componentType": kinds[form], "count": len(rows),
                               "type": types[len(rows[0])], **more})
        return len(self.accessors) - 1

    def add_bounded(self, rows):
        rows = [struct.unpack(f"<{len(row)}f", struct.pack(f"<{len(row)}f", *row)) for row in rows]
        return self.add("f", rows, min=[min(column) for column in zip(*rows)], max=[max(column) for column in zip(*rows)])


def document(places, normals, faces):
    buffer, indices, weights = Buffer(), [], []
    for p in places:
        own = joint_weights(p) + [(NAMES[0], 0.0)] * 4
        numbers = [round(65535 * weight) for _, weight in own[:4]]
        numbers[0] += 65535 - sum(numbers)
        indices.append([NAMES.index(name) for name, _ in own[:4]])
        weights.append(numbers)
    attributes = {"POSITION": buffer.add_bounded(places), "NORMAL": buffer.add("f", normals),
                  "JOINTS_0": buffer.add("B", indices), "WEIGHTS_0": buffer.add("H", weights, normalized=True)}
    corners = buffer.add("H", [(corner,) for face in faces for corner in face])
    rest = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, *(-x for x in JOINTS[name][1]), 1) for name in NAMES]
    inverse = buffer.add("f", rest)
    nodes = [{"name": "figure", "mesh": 0, "skin": 0}]
    for name in NAMES:
        parent, place = JOINTS[name]
        from_parent = [a - b for a, b in zip(place, JOINTS[parent][1])] if parent else list(place)
        node = {"name": name, "translation": from_parent}
        children = [1 + NAMES.index(other) for other in NAMES if JOINTS[other][0] == name]
        nodes.append({**node, "children": children} if children else node)
    times_s = [i / KEYS_PER_S for i in range(round(LOOP_S * KEYS_PER_S) + 1)]
    poses = [pose(time_s) for time_s in times_s]
    keys = buffer.add_bounded([(time_s,) for time_s in times_s])
    moved = [(1, "translation", buffer.add("f", [hips for hips, _ in poses]))]
    moved += [(1 + i, "rotation", buffer.add("f", [turns[name] for _, turns in poses])) for i, name in enumerate(NAMES)]
    return {"asset": {"version": "2.0", "generator": "make_figure.py of Offing"}, "scene": 0,
            "scenes": [{"nodes": [0, 1]}], "nodes": nodes,
            "meshes": [{"name": "figure", "primitives": [{"attributes": attributes, "indices": corners}]}],
            "skins": [{"joints": list(range(1, 1 + len(NAMES))), "inverseBindMatrices": inverse, "skeleton": 1}],
            "animations": [{"name": "wave",
                            "channels": [{"sampler": i, "target": {"node": node, "path": path}}
                                         for i, (node, path, _) in enumerate(moved)],
                            "samplers": [{"input": keys, "output": values} for _, _, values in moved]}],
            "bufferViews": buffer.views, "accessors": buffer.accessors,
            "buffers": [{"byteLength": len(buffer.bytes)}]}, buffer.bytes


def write(file):
    places, quads = surface_net()
    places, normals = evened(places, quads)
    faces = triangles(places, quads)
    json_part, binary = document(places, normals, faces)
    text = json.dumps(json_part, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    binary += b"\0" * (-len(binary) % 4)
    with open(file, "wb") as output:
        output.write(struct.pack("<4sIIII", b"glTF", 2, 28 + len(text) + len(binary), len(text), 0x4E4F534A))
        output.write(text + struct.pack("<II", len(binary), 0x004E4942) + binary)
    print(f"{file}: {len(places)} vertices, {len(faces)} faces")


if __name__ == "__main__":
    write(sys.argv[1])
