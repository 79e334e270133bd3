#include "certificate_file.h"

#include "../exit_status.h"

#include <fmt/format.h>
#include <output/document.h>

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

} // namespace

nlohmann::ordered_json castCount(const measure::Certificate& certificate, std::uint64_t count) {
    return certificate.isRefused() ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(count);
}

nlohmann::ordered_json certificateOf(std::uint32_t number, const scene::Camera& camera,
                                     const CertifiedOutput& certified, const std::string& hash) {
    const measure::Certificate& certificate = certified.certificate;
    nlohmann::ordered_json json{{"frame", number},
                                {"camera", jsonOf(camera)},
                                {"snap_pixels", certified.snapPixels},
                                {"bound", jsonOf(certificate.bound)},
                                {"pixels", certificate.pixels},
                                {"certified", certificate.certified},
                                {"proven", certificate.proven},
                                {"certified_fraction", certificate.certifiedFraction()},
                                {"cast", castCount(certificate, certificate.cast)},
                                {"cast_masked", castCount(certificate, certificate.castMasked)},
                                {"wrong_before", castCount(certificate, certificate.wrong)},
                                {"repaired", castCount(certificate, certificate.repairs.size())},
                                {"blended_pixels", certificate.blended},
                                {"refused", certificate.refused}};
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
