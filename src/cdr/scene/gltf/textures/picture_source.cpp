#include "picture_source.h"

#include "../checks.h"
#include "../json.h"

namespace cdr::scene::gltf {

std::string PictureSource::label() const {
    return fmt::format("image {}", image);
}

PictureSource readPictureSource(const Sources& sources, int image) {
    const nlohmann::json& json = itemAt(sources.document, "images", image, "image");
    const std::optional<int> bufferView = indexMember(json, "bufferView");
    const std::optional<std::string> uri = stringMember(json, "uri");
    if (bufferView.has_value() == uri.has_value()) {
        refuse("image {} must have one of 'uri' and 'bufferView'", image);
    }
    PictureSource source{.image = image, .name = oneLine(fullNameOf(json))};
    if (!uri) {
        source.inBuffer = sources.buffers.view(*bufferView).bytes;
        sources.files.countInView(source.inBuffer->size(), source.label());
    }
    const platform::Bytes encoded = uri ? sources.files.open(*uri).read() : source.inBuffer->read();
    source.size = image::sizeOfEncoded(encoded, source.label());
    return source;
}

image::ImageRgba8 decodePicture(const Sources& sources, const PictureSource& picture) {
    const auto uri = [&] {
        const nlohmann::json& json = itemAt(sources.document, "images", picture.image, "image");
        return stringMember(json, "uri").value_or("");
    };
    const platform::Bytes encoded =
        picture.inBuffer ? picture.inBuffer->read() : sources.files.readAgain(uri());
    image::ImageRgba8 pixels = image::decodeImage(encoded, picture.label());
    if (image::PictureSize{.width = pixels.width, .height = pixels.height} != picture.size) {
        refuse("{} changed while the file was imported", picture.label());
    }
    return pixels;
}

} // namespace cdr::scene::gltf
