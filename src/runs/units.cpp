#include "units.h"

namespace cdr::runs {

namespace {

// CBOR keeps every bit of a number, infinity, and the order of fields.

ranks::Ranks::Make makeBytes(const std::function<output::Json(std::size_t unit)>& make) {
    return [&make](std::size_t unit) { return output::Json::to_cbor(make(unit)); };
}

ranks::Ranks::Take takeBytes(const std::function<void(std::size_t unit, output::Json made)>& take) {
    return
        [&take](std::size_t unit, const platform::Bytes& made) { take(unit, output::Json::from_cbor(made)); };
}

} // namespace

void forEachUnit(ranks::Ranks& ranks, std::size_t count,
                 const std::function<output::Json(std::size_t unit)>& make,
                 const std::function<void(std::size_t unit, output::Json made)>& take) {
    ranks.forEachUnit(count, makeBytes(make), takeBytes(take));
}

void forEachUnitOnFirst(ranks::Ranks& ranks, std::size_t count,
                        const std::function<output::Json(std::size_t unit)>& make,
                        const std::function<void(std::size_t unit, output::Json made)>& take) {
    ranks.forEachUnitOnFirst(count, makeBytes(make), takeBytes(take));
}

void forEachUnitTogether(ranks::Ranks& ranks, std::size_t count,
                         const std::function<output::Json(std::size_t unit)>& make,
                         const std::function<void(std::size_t unit, output::Json made)>& take) {
    ranks.forEachUnitTogether(count, makeBytes(make), takeBytes(take));
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
