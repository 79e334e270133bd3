#!/usr/bin/env python3
"""Writes the models of this folder: python3 tests/assets/make_assets.py

garden.glb: 54 nodes, nested, one mirrored; opaque, masked and blended materials; two PNG pictures inside; a camera.
materials.glb: every texture of a material, read in every way that the importer knows; a camera.
shield.glb: five textures of one size, which are read as three.
machine.glb: animations of every path and interpolation, a skin of six joints, morph targets, a camera that moves.
survey.glb: points and lines of every mode, lit and unlit, in colours, with and without indices; a camera.
stage.glb: a spot, a point light with a range and a directional light, two of which move; a camera.
veils.glb: blended meshes that joints and morph targets bend, before and behind an opaque block that moves; a camera.
well.gltf, well.bin and stone.jpg: a model in three files. ffmpeg writes the JPEG, so its bytes depend on the version.
"""

import json
import math
import os
import random
import subprocess

from model_writer import FOLDER, FLOAT, UBYTE, png, Model, unit, grid, tube, sphere, box, turn


def garden():
    rng = random.Random(2013)
    model = Model()
    speckle = [[rng.randrange(40) for _ in range(32)] for _ in range(32)]
    grass = png(32, 32, lambda x, y: (50 + speckle[y][x] // 2, 100 + speckle[y][x], 40 + speckle[x][y] // 3))

    def leaf(x, y):
        across, down = (x + 5 * (y // 8)) % 12, y % 8
        u, v = (across - 5.5) / 6, (down - 3.5) / 4
        inside = u * u + v * v + 0.6 * u * v < 0.9 and math.hypot(x - 31.5, y - 31.5) < 31
        return (40 + 6 * across, 120 + 9 * down, 30, 255 if inside else 0)

    model.root["images"] = [
        {"name": "grass", "bufferView": model.view(grass), "mimeType": "image/png"},
        {"name": "leaves", "bufferView": model.view(png(64, 64, leaf)), "mimeType": "image/png"},
    ]
    model.root["samplers"] = [{"magFilter": 9729, "minFilter": 9987}, {"wrapS": 33071, "wrapT": 33071}]
    model.root["textures"] = [{"source": 0, "sampler": 0}, {"source": 1, "sampler": 1}]
    model.root["extensionsUsed"] = ["KHR_texture_transform"]
    repeat = {"index": 0, "extensions": {"KHR_texture_transform": {"scale": [6, 6]}}}
    lawn = model.material("lawn", texture=repeat)
    bark = model.material("bark", (0.6, 0.45, 0.3, 1))
    leaves = model.material("leaves", texture={"index": 1}, alphaMode="MASK", alphaCutoff=0.5, doubleSided=True)
    water = model.material("water", (0.1, 0.35, 0.55, 0.6), roughness=0.1, alphaMode="BLEND")
    glass = model.material("glass", (0.7, 0.9, 0.85, 0.3), roughness=0.1, alphaMode="BLEND", doubleSided=True)
    paint = model.material("paint", (0.9, 0.88, 0.8, 1))
    gold = model.material("gold", (1, 0.77, 0.34, 1), metallic=1, roughness=0.3)

    def hill(u, v):
        x, z = 20 * (u - 0.5), 20 * (0.5 - v)
        return [x, 0.25 * math.sin(0.7 * x) * math.cos(0.5 * z) - 0.3, z]

    ground = model.mesh("ground", grid(16, 16, hill), lawn)
    trunk_shape = tube(0, 2, 0.25, 0.12)
    trunk_shape["colors"] = [(150 + rng.randrange(80),) * 3 + (255,) for _ in trunk_shape["positions"]]
    trunk = model.mesh("trunk", trunk_shape, bark)
    crown_shape = {"positions": [], "normals": [], "uvs": [], "indices": []}
    for k in range(5):
        c, s = math.cos(k * math.pi / 5), math.sin(k * math.pi / 5)
        first = len(crown_shape["positions"])
        for p, q in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            crown_shape["positions"].append([1.4 * p * c, 1.4 * q, 1.4 * p * s])
            crown_shape["normals"].append(unit([p * c, 0.5 + q, p * s]))
            crown_shape["uvs"].append(((p + 1) / 2, (1 - q) / 2))
        crown_shape["indices"] += [first + i for i in (0, 1, 2, 0, 2, 3)]
    crown = model.mesh("crown", crown_shape, leaves)
    rim = [[2.2 * math.cos(-2 * math.pi * i / 24), 0, 1.5 * math.sin(-2 * math.pi * i / 24)] for i in range(25)]
    pond = model.mesh("pond", {"positions": [[0, 0, 0]] + rim, "normals": [[0, 1, 0]] * 26}, water, mode=6)
    post = model.mesh("post", box(0.08, 0.5, 0.08), paint)
    rail = model.mesh("rail", {k: v for k, v in box(9.2, 0.05, 0.03).items() if k != "normals"}, paint)
    ball = model.mesh("ball", sphere(0.6), gold)
    pane = model.mesh("greenhouse", box(1.2, 0.8, 0.9), glass)

    roots = [model.node("ground", ground)]
    for k in range(8):
        x, z = 7.5 * math.cos(k * 0.785 + 0.3), 7.5 * math.sin(k * 0.785 + 0.3)
        size = 0.8 + 0.1 * k
        children = [model.node("trunk", trunk), model.node("crown", crown, translation=[0, 2.6, 0], rotation=turn(20 * k))]
        scale = [-size if k == 3 else size, size, size]
        roots.append(model.node(f"tree {k}", translation=[x, -0.4, z], scale=scale, children=children))
    roots.append(model.node("pond", pond, translation=[-1.5, 0.05, 1.5]))
    roots.append(model.node("ball", ball, translation=[2.2, 0.6, 2.5]))
    roots.append(model.node("greenhouse", pane, translation=[2.8, 0.6, -2.5], rotation=turn(30)))
    roots.append(model.node("pot", ball, translation=[2.8, 0.2, -2.5], scale=[0.5, 0.7, 0.5]))
    for side in range(4):
        posts = [model.node("post", post, translation=[-9.2 + 4.6 * k, 0, 0]) for k in range(4)]
        posts.append(model.node("rail", rail, translation=[0, 0.25, 0]))
        c, s = math.cos(side * math.pi / 2), math.sin(side * math.pi / 2)
        place = {"translation": [9.2 * s, 0.2, 9.2 * c], "rotation": turn(90 * side)}
        roots.append(model.node(f"fence {side}", children=posts, **place))
    model.root["cameras"] = [{"type": "perspective", "name": "gate", "perspective": {"yfov": 0.7, "znear": 0.1, "zfar": 200}}]
    roots.append(model.node("gate", camera=0, translation=[0, 3, 16]))
    model.root["scenes"] = [{"name": "garden", "nodes": roots}]
    model.write_glb("garden.glb")


def machine():
    """What moves: by keyframes of every interpolation, by joints, by morph targets, and a camera."""
    model = Model()
    paint = model.material("paint", (0.8, 0.3, 0.15, 1))
    steel = model.material("steel", (0.6, 0.62, 0.65, 1))
    floor = model.mesh("floor", box(4, 0.1, 4), steel)
    block = model.mesh("block", box(0.4, 0.4, 0.4), paint)
    joints = 6
    rows = 15
    bend = lambda u, v: [(0.3 - 0.15 * v) * math.cos(-2 * math.pi * u), 3 * v, (0.3 - 0.15 * v) * math.sin(-2 * math.pi * u)]
    arm_shape = grid(12, rows, bend)
    arm = model.mesh("arm", arm_shape, paint)
    sets = {name: [] for name in ("JOINTS_0", "WEIGHTS_0", "JOINTS_1", "WEIGHTS_1")}
    for _, y, _ in arm_shape["positions"]:
        along = min(y / 3 * (joints - 1), joints - 1 - 1e-6)
        low, share = int(along), along - int(along)
        sets["JOINTS_0"].append((low, 0, 0, 0))
        sets["WEIGHTS_0"].append((1 - share, 0, 0, 0))
        sets["JOINTS_1"].append((low + 1, 0, 0, 0))
        sets["WEIGHTS_1"].append((share, 0, 0, 0))
    for name, values in sets.items():
        accessor = model.accessor(values, "VEC4", UBYTE if "JOINTS" in name else FLOAT)
        model.root["meshes"][arm]["primitives"][0]["attributes"][name] = accessor
    ball_shape = sphere(0.6)
    ball = model.mesh("ball", ball_shape, steel)
    wide = [[0.8 * x, -0.3 * y, 0.8 * z] for x, y, z in ball_shape["positions"]]
    tall = [[-0.2 * x, 0.9 * y, -0.2 * z] for x, y, z in ball_shape["positions"]]
    model.root["meshes"][ball]["primitives"][0]["targets"] = [{"POSITION": model.accessor(d, "VEC3")} for d in (wide, tall)]
    model.root["meshes"][ball]["weights"] = [0.25, 0]
    bones = []
    for k in reversed(range(joints)):
        children = {"children": [bones[-1]]} if bones else {}
        bones.append(model.node(f"bone {k}", translation=[0, 3 / (joints - 1) if k else 0, 0], **children))
    bones.reverse()
    inverse = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -3 * k / (joints - 1), 0, 1) for k in range(joints)]
    model.root["skins"] = [{"joints": bones, "inverseBindMatrices": model.accessor(inverse, "MAT4"), "name": "arm"}]
    shoulder = model.node("shoulder", translation=[-1.5, 0.1, 0], children=[bones[0]])
    skinned = model.node("arm", arm, skin=0, translation=[99, 0, 0])
    rider = model.node("rider", block, translation=[1.2, 0, 0])
    wheel = model.node("wheel", block, translation=[1.8, 1.2, 0], children=[rider])
    drop = model.node("drop", block, translation=[0, 2.5, -2], scale=[0.5, 0.5, 0.5])
    swell = model.node("swell", ball, translation=[0.5, 0.9, 1.8])
    model.root["cameras"] = [{"type": "perspective", "name": "crane", "perspective": {"yfov": 0.8, "znear": 0.1, "zfar": 100}}]
    crane = model.node("crane", camera=0, translation=[0, 2, 9])
    quarter = [(0, 0, 0, 1), (0, 0, math.sqrt(0.5), math.sqrt(0.5)), (0, 0, 1, 0)]
    splined = [part for turn_ in quarter for part in ((0, 0, 0, 0), turn_, (0, 0, 0, 0))]

    curl = [(0, 0, 0, 1), (0, 0, math.sin(0.2), math.cos(0.2)), (math.sin(0.15), 0, 0, math.cos(0.15))]
    work = [(bone, "rotation", "LINEAR", (0, 1, 2), curl, "VEC4") for bone in bones[1:]]
    work.append((wheel, "rotation", "CUBICSPLINE", (0, 1, 2), splined, "VEC4"))
    work.append((drop, "translation", "LINEAR", (0, 0.5, 2), [(0, 2.5, -2), (0, 0.5, -2), (0.5, 2.5, -2)], "VEC3"))
    work.append((drop, "scale", "STEP", (0, 1), [(0.5, 0.5, 0.5), (0.9, 0.5, 0.9)], "VEC3"))
    work.append((swell, "weights", "LINEAR", (0, 1, 2), [(w,) for w in (0.25, 0, 1, 0, 0, 1)], "SCALAR"))
    fly = [(crane, "translation", "LINEAR", (0, 2), [(0, 2, 9), (3, 3, 7)], "VEC3")]
    model.root["animations"] = [model.animation("work", *work), model.animation("fly", *fly)]
    ground = model.node("floor", floor)
    model.root["scenes"] = [{"name": "machine", "nodes": [ground, shoulder, skinned, wheel, drop, swell, crane]}]
    model.write_glb("machine.glb")


def stage():
    """Lights of every type, two of which go with nodes that move, and columns that they shine on."""
    model = Model()
    boards = model.material("boards", (0.55, 0.5, 0.45, 1))
    plaster = model.material("plaster", (0.8, 0.8, 0.78, 1))
    brass = model.material("brass", (0.9, 0.75, 0.35, 1), metallic=1.0, roughness=0.35)
    pane = model.material("pane", (0.6, 0.8, 0.9, 0.35), alphaMode="BLEND", doubleSided=True)
    floor = model.mesh("floor", box(4, 0.1, 3), boards)
    column = model.mesh("column", tube(0, 2, 0.3, 0.25, 24), plaster)
    ball = model.mesh("ball", sphere(0.4), brass)
    bulb = model.mesh("bulb", sphere(0.08), brass)
    glass = model.mesh("glass", box(0.7, 0.5, 0.02), pane)
    model.root["extensions"] = {
        "KHR_lights_punctual": {
            "lights": [
                {"type": "spot", "name": "follow spot", "color": [1, 0.85, 0.6], "intensity": 60, "range": 12,
                 "spot": {"innerConeAngle": 0.12, "outerConeAngle": 0.3}},
                {"type": "point", "name": "lantern", "color": [0.5, 0.7, 1], "intensity": 6, "range": 3},
                {"type": "directional", "name": "moon", "color": [0.6, 0.7, 1], "intensity": 0.4},
            ]
        }
    }
    model.root["extensionsUsed"] = ["KHR_lights_punctual"]
    light = lambda number: {"extensions": {"KHR_lights_punctual": {"light": number}}}
    down = lambda degrees: [math.sin(math.radians(-degrees) / 2), 0, 0, math.cos(math.radians(degrees) / 2)]
    lamp = model.node("follow spot", rotation=down(40), **light(0))
    mast = model.node("mast", translation=[0, 4, 4], children=[lamp])
    lantern = model.node("lantern", bulb, translation=[1.4, 0, 0], **light(1))
    arm = model.node("arm", translation=[0.6, 1.1, 0.6], children=[lantern])
    moon = model.node("moon", rotation=down(60), **light(2))
    roots = [model.node("floor", floor, translation=[0, -0.1, 0]), mast, arm, moon]
    roots += [model.node(f"column {i}", column, translation=[1.5 * i - 2.25, 0, -0.8]) for i in range(4)]
    roots += [model.node("ball", ball, translation=[-0.9, 0.4, 0.9]), model.node("glass", glass, translation=[1.3, 0.6, 1.7])]
    model.root["cameras"] = [{"type": "perspective", "name": "stalls", "perspective": {"yfov": 0.75, "znear": 0.1, "zfar": 100}}]
    roots.append(model.node("stalls", camera=0, translation=[0, 1.6, 6.5], rotation=down(8)))
    sweep = [turn(30), turn(-30), turn(30)]
    half = [turn(0), turn(120), turn(240)]
    show = [(mast, "rotation", "LINEAR", (0, 1, 2), sweep, "VEC4"), (arm, "rotation", "LINEAR", (0, 1, 2), half, "VEC4")]
    model.root["animations"] = [model.animation("show", *show)]
    model.root["scenes"] = [{"name": "stage", "nodes": roots}]
    model.write_glb("stage.glb")


def veils():
    """Blended meshes that bend: a curtain by joints, a bubble by a morph target. An opaque block moves between them."""
    model = Model()
    cloth = model.material("cloth", (0.85, 0.3, 0.25, 0.5), alphaMode="BLEND", doubleSided=True)
    soap = model.material("soap", (0.35, 0.6, 0.9, 0.4), alphaMode="BLEND", doubleSided=True)
    stone = model.material("stone", (0.6, 0.58, 0.5, 1))
    joints = 4
    curtain_shape = grid(6, 9, lambda u, v: [1.6 * (u - 0.5), 2.4 * v, 0.0])
    curtain = model.mesh("curtain", curtain_shape, cloth)
    sets = {"JOINTS_0": [], "WEIGHTS_0": []}
    for _, y, _ in curtain_shape["positions"]:
        along = min(y / 2.4 * (joints - 1), joints - 1 - 1e-6)
        low, share = int(along), along - int(along)
        sets["JOINTS_0"].append((low, low + 1, 0, 0))
        sets["WEIGHTS_0"].append((1 - share, share, 0, 0))
    for name, values in sets.items():
        accessor = model.accessor(values, "VEC4", UBYTE if "JOINTS" in name else FLOAT)
        model.root["meshes"][curtain]["primitives"][0]["attributes"][name] = accessor
    bones = []
    for k in reversed(range(joints)):
        children = {"children": [bones[-1]]} if bones else {}
        bones.append(model.node(f"bone {k}", translation=[0, 2.4 / (joints - 1) if k else 0, 0], **children))
    bones.reverse()
    inverse = [(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2.4 * k / (joints - 1), 0, 1) for k in range(joints)]
    model.root["skins"] = [{"joints": bones, "inverseBindMatrices": model.accessor(inverse, "MAT4"), "name": "curtain"}]
    ball_shape = sphere(0.6)
    bubble = model.mesh("bubble", ball_shape, soap)
    dented = [[0.4 * x, -0.5 * y, 0.3 * x] for x, y, _ in ball_shape["positions"]]
    model.root["meshes"][bubble]["primitives"][0]["targets"] = [{"POSITION": model.accessor(dented, "VEC3")}]
    block = model.mesh("block", box(0.5, 0.5, 0.5), stone)
    floor = model.mesh("floor", box(3, 0.1, 3), stone)
    rod = model.node("rod", translation=[-0.4, 0, 0.3], children=[bones[0]])
    roots = [model.node("floor", floor, translation=[0, -0.1, 0]), rod, model.node("curtain", curtain, skin=0)]
    swell = model.node("bubble", bubble, translation=[0.5, 0.9, 1.2])
    pane = model.node("pane", curtain, translation=[0.3, 0, -0.9])
    carried = model.node("block", block, translation=[-1.2, 0.6, -0.3])
    roots += [swell, pane, carried]
    model.root["cameras"] = [{"type": "perspective", "name": "seat", "perspective": {"yfov": 0.7, "znear": 0.1, "zfar": 100}}]
    roots.append(model.node("seat", camera=0, translation=[0, 1.2, 4.4]))
    bend = lambda angle: [(0, 0, 0, 1), (math.sin(angle), 0, 0, math.cos(angle)), (0, math.sin(angle), 0, math.cos(angle))]
    drift = [(bone, "rotation", "LINEAR", (0, 1, 2), bend(0.25), "VEC4") for bone in bones[1:]]
    drift.append((swell, "weights", "LINEAR", (0, 1, 2), [(w,) for w in (0, 1, 0.3)], "SCALAR"))
    drift.append((carried, "translation", "LINEAR", (0, 2), [(-1.2, 0.6, -0.3), (1.2, 0.9, 0.4)], "VEC3"))
    model.root["animations"] = [model.animation("drift", *drift), model.animation("rest", drift[-1])]
    model.root["scenes"] = [{"name": "veils", "nodes": roots}]
    model.write_glb("veils.glb")


def survey():
    """Points and lines of every mode: a scanned hill, its border, heights, a fence and a flight over it."""
    rng = random.Random(21)
    model = Model()
    white = model.material("white", (1, 1, 1, 1))
    red = model.material("red", (0.9, 0.2, 0.15, 1))
    steel = model.material("steel", (0.55, 0.6, 0.65, 1), roughness=0.5)
    height = lambda x, z: 0.7 * math.exp(-0.35 * (x * x + z * z)) + 0.1 * math.sin(1.7 * x) * math.cos(1.3 * z)
    shade = lambda y: (60 + int(180 * max(0, min(1, y))), 130 + int(60 * max(0, min(1, y))), 60, 255)
    spots = [(3 * (2 * rng.random() - 1), 2 * (2 * rng.random() - 1)) for _ in range(900)]
    scan = [[x, height(x, z), z] for x, z in spots]
    hill = model.mesh("hill", {"positions": scan, "colors": [shade(y) for _, y, _ in scan]}, white, mode=0)
    ball = sphere(0.4)
    dome = model.mesh("dome", {"positions": ball["positions"], "normals": ball["normals"]}, steel, mode=0)
    corners = [[-3.1, 0, -2.1], [3.1, 0, -2.1], [3.1, 0, 2.1], [-3.1, 0, 2.1]]
    border = model.mesh("border", {"positions": corners}, red, mode=2)
    fence = {"positions": [], "indices": [], "colors": []}
    for k in range(9):
        x = -2.8 + 0.7 * k
        fence["positions"] += [[x, height(x, 1.8), 1.8], [x, height(x, 1.8) + 0.35, 1.8]]
        fence["colors"] += [(60, 40, 30, 255), (250, 220, 120, 255)]
        fence["indices"] += [2 * k, 2 * k + 1] + ([2 * k - 1, 2 * k + 1] if k else [])
    fence_mesh = model.mesh("fence", fence, white, mode=1)
    turns = [k / 96 for k in range(97)]
    flight = [[2.2 * t * math.cos(15 * t), 1.2 - 0.3 * t, 1.6 * t * math.sin(15 * t)] for t in turns]
    colors = [(int(255 * t), 80, int(255 * (1 - t)), 255) for t in turns]
    path = model.mesh("flight", {"positions": flight, "colors": colors}, white, mode=3)
    plate = model.mesh("plate", box(3.2, 0.05, 2.2), steel)
    roots = [model.node("plate", plate, translation=[0, -0.3, 0]), model.node("hill", hill), model.node("border", border)]
    roots.append(model.node("dome", dome, translation=[-2.1, 0.75, -1.0]))
    roots += [model.node("fence", fence_mesh), model.node("flight", path)]
    model.root["cameras"] = [{"type": "perspective", "name": "drone", "perspective": {"yfov": 0.7, "znear": 0.1, "zfar": 100}}]
    lean = [math.sin(math.radians(-28) / 2), 0, 0, math.cos(math.radians(28) / 2)]
    roots.append(model.node("drone", camera=0, translation=[0, 4, 7], rotation=lean))
    model.root["scenes"] = [{"name": "survey", "nodes": roots}]
    model.write_glb("survey.glb")


def stone():
    """128 x 128 of a wall of grey blocks."""
    rng = random.Random(7)
    shade = [[110 + rng.randrange(90) for _ in range(8)] for _ in range(8)]

    def pixel(x, y):
        row = y // 16
        column = (x + 8 * (row % 2)) // 16 % 8
        joint = y % 16 < 2 or (x + 8 * (row % 2)) % 16 < 2
        level = 70 if joint else shade[row][column] + (x * 7 + y * 13) % 17
        return (level, level - 4, level - 12)

    command = ["ffmpeg", "-v", "error", "-y", "-f", "png_pipe", "-i", "-", "-q:v", "4", "-pix_fmt", "yuvj420p"]
    subprocess.run([*command, os.path.join(FOLDER, "stone.jpg")], input=png(128, 128, pixel), check=True)


def well():
    model = Model()
    model.root["images"] = [{"name": "stone", "uri": "stone.jpg"}]
    model.root["textures"] = [{"source": 0}]
    masonry = model.material("masonry", texture={"index": 0}, roughness=0.9)
    wood = model.material("wood", (0.45, 0.28, 0.14, 1))
    tiles = model.material("tiles", (0.65, 0.2, 0.12, 1), roughness=0.6, doubleSided=True)
    iron = model.material("iron", (0.35, 0.36, 0.38, 1), metallic=1, roughness=0.5)
    outside = model.mesh("outside", tube(0, 1, 1.2, 1.1, 24), masonry)
    inside = model.mesh("inside", tube(1, 0, 0.85, 0.85, 24), masonry)
    lip = model.mesh("lip", tube(1, 1, 1.1, 0.85, 24), masonry)
    beam = model.mesh("beam", box(0.07, 0.9, 0.07), wood)
    apex, eaves = [0, 0.8, 0], [[-1.3, 0, 1], [1.3, 0, 1], [1.3, 0, -1], [-1.3, 0, -1]]
    faces = [p for i in range(4) for p in (eaves[i], eaves[(i + 1) % 4], apex)]
    roof = model.mesh("roof", {"positions": faces}, tiles)
    bucket = model.mesh("bucket", tube(0, 0.35, 0.14, 0.2, 12), iron)
    roots = [
        model.node("wall", children=[model.node("outside", outside), model.node("inside", inside), model.node("lip", lip)]),
        model.node("left", beam, translation=[-1, 1.7, 0]),
        model.node("right", beam, translation=[1, 1.7, 0]),
        model.node("axle", beam, translation=[0, 2, 0], rotation=[0, 0, math.sqrt(0.5), math.sqrt(0.5)], scale=[0.7, 1.2, 0.7]),
        model.node("roof", roof, translation=[0, 2.5, 0]),
        model.node("bucket", bucket, translation=[0.2, 1.2, 0]),
    ]
    model.root["scenes"] = [{"name": "well", "nodes": roots}]
    model.root["buffers"] = [{"byteLength": len(model.data), "uri": "well.bin"}]
    with open(os.path.join(FOLDER, "well.bin"), "wb") as file:
        file.write(model.data)
    with open(os.path.join(FOLDER, "well.gltf"), "w") as file:
        json.dump(model.root, file, indent=1)
        file.write("\n")


def bumps(size, slope):
    """A normal texture: bump (u, v) in [0, 1] has slopes slope(u, v) along u and up."""

    def pixel(x, y):
        across, up = slope((x + 0.5) / size, (y + 0.5) / size)
        return [round(127.5 + 127.5 * c) for c in unit([-across, -up, 1])]

    return png(size, size, pixel)


def materials():
    """Every texture of a glTF 2.0 material, read in every way that the importer knows."""
    model = Model()

    def wave(u, v):
        return 0.5 + 0.5 * math.sin(6.2832 * u) * math.sin(6.2832 * v)

    def byte(share):
        return max(0, min(255, round(255 * share)))

    pictures = {
        "color": png(32, 32, lambda x, y: (200, 120 + (x // 8 + y // 8) % 2 * 90, 60 + 4 * y)),
        "shine": png(32, 32, lambda x, y: (0, byte(0.15 + 0.8 * y / 31), 255 * (x // 16))),
        "normal": bumps(64, lambda u, v: (0.8 * math.sin(12.566 * u), 0.8 * math.sin(12.566 * v))),
        "occlusion": png(32, 32, lambda x, y: (byte(wave(x / 32, y / 32)), 0, 0)),
        "emissive": png(32, 32, lambda x, y: (255, 140, 30) if 10 < x < 22 and 10 < y < 22 else (0, 0, 0)),
        "tiles": png(4, 4, lambda x, y: (60 * x + 40, 60 * y + 40, 90)),
    }
    model.root["images"] = [
        {"name": name, "bufferView": model.view(data), "mimeType": "image/png"} for name, data in pictures.items()
    ]
    smooth, mirrored, single = 0, 1, 2
    model.root["samplers"] = [
        {"magFilter": 9729, "minFilter": 9729},
        {"wrapS": 33648, "wrapT": 33648},
        {"magFilter": 9728, "minFilter": 9728, "wrapS": 33071, "wrapT": 33071},
    ]
    model.root["textures"] = []

    def texture(name, sampler=smooth, **more):
        item = {"source": list(pictures).index(name), "sampler": sampler}
        if item not in model.root["textures"]:
            model.root["textures"].append(item)
        return {"index": model.root["textures"].index(item), **more}

    def moved(**transform):
        return {"extensions": {"KHR_texture_transform": transform}}

    model.root["extensionsUsed"] = ["KHR_texture_transform", "KHR_materials_emissive_strength", "KHR_materials_unlit"]

    def material(name, factors, **more):
        return model.append("materials", {"name": name, "pbrMetallicRoughness": factors, **more})

    full = material(
        "full",
        {"baseColorTexture": texture("color"), "metallicRoughnessTexture": texture("shine")},
        normalTexture=texture("normal"),
        occlusionTexture=texture("occlusion", strength=0.8),
        emissiveTexture=texture("emissive"),
        emissiveFactor=[1, 1, 1],
        extensions={"KHR_materials_emissive_strength": {"emissiveStrength": 3}},
    )
    second = material(
        "second place",
        {"baseColorTexture": texture("color"), "metallicFactor": 0, "roughnessFactor": 0.4},
        normalTexture=texture("normal", mirrored, texCoord=1, scale=1.5),
        occlusionTexture=texture("occlusion", mirrored, texCoord=1),
    )
    moving = material(
        "transformed",
        {"baseColorTexture": texture("color", mirrored, **moved(scale=[2, 2], rotation=0.5, offset=[0.1, 0.2])), "metallicFactor": 0},
        normalTexture=texture("normal", mirrored, **moved(scale=[2, 2], rotation=0.5, offset=[0.1, 0.2])),
        emissiveTexture=texture("emissive", mirrored, **moved(scale=[2, 2])),
        emissiveFactor=[0.2, 0.6, 1],
    )
    metal = material(
        "metal",
        {"baseColorFactor": [1, 0.8, 0.5, 1], "metallicRoughnessTexture": texture("shine"), "roughnessFactor": 0.8},
        normalTexture=texture("normal", scale=0.3),
    )
    lamp = material("lamp", {"baseColorFactor": [0.2, 0.2, 0.2, 1], "metallicFactor": 0}, emissiveFactor=[0.1, 0.8, 0.3])
    sign = material("unlit", {"baseColorTexture": texture("tiles", single)}, extensions={"KHR_materials_unlit": {}})
    pane = material(
        "pane",
        {"baseColorFactor": [0.5, 0.7, 1, 0.5], "metallicFactor": 0, "roughnessFactor": 0.2},
        normalTexture=texture("normal"),
        emissiveTexture=texture("emissive"),
        emissiveFactor=[1, 0.5, 0.5],
        alphaMode="BLEND",
        doubleSided=True,
    )

    panel = grid(2, 2, lambda u, v: [u - 0.5, 0.5 - v, 0])
    panel["indices"] = panel["indices"][::-1]  # v runs down
    panel["normals"] = [[0, 0, 1]] * 9
    given = {**panel, "tangents": [[1, 0, 0, 1]] * 9, "uvs1": [(0.2 + 1.5 * u, 1.5 * v) for u, v in panel["uvs"]]}
    ball = sphere(0.55)
    painted = {**ball, "colors": [(255, byte(v), byte(u), 255) for u, v in ball["uvs"]]}
    roots = [
        model.node("full", model.mesh("full", ball, full), translation=[-1.3, 0.7, 0]),
        model.node("given tangents", model.mesh("given", given, second), translation=[0, 0.7, 0], rotation=turn(25)),
        model.node("derived tangents", model.mesh("derived", panel, moving), translation=[1.3, 0.7, 0], rotation=turn(-25)),
        model.node("metal", model.mesh("metal", painted, metal), translation=[-1.3, -0.6, 0]),
        model.node("mirrored", 0, translation=[0, -0.6, -0.2], scale=[-0.9, 0.9, 0.7]),
        model.node("lamp", model.mesh("lamp", box(0.2, 0.2, 0.2), lamp), translation=[0.95, -0.35, 0], rotation=turn(30)),
        model.node("unlit", model.mesh("sign", panel, sign), translation=[1.6, -0.4, 0], scale=[0.5, 0.5, 0.5]),
        model.node("pane", model.mesh("pane", panel, pane), translation=[1.1, -0.75, 0.5], rotation=turn(-15), scale=[0.9, 0.6, 1]),
    ]
    model.root["cameras"] = [{"type": "perspective", "name": "front", "perspective": {"yfov": 0.6, "znear": 0.1, "zfar": 100}}]
    roots.append(model.node("front", camera=0, translation=[0.1, 0.05, 5]))
    model.root["scenes"] = [{"name": "materials", "nodes": roots}]
    model.write_glb("materials.glb")


def shield():
    """Five textures of one size, place and sampler, which are read as three."""
    model = Model()

    def share(x):
        return max(0, min(255, round(255 * x)))

    def brick(x, y):
        return (x + 16 * (y // 16 % 2)) % 32, y % 16

    def isJoint(x, y):
        return min(brick(x, y)) < 2

    pictures = [
        png(64, 64, lambda x, y: (120, 115, 105) if isJoint(x, y) else (190, 90 + x // 2, 60 + y // 2)),
        png(64, 64, lambda x, y: (0, share(0.9 if isJoint(x, y) else 0.25 + 0.006 * x), 255 * (y // 32))),
        bumps(64, lambda u, v: (0.6 * math.sin(25.133 * u), 0.6 * math.sin(25.133 * v))),
        png(64, 64, lambda x, y: (share(0.4 if isJoint(x, y) else 0.7 + 0.3 * math.sin(0.1963 * y)), 0, 0)),
        png(64, 64, lambda x, y: (255, 150, 40) if 24 <= x < 40 and 24 <= y < 40 else (0, 0, 0)),
    ]
    model.root["images"] = [{"bufferView": model.view(data), "mimeType": "image/png"} for data in pictures]
    model.root["textures"] = [{"source": i} for i in range(5)]
    bricks = {
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
        "normalTexture": {"index": 2},
        "occlusionTexture": {"index": 3},
        "emissiveTexture": {"index": 4},
        "emissiveFactor": [0.8, 0.8, 0.8],
    }
    panel = grid(2, 2, lambda u, v: [u - 0.5, 0.5 - v, 0])
    panel["indices"] = panel["indices"][::-1]  # v runs down
    panel["normals"] = [[0, 0, 1]] * 9
    material = model.append("materials", {"name": "bricks", **bricks})
    roots = [
        model.node("ball", model.mesh("ball", sphere(0.5), material), translation=[-0.6, 0, 0]),
        model.node("panel", model.mesh("panel", panel, material), translation=[0.5, 0, 0], rotation=turn(-20)),
    ]
    model.root["scenes"] = [{"name": "shield", "nodes": roots}]
    model.write_glb("shield.glb")


garden()
materials()
machine()
shield()
stage()
survey()
veils()
stone()
well()
