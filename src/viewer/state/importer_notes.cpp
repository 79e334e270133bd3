#include "importer_notes.h"

#include <cstddef>

namespace cdr::viewer {

std::vector<std::string> importerNotes(const scene::OpenedScene& scene) {
    std::vector<std::string> notes;
    for (std::size_t i = 0; i < scene.notes.size(); ++i) {
        if (scene.animationsNote != i) {
            notes.push_back("ignored: " + scene.notes[i]);
        }
    }
    return notes;
}

} // namespace cdr::viewer
