#include "targets_single.h"

#include <cdr/base/error.h>
#include <cdr/base/suggest.h>

#include <array>

namespace cdr::render {

namespace {

constexpr std::array<std::string_view, 1> kNames{"single"};

} // namespace

std::string_view nameOf(TargetsKind kind) {
    return kNames[static_cast<std::size_t>(kind)];
}

TargetsKind parseTargets(std::string_view name) {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (kNames[i] == name) {
            return static_cast<TargetsKind>(i);
        }
    }
    throw base::InputError(base::unknownName("targets", name, kNames));
}

Targets::DepthSlice Targets::depthSlice(std::size_t, std::size_t) const {
    return {};
}

std::unique_ptr<Targets> makeTargets(const gpu::Device& device, TargetsKind kind,
                                     const TargetsOptions& options) {
    switch (kind) {
    case TargetsKind::single:
        return std::make_unique<SingleTargets>(device, options);
    }
    throw base::RunError("targets kind out of range");
}

} // namespace cdr::render
