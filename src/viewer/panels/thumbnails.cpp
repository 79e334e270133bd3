#include "thumbnails.h"

#include <cdr/image/codec.h>
#include <cdr/viewer/scenes_picture.h>

#include <imgui.h>

#include <cstring>

namespace cdr::viewer {

namespace {

constexpr std::uint32_t kThumbnailWidth = 160;
constexpr std::uint32_t kThumbnailHeight = 90;

const image::ImageRgba8& sheet() {
    static const image::ImageRgba8 kSheet = image::decodeImage(kScenesPicture, "scenes.jpg");
    return kSheet;
}

std::uint32_t columnsOfSheet() {
    return sheet().width / kThumbnailWidth;
}

} // namespace

std::size_t thumbnailCount() {
    return std::size_t{columnsOfSheet()} * (sheet().height / kThumbnailHeight);
}

#if IMGUI_VERSION_NUM < 19200

void reserveThumbnails(ImFontAtlas& atlas) {
    for (std::size_t i = 0; i < thumbnailCount(); ++i) {
        atlas.AddCustomRectRegular(kThumbnailWidth, kThumbnailHeight);
    }
}

void copyThumbnails(ImFontAtlas& atlas) {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    for (std::size_t i = 0; i < thumbnailCount(); ++i) {
        const ImFontAtlasCustomRect& room = *atlas.GetCustomRectByIndex(static_cast<int>(i));
        const std::size_t left = i % columnsOfSheet() * kThumbnailWidth;
        const std::size_t top = i / columnsOfSheet() * kThumbnailHeight;
        for (std::size_t row = 0; row < kThumbnailHeight; ++row) {
            const image::Rgba8* from = &sheet().pixels[(top + row) * sheet().width + left];
            unsigned char* to = pixels + 4 * ((room.Y + row) * static_cast<std::size_t>(width) + room.X);
            std::memcpy(to, from, sizeof(image::Rgba8) * kThumbnailWidth);
        }
    }
}

void drawThumbnail(std::size_t scene, float width) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    if (scene >= thumbnailCount()) {
        return;
    }
    ImVec2 low;
    ImVec2 high;
    atlas.CalcCustomRectUV(atlas.GetCustomRectByIndex(static_cast<int>(scene)), &low, &high);
    ImGui::Image(atlas.TexID, {width, width * kThumbnailHeight / kThumbnailWidth}, low, high);
}

#else // its atlas has no room for pictures before the back end asks for them

void reserveThumbnails(ImFontAtlas&) {}
void copyThumbnails(ImFontAtlas&) {}
void drawThumbnail(std::size_t, float) {}

#endif

} // namespace cdr::viewer
