#pragma once

#include <cdr/scene/scene.h>

#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace cdr::scene {

/// Which instances use a mesh. Only meshes that were asked for once are followed, so that others cost nothing.
/// @threads One thread at a time.
/// @errors None.
class MeshUsers {
  public:
    /// Looks at every instance when a mesh is asked for first.
    /// @lifetime The reference is valid as long as the object; what it refers to changes by add() and remove().
    const std::vector<std::uint32_t>& of(std::uint32_t mesh, const Instances& instances) {
        const auto [found, isNew] = m_users.try_emplace(mesh);
        for (std::size_t i = 0; isNew && i < instances.size(); ++i) {
            if (instances.mesh[i] == mesh && instances.radius[i] != kNoRadius) {
                found->second.add(static_cast<std::uint32_t>(i));
            }
        }
        return found->second.instances;
    }

    /// An instance that uses a mesh was added.
    void add(std::uint32_t mesh, std::uint32_t instance) {
        if (const auto found = m_users.find(mesh); found != m_users.end()) {
            found->second.add(instance);
        }
    }
    /// It was removed. The last one takes its place.
    void remove(std::uint32_t mesh, std::uint32_t instance) {
        if (const auto found = m_users.find(mesh); found != m_users.end()) {
            found->second.remove(instance);
        }
    }

  private:
    struct Users {
        std::vector<std::uint32_t> instances;
        std::unordered_map<std::uint32_t, std::size_t> places; ///< of each, in `instances`

        void add(std::uint32_t instance) {
            places[instance] = instances.size();
            instances.push_back(instance);
        }
        void remove(std::uint32_t instance) {
            const auto place = places.find(instance);
            if (place == places.end()) {
                return;
            }
            instances[place->second] = instances.back();
            places[instances.back()] = place->second;
            instances.pop_back();
            places.erase(instance);
        }
    };
    std::unordered_map<std::uint32_t, Users> m_users; ///< by mesh
};

} // namespace cdr::scene
