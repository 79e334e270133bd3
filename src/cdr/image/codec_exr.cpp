#include <cdr/base/format_error.h>
#include <cdr/image/codec.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace cdr::image {

namespace {

void requireWritableChannels(const std::filesystem::path& path, std::span<const ExrChannel> channels) {
    if (channels.empty() || channels.front().values.pixels.empty()) {
        throw base::inputError("{}: nothing to write", path.string());
    }
    const ImageFloat& first = channels.front().values;
    constexpr std::uint32_t kMaxSide = std::numeric_limits<std::int32_t>::max();
    if (first.width > kMaxSide || first.height > kMaxSide) {
        throw base::inputError("{}: {}x{} pixels is too large for EXR", path.string(), first.width,
                               first.height);
    }
    std::set<std::string> names;
    for (const ExrChannel& channel : channels) {
        if (channel.name.empty() || !names.insert(channel.name).second) {
            throw base::inputError("{}: channel name '{}' is empty or used twice", path.string(),
                                   channel.name);
        }
        if (channel.values.width != first.width || channel.values.height != first.height) {
            throw base::inputError("{}: channel '{}' is {}x{}, '{}' is {}x{}", path.string(), channel.name,
                                   channel.values.width, channel.values.height, channels.front().name,
                                   first.width, first.height);
        }
    }
}

/// A file in memory, as OpenEXR writes one: it goes back to fill in where its lines begin.
class MemoryStream final : public Imf::OStream {
  public:
    explicit MemoryStream(const std::string& name) : OStream(name.c_str()) {}

    void write(const char* bytes, int count) override {
        m_bytes.resize(std::max(m_bytes.size(), m_place + static_cast<std::size_t>(count)));
        std::copy_n(bytes, count, m_bytes.begin() + static_cast<std::ptrdiff_t>(m_place));
        m_place += static_cast<std::size_t>(count);
    }
    std::uint64_t tellp() override { return m_place; }
    void seekp(std::uint64_t place) override { m_place = place; }

    std::vector<std::uint8_t> takeBytes() { return std::move(m_bytes); }

  private:
    std::vector<std::uint8_t> m_bytes;
    std::size_t m_place = 0;
};

void writeChannels(Imf::OStream& stream, std::span<const ExrChannel> channels) {
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
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(pixels);
    file.writePixels(static_cast<int>(first.height));
}

} // namespace

std::vector<std::uint8_t> encodeExr(const std::filesystem::path& path, std::span<const ExrChannel> channels) {
    requireWritableChannels(path, channels);
    MemoryStream stream(path.string());
    try {
        writeChannels(stream, channels);
    } catch (const std::exception& error) {
        throw base::runError("{}: EXR write failed: {}", path.string(), error.what());
    }
    return stream.takeBytes();
}

} // namespace cdr::image
