#include <cdr/base/error.h>
#include <cdr/scene/world/handle.h>

#include <fmt/format.h>

namespace cdr::scene {

void refusePlace(const char* kind, std::size_t index) {
    throw base::InputError(fmt::format("{} {} is not there", kind, index));
}

void refuseHandle(const char* kind, std::uint32_t index, std::uint32_t generation, bool wasThere) {
    throw base::InputError(fmt::format("{} {} (generation {}) is not there: {}", kind, index, generation,
                                       wasThere ? "it was removed" : "it never was"));
}

void refuseUsed(const char* kind, std::uint32_t index, std::uint32_t uses, const char* users) {
    throw base::InputError(fmt::format("{} {} cannot be removed: {} {} use it", kind, index, uses, users));
}

} // namespace cdr::scene
