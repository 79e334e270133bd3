#include <cdr/base/error.h>
#include <cli/render/kept_frame.h>

#include <runs/unit_state.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace {

using cdr::output::Json;

constexpr std::uint32_t kNumber = 3;

cdr::cli::FrameShape shapeOf(bool isCertified) {
    return {.number = kNumber,
            .label = "cubes frame 3",
            .cells = 2,
            .fields = {"frame", "technique", "draws", "wrong_fraction"},
            .isCertified = isCertified};
}

void require(bool holds) {
    if (!holds) {
        __builtin_trap();
    }
}

/// What CertificateFile takes of it.
void takeCertificate(const Json& certificate) {
    require(certificate.at("frame").get<std::uint64_t>() == kNumber);
    if (certificate.contains("first_refused")) {
        for (const Json& side : certificate.at("first_refused")) {
            require(side.get<std::uint64_t>() <= std::numeric_limits<std::uint32_t>::max());
        }
    }
}

/// What RenderResults takes of it.
void take(const Json& made, bool isCertified) {
    for (const Json& note : made.at("notes")) {
        require(note.get<std::string>().find_first_of("\n\x1b") == std::string::npos);
    }
    require(made.at("cells").get<std::vector<std::string>>().size() == 2);
    require(made.at("cells").at(1).get<std::string>().find_first_of("\n\x1b") == std::string::npos);
    require(made.at("row").size() <= 4 && !made.at("row").dump().empty());
    require(isCertified || made.at("certificate").is_null());
    if (isCertified) {
        takeCertificate(made.at("certificate"));
    }
}

} // namespace

/// Any value of a state is a frame that `render` can take, or is called none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    namespace runs = cdr::runs;
    const runs::UnitRun run{.digest = "run", .units = 1};
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const std::string line = R"({"unit":0,"made":)" + text + "}";
        const auto state = runs::readUnitState(runs::stateHeadOf(run) + runs::summed(line), run, "state");
        for (const auto& [unit, made] : state.made) {
            for (const bool isCertified : {false, true}) {
                if (isKeptFrame(made, shapeOf(isCertified))) {
                    take(made, isCertified);
                }
            }
        }
    } catch (const cdr::base::InputError&) {
    }
    return 0;
}
