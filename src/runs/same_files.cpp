#include "same_files.h"

#include <cdr/base/error.h>
#include <cdr/platform/file.h>
#include <cdr/scene/gltf/gltf.h>
#include <cdr/scene/gltf/open_gltf.h>
#include <scenes/orbit/data.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <program/sha256.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

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

std::vector<scene::GltfReference> earthFiles(const std::filesystem::path& folder) {
    std::vector<scene::GltfReference> files;
    for (const std::filesystem::path& file : scenes::earthFiles(folder)) {
        files.push_back({.uri = file.filename().string(), .path = file});
    }
    return files;
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

/// @param what has these files, for the message.
void requireAlike(ranks::Ranks& ranks, const std::string& what,
                  const std::vector<scene::GltfReference>& files) {
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

} // namespace

void requireSameFiles(ranks::Ranks& ranks, const std::filesystem::path& path) {
    if (ranks.isAlone()) {
        return;
    }
    const std::string digest = program::digestOfFile(path, scene::GltfLimits{}.maxFileBytes).sha256;
    ranks.requireSame(digest, fmt::format("{}: is another file than the first rank's", path.string()));
    if (scene::isGltfPath(path)) {
        requireAlike(ranks, path.string(), scene::gltfReferences(path));
    }
}

void requireSameEarth(ranks::Ranks& ranks, const std::filesystem::path& folder) {
    if (ranks.isAlone()) {
        return;
    }
    requireAlike(ranks, "orbit", earthFiles(folder));
}

std::string digestOfFiles(const std::filesystem::path& path) {
    std::vector<scene::GltfReference> files{{.uri = path.string(), .path = path}};
    if (scene::isGltfPath(path)) {
        const std::vector<scene::GltfReference> others = scene::gltfReferences(path);
        files.insert(files.end(), others.begin(), others.end());
    }
    return program::sha256Of(nlohmann::json(digestsOf(files)).dump());
}

std::string digestOfEarth(const std::filesystem::path& folder) {
    return program::sha256Of(nlohmann::json(digestsOf(earthFiles(folder))).dump());
}

} // namespace cdr::runs
