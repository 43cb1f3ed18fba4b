// The camera's view: its display choices, handles, looking around and picking.
#include <algorithm>
#include <cmath>

#include "frame/depth_colors.h"
#include "state/fields.h"
#include "state/file/beside.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "text/per_enum.h"
#include "topics/depth/shown/depth_views.h"
#include "topics/hidden/shown/hidden_overlay.h"
#include "topics/planes/shown/derivation_views.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"
#include "ui/parts/view_parts.h"
#include "ui/views/beside_view.h"
#include "ui/views/views.h"

namespace viewing {
namespace {

constexpr auto shows = per_enum<Shows>(marked("color"), marked("depth"), marked("stencil"), marked("facing"),
                                       marked("overdraw"), marked("difference"), marked("fighting"), marked("w of S"));

/// Draws the list of what the picture can show, and the options that depend on the choice.
void view_choices(Params& params, const Rect& rect) {
    static constexpr const char* show_explanations[] = {
        marked("The picture itself, in its usual colors."),
        marked("The depth buffer: black is near, white is far, tinted pixels were never written."),
        marked("The stencil buffer: which patch was marked, through how many mirrors it is seen, and which lights' "
               "shadows were counted on it."),
        marked("The visible side of each polygon: front faces and back faces in two colors."),
        marked("How often each pixel was drawn."),
        marked("Red marks pixels where the two compared methods see different polygons."),
        marked("The gap between flat surfaces, divided by the smallest gap that the depth buffer is sure to resolve. "
               "Below 1, depth fighting is possible."),
        marked("The w that S gives each point of the objects: positive between the light and the plane, and also "
               "behind the plane.")};
    int index = static_cast<int>(params.view.shows);
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const float second = px(130.0F);  // width of the next list
    if (widgets::Offers("control:view.shows")) {
        if (words("##shows", index, shows, show_explanations, 0, rect.max.x - second))
            params.view.shows = static_cast<Shows>(index);
        widgets::MarkTarget("control:view.shows", from, ImGui::GetItemRectMax());
    }
    if (params.view.shows == Shows::depth) {
        ImGui::SameLine(0.0F, px(16.0F));
        depth_choices(params, rect.max.x);
    } else if (params.view.shows != Shows::stencil && rect.width() > px(480.0F) &&
               widgets::Offers("control:view.samples")) {  // otherwise only the Look menu has this choice
        static constexpr const char* samples[] = {marked("MSAA off"), marked("MSAA 4×")};
        static constexpr const char* explanations[] = {marked("One sample per pixel: jagged edges."),
                                                       marked("Four samples per pixel: smooth edges.")};
        ImGui::SameLine(0.0F, px(16.0F));
        int four = params.view.samples == 4 ? 1 : 0;
        if (words("##samples", four, samples, explanations, 1, rect.max.x)) params.view.samples = four == 1 ? 4 : 0;
    }
}

void show_legend(Overlay& overlay, std::span<const LegendEntry> entries) {
    overlay.keep_labels_off(draw_legend(overlay.draw(), overlay.rect(), entries));
}

/// Draws the stencil's legend. The low four bits hold the patch's value, plus 1 for each mirror; each of the high four
/// bits marks one missing light.
void stencil_legend(Overlay& overlay, const Params& params) {
    const std::size_t planes = params.planes.size(), lights = params.lights.size();
    const std::string patches = planes > 1 ? say("1–{last}: the planes", "last"_a = planes) : tr("1: the patch");
    std::string values = "+16";
    for (std::size_t light = 1; light < lights; ++light) values += ", " + std::to_string(16 << light);
    const std::string missing = lights > 1 ? say("{values}: a light is blocked", "values"_a = values)
                                           : say("{values}: the light is blocked", "values"_a = values);
    const LegendEntry entries[] = {{stencil_colors[0], marked("0: nothing marked")},
                                   {stencil_colors[1], patches.c_str()},
                                   {stencil_colors[2], missing.c_str()},
                                   {stencil_colors[3], marked("16 or more: outside the patch")}};
    show_legend(overlay, std::span(entries).first(params.shadow.clip_to_receiver ? 3 : 4));
}

void camera_legend(Overlay& overlay, const Params& params, const HiddenStatus& hidden) {
    if (params.view.shows == Shows::difference && hidden.answer && hidden.answer->different_pixels >= 0) {
        const std::int64_t pixels = hidden.answer->different_pixels, all = hidden.answer->compared_pixels;
        const double share = all > 0 ? static_cast<double>(pixels) / static_cast<double>(all) : 0.0;
        const std::string differ =
            say_count(pixels, "one pixel differs, edges excluded: {share}",
                      "{count} pixels differ, edges excluded: {share}", "share"_a = percent(share));
        const LegendEntry entries[] = {{difference_color, differ.c_str()}};
        show_legend(overlay, entries);
    }
    if (params.view.shows == Shows::facing) {
        const LegendEntry entries[] = {{front_color, marked("front faces")},
                                       {back_color, marked("back faces (striped)")}};
        show_legend(overlay, entries);
    } else if (params.view.shows == Shows::stencil) {
        stencil_legend(overlay, params);
    } else if (params.view.shows == Shows::shadow_w) {
        const bool tells = !widgets::IsCovered("sentences");  // whether to say what happens to the points
        const LegendEntry entries[] = {{caster_colors[0], tells ? marked("w > 0: projected") : "w > 0"},
                                       {caster_colors[1], marked("w > 0 behind the plane")},
                                       {caster_colors[2], tells ? marked("w ≤ 0: clipped away") : "w ≤ 0"}};
        show_legend(overlay, entries);
    } else if (params.view.shows == Shows::overdraw) {
        const LegendEntry entries[] = {{overdraw_colors[0], "0"},
                                       {overdraw_colors[1], "1"},
                                       {overdraw_colors[2], "2"},
                                       {overdraw_colors[3], "3"},
                                       {overdraw_colors[4], "4"},
                                       {overdraw_colors[6], "6"},
                                       {overdraw_colors[8], marked("drawn 8 or more times")}};
        show_legend(overlay, entries);
    } else if (params.view.shows == Shows::fighting) {
        const LegendEntry entries[] = {{heat_colors[0], marked("gap ÷ safe gap: 0")},
                                       {heat_colors[1], "½"},
                                       {heat_colors[3], "1"},
                                       {heat_colors[4], "2"},
                                       {heat_colors[5], marked("4 or more")}};
        show_legend(overlay, entries);
    } else if (params.view.shows == Shows::depth) {
        const Color unwritten = ground_of(params.ui.theme).unwritten;
        const DepthColors colors = params.view.depth_colors;
        const glm::dvec2 range =
            params.view.depth_range.value_or(glm::dvec2(params.projection.near, params.lens().shown_far()));
        const std::string near = "z = " + number_text(range.x, 2), far = number_text(range.y, 2);
        const LegendEntry entries[] = {
            {near_color(colors), near.c_str()}, {far_color(colors), far.c_str()}, {unwritten, marked("never written")}};
        show_legend(overlay, entries);
    }
}

/// Draws a problem's sentence over the picture, with its icon, a button that fixes the problem, and one that shows the
/// fixed picture beside this one. Call before the picture takes the mouse input. Returns the top edge of the next
/// sentence.
float tell_why(Session& session, const Problem& problem, const Rect& rect, float top) {
    const widgets::Context& context = widgets::CurrentContext();
    const ImFont* font = context.fonts.text ? context.fonts.text : ImGui::GetFont();
    const float margin = px(10.0F), sign = font->FontSize + px(7.0F);
    const float width = std::min(px(560.0F), rect.width() - 4.0F * margin) - sign;
    const bool has_button = !problem.fixed_by.empty() && widgets::OffersButton("Fix");
    const auto width_of_button = [](const char* label) { return ImGui::CalcTextSize(tr(label)).x + px(24.0F); };
    const float fix = has_button ? width_of_button("Fix") : 0.0F, compare = width_of_button("Compare");
    const bool compares =
        has_button && session.params.view.beside.shows == Beside::nothing && width - fix - compare > px(200.0F);
    const float button = fix + (compares ? compare : 0.0F);
    const std::string sentence = widgets::BrokenAtBlanks(say(problem.sentence), width - button, *font);
    const ImVec2 text = font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, sentence.c_str());
    const ImVec2 at(rect.min.x + 2.0F * margin, top), size(sign + text.x + button, text.y);
    const float next = at.y + size.y + px(12.0F);
    if (width < px(160.0F) || next > rect.max.y) return top;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    const widgets::Tone tone = tone_of(problem.kind);
    draw_plate(draw, {at, {at.x + size.x, at.y + size.y}}, {margin, px(5.0F)});
    widgets::DrawSign(draw, at, font->FontSize, tone);
    draw->AddText(font, font->FontSize, {at.x + sign, at.y}, widgets::ColorOf(tone), sentence.c_str());
    if (!has_button) return next;
    const ImVec2 buttons(at.x + sign + text.x + px(10.0F), at.y - px(3.0F));
    ImGui::SetCursorScreenPos(buttons);
    const std::string& setting = problem.fixed_by;
    ImGui::PushID(setting.c_str());
    const bool fixes = widgets::SmallButton("Fix");
    widgets::Tooltip("Fix it", say("Sets {setting}. Ctrl+Z undoes the fix.", "setting"_a = setting).c_str());
    bool shows_both = false;
    if (compares) {
        ImGui::SetCursorScreenPos({buttons.x + fix, buttons.y});
        shows_both = widgets::SmallButton("Compare");
        widgets::Tooltip("Compare", tr("Shows the fixed picture beside this one."));
    }
    ImGui::PopID();
    if (fixes || shows_both)
        if (Result<Params> fixed = apply_settings(session.params, {&setting, 1})) {
            if (fixes)
                session.params = *std::move(fixed);
            else
                show_beside(session.params, *std::move(fixed));
        }
    return next;
}

/// Whether a control in `controls` is in the same group of settings (for example "depth") as the problem or its fix.
/// Always true if `controls` is empty, which means that all controls are offered.
bool is_about(const Problem& problem, const std::vector<std::string>& controls) {
    const auto group_of = [](std::string_view path) { return path.substr(0, path.find_first_of(".=[")); };
    return controls.empty() || std::any_of(controls.begin(), controls.end(), [&](const std::string& path) {
               return group_of(path) == problem.group || group_of(path) == group_of(problem.fixed_by);
           });
}

/// Returns the problems to describe over the picture: the worst kind first and, within a kind, first those that a
/// button can fix. On stage, where the sentences would compete with the lesson's own, includes only errors in the
/// picture, and only those about settings that the step lets the audience change.
std::vector<const Problem*> told_problems(const std::vector<Problem>& problems, const Params& params) {
    std::vector<const Problem*> told;
    for (const Problem& problem : problems)
        if (!widgets::HasPlainTitles() ||
            (problem.kind == ProblemKind::wrong && is_about(problem, params.view.layout.controls)))
            told.push_back(&problem);
    const auto rank = [](const Problem* problem) { return std::pair(problem->kind, problem->fixed_by.empty()); };
    std::stable_sort(told.begin(), told.end(),
                     [&](const Problem* one, const Problem* other) { return rank(one) < rank(other); });
    return told;
}

/// Draws the first problem's sentence and at most two more, if they end above the picture's middle. A small button
/// shows the other sentences. Returns the covered area.
Rect tell_problems(Session& session, const std::vector<Problem>& problems, const Rect& rect) {
    constexpr std::size_t most = 3;
    const float first = rect.min.y + px(15.0F);
    if (widgets::IsCovered("sentences")) return {};
    const std::vector<const Problem*> told_ones = told_problems(problems, session.params);
    bool& is_open = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("all sentences"), false);
    const float middle = (rect.min.y + rect.max.y) * 0.5F;
    float top = first, height = 0.0F;  // assumes that the next sentence is as tall as the one before
    std::size_t fitting = 0, usual = 0;
    while (fitting < told_ones.size()) {
        const bool is_usual = fitting < most && top + height < middle;
        // If all sentences are open, leave space for the button that closes them.
        if (is_open ? top >= rect.max.y - px(90.0F) : !is_usual) break;
        if (is_usual && usual == fitting) ++usual;
        const float next = tell_why(session, *told_ones[fitting], rect, top);
        if (next == top) break;
        height = next - top;
        top = next;
        ++fitting;
    }
    if (top == first) return {};
    const bool closes = is_open && usual < fitting;
    if ((closes || fitting < told_ones.size()) && top + px(24.0F) < rect.max.y) {
        ImGui::SetCursorScreenPos({rect.min.x + px(20.0F), top - px(4.0F)});
        const std::string label = closes ? tr("Fewer") : say("{count} more", "count"_a = told_ones.size() - fitting);
        if (widgets::SmallButton((label + "###other sentences").c_str())) is_open = !closes;
        top += px(24.0F);
    }
    const Rect told{rect.min, {std::min(rect.min.x + px(600.0F), rect.max.x), top}};
    widgets::MarkTarget("sentences", told.min, told.max);
    return told;
}

}  // namespace

void draw_pin(const Overlay& overlay, glm::ivec2 pixel) {
    const Rect& rect = overlay.rect();
    const ImVec2 at(rect.min.x + static_cast<float>(pixel.x) + 0.5F, rect.min.y + static_cast<float>(pixel.y) + 0.5F);
    if (!rect.contains(at)) return;
    overlay.draw()->AddCircle(at, px(7.0F), palette().ground, 0, px(4.0F));
    overlay.draw()->AddCircle(at, px(7.0F), palette().point, 0, px(2.0F));
}

void pin(Params& params, const PinnedPixel& pinned, glm::ivec2 pixel) {
    params.view.pin.reset();
    if (pinned.pixel == pixel)
        params.view.pixel.reset();
    else
        params.view.pixel = pixel;
}

std::optional<glm::ivec2> camera_pixel_at(const Rect& rect, ImVec2 pointer, glm::ivec2 camera_px,
                                          const ProjectionParams& projection) {
    // The vertical field of view is fixed, so a picture with another aspect ratio shows more or less at its sides.
    const glm::dvec2 size(camera_px),
        from_middle(pointer.x - 0.5F * (rect.min.x + rect.max.x), pointer.y - 0.5F * (rect.min.y + rect.max.y));
    const glm::dvec2 scale = size / glm::dvec2(std::max(rect.width(), 1.0F), std::max(rect.height(), 1.0F));
    const bool fills = projection.has_window() || projection.aspect > 0.0;
    const glm::ivec2 pixel(glm::floor(0.5 * size + from_middle * (fills ? scale : glm::dvec2(scale.y))));
    const bool is_inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < camera_px.x && pixel.y < camera_px.y;
    return is_inside ? std::optional(pixel) : std::nullopt;
}

void draw_camera_view(ViewState& state, Session& session, const Derived& derived, const std::vector<Problem>& problems,
                      const Rect& rect, const Pictures& pictures, const FrameInput& input, MotionInput& motion) {
    if (rect.empty()) return;
    const widgets::Group group("view");
    Params& params = session.params;
    if (widgets::HasPlainTitles() && params.view.shows != Shows::color)
        view_header(rect, say("Camera view: {what}", "what"_a = tr(shows[params.view.shows])).c_str());
    else if (params.view.beside.shows == Beside::settings && params.view.beside.layout == BesideLayout::halves)
        draw_beside_title(rect, rect.width() - px(150.0F), params, &BesideTitles::camera);
    else
        view_header(rect, rect.width() < px(300.0F) ? "" : marked("Camera view"));
    view_choices(params, rect);
    widgets::MarkTarget("view:camera", rect.min, rect.max);
    if (widgets::IsCovered("view:camera")) {
        ImGui::SetCursorScreenPos(rect.min);
        return widgets::Plate("camera view", {rect.width(), rect.height()});
    }

    const BesideParams& beside = params.view.beside;
    const bool has_divider = beside.shows != Beside::nothing && beside.layout == BesideLayout::divider;
    draw_picture(rect, pictures.camera);
    const bool has_sentences = !problems.empty() && !widgets::IsCovered("sentences");
    if (has_divider) draw_beside_divider(session, derived, rect, pictures.beside, has_sentences);
    // Sentences and the legend come first, so that the overlay's labels avoid them, but they are in the upper layer, so
    // that no line crosses them.
    ImDrawList* const draw = ImGui::GetWindowDrawList();
    ImDrawListSplitter layers;
    layers.Split(draw, 2);
    layers.SetCurrentChannel(draw, 1);
    const Rect told = tell_problems(session, problems, rect);
    layers.SetCurrentChannel(draw, 0);
    picture_item("camera view", rect, nullptr);
    const bool over = ImGui::IsItemHovered();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (over) state.hovered = ViewName::camera;
    state.camera_px = rect.size_px();
    if (over) state.hovered_pixel = state.told_pixel = glm::ivec2(mouse.x - rect.min.x, mouse.y - rect.min.y);

    Overlay overlay(draw, rect, derived.clip_from_world);
    for (const Rect& taken : {told, state.plate})
        if (!taken.empty()) overlay.keep_labels_off(taken);
    if (has_divider) {  // the names of the two sides are at the top
        const float middle = rect.min.x + static_cast<float>(beside.share) * rect.width(), half = px(220.0F);
        overlay.keep_labels_off({{middle - half, rect.min.y}, {middle + half, rect.min.y + px(36.0F)}});
    }
    state.method_pixel = over ? method_pixel_at(pictures.hidden, overlay, mouse) : std::nullopt;
    const HandlePlaces places = handle_places(derived);
    Handle hovered = state.grip.handle;
    const bool has_handles = state.handles && !has_raster(params.visibility);  // handles would hide the pixels' depths
    if (hovered == Handle::none && over && has_handles && !state.looking)
        hovered = movable_handle(state, handle_at(overlay, places, mouse));
    if (hovered != Handle::none) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    camera_mouse(state, session, derived, overlay, hovered, pictures.hidden, input, motion);

    layers.SetCurrentChannel(draw, 1);
    camera_legend(overlay, params, pictures.hidden);
    layers.SetCurrentChannel(draw, 0);
    PolygonLinks& links = state.hidden.links;
    if (over) links.next.hovered_fragment = fragment_at(pictures.hidden, overlay, mouse);
    draw_hidden_overlay(links.now, session, pictures.hidden, overlay);
    if (state.pinned.pixel) draw_pin(overlay, *state.pinned.pixel);
    draw_why_overlay(state.why, overlay);
    if (state.target) overlay.target(state.target->point_world, state.target->label.c_str(), palette().accent);
    if (has_handles) {
        if (state.marks_plane) draw_plane_handles(overlay, places, hovered);
        if (state.marks_lights) draw_light_handles(overlay, places, derived, hovered);
        if (state.marks_derivation || params.follow) draw_derivation_overlay(overlay, params, derived);
    }
    layers.Merge(draw);
}

}  // namespace viewing
