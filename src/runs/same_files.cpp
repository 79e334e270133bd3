#include "same_files.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <cdr/scene/gltf/open_gltf.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <program/sha256.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace cdr::runs {

namespace {

/// The importer reads no more of what a file refers to than this many times the limit of one file.
constexpr std::uintmax_t kFilesRead = 4;

/// By file its digest, or that it cannot be read.
std::vector<std::string> digestsOf(const std::vector<scene::GltfReference>& files) {
    std::uintmax_t left = kFilesRead * scene::GltfLimits{}.maxFileBytes;
    std::vector<std::string> digests;
    for (const scene::GltfReference& file : files) {
        try {
            const program::FileDigest digest =
                program::digestOfFile(file.path, std::min(left, scene::GltfLimits{}.maxFileBytes));
            left -= digest.bytes;
            digests.push_back(digest.sha256);
        } catch (const base::InputError&) {
            digests.emplace_back("cannot be read");
        }
    }
    return digests;
}

/// The first file, by name, that is another one or that only one of them refers to; empty where there is none. A rank may
/// refuse a reference that another one follows.
std::string differing(const std::map<std::string, std::string>& mine,
                      const std::map<std::string, std::string>& first) {
    const auto [mineEnd, firstEnd] = std::mismatch(mine.begin(), mine.end(), first.begin(), first.end());
    if (mineEnd == mine.end() || firstEnd == first.end()) {
        return mineEnd != mine.end() ? mineEnd->first : firstEnd != first.end() ? firstEnd->first : "";
    }
    return std::min(mineEnd->first, firstEnd->first);
}

} // namespace

void requireSameFiles(ranks::Run& ranks, const std::string& what,
                      const std::vector<scene::GltfReference>& files) {
    if (ranks.isAlone()) {
        return;
    }
    const std::vector<std::string> digests = digestsOf(files);
    std::map<std::string, std::string> mine;
    for (std::size_t i = 0; i < files.size(); ++i) {
        mine[files[i].uri] = digests[i];
    }
    const std::string text =
        nlohmann::json(mine).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    const platform::Bytes shared = ranks.share({text.begin(), text.end()});
    const auto first = nlohmann::json::parse(shared).get<std::map<std::string, std::string>>();
    ranks.requireSame(text, fmt::format("{}: its file {} is another one than the first rank's", what,
                                        differing(mine, first)));
}

std::string digestOfFiles(const std::vector<scene::GltfReference>& files) {
    return program::sha256Of(nlohmann::json(digestsOf(files)).dump());
}

} // namespace cdr::runs
