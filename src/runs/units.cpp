#include "units.h"

namespace cdr::runs {

// CBOR keeps every bit of a number, infinity, and the order of fields.
void forEachUnit(ranks::Ranks& ranks, std::size_t count,
                 const std::function<output::Json(std::size_t unit)>& make,
                 const std::function<void(std::size_t unit, output::Json made)>& take,
                 ranks::Ranks::ForEach forEach) {
    (ranks.*forEach)(
        count, [&](std::size_t unit) { return output::Json::to_cbor(make(unit)); },
        [&](std::size_t unit, const platform::Bytes& made) { take(unit, output::Json::from_cbor(made)); });
}

output::Json packedPicture(const image::ImageRgba8& picture) {
    return {{"width", picture.width}, {"height", picture.height}, {"pixels", packed(picture.pixels)}};
}

image::ImageRgba8 unpackedPicture(const output::Json& json) {
    image::ImageRgba8 picture;
    picture.width = json.at("width").get<std::uint32_t>();
    picture.height = json.at("height").get<std::uint32_t>();
    picture.pixels = unpacked<image::Rgba8>(json.at("pixels"), std::size_t{picture.width} * picture.height);
    return picture;
}

} // namespace cdr::runs
