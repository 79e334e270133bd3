#include <cdr/base/error.h>
#include <cdr/host/file.h>
#include <cdr/image/codec.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <fmt/format.h>

#include <limits>
#include <set>

namespace cdr::image {

namespace {

void requireWritableChannels(const std::filesystem::path& path, std::span<const ExrChannel> channels) {
    if (channels.empty() || channels.front().values.pixels.empty()) {
        throw base::InputError(fmt::format("{}: nothing to write", path.string()));
    }
    const ImageFloat& first = channels.front().values;
    constexpr std::uint32_t kMaxSide = std::numeric_limits<std::int32_t>::max();
    if (first.width > kMaxSide || first.height > kMaxSide) {
        throw base::InputError(
            fmt::format("{}: {}x{} pixels is too large for EXR", path.string(), first.width, first.height));
    }
    std::set<std::string> names;
    for (const ExrChannel& channel : channels) {
        if (channel.name.empty() || !names.insert(channel.name).second) {
            throw base::InputError(
                fmt::format("{}: channel name '{}' is empty or used twice", path.string(), channel.name));
        }
        if (channel.values.width != first.width || channel.values.height != first.height) {
            throw base::InputError(fmt::format("{}: channel '{}' is {}x{}, '{}' is {}x{}", path.string(),
                                               channel.name, channel.values.width, channel.values.height,
                                               channels.front().name, first.width, first.height));
        }
    }
}

void writeChannels(const std::filesystem::path& path, std::span<const ExrChannel> channels) {
    const ImageFloat& first = channels.front().values;
    Imf::Header header(static_cast<int>(first.width), static_cast<int>(first.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer pixels;
    for (const ExrChannel& channel : channels) {
        header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
        // OpenEXR has one slice type for reading and writing; writing leaves the pixels alone.
        auto* values = reinterpret_cast<char*>(const_cast<float*>(channel.values.pixels.data()));
        pixels.insert(channel.name,
                      Imf::Slice(Imf::FLOAT, values, sizeof(float), sizeof(float) * channel.values.width));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(static_cast<int>(first.height));
}

} // namespace

void writeExr(const std::filesystem::path& path, std::span<const ExrChannel> channels) {
    requireWritableChannels(path, channels);
    host::requireWritable(path);
    host::writeBesideThenRename(path, [&](const std::filesystem::path& temporary) {
        try {
            writeChannels(temporary, channels);
        } catch (const std::exception& error) {
            throw base::RunError(fmt::format("{}: EXR write failed: {}", path.string(), error.what()));
        }
    });
}

} // namespace cdr::image
