// A figure as on a slide: lines, marks, and labels in a cross-section. cross_section.h defines the placement.
#pragma once

#include <string>
#include <vector>

#include "ui/parts/cross_section.h"

namespace viewing {

/// Draws into the current window immediately, except for labels: the destructor places them in free space. Positions
/// are in world space, sizes in design pixels.
class Figure {
public:
    explicit Figure(const CrossSection& section) : draw_(ImGui::GetWindowDrawList()), section_(section) {}
    ~Figure();
    Figure(const Figure&) = delete;
    Figure& operator=(const Figure&) = delete;

    /// Whether symbols fit beside the numbers.
    static bool has_room(const Rect& rect);
    bool has_room() const { return has_room(section_.rect()); }

    void line(const glm::dvec3& from, const glm::dvec3& to, ImU32 color, float thickness = 1.6F);
    void dashed(const glm::dvec3& from, const glm::dvec3& to, ImU32 color);
    void triangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, ImU32 color, ImU32 alpha);
    void dot(const glm::dvec3& point, ImU32 color, float radius = 4.5F);
    /// Draws the right-angle mark between the plane and a perpendicular.
    void right_angle(const glm::dvec3& foot, const glm::dvec3& across, const glm::dvec3& up);
    void name(const glm::dvec3& point, const char* text, ImU32 color);
    /// Labels the middle of a line's visible part: "|p − l| = 3.91", or only the number if the figure is small.
    void measure(const glm::dvec3& from, const glm::dvec3& to, const char* symbol, double value, ImU32 color);
    /// Labels a vertical line in the same way, with a dimension line to its left.
    void dimension(const glm::dvec3& from, const glm::dvec3& to, const char* symbol, double value, ImU32 color);
    /// Gives the area around this line the name by which lessons refer to it.
    void mark_target(const char* name, const glm::dvec3& from, const glm::dvec3& to) const;

private:
    struct Label {
        ImVec2 place;
        std::string text;
        ImU32 color;
        bool is_name;
    };
    struct Segment {
        ImVec2 from, to;
    };
    /// Returns the part of a line inside the rectangle, or the whole line if no part of it is inside.
    Segment seen(ImVec2 from, ImVec2 to) const;
    ImVec2 middle_seen(ImVec2 from, ImVec2 to) const;
    std::string measure_text(const char* symbol, double value) const;
    ImFont* number_font() const;

    ImDrawList* draw_;
    const CrossSection& section_;
    std::vector<ImVec2> marks_;
    std::vector<Rect> taken_;
    std::vector<Segment> lines_;
    std::vector<Label> labels_;
};

}  // namespace viewing
