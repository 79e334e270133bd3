// What lets C++ and GLSL read the same headers.
#ifndef CDR_SHADERS_SHARING_H
#define CDR_SHADERS_SHARING_H

#ifdef __cplusplus
#include <glm/glm.hpp>

#include <cstdint>

namespace cdr::shaders {
using uint = std::uint32_t;
using ivec2 = glm::ivec2;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
} // namespace cdr::shaders

#define CDR_SHARED_BEGIN namespace cdr::shaders {
#define CDR_SHARED_END }
#define CDR_CONST inline constexpr uint
#define CDR_CONST_FLOAT inline constexpr float
#else
#define CDR_SHARED_BEGIN
#define CDR_SHARED_END
#define CDR_CONST const uint
#define CDR_CONST_FLOAT const float
#define static_assert(holds)
#endif

#endif
