// The histogram of a depth buffer. Pure, and fast enough to run every frame. See render/buffer_read.h for the source of
// the depths.
#pragma once

#include <cstdint>
#include <span>

#include "frame/pixel_report.h"
#include "frame/plan/plan.h"

namespace viewing {

/// Counts depths as they were read back: integer codes, or the bits of floats in 0 … 1. The plan's clear value counts
/// as unwritten. The histogram has 128 bins of equal width on the plan's depth scale: eye distances between near and
/// far, or window depths. Counting uses float32, so a depth within 10⁻⁵ of a bin's edge may be counted in the
/// neighboring bin.
DepthCounts count_depths(std::span<const std::uint32_t> stored, const DepthPrecision& read_as, const FramePlan& plan);

}  // namespace viewing
