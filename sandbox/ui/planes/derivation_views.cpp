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
#include "ui/planes/derivation_lines.h"
#include "ui/planes/derivation_text.h"

namespace viewing {
namespace {

constexpr float least_bar = 215.0F;  ///< width of a step bar, in design pixels

/// A view with its figure at the left, or at the top if the view is narrow or tall. Below a figure at the left there is
/// room for rows of controls, so that the lines have the height of the view. Closes at the end of its scope.
class FigureView {
public:
    FigureView(const char* name, const Rect& rect, int control_rows)
        : view_(name, rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse) {
        const ImVec2 from = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
        // A stage's lines are longer: there, a text beside the figure is cut unless the view is very low.
        const float least_aspect = widgets::HasPlainTitles() && room.x < px(520.0F) ? 2.0F : 1.3F;
        is_wide_ = room.x >= px(420.0F) && room.x >= least_aspect * room.y;
        const float width = is_wide_ ? std::floor(room.x * 0.43F) : std::max(room.x, 1.0F);
        const float controls = static_cast<float>(control_rows) * (ImGui::GetFrameHeight() + px(control_gap));
        const bool has_bar = !widgets::HasPlainTitles() && !widgets::CurrentContext().printed;
        has_controls_ = is_wide_ && has_bar && width >= px(least_bar) && room.y - controls >= px(least_figure);
        const float wide = room.y - (has_controls_ ? controls : 0.0F);
        const float height = is_wide_ ? std::max(wide, 1.0F) : std::max(std::floor(room.y * 0.5F), px(60.0F));
        figure_ = {from, {from.x + width, from.y + height}};
        ImGui::Dummy({width, height});
        widgets::Record("figure");
    }
    const Rect& figure() const { return figure_; }
    bool is_wide() const { return is_wide_; }
    /// Whether the controls are below the figure, not above the lines.
    bool has_controls() const { return has_controls_; }

    static constexpr float control_gap = 3.0F, least_figure = 80.0F;  ///< design pixels

private:
    ViewWindow view_;
    Rect figure_;
    bool is_wide_, has_controls_ = false;
};

/// The controls below the figure. Closes at the end of its scope.
class FigureControls {
public:
    explicit FigureControls(const FigureView& view) : behind_(ImGui::GetCursorScreenPos()) {
        ImGui::SetCursorScreenPos({view.figure().min.x, view.figure().max.y + px(FigureView::control_gap)});
        ImGui::BeginChild("controls", {view.figure().width(), 0.0F}, false, ImGuiWindowFlags_NoScrollbar);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(6.0F), px(FigureView::control_gap)});
    }
    ~FigureControls() {
        ImGui::PopStyleVar();
        ImGui::EndChild();
        ImGui::SetCursorScreenPos(behind_);
    }
    FigureControls(const FigureControls&) = delete;
    FigureControls& operator=(const FigureControls&) = delete;

private:
    ImVec2 behind_;
};

/// The scrolling text beside or below the figure. Closes at the end of its scope.
class Steps {
public:
    explicit Steps(const FigureView& view) {
        if (view.is_wide()) ImGui::SetCursorScreenPos({view.figure().max.x + px(14.0F), view.figure().min.y});
        ImGui::BeginChild("steps", {0.0F, 0.0F}, false);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(6.0F), px(3.0F)});
        is_short_ = ImGui::GetContentRegionAvail().y < px(420.0F);
    }
    ~Steps() {
        ImGui::PopStyleVar();
        widgets::CountScrolled();
        ImGui::EndChild();
    }
    Steps(const Steps&) = delete;
    Steps& operator=(const Steps&) = delete;

    /// Whether there is space for the results, but not for every step toward them.
    bool is_short() const { return is_short_; }

private:
    bool is_short_;
};

/// Draws "light: parallel [      ] point", a slider for l_w from 0 to 1; x, y and z stay the same. In a narrow view,
/// the first label is above the slider.
void light_slider(Params& params) {
    if (widgets::HasPlainTitles()) return;  // the panel has this control, with its name
    constexpr double smallest = 1e-6;
    glm::dvec4& light = params.lights[params.chosen().light].position;
    const bool has_direction = glm::length(glm::dvec3(light)) >= smallest;
    const widgets::NumberStyle style{.min = has_direction ? 0.0 : 0.01,  // never let all four be zero
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
    widgets::Tooltip(
        "Parallel or point light",
        "The light's fourth coordinate, w. 1: a point light at ℓ. 0: a parallel light from the direction (x, y, z). In "
        "between, the light is at (x, y, z) ÷ w: the smaller w is, the farther away the light.");
    ImGui::SameLine(0.0F, gap);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(tr("point"));
}

void tell_point(const Derived& derived, const char* letter) {
    if (derived.followed) return;
    const std::string note =
        say("Click an object to follow one of its vertices; until then, {point} is one unit from the center of the "
            "plane's patch, on the light's side.",
            "point"_a = letter);
    widgets::Note(note.c_str());
}

void tell_ray(ShadowRay ray) {
    if (ray == ShadowRay::regular) return;
    if (ray == ShadowRay::point_in_plane) return widgets::Note(sentence_of(ray));  // not an error
    widgets::Trouble(sentence_of(ray));
}

void plane_line(const glm::dvec4& unit_plane) {
    equation({"n", "= " + derivation_vector(glm::dvec3(unit_plane)), "d = " + derivation_number(unit_plane.w)});
}

void write_shown(const DerivationLine& line) {
    switch (line.kind) {
        case DerivationLine::Kind::equation:
            return equation(line.parts);
        case DerivationLine::Kind::heading:
            return derivation_heading(line.parts.front().c_str());
        case DerivationLine::Kind::note:
            return widgets::Note(line.parts.front().c_str());
    }
}

/// Whether this line, or another part that shows the same numbers, is covered.
bool is_covered(const std::string& target) {
    struct Same {
        std::string_view line;
        const char* elsewhere;
    };
    static constexpr Same all[] = {{"text:mirror_derivation.k", "follow:distance"},
                                   {"text:mirror_derivation.foot", "follow:foot"},
                                   {"text:mirror_derivation.mirrored", "follow:mirrored"},
                                   {"text:mirror_derivation.rows", "follow:mirrored"},
                                   {"text:mirror_derivation.rows", "matrix:R"},
                                   {"text:shadow_derivation.lines", "follow:shadow"},
                                   {"text:shadow_derivation.lines", "follow:S p"},
                                   {"text:shadow_derivation.lines", "matrix:S"}};
    return widgets::IsCovered(target) || std::any_of(std::begin(all), std::end(all), [&target](const Same& same) {
               return same.line == target && widgets::IsPartCovered(same.elsewhere);
           });
}

void write(const DerivationLine& line) {
    if (is_covered(line.target)) {
        widgets::Plate("line", {ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()});
        return widgets::MarkTarget(line.target);
    }
    const ImVec2 from = ImGui::GetCursorScreenPos();
    write_shown(line);
    widgets::MarkTarget(line.target, from, {from.x + ImGui::GetContentRegionAvail().x, ImGui::GetItemRectMax().y});
}

/// Writes all lines, or those up to the state's step; omits intermediate steps if `is_short`. Scrolls to the latest
/// line if the step was just chosen. Returns true when all are written.
bool write_lines(const std::vector<DerivationLine>& lines, int step, bool is_short, bool is_stepped) {
    const std::vector<DerivationLine> shown = lines_until(lines, step);
    for (const DerivationLine& line : shown)
        if (!is_short || !line.is_step) write(line);
    if (is_stepped) ImGui::SetScrollHereY(1.0F);
    return shown.size() == lines.size();
}

/// Draws the step bar. Returns true when a step was chosen.
bool step_bar(Params& params, const std::vector<DerivationLine>& lines, widgets::StepPlayer& player) {
    if (ImGui::GetContentRegionAvail().x < px(least_bar)) return false;
    int& step = params.view.derivation_step;
    const int before = step;
    widgets::StepBar("derivation", step, step_count(lines), player, ImGui::GetIO().DeltaTime);
    return step != before && step >= 0;
}

/// Draws a plate if this part of the derivation is covered. Returns whether it is.
bool is_part_covered(const char* target, float height) {
    if (!widgets::IsCovered(target)) return false;
    widgets::Plate(target, {ImGui::GetContentRegionAvail().x, std::max(height, px(20.0F))});
    widgets::MarkTarget(target);
    return true;
}

void mirror_form(const MirrorDerivation& found) {
    constexpr float plate_height = 130.0F;
    if (is_part_covered("text:mirror_derivation.matrix", px(plate_height))) return;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    static constexpr const char* headings[] = {marked("R for the yz-plane"), marked("R for the xz-plane"),
                                               marked("R for the xy-plane"), marked("R for any plane")};
    derivation_heading(headings[static_cast<std::size_t>(found.plane)]);
    const float width = std::min(ImGui::GetContentRegionAvail().x, px(420.0F));
    MatrixCells cells = mirror_cells();
    widgets::Matrix("R derived", found.mirrored_world_from_world,
                    {.cells = cells, .roles = mirror_roles(), .target = "matrix:R"}, width);
    widgets::MarkTarget("text:mirror_derivation.matrix", from, ImGui::GetItemRectMax());
    widgets::Note(
        "The slide divides n·q + d by |n| once. That makes k a distance, but the n that k multiplies must also have "
        "length 1. For a plane as typed, divide by |n|² instead.");
    if (found.plane == MirrorPlane::general)
        widgets::Note("The presets mirror-yz, mirror-xz and mirror-xy show the three cases on the slide.");
}

}  // namespace

void draw_shadow_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player) {
    Params& params = session.params;
    const DerivedPlane& plane = derived.chosen_plane();
    const ShadowDerivation found = derive_shadow(plane.unit_plane, derived.chosen_light(), derivation_point(derived));
    const ShadowForms forms = shadow_forms(plane.unit_plane, derived.chosen_light());
    const FigureView view("shadow derivation", rect, 3);
    draw_shadow_diagram(view.figure(), found, 3.0 * plane.patch.extent);

    const std::vector<DerivationLine> lines = shadow_lines(found, forms.blinn.has_value());
    bool is_stepped = false;
    const auto controls = [&] {
        is_stepped = step_bar(params, lines, player);
        light_slider(params);
    };
    if (view.has_controls() && !widgets::IsCovered("text:shadow_derivation")) {
        const FigureControls below(view);
        controls();
    }
    const Steps steps(view);
    if (is_part_covered("text:shadow_derivation", ImGui::GetContentRegionAvail().y)) return;
    if (!view.has_controls()) controls();
    const int step = params.view.derivation_step;
    const bool is_short = steps.is_short() && step < 0;
    tell_ray(found.ray);
    if (derived.chosen_shadow().by_hand) widgets::Note("S was entered by hand; this view shows S as derived.");
    equation({"l", found.parallel_light || found.light.w == 1.0 ? "" : "= (x, y, z)/l_w",
              "= " + derivation_vector(found.light_world)});
    equation({"p", "= " + derivation_vector(found.point_world)});
    if (!is_short) plane_line(found.unit_plane);
    const bool is_whole = write_lines(lines, step, is_short, is_stepped);
    if (is_short) plane_line(found.unit_plane);
    tell_point(derived, "p");
    if (!is_whole || is_part_covered("text:shadow_derivation.matrix", px(130.0F))) return;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    show_three_forms(forms);
    widgets::MarkTarget("text:shadow_derivation.matrix", from, ImGui::GetItemRectMax());
}

void draw_mirror_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player) {
    const MirrorDerivation found = derive_mirror(derived.chosen_plane().unit_plane, derivation_point(derived));
    const FigureView view("mirror derivation", rect, 2);
    draw_mirror_diagram(view.figure(), found);

    const std::vector<DerivationLine> lines = mirror_lines(found);
    bool is_stepped = false;
    if (view.has_controls() && !widgets::IsCovered("text:mirror_derivation")) {
        const FigureControls below(view);
        is_stepped = step_bar(session.params, lines, player);
    }
    const Steps steps(view);
    if (is_part_covered("text:mirror_derivation", ImGui::GetContentRegionAvail().y)) return;
    if (!view.has_controls()) is_stepped = step_bar(session.params, lines, player);
    if (derived.chosen_plane().mirror_by_hand) widgets::Note("R was entered by hand; this view shows R as derived.");
    if (derived.chosen_plane().mirror_has_slip) widgets::Note("R contains a mistake; this view shows R as derived.");
    equation({"q", "= " + derivation_vector(found.point_world)});
    plane_line(found.unit_plane);
    tell_point(derived, "q");
    if (write_lines(lines, session.params.view.derivation_step, false, is_stepped)) mirror_form(found);
}

}  // namespace viewing
