#pragma once

#include <cdr/base/export.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cdr::scene {

/// Names one thing in a World for as long as it is there. Its place in the scene's arrays is `index`; a later thing at
/// the same place has another generation.
template <typename Kind>
struct Handle {
    std::uint32_t index = 0;      ///< of its place
    std::uint32_t generation = 0; ///< 0 names nothing

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

/// Says that nothing is at this place.
/// @throws base::InputError always.
[[noreturn]] CDR_EXPORT void refusePlace(const char* kind, std::size_t index);
/// Says that the handle names nothing that is there.
/// @param wasThere whether there is such a place
/// @throws base::InputError always.
[[noreturn]] CDR_EXPORT void refuseHandle(const char* kind, std::uint32_t index, std::uint32_t generation,
                                          bool wasThere);
/// Says that something uses it still.
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
    explicit Places(const char* kind, std::size_t taken = 0) : m_kind(kind), m_generations(taken, 1) {}

    /// What messages call a thing.
    /// @lifetime That of the text that the constructor was given.
    const char* kind() const { return m_kind; }

    /// How many places there are, the free ones included.
    std::size_t size() const { return m_generations.size(); }

    /// Its index is size() as it was where no place was free.
    Handle<Kind> take() {
        if (m_free.empty()) {
            m_generations.push_back(1);
            return {static_cast<std::uint32_t>(size() - 1), 1};
        }
        const std::uint32_t index = m_free.back();
        m_free.pop_back();
        return {index, ++m_generations[index]};
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
        return isTaken(handle.index) && m_generations[handle.index] == handle.generation;
    }
    /// @throws base::InputError unless has(handle).
    void require(Handle<Kind> handle) const {
        if (!has(handle)) {
            refuseHandle(m_kind, handle.index, handle.generation, handle.index < size());
        }
    }
    /// The handle of what is at a place.
    /// @throws base::InputError unless isTaken(index).
    Handle<Kind> at(std::size_t index) const {
        if (!isTaken(index)) {
            refusePlace(m_kind, index);
        }
        return {static_cast<std::uint32_t>(index), m_generations[index]};
    }

  private:
    const char* m_kind;
    std::vector<std::uint32_t> m_generations; ///< odd while taken
    std::vector<std::uint32_t> m_free;
};

} // namespace cdr::scene
