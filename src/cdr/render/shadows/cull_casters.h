#pragma once

#include <cdr/render/shadows/caster_test.h>
#include <cdr/visibility/instance_cells.h>

#include <cstdint>
#include <vector>

namespace cdr::render {

/// Appends the instances whose bounding spheres may lie between a light and a surface that reads its map. Their order depends
/// on the cells alone.
/// @return how near to the light they reach: LightView::nearAhead.
double cullCasters(const visibility::InstanceCells& cells, const LightView& view, const CasterTest& test,
                   std::vector<std::uint32_t>& casters);

} // namespace cdr::render
