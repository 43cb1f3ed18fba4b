#include "topics/hidden/shown/step_rows.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "state/fields.h"
#include "text/catalogue.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "topics/hidden/numbers/step_groups.h"
#include "topics/hidden/shown/step_text.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/panel_parts.h"
#include "ui/parts/table_parts.h"

namespace viewing {
namespace {

constexpr glm::ivec2 first_raster{24, 16};
constexpr float step_gap = 2.0F, slider_width = 124.0F;  // design pixels

/// Draws a button that goes to step `to`; disabled if there is no such step. The button is wide enough for its symbol.
void step_button(const char* id, const char* sign, std::optional<int> to, int& step, const char* title,
                 const char* explanation, const char* why_not) {
    if (widgets::CurrentContext().printed) return;
    ImGui::PushID(id);
    ImGui::BeginDisabled(!to);
    const float width = std::max(std::round(1.15F * ImGui::GetFrameHeight()), ImGui::CalcTextSize(sign).x + px(10.0F));
    if (ImGui::Button(sign, {width, 0.0F})) step = *to;
    widgets::GoOnWhileHeld();
    widgets::Record(id);
    ImGui::EndDisabled();
    ImGui::PopID();
    widgets::Tooltip(title, to ? explanation : why_not);
    ImGui::SameLine(0.0F, px(step_gap));
}

/// Draws two buttons: one goes to the previous step that touches the followed pixel, the other to the next one.
void touch_buttons(int& step, const HiddenResult& result, const char* previous_sign, const char* next_sign) {
    const char* const why_not = result.request.visibility.pixel
                                    ? marked("No other step in this direction touches this pixel.")
                                    : marked("Click a pixel of the picture first.");
    step_button("touch before", previous_sign, previous_touch(result, step), step, marked("Back at this pixel"),
                marked("Goes to the previous step that touches the chosen pixel."), why_not);
    step_button("next touch", next_sign, next_touch(result, step), step, marked("Next at this pixel"),
                marked("Goes to the next step that touches the chosen pixel."), why_not);
}

/// Draws buttons that go to the beginning and the end of the step's group or, if already there, of the previous or next
/// group.
void group_buttons(int& step, const HiddenResult& result, const char* previous_sign, const char* next_sign) {
    const StepWords& words = hidden_method(result.request.visibility.method).words;
    step_button("group before", previous_sign, previous_group(result, step), step, marked("Back"), words.previous,
                marked("Already there."));
    step_button("next group", next_sign, next_group(result, step), step, marked("Next"), words.next,
                marked("Already there."));
}

/// Draws a slider from `least` to `count`; returns whether it was moved.
bool level_slider(const char* label, int& value, int least, int count) {
    constexpr int most_told = 999'999;  // larger counts do not fit beside the value
    const std::string of = count <= most_told ? " / " + std::to_string(count) : "";
    double shown = value;
    const widgets::NumberStyle style{.min = static_cast<double>(least),
                                     .max = static_cast<double>(std::max(count, least + 1)),
                                     .step = std::clamp(count / 400.0, 0.02, 100.0),
                                     .decimals = 0,
                                     .unit = of.c_str(),
                                     .integer = true,
                                     .default_value = static_cast<double>(count)};
    ImGui::BeginDisabled(count <= least);
    const bool moved = widgets::Slider(label, shown, style, px(slider_width));
    ImGui::EndDisabled();
    if (moved) value = std::clamp(static_cast<int>(std::lround(shown)), least, std::max(count, least));
    return moved;
}

void level_rows(int& step, const HiddenResult& result, const StepPlace& place) {
    const StepWords& words = hidden_method(result.request.visibility.method).words;
    group_buttons(step, result, "←", "→");
    int group = place.group;
    if (level_slider(words.group, group, 1, place.groups)) step = end_of_group(result, group);
    // Align this slider with the group's, but add no buttons: the bar above already has those for single steps.
    const float indent = 2.0F * (std::round(1.15F * ImGui::GetFrameHeight()) + px(step_gap));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
    int within = place.within;
    if (level_slider(words.within, within, 0, place.size)) step = place.first + within;
}

/// Draws the buttons for the steps that touch the followed pixel, and says how many of these steps have been reached.
void touch_row(int& step, const HiddenResult& result, const std::optional<glm::ivec2>& pixel) {
    touch_buttons(step, result, "←", "→");
    const int reached = step < 0 ? result.step_count : step;
    const auto done = std::count_if(result.touches.begin(), result.touches.end(),
                                    [reached](const PixelTouch& touch) { return touch.step <= reached; });
    const std::string text = pixel ? say("pixel ({x}, {y}): {done} of {count}", "x"_a = pixel->x, "y"_a = pixel->y,
                                         "done"_a = done, "count"_a = result.touches.size())
                                   : std::string(tr("click a pixel to follow it"));
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    ImGui::TextUnformatted(widgets::Shortened(text, ImGui::GetContentRegionAvail().x).c_str());
    widgets::Record("touches");
    ImGui::PopFont();
    widgets::Tooltip("Chosen pixel", text.c_str());
}

bool has_touches(const HiddenResult& result) {
    return !result.order.empty() && !is_drawn_by_gl_alone(result.request.visibility.method);
}

}  // namespace

void draw_raster_row(Params& params) {
    const Field& field = viewing::field("visibility.raster");
    std::optional<glm::ivec2>& raster = params.visibility.raster;
    const std::optional<glm::ivec2> before = raster;
    bool is_small = raster.has_value();
    if (widgets::Toggle("Small raster", is_small, false))
        raster = is_small ? std::optional(first_raster) : std::nullopt;
    explain(field, "Small raster");
    const float number = px(44.0F), times = ImGui::CalcTextSize("×").x;
    beside(118.0F, 2.0F * number + times + px(12.0F));
    glm::ivec2 size = raster.value_or(first_raster);
    ImGui::BeginDisabled(!raster);
    const auto count = [&](const char* label, int& value, int by_default, const char* title) {
        double shown = value;
        const widgets::NumberStyle style{.min = field.min,
                                         .max = field.max,
                                         .step = 0.1,
                                         .decimals = 0,
                                         .integer = true,
                                         .default_value = static_cast<double>(by_default)};
        if (widgets::Number(label, shown, style, number)) value = static_cast<int>(std::lround(shown));
        explain(field, title, raster ? "" : tr("The raster has the size of the view."));
    };
    count("##columns", size.x, first_raster.x, marked("Columns"));
    ImGui::SameLine(0.0F, px(6.0F));
    ImGui::TextUnformatted("×");
    ImGui::SameLine(0.0F, px(6.0F));
    count("##rows", size.y, first_raster.y, marked("Rows"));
    ImGui::EndDisabled();
    if (raster) raster = size;
    if (raster.has_value() != before.has_value()) params.visibility.pixel.reset();  // it belonged to the other raster
}

void draw_step_rows(Params& params, const HiddenResult& result) {
    const widgets::Group group("levels");
    int& step = params.visibility.step;
    // Use the same height for every method, so that everything below stays in place while methods are compared.
    const float bottom = ImGui::GetCursorPosY() + 3.0F * ImGui::GetFrameHeightWithSpacing();
    if (has_touches(result)) touch_row(step, result, params.visibility.pixel);
    if (const std::optional<StepPlace> place = place_of_step(result, step)) level_rows(step, result, *place);
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), bottom));
}

void draw_step_line(Params& params, const HiddenResult& result) {
    if (result.step_count == 0) return;
    const widgets::Group group("line");
    int& step = params.visibility.step;
    const int reached = step < 0 ? result.step_count : std::min(step, result.step_count);
    const auto one = [&](int to) { return to >= 0 && to <= result.step_count ? std::optional(to) : std::nullopt; };
    ImGui::PushButtonRepeat(true);
    step_button("step before", "←", one(reached - 1), step, marked("Back"),
                marked("Goes back one step; hold to repeat."), marked("Already there."));
    step_button("next step", "→", one(reached + 1), step, marked("Next"), marked("Advances one step; hold to repeat."),
                marked("Already there."));
    ImGui::PopButtonRepeat();
    if (!result.group_ends.empty()) group_buttons(step, result, "⇤", "⇥");
    if (has_touches(result)) touch_buttons(step, result, "←□", "□→");
    if (!widgets::CurrentContext().printed) ImGui::SameLine(0.0F, px(8.0F));
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    const std::string progress = progress_sentence(result, step);
    const float room = ImGui::GetContentRegionAvail().x;
    std::string brief;
    for (const std::string& numbers : progress_numbers(result, step))
        if (brief.empty() || ImGui::CalcTextSize(brief.c_str()).x > room) brief = numbers;
    shortened_text(progress, room, brief);
    widgets::Record(progress.c_str());
    ImGui::PopFont();
}

}  // namespace viewing
