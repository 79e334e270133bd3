#pragma once

#include <cdr/scene/world/change_log.h>
#include <cdr/scene/world/handle.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace cdr::scene {

/// Things of one kind that others use: who has which place, how many use each, and what changed. The things themselves are
/// an array of the scene's, which the functions are given; a place that is free keeps one that nothing uses.
///
/// @threads Any number at once may read while none changes it.
/// @errors Functions that take a handle throw base::InputError, and change nothing, unless it names what is there.
/// @lifetime References are valid as long as the table.
template <typename Kind>
class Table {
  public:
    /// A table of things that are there, which nothing uses yet.
    /// @param kind as messages name one; must outlive the table
    /// @param users as messages name them; must outlive the table
    /// @param world that the things are of
    /// @param taken how many things there are
    Table(const char* kind, const char* users, std::uint32_t world, std::size_t taken)
        : m_places(kind, world, taken),
          m_users(users),
          m_uses(taken) {}

    /// Who has which place.
    const Places<Kind>& places() const { return m_places; }
    /// Which places changed.
    const ChangeLog& changes() const { return m_changes; }

    /// Something uses a thing.
    /// @param index of a place that is there, which is not checked
    void use(std::uint32_t index) { ++m_uses[index]; }
    /// Takes one use() back.
    void release(std::uint32_t index) { --m_uses[index]; }

    /// Puts a thing into a free place, or a new one.
    template <typename T>
    Handle<Kind> add(std::vector<T>& things, T thing) {
        const Handle<Kind> handle = m_places.take();
        if (handle.index == things.size()) {
            things.emplace_back();
            m_uses.push_back(0);
        }
        put(things, handle.index, std::move(thing));
        return handle;
    }
    /// Puts another thing into a place.
    template <typename T>
    void set(std::vector<T>& things, Handle<Kind> handle, T thing) {
        m_places.require(handle);
        put(things, handle.index, std::move(thing));
    }
    /// Gives a place back.
    /// @param free what the place keeps
    /// @throws base::InputError also where something uses it.
    template <typename T>
    void remove(std::vector<T>& things, Handle<Kind> handle, T free) {
        requireUnused(handle);
        m_places.free(handle);
        put(things, handle.index, std::move(free));
    }
    /// Whether a thing may be removed.
    /// @throws base::InputError unless the handle names what is there and nothing uses it.
    void requireUnused(Handle<Kind> handle) const {
        m_places.require(handle);
        if (m_uses[handle.index] > 0) {
            refuseUsed(m_places.kind(), handle.index, m_uses[handle.index], m_users);
        }
    }

  private:
    template <typename T>
    void put(std::vector<T>& things, std::uint32_t index, T thing) {
        things[index] = std::move(thing);
        m_changes.add(index, things.size());
    }

    Places<Kind> m_places;
    const char* m_users;
    std::vector<std::uint32_t> m_uses; ///< by place
    ChangeLog m_changes;
};

} // namespace cdr::scene
