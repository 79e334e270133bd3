#pragma once

#include <cdr/base/export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::scene {

/// Names one thing in one World for as long as it is there, or in a copy of that world that was made since. Its place in the
/// scene's arrays is `index`. A later thing at the same place has another generation.
template <typename Kind>
struct Handle {
    std::uint32_t index = 0;      ///< of its place
    std::uint32_t generation = 0; ///< 0 names nothing
    std::uint32_t world = 0;      ///< that gave it, as newWorldId() counts them

    bool operator==(const Handle&) const = default;
};

/// Of an instance.
using InstanceHandle = Handle<struct InstanceKind>;
/// Of a light.
using LightHandle = Handle<struct LightKind>;
/// Of a mesh.
using MeshHandle = Handle<struct MeshKind>;
/// Of a material.
using MaterialHandle = Handle<struct MaterialKind>;
/// Of a texture.
using TextureHandle = Handle<struct TextureKind>;

/// Another number than any world of the process has had. @errors None.
CDR_EXPORT std::uint32_t newWorldId();

/// Why a handle names nothing that is there.
enum class HandleFault : std::uint8_t {
    never,      ///< it was never given
    removed,    ///< what it named was removed
    otherWorld, ///< it was given by another world
};

/// Refuses a place that holds nothing.
/// @throws base::InputError always.
[[noreturn]] CDR_EXPORT void refusePlace(const char* kind, std::size_t index);
/// Refuses a handle that names nothing that is there.
/// @throws base::InputError always.
[[noreturn]] CDR_EXPORT void refuseHandle(const char* kind, std::uint32_t index, std::uint32_t generation,
                                          HandleFault fault);
/// Refuses a removal, since something still uses the thing.
/// @throws base::InputError always.
[[noreturn]] CDR_EXPORT void refuseUsed(const char* kind, std::uint32_t index, std::uint32_t uses,
                                        const char* users);

/// Hands out places in an array and takes them back. A place that was given back is used again before the array grows.
/// @threads Any number at once may read while none takes or gives back.
/// @errors None but those that a function names.
template <typename Kind>
class Places {
  public:
    /// The first `taken` places, none free.
    /// @param kind as messages name it; must outlive the object
    /// @param world that the things are of
    Places(const char* kind, std::uint32_t world, std::size_t taken)
        : m_kind(kind),
          m_world(world),
          m_generations(taken, 1) {}

    /// What messages call a thing.
    /// @lifetime That of the text that the constructor was given.
    const char* kind() const { return m_kind; }

    /// How many places there are, the free ones included.
    std::size_t size() const { return m_generations.size(); }

    /// Its index is size() as it was where no place was free.
    Handle<Kind> take() {
        if (m_free.empty()) {
            m_generations.push_back(1);
            return {static_cast<std::uint32_t>(size() - 1), 1, m_world};
        }
        const std::uint32_t index = m_free.back();
        m_free.pop_back();
        return {index, ++m_generations[index], m_world};
    }
    /// Takes a place back.
    /// @param handle of a taken place, which is not checked
    void free(Handle<Kind> handle) {
        ++m_generations[handle.index];
        m_free.push_back(handle.index);
    }

    /// Whether something is at a place.
    bool isTaken(std::size_t index) const { return index < size() && m_generations[index] % 2 == 1; }
    /// Whether a handle names what is there.
    bool has(Handle<Kind> handle) const {
        return handle.world == m_world && isTaken(handle.index) &&
               m_generations[handle.index] == handle.generation;
    }
    /// @throws base::InputError unless has(handle).
    void require(Handle<Kind> handle) const {
        if (!has(handle)) {
            refuseHandle(m_kind, handle.index, handle.generation, faultOf(handle));
        }
    }
    /// The handle of what is at a place.
    /// @throws base::InputError unless isTaken(index).
    Handle<Kind> at(std::size_t index) const {
        if (!isTaken(index)) {
            refusePlace(m_kind, index);
        }
        return {static_cast<std::uint32_t>(index), m_generations[index], m_world};
    }

  private:
    HandleFault faultOf(Handle<Kind> handle) const {
        if (handle.generation != 0 && handle.world != m_world) {
            return HandleFault::otherWorld;
        }
        return handle.generation != 0 && handle.index < size() ? HandleFault::removed : HandleFault::never;
    }

    const char* m_kind;
    std::uint32_t m_world;
    std::vector<std::uint32_t> m_generations; ///< odd while taken
    std::vector<std::uint32_t> m_free;
};

} // namespace cdr::scene
