#include <cdr/base/error.h>
#include <cdr/scene/camera_recording.h>

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace {

/// A file without a name that holds what is fuzzed.
class MemoryFile {
  public:
    MemoryFile() : m_descriptor(::memfd_create("path", MFD_CLOEXEC)) {}
    ~MemoryFile() { ::close(m_descriptor); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    void fill(const std::uint8_t* data, std::size_t size) const {
        if (::ftruncate(m_descriptor, 0) != 0 ||
            ::pwrite(m_descriptor, data, size, 0) != static_cast<ssize_t>(size)) {
            __builtin_trap();
        }
    }
    std::string path() const { return "/proc/self/fd/" + std::to_string(m_descriptor); }

  private:
    int m_descriptor;
};

} // namespace

/// Any bytes are a recording with a usable camera at every moment, or are refused with base::InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const MemoryFile file;
    file.fill(data, size);
    try {
        const cdr::scene::CameraRecording recording = cdr::scene::readRecording(file.path());
        const cdr::scene::CameraPath path = cdr::scene::pathOf(recording, 7);
        for (std::uint32_t frame = 0; frame < 7; ++frame) {
            requireUsable(path.at(frame));
        }
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
