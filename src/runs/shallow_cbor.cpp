#include "shallow_cbor.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace cdr::runs {

namespace {

constexpr std::size_t kDeepestResult = 100;

enum class Major : std::uint8_t { number = 0, bytes = 2, text = 3, list = 4, map = 5, tag = 6 };

class Heads {
  public:
    explicit Heads(const platform::Bytes& all) : m_all(all) {}

    struct Head {
        Major major = Major::number;
        std::uint64_t value = 0; ///< a number, a length, or how many values follow
    };
    /// Empty at the end, and where a length is left open.
    std::optional<Head> next() {
        if (left() == 0) {
            return std::nullopt;
        }
        const std::uint8_t first = m_all[m_at++];
        const std::uint8_t info = first & 31;
        Head head{.major = static_cast<Major>(first >> 5), .value = info};
        if (info < 24) {
            return head;
        }
        const std::size_t size = std::size_t{1} << (info - 24);
        if (info > 27 || size > left()) {
            return std::nullopt;
        }
        head.value = 0;
        for (std::size_t i = 0; i < size; ++i) {
            head.value = head.value << 8 | m_all[m_at++];
        }
        return head;
    }
    void skip(std::uint64_t count) { m_at += static_cast<std::size_t>(count); }
    std::size_t left() const { return m_all.size() - m_at; }

  private:
    const platform::Bytes& m_all;
    std::size_t m_at = 0;
};

} // namespace

bool isShallowCbor(const platform::Bytes& bytes) {
    Heads heads(bytes);
    std::vector<std::uint64_t> open{1}; // values that are left, by level
    while (!open.empty()) {
        if (open.back() == 0) {
            open.pop_back();
            continue;
        }
        --open.back();
        const auto head = heads.next();
        const bool hasLength = head && head->major >= Major::bytes && head->major <= Major::map;
        if (!head || head->major == Major::tag || (hasLength && head->value > heads.left())) {
            return false;
        }
        if (head->major == Major::bytes || head->major == Major::text) {
            heads.skip(head->value);
        } else if (hasLength && open.size() == kDeepestResult) {
            return false;
        } else if (hasLength) {
            open.push_back(head->major == Major::map ? 2 * head->value : head->value);
        }
    }
    return heads.left() == 0;
}

} // namespace cdr::runs
