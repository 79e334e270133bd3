#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace cdr::gpu {

/// A Vulkan object that all who asked for an equal one share. It is destroyed with the last of them.
/// @tparam Unique the vk::UniqueHandle that owns the object
template <typename Unique>
class Shared {
  public:
    using Handle = typename Unique::element_type;

    Shared() = default;
    explicit Shared(std::shared_ptr<const Unique> object) : m_object(std::move(object)) {}

    /// The null handle where there is none.
    Handle operator*() const { return m_object != nullptr ? **m_object : Handle(); }
    explicit operator bool() const { return m_object != nullptr; }

    /// Whether they are one object, not whether they are alike.
    bool operator==(const Shared&) const = default;

  private:
    std::shared_ptr<const Unique> m_object;
};

/// Finds objects, of one type and one device, by what they were made from, as long as somebody has them. Any thread may
/// ask at any time, and waits while another makes one.
/// @tparam Options with operator==. They are kept as long as the object, so what they refer to is there as long.
template <typename Options, typename Unique>
class SharedObjects {
  public:
    /// An object that somebody has and that was made from equal options; else what `make(options)` returns.
    template <typename Make>
    Shared<Unique> get(const Options& options, const Make& make) {
        const std::lock_guard lock(m_mutex);
        std::erase_if(m_objects, [](const auto& object) { return object.expired(); });
        for (const std::weak_ptr<const Object>& known : m_objects) {
            if (const auto object = known.lock(); object != nullptr && object->options == options) {
                return share(object);
            }
        }
        const auto object = std::make_shared<const Object>(options, make(options));
        m_objects.push_back(object);
        if (m_keeps) {
            m_kept.push_back(object);
        }
        ++m_made;
        return share(object);
    }

    /// From now on has each object that it makes itself too, until release() or its end.
    void keep() {
        const std::lock_guard lock(m_mutex);
        m_keeps = true;
    }

    /// Keeps none any more: those that nobody else has are destroyed.
    void release() {
        const std::lock_guard lock(m_mutex);
        m_keeps = false;
        m_kept.clear();
    }

    /// How many were made so far, those that are gone included.
    std::uint64_t made() const {
        const std::lock_guard lock(m_mutex);
        return m_made;
    }

  private:
    struct Object {
        Options options;
        Unique object;
        Object(const Options& from, Unique made) : options(from), object(std::move(made)) {}
    };

    static Shared<Unique> share(const std::shared_ptr<const Object>& object) {
        return Shared<Unique>(std::shared_ptr<const Unique>(object, &object->object));
    }

    mutable std::mutex m_mutex;
    std::vector<std::weak_ptr<const Object>> m_objects;
    std::vector<std::shared_ptr<const Object>> m_kept;
    bool m_keeps = false;
    std::uint64_t m_made = 0;
};

} // namespace cdr::gpu
