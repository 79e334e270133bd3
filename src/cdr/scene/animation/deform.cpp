#include <cdr/base/error.h>
#include <cdr/scene/animation/deform.h>
#include <cdr/scene/box_tree.h>

#include <algorithm>
#include <cmath>

namespace cdr::scene {

namespace {

/// A vertex in float64 on its way.
struct Point {
    glm::dvec3 position;
    glm::dvec3 normal;
    glm::dvec4 tangent; ///< as VertexDetail::tangent
};

glm::dvec3 normalizedOr(const glm::dvec3& v, const glm::dvec3& fallback) {
    const double length = glm::length(v);
    return length > 0.0 && std::isfinite(length) ? v / length : fallback;
}

/// What turns normals as `matrix` turns surfaces, up to a positive factor.
glm::dmat3 normalMatrixOf(const glm::dmat3& matrix) {
    const glm::dmat3 cofactors(glm::cross(matrix[1], matrix[2]), glm::cross(matrix[2], matrix[0]),
                               glm::cross(matrix[0], matrix[1]));
    return glm::determinant(matrix) < 0.0 ? -cofactors : cofactors;
}

/// Tangents turn as edges do; a mirror turns round how the bitangent points.
glm::dvec4 turnedTangent(const glm::dmat3& matrix, const glm::dvec4& tangent) {
    return {matrix * glm::dvec3(tangent), glm::determinant(matrix) < 0.0 ? -tangent.w : tangent.w};
}

void morph(const Deformer& deformer, std::span<const double> weights, std::size_t first,
           std::span<Point> points) {
    for (std::size_t target = 0; target < std::min(weights.size(), deformer.targets.size()); ++target) {
        if (weights[target] == 0.0) {
            continue;
        }
        const std::vector<MorphDelta>& deltas = deformer.targets[target];
        auto delta = std::ranges::lower_bound(deltas, first, {}, &MorphDelta::vertex);
        for (; delta != deltas.end() && delta->vertex < first + points.size(); ++delta) {
            Point& point = points[delta->vertex - first];
            point.position += weights[target] * glm::dvec3(delta->position);
            point.normal += weights[target] * glm::dvec3(delta->normal);
            point.tangent += weights[target] * glm::dvec4(glm::dvec3(delta->tangent), 0.0);
        }
    }
    if (deformer.derivedTangents && !deformer.isFlat) {
        for (Point& point : points) {
            const glm::dvec3 normal = normalizedOr(point.normal, glm::dvec3(0.0));
            point.tangent -= glm::dvec4(normal * glm::dot(normal, glm::dvec3(point.tangent)), 0.0);
        }
    }
}

glm::dmat4 blended(const Deformer& deformer, std::span<const glm::dmat4> joints, std::size_t vertex) {
    glm::dmat4 matrix(0.0);
    for (std::size_t i = deformer.firstInfluence[vertex]; i < deformer.firstInfluence[vertex + 1]; ++i) {
        matrix += static_cast<double>(deformer.influences[i].weight) * joints[deformer.influences[i].joint];
    }
    return matrix;
}

/// Calls `visit` with each vertex and what joints do to it.
template <typename Visit>
void forEachInfluence(const Deformer& deformer, const Visit& visit) {
    for (std::size_t vertex = 0; vertex + 1 < deformer.firstInfluence.size(); ++vertex) {
        for (std::size_t i = deformer.firstInfluence[vertex]; i < deformer.firstInfluence[vertex + 1]; ++i) {
            visit(glm::dvec3(deformer.vertices[vertex].position), deformer.influences[i]);
        }
    }
}

/// What is not a number stays, and must not get lost in a comparison.
double largerOrNan(double a, double b) {
    return std::isnan(a) || b <= a ? a : b;
}

void measureJoints(Deformer& deformer) {
    std::vector<Box> boxes;
    forEachInfluence(deformer, [&](const glm::dvec3& position, const Influence& influence) {
        boxes.resize(std::max<std::size_t>(boxes.size(), influence.joint + std::size_t{1}));
        boxes[influence.joint].add(position);
    });
    std::vector<double> radii(boxes.size());
    forEachInfluence(deformer, [&](const glm::dvec3& position, const Influence& influence) {
        double& radius = radii[influence.joint];
        radius = largerOrNan(radius, glm::length(position - boxes[influence.joint].centre()));
    });
    deformer.jointReaches.clear();
    for (std::uint32_t joint = 0; joint < boxes.size(); ++joint) {
        if (!boxes[joint].isEmpty()) {
            deformer.jointReaches.push_back(
                {.joint = joint, .centre = boxes[joint].centre(), .radius = radii[joint]});
        }
    }
}

/// What bounds of poses are made from.
void measureReaches(Deformer& deformer) {
    deformer.reach = 0.0;
    for (const Vertex& vertex : deformer.vertices) {
        deformer.reach =
            largerOrNan(deformer.reach, glm::length(glm::dvec3(vertex.position) - deformer.centre));
    }
    deformer.targetReach.clear();
    for (const std::vector<MorphDelta>& target : deformer.targets) {
        double most = 0.0;
        for (const MorphDelta& delta : target) {
            most = largerOrNan(most, glm::length(glm::dvec3(delta.position)));
        }
        deformer.targetReach.push_back(most);
    }
    measureJoints(deformer);
    deformer.weightError = 0.0;
    deformer.weightSize = 0.0;
    for (std::size_t vertex = 0; vertex + 1 < deformer.firstInfluence.size(); ++vertex) {
        double sum = 0.0;
        double size = 0.0;
        for (std::size_t i = deformer.firstInfluence[vertex]; i < deformer.firstInfluence[vertex + 1]; ++i) {
            const auto weight = static_cast<double>(deformer.influences[i].weight);
            sum += weight;
            size += std::abs(weight);
        }
        deformer.weightSize = largerOrNan(deformer.weightSize, size);
        deformer.weightError = largerOrNan(deformer.weightError, std::abs(sum - 1.0));
    }
}

} // namespace

bool hasInfluencesByVertex(const Deformer& deformer) {
    const std::vector<std::size_t>& first = deformer.firstInfluence;
    if (first.empty()) {
        return deformer.influences.empty();
    }
    return first.size() == deformer.vertices.size() + 1 && first.front() == 0 &&
           first.back() == deformer.influences.size() && std::is_sorted(first.begin(), first.end());
}

void finish(Deformer& deformer) {
    if (!hasInfluencesByVertex(deformer)) {
        throw base::InputError(
            "the firstInfluence of a deformer must divide its influences among its vertices");
    }
    Box box;
    for (const Vertex& vertex : deformer.vertices) {
        box.add(glm::dvec3(vertex.position));
    }
    deformer.centre = box.centre();
    std::vector<double> weightOf;
    for (const Influence& influence : deformer.influences) {
        weightOf.resize(std::max<std::size_t>(weightOf.size(), influence.joint + std::size_t{1}));
        weightOf[influence.joint] += static_cast<double>(influence.weight);
    }
    deformer.anchor = static_cast<std::uint32_t>(std::ranges::max_element(weightOf) - weightOf.begin());
    measureReaches(deformer);
}

DeformedPlace placeOf(const Deformer& deformer, const glm::dmat4& toWorld) {
    return {.position = glm::dvec3(toWorld * glm::dvec4(deformer.centre, 1.0)), .basis = glm::dmat3(toWorld)};
}

DeformedPlace placeOf(const Deformer& deformer, std::span<const glm::dmat4> joints) {
    const glm::dmat4& anchor = joints[deformer.anchor];
    // Joints that mirror turn front faces into back faces, unless the instance mirrors them.
    const bool mirrors = glm::determinant(glm::dmat3(anchor)) < 0.0;
    return {.position = glm::dvec3(anchor * glm::dvec4(deformer.centre, 1.0)),
            .basis = mirrors ? glm::dmat3(glm::dvec3(-1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0),
                                          glm::dvec3(0.0, 0.0, 1.0))
                             : glm::dmat3(1.0)};
}

void deform(const Deformer& deformer, const Deformation& deformation, std::size_t first, std::size_t last,
            MeshVertices& deformed) {
    const DeformedPlace& place = deformation.place;
    std::vector<Point> points;
    points.reserve(last - first);
    for (std::size_t i = first; i < last; ++i) {
        const glm::vec4 tangent = deformer.details.empty() ? glm::vec4(0.0f) : deformer.details[i].tangent;
        points.push_back({glm::dvec3(deformer.vertices[i].position), glm::dvec3(deformer.vertices[i].normal),
                          glm::dvec4(tangent)});
    }
    morph(deformer, deformation.weights, first, points);
    for (std::size_t i = first; i < last; ++i) {
        Point& point = points[i - first];
        if (deformation.joints.empty()) {
            point.position -= deformer.centre;
        } else {
            // The basis is the identity or a mirror, each its own inverse.
            const glm::dmat4 matrix = blended(deformer, deformation.joints, i);
            const glm::dvec3 world(matrix * glm::dvec4(point.position, 1.0));
            point.position = place.basis * (world - place.position);
            point.normal = place.basis * (normalMatrixOf(glm::dmat3(matrix)) * point.normal);
            point.tangent = turnedTangent(place.basis * glm::dmat3(matrix), point.tangent);
        }
        Vertex& vertex = deformed.vertices[i];
        vertex = deformer.vertices[i];
        vertex.position = glm::vec3(point.position);
        vertex.normal = glm::vec3(normalizedOr(point.normal, glm::dvec3(vertex.normal)));
        if (!deformer.details.empty()) {
            const glm::vec4& atRest = deformer.details[i].tangent;
            deformed.details[i] = deformer.details[i];
            deformed.details[i].tangent =
                glm::vec4(glm::vec3(normalizedOr(glm::dvec3(point.tangent), glm::dvec3(atRest))),
                          static_cast<float>(point.tangent.w));
        }
    }
}

void setFlatNormals(const Deformer& deformer, std::span<Vertex> deformed) {
    for (std::size_t i = 0; deformer.isFlat && i + 2 < deformed.size(); i += 3) {
        const glm::dvec3 a(deformed[i].position);
        const glm::dvec3 b(deformed[i + 1].position);
        const glm::dvec3 c(deformed[i + 2].position);
        const glm::vec3 normal(
            normalizedOr(glm::cross(b - a, c - a), glm::dvec3(deformer.vertices[i].normal)));
        deformed[i].normal = deformed[i + 1].normal = deformed[i + 2].normal = normal;
    }
}

} // namespace cdr::scene
