#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cdr::scene {

/// Which places of an array changed, in order. Each reader remembers how far it has read, so that following the changes
/// takes time by their number, not by the array's size.
/// @threads Any number at once may read while none adds.
/// @errors None.
class ChangeLog {
  public:
    /// Of an array that nobody changed yet.
    ChangeLog() = default;
    /// Of a copy of the array.
    ChangeLog(const ChangeLog&) = default;
    ~ChangeLog() = default;
    /// Another array took the place of this one. A reader with a position in either log reads it whole.
    ChangeLog& operator=(const ChangeLog& other) {
        m_first = (end() > other.end() ? end() : other.end()) + 1;
        m_changed.clear();
        ++m_replaced;
        return *this;
    }

    /// How often another array took the place of this one.
    std::uint64_t replaced() const { return m_replaced; }

    /// Where a reader begins that has seen all so far.
    std::uint64_t end() const { return m_first + m_changed.size(); }

    /// What changed since a position, places twice where they changed twice. Nothing where so much changed that the
    /// reader had better read the whole array.
    /// @param position at most end(), which is not checked.
    /// @lifetime The span is valid until the next add().
    std::optional<std::span<const std::uint32_t>> since(std::uint64_t position) const {
        if (position < m_first) {
            return std::nullopt;
        }
        return std::span(m_changed).subspan(static_cast<std::size_t>(position - m_first));
    }

    /// A place changed.
    /// @param places of the array
    void add(std::uint32_t index, std::size_t places) {
        constexpr std::size_t kMin = 1024;
        const std::size_t kept = places > kMin ? places : kMin;
        if (m_changed.size() >= 2 * kept) {
            m_changed.erase(m_changed.begin(), m_changed.begin() + static_cast<std::ptrdiff_t>(kept));
            m_first += kept;
        }
        m_changed.push_back(index);
    }

  private:
    std::uint64_t m_first = 0; ///< position of the first entry kept
    std::uint64_t m_replaced = 0;
    std::vector<std::uint32_t> m_changed;
};

} // namespace cdr::scene
