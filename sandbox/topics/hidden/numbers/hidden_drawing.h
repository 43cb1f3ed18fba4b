// Converts a hidden-surface method's result to what the renderer draws.
#pragma once

#include <span>

#include "frame/plan/hidden_pictures.h"
#include "topics/hidden/methods/difference.h"
#include "topics/hidden/numbers/hidden_surfaces.h"

namespace viewing {

/// Returns a drawing of the polygons up to the result's step, or of the picture at that step. If canceled, the drawing
/// has at least the first 32,768 polygons, so a drawing that is quick to make is always complete.
HiddenDrawing hidden_drawing(const HiddenResult& result, const WorkProgress* progress = nullptr);

/// Compares the ID image of a result with a reference. If GL has drawn the image, rounding at edges does not count.
IdDifference difference_from_drawn(const IdImage& reference, const IdImage& image, const HiddenResult& result);

/// `differs`: nonzero for each pixel that differs, rows from the top.
DifferenceDrawing difference_drawing(std::span<const std::uint8_t> differs, glm::ivec2 size_px);
/// Returns a drawing of what two ID images of the same size do not have in common, away from edges.
DifferenceDrawing difference_drawing(const IdDifference& found, glm::ivec2 size_px);

}  // namespace viewing
