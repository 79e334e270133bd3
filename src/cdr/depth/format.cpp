#include <cdr/base/error.h>
#include <cdr/base/suggest.h>
#include <cdr/depth/format.h>

#include <cmath>
#include <limits>

namespace cdr::depth {

namespace {

constexpr std::array<std::string_view, 3> kNames{"d16", "d24", "d32f"};

double steps(DepthFormat format) {
    return format == DepthFormat::d16 ? 65535.0 : 16777215.0;
}

} // namespace

std::string_view nameOf(DepthFormat format) {
    return kNames[static_cast<std::size_t>(format)];
}

DepthFormat parseDepthFormat(std::string_view name) {
    for (const DepthFormat format : kDepthFormats) {
        if (nameOf(format) == name) {
            return format;
        }
    }
    throw base::InputError(base::unknownName("depth format", name, kNames));
}

double depthStep(DepthFormat format, double zNdc) {
    if (format != DepthFormat::d32f) {
        return 1.0 / steps(format);
    }
    const auto z = static_cast<float>(zNdc);
    if (z <= 0.0f) {
        return static_cast<double>(std::numeric_limits<float>::denorm_min());
    }
    return static_cast<double>(z) - static_cast<double>(std::nextafterf(z, 0.0f));
}

double quantize(DepthFormat format, double zNdc) {
    if (format == DepthFormat::d32f) {
        return static_cast<double>(static_cast<float>(zNdc));
    }
    return std::round(zNdc * steps(format)) / steps(format);
}

} // namespace cdr::depth
