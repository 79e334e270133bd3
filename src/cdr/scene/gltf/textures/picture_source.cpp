#include "picture_source.h"

#include "../checks.h"
#include "../json.h"

namespace cdr::scene::gltf {

std::string PictureSource::label() const {
    return fmt::format("image {}", image);
}

PictureSource readPictureSource(const Sources& sources, int image) {
    const nlohmann::json& json = itemAt(sources.document.root, "images", image, "image");
    const std::optional<int> bufferView = indexMember(json, "bufferView");
    const std::optional<std::string> uri = stringMember(json, "uri");
    if (bufferView.has_value() == uri.has_value()) {
        refuse("image {} must have one of 'uri' and 'bufferView'", image);
    }
    PictureSource source{.image = image, .name = oneLine(fullNameOf(json))};
    if (uri) {
        source.owned = sources.files.read(*uri);
    } else {
        source.inBuffer = sources.buffers.view(*bufferView).bytes;
    }
    source.size = image::sizeOfEncoded(source.encoded(), source.label());
    return source;
}

} // namespace cdr::scene::gltf
