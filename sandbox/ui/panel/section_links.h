// Links below the panel to the sections that are out of view. They show that there are more controls, and a click on a
// link goes to its section. Without the links, a short window hides whole topics.
#pragma once

#include <string>
#include <vector>

#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

class SectionLinks {
public:
    /// Returns the height that the links take from the panel's rectangle; 0 if all its content fits.
    float height_px(const Rect& panel) const;

    /// Call at the end of the panel's window. Records where its sections are and which part is visible.
    void note();

    /// Draws the links into the current window, which fills their rectangle.
    void draw() const;

private:
    struct Link {
        widgets::SectionPlace place;
        float width_px;
    };
    std::vector<Link> links_;
    float content_px_ = 0.0F, scroll_px_ = 0.0F, seen_px_ = 0.0F;
    float line_px_ = 0.0F;  ///< the height of a line of links
};

}  // namespace viewing
