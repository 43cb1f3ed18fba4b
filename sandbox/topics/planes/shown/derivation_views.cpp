#include "topics/planes/shown/derivation_views.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "text/catalogue.h"
#include "text/per_enum.h"
#include "topics/planes/shown/derivation_diagram.h"
#include "topics/planes/shown/derivation_flow.h"
#include "topics/planes/shown/derivation_forms.h"
#include "topics/planes/shown/derivation_lines.h"
#include "topics/planes/shown/derivation_text.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/links.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

using Lines = std::vector<DerivationLine>;

/// A child window over a part of a derivation's view. Closes at the end of its scope.
class Part {
public:
    /// `fade`: height of the mark that indicates more content below, in design pixels; 0: the part never scrolls.
    Part(const char* name, ImVec2 from, ImVec2 size, float line_gap, float fade)
        : behind_(ImGui::GetCursorScreenPos()), fade_(fade) {
        const bool scrolls = fade > 0.0F;
        ImGui::SetCursorScreenPos(from);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(DerivationFlow::padding), 0.0F});
        ImGui::BeginChild(name, size, false,
                          scrolls ? ImGuiWindowFlags_AlwaysUseWindowPadding
                                  : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(6.0F), px(line_gap)});
    }
    ~Part() {
        ImGui::PopStyleVar();
        if (fade_ > 0.0F) widgets::CountScrolled(false, fade_);
        ImGui::EndChild();
        if (fade_ == 0.0F) ImGui::SetCursorScreenPos(behind_);
    }
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

private:
    ImVec2 behind_;
    float fade_;
};

/// Draws "light: parallel [      ] point", a slider for l_w from 0 to 1; x, y and z stay the same. In a narrow view,
/// the first label is above the slider.
void light_slider(Params& params) {
    if (widgets::HasPlainTitles()) return;  // the panel has this control, with its name
    if (widgets::CurrentContext().printed) return;
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

DerivationLine note_line(std::string text) {
    return {DerivationLine::Kind::note, {std::move(text)}};
}

/// If no vertex is followed, adds a sentence about the point used for the derivation.
void tell_point(Lines& lines, const Derived& derived, const char* letter) {
    if (derived.followed) return;
    lines.push_back(note_line(
        widgets::CurrentContext().printed
            ? say("{point} is one unit from the center of the plane's patch, on the light's side.", "point"_a = letter)
            : say("Click an object to follow one of its vertices; until then, {point} is one unit from the center of "
                  "the plane's patch, on the light's side.",
                  "point"_a = letter)));
}

void tell_ray(Lines& lines, ShadowRay ray) {
    if (ray == ShadowRay::regular) return;
    lines.push_back(note_line(tr(sentence_of(ray))));
    // A point in the plane is no error.
    if (ray != ShadowRay::point_in_plane) lines.back().kind = DerivationLine::Kind::trouble;
}

DerivationLine plane_line(const glm::dvec4& unit_plane) {
    return {DerivationLine::Kind::equation,
            {"n", "= " + derivation_vector(glm::dvec3(unit_plane)), "d = " + derivation_number(unit_plane.w)}};
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

void write(const DerivationLine& line, bool is_small) {
    if (is_covered(line.target)) {
        widgets::Plate("line", {ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()});
        return widgets::MarkTarget(line.target);
    }
    const ImVec2 from = ImGui::GetCursorScreenPos();
    write_line(line, is_small);
    widgets::MarkTarget(line.target, from, {from.x + ImGui::GetContentRegionAvail().x, ImGui::GetItemRectMax().y});
}

/// Draws the step bar. Returns true when a step was chosen.
bool step_bar(Params& params, const std::vector<DerivationLine>& lines, widgets::StepPlayer& player) {
    if (ImGui::GetContentRegionAvail().x < px(DerivationFlow::least_bar)) return false;
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

/// The parts of a derivation's view.
struct Derivation {
    const char *name, *target;  ///< of the view's window; of its text in lessons
    int control_rows;
    Lines before = {}, lines = {}, after = {};  ///< the step bar counts only `lines`
    std::function<void(const Rect&)> draw_figure = {};
    std::function<bool(int)> controls = {};  ///< draws this many rows and returns whether a step was chosen
    std::function<void()> form = {};         ///< draws what is below the last line
};

/// A derivation's lines, some of which the state's step has not reached. write() draws the lines in a range of indices,
/// without the counted lines that are not reached.
struct WrittenLines {
    const Lines& all;
    std::size_t written, behind;  ///< the ends of the written and of the counted lines

    void write(std::size_t begin, std::size_t end, const DerivationFlow& flow) const {
        ImGui::SetWindowFontScale(flow.font_scale);
        for (std::size_t i = begin; i < std::min(end, all.size()); ++i)
            if ((i < written || i >= behind) && !(flow.is_short && all[i].is_step))
                viewing::write(all[i], !flow.columns.empty());
        ImGui::SetWindowFontScale(1.0F);
    }
};

void draw_columns(const DerivationFlow& flow, const WrittenLines& lines, ImVec2 from, float first_top) {
    for (std::size_t column = 0; column < flow.columns.size(); ++column) {
        const bool is_last = column + 1 == flow.columns.size();
        const float top = column == 0 ? first_top : 0.0F;
        ImGui::PushID(static_cast<int>(column));
        {
            const Part part(
                "column",
                {from.x + static_cast<float>(column) * (flow.column.x + px(DerivationFlow::gap)), from.y + top},
                {flow.column.x, std::max(flow.column.y - top, 1.0F)}, flow.line_gap(), 0.0F);
            lines.write(flow.columns[column], is_last ? lines.all.size() : flow.columns[column + 1], flow);
        }
        ImGui::PopID();
    }
    ImGui::SetCursorScreenPos({from.x, from.y + flow.column.y + px(DerivationFlow::foot)});
}

void draw_derivation(const Derivation& shown, int step, const Rect& rect) {
    const ViewWindow view(shown.name, rect, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const bool has_cover = widgets::IsCovered(shown.target);
    Lines all = shown.before;
    all.insert(all.end(), shown.lines.begin(), shown.lines.end());
    all.insert(all.end(), shown.after.begin(), shown.after.end());
    const std::size_t before = shown.before.size(), reached = lines_until(shown.lines, step).size();
    const WrittenLines lines{all, before + reached, before + shown.lines.size()};
    const DerivationFlow flow =
        flow_of(has_cover ? Lines{} : all, ImGui::GetContentRegionAvail(), shown.control_rows, step < 0);

    std::optional<Part> steps;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (!flow.columns.empty())
        steps.emplace("steps", ImGui::GetCursorScreenPos(), room, flow.line_gap(), DerivationFlow::foot);
    const ImVec2 from = ImGui::GetCursorScreenPos(), below{from.x, from.y + flow.figure.y};
    if (flow.figure.y > 0.0F) {
        shown.draw_figure({from, {from.x + flow.figure.x, below.y}});
        ImGui::Dummy(flow.figure);
        widgets::Record("figure");
    }
    bool is_stepped = false;
    const float control_gap = px(DerivationFlow::control_gap);
    const float controls = static_cast<float>(flow.control_rows) * (ImGui::GetFrameHeight() + control_gap);
    if (flow.has_controls && !has_cover) {
        const Part part("controls", {below.x, below.y + control_gap}, {flow.figure.x, controls},
                        DerivationFlow::control_gap, 0.0F);
        is_stepped = shown.controls(flow.control_rows);
    }
    if (!flow.columns.empty()) {
        draw_columns(flow, lines, from, flow.figure.y + (flow.has_controls ? controls : 0.0F) + control_gap);
    } else {
        const ImVec2 beside{from.x + flow.figure.x + px(DerivationFlow::gap), from.y};
        steps.emplace("steps", flow.is_wide ? beside : ImGui::GetCursorScreenPos(), ImVec2{0.0F, 0.0F}, flow.line_gap(),
                      34.0F);
        if (is_part_covered(shown.target, ImGui::GetContentRegionAvail().y)) return;
        if (!flow.has_controls) is_stepped = shown.controls(flow.control_rows);
        lines.write(0, all.size(), flow);
        if (is_stepped) ImGui::SetScrollHereY(1.0F);
    }
    if (reached == shown.lines.size()) shown.form();
}

void mirror_form(const MirrorDerivation& found) {
    constexpr float plate_height = 130.0F;
    if (is_part_covered("text:mirror_derivation.matrix", px(plate_height))) return;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    static constexpr auto headings = per_enum<MirrorPlane>(marked("R for the yz-plane"), marked("R for the xz-plane"),
                                                           marked("R for the xy-plane"), marked("R for any plane"));
    derivation_heading(headings[found.plane]);
    const float width = std::min(ImGui::GetContentRegionAvail().x, px(420.0F));
    MatrixCells cells = mirror_cells();
    widgets::Matrix("R derived", found.mirrored_world_from_world,
                    {.cells = cells, .roles = mirror_roles(), .target = "matrix:R"}, width);
    widgets::MarkTarget("text:mirror_derivation.matrix", from, ImGui::GetItemRectMax());
    widgets::Note(
        "The slide divides n·q + d by |n| once. That makes k a distance, but the n that k multiplies must also have "
        "length 1. If the plane is used as typed, divide by |n|² instead.");
    if (found.plane == MirrorPlane::general)
        widgets::Note("The presets mirror-yz, mirror-xz and mirror-xy show the three cases on the slide.");
}

}  // namespace

void draw_shadow_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player) {
    Params& params = session.params;
    const DerivedPlane& plane = derived.chosen_plane();
    const ShadowDerivation found = derive_shadow(plane.unit_plane, derived.chosen_light(), derivation_point(derived));
    const ShadowForms forms = shadow_forms(plane.unit_plane, derived.chosen_light());
    Derivation shown{"shadow derivation", "text:shadow_derivation", 3};
    tell_ray(shown.before, found.ray);
    if (derived.chosen_shadow().by_hand)
        shown.before.push_back(note_line(marked("S was entered by hand; this view shows S as derived.")));
    shown.before.push_back({DerivationLine::Kind::equation,
                            {"l", found.parallel_light || found.light.w == 1.0 ? "" : "= (x, y, z)/l_w",
                             "= " + derivation_vector(found.light_world)}});
    shown.before.push_back({DerivationLine::Kind::equation, {"p", "= " + derivation_vector(found.point_world)}});
    shown.before.push_back(plane_line(found.unit_plane));
    shown.before.back().is_step = true;  // the results contain the plane's numbers
    shown.lines = shadow_lines(found, forms.blinn.has_value());
    tell_point(shown.after, derived, "p");
    shown.draw_figure = [&](const Rect& figure) { draw_shadow_diagram(figure, found, 3.0 * plane.patch.extent); };
    shown.controls = [&](int rows) {
        const bool is_stepped = step_bar(params, shown.lines, player);
        if (rows == shown.control_rows) light_slider(params);
        return is_stepped;
    };
    shown.form = [&] {
        if (is_part_covered("text:shadow_derivation.matrix", px(130.0F))) return;
        const ImVec2 from = ImGui::GetCursorScreenPos();
        show_three_forms(forms);
        widgets::MarkTarget("text:shadow_derivation.matrix", from, ImGui::GetItemRectMax());
    };
    draw_derivation(shown, params.view.derivation_step, rect);
}

void draw_mirror_derivation(Session& session, const Derived& derived, const Rect& rect, widgets::StepPlayer& player) {
    const MirrorDerivation found = derive_mirror(derived.chosen_plane().unit_plane, derivation_point(derived));
    Derivation shown{"mirror derivation", "text:mirror_derivation", 2};
    if (derived.chosen_plane().mirror_by_hand)
        shown.before.push_back(note_line(marked("R was entered by hand; this view shows R as derived.")));
    if (derived.chosen_plane().mirror_has_slip)
        shown.before.push_back(note_line(marked("R contains a mistake; this view shows R as derived.")));
    shown.before.push_back({DerivationLine::Kind::equation, {"q", "= " + derivation_vector(found.point_world)}});
    shown.before.push_back(plane_line(found.unit_plane));
    shown.lines = mirror_lines(found);
    tell_point(shown.after, derived, "q");
    shown.draw_figure = [&](const Rect& figure) { draw_mirror_diagram(figure, found); };
    shown.controls = [&](int) { return step_bar(session.params, shown.lines, player); };
    shown.form = [&] { mirror_form(found); };
    draw_derivation(shown, session.params.view.derivation_step, rect);
}

}  // namespace viewing
