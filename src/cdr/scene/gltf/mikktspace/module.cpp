#include "module.h"

#if CDR_HAS_MIKKTSPACE
#include <mikktspace.h>
#endif

#include <array>
#include <cstring>
#include <memory>
#include <new>

namespace cdr::scene::gltf {

namespace {

constexpr std::uint64_t kModuleBytes = 4u << 20u;
constexpr std::uint64_t kCornerBytes = 192; // 158 to 170 were measured

} // namespace

std::uint64_t mikkTSpaceBytes(std::uint64_t corners) {
    return kModuleBytes + corners * (kCornerBytes + sizeof(glm::vec4));
}

#if !CDR_HAS_MIKKTSPACE

bool hasMikkTSpace() {
    return false;
}

base::Result<std::vector<glm::vec4>> mikkTSpace(std::size_t /*corners*/,
                                                const std::function<TangentCorner(std::size_t)>& /*cornerAt*/,
                                                const MikkTSpaceLimits& /*limits*/) {
    return base::Refusal{"cdr was built without MikkTSpace"};
}

#else

namespace {

constexpr std::size_t kTableSize = 18; // of the module
constexpr std::uint32_t kResultBytes = 16;
constexpr std::uint64_t kMaxCorners = ((std::uint64_t{1} << 32u) - kModuleBytes) / kCornerBytes; // of 32 bits

/// What ends a call.
struct Trap {
    wasm_rt_trap_t cause;
};

/// The module, with all that it changes.
class Module {
  public:
    /// @param memory zero, of `bytes`.
    Module(std::uint8_t* memory, std::uint64_t bytes, std::uint32_t depth) {
        m_state.w2c_memory = {.data = memory, .size = 0, .max_size = bytes, .depth = 0, .max_depth = depth};
        m_state.w2c_T0 = {.data = m_table.data(), .size = 0, .max_size = kTableSize};
        wasm2c_mikktspace_instantiate(&m_state, nullptr);
    }

    w2c_mikktspace* state() { return &m_state; }

    /// Room for numbers, which the module gives a place.
    std::uint32_t allocate(std::uint64_t floats) {
        return w2c_mikktspace_0x5F_wbindgen_malloc(&m_state,
                                                   static_cast<std::uint32_t>(floats * sizeof(float)));
    }

    template <typename Value>
    void write(std::uint64_t place, const Value& value) {
        std::memcpy(at(place, sizeof(Value)), &value, sizeof(Value));
    }

    template <typename Value>
    Value read(std::uint64_t place) {
        Value value;
        std::memcpy(&value, at(place, sizeof(Value)), sizeof(Value));
        return value;
    }

  private:
    std::uint8_t* at(std::uint64_t place, std::uint64_t bytes) {
        const wasm_rt_memory_t& memory = *w2c_mikktspace_memory(&m_state);
        if (place + bytes > memory.size) {
            throw Trap{WASM_RT_TRAP_OOB};
        }
        return memory.data + place;
    }

    w2c_mikktspace m_state{};
    std::array<wasm_rt_funcref_t, kTableSize> m_table{};
};

std::vector<glm::vec4> tangentsBy(Module& module, std::size_t corners,
                                  const std::function<TangentCorner(std::size_t)>& cornerAt) {
    const auto count = static_cast<std::uint32_t>(corners);
    const std::uint32_t result =
        w2c_mikktspace_0x5F_wbindgen_add_to_stack_pointer(module.state(), 0u - kResultBytes);
    const std::uint32_t positions = module.allocate(3 * corners);
    const std::uint32_t normals = module.allocate(3 * corners);
    const std::uint32_t uvs = module.allocate(2 * corners);
    for (std::size_t i = 0; i < corners; ++i) {
        const TangentCorner corner = cornerAt(i);
        module.write(positions + i * sizeof(glm::vec3), corner.position);
        module.write(normals + i * sizeof(glm::vec3), corner.normal);
        module.write(uvs + i * sizeof(glm::vec2), corner.uv);
    }
    w2c_mikktspace_generateTangents(module.state(), result, positions, 3 * count, normals, 3 * count, uvs,
                                    2 * count);
    const auto place = module.read<std::uint32_t>(result);
    if (module.read<std::uint32_t>(result + sizeof(place)) != 4 * count) {
        throw Trap{WASM_RT_TRAP_OOB};
    }
    std::vector<glm::vec4> tangents(corners);
    for (std::size_t i = 0; i < corners; ++i) {
        const auto tangent = module.read<glm::vec4>(place + i * sizeof(glm::vec4));
        tangents[i] = {tangent.x, tangent.y, tangent.z, -tangent.w}; // its v grows up a texture
    }
    return tangents;
}

} // namespace

bool hasMikkTSpace() {
    return true;
}

base::Result<std::vector<glm::vec4>> mikkTSpace(std::size_t corners,
                                                const std::function<TangentCorner(std::size_t)>& cornerAt,
                                                const MikkTSpaceLimits& limits) {
    if (corners == 0) {
        return std::vector<glm::vec4>{};
    }
    const std::uint64_t bytes = kModuleBytes + corners * kCornerBytes;
    if (corners > kMaxCorners || mikkTSpaceBytes(corners) > limits.bytes) {
        return base::Refusal{"MikkTSpace would take too much memory"};
    }
    const std::unique_ptr<std::uint8_t[]> memory(new (std::nothrow) std::uint8_t[bytes]());
    if (memory == nullptr) {
        return base::Refusal{"MikkTSpace would take too much memory"};
    }
    try {
        // The table is of pointers to the module, which must not move.
        const auto module = std::make_unique<Module>(memory.get(), bytes, limits.depth);
        return tangentsBy(*module, corners, cornerAt);
    } catch (const Trap& trap) {
        return base::Refusal{trap.cause == WASM_RT_TRAP_EXHAUSTION ? "MikkTSpace would nest too many calls"
                                                                   : "MikkTSpace failed"};
    }
}

} // namespace cdr::scene::gltf

void cdr_mikktspace_trap(wasm_rt_trap_t cause) {
    throw cdr::scene::gltf::Trap{cause};
}

// What the module asks of JavaScript, to report an error.
// NOLINTBEGIN(readability-identifier-naming): wasm2c's names
void w2c_0x5F__wbindgen__placeholder__0x5F_0x5F_wbindgen_rethrow(
    w2c_0x5F__wbindgen__placeholder__0x5F* /*host*/, u32 /*error*/) {
    throw cdr::scene::gltf::Trap{WASM_RT_TRAP_UNREACHABLE};
}

u32 w2c_0x5F__wbindgen__placeholder__0x5F_0x5F_wbindgen_string_new(
    w2c_0x5F__wbindgen__placeholder__0x5F* /*host*/, u32 /*text*/, u32 /*bytes*/) {
    return 0;
}
// NOLINTEND(readability-identifier-naming)

namespace cdr::scene::gltf {

#endif

} // namespace cdr::scene::gltf
