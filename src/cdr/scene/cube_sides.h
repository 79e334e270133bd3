#pragma once

/// @file
/// @errors None but those that a function names.

#include <cdr/base/export.h>
#include <cdr/scene/camera.h>

#include <array>

namespace cdr::scene {

/// Six cameras at one place with a field of view of 90 degrees, which together see all directions where pictures are
/// square. The sides are, in this order, to its right, left, up, down, back and ahead. The four level ones
/// keep its up; up has its back above, and down its view direction.
/// @throws base::InputError for a camera that is not usable.
CDR_EXPORT std::array<Camera, 6> cubeSides(const Camera& camera);

} // namespace cdr::scene
