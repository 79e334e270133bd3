#include <report/manifest.h>

#include <cstddef>
#include <cstdint>

/// Any bytes are the manifest of a report, which is one of its own files, or are none. Nothing is thrown.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto files = cdr::report::filesOfManifest({reinterpret_cast<const char*>(data), size});
    if (files && !files->contains(cdr::report::kManifest)) {
        __builtin_trap();
    }
    return 0;
}
