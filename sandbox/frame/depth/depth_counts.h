// The histogram of a depth buffer. Pure, and quick enough to follow every frame. Read render/buffer_read.h for where
// the depths come from.
#pragma once

#include <cstdint>
#include <span>

#include "frame/pixel_report.h"
#include "frame/plan.h"

namespace viewing {

/// Depths as they were read: integer codes, or bits of floats in 0 … 1. What the plan clears to counts as unwritten.
/// 128 bins of equal width on the plan's depth scale: eye distances between near and far, or window depths. In float32:
/// a depth within 10⁻⁵ of its bin's edge may be counted beside it.
DepthCounts count_depths(std::span<const std::uint32_t> stored, const DepthPrecision& read_as, const FramePlan& plan);

}  // namespace viewing
