#pragma once

#include <cdr/scene/animation/mesh_pose.h>
#include <cdr/shaders/deform_shared.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cdr::render {

/// A deformer as shaders/deform/deform.comp reads it.
struct DeformerWords {
    std::vector<std::uint32_t> words;
    shaders::DeformPush push{}; ///< but for what depends on a pose and on where vertices go
};

/// How many words wordsOf() makes.
std::uint64_t countWords(const scene::Deformer& deformer);
DeformerWords wordsOf(const scene::Deformer& deformer);

/// How many numbers of a pose the shader reads.
std::size_t countNumbers(const scene::MeshPose& pose);
/// Writes them. @param numbers as many
void writeNumbers(const scene::MeshPose& pose, std::span<double> numbers);

/// Whether triangles stay facets in each pose: of one colour, and of one normal, which is their own.
/// @param indices three per triangle
bool staysFaceted(const scene::Deformer& deformer, std::span<const std::uint32_t> indices);

} // namespace cdr::render
