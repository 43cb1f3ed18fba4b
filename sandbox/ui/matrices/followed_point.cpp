#include "ui/matrices/followed_point.h"

#include <string>

#include "text/catalogue.h"
#include "text/words.h"
#include "ui/matrices/shown_matrix.h"
#include "ui/parts/look.h"

namespace viewing {

using widgets::Role;

namespace {

/// Draws one line about the followed point, which lessons know as `target`.
void followed_line(const char* target, const std::string& text, Role role) {
    if (widgets::IsCovered(target))
        widgets::Plate("value", {ImGui::GetContentRegionAvail().x, widgets::CurrentContext().fonts.number->FontSize});
    else
        widgets::ValueText(text.c_str(), role);
    widgets::MarkTarget(target);
}

/// "name = (   1.000,   2.000,   3.000 )", with the columns of all lines aligned. `w`: an optional fourth component.
void vector_line(const char* target, const char* name, const glm::dvec3& value, Role role, const double* w = nullptr) {
    constexpr std::size_t columns = 7;
    const auto padded = [](double number) {
        const std::string text = number_text(number, 3);
        const std::size_t shown = character_count(text);
        return std::string(shown < columns ? columns - shown : 0, ' ') + text;
    };
    // A word in another script has a different width: pad by pixels, not by characters.
    const ImFont& font = *widgets::CurrentContext().fonts.number;
    const auto width_of = [&font](const std::string& text) {
        return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, text.c_str()).x;
    };
    const float least = width_of("foot") - 0.5F * width_of(" ");
    std::string padded_name = name;
    while (width_of(padded_name) < least) padded_name += ' ';
    std::string text = padded_name + " = (" + padded(value.x) + "," + padded(value.y) + "," + padded(value.z);
    text += w ? "," + padded(*w) + " )" : " )";
    followed_line(target, text, role);
}

}  // namespace

void draw_followed_point(Session& session, const Derived& derived) {
    if (widgets::CurrentContext().printed && !session.params.follow) return;
    const bool has_several = derived.planes.size() > 1 || derived.lights_world.size() > 1;
    const std::string of = session.params.follow ? object_text(session.params.follow->object) : "";
    const bool says_which = has_several && derived.followed;
    const std::string note = says_which
                                 ? say("{object} · plane {plane}, light {light}", "object"_a = of,
                                       "plane"_a = derived.chosen.plane + 1, "light"_a = derived.chosen.light + 1)
                                 : of;
    const bool has_note = matrix_heading(marked("Follow a point"), "p", note, Role::point, place_at_right("Clear"));
    // Use the same height without a point, so that nothing below moves when one is clicked.
    const float top = ImGui::GetCursorPosY();
    const float bottom =
        top + 6.0F * (widgets::CurrentContext().fonts.number->FontSize + ImGui::GetStyle().ItemSpacing.y);
    if (!derived.followed) {
        widgets::Note(
            "Click a vertex of an object in the camera view to follow p, its shadow S p and its mirror image R p "
            "here.");
        ImGui::SetCursorPosY(bottom - ImGui::GetStyle().ItemSpacing.y);
        ImGui::Dummy({0.0F, 0.0F});
        return;
    }
    if (widgets::OffersButton("Clear")) {
        ImGui::SameLine(place_at_right("Clear"));
        if (widgets::SmallButton("Clear")) session.params.follow.reset();
    }
    if (!has_note) widgets::Note(note.c_str());
    const FollowedPoint& followed = *derived.followed;
    vector_line("follow:p", "p   ", followed.point_world, Role::point);
    vector_line("follow:S p", "S p ", glm::dvec3(followed.shadow_homogeneous), Role::none,
                &followed.shadow_homogeneous.w);
    if (followed.shadow_world)
        vector_line("follow:shadow", "÷ w ", *followed.shadow_world, Role::light);
    else
        followed_line("follow:shadow", tr("÷ w  at infinity: w = 0"), Role::trouble);
    vector_line("follow:mirrored", "R p ", followed.mirrored_world, Role::mirror);
    vector_line("follow:foot", tr("foot"), followed.foot_world, Role::plane);
    const std::string distance = "k    = n·p + d = " + number_text(followed.plane_distance, 3);
    followed_line("follow:distance", distance, Role::plane);
}

}  // namespace viewing
