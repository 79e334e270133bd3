#version 460
#extension GL_GOOGLE_include_directive : require
#include "deform/deform_shared.h"

// Deforms a mesh as scene::deform() does: float64 in the order of the CPU's operations, never contracted, rounded once.
// Positions are the CPU's to the bit. Vulkan lets float64 division and square root be less exact, which normals need.
layout(local_size_x = kDeformBlock) in;

layout(set = 0, binding = 0, std430) readonly buffer Deformer { uint rest[]; };
layout(set = 0, binding = 1, std430) readonly buffer Pose { double pose[]; };
layout(set = 0, binding = 2, std430) buffer Vertices { uint vertices[]; }; // PackedVertex
layout(set = 0, binding = 3, std430) buffer Details { uint details[]; };   // PackedDetail
layout(push_constant) uniform Push { DeformPush push; };

struct Point {
    dvec3 position;
    dvec3 normal;
    dvec3 tangent;
    double handedness;
};

// Column by column.
struct Linear {
    dvec3 columns[3];
};

bool has(uint flag) { return (push.flags & flag) != 0u; }

dvec3 floatsAt(uint word) {
    return dvec3(uintBitsToFloat(rest[word]), uintBitsToFloat(rest[word + 1u]), uintBitsToFloat(rest[word + 2u]));
}

dvec3 numbersAt(uint first) { return dvec3(pose[first], pose[first + 1u], pose[first + 2u]); }

double dotOf(dvec3 a, dvec3 b) {
    precise dvec3 products = a * b;
    precise double sum = products.x + products.y + products.z;
    return sum;
}

dvec3 crossOf(dvec3 a, dvec3 b) {
    precise dvec3 product = dvec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
    return product;
}

double determinantOf(Linear m) {
    dvec3 a = m.columns[0];
    dvec3 b = m.columns[1];
    dvec3 c = m.columns[2];
    precise double sum =
        a.x * (b.y * c.z - c.y * b.z) - b.x * (a.y * c.z - c.y * a.z) + c.x * (a.y * b.z - b.y * a.z);
    return sum;
}

dvec3 timesVector(Linear m, dvec3 v) {
    precise dvec3 sum = m.columns[0] * v.x + m.columns[1] * v.y + m.columns[2] * v.z;
    return sum;
}

Linear timesMatrix(Linear a, Linear b) {
    return Linear(dvec3[3](timesVector(a, b.columns[0]), timesVector(a, b.columns[1]), timesVector(a, b.columns[2])));
}

dvec3 normalizedOr(dvec3 v, dvec3 other) {
    precise double size = sqrt(dotOf(v, v));
    if (!(size > 0.0lf) || isinf(size)) {
        return other;
    }
    precise dvec3 unit = v / size;
    return unit;
}

void morph(uint vertex, inout Point point) {
    uint end = rest[push.firstDeltas + vertex + 1u];
    for (uint i = rest[push.firstDeltas + vertex]; i < end; ++i) {
        uint delta = push.deltas + kDeltaWords * i;
        uint target = rest[delta];
        double weight = target < push.weights ? pose[kPlaceNumbers + target] : 0.0lf;
        if (weight != 0.0lf) {
            precise dvec3 position = point.position + weight * floatsAt(delta + 1u);
            precise dvec3 normal = point.normal + weight * floatsAt(delta + 4u);
            precise dvec3 tangent = point.tangent + weight * floatsAt(delta + 7u);
            point.position = position;
            point.normal = normal;
            point.tangent = tangent;
        }
    }
    if (has(kDeformDerived)) {
        dvec3 normal = normalizedOr(point.normal, dvec3(0.0lf));
        double along = dotOf(normal, point.tangent);
        precise dvec3 tangent = point.tangent - normal * along;
        point.tangent = tangent;
    }
}

void followJoints(uint vertex, inout Point point) {
    precise dvec3 columns[4] = dvec3[4](dvec3(0.0lf), dvec3(0.0lf), dvec3(0.0lf), dvec3(0.0lf));
    uint end = rest[push.firstInfluences + vertex + 1u];
    for (uint i = rest[push.firstInfluences + vertex]; i < end; ++i) {
        uint influence = push.influences + 2u * i;
        uint joint = kPlaceNumbers + push.weights + 16u * rest[influence];
        double weight = double(uintBitsToFloat(rest[influence + 1u]));
        for (uint c = 0u; c < 4u; ++c) {
            precise dvec3 column = columns[c] + numbersAt(joint + 4u * c) * weight;
            columns[c] = column;
        }
    }
    Linear matrix = Linear(dvec3[3](columns[0], columns[1], columns[2]));
    Linear basis = Linear(dvec3[3](numbersAt(3u), numbersAt(6u), numbersAt(9u)));
    precise dvec3 first = columns[0] * point.position.x + columns[1] * point.position.y;
    precise dvec3 second = columns[2] * point.position.z + columns[3];
    precise dvec3 fromPlace = (first + second) - numbersAt(0u);
    point.position = timesVector(basis, fromPlace);
    Linear cofactors = Linear(dvec3[3](crossOf(columns[1], columns[2]), crossOf(columns[2], columns[0]),
                                       crossOf(columns[0], columns[1])));
    double side = determinantOf(matrix) < 0.0lf ? -1.0lf : 1.0lf;
    for (uint c = 0u; c < 3u; ++c) {
        cofactors.columns[c] *= side;
    }
    point.normal = timesVector(basis, timesVector(cofactors, point.normal));
    Linear turned = timesMatrix(basis, matrix);
    point.tangent = timesVector(turned, point.tangent);
    point.handedness = determinantOf(turned) < 0.0lf ? -point.handedness : point.handedness;
}

Point deformed(uint vertex) {
    uint word = kRestWords * vertex;
    Point point = Point(floatsAt(word), floatsAt(word + 3u), floatsAt(word + 6u),
                        double(uintBitsToFloat(rest[word + 9u])));
    morph(vertex, point);
    if (has(kDeformSkin)) {
        followJoints(vertex, point);
    } else {
        precise dvec3 position = point.position - numbersAt(12u);
        point.position = position;
    }
    return point;
}

// As glm::packSnorm2x16() rounds: halves away from zero.
uint snorm16(float value) {
    precise float scaled = clamp(value, -1.0, 1.0) * 32767.0;
    precise double size = floor(abs(double(scaled)) + 0.5lf);
    return uint(int(scaled < 0.0 ? -size : size)) & 0xffffu;
}

// As encodeOctahedral(). The quotient is rounded from float64, since that of float32 may be off by two steps.
uint packOctahedral(vec3 n) {
    precise float sum = abs(n.x) + abs(n.y) + abs(n.z);
    if (!(sum > 0.0)) {
        return 0u;
    }
    precise vec2 p = vec2(float(double(n.x) / double(sum)), float(double(n.y) / double(sum)));
    if (!(n.z >= 0.0)) {
        precise vec2 folded = vec2((1.0 - abs(p.y)) * (p.x >= 0.0 ? 1.0 : -1.0), (1.0 - abs(p.x)) * (p.y >= 0.0 ? 1.0 : -1.0));
        p = folded;
    }
    return snorm16(p.x) | snorm16(p.y) << 16u;
}

vec3 roundedNormal(uint vertex, dvec3 normal) {
    return vec3(normalizedOr(normal, floatsAt(kRestWords * vertex + 3u)));
}

vec3 writePosition(uint vertex, dvec3 position) {
    vec3 rounded = vec3(position);
    uint word = push.firstVertexWord + kVertexWords * vertex;
    vertices[word] = floatBitsToUint(rounded.x);
    vertices[word + 1u] = floatBitsToUint(rounded.y);
    vertices[word + 2u] = floatBitsToUint(rounded.z);
    return rounded;
}

void writeNormal(uint vertex, vec3 normal) {
    vertices[push.firstVertexWord + kVertexWords * vertex + 3u] = packOctahedral(normal);
}

void writeTangent(uint vertex, Point point) {
    if (has(kDeformDetails)) {
        vec3 tangent = vec3(normalizedOr(point.tangent, floatsAt(kRestWords * vertex + 6u)));
        uint word = push.firstDetailWord + kDetailWords * vertex;
        details[word] = packOctahedral(tangent);
        details[word + 1u] = snorm16(float(point.handedness));
    }
}

void deformTriangle(uint first) {
    dvec3 corners[3];
    for (uint i = 0u; i < 3u; ++i) {
        Point point = deformed(first + i);
        corners[i] = dvec3(writePosition(first + i, point.position));
        writeTangent(first + i, point);
    }
    precise dvec3 ab = corners[1] - corners[0];
    precise dvec3 ac = corners[2] - corners[0];
    vec3 normal = roundedNormal(first, crossOf(ab, ac));
    for (uint i = 0u; i < 3u; ++i) {
        writeNormal(first + i, normal);
    }
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (has(kDeformFlat)) {
        if (3u * index + 2u < push.vertices) {
            deformTriangle(3u * index);
        }
    } else if (index < push.vertices) {
        Point point = deformed(index);
        writePosition(index, point.position);
        writeNormal(index, roundedNormal(index, point.normal));
        writeTangent(index, point);
    }
}
