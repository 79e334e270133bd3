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

} // namespace cdr::render
