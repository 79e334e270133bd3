#include "../../support/worst.h"
#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace cdr::scene::test {
namespace {

using Surface = std::function<glm::dvec3(double, double)>;

/// Places and normals of a mesh, vertex by vertex.
struct Sheet {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
};

constexpr int kCells = 8;

/// A grid of vertices on a surface over the unit square.
Sheet sheetOf(const Surface& surface) {
    Sheet sheet;
    for (int y = 0; y <= kCells; ++y) {
        for (int x = 0; x <= kCells; ++x) {
            const double u = 1.0 * x / kCells;
            const double v = 1.0 * y / kCells;
            constexpr double kStep = 1e-5;
            const glm::dvec3 alongU = surface(u + kStep, v) - surface(u - kStep, v);
            const glm::dvec3 alongV = surface(u, v + kStep) - surface(u, v - kStep);
            sheet.positions.push_back(surface(u, v));
            sheet.normals.push_back(glm::normalize(glm::cross(alongU, alongV)));
        }
    }
    return sheet;
}

Sheet operator-(const Sheet& a, const Sheet& b) {
    Sheet difference = a;
    for (std::size_t i = 0; i < a.positions.size(); ++i) {
        difference.positions[i] -= b.positions[i];
        difference.normals[i] -= b.normals[i];
    }
    return difference;
}

std::vector<float> floatsOf(const std::vector<glm::dvec3>& vectors) {
    std::vector<float> floats;
    for (const glm::dvec3& v : vectors) {
        floats.insert(floats.end(),
                      {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
    }
    return floats;
}

/// A wave, a piece of a cylinder that is three times as wide, and the wave sheared, stretched and turned.
glm::dvec3 wave(double u, double v) {
    return {2.0 * u, 1.5 * v, 0.15 * std::sin(5.0 * u + 2.0 * v)};
}
glm::dvec3 cylinder(double u, double v) {
    return {3.0 * std::sin(2.0 * u), 1.5 * v + u, 3.0 * std::cos(2.0 * u)};
}
glm::dvec3 sheared(double u, double v) {
    const glm::dvec3 at = wave(u, v);
    return {-3.0 * at.y + 0.3 * at.z, 2.5 * at.x + at.y, at.z};
}

class GltfMorphedTangents : public GltfFolder {
  protected:
    /// A sheet with a normal texture that lies askew on it, and targets that move it.
    static Document documentOf(const Sheet& sheet, const std::vector<Sheet>& targets) {
        Document document = triangle();
        std::vector<float> uv;
        std::vector<std::uint16_t> indices;
        for (int y = 0; y <= kCells; ++y) {
            for (int x = 0; x <= kCells; ++x) {
                uv.insert(uv.end(), {static_cast<float>(x + 0.3 * y), static_cast<float>(-0.8 * y)});
                if (x < kCells && y < kCells) {
                    const int at = y * (kCells + 1) + x;
                    for (const int corner : {0, 1, kCells + 2, 0, kCells + 2, kCells + 1}) {
                        indices.push_back(static_cast<std::uint16_t>(at + corner));
                    }
                }
            }
        }
        json& primitive = document.primitive();
        const auto add = [&](const std::vector<glm::dvec3>& vectors) {
            return document.addAccessor(floatsOf(vectors), "VEC3", kFloat);
        };
        primitive["attributes"] = {{"POSITION", add(sheet.positions)},
                                   {"NORMAL", add(sheet.normals)},
                                   {"TEXCOORD_0", document.addAccessor(uv, "VEC2", kFloat)}};
        primitive["indices"] = document.addAccessor(indices, "SCALAR", kUShort);
        for (const Sheet& target : targets) {
            primitive["targets"].push_back(
                {{"POSITION", add(target.positions)}, {"NORMAL", add(target.normals)}});
        }
        giveNormalTexture(document);
        return document;
    }

    Mesh meshOf(const Document& document) const { return load(document).scene.meshes.at(0); }

    /// The largest angle between tangents of a sheet with targets and those that its deformed form would get by itself.
    double errorAt(const std::vector<Sheet>& shapes, const std::vector<double>& weights) const {
        Sheet deformed = shapes.front();
        std::vector<Sheet> targets;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            targets.push_back(shapes[i + 1] - shapes.front());
            for (std::size_t v = 0; v < deformed.positions.size(); ++v) {
                deformed.positions[v] += weights[i] * targets[i].positions[v];
                deformed.normals[v] += weights[i] * targets[i].normals[v];
            }
        }
        for (glm::dvec3& normal : deformed.normals) {
            normal = glm::normalize(normal);
        }
        Document document = documentOf(shapes.front(), targets);
        document.root["meshes"][0]["weights"] = weights;
        const Mesh made = meshOf(document);
        const Mesh truth = meshOf(documentOf(deformed, {}));
        EXPECT_FALSE(truth.details.empty());
        EXPECT_EQ(made.details.size(), truth.details.size());
        double error = 0.0;
        for (std::size_t i = 0; i < std::min(made.details.size(), truth.details.size()); ++i) {
            const glm::dvec4 is(made.details[i].tangent);
            const glm::dvec4 was(truth.details[i].tangent);
            EXPECT_EQ(is.w, was.w);
            const double half = 0.5 * glm::distance(glm::dvec3(is), glm::dvec3(was));
            // Roundings make opposite ones a little more than 2 apart.
            error = cdr::test::worseOf(error, 2.0 * std::asin(half > 1.0 ? 1.0 : half));
        }
        return error;
    }
};

TEST_F(GltfMorphedTangents, OneTargetInFullGivesTheTangentsOfItsMesh) {
    const std::vector<Sheet> shapes{sheetOf(wave), sheetOf(cylinder), sheetOf(sheared)};
    EXPECT_LT(errorAt(shapes, {1.0, 0.0}), 1e-3);
    EXPECT_LT(errorAt(shapes, {0.0, 1.0}), 1e-3);
}

TEST_F(GltfMorphedTangents, BetweenTargetsTheyAreNear) {
    const std::vector<Sheet> shapes{sheetOf(wave), sheetOf(cylinder), sheetOf(sheared)};
    for (const double weight : {0.2, 0.5, 0.8}) {
        EXPECT_LT(errorAt(shapes, {weight, 0.0}), 0.05) << weight;
        EXPECT_LT(errorAt(shapes, {0.0, weight}), 0.05) << weight;
    }
    for (const double bent : {0.2, 0.4, 0.5}) {
        EXPECT_LT(errorAt(shapes, {bent, 1.0 - bent}), 0.12) << bent;
    }
}

/// A target that moves all of a plane alike changes all its tangents alike.
TEST_F(GltfMorphedTangents, APlaneIsExactAtAllWeights) {
    const Surface plane = [](double u, double v) { return glm::dvec3(u, v, 0.0); };
    const Surface turned = [](double u, double v) { return glm::dvec3(u - v, 3.0 * u + 0.2 * v, 0.0); };
    const std::vector<Sheet> shapes{sheetOf(plane), sheetOf(turned)};
    for (const double weight : {0.1, 0.5, 0.9, 1.3}) {
        EXPECT_LT(errorAt(shapes, {weight}), 1e-5) << weight;
    }
}

TEST_F(GltfMorphedTangents, WhatNoTargetMovesKeepsItsTangents) {
    const Sheet rest = sheetOf(wave);
    Sheet corner = rest;
    corner.positions.front() += glm::dvec3(-0.2, 0.3, 0.4);
    const Mesh before = meshOf(documentOf(rest, {}));
    Document document = documentOf(rest, {corner - rest});
    document.root["meshes"][0]["weights"] = {1.0};
    const Mesh after = meshOf(document);
    ASSERT_EQ(after.details.size(), before.details.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < after.details.size(); ++i) {
        changed += glm::distance(after.details[i].tangent, before.details[i].tangent) <= 1e-6f ? 0 : 1;
    }
    EXPECT_EQ(changed, 4u); // the corners of the two triangles at that vertex
}

/// Without normals each triangle has vertices of its own, whose normals follow from where they are.
TEST_F(GltfMorphedTangents, FlatTrianglesFollowTheirCorners) {
    const std::vector<Sheet> shapes{sheetOf(wave), sheetOf(cylinder)};
    Document document = documentOf(shapes[0], {shapes[1] - shapes[0]});
    document.primitive()["attributes"].erase("NORMAL");
    document.root["meshes"][0]["weights"] = {1.0};
    const Mesh made = meshOf(document);
    Document deformed = documentOf(shapes[1], {});
    deformed.primitive()["attributes"].erase("NORMAL");
    const Mesh truth = meshOf(deformed);
    ASSERT_FALSE(truth.details.empty());
    ASSERT_EQ(made.details.size(), truth.details.size());
    double farthest = 0.0;
    for (std::size_t i = 0; i < made.details.size(); ++i) {
        const float apart = glm::distance(made.details[i].tangent, truth.details[i].tangent);
        farthest = cdr::test::worseOf(farthest, double{apart});
    }
    EXPECT_LT(farthest, 1e-3);
}

/// glTF: without normals the tangents of a file do not count. So those of targets do not either.
TEST_F(GltfMorphedTangents, WithoutNormalsTangentsOfTargetsDoNotCount) {
    const Sheet rest = sheetOf(wave);
    Document document = documentOf(rest, {});
    document.primitive()["attributes"].erase("NORMAL");
    const Mesh before = meshOf(document);
    const std::vector<float> tangents(4 * rest.positions.size(), 1.0f);
    const std::vector<float> deltas(3 * rest.positions.size(), 5.0f);
    document.setFloats("TANGENT", "VEC4", tangents);
    document.primitive()["targets"] = {{{"TANGENT", document.addAccessor(deltas, "VEC3", kFloat)}}};
    document.root["meshes"][0]["weights"] = {1.0};
    const Mesh after = meshOf(document);
    ASSERT_FALSE(before.details.empty());
    ASSERT_EQ(after.details.size(), before.details.size());
    for (std::size_t i = 0; i < after.details.size(); ++i) {
        EXPECT_LT(glm::distance(after.details[i].tangent, before.details[i].tangent), 1e-6f) << i;
    }
}

} // namespace
} // namespace cdr::scene::test
