#include <cdr/render/submit/draw_path.h>

#include <fmt/format.h>

namespace cdr::render {

std::string labelOf(std::span<const std::size_t> cascades) {
    return cascades.size() == 1 ? fmt::format("cascade {}", cascades.front())
                                : fmt::format("cascades {} to {}", cascades.front(), cascades.back());
}

} // namespace cdr::render
