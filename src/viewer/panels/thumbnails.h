#pragma once

#include <cstddef>

struct ImFontAtlas;

namespace cdr::viewer {

// Small pictures of scenes::generatedScenes(), in its order. They lie in the texture of the font, the one texture that
// every back end of Dear ImGui has.

/// How many there are.
std::size_t thumbnailCount();

/// Reserves room for them. Nothing else may have reserved room before.
void reserveThumbnails(ImFontAtlas& atlas);
/// Copies them into the room reserved, before the texture is uploaded.
void copyThumbnails(ImFontAtlas& atlas);

/// Draws one as an item of that width. Nothing where the atlas holds none.
void drawThumbnail(std::size_t scene, float width);

} // namespace cdr::viewer
