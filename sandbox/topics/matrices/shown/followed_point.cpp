#include "topics/matrices/shown/followed_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "state/fields.h"
#include "text/catalogue.h"
#include "text/per_enum.h"
#include "text/words.h"
#include "topics/camera/numbers/camera_way.h"
#include "topics/depth/numbers/fragment_text.h"
#include "topics/matrices/shown/shown_matrix.h"
#include "ui/parts/look.h"

namespace viewing {

using widgets::Role;

namespace {

constexpr const char* type_button = marked("Type p");

/// Draws one line about the followed point: its name, then its value, which starts at `column`. `target` is the line's
/// name in lessons.
void followed_line(const char* target, const char* name, float column, const std::string& value, Role role,
                   bool is_covered) {
    if (is_covered) {
        widgets::Plate("value", {ImGui::GetContentRegionAvail().x, widgets::CurrentContext().fonts.number->FontSize});
    } else {
        ImGui::BeginGroup();
        widgets::ValueText(name, role);
        ImGui::SameLine(column);
        widgets::ValueText(value.c_str(), role);
        ImGui::EndGroup();
    }
    widgets::MarkLine(target);
}

/// Returns "= (   1.000,   2.000,   3.000 )", padded so that the columns of all lines align. `w`: an optional fourth
/// component.
std::string vector_text(const glm::dvec3& value, std::size_t columns, const double* w = nullptr) {
    const auto padded = [columns](double number) {
        const std::string text = number_text(number, 3);
        const std::size_t shown = character_count(text);
        return std::string(shown < columns ? columns - shown : 0, ' ') + text;
    };
    const std::string text = "= (" + padded(value.x) + "," + padded(value.y) + "," + padded(value.z);
    return w ? text + "," + padded(*w) + " )" : text + " )";
}

/// Returns the width of a text in the number font.
float number_width(const char* text) {
    const ImFont& font = *widgets::CurrentContext().fonts.number;
    return font.CalcTextSizeA(font.FontSize, FLT_MAX, 0.0F, text).x;
}

}  // namespace

namespace {

/// Where a line's value begins, and the number of characters to which each component of a vector is padded.
struct LineStyle {
    float column;
    std::size_t digits;
};

/// Draws p: as text or, if the point is not a vertex, as number fields. `text`: the value of p.
void point_line(Params& params, float column, const std::string& text) {
    if (!params.follow->point || widgets::IsCovered("follow:p"))
        return followed_line("follow:p", "p", column, text, Role::point, widgets::IsCovered("follow:p"));
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    widgets::ValueText("p", Role::point);
    ImGui::SameLine(column);
    const Field& range = field("follow");
    const widgets::NumberStyle style{
        .min = range.min, .max = range.max, .step = 0.02, .decimals = 3, .role = Role::point};
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    widgets::Vec3("##p", *params.follow->point, style);
    ImGui::EndGroup();
    widgets::MarkLine("follow:p");
}

/// Draws a button in the heading's row, starting at `left`. The button starts following a user-defined point at
/// `start`.
void offer_to_type(Params& params, float left, const glm::dvec3& start) {
    if (!widgets::OffersButton(type_button)) return;
    ImGui::SameLine(left);
    if (widgets::SmallButton(type_button)) params.follow = Follow{.object = "", .point = start};
    widgets::Tooltip(type_button, "Follows a point that you can type here and drag in the views, instead of a vertex.");
}

/// Draws p's path through V and P to its pixel or, if `only_view`, only V p. If a lesson covers one of these matrices,
/// also covers the numbers that would give it away.
void draw_camera_numbers(const Params& params, const Derived& derived, const LineStyle& style, bool only_view) {
    const CameraWay way = camera_way(params, derived, derived.followed->point_world);
    const bool is_covered = widgets::IsPartCovered("matrix:V") || (!only_view && widgets::IsPartCovered("matrix:P"));
    const auto line = [&](const char* name, const std::string& value, Role role) {
        const float width = std::ceil(number_width(name) + number_width(" "));
        followed_line("matrix:V", name, std::max(style.column, width), value, role, is_covered);
    };
    line("V p", vector_text(way.point_view, style.digits), Role::camera);
    if (only_view) return;
    line("P V p", vector_text(glm::dvec3(way.point_clip), style.digits, &way.point_clip.w), Role::none);
    if (way.point_ndc)
        line("÷ w", vector_text(*way.point_ndc, style.digits), Role::camera);
    else
        line("÷ w", tr("at infinity: w = 0"), Role::trouble);
    std::string place = "= —", code = "—";
    if (way.point_ndc) {
        const glm::dvec2 at = 0.5 * (glm::dvec2(*way.point_ndc) + 1.0) * glm::dvec2(derived.view_px);
        place = "= (" + number_text(at.x, 1) + ", " + number_text(at.y, 1);
        place += way.window_depth ? ", " + number_text(*way.window_depth, 6) + ")" : ")";
    }
    if (way.window_depth) code = code_text(way.code, precision_of(params.depth.format));
    line(tr("window"), place, Role::none);
    line(tr("code"), "= " + code + ", " + tr(outcome_of(way.cut_by)),
         way.cut_by == FrustumPlane::none ? Role::none : Role::trouble);
}

}  // namespace

bool is_named(std::span<const std::string> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_matrix(std::string_view name) {
    return name != "follow" && name != "display";
}

PointNumbers point_numbers(std::span<const std::string> listed, bool has_shadow, bool has_mirror) {
    if (!is_named(listed, "S") && !is_named(listed, "R")) {
        if (is_named(listed, "P")) return PointNumbers::camera;
        if (is_named(listed, "V")) return PointNumbers::view;
    }
    if (has_shadow == has_mirror) return PointNumbers::plane;
    return has_shadow ? PointNumbers::shadow : PointNumbers::mirror;
}

int lines_of(PointNumbers numbers) {
    static constexpr auto lines = per_enum<PointNumbers>(6, 3, 4, 2, 6, 11);
    return lines[numbers];
}

float followed_point_height(const Session& session, PointNumbers numbers) {
    const int lines = lines_of(numbers);
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float line = widgets::CurrentContext().fonts.number->FontSize, field = ImGui::GetFrameHeight();
    const auto& follow = session.params.follow;
    const float height =
        follow ? static_cast<float>(lines) * (line + spacing) + (follow->point ? field - line : 0.0F) : 0.0F;
    return ImGui::GetFrameHeight() + spacing + height;
}

void draw_followed_point(Session& session, const Derived& derived, PointNumbers numbers) {
    if (widgets::CurrentContext().printed && !session.params.follow) return;
    const bool has_several = derived.planes.size() > 1 || derived.lights_world.size() > 1;
    const std::string of =
        session.params.follow && !session.params.follow->point ? object_text(session.params.follow->object) : "";
    const bool says_which = has_several && derived.followed;
    const std::string note = says_which
                                 ? say("{object} · plane {plane}, light {light}", "object"_a = of,
                                       "plane"_a = derived.chosen.plane + 1, "light"_a = derived.chosen.light + 1)
                                 : of;
    if (!derived.followed) {
        const std::string how = tr("click a vertex of an object");
        const bool has_note =
            matrix_heading(marked("Follow a point"), "p", how, Role::point, place_at_right(type_button));
        widgets::Tooltip("Follow a point",
                         "Click a vertex of an object in the camera view. The coordinates of this vertex p and of its "
                         "images are then shown here.");
        offer_to_type(session.params, place_at_right(type_button), session.params.camera.target);
        if (!has_note) widgets::Note(how.c_str());
        return;
    }
    const bool is_vertex = !session.params.follow->point && widgets::OffersButton(type_button);
    const float type_place = place_at_right("Clear") - widgets::SmallButtonWidth(type_button) - px(4.0F);
    const bool has_note = matrix_heading(marked("Follow a point"), "p", note, Role::point,
                                         is_vertex ? type_place : place_at_right("Clear"));
    if (is_vertex) offer_to_type(session.params, type_place, derived.followed->point_world);
    if (widgets::OffersButton("Clear")) {
        ImGui::SameLine(place_at_right("Clear"));
        if (widgets::SmallButton("Clear")) return session.params.follow.reset();
    }
    if (!has_note && !note.empty()) widgets::Note(note.c_str());
    const FollowedPoint& followed = *derived.followed;
    const char* const foot = tr("foot");
    const glm::dvec4& shadow = followed.shadow_homogeneous;
    const auto column_of = [](const char* longest) { return std::ceil(number_width(longest) + number_width(" ")); };
    const auto fits = [&](float column, std::size_t digits) {
        const std::string widest = vector_text(glm::dvec3(shadow), digits, &shadow.w);
        return column + number_width(widest.c_str()) <= ImGui::GetContentRegionAvail().x;
    };
    // If a long translation of "foot" leaves too little space for the widest line, only the value on the foot's line
    // starts farther right.
    const float wide = std::max(column_of("S p"), column_of(foot));
    const float column = fits(wide, 6) ? wide : column_of("S p");
    const bool has_camera = numbers >= PointNumbers::view;
    const float first_column =
        !has_camera ? column : std::max({column_of("P V p"), column_of(tr("window")), column_of(tr("code")), column});
    const std::size_t digits = fits(first_column, 7) ? 7U : 6U;
    point_line(session.params, std::max(first_column, column_of("p")), vector_text(followed.point_world, digits));
    if (has_camera) draw_camera_numbers(session.params, derived, {first_column, digits}, numbers == PointNumbers::view);
    if (has_camera && numbers != PointNumbers::both) return;
    const auto vector = [digits](const glm::dvec3& value, const double* w = nullptr) {
        return vector_text(value, digits, w);
    };
    const auto line = [&](const char* target, const char* name, const std::string& value, Role role) {
        followed_line(target, name, std::max(first_column, column_of(name)), value, role, widgets::IsCovered(target));
    };
    if (numbers != PointNumbers::mirror) {
        line("follow:S p", "S p", vector(glm::dvec3(shadow), &shadow.w), Role::none);
        if (followed.shadow_world)
            line("follow:shadow", "÷ w", vector(*followed.shadow_world), Role::light);
        else
            line("follow:shadow", "÷ w", tr("at infinity: w = 0"), Role::trouble);
    }
    if (numbers == PointNumbers::shadow) return;
    line("follow:mirrored", "R p", vector(followed.mirrored_world), Role::mirror);
    line("follow:foot", foot, vector(followed.foot_world), Role::plane);
    line("follow:distance", "k", "= n·p + d = " + number_text(followed.plane_distance, 3), Role::plane);
}

}  // namespace viewing
