#pragma once

#include <cdr/platform/file.h>
#include <cdr/render/frame.h>

#include <ranks/ranks.h>

namespace cdr::runs {

/// Pixels of a frame that show a surface, with their colours, as bytes that another rank of the same program reads. What
/// shows the background takes next to none.
platform::Bytes packedSurfaces(const render::Frame& frame);

/// Lays what packedSurfaces() made of farther cascades under a frame of nearer ones. base::RunError
/// for bytes that are not of a frame of its size. Then the frame is half done.
void layUnder(render::Frame& frame, const platform::Bytes& farther);

/// The first rank's frame becomes the whole one, where each rank has drawn its part (render::CascadePart) of the same.
/// @param bytesSent grows by what this rank sends.
void mergeParts(ranks::Ranks& ranks, render::Frame& frame, std::size_t& bytesSent);

} // namespace cdr::runs
