// Points and lines of the world drawn over a picture of it, clipped at the eye, anti-aliased by ImGui.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "geometry/ray.h"
#include "ui/parts/layout.h"
#include "widgets/widgets.h"

namespace viewing {

class Overlay {
public:
    Overlay(ImDrawList* draw, const Rect& rect, const glm::dmat4& clip_from_world);
    ~Overlay();
    Overlay(const Overlay&) = delete;
    Overlay& operator=(const Overlay&) = delete;

    /// Where a point of the world is on screen; none behind the eye.
    std::optional<ImVec2> project(const glm::dvec3& point_world) const;
    /// The ray of the world under a place on screen.
    Ray ray_at(ImVec2 place) const;

    void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 1.6F);
    void dashed(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 1.6F);
    /// A translucent quad; left out when a corner lies behind the eye.
    void fill(const std::array<glm::dvec3, 4>& corners, ImU32 color);
    void dot(const glm::dvec3& point, ImU32 color, float radius = 4.0F);
    void ring(const glm::dvec3& point, ImU32 color, float radius);
    void square(const glm::dvec3& point, ImU32 color, float half_size);
    void arrow(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 2.0F);
    /// Labels are placed when the overlay ends, beside their points and not over each other.
    void label(const glm::dvec3& point, const char* text, ImU32 color);
    /// An arrow at the picture's edge that shows the way to a point outside it, with a label; true when the point is
    /// there.
    bool arrow_at_edge(const glm::dvec3& point, const char* text, ImU32 color);
    /// What stands about this line bears a name for a lesson (widgets/targets.h).
    void mark_target(const char* name, const glm::dvec3& from, const glm::dvec3& to);
    /// A cross in a ring with a label on a plate; an arrow at the edge where it is outside the picture.
    void target(const glm::dvec3& point, const char* text, ImU32 color);
    /// No label covers this part of the picture.
    void keep_labels_off(const Rect& taken) { taken_.push_back(taken); }
    bool is_free(const Rect& part) const;

    ImDrawList* draw() const { return draw_; }
    const Rect& rect() const { return rect_; }

private:
    struct Label {
        ImVec2 place;
        std::string text;
        ImU32 color;
    };
    struct Segment {
        ImVec2 from, to;
    };
    std::optional<Segment> segment(const glm::dvec3& from, const glm::dvec3& to) const;
    ImVec2 place_of(const glm::dvec4& clip) const;

    ImDrawList* draw_;
    Rect rect_;
    glm::dmat4 clip_from_world_;
    float scale_, stroke_;
    std::vector<Label> labels_;
    std::vector<Rect> taken_;
};

}  // namespace viewing
