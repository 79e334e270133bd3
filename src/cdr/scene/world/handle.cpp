#include <cdr/base/enum_names.h>
#include <cdr/base/format_error.h>
#include <cdr/scene/world/handle.h>

#include <atomic>

namespace cdr::scene {

void refusePlace(const char* kind, std::size_t index) {
    throw base::inputError("{} {} is not there", kind, index);
}

std::uint32_t newWorldId() {
    static std::atomic<std::uint32_t> last{0};
    return ++last;
}

void refuseHandle(const char* kind, std::uint32_t index, std::uint32_t generation, HandleFault fault) {
    constexpr base::EnumNames<HandleFault, 3> kWhy{
        "fault", {"it never was", "it was removed", "it is of another world"}};
    throw base::inputError("{} {} (generation {}) is not there: {}", kind, index, generation,
                           kWhy.nameOf(fault));
}

void refuseUsed(const char* kind, std::uint32_t index, std::uint32_t uses, const char* users) {
    throw base::inputError("{} {} cannot be removed: {} {} use it", kind, index, uses, users);
}

} // namespace cdr::scene
