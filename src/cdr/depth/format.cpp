#include <cdr/base/enum_names.h>
#include <cdr/depth/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace cdr::depth {

namespace {

/// The names of kDepthFormatTraits.
constexpr auto kFormatNames = [] {
    base::EnumNames<DepthFormat, kDepthFormats.size()> names{"depth format", {}};
    for (const DepthFormat format : kDepthFormats) {
        names.names[static_cast<std::size_t>(format)] = nameOf(format);
    }
    return names;
}();

/// The largest stored integer.
double steps(DepthFormat format) {
    return std::exp2(traitsOf(format).bits) - 1.0;
}

} // namespace

std::vector<std::string_view> namesOf(std::span<const DepthFormat> formats) {
    std::vector<std::string_view> names;
    std::transform(formats.begin(), formats.end(), std::back_inserter(names),
                   [](DepthFormat format) { return nameOf(format); });
    return names;
}

DepthFormat parseDepthFormat(std::string_view name) {
    return kFormatNames.parse(name);
}

base::Result<DepthFormat> tryParseDepthFormat(std::string_view name) {
    return kFormatNames.tryParse(name);
}

double depthStep(DepthFormat format, double zNdc) {
    if (!traitsOf(format).isFloat) {
        return 1.0 / steps(format);
    }
    const auto z = static_cast<float>(zNdc);
    if (z <= 0.0f) {
        return static_cast<double>(std::numeric_limits<float>::denorm_min());
    }
    return static_cast<double>(z) - static_cast<double>(std::nextafterf(z, 0.0f));
}

double quantize(DepthFormat format, double zNdc) {
    if (traitsOf(format).isFloat) {
        return static_cast<double>(static_cast<float>(zNdc));
    }
    return std::round(zNdc * steps(format)) / steps(format);
}

} // namespace cdr::depth
