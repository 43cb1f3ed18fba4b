// Draws points and lines in world space over a picture of the world. Lines are clipped at the eye; ImGui anti-aliases
// them.
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

    /// Returns a world point's position on screen; nullopt if the point is behind the eye.
    std::optional<ImVec2> project(const glm::dvec3& point_world) const;
    /// Returns the ray in world space through a screen position.
    Ray ray_at(ImVec2 place) const;

    void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 1.6F);
    void dashed(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 1.6F);
    /// Draws a translucent quad, unless a corner is behind the eye.
    void fill(const std::array<glm::dvec3, 4>& corners, ImU32 color);
    void dot(const glm::dvec3& point, ImU32 color, float radius = 4.0F);
    void ring(const glm::dvec3& point, ImU32 color, float radius);
    void square(const glm::dvec3& point, ImU32 color, float half_size);
    void arrow(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 2.0F);
    /// Adds a label. The destructor places all labels beside their points, without overlap.
    void label(const glm::dvec3& point, const char* text, ImU32 color);
    /// If a point is outside the picture, draws a labeled arrow toward it at the picture's edge. Returns whether it is
    /// outside.
    bool arrow_at_edge(const glm::dvec3& point, const char* text, ImU32 color);
    /// Gives the area around this line the name by which lessons refer to it (widgets/targets.h).
    void mark_target(const char* name, const glm::dvec3& from, const glm::dvec3& to);
    /// Draws a cross in a ring with a label on a plate, or an arrow at the edge if the point is outside the picture.
    void target(const glm::dvec3& point, const char* text, ImU32 color);
    /// Keeps labels off this part of the picture.
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
    /// Like segment(), but for a line that will be drawn: also keeps labels off the line.
    std::optional<Segment> drawn(const glm::dvec3& from, const glm::dvec3& to);
    ImVec2 place_of(const glm::dvec4& clip) const;

    ImDrawList* draw_;
    Rect rect_;
    glm::dmat4 clip_from_world_;
    float scale_, stroke_;
    std::vector<Label> labels_;
    std::vector<Rect> taken_;
    std::vector<Segment> lines_;
};

}  // namespace viewing
