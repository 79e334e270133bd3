#include "wrong_view.h"

#include "picture_parts.h"

#include <cdr/base/error.h>
#include <cdr/base/quantity_text.h>
#include <cdr/measure/compare/wrong_pixels.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cdr::viewer {

namespace {

constexpr image::Rgba8 kWrong{255, 0, 0, 255};
constexpr image::Rgba8 kWrongOnEdge{255, 165, 0, 255};

/// What should be seen, and where that counts.
struct Answer {
    image::ImageU32 ids;
    image::Raster<std::uint8_t> inner;
};

Answer answerOf(const render::Frame& frame, const render::Frame& reference) {
    if (frame.width() != reference.width() || frame.height() != reference.height()) {
        throw base::InputError("wrong pixels: the two frames differ in size");
    }
    Answer answer{.ids = reference.ids(), .inner = {}};
    measure::innerMask(answer.ids, answer.inner);
    return answer;
}

std::size_t objectsIn(const image::ImageU32& ids) {
    const auto isObject = [](std::uint32_t id) { return id != 0; };
    const auto first = std::find_if(ids.pixels.begin(), ids.pixels.end(), isObject);
    if (first == ids.pixels.end()) {
        return 0;
    }
    return std::any_of(first, ids.pixels.end(),
                       [&](std::uint32_t id) { return isObject(id) && id != *first; })
               ? 2
               : 1;
}

WrongCount countAgainst(const Answer& answer, const render::Frame& frame) {
    WrongCount count{.objects = objectsIn(answer.ids)};
    for (std::size_t i = 0; i < answer.ids.pixels.size(); ++i) {
        const bool isInner = answer.inner.pixels[i] != 0;
        const bool isWrong = frame.gbuffer.pixels[i].id() != answer.ids.pixels[i];
        count.inner += isInner;
        count.wrong += isInner && isWrong;
        count.edgeWrong += !isInner && isWrong;
    }
    return count;
}

} // namespace

WrongCount countWrong(const render::Frame& frame, const render::Frame& reference) {
    return countAgainst(answerOf(frame, reference), frame);
}

WrongCount paintWrong(const render::Frame& frame, const render::Frame& reference,
                      image::ImageRgba8& picture) {
    const Answer answer = answerOf(frame, reference);
    resize(picture, frame.width(), frame.height());
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const image::Rgba8 wrong = answer.inner.pixels[i] != 0 ? kWrong : kWrongOnEdge;
        const bool isRight = frame.gbuffer.pixels[i].id() == answer.ids.pixels[i];
        picture.pixels[i] = isRight ? measure::dimmed(frame.color.pixels[i]) : wrong;
    }
    return countAgainst(answer, frame);
}

std::string wrongText(const std::vector<WrongCount>& sides) {
    if (sides.empty() || sides.front().objects == 0) {
        return {};
    }
    if (sides.front().objects == 1) {
        return "one object in view: no wrong pixels to count";
    }
    std::vector<std::string> shares;
    for (const WrongCount& side : sides) {
        const std::optional<double> share = side.share();
        shares.push_back(share ? shareText(*share) : "-");
    }
    return fmt::format("wrong\u00a0{}", fmt::join(shares, "\u00a0|\u00a0"));
}

std::string shareText(double share) {
    return base::quantityText(100.0 * share) + "\u00a0%";
}

} // namespace cdr::viewer
