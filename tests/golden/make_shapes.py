#!/usr/bin/env python3
"""Writes shapes.gltf, a small glTF 2.0 file that embeds its buffer: python3 tests/golden/make_shapes.py

A pyramid with one colour per face (COLOR_0) and an octahedron without colours, both flat-shaded. Nested nodes place them
with rotations, uneven scales and mirrors.
"""

import base64
import json
import os
import struct


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def flat(triangles):
    """Positions and normals, three vertices a triangle."""
    positions, normals = [], []
    for a, b, c in triangles:
        n = cross([q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)])
        length = sum(x * x for x in n) ** 0.5
        positions += [a, b, c]
        normals += [[x / length for x in n]] * 3
    return positions, normals


APEX = (0, 1, 0)
BASE = [(-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1)]
PYRAMID = [(BASE[i], BASE[(i + 1) % 4], APEX) for i in range(4)] + [(BASE[0], BASE[2], BASE[1]), (BASE[0], BASE[3], BASE[2])]
FACE_COLORS = [(1, 0.2, 0.1, 1), (0.2, 0.9, 0.2, 1), (0.2, 0.3, 1, 1), (1, 0.9, 0.2, 1), (1, 1, 1, 1), (1, 1, 1, 1)]
RING = [(1, 0, 0), (0, 0, -1), (-1, 0, 0), (0, 0, 1)]
OCTAHEDRON = [(RING[i], RING[(i + 1) % 4], (0, 1, 0)) for i in range(4)] + [
    (RING[(i + 1) % 4], RING[i], (0, -1, 0)) for i in range(4)
]

data, views, accessors = b"", [], []


def add(rows, kind):
    global data
    packed = b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)
    views.append({"buffer": 0, "byteOffset": len(data), "byteLength": len(packed), "target": 34962})
    accessors.append({"bufferView": len(views) - 1, "componentType": 5126, "count": len(rows), "type": kind})
    if kind == "VEC3":
        accessors[-1]["min"] = [min(c) for c in zip(*rows)]
        accessors[-1]["max"] = [max(c) for c in zip(*rows)]
    data += packed
    return len(accessors) - 1


def primitive(triangles, material, colors=None):
    positions, normals = flat(triangles)
    attributes = {"POSITION": add(positions, "VEC3"), "NORMAL": add(normals, "VEC3")}
    if colors:
        attributes["COLOR_0"] = add([c for c in colors for _ in range(3)], "VEC4")
    return {"attributes": attributes, "material": material}


meshes = [
    {"name": "pyramid", "primitives": [primitive(PYRAMID, 0, FACE_COLORS)]},
    {"name": "octahedron", "primitives": [primitive(OCTAHEDRON, 1)]},
]
document = {
    "asset": {"version": "2.0", "generator": "make_shapes.py"},
    "scene": 0,
    "scenes": [{"nodes": [0, 2, 3]}],
    "nodes": [
        {"name": "left", "mesh": 0, "translation": [-1.6, -0.6, 0], "rotation": [0, 0.2588190451, 0, 0.9659258263], "children": [1]},
        {"name": "on top", "mesh": 1, "translation": [0, 1.5, 0], "scale": [0.4, 0.7, 0.4]},
        {"name": "right", "mesh": 1, "translation": [1.5, 0.1, 0], "rotation": [0.1305261922, 0.2, 0, 0.9709], "scale": [1, 1.2, 1]},
        {"name": "mirrored", "mesh": 0, "translation": [0.2, -0.9, 1.4], "scale": [-0.6, 0.6, 0.6]},
    ],
    "meshes": meshes,
    "materials": [
        {"name": "painted", "pbrMetallicRoughness": {"baseColorFactor": [0.9, 0.9, 0.9, 1], "metallicFactor": 0, "roughnessFactor": 0.6}},
        {"name": "copper", "pbrMetallicRoughness": {"baseColorFactor": [0.75, 0.35, 0.15, 1], "metallicFactor": 1, "roughnessFactor": 0.4}},
    ],
    "accessors": accessors,
    "bufferViews": views,
    "buffers": [
        {
            "byteLength": len(data),
            "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
        }
    ],
}

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "shapes.gltf"), "w") as file:
    json.dump(document, file, indent=1)
    file.write("\n")
