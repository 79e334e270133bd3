#include <cdr/base/error.h>
#include <cdr/render/output/motion_history.h>
#include <cdr/render/upload/last_vertices.h>
#include <cdr/scene/world/change_log.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

/// Whether one move of all that belongs together brings both where they were.
bool moveAsOne(const MovedObject& a, const MovedObject& b) {
    const glm::dmat3 turn = glm::dmat3(a.before.basis) * glm::inverse(glm::dmat3(a.now.basis));
    const glm::dmat3 basis = turn * glm::dmat3(b.now.basis);
    const glm::dvec3 apart = b.now.position - a.now.position;
    const glm::dvec3 off = (b.before.position - a.before.position) - turn * apart;
    const double most = kApart * glm::length(apart) + 1e-15 * glm::length(a.before.position);
    return largest(glm::dmat3(b.before.basis) - basis) <= kApart * largest(basis) && glm::length(off) <= most;
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
        if (!areAll || !std::all_of(first, end, [&](const MovedObject& other) {
                return &other == &*first || moveAsOne(*first, other);
            })) {
            throw base::InputError(fmt::format("motion needs each object to move as one, and instances of "
                                               "object {} moved apart",
                                               first->object));
        }
        objects.push_back(*first);
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
    try {
        motion.moved = oncePerObject(std::move(changed.moved), m_instances);
    } catch (const base::InputError&) {
        forget();
        throw;
    }
    motion.deformed = std::move(changed.deformed);
    for (const std::uint32_t object : changed.added) {
        m_instances.resize(std::max<std::size_t>(m_instances.size(), object + std::size_t{1}));
        ++m_instances[object];
    }
    return motion;
}

void MotionHistory::forget() {
    *this = {};
}

} // namespace cdr::render
