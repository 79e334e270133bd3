#pragma once

/// @file
/// @errors None but those that a function names.
/// @lifetime Names live as long as the program.

#include <cdr/base/export.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace cdr::render {

/// How cascades reach the final G-buffer: the four methods of the thesis (chapter 3), and ours.
enum class TargetsKind : std::uint8_t { single, accumulate, pool, layers, onePass };

/// All of them.
inline constexpr std::array kTargetsKinds{TargetsKind::single, TargetsKind::accumulate, TargetsKind::pool,
                                          TargetsKind::layers, TargetsKind::onePass};

/// "single", "accumulate", "pool", "layers" or "one-pass".
CDR_EXPORT std::string_view nameOf(TargetsKind kind);

/// A sentence or two for a user interface: what the kind does, and what it is good and bad at.
CDR_EXPORT std::string_view explanationOf(TargetsKind kind);

/// Layers a pool may have; with one it would be `accumulate`.
inline constexpr std::uint32_t kMinPoolLayers = 2;
/// Most layers of a pool.
inline constexpr std::uint32_t kMaxPoolLayers = 16;
/// Layers of a pool that does not say.
inline constexpr std::uint32_t kDefaultPoolLayers = 3;

/// A kind of targets and what it leaves to choose.
struct CDR_EXPORT TargetsChoice {
    TargetsKind kind = TargetsKind::single; ///< which
    std::uint32_t layers = 0;               ///< of a pool; 0 for the other kinds, which have no say in it

    TargetsChoice() = default;
    /// A kind as it comes: a pool has kDefaultPoolLayers.
    TargetsChoice(TargetsKind ofKind); // NOLINT(google-explicit-constructor): a kind is a choice
    /// A pool of so many layers.
    /// @throws base::InputError unless kMinPoolLayers to kMaxPoolLayers.
    static TargetsChoice pool(std::uint32_t layers);

    bool operator==(const TargetsChoice&) const = default;
};

/// The kind's name, a pool's with its layers: "pool:4".
CDR_EXPORT std::string nameOf(const TargetsChoice& choice);

/// Reads a kind's name, or "pool:N".
/// @throws base::InputError with a suggestion for an unknown name, and for a number that does not fit.
CDR_EXPORT TargetsChoice parseTargets(std::string_view text);

/// Whether cascades are drawn into G-buffers of their own before they meet: accumulate, pool and layers.
CDR_EXPORT bool hasLayers(TargetsKind kind);

} // namespace cdr::render
