#include <cdr/render/upload/deformer_words.h>
#include <cdr/render/upload/scene_meshes.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <bit>
#include <tuple>

namespace cdr::render {

namespace {

using scene::Deformer;

constexpr std::size_t kNumbersPerJoint = 16;

/// Appends to the words of a deformer.
class WordWriter {
  public:
    explicit WordWriter(std::vector<std::uint32_t>& words) : m_words(words) {}

    std::uint32_t end() const { return static_cast<std::uint32_t>(m_words.size()); }
    void add(std::uint32_t word) { m_words.push_back(word); }
    void add(float number) { add(std::bit_cast<std::uint32_t>(number)); }
    template <glm::length_t L>
    void add(const glm::vec<L, float>& numbers) {
        for (glm::length_t i = 0; i < L; ++i) {
            add(numbers[i]);
        }
    }

  private:
    std::vector<std::uint32_t>& m_words;
};

/// A delta of one of the targets.
struct TargetDelta {
    std::uint32_t target = 0;
    const scene::MorphDelta* delta = nullptr;
};

/// By vertex, and the targets of each ascending: the order in which the CPU adds them.
std::vector<TargetDelta> deltasByVertex(const Deformer& deformer) {
    std::vector<TargetDelta> deltas;
    for (std::uint32_t target = 0; target < deformer.targets.size(); ++target) {
        for (const scene::MorphDelta& delta : deformer.targets[target]) {
            deltas.push_back({target, &delta});
        }
    }
    std::ranges::stable_sort(
        deltas, [](const TargetDelta& a, const TargetDelta& b) { return a.delta->vertex < b.delta->vertex; });
    return deltas;
}

void addRest(const Deformer& deformer, WordWriter& words) {
    for (std::size_t i = 0; i < deformer.vertices.size(); ++i) {
        words.add(deformer.vertices[i].position);
        words.add(deformer.vertices[i].normal);
        words.add(deformer.details.empty() ? glm::vec4(0.0f) : deformer.details[i].tangent);
    }
}

void addInfluences(const Deformer& deformer, WordWriter& words, shaders::DeformPush& push) {
    push.firstInfluences = words.end();
    for (const std::size_t first : deformer.firstInfluence) {
        words.add(static_cast<std::uint32_t>(first));
    }
    push.influences = words.end();
    for (const scene::Influence& influence : deformer.influences) {
        words.add(influence.joint);
        words.add(influence.weight);
    }
}

void addDeltas(const Deformer& deformer, WordWriter& words, shaders::DeformPush& push) {
    const std::vector<TargetDelta> deltas = deltasByVertex(deformer);
    push.firstDeltas = words.end();
    std::size_t next = 0;
    for (std::size_t vertex = 0; vertex <= deformer.vertices.size(); ++vertex) {
        while (next < deltas.size() && deltas[next].delta->vertex < vertex) {
            ++next;
        }
        words.add(static_cast<std::uint32_t>(next));
    }
    push.deltas = words.end();
    for (const auto& [target, delta] : deltas) {
        words.add(target);
        words.add(delta->position);
        words.add(delta->normal);
        words.add(delta->tangent);
    }
}

bool followAlike(const Deformer& deformer, std::uint32_t a, std::uint32_t b) {
    if (deformer.firstInfluence.empty()) {
        return true;
    }
    const auto influences = [&](std::uint32_t vertex) {
        const std::size_t first = deformer.firstInfluence[vertex];
        return std::span(deformer.influences).subspan(first, deformer.firstInfluence[vertex + 1] - first);
    };
    return std::equal(influences(a).begin(), influences(a).end(), influences(b).begin(), influences(b).end(),
                      [](const scene::Influence& one, const scene::Influence& other) {
                          return one.joint == other.joint && one.weight == other.weight;
                      });
}

std::size_t weightsOf(const scene::MeshPose& pose) {
    return std::min(pose.weights.size(), pose.deformer->targets.size());
}

} // namespace

std::uint64_t countWords(const Deformer& deformer) {
    std::uint64_t deltas = 0;
    for (const std::vector<scene::MorphDelta>& target : deformer.targets) {
        deltas += target.size();
    }
    return std::uint64_t{shaders::kRestWords} * deformer.vertices.size() + deformer.firstInfluence.size() +
           std::uint64_t{2} * deformer.influences.size() + deformer.vertices.size() + 1 +
           shaders::kDeltaWords * deltas;
}

DeformerWords wordsOf(const Deformer& deformer) {
    DeformerWords made;
    made.words.reserve(static_cast<std::size_t>(countWords(deformer)));
    WordWriter words(made.words);
    made.push.vertices = static_cast<std::uint32_t>(deformer.vertices.size());
    made.push.flags = deformer.isFlat ? shaders::kDeformFlat : 0u;
    if (deformer.derivedTangents && !deformer.isFlat) {
        made.push.flags |= shaders::kDeformDerived;
    }
    addRest(deformer, words);
    addInfluences(deformer, words, made.push);
    addDeltas(deformer, words, made.push);
    return made;
}

std::size_t countNumbers(const scene::MeshPose& pose) {
    return shaders::kPlaceNumbers + weightsOf(pose) + kNumbersPerJoint * pose.joints.size();
}

void writeNumbers(const scene::MeshPose& pose, std::span<double> numbers) {
    auto next = numbers.begin();
    const auto add = [&](const double* first, std::size_t count) { next = std::copy_n(first, count, next); };
    add(glm::value_ptr(pose.place.position), 3);
    add(glm::value_ptr(pose.place.basis), 9);
    add(glm::value_ptr(pose.deformer->centre), 3);
    *next++ = 0.0;
    add(pose.weights.data(), weightsOf(pose));
    for (const glm::dmat4& joint : pose.joints) {
        add(glm::value_ptr(joint), kNumbersPerJoint);
    }
}

bool staysFaceted(const Deformer& deformer, std::span<const std::uint32_t> indices) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const auto [a, b, c] = std::tuple(indices[i], indices[i + 1], indices[i + 2]);
        const glm::u8vec4 color = deformer.vertices[a].color;
        if (deformer.vertices[b].color != color || deformer.vertices[c].color != color) {
            return false;
        }
        if (!deformer.isFlat && !(followAlike(deformer, a, b) && followAlike(deformer, a, c))) {
            return false;
        }
    }
    return deformer.isFlat || (deformer.targets.empty() && areFaceted(deformer.vertices, indices));
}

} // namespace cdr::render
