#include "views_plan.h"

#include "../parsed_option.h"

#include <CLI/CLI.hpp>
#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>
#include <cdr/image/beside.h>
#include <cdr/render/views/joined_frame.h>
#include <cdr/scene/cube_sides.h>

#include <cmath>

namespace cdr::options {

namespace {

constexpr base::EnumNames<StereoPicture, 2> kStereoPictureNames{"stereo picture",
                                                                {"side-by-side", "anaglyph"}};
constexpr base::EnumNames<ViewsKind, 2> kViewsNames{"views", {"one", "six"}};

constexpr std::string_view kNoStereo = "none";

/// How eyes look; nothing for "none".
std::optional<scene::StereoMode> parseStereo(std::string_view name) {
    std::vector<std::string_view> known{kNoStereo};
    for (const scene::StereoMode mode : scene::kStereoModes) {
        if (name == nameOf(mode)) {
            return mode;
        }
        known.push_back(nameOf(mode));
    }
    if (name != kNoStereo) {
        throw base::InputError(base::unknownName("stereo", name, known));
    }
    return std::nullopt;
}

StereoPicture parsePicture(std::string_view name) {
    return kStereoPictureNames.parse(name);
}

ViewsKind parseKind(std::string_view name) {
    return kViewsNames.parse(name);
}

void requireStereoAlone(const ViewsArguments& arguments) {
    const auto refuse = [](bool isGiven, const char* option) {
        if (isGiven) {
            throw base::inputError("{} is for two eyes: give --stereo too", option);
        }
    };
    refuse(arguments.eyeDistance.has_value(), "--eye-distance");
    refuse(arguments.converge.has_value(), "--converge");
    refuse(arguments.picture != ViewsArguments{}.picture, "--stereo-picture");
}

} // namespace

std::string_view nameOf(StereoPicture picture) {
    return kStereoPictureNames.nameOf(picture);
}

void addStereoOptions(CLI::App& command, ViewsArguments& arguments) {
    addParsed(command, "--stereo", arguments.stereo, parseStereo,
              "Render two eyes into one picture: none, parallel, toed-in or off-axis")
        ->default_str(std::string(kNoStereo));
    command.add_option("--eye-distance", arguments.eyeDistance, "Distance between the eyes, in scene units");
    command.add_option(
        "--converge", arguments.converge,
        "Distance at which the pictures of both eyes coincide, in scene units; without it, those of "
        "parallel eyes coincide at infinity");
    addNamed(command, "--stereo-picture", arguments.picture, parsePicture,
             "How the pictures of both eyes are combined: side-by-side or anaglyph (red left, cyan right)");
}

void addViewsOption(CLI::App& command, ViewsArguments& arguments) {
    addParsed(
        command, "--views", arguments.kind, parseKind,
        "Views in one picture: one, or six (the sides of a cube around the camera: right, left, up, down, "
        "behind, ahead)")
        ->default_str(std::string(kViewsNames.nameOf(arguments.kind)));
}

ViewsPlan::ViewsPlan(const ViewsArguments& arguments, std::uint32_t width, std::uint32_t height)
    : m_kind(arguments.kind),
      m_picture(arguments.picture),
      m_rig{},
      m_width(width),
      m_height(height) {
    if (m_kind == ViewsKind::six && width != height) {
        throw base::inputError("--views six has square pictures: give a --size such as 512x512, not {}x{}",
                               width, height);
    }
    if (!arguments.stereo) {
        requireStereoAlone(arguments);
        return;
    }
    m_rig.mode = *arguments.stereo;
    if (m_kind == ViewsKind::six) {
        throw base::InputError("give either --stereo or --views six");
    }
    m_kind = ViewsKind::stereo;
    if (!arguments.eyeDistance) {
        throw base::InputError("--stereo needs an --eye-distance");
    }
    if (!arguments.converge && m_rig.mode != scene::StereoMode::parallel) {
        throw base::inputError(
            "--stereo {} needs a distance at which both pictures coincide: give --converge",
            nameOf(m_rig.mode));
    }
    m_rig.eyeDistance = *arguments.eyeDistance;
    if (arguments.converge && !std::isfinite(*arguments.converge)) {
        throw base::InputError("--converge takes a finite distance; parallel eyes do not need it");
    }
    m_rig.convergence = arguments.converge.value_or(m_rig.convergence);
    eyesOf(m_rig); // distances that no camera can have end here
}

std::size_t ViewsPlan::count() const {
    switch (m_kind) {
    case ViewsKind::six:
        return 6;
    case ViewsKind::stereo:
        return 2;
    case ViewsKind::one:
        break;
    }
    return 1;
}

std::string_view ViewsPlan::stereoName() const {
    return m_kind == ViewsKind::stereo ? nameOf(m_rig.mode) : kNoStereo;
}

scene::StereoRig ViewsPlan::rigOf(const scene::Camera& camera) const {
    scene::StereoRig rig = m_rig;
    rig.centre = camera;
    return rig;
}

std::uint32_t ViewsPlan::shiftOf(const scene::Camera& camera) const {
    return m_kind == ViewsKind::stereo ? stereoShift(rigOf(camera), m_width, m_height) : 0;
}

std::vector<scene::Camera> ViewsPlan::camerasOf(const scene::Camera& camera) const {
    if (m_kind == ViewsKind::six) {
        const auto sides = scene::cubeSides(camera);
        return {sides.begin(), sides.end()};
    }
    if (m_kind == ViewsKind::stereo) {
        static_cast<void>(shiftOf(camera)); // refuses pictures that would not overlap before they are drawn
        const auto eyes = eyesOf(rigOf(camera));
        return {eyes.begin(), eyes.end()};
    }
    return {camera};
}

render::Frame ViewsPlan::join(const std::vector<render::Frame>& views, const scene::Camera& camera) const {
    return render::joinedFrame(views, camera, shiftOf(camera));
}

measure::TruthImage ViewsPlan::join(const std::vector<measure::TruthImage>& views,
                                    const scene::Camera& camera) const {
    std::vector<const image::Raster<measure::TruthPixel>*> pictures;
    std::vector<image::Raster<std::uint8_t>> doubtful;
    for (const measure::TruthImage& view : views) {
        pictures.push_back(&view);
        doubtful.push_back(view.doubtful.pixels.empty() ? image::Raster<std::uint8_t>(view.width, view.height)
                                                        : view.doubtful);
    }
    measure::TruthImage joined(image::beside<measure::TruthPixel>(pictures, shiftOf(camera)));
    std::vector<const image::Raster<std::uint8_t>*> masks;
    for (const image::Raster<std::uint8_t>& mask : doubtful) {
        masks.push_back(&mask);
    }
    joined.doubtful = image::beside<std::uint8_t>(masks, shiftOf(camera));
    return joined;
}

void addViewsJson(nlohmann::ordered_json& options, const ViewsArguments& arguments) {
    if (arguments.kind != ViewsArguments{}.kind) {
        options["views"] = kViewsNames.nameOf(arguments.kind);
    }
    if (!arguments.stereo) {
        return;
    }
    options["stereo"] = nameOf(*arguments.stereo);
    options["stereo_picture"] = nameOf(arguments.picture);
    if (arguments.eyeDistance) {
        options["eye_distance"] = *arguments.eyeDistance;
    }
    if (arguments.converge) {
        options["converge"] = *arguments.converge;
    }
}

} // namespace cdr::options
