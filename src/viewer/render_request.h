#pragma once

#include <cdr/render/frame.h>
#include <cdr/render/renderer.h>
#include <cdr/scene/open_scene.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cdr::viewer {

/// What the interface wants to see next.
struct RenderRequest {
    std::uint64_t serial = 0; ///< counts requests
    std::string scene;        ///< a name or file for scene::openScene()
    std::uint64_t seed = scene::kDefaultSeed;
    std::optional<scene::Camera> camera; ///< the scene's own first one without
    /// One technique, or two to compare. Of all sides width and height agree.
    std::vector<render::RenderOptions> sides;
};

/// One technique's answer.
struct SideResult {
    render::RenderOptions options;
    std::shared_ptr<const render::Frame> frame;
    std::shared_ptr<const image::ImageRgba8> picture; ///< what to show of it
};

/// The answer to a request.
struct RenderResult {
    std::uint64_t serial = 0; ///< the request's
    std::string sceneName{};    ///< the open scene's, as requested
    std::shared_ptr<const scene::OpenedScene> scene{};
    std::vector<SideResult> sides{}; ///< empty when it failed
    double frameMs = 0.0;          ///< from the request taken to the pictures made
    std::string message{};           ///< why it failed, one line; else empty
    std::exception_ptr fatal{};      ///< nothing more will come
};

} // namespace cdr::viewer
