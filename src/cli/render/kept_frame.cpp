#include "kept_frame.h"

#include <algorithm>
#include <limits>
#include <string_view>

namespace cdr::cli {

namespace {

using output::Json;

/// A value of an object; null where there is none.
const Json& valueAt(const Json& object, std::string_view key) {
    static const Json kNone;
    const auto found = object.is_object() ? object.find(std::string(key)) : object.end();
    return found != object.end() ? *found : kNone;
}

bool isPrintable(const Json& json) {
    if (!json.is_string()) {
        return false;
    }
    const std::string& text = json.get_ref<const std::string&>();
    return text.size() <= kMaxText && std::none_of(text.begin(), text.end(), [](char c) {
               return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
           });
}

/// As program::sha256() gives it.
bool isDigest(const Json& json) {
    constexpr std::size_t kDigits = 64;
    return isPrintable(json) && json.get_ref<const std::string&>().size() == kDigits &&
           json.get_ref<const std::string&>().find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool isUnsigned(const Json& json, std::uint64_t most = std::numeric_limits<std::uint64_t>::max()) {
    return json.is_number_unsigned() && json.get<std::uint64_t>() <= most;
}

/// JSON has null for what is not finite.
bool isNumberOrNull(const Json& json) {
    return json.is_number() || json.is_null();
}

template <typename Check>
bool isListOf(const Json& json, std::size_t count, const Check& check) {
    return json.is_array() && json.size() == count && std::all_of(json.begin(), json.end(), check);
}

/// As a state has it, where bytes that are no UTF-8 are replaced.
std::string written(const Json& text) {
    return text.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool isNotes(const Json& notes) {
    return notes.size() <= kMaxNotes && isListOf(notes, notes.size(), isPrintable);
}

bool isRow(const Json& row, const FrameShape& frame) {
    if (!row.is_object() || !isUnsigned(valueAt(row, "frame")) || valueAt(row, "frame") != frame.number) {
        return false;
    }
    return std::all_of(row.items().begin(), row.items().end(), [&](const auto& item) {
        const Json& value = item.value();
        return frame.fields.contains(item.key()) &&
               (isNumberOrNull(value) || value.is_boolean() || isPrintable(value));
    });
}

bool isCells(const Json& cells, const FrameShape& frame) {
    return isListOf(cells, frame.cells, [](const Json& cell) { return cell.is_string(); }) &&
           !cells.empty() && written(cells.front()) == written(frame.label) &&
           std::all_of(cells.begin() + 1, cells.end(), isPrintable);
}

bool isCamera(const Json& camera) {
    const auto isVector = [&](std::string_view key) {
        return isListOf(valueAt(camera, key), 3, isNumberOrNull);
    };
    const auto isNumber = [&](std::string_view key) { return isNumberOrNull(valueAt(camera, key)); };
    return camera.is_object() && isVector("eye") && isVector("right") && isVector("up") && isVector("back") &&
           isNumber("fov_y") && isNumber("near") && isNumber("far");
}

/// Whether CertificateFile takes it.
bool isCertificate(const Json& json, std::uint32_t number) {
    const auto isCount = [&](std::string_view key) { return isUnsigned(valueAt(json, key)); };
    const bool isRefused = json.is_object() && json.contains("first_refused");
    const auto isCastCount = [&](std::string_view key) {
        return isRefused ? json.contains(key) && json[key].is_null() : isCount(key);
    };
    if (!isCount("frame") || valueAt(json, "frame") != number || !isCamera(valueAt(json, "camera")) ||
        !isNumberOrNull(valueAt(json, "snap_pixels")) ||
        !isNumberOrNull(valueAt(json, "certified_fraction")) || !isCount("pixels") || !isCount("certified") ||
        !isCount("proven") || !isCastCount("cast") || !isCastCount("wrong_before") ||
        !isCastCount("repaired") || !isCount("refused")) {
        return false;
    }
    const auto isPixel = [](const Json& side) {
        return isUnsigned(side, std::numeric_limits<std::uint32_t>::max());
    };
    return isRefused ? isListOf(json["first_refused"], 2, isPixel) : isDigest(valueAt(json, "hash"));
}

} // namespace

bool isKeptFrame(const Json& made, const FrameShape& frame) {
    const Json& picture = valueAt(made, "picture");
    const Json& certificate = valueAt(made, "certificate");
    return made.is_object() && made.contains("picture") && made.contains("certificate") &&
           (picture.is_null() || isDigest(picture)) && isNotes(valueAt(made, "notes")) &&
           isRow(valueAt(made, "row"), frame) && isCells(valueAt(made, "cells"), frame) &&
           (frame.isCertified ? isCertificate(certificate, frame.number) : certificate.is_null());
}

} // namespace cdr::cli
