#include "cascade_layers.h"
#include "one_gbuffer.h"

#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>

#include <fmt/format.h>

#include <charconv>

namespace cdr::render {

namespace {

constexpr auto kTargetsRows = std::to_array<base::ExplainedName>(
    {{"single",
      "One G-buffer for all cascades, drawn from the farthest to the nearest with depth cleared in between "
      "(the thesis' method 1). It takes the least memory and needs no merging, but draws what a nearer "
      "cascade hides."},
     {"accumulate",
      "Each cascade is drawn into a G-buffer and merged into an accumulated one (method 2). An effect "
      "may run on each cascade, at the price of one merge per cascade."},
     {"pool",
      "Several G-buffers in flight, merged in depth order (method 3). Cascades need not wait for each other's "
      "merge, but each G-buffer takes memory."},
     {"layers",
      "One G-buffer per cascade, all kept and merged at the end (method 4). All hidden surfaces stay "
      "available, but it takes the most memory."},
     {"one-pass",
      "One rendering scope without clears. Each cascade has its own slice of the depth range, nearest "
      "first, so early depth tests work across cascades. Integer formats lose a bit for each doubling of "
      "cascades."}});

constexpr base::EnumNames<TargetsKind, kTargetsKinds.size()> kNames{"targets", base::namesOf(kTargetsRows)};

std::uint32_t parseLayers(std::string_view text) {
    std::uint32_t layers = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), layers);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw base::inputError("pool:N takes a whole number of layers, {} to {}, not '{}'", kMinPoolLayers,
                               kMaxPoolLayers, text.substr(0, 60));
    }
    return layers;
}

} // namespace

std::string_view nameOf(TargetsKind kind) {
    return kNames.nameOf(kind);
}

std::string_view explanationOf(TargetsKind kind) {
    return kTargetsRows.at(static_cast<std::size_t>(kind)).explanation;
}

bool hasLayers(TargetsKind kind) {
    return kind != TargetsKind::single && kind != TargetsKind::onePass;
}

TargetsChoice::TargetsChoice(TargetsKind ofKind)
    : kind(ofKind),
      layers(ofKind == TargetsKind::pool ? kDefaultPoolLayers : 0) {}

TargetsChoice TargetsChoice::pool(std::uint32_t layers) {
    if (layers < kMinPoolLayers || layers > kMaxPoolLayers) {
        throw base::inputError("a pool has {} to {} layers, not {}", kMinPoolLayers, kMaxPoolLayers, layers);
    }
    TargetsChoice choice(TargetsKind::pool);
    choice.layers = layers;
    return choice;
}

std::string nameOf(const TargetsChoice& choice) {
    const std::string_view kind = nameOf(choice.kind);
    return choice.kind == TargetsKind::pool ? fmt::format("{}:{}", kind, choice.layers) : std::string(kind);
}

TargetsChoice parseTargets(std::string_view text) {
    const std::size_t colon = text.find(':');
    const TargetsKind kind = kNames.parse(text.substr(0, colon));
    if (colon == std::string_view::npos) {
        return kind;
    }
    if (kind != TargetsKind::pool) {
        throw base::inputError("targets {} take no number of layers, only pool:N does", nameOf(kind));
    }
    return TargetsChoice::pool(parseLayers(text.substr(colon + 1)));
}

void Targets::begin(vk::CommandBuffer) const {}

std::vector<vk::Format> surfaceFormats(const TargetsOptions& options) {
    return options.emission ? std::vector{options.format, kEmissionFormat} : std::vector{options.format};
}

std::unique_ptr<gpu::Image> makeEmission(const gpu::Device& device, const TargetsOptions& options,
                                         const std::string& name) {
    return options.emission
               ? std::make_unique<gpu::Image>(makeGBuffer(device, options.extent, name, kEmissionFormat))
               : nullptr;
}

std::unique_ptr<Targets> makeTargets(const gpu::Device& device, const TargetsChoice& choice,
                                     const TargetsOptions& options) {
    switch (choice.kind) {
    case TargetsKind::single:
    case TargetsKind::onePass:
        return std::make_unique<OneGBufferTargets>(device, choice.kind, options);
    case TargetsKind::accumulate:
        return std::make_unique<CascadeLayers>(device, options, LayerCount{});
    case TargetsKind::pool:
        return std::make_unique<CascadeLayers>(
            device, options, LayerCount{.first = TargetsChoice::pool(choice.layers).layers});
    case TargetsKind::layers:
        return std::make_unique<CascadeLayers>(device, options, LayerCount{.perCascade = true});
    }
    throw base::RunError("targets kind out of range");
}

} // namespace cdr::render
