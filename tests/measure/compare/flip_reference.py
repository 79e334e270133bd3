#!/usr/bin/env python3
"""Prints the figures that flip_difference_test.cpp holds FLIP to.

A second implementation of LDR-FLIP, written from the paper (Andersson et al., "FLIP: A Difference Evaluator for
Alternating Images", HPG 2020) and sharing nothing with the C++ one: float64, every filter as the two-dimensional one
of the paper and not as two passes, over all pixels and not over tiles. Plain Python, a minute a run:

    python3 tests/measure/flip_reference.py

The pictures are made by formulas that the test repeats.
"""

from math import ceil, exp, pi, sqrt

DEFAULT_SCALE = 0.7 * 3840 / 0.7 * pi / 180  # pixels per degree


# Pictures: lists of rows of (r, g, b), 0 to 255.


def ramp(width, height):
    return [[(5 * x % 256, (3 * x + 6 * y) % 256, (255 - 4 * y) % 256) for x in range(width)] for y in range(height)]


def with_box(picture, left, top, right, bottom, color):
    return [
        [color if left <= x < right and top <= y < bottom else pixel for x, pixel in enumerate(row)]
        for y, row in enumerate(picture)
    ]


def flat(width, height, color):
    return [[color] * width for _ in range(height)]


def noise(width, height, step):
    """A linear congruential generator's top bit, added to mid grey."""
    state = 1
    rows = []
    for _ in range(height):
        row = []
        for _ in range(width):
            state = (1664525 * state + 1013904223) % 2**32
            value = 128 + (step if state >= 2**31 else 0)
            row.append((value, value, value))
        rows.append(row)
    return rows


# Colour.

RGB_TO_XYZ = [
    [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
    [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
    [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
]


def times(matrix, v):
    return [sum(m * c for m, c in zip(row, v)) for row in matrix]


def inverse(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [
        [(e * i - f * h) / det, (c * h - b * i) / det, (b * f - c * e) / det],
        [(f * g - d * i) / det, (a * i - c * g) / det, (c * d - a * f) / det],
        [(d * h - e * g) / det, (b * g - a * h) / det, (a * e - b * d) / det],
    ]


XYZ_TO_RGB = inverse(RGB_TO_XYZ)
WHITE = times(RGB_TO_XYZ, [1, 1, 1])


def linear(byte):
    c = byte / 255
    return c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4


def to_ycxcz(rgb):
    x, y, z = (c / w for c, w in zip(times(RGB_TO_XYZ, [linear(c) for c in rgb]), WHITE))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def from_ycxcz(color):
    y = (color[0] + 16) / 116
    xyz = [(y + color[1] / 500) * WHITE[0], y * WHITE[1], (y - color[2] / 200) * WHITE[2]]
    return [min(max(c, 0.0), 1.0) for c in times(XYZ_TO_RGB, xyz)]


def hunt_lab(rgb):
    def f(t):
        return t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29

    x, y, z = (f(c / w) for c, w in zip(times(RGB_TO_XYZ, rgb), WHITE))
    lightness = 116 * y - 16
    return lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)


def hyab(a, b):
    return abs(a[0] - b[0]) + sqrt((a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2)


# Filters: square lists of weights.


def square(radius, weight):
    span = range(-radius, radius + 1)
    return [[weight(x, y) for x in span] for y in span]


def normalized(weights):
    positive = sum(w for row in weights for w in row if w > 0)
    negative = -sum(w for row in weights for w in row if w < 0)
    return [[w / positive if w > 0 else (w / negative if w < 0 else 0.0) for w in row] for row in weights]


def filtered(plane, weights):
    height, width, radius = len(plane), len(plane[0]), len(weights) // 2
    return [
        [
            sum(
                w * plane[min(max(y + j - radius, 0), height - 1)][min(max(x + i - radius, 0), width - 1)]
                for j, row in enumerate(weights)
                for i, w in enumerate(row)
            )
            for x in range(width)
        ]
        for y in range(height)
    ]


def sensitivities(scale):
    radius = ceil(3 * sqrt(0.04 / (2 * pi**2)) * scale)

    def sensitivity(gaussians):
        return normalized(
            square(
                radius,
                lambda x, y: sum(
                    a * sqrt(pi / b) * exp(-(pi**2) * (x * x + y * y) / scale**2 / b) for a, b in gaussians
                ),
            )
        )

    return sensitivity([(1, 0.0047)]), sensitivity([(1, 0.0053)]), sensitivity([(34.1, 0.04), (13.5, 0.025)])


def features(lightness, scale):
    """Magnitudes of edges and points, per pixel."""
    deviation = 0.5 * 0.082 * scale
    radius = ceil(3 * deviation)

    def gaussian(x, y):
        return exp(-(x * x + y * y) / (2 * deviation**2))

    def magnitudes(weight):
        along_x = filtered(lightness, normalized(square(radius, lambda x, y: weight(x) * gaussian(x, y))))
        along_y = filtered(lightness, normalized(square(radius, lambda x, y: weight(y) * gaussian(x, y))))
        return [[sqrt(a * a + b * b) for a, b in zip(ra, rb)] for ra, rb in zip(along_x, along_y)]

    return magnitudes(lambda t: -t), magnitudes(lambda t: t * t / deviation**2 - 1)


def flip(reference, test, scale=DEFAULT_SCALE):
    seen = []
    for picture in (reference, test):
        opponents = [[to_ycxcz(pixel) for pixel in row] for row in picture]
        planes = [
            filtered([[c[i] for c in row] for row in opponents], weights)
            for i, weights in enumerate(sensitivities(scale))
        ]
        edges, points = features([[(c[0] + 16) / 116 for c in row] for row in opponents], scale)
        seen.append((planes, edges, points))
    largest = hyab(hunt_lab([0, 1, 0]), hunt_lab([0, 0, 1])) ** 0.7
    knee = 0.4 * largest

    def difference(x, y):
        labs = [hunt_lab(from_ycxcz([plane[y][x] for plane in planes])) for planes, _, _ in seen]
        power = hyab(*labs) ** 0.7
        color = 0.95 * power / knee if power < knee else 0.95 + 0.05 * (power - knee) / (largest - knee)
        edge, point = (abs(seen[0][k][y][x] - seen[1][k][y][x]) for k in (1, 2))
        return color ** (1 - sqrt(max(edge, point) / sqrt(2)))

    return [[difference(x, y) for x in range(len(test[0]))] for y in range(len(test))]


def report(name, reference, test, scale=DEFAULT_SCALE):
    differences = flip(reference, test, scale)
    height, width = len(differences), len(differences[0])
    mean = sum(map(sum, differences)) / (width * height)
    corner, middle = differences[0][0], differences[height // 2][width // 2]
    print(f"{name}: mean {mean:.7f}, at (0, 0) {corner:.7f}, in the middle {middle:.7f}")


if __name__ == "__main__":
    base = ramp(70, 40)
    report("box", base, with_box(base, 20, 10, 40, 25, (250, 30, 60)))
    report("box at 30 pixels a degree", base, with_box(base, 20, 10, 40, 25, (250, 30, 60)), 30.0)
    report("grey", flat(24, 20, (100, 100, 100)), flat(24, 20, (110, 110, 110)))
    report("black and white", flat(24, 20, (0, 0, 0)), flat(24, 20, (255, 255, 255)))
    report("green and blue", flat(24, 20, (0, 255, 0)), flat(24, 20, (0, 0, 255)))
    report("noise", noise(48, 32, 40), flat(48, 32, (128, 128, 128)))
    report("one step", flat(30, 30, (128, 128, 128)), with_box(flat(30, 30, (128, 128, 128)), 15, 15, 16, 16, (129, 129, 129)))
