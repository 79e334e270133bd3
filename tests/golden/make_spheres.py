#!/usr/bin/env python3
"""Writes spheres.gltf, a grid of glTF 2.0 metallic-roughness materials: python3 tests/golden/make_spheres.py

One copper sphere per material. Roughness grows from left to right, metallic from bottom to top. In the row below them
materials without either factor, which makes both 1, alternate with unlit ones.
"""

import base64
import json
import math
import os
import struct

ROUGHNESS = [0.1, 0.3, 0.5, 0.7, 1.0]
METALLIC = [0.0, 0.5, 1.0]
COPPER = [0.93, 0.45, 0.28, 1]
RINGS, SECTORS = 16, 24

points, indices = [], []
for ring in range(RINGS + 1):
    polar = math.pi * ring / RINGS
    for sector in range(SECTORS + 1):
        turn = 2 * math.pi * sector / SECTORS
        points.append([math.sin(polar) * math.sin(turn), math.cos(polar), math.sin(polar) * math.cos(turn)])
for ring in range(RINGS):
    for sector in range(SECTORS):
        a = ring * (SECTORS + 1) + sector
        b = a + SECTORS + 1
        if ring > 0:
            indices += [a, b, a + 1]
        if ring + 1 < RINGS:
            indices += [a + 1, b, b + 1]

vertices = b"".join(struct.pack("<3f", *point) for point in points)
data = vertices + struct.pack(f"<{len(indices)}H", *indices)

materials, meshes, nodes = [], [], []


def sphere(column, row, name, factors, extensions=None):
    material = {"name": name, "pbrMetallicRoughness": {"baseColorFactor": COPPER, **factors}}
    if extensions:
        material["extensions"] = extensions
    materials.append(material)
    primitive = {"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1, "material": len(materials) - 1}
    meshes.append({"primitives": [primitive]})
    nodes.append({"name": name, "mesh": len(meshes) - 1, "translation": [2.3 * column, 2.3 * row, 0]})


for row, metallic in enumerate(METALLIC):
    for column, roughness in enumerate(ROUGHNESS):
        factors = {"metallicFactor": metallic, "roughnessFactor": roughness}
        sphere(column, row, f"metallic {metallic}, roughness {roughness}", factors)
for column in range(5):
    if column % 2 == 0:
        sphere(column, -1, "both left out", {})
    else:
        sphere(column, -1, "unlit", {}, {"KHR_materials_unlit": {}})

document = {
    "asset": {"version": "2.0", "generator": "make_spheres.py"},
    "extensionsUsed": ["KHR_materials_unlit"],
    "scene": 0,
    "scenes": [{"nodes": list(range(len(nodes)))}],
    "nodes": nodes,
    "meshes": meshes,
    "materials": materials,
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3", "min": [-1, -1, -1], "max": [1, 1, 1]},
        {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"},
    ],
    "bufferViews": [
        {"buffer": 0, "byteOffset": 0, "byteLength": len(vertices), "target": 34962},
        {"buffer": 0, "byteOffset": len(vertices), "byteLength": len(data) - len(vertices), "target": 34963},
    ],
    "buffers": [
        {
            "byteLength": len(data),
            "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode(),
        }
    ],
}

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "spheres.gltf"), "w") as file:
    json.dump(document, file, indent=1)
    file.write("\n")
