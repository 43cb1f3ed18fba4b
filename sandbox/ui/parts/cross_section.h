// A cross-section of the world: what lies in one plane upright on another, fitted into a rectangle of the screen with
// the same scale both ways.
#pragma once

#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

class CrossSection {
public:
    /// Through `foot_world` on the plane; `across` along the plane and `up` away from it, both unit vectors of the
    /// world. `upright`: the plane's line stands upright in the picture, and `up` is to the right.
    CrossSection(const Rect& rect, const glm::dvec3& foot_world, const glm::dvec3& across, const glm::dvec3& up,
                 bool upright = false);

    /// Pixels that stay free around what is shown.
    struct Margins {
        float left, right, top, bottom;
    };
    /// Fits these points; whatever else lies outside.
    void fit(std::span<const glm::dvec3> points_world, const Margins& margins_px);

    ImVec2 place(const glm::dvec3& point_world) const;

    /// The plane as a line through the whole rectangle, its back side shaded, with its normal at one end; `along_up`
    /// says whether the normal points along `up`.
    void draw_plane(ImDrawList* draw, bool along_up) const;

    /// Of the screen, around the plane's line: labels keep off it.
    Rect plane_strip() const;
    /// Where the normal and its letter may be, on either side.
    Rect normal_area() const;

    const Rect& rect() const { return rect_; }

private:
    glm::dvec2 flat(const glm::dvec3& point_world) const;
    ImVec2 place(const glm::dvec2& flat) const;

    Rect rect_;
    glm::dvec3 foot_world_, across_, up_;
    bool upright_;
    glm::dvec2 middle_{0.0};  ///< in the section, of what is shown
    ImVec2 middle_px_{0.0F, 0.0F};
    double scale_ = 1.0;  ///< pixels per unit
};

}  // namespace viewing
