#pragma once

#include <cdr/depth/technique.h>
#include <cdr/render/geometry/snapping.h>
#include <cdr/render/render_options.h>

#include <options/cli_app.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace cdr::options {

/// A technique by its parts, instead of a preset.
struct TechniqueParts {
    std::optional<depth::Mapping> mapping{}; ///< standard without
    std::optional<depth::Split> split{};     ///< none without

    /// Whether a command line names any.
    bool isGiven() const { return mapping || split; }
    /// With the format d32f.
    depth::Technique technique() const;
};

// Each adds options; what it refers to must live as long as the command. What cannot be parsed ends with
// base::InputError.

/// Adds --depth and --split.
void addTechniqueParts(CLI::App& command, TechniqueParts& parts);
/// Adds --format.
void addDepthFormat(CLI::App& command, std::optional<depth::DepthFormat>& format);
/// Adds --targets.
void addTargets(CLI::App& command, render::TargetsChoice& targets);
/// Adds --submission and --batching.
void addSubmission(CLI::App& command, render::RenderOptions& options);
/// Adds --detail.
void addDetail(CLI::App& command, visibility::Detail& detail);
/// Adds --snap-bits, as render::RenderOptions has it.
void addSnapBits(CLI::App& command, std::uint32_t& snapBits);
/// Adds --snapping, as render::RenderOptions has it.
void addSnapping(CLI::App& command, render::Snapping& snapping);
/// Adds --threads, 1 to platform::WorkerPool::kMaxThreads.
void addThreads(CLI::App& command, std::size_t& threads);

} // namespace cdr::options
