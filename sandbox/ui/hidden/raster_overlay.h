// The pixels of a method's picture over the camera's view: where they are, and as large squares with the depth in each.
// Read hidden_overlay.cpp for its use.
#pragma once

#include <optional>

#include "frame/hidden/hidden_surfaces.h"
#include "ui/parts/overlay.h"

namespace viewing {

/// Where the pixels of one result are in a view, whose size may have changed since.
class RasterPlaces {
public:
    /// `result` has a picture and outlives this.
    RasterPlaces(const Rect& view, const HiddenResult& result) : view_(view), result_(result) {}

    Rect of(glm::ivec2 pixel) const;
    ImVec2 middle(glm::ivec2 pixel) const;
    Rect whole() const;
    /// None beside the picture.
    std::optional<glm::ivec2> pixel_at(ImVec2 place) const;

private:
    ImVec2 place_of(const glm::dvec2& position_px) const;

    Rect view_;
    const HiddenResult& result_;
};

/// The lines between pixels; nothing where they are those of the view.
void draw_raster_lines(const Overlay& overlay, const HiddenResult& result);

/// In each pixel of a raster its depth, in as many digits as there is room for, but where labels are kept off.
void draw_raster_depths(const Overlay& overlay, const HiddenResult& result);

/// The pixel that the step is at, with a sentence beside it that labels are kept off.
void draw_pixel_of_step(Overlay& overlay, const HiddenResult& result, glm::ivec2 pixel, const std::string& text);

/// The followed pixel.
void draw_chosen_pixel(const Overlay& overlay, const HiddenResult& result);

}  // namespace viewing
