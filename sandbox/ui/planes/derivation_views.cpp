#include "ui/planes/derivation_views.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "ui/parts/controls.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"
#include "ui/planes/derivation_diagram.h"
#include "ui/planes/derivation_forms.h"
#include "ui/planes/derivation_text.h"

namespace viewing {
namespace {

/// A view's rectangle with its figure at the left, or at the top of a narrow one; ends with its scope.
class FigureView {
public:
    FigureView(const char* name, const Rect& rect)
        : view_(name, rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse) {
        const ImVec2 from = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
        is_wide_ = room.x >= px(420.0F);
        const float width = is_wide_ ? std::floor(room.x * 0.43F) : std::max(room.x, 1.0F);
        const float height = is_wide_ ? std::max(room.y, 1.0F) : std::max(std::floor(room.y * 0.5F), px(60.0F));
        figure_ = {from, {from.x + width, from.y + height}};
        ImGui::Dummy({width, height});
        widgets::Record("figure");
    }
    const Rect& figure() const { return figure_; }
    bool is_wide() const { return is_wide_; }

private:
    ViewWindow view_;
    Rect figure_;
    bool is_wide_;
};

/// What stands beside or below the figure, and scrolls; ends with its scope.
class Steps {
public:
    explicit Steps(const FigureView& view) {
        if (view.is_wide()) ImGui::SameLine(0.0F, px(14.0F));
        ImGui::BeginChild("steps", {0.0F, 0.0F}, false);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(6.0F), px(3.0F)});
        is_short_ = ImGui::GetContentRegionAvail().y < px(420.0F);
    }
    ~Steps() {
        ImGui::PopStyleVar();
        ImGui::EndChild();
    }
    Steps(const Steps&) = delete;
    Steps& operator=(const Steps&) = delete;

    /// There is room for the results, not for every step that leads to them.
    bool is_short() const { return is_short_; }

private:
    bool is_short_;
};

/// "light: parallel [      ] point": l_w from 0 to 1, where x, y and z stay. In a narrow place the first words stand
/// above.
void light_slider(Params& params) {
    constexpr double smallest = 1e-6;
    glm::dvec4& light = params.lights[params.chosen().light].position;
    const bool has_direction = glm::length(glm::dvec3(light)) >= smallest;
    const widgets::NumberStyle style{.min = has_direction ? 0.0 : 0.01,  // never all zero
                                     .max = 1.0,
                                     .step = 0.005,
                                     .decimals = 3,
                                     .default_value = default_params().lights.front().position.w,
                                     .links = link::light[3],
                                     .role = widgets::Role::light};
    const float room = ImGui::GetContentRegionAvail().x, gap = px(8.0F), least = px(60.0F);
    const float before = ImGui::CalcTextSize(tr("light: parallel")).x + gap,
                behind = ImGui::CalcTextSize(tr("point")).x + gap;
    const bool in_a_row = before + least + behind <= room;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("light: parallel"));
    if (in_a_row) ImGui::SameLine(0.0F, gap);
    widgets::Slider("##l_w", light.w, style, std::clamp(room - behind - (in_a_row ? before : 0.0F), least, px(260.0F)));
    widgets::Tooltip("Parallel or point light",
                     "The light's fourth coordinate. 1: a point light at l. 0: a parallel light from the direction (x, "
                     "y, z). Between them the light is at (x, y, z) divided by it, farther away the smaller it is.");
    ImGui::SameLine(0.0F, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("point"));
}

void tell_point(const Derived& derived, const char* letter) {
    if (derived.followed) return;
    const std::string note =
        say("Click an object to follow one of its vertices; until then {point} is one unit from the middle of the "
            "plane's patch, on the light's side.",
            "point"_a = letter);
    widgets::Note(note.c_str());
}

void tell_ray(ShadowRay ray) {
    if (ray == ShadowRay::regular) return;
    if (ray == ShadowRay::point_in_plane) return widgets::Note(sentence_of(ray));  // nothing is wrong with it
    widgets::Trouble(sentence_of(ray));
}

std::string signed_sum(std::span<const double> terms) {
    std::string text;
    for (std::size_t term = 0; term < terms.size(); ++term) {
        if (term > 0) text += terms[term] < 0.0 ? " − " : " + ";
        text += derivation_number(term > 0 ? std::abs(terms[term]) : terms[term]);
    }
    return text;
}

void plane_line(const glm::dvec4& unit_plane) {
    equation({"n", "= " + derivation_vector(glm::dvec3(unit_plane)), "d = " + derivation_number(unit_plane.w)});
}

/// "a/(b − c)" with numbers: a negative c in brackets.
std::string quotient(double over, double from, double minus) {
    const std::string subtracted = derivation_number(minus);
    return "= " + derivation_number(over) + "/(" + derivation_number(from) + " − " +
           (subtracted.starts_with("−") ? "(" + subtracted + ")" : subtracted) + ")";
}

void point_light_steps(const ShadowDerivation& found, bool is_blinn, bool is_short) {
    equation({"s", "= l + t (p − l)"});
    equation({"n·s + d", "= 0"});
    if (!is_short) {
        equation({"n·(l + t (p − l)) + d", "= 0"});
        equation({"t (n·p − n·l)", "= −d − n·l"});
    }
    if (!found.shadow_world) return;
    const std::string t = "= " + derivation_number(found.t);
    equation({"t", "= (n·l + d)/(n·l − n·p)", quotient(found.light_height, found.n_dot_l, found.n_dot_p), t});
    if (is_blinn)
        equation({"t", "= l_y/(l_y − p_y)",
                  is_short ? "" : quotient(found.light_world.y, found.light_world.y, found.point_world.y),
                  is_short ? "" : t, marked("for y = 0")});
    equation({"s", "= " + derivation_vector(*found.shadow_world)});
    const double length_ratio = std::abs(found.t);
    equation({"|s − l|", found.t < 0.0 ? "= |t| |p − l|" : "= t |p − l|",
              "= " + derivation_number(length_ratio) + "·" + derivation_number(found.light_to_point),
              "= " + derivation_number(found.light_to_shadow)});
}

void parallel_light_steps(const ShadowDerivation& found, bool is_short) {
    equation({"s", "= p + τ l", marked("for l_w = 0")});
    equation({"n·s + d", "= 0"});
    if (!is_short) equation({"n·(p + τ l) + d", "= 0"});
    if (!found.shadow_world) return;
    equation({"τ", "= −(n·p + d)/(n·l)",
              "= −" + derivation_number(found.point_height) + "/" + derivation_number(found.n_dot_l),
              "= " + derivation_number(found.t)});
    equation({"s", "= " + derivation_vector(*found.shadow_world)});
    equation({"|s − p|", "= " + derivation_number(found.point_to_shadow)});
}

/// The lecture's expansion of q′, row by row, with the slip of its second line put right.
void expansion(const MirrorDerivation& found) {
    derivation_heading(marked("Expanded"));
    static constexpr const char* rows[3][5] = {{"x_0′", "= (1 - 2a^2) x_0", "- 2ab y_0", "- 2ac z_0", "- 2ad"},
                                               {"y_0′", "= -2ab x_0", "+ (1 - 2b^2) y_0", "- 2bc z_0", "- 2bd"},
                                               {"z_0′", "= -2ac x_0", "- 2bc y_0", "+ (1 - 2c^2) z_0", "- 2cd"}};
    for (int row = 0; row < 3; ++row) {
        const auto& [name, x, y, z, d] = rows[row];
        equation({name, x, y, z, d, "= " + signed_sum(found.terms[row]),
                  "= " + derivation_number(found.mirrored_world[row])});
    }
    widgets::Note("The slide's second line begins with 2ab x₀; it is −2ab x₀.");
}

void mirror_form(const MirrorDerivation& found) {
    static constexpr const char* headings[] = {marked("R for the yz-plane"), marked("R for the xz-plane"),
                                               marked("R for the xy-plane"), marked("R for any plane")};
    derivation_heading(headings[static_cast<std::size_t>(found.plane)]);
    const float width = std::min(ImGui::GetContentRegionAvail().x, px(420.0F));
    MatrixCells cells = mirror_cells();
    widgets::Matrix("R derived", found.mirrored_world_from_world, {.cells = cells, .roles = mirror_roles()}, width);
    if (found.plane == MirrorPlane::general)
        widgets::Note("The buttons yz, xz and xy of the plane give the three that the slide shows.");
}

}  // namespace

void draw_shadow_derivation(Session& session, const Derived& derived, const Rect& rect) {
    Params& params = session.params;
    const DerivedPlane& plane = derived.chosen_plane();
    const ShadowDerivation found = derive_shadow(plane.unit_plane, derived.chosen_light(), derivation_point(derived));
    const ShadowForms forms = shadow_forms(plane.unit_plane, derived.chosen_light());
    const FigureView view("shadow derivation", rect);
    draw_shadow_diagram(view.figure(), found, 3.0 * plane.patch.extent);

    const Steps steps(view);
    light_slider(params);
    tell_ray(found.ray);
    if (derived.chosen_shadow().by_hand) widgets::Note("S is entered by hand; here it is as derived.");
    equation({"l", found.parallel_light || found.light.w == 1.0 ? "" : "= (x, y, z)/l_w",
              "= " + derivation_vector(found.light_world)});
    equation({"p", "= " + derivation_vector(found.point_world)});
    if (!steps.is_short()) {
        plane_line(found.unit_plane);
        derivation_heading(marked("Step by step"));
    }
    if (found.parallel_light)
        parallel_light_steps(found, steps.is_short());
    else
        point_light_steps(found, forms.blinn.has_value(), steps.is_short());
    if (steps.is_short()) plane_line(found.unit_plane);
    tell_point(derived, "p");
    show_three_forms(forms);
}

void draw_mirror_derivation(const Derived& derived, const Rect& rect) {
    const MirrorDerivation found = derive_mirror(derived.chosen_plane().unit_plane, derivation_point(derived));
    const FigureView view("mirror derivation", rect);
    draw_mirror_diagram(view.figure(), found);

    const Steps steps(view);
    if (derived.chosen_plane().mirror_by_hand) widgets::Note("R is entered by hand; here it is as derived.");
    equation({"q", "= " + derivation_vector(found.point_world)});
    plane_line(found.unit_plane);
    equation({"k", "= n·q + d", "= " + derivation_number(found.k)});
    equation({marked("foot"), "= q − k n", "= " + derivation_vector(found.foot_world)});
    equation({"q′", "= q − 2 k n", "= " + derivation_vector(found.mirrored_world)});
    tell_point(derived, "q");
    expansion(found);
    mirror_form(found);
}

}  // namespace viewing
