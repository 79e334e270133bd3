#pragma once

#include <cdr/measure/truth/truth.h>
#include <cdr/render/frame.h>
#include <cdr/scene/stereo_rig.h>

#include <nlohmann/json.hpp>
#include <options/cli_app.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cdr::options {

/// Which views a picture is of: one, the sides of a cube, or two eyes.
enum class ViewsKind : std::uint8_t { one, six, stereo };

/// How two eyes become one picture.
enum class StereoPicture : std::uint8_t { sideBySide, anaglyph };
/// "side-by-side" or "anaglyph".
std::string_view nameOf(StereoPicture picture);
inline constexpr std::array kStereoPictures{StereoPicture::sideBySide, StereoPicture::anaglyph};

/// What a command line says of several views.
struct ViewsArguments {
    ViewsKind kind = ViewsKind::one;         ///< one or six; `stereo` makes two eyes of one view
    std::optional<scene::StereoMode> stereo; ///< how two eyes look; nothing for one eye
    std::optional<double> eyeDistance;
    std::optional<double> converge;
    StereoPicture picture = StereoPicture::sideBySide;

    bool operator==(const ViewsArguments&) const = default;
};

/// Adds --stereo, --eye-distance, --converge and --stereo-picture. base::InputError for unknown names.
void addStereoOptions(CLI::App& command, ViewsArguments& arguments);
/// Adds --views. base::InputError for unknown names.
void addViewsOption(CLI::App& command, ViewsArguments& arguments);

/// From which cameras a frame is rendered, and how the pictures become one.
class ViewsPlan {
  public:
    /// base::InputError for options that contradict each other or the size of a view.
    ViewsPlan(const ViewsArguments& arguments, std::uint32_t width, std::uint32_t height);

    ViewsKind kind() const { return m_kind; }
    std::size_t count() const;           ///< of views
    std::string_view stereoName() const; ///< of how eyes look; "none" without
    bool isAnaglyph() const { return m_kind == ViewsKind::stereo && m_picture == StereoPicture::anaglyph; }

    /// Of a frame whose camera that is. base::InputError where there is none.
    std::vector<scene::Camera> camerasOf(const scene::Camera& camera) const;
    /// The frames of those cameras beside each other.
    render::Frame join(const std::vector<render::Frame>& views, const scene::Camera& camera) const;
    /// The truths of those cameras beside each other.
    measure::TruthImage join(const std::vector<measure::TruthImage>& views,
                             const scene::Camera& camera) const;

  private:
    scene::StereoRig rigOf(const scene::Camera& camera) const;
    std::uint32_t shiftOf(const scene::Camera& camera) const;

    ViewsKind m_kind = ViewsKind::one;
    StereoPicture m_picture = StereoPicture::sideBySide;
    scene::StereoRig m_rig; ///< except for its camera
    std::uint32_t m_width;
    std::uint32_t m_height;
};

/// What "options" of the command's JSON says of views, where there are several.
void addViewsJson(nlohmann::ordered_json& options, const ViewsArguments& arguments);

} // namespace cdr::options
