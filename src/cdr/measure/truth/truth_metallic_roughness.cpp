#include <cdr/measure/truth/truth_metallic_roughness.h>

#include <algorithm>
#include <cmath>

namespace cdr::measure {

namespace {

constexpr double kMinFacing = 1e-3;

double roughnessOf(const GlossyPoint& point) {
    return std::max(static_cast<double>(point.metallicRoughness.roughness), kMinTruthRoughness);
}

double facingOf(const GlossyPoint& point) {
    return std::max(glm::dot(point.normal, point.toCamera), kMinFacing);
}

/// Smith's Lambda of GGX (Heitz 2014, equation 72), for the cosine of an angle to the normal.
double shadowing(double cosine, double alpha) {
    const double tangent2 = 1.0 / (cosine * cosine) - 1.0;
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tangent2) - 1.0);
}

/// Normal distribution of GGX (Walter et al. 2007, equation 33), times pi.
double facets(double cosine, double alpha) {
    const double cosine2 = cosine * cosine;
    const double tangent2 = std::max(1.0 / cosine2 - 1.0, 0.0);
    return std::pow(alpha / (cosine2 * (alpha * alpha + tangent2)), 2.0);
}

/// What a dielectric mirrors at normal incidence.
constexpr double kDielectric = 0.04;

/// Schlick 1994.
template <typename T>
T fresnel(const T& atNormal, double cosine) {
    return atNormal + (1.0 - atNormal) * std::pow(1.0 - std::clamp(cosine, 0.0, 1.0), 5.0);
}

/// glTF 2.0, appendix B.2: a surface is so much of a metal, and the rest a dielectric.
glm::dvec3 mixed(const GlossyPoint& point, const glm::dvec3& dielectric, const glm::dvec3& metal) {
    return glm::mix(dielectric, metal, static_cast<double>(point.metallicRoughness.metallic));
}

} // namespace

glm::dvec3 pointShare(const GlossyPoint& point, const glm::dvec3& toLight) {
    const double lambert = glm::dot(point.normal, toLight);
    const glm::dvec3 sum = point.toCamera + toLight; // 0 for a light straight behind the surface
    if (lambert <= 0.0 || sum == glm::dvec3(0.0)) {
        return glm::dvec3(0.0);
    }
    const glm::dvec3 halfway = glm::normalize(sum);
    const double alpha = std::pow(roughnessOf(point), 2.0);
    const double facing = facingOf(point);
    const double seen = 1.0 / (1.0 + shadowing(lambert, alpha) + shadowing(facing, alpha));
    const double micro = facets(glm::dot(point.normal, halfway), alpha) * seen / (4.0 * lambert * facing);
    const double cosine = glm::dot(point.toCamera, halfway);
    const double glossy = fresnel(kDielectric, cosine);
    return lambert * mixed(point, glossy * micro + (1.0 - glossy) * point.baseColor,
                           fresnel(point.baseColor, cosine) * micro);
}

glm::dvec3 diffuseShare(const GlossyPoint& point, const glm::dvec3& toLight) {
    const double lambert = std::max(glm::dot(point.normal, toLight), 0.0);
    const glm::dvec3 halfway = glm::normalize(point.toCamera + toLight);
    const double glossy = fresnel(kDielectric, glm::dot(point.toCamera, halfway));
    return lambert * mixed(point, (1.0 - glossy) * point.baseColor, glm::dvec3(0.0));
}

glm::dvec3 ambientShare(const GlossyPoint& point) {
    const double rough = roughnessOf(point);
    const double smooth = 1.0 - rough;
    const double lobe =
        std::min(smooth * smooth, std::exp2(-9.28 * facingOf(point))) * smooth + 0.0425 - 0.0275 * rough;
    const auto mirrored = [&](const auto& atNormal) {
        return atNormal * (1.04 - 0.572 * rough - 1.04 * lobe) + (0.022 * rough - 0.04 + 1.04 * lobe);
    };
    const double glossy = mirrored(kDielectric);
    return mixed(point, glossy + (1.0 - glossy) * point.baseColor,
                 glm::max(mirrored(point.baseColor), glm::dvec3(0.0)));
}

} // namespace cdr::measure
