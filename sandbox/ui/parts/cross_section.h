// A cross-section of the world, perpendicular to a plane, fitted into a rectangle of the screen with the same scale on
// both axes.
#pragma once

#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

class CrossSection {
public:
    /// Cuts the world at `foot_world`, a point on the plane. `across` runs along the plane and `up` away from it; both
    /// are unit vectors in world space. If `upright`, the plane's line is vertical in the picture and `up` points
    /// right.
    CrossSection(const Rect& rect, const glm::dvec3& foot_world, const glm::dvec3& across, const glm::dvec3& up,
                 bool upright = false);

    /// Pixels to keep free around the content.
    struct Margins {
        float left, right, top, bottom;
    };
    /// Chooses the scale at which these points fit; other points may fall outside.
    void fit(std::span<const glm::dvec3> points_world, const Margins& margins_px);

    ImVec2 place(const glm::dvec3& point_world) const;

    /// Draws the plane as a line through the whole rectangle, shades the side that `up` points away from, and draws the
    /// normal at one end. `along_up` says whether the normal points along `up`.
    void draw_plane(ImDrawList* draw, bool along_up) const;

    /// Returns the area on screen around the plane's line; labels avoid it.
    Rect plane_strip() const;
    /// Returns the area that the normal and its letter may cover, on either side of the plane.
    Rect normal_area() const;

    const Rect& rect() const { return rect_; }

private:
    glm::dvec2 flat(const glm::dvec3& point_world) const;
    ImVec2 place(const glm::dvec2& flat) const;

    Rect rect_;
    glm::dvec3 foot_world_, across_, up_;
    bool upright_;
    glm::dvec2 middle_{0.0};  ///< center of the content, in section coordinates
    ImVec2 middle_px_{0.0F, 0.0F};
    double scale_ = 1.0;  ///< pixels per world unit
};

}  // namespace viewing
