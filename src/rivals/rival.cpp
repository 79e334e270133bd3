#include <cdr/base/format_error.h>
#include <cdr/base/suggest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <rivals/rival.h>

#include <algorithm>

namespace cdr::rivals {

namespace {

constexpr std::string_view kPrepass = "/prepass";

bool usesFloat64(const Rival& rival) {
    return rival.distance == Distance::object && rival.key != Key::pair64;
}

} // namespace

std::span<const NamedRival> namedRivals() {
    static const std::vector<NamedRival> kRivals{
        {"atomic-log", {.distance = Distance::view, .key = Key::log40}},
        {"two-float", {.distance = Distance::vertexPair, .key = Key::pair64}},
        {"atomic-log-object", {.distance = Distance::object, .key = Key::log40}},
        {"atomic-fixed", {.distance = Distance::object, .key = Key::fixed64}},
        {"object-anchors", {.distance = Distance::object, .key = Key::pair64}},
    };
    return kRivals;
}

NamedRival parseRival(std::string_view name) {
    const bool hasPrepass = name.ends_with(kPrepass);
    const std::string_view bare = hasPrepass ? name.substr(0, name.size() - kPrepass.size()) : name;
    std::vector<std::string_view> names;
    for (const NamedRival& known : namedRivals()) {
        if (known.name == bare) {
            NamedRival found{std::string(name), known.rival};
            found.rival.prepass = hasPrepass;
            return found;
        }
        names.push_back(known.name);
    }
    throw base::InputError(base::unknownName("rival", bare, names));
}

std::vector<std::string> featuresOf(const Rival& rival) {
    std::vector<std::string> features{"fragmentStoresAndAtomics", "shaderInt64", "shaderBufferInt64Atomics"};
    if (usesFloat64(rival)) {
        features.emplace_back("shaderFloat64");
    }
    return features;
}

std::vector<std::string> missingFeatures(const gpu::DeviceInfo& device, const Rival& rival) {
    std::vector<std::string> missing;
    for (std::string& feature : featuresOf(rival)) {
        const bool has = feature == "fragmentStoresAndAtomics" ? device.hasFragmentStores
                         : feature == "shaderFloat64"          ? device.hasFloat64
                                                               : device.hasInt64Atomics;
        if (!has) {
            missing.push_back(std::move(feature));
        }
    }
    if (rival.prepass && std::ranges::count(device.depthFormats, depth::DepthFormat::d32f) == 0) {
        missing.emplace_back("depth buffers of 32 bits");
    }
    return missing;
}

void requireFeatures(const gpu::DeviceInfo& device, const Rival& rival) {
    if (const auto missing = missingFeatures(device, rival); !missing.empty()) {
        throw base::inputError("{} cannot compare 64-bit depths by atomics: it lacks {}", device.name,
                               fmt::join(missing, ", "));
    }
}

std::uint32_t geometryPassesOf(const Rival& rival) {
    return (rival.prepass ? 2u : 1u) + (rival.key == Key::log40 ? 0u : 1u);
}

std::uint32_t bytesPerPixelOf(const Rival& rival) {
    constexpr std::uint32_t kKeyBytes = sizeof(std::uint64_t);
    return kKeyBytes + (rival.key == Key::log40 ? 0u : 4u) + (rival.prepass ? 4u : 0u);
}

} // namespace cdr::rivals
