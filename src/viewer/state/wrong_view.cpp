#include "wrong_view.h"

#include "picture_parts.h"

#include <cdr/base/error.h>

namespace cdr::viewer {

namespace {

constexpr image::Rgba8 kWrong{255, 0, 0, 255};
constexpr image::Rgba8 kWrongOnEdge{255, 165, 0, 255};

} // namespace

WrongCount paintWrong(const render::Frame& frame, const render::Frame& reference,
                      image::ImageRgba8& picture) {
    if (frame.width() != reference.width() || frame.height() != reference.height()) {
        throw base::InputError("wrong pixels: the two frames differ in size");
    }
    resize(picture, frame.width(), frame.height());
    const image::ImageU32 answer = reference.ids();
    image::Raster<std::uint8_t> inner;
    measure::innerMask(answer, inner);
    WrongCount count;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const bool isInner = inner.pixels[i] != 0;
        count.inner += isInner;
        if (frame.gbuffer.pixels[i].id() == answer.pixels[i]) {
            const std::uint8_t grey = dimGrey(frame.color.pixels[i]);
            picture.pixels[i] = {grey, grey, grey, 255};
            continue;
        }
        count.wrong += isInner;
        count.edgeWrong += !isInner;
        picture.pixels[i] = isInner ? kWrong : kWrongOnEdge;
    }
    return count;
}

} // namespace cdr::viewer
