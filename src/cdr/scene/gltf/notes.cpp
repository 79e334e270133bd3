#include "notes.h"

#include "checks.h"

namespace cdr::scene::gltf {

void Notes::add(const std::string& what, const std::string& where) {
    const auto [found, isNew] = m_indexOf.try_emplace(what, m_remarks.size());
    if (isNew) {
        m_remarks.push_back({what, where, 0});
    }
    ++m_remarks[found->second].count;
}

void Notes::addNamed(const std::string& what, const std::string& name) {
    if (m_named == kMaxNamed) {
        add(what, name);
        return;
    }
    ++m_named;
    m_remarks.push_back({what, name, 1});
}

std::vector<std::string> Notes::lines() const {
    std::vector<std::string> lines;
    lines.reserve(m_remarks.size());
    for (const Remark& remark : m_remarks) {
        lines.push_back(oneLine(remark.count == 1 ? fmt::format("{}: {}", remark.firstWhere, remark.what)
                                                  : fmt::format("{} and {} more: {}", remark.firstWhere,
                                                                remark.count - 1, remark.what)));
    }
    return lines;
}

} // namespace cdr::scene::gltf
