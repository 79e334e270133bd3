#include "certificate_file.h"

#include "../exit_status.h"

#include <fmt/format.h>
#include <output/document.h>

#include <cmath>
#include <functional>
#include <utility>

namespace cdr::cli {

namespace {

nlohmann::ordered_json jsonOf(const glm::dvec3& vector) {
    return {vector.x, vector.y, vector.z};
}

nlohmann::ordered_json jsonOf(const scene::Camera& camera) {
    return {{"eye", jsonOf(camera.position)}, {"right", jsonOf(camera.right)},
            {"up", jsonOf(camera.up)},        {"back", jsonOf(camera.back)},
            {"fov_y", camera.fovY},           {"near", camera.nearView},
            {"far", camera.farView},          {"lens_shift", {camera.lensShift.x, camera.lensShift.y}}};
}

nlohmann::ordered_json jsonOf(const measure::FrameBound& bound) {
    return {{"pixels", bound.pixels},
            {"distance", bound.distanceView},
            {"depth", bound.depth},
            {"depth_step", bound.stepView}};
}

/// Rounded down: only where all pixels are certified does it say 100 %.
std::string certifiedText(const measure::Certificate& certificate) {
    const double percent = 100.0 * certificate.certifiedFraction();
    return percent < 100.0 ? fmt::format("{:.2f} %", std::floor(100.0 * percent) / 100.0) : "100 %";
}

} // namespace

output::Columns<measure::Certificate> certificateColumns(bool isShown) {
    using Certificate = measure::Certificate;
    const auto ofRays = [](auto count) {
        return [count](const Certificate& certificate) {
            return certificate.isRefused() ? output::Json(nullptr)
                                           : output::Json(std::invoke(count, certificate));
        };
    };
    return {{.key = "certified", .value = &Certificate::certified},
            {.key = "proven", .value = &Certificate::proven},
            {.key = "certified_fraction",
             .value = &Certificate::certifiedFraction,
             .heading = isShown ? "certified" : "",
             .text = certifiedText},
            {.key = "cast",
             .value = ofRays(&Certificate::cast),
             .heading = isShown ? "cast" : "",
             .format = {.missing = "-"}},
            {.key = "cast_masked", .value = ofRays(&Certificate::castMasked)},
            {.key = "wrong_before",
             .value = ofRays(&Certificate::wrong),
             .heading = isShown ? "wrong before" : "",
             .format = {.missing = "-"}},
            {.key = "repaired",
             .value = ofRays([](const Certificate& certificate) { return certificate.repairs.size(); }),
             .heading = isShown ? "repaired" : "",
             .format = {.missing = "-"}},
            {.key = "blended_pixels", .value = &Certificate::blended},
            {.key = "refused", .value = &Certificate::refused}};
}

nlohmann::ordered_json certificateOf(std::uint32_t number, const scene::Camera& camera,
                                     const CertifiedOutput& certified, const std::string& hash) {
    const measure::Certificate& certificate = certified.certificate;
    nlohmann::ordered_json json{{"frame", number},
                                {"camera", jsonOf(camera)},
                                {"snap_pixels", certified.snapPixels},
                                {"bound", jsonOf(certificate.bound)},
                                {"pixels", certificate.pixels}};
    json.update(output::jsonOf(certificateColumns(false), certificate));
    if (certificate.firstRefused) {
        json["first_refused"] = {certificate.firstRefused->x, certificate.firstRefused->y};
    } else {
        json["hash"] = hash;
    }
    return json;
}

CertificateFile::CertificateFile(std::filesystem::path path, Command& command, nlohmann::ordered_json options)
    : m_path(std::move(path)),
      m_console(command.console()),
      m_document(command.makeDocument(std::move(options))) {
    m_document["rule"] = "the float64 ray through a pixel's centre decides";
    m_document["sub_pixel_bits"] = command.device().info().subPixelBits;
}

void CertificateFile::add(nlohmann::ordered_json certificate) {
    if (certificate.contains("first_refused")) {
        ++m_refused;
        const nlohmann::ordered_json& first = certificate["first_refused"];
        m_console.warning(fmt::format(
            "frame {} refused: {} pixels show errors that the device may not make, the first at ({}, {}); no "
            "picture of it is written",
            certificate["frame"].get<std::uint32_t>(), certificate["refused"].get<std::uint64_t>(),
            first[0].get<std::uint32_t>(), first[1].get<std::uint32_t>()));
    }
    m_document["results"].push_back(std::move(certificate));
}

void CertificateFile::finish() {
    output::writeDocument(m_path, m_document);
    if (hasRefused()) {
        throw ExitStatus(ExitStatus::kFound);
    }
}

} // namespace cdr::cli
