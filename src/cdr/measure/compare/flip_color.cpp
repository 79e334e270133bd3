#include <cdr/image/srgb.h>
#include <cdr/measure/compare/flip_color.h>

#include <glm/glm.hpp>

#include <cmath>

namespace cdr::measure {

namespace {

/// Linear sRGB to XYZ over the white's XYZ; rows of the sRGB standard's matrix, exact as fractions.
const glm::dmat3& whiteRelative() {
    static const glm::dmat3 kMatrix = [] {
        const glm::dmat3 rows(
            glm::dvec3(10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0),
            glm::dvec3(2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0),
            glm::dvec3(1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0));
        const glm::dmat3 toXyz = glm::transpose(rows);
        const glm::dvec3 white = toXyz * glm::dvec3(1.0);
        return glm::dmat3(toXyz[0] / white, toXyz[1] / white, toXyz[2] / white);
    }();
    return kMatrix;
}

const glm::mat3& toWhiteRelative() {
    static const glm::mat3 kMatrix(whiteRelative());
    return kMatrix;
}

const glm::mat3& fromWhiteRelative() {
    static const glm::mat3 kMatrix(glm::inverse(whiteRelative()));
    return kMatrix;
}

/// The curve of L*a*b* (CIE 15), white being 1.
float lightnessCurve(float t) {
    constexpr float kDelta = 6.0f / 29.0f;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
}

HuntLab huntLabOfLinear(const glm::vec3& rgb) {
    const glm::vec3 xyz = toWhiteRelative() * rgb;
    const float x = lightnessCurve(xyz.x);
    const float y = lightnessCurve(xyz.y);
    const float z = lightnessCurve(xyz.z);
    const float l = 116.0f * y - 16.0f;
    return {.l = l, .a = 0.01f * l * 500.0f * (x - y), .b = 0.01f * l * 200.0f * (y - z)};
}

/// The exponent and the two points of the piecewise linear map (section 4.1.3).
constexpr float kExponent = 0.7f;
constexpr float kKneeShare = 0.4f;
constexpr float kKneeValue = 0.95f;

float largestDifference() {
    static const float kLargest = std::pow(
        hyab(huntLabOfLinear(glm::vec3(0.0f, 1.0f, 0.0f)), huntLabOfLinear(glm::vec3(0.0f, 0.0f, 1.0f))),
        kExponent);
    return kLargest;
}

} // namespace

Opponent opponentOf(const image::Rgba8& srgb) {
    const auto& linear = image::linearOfSrgb();
    const glm::vec3 xyz =
        toWhiteRelative() * glm::vec3(glm::dvec3(linear[srgb[0]], linear[srgb[1]], linear[srgb[2]]));
    return {.y = 116.0f * xyz.y - 16.0f, .cx = 500.0f * (xyz.x - xyz.y), .cz = 200.0f * (xyz.y - xyz.z)};
}

HuntLab huntLabOf(const Opponent& color) {
    const float y = (color.y + 16.0f) / 116.0f;
    const glm::vec3 rgb = fromWhiteRelative() * glm::vec3(y + color.cx / 500.0f, y, y - color.cz / 200.0f);
    return huntLabOfLinear(glm::clamp(rgb, 0.0f, 1.0f));
}

float hyab(const HuntLab& a, const HuntLab& b) {
    const float da = a.a - b.a;
    const float db = a.b - b.b;
    return std::abs(a.l - b.l) + std::sqrt(da * da + db * db);
}

float redistribute(float hyabDistance) {
    const float largest = largestDifference();
    const float knee = kKneeShare * largest;
    const float power = std::pow(hyabDistance, kExponent);
    return power < knee ? kKneeValue / knee * power
                        : kKneeValue + (power - knee) / (largest - knee) * (1.0f - kKneeValue);
}

} // namespace cdr::measure
