// The pixels of a method's picture, drawn over the camera view: their positions on screen, and the depth in each pixel
// if the pixels are large. See hidden_overlay.cpp for usage.
#pragma once

#include <optional>

#include "topics/hidden/numbers/hidden_surfaces.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Maps the pixels of one result to a view, whose size may have changed since the result was computed.
class RasterPlaces {
public:
    /// `result` must have a picture and outlive this object.
    RasterPlaces(const Rect& view, const HiddenResult& result) : view_(view), result_(result) {}

    Rect of(glm::ivec2 pixel) const;
    ImVec2 middle(glm::ivec2 pixel) const;
    Rect whole() const;
    /// Returns the pixel at a position on screen; nullopt outside the picture.
    std::optional<glm::ivec2> pixel_at(ImVec2 place) const;

private:
    ImVec2 place_of(const glm::dvec2& position_px) const;

    Rect view_;
    const HiddenResult& result_;
};

/// Draws the lines between pixels; draws nothing if the raster has the view's own resolution.
void draw_raster_lines(const Overlay& overlay, const HiddenResult& result);

/// Draws the depth in each pixel of a raster, with as many digits as fit. Skips areas that labels must avoid.
void draw_raster_depths(const Overlay& overlay, const HiddenResult& result);

/// Outlines the step's pixel and draws a sentence beside it. Labels then avoid the sentence.
void draw_pixel_of_step(Overlay& overlay, const HiddenResult& result, glm::ivec2 pixel, const std::string& text);

/// Outlines the followed pixel.
void draw_chosen_pixel(const Overlay& overlay, const HiddenResult& result);

}  // namespace viewing
