#include "needs_command.h"

#include <experiments/rivals/needs.h>

namespace cdr::cli {

namespace {

std::vector<experiments::RivalNeeds> needsOfAll(const std::vector<rivals::NamedRival>& named) {
    std::vector<experiments::RivalNeeds> needs;
    for (const auto& [name, rival] : named) {
        needs.push_back(experiments::needsOf(name, rival));
    }
    return needs;
}

} // namespace

void printNeeds(const Console& console, const std::vector<rivals::NamedRival>& rivals) {
    if (!rivals.empty()) {
        console.line("");
        console.table(output::tableOf(experiments::rivalNeedsColumns(), needsOfAll(rivals)));
    }
}

void addNeeds(output::Json& document, const std::vector<rivals::NamedRival>& rivals) {
    if (!rivals.empty()) {
        document["needs"] = output::jsonOf(experiments::rivalNeedsColumns(), needsOfAll(rivals));
    }
}

} // namespace cdr::cli
