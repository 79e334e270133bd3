#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

namespace cdr::scene::gltf {

/// What of the file was not used. Repeats of one remark make one line, so a hostile file cannot make
/// millions.
class Notes {
  public:
    /// @param what the remark, the same text for every repeat.
    /// @param where the place in the file; only the first one is shown.
    void add(const std::string& what, const std::string& where);

    /// The same for a name that is a remark of its own. After kMaxNamed of them, repeats of `what` make one line again.
    void addNamed(const std::string& what, const std::string& name);

    /// One line per remark, in the order they first came up.
    std::vector<std::string> lines() const;

    static constexpr std::size_t kMaxNamed = 64;

  private:
    struct Remark {
        std::string what;
        std::string firstWhere;
        std::size_t count = 0;
    };
    std::vector<Remark> m_remarks;
    std::unordered_map<std::string, std::size_t> m_indexOf;
    std::size_t m_named = 0;
};

} // namespace cdr::scene::gltf
