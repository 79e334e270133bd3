#include "deform_choice.h"

#include "parsed_option.h"

#include <CLI/CLI.hpp>
#include <cdr/base/format_error.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace cdr::options {

void addDeform(CLI::App& command, std::optional<scenes::Deform>& deform) {
    addParsed(
        command, "--deform", deform, scenes::parseDeform,
        "What computes skins and morph targets in the frames of --fps: cpu or device, which needs float64")
        ->default_str("device on graphics cards with float64, else cpu");
}

scenes::Deform deformOn(const gpu::DeviceInfo& device, std::optional<scenes::Deform> told,
                        VertexReaders readers) {
    using scenes::Deform;
    const bool can = device.deformMissing.empty();
    if (told == Deform::device && !can) {
        throw base::inputError("--deform device: {} lacks {}", device.name,
                               fmt::join(device.deformMissing, ", "));
    }
    const bool isCard = device.kind != gpu::DeviceKind::cpu;
    if (told.value_or(isCard && can ? Deform::device : Deform::cpu) == Deform::cpu) {
        return Deform::cpu;
    }
    return readers == VertexReaders::drawing ? Deform::device : Deform::both;
}

} // namespace cdr::options
