#include <cdr/render/submit/cascade_commands.h>

namespace cdr::render {

std::vector<std::size_t> CascadeCommands::drawnCascades(std::size_t cascades) const {
    std::vector<std::size_t> drawn;
    for (std::size_t cascade = 0; cascade < cascades; ++cascade) {
        if (!isEmpty(cascade)) {
            drawn.push_back(cascade);
        }
    }
    if (drawn.empty() && cascades > 0) {
        drawn.push_back(cascades - 1);
    }
    return drawn;
}

void CascadeCommands::drawScopes(std::span<const std::size_t> cascades,
                                 std::span<const GBufferScope> scopes) {
    // All barriers first, so that the draws may overlap.
    for (const GBufferScope& scope : scopes) {
        beginGBuffer(primary(), scope);
    }
    for (std::size_t i = 0; i < scopes.size(); ++i) {
        drawScope(scopes[i], cascades.subspan(cascades.size() - 1 - i, 1));
    }
}

} // namespace cdr::render
