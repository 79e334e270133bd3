"""What make_assets.py makes models with: glTF documents, their buffers, simple shapes and PNG pictures."""


import json
import math
import os
import struct
import zlib

FOLDER = os.path.dirname(os.path.abspath(__file__))
FLOAT, UBYTE, USHORT = 5126, 5121, 5123
CODES = {FLOAT: "f", UBYTE: "B", USHORT: "H"}


def png(width, height, pixel):
    """A picture whose pixels are pixel(x, y): bytes of RGB or RGBA."""
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))
    color_type = 6 if len(pixel(0, 0)) == 4 else 2

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, color_type, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


class Model:
    """A glTF document and its one buffer."""

    def __init__(self):
        self.data = b""
        self.root = {"asset": {"version": "2.0", "generator": "make_assets.py", "copyright": "CC0"}, "scene": 0}
        for key in ("nodes", "meshes", "materials", "accessors", "bufferViews"):
            self.root[key] = []

    def append(self, key, item):
        self.root[key].append(item)
        return len(self.root[key]) - 1

    def view(self, data):
        offset = len(self.data)
        self.data += data + b"\0" * (-len(data) % 4)
        return self.append("bufferViews", {"buffer": 0, "byteOffset": offset, "byteLength": len(data)})

    def accessor(self, rows, kind, component=FLOAT, **more):
        packed = b"".join(struct.pack(f"<{len(row)}{CODES[component]}", *row) for row in rows)
        item = {"bufferView": self.view(packed), "componentType": component, "count": len(rows), "type": kind, **more}
        if kind == "VEC3" or kind == "SCALAR" and component == FLOAT:
            floats = [struct.unpack(f"<{len(row)}f", struct.pack(f"<{len(row)}f", *row)) for row in rows]
            item["min"], item["max"] = [min(c) for c in zip(*floats)], [max(c) for c in zip(*floats)]
        return self.append("accessors", item)

    def mesh(self, name, shape, material, mode=4):
        primitive = {"attributes": {"POSITION": self.accessor(shape["positions"], "VEC3")}, "material": material}
        for key, attribute, kind in (("normals", "NORMAL", "VEC3"), ("uvs", "TEXCOORD_0", "VEC2")):
            if key in shape:
                primitive["attributes"][attribute] = self.accessor(shape[key], kind)
        for key, attribute, kind in (("tangents", "TANGENT", "VEC4"), ("uvs1", "TEXCOORD_1", "VEC2")):
            if key in shape:
                primitive["attributes"][attribute] = self.accessor(shape[key], kind)
        if "colors" in shape:
            primitive["attributes"]["COLOR_0"] = self.accessor(shape["colors"], "VEC4", UBYTE, normalized=True)
        if "indices" in shape:
            component = UBYTE if len(shape["positions"]) < 255 else USHORT
            primitive["indices"] = self.accessor([(i,) for i in shape["indices"]], "SCALAR", component)
        if mode != 4:
            primitive["mode"] = mode
        return self.append("meshes", {"name": name, "primitives": [primitive]})

    def material(self, name, color=(1, 1, 1, 1), metallic=0.0, roughness=0.8, texture=None, **more):
        factors = {"baseColorFactor": list(color), "metallicFactor": metallic, "roughnessFactor": roughness}
        if texture is not None:
            factors["baseColorTexture"] = texture
        return self.append("materials", {"name": name, "pbrMetallicRoughness": factors, **more})

    def write_glb(self, name):
        self.root["buffers"] = [{"byteLength": len(self.data)}]
        text = json.dumps(self.root, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        with open(os.path.join(FOLDER, name), "wb") as file:
            file.write(struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(self.data)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(self.data), b"BIN\0") + self.data)

    def node(self, name, mesh=None, **more):
        return self.append("nodes", {"name": name, **({} if mesh is None else {"mesh": mesh}), **more})

    def animation(self, name, *tracks):
        """Tracks are (node, path, interpolation, times, values, kind)."""
        made = {"name": name, "samplers": [], "channels": []}
        for node, path, mode, times, values, kind in tracks:
            sampler = {"input": self.accessor([(t,) for t in times], "SCALAR"), "interpolation": mode}
            sampler["output"] = self.accessor(values, kind)
            made["channels"].append({"sampler": len(made["samplers"]), "target": {"node": node, "path": path}})
            made["samplers"].append(sampler)
        return made


def unit(v):
    length = math.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def grid(columns, rows, at):
    """A surface at(u, v) over [0, 1] x [0, 1], its normals by differences."""
    step = 1e-4
    shape = {"positions": [], "normals": [], "uvs": [], "indices": []}
    for j in range(rows + 1):
        for i in range(columns + 1):
            u, v = i / columns, j / rows
            p = at(u, v)
            du = [b - a for a, b in zip(at(u - step, v), at(u + step, v))]
            dv = [b - a for a, b in zip(at(u, v - step), at(u, v + step))]
            shape["positions"].append(p)
            normal = [du[1] * dv[2] - du[2] * dv[1], du[2] * dv[0] - du[0] * dv[2], du[0] * dv[1] - du[1] * dv[0]]
            shape["normals"].append(unit(normal) if any(abs(x) > 1e-12 for x in normal) else unit(p))
            shape["uvs"].append((u, v))
    for j in range(rows):
        for i in range(columns):
            a = j * (columns + 1) + i
            c = a + columns + 1
            shape["indices"] += [a, a + 1, c + 1, a, c + 1, c]
    return shape


def tube(low, high, bottom, top, sides=10):
    """The side of a cone's frustum about y."""

    def at(u, v):
        angle = -2 * math.pi * u
        radius = bottom + (top - bottom) * v
        return [radius * math.cos(angle), low + (high - low) * v, radius * math.sin(angle)]

    return grid(sides, 1, at)


def sphere(radius):
    def at(u, v):
        angle, height = -2 * math.pi * u, math.pi * (v - 0.5)
        return [radius * math.cos(height) * math.cos(angle), radius * math.sin(height), radius * math.cos(height) * math.sin(angle)]

    return grid(16, 8, at)


def box(x, y, z):
    """Half sides, about the origin."""
    shape = {"positions": [], "normals": [], "uvs": [], "indices": []}
    for axis in range(3):
        for sign in (1, -1):
            first = len(shape["positions"])
            a, b = (axis + 1) % 3, (axis + 2) % 3
            for s, t in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                p, n = [0, 0, 0], [0, 0, 0]
                p[axis], n[axis] = sign, sign
                p[a], p[b] = s * sign, t
                shape["positions"].append([p[0] * x, p[1] * y, p[2] * z])
                shape["normals"].append(n)
                shape["uvs"].append(((s + 1) / 2, (t + 1) / 2))
            shape["indices"] += [first + i for i in (0, 1, 2, 0, 2, 3)]
    return shape


def turn(degrees):
    """A rotation about y."""
    half = math.radians(degrees) / 2
    return [0, math.sin(half), 0, math.cos(half)]
