// Finds the main view on stage, for the tests of the layout and of the pixels.
#pragma once

#include <algorithm>
#include <vector>

#include "ui/parts/layout.h"

namespace viewing::test {

inline float area_of(const Rect& rect) {
    return rect.empty() ? 0.0F : rect.width() * rect.height();
}

/// Returns the rectangles of the camera's pictures, or of the view that is shown large in their place.
inline std::vector<Rect> main_view(const Layout& layout) {
    if (!layout.camera.empty()) return {layout.camera, layout.beside};
    const std::vector<Rect> views = {layout.lower_left, layout.lower_right, layout.matrices};
    return {*std::max_element(views.begin(), views.end(),
                              [](const Rect& a, const Rect& b) { return area_of(a) < area_of(b); })};
}

/// Returns the fraction of the area above the lesson's text that the main view occupies.
inline float main_share(const Layout& layout) {
    float sum = 0.0F;
    for (const Rect& rect : main_view(layout)) sum += area_of(rect);
    return sum / (layout.strip.width() * layout.strip.min.y);
}

}  // namespace viewing::test
