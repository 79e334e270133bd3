#include <cdr/base/format_error.h>
#include <cdr/render/output/motion_history.h>
#include <cdr/render/upload/last_vertices.h>
#include <cdr/scene/world/change_log.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace cdr::render {

namespace {

/// Bases are float32, so a part may lie off where the others' turn brings it by this share of its distance to them.
constexpr double kApart = 1e-6;

double largest(const glm::dmat3& matrix) {
    double most = 0.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            most = std::max(most, std::abs(matrix[column][row]));
        }
    }
    return most;
}

bool isTurned(const MovedObject& moved) {
    return moved.before.basis != moved.now.basis;
}

/// How many times less exact a turn is that is found by this basis than the basis. Infinite where it is flat.
double conditionOf(const glm::mat3& basis) {
    const glm::dmat3 exact(basis);
    return glm::determinant(exact) == 0.0 ? std::numeric_limits<double>::infinity()
                                          : largest(exact) * largest(glm::inverse(exact));
}

/// How parts of an object moved, told by one of them.
struct CommonMove {
    const MovedObject& part;
    double condition = 1.0;
    glm::dmat3 turn{1.0};
};

/// By the part that tells it best. No turn where no part turned.
CommonMove commonMove(std::span<const MovedObject> parts) {
    if (std::none_of(parts.begin(), parts.end(), isTurned)) {
        return {.part = parts.front()};
    }
    const auto best = std::ranges::min_element(parts, [](const MovedObject& a, const MovedObject& b) {
        return conditionOf(a.now.basis) < conditionOf(b.now.basis);
    });
    return {.part = *best,
            .condition = conditionOf(best->now.basis),
            .turn = glm::dmat3(best->before.basis) * glm::inverse(glm::dmat3(best->now.basis))};
}

/// Whether that move brings a part where it was. Where all parts are flat and turned, none tells how the others moved.
bool isOfMove(const CommonMove& move, const MovedObject& part) {
    if (!std::isfinite(move.condition)) {
        return true;
    }
    const double allowed = kApart * move.condition;
    const glm::dmat3 basis = move.turn * glm::dmat3(part.now.basis);
    const glm::dvec3 apart = part.now.position - move.part.now.position;
    const glm::dvec3 apartBefore = move.turn * apart;
    const glm::dvec3 off = (part.before.position - move.part.before.position) - apartBefore;
    const double most =
        allowed * std::max(glm::length(apart), glm::length(apartBefore)) +
        1e-15 * (glm::length(move.part.before.position) + glm::length(move.turn * move.part.now.position));
    return largest(glm::dmat3(part.before.basis) - basis) <= allowed * largest(basis) &&
           glm::length(off) <= most;
}

/// Brings the instances of each object together, all of which must have moved alike.
/// @param instances by object: how many were there before and still are
std::vector<MovedObject> oncePerObject(std::vector<MovedObject> moved,
                                       std::span<const std::uint32_t> instances) {
    const auto comesFirst = [](const MovedObject& a, const MovedObject& b) { return a.object < b.object; };
    if (!std::is_sorted(moved.begin(), moved.end(), comesFirst)) {
        std::stable_sort(moved.begin(), moved.end(), comesFirst);
    }
    std::vector<MovedObject> objects;
    for (auto first = moved.begin(); first != moved.end();) {
        const auto end = std::find_if(
            first, moved.end(), [&](const MovedObject& other) { return other.object != first->object; });
        const bool areAll = static_cast<std::uint32_t>(end - first) == instances[first->object];
        const CommonMove move = commonMove({first, end});
        if (!areAll || !std::all_of(first, end, [&](const MovedObject& part) {
                return &part == &move.part || isOfMove(move, part);
            })) {
            throw base::inputError("motion needs each object to move as one, and instances of "
                                   "object {} moved apart",
                                   first->object);
        }
        objects.push_back(move.part);
        first = end;
    }
    return objects;
}

} // namespace

MotionHistory::Place MotionHistory::placeOf(const DrawnScene& drawn, std::size_t instance) {
    const scene::Instances& instances = drawn.scene.instances;
    return {.transform = {.position = instances.position(instance), .basis = instances.basis[instance]},
            .object = instances.object[instance],
            .generation = drawn.uploaded.generation(instance)};
}

void MotionHistory::look(const DrawnScene& drawn, std::size_t instance, Changed& changed) {
    Place& before = m_places[instance];
    if (before.seen == m_frame) {
        return; // it changed more than once
    }
    Place now = placeOf(drawn, instance);
    now.seen = m_frame;
    const bool isSame = now.generation == before.generation && now.object == before.object;
    if (isSame && now.generation != 0 && now.transform != before.transform) {
        changed.moved.push_back({now.object, before.transform, now.transform});
    }
    if (isSame && now.generation != 0 && changed.lastVertices != nullptr &&
        changed.lastVertices->firstOf(drawn.scene.instances.mesh[instance])) {
        changed.deformed.push_back({static_cast<std::uint32_t>(instance), before.transform});
    }
    if (!isSame && before.generation != 0) {
        --m_instances[before.object];
    }
    if (!isSame && now.generation != 0) {
        changed.added.push_back(now.object);
    }
    before = now;
}

FrameMotion MotionHistory::follow(const DrawnScene& drawn, const scene::Camera& camera) {
    try {
        return motionSinceLast(drawn, camera);
    } catch (...) { // refused, or without memory half-way: the next frame is as a first one
        forget();
        throw;
    }
}

FrameMotion MotionHistory::motionSinceLast(const DrawnScene& drawn, const scene::Camera& camera) {
    if (const std::uint64_t replaced = drawn.uploaded.instanceChanges().replaced(); replaced != m_replaced) {
        forget(); // another world took the place of the one before: its places hold other things
        m_replaced = replaced;
    }
    ++m_frame;
    FrameMotion motion{.cameraBefore = m_camera.value_or(camera), .moved = {}, .deformed = {}};
    m_camera = camera;
    if (!drawn.uploaded.isLive()) {
        return motion;
    }
    const scene::ChangeLog& changes = drawn.uploaded.instanceChanges();
    const bool isFirst = m_places.empty();
    const auto places = isFirst ? std::nullopt : changes.since(m_followed);
    m_followed = changes.end();
    m_places.resize(drawn.scene.instances.size());
    const std::uint64_t verticesBefore = std::exchange(m_vertices, drawn.uploaded.verticesRevision());
    Changed changed{.lastVertices =
                        m_vertices == verticesBefore + 1 ? &drawn.uploaded.lastVertices() : nullptr};
    if (places) {
        for (const std::uint32_t instance : *places) {
            look(drawn, instance, changed);
        }
    } else {
        for (std::size_t instance = 0; instance < m_places.size(); ++instance) {
            look(drawn, instance, changed);
        }
    }
    motion.moved = oncePerObject(std::move(changed.moved), m_instances);
    motion.deformed = std::move(changed.deformed);
    for (const std::uint32_t object : changed.added) {
        m_instances.resize(std::max<std::size_t>(m_instances.size(), object + std::size_t{1}));
        ++m_instances[object];
    }
    return motion;
}

} // namespace cdr::render
