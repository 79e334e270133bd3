#include "animations.h"

#include "../checks.h"
#include "../json.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cdr::scene::gltf {

namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 4> kPaths{"translation", "rotation", "scale", "weights"};
constexpr std::array<std::string_view, 3> kInterpolations{"STEP", "LINEAR", "CUBICSPLINE"};

std::optional<AnimatedPath> pathOf(const json& target) {
    return valueOf<AnimatedPath>(kPaths, stringMember(target, "path").value_or(""));
}

Interpolation interpolationOf(const json& sampler, const std::string& where) {
    const std::string name = stringMember(sampler, "interpolation").value_or("LINEAR");
    if (const auto interpolation = valueOf<Interpolation>(kInterpolations, name)) {
        return *interpolation;
    }
    refuse("{}: interpolation '{}' does not exist", where, oneLine(name, kMaxNameLength));
}

/// Calls back with each channel's path and the node it names; channels without a node are for extensions.
template <typename Take>
void forEachTarget(const json& root, Take take) {
    for (const json& animation : arrayMember(root, "animations")) {
        for (const json& channel : arrayMember(animation, "channels")) {
            const json& target = objectMember(channel, "target", "a channel");
            if (const auto node = indexMember(target, "node")) {
                itemAt(root, "nodes", *node, "node");
                take(static_cast<std::size_t>(*node), pathOf(target));
            }
        }
    }
}

/// Reads one animation.
class AnimationReader {
  public:
    AnimationReader(const json& source, std::string where, Accessors& accessors, const FileRig& rig,
                    MemoryPrediction& memory, Notes& notes)
        : m_source(source),
          m_where(std::move(where)),
          m_accessors(accessors),
          m_rig(rig),
          m_memory(memory),
          m_notes(notes) {}

    Animation read() {
        m_animation.name = oneLine(fullNameOf(m_source), kMaxNameLength);
        for (const json& channel : arrayMember(m_source, "channels")) {
            addChannel(channel);
        }
        if (!m_animation.fault.empty()) {
            m_notes.add("it cannot be played, because times of its keyframes are unsound", m_where);
            m_animation.seconds = 0.0;
            m_animation.keyframes.clear();
            m_animation.channels.clear();
        }
        return std::move(m_animation);
    }

  private:
    void addChannel(const json& channel);
    std::size_t keyframesOf(int index, AnimatedPath path, std::size_t width);
    std::vector<float> timesOf(const json& sampler, const std::string& where);
    std::vector<float> valuesOf(const json& sampler, const Keyframes& keyframes, AnimatedPath path,
                                const std::string& where);

    const json& m_source;
    std::string m_where;
    Accessors& m_accessors;
    const FileRig& m_rig;
    MemoryPrediction& m_memory;
    Notes& m_notes;
    Animation m_animation;
    std::map<std::pair<int, std::pair<AnimatedPath, std::size_t>>, std::size_t>
        m_read; ///< by sampler and use
};

void AnimationReader::addChannel(const json& channel) {
    const json& target = objectMember(channel, "target", m_where);
    const auto fileNode = indexMember(target, "node");
    const auto path = pathOf(target);
    if (!fileNode || !path) {
        m_notes.add("a channel moves what is no part of a node", m_where);
        return;
    }
    const std::size_t node = m_rig.nodeOf[static_cast<std::size_t>(*fileNode)].value();
    const RigNode& moved = m_rig.rig.nodes[node];
    if (moved.matrix && *path != AnimatedPath::weights) {
        m_notes.add("a channel moves a node that is given as a matrix, which stays", m_where);
        return;
    }
    if (*path == AnimatedPath::weights && moved.weightCount == 0) {
        m_notes.add("a channel changes weights of a node without morph targets", m_where);
        return;
    }
    const std::size_t width = *path == AnimatedPath::weights    ? moved.weightCount
                              : *path == AnimatedPath::rotation ? 4
                                                                : 3;
    const std::size_t keyframes = keyframesOf(requiredIndex(channel, "sampler", m_where), *path, width);
    m_animation.channels.push_back({.keyframes = keyframes, .node = node, .path = *path});
}

std::size_t AnimationReader::keyframesOf(int index, AnimatedPath path, std::size_t width) {
    const auto [found, isNew] = m_read.try_emplace({index, {path, width}}, m_animation.keyframes.size());
    if (!isNew) {
        return found->second;
    }
    const std::string where = fmt::format("{} sampler {}", m_where, index);
    const json& sampler = itemAt(m_source, "samplers", index, "sampler");
    Keyframes keyframes;
    keyframes.interpolation = interpolationOf(sampler, where);
    keyframes.width = width;
    keyframes.times = timesOf(sampler, where);
    keyframes.values = valuesOf(sampler, keyframes, path, where);
    m_animation.seconds = std::max(m_animation.seconds, static_cast<double>(keyframes.times.back()));
    m_animation.keyframes.push_back(std::move(keyframes));
    return found->second;
}

std::vector<float> AnimationReader::timesOf(const json& sampler, const std::string& where) {
    const Accessor& accessor = m_accessors.at(requiredIndex(sampler, "input", where));
    if (accessor.components() != 1 || accessor.count() == 0) {
        refuse("{}: its times are no list of numbers", where);
    }
    m_memory.add({.kept = accessor.count() * sizeof(float)}, where);
    std::vector<float> times;
    times.reserve(accessor.count());
    for (std::size_t i = 0; i < accessor.count(); ++i) {
        const float time = accessor.vector(i).x;
        const bool isNext = std::isfinite(time) && (i == 0 || time > times.back());
        if (m_animation.fault.empty() && (time < 0.0f || !isNext)) {
            m_animation.fault =
                fmt::format("{}: its time {} is {}", where, i,
                            time < 0.0f ? "negative" : "not finite, or does not come after the one before");
        }
        times.push_back(time);
    }
    return times;
}

std::vector<float> AnimationReader::valuesOf(const json& sampler, const Keyframes& keyframes,
                                             AnimatedPath path, const std::string& where) {
    const Accessor& accessor = m_accessors.at(requiredIndex(sampler, "output", where));
    const std::size_t parts = keyframes.interpolation == Interpolation::cubicSpline ? 3 : 1;
    const bool isScalar = path == AnimatedPath::weights;
    const std::size_t components = isScalar ? 1 : keyframes.width;
    const std::size_t elements = keyframes.times.size() * parts * (isScalar ? keyframes.width : 1);
    if (static_cast<std::size_t>(accessor.components()) != components || accessor.count() != elements) {
        refuse("{}: {} elements of {} components where {} of {} are needed", where, accessor.count(),
               accessor.components(), elements, components);
    }
    m_memory.add({.kept = elements * components * sizeof(float)}, where);
    std::vector<float> values;
    values.reserve(elements * components);
    for (std::size_t i = 0; i < elements; ++i) {
        const glm::vec4 value = accessor.vector(i);
        for (std::size_t c = 0; c < components; ++c) {
            const float number = value[static_cast<glm::length_t>(c)];
            if (!std::isfinite(number)) {
                refuse("{}: its value {} is not finite", where, i);
            }
            values.push_back(number);
        }
        const bool isRotation = components == 4 && i % parts == parts / 2;
        if (isRotation && value == glm::vec4(0.0f)) {
            refuse("{}: its rotation {} has no direction", where, i);
        }
    }
    return values;
}

} // namespace

std::vector<bool> animatedNodes(const json& root) {
    std::vector<bool> animated(arrayMember(root, "nodes").size());
    forEachTarget(root, [&](std::size_t node, std::optional<AnimatedPath>) { animated[node] = true; });
    return animated;
}

std::vector<bool> morphedNodes(const json& root) {
    std::vector<bool> morphed(arrayMember(root, "nodes").size());
    forEachTarget(root, [&](std::size_t node, std::optional<AnimatedPath> path) {
        morphed[node] = morphed[node] || path == AnimatedPath::weights;
    });
    return morphed;
}

std::vector<Animation> readAnimations(const json& root, Accessors& accessors, const FileRig& rig,
                                      MemoryPrediction& memory, Notes& notes) {
    std::vector<Animation> animations;
    for (const json& source : arrayMember(root, "animations")) {
        const std::string where = fmt::format("animation {} '{}'", animations.size(), nameOf(source));
        animations.push_back(AnimationReader(source, where, accessors, rig, memory, notes).read());
    }
    return animations;
}

} // namespace cdr::scene::gltf
