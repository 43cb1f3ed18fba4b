#include "topics/hidden/shown/hidden_panel.h"

#include <algorithm>

#include "text/catalogue.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "topics/hidden/shown/method_words.h"
#include "topics/hidden/shown/step_rows.h"
#include "ui/parts/field_controls.h"
#include "ui/parts/look.h"
#include "ui/parts/panel_parts.h"
#include "ui/parts/table_parts.h"

namespace viewing {
namespace {

constexpr float choice_width = 150.0F;

void draw_options(const HiddenMethod& method, Params& params) {
    if (method.sorts_by_key)
        control(params, "visibility.sort_key",
                {.width = choice_width, .names = sort_key_names, .label = marked("sort key")});
    if (method.has_tree) {
        control(params, "visibility.splitter",
                {.width = choice_width, .names = splitter_names, .label = marked("splitter")});
        control(params, "visibility.walk", {.width = choice_width, .names = walk_names, .label = marked("walk")});
    }
    if (method.splits) control(params, "visibility.epsilon", {.decimals = 2, .label = marked("epsilon")});
    if (method.casts_rays) control(params, "visibility.exact_curves", {.label = marked("Exact curves")});
}

/// Draws a button that cancels the method or runs it again. The button shares a row with the previous control, so that
/// nothing moves when it appears or disappears.
void cancel_button(HiddenPanelState& state, const HiddenStatus& hidden) {
    const bool was_canceled = hidden.answer && hidden.answer->camera->is_canceled;
    if (!hidden.fraction && !was_canceled) return;
    const char* label = hidden.fraction ? marked("Cancel") : marked("Run again");
    beside(118.0F, widgets::SmallButtonWidth(label));
    if (widgets::SmallButton(label)) (hidden.fraction ? state.cancel_method : state.restart_method) = true;
}

/// The method's counters in two columns; omits those that do not apply. A counter too wide for one column takes both.
class CounterTable {
public:
    void number(const char* name, std::int64_t value) {
        if (value >= 0) text(name, grouped_number(value).c_str());
    }
    void text(const char* name, const char* value) {
        const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
        const float column = px(148.0F), number_end = px(130.0F), number_width = width_of(value, fonts.small_number);
        if (is_second_) ImGui::SameLine(column);
        const float left = is_second_ ? column : ImGui::GetCursorPosX();
        const bool has_room = left + width_of(tr(name), fonts.note) + px(4.0F) + number_width <=
                              (is_second_ ? column : 0.0F) + number_end;
        if (is_second_ && !has_room) ImGui::NewLine();
        ImGui::PushFont(fonts.note);
        ImGui::TextUnformatted(tr(name));
        ImGui::PopFont();
        ImGui::PushFont(fonts.small_number);
        ImGui::SameLine((is_second_ || !has_room ? column : 0.0F) + number_end - number_width);
        ImGui::TextUnformatted(value);
        ImGui::PopFont();
        rows_ += !is_second_ || !has_room ? 1 : 0;
        is_second_ = has_room && !is_second_;
    }
    int rows() const { return rows_; }  ///< rows used so far

private:
    int rows_ = 0;
    bool is_second_ = false;
};

void counters(const HiddenResult& result, bool shows_time) {
    const HiddenCounters& counted = result.counters;
    CounterTable table;
    const float top = ImGui::GetCursorPosY();
    const auto time = [&](double ms) {
        if (!shows_time) return std::string("–");
        return ms < 0.1 ? say("{time} µs", "time"_a = number_text(ms * 1e3, 1))
                        : say("{time} ms", "time"_a = number_text(ms, 2));
    };
    table.number(marked("polygons"), counted.polygons);
    table.number(marked("culled"), counted.culled > 0 ? counted.culled : -1);
    table.number(result.tree ? marked("plane tests") : marked("comparisons"), counted.comparisons);
    table.number(marked("swaps"), counted.swaps);
    table.number(marked("splits"), counted.splits);
    table.number(marked("fragments"), counted.fragments);
    table.number(marked("tree depth"), counted.tree_depth);
    table.number(marked("rays"), counted.rays);
    table.number(marked("ray tests"), counted.intersection_tests);
    table.number(marked("pixels tested"), counted.pixels_tested);
    table.number(marked("pixels written"), counted.pixels_written);
    if (counted.pixels_written >= 0) table.text(marked("overdraw"), number_text(counted.overdraw(), 2).c_str());
    if (!is_drawn_by_gl_alone(result.request.visibility.method))
        table.text(marked("time"), time(result.time_ms).c_str());
    if (result.build_ms >= 0.0) table.text(marked("build time"), time(result.build_ms).c_str());
    // Use the same height for every method: the BSP tree has the most counters, and culling adds one.
    constexpr int most_rows = 6;
    const float row = (ImGui::GetCursorPosY() - top) / static_cast<float>(std::max(table.rows(), 1));
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + static_cast<float>(most_rows) * row));
}

void culling_counts(const HiddenResult& result, bool steps) {
    const CullCounts& counts = result.facing;
    std::string text =
        say("By plane sign: {front} front, {back} back. By GL winding: {gl_front} front, {gl_back} back.",
            "front"_a = grouped_number(counts.facing_towards), "back"_a = grouped_number(counts.facing_away),
            "gl_front"_a = grouped_number(counts.gl_front), "gl_back"_a = grouped_number(counts.gl_back));
    const std::int64_t culled = result.counters.culled;
    const std::int64_t total = result.tree ? result.counters.fragments : counts.input;
    if (culled > 0) {
        const std::string left = grouped_number(total - culled), all = grouped_number(total);
        text += " ";
        text += result.tree ? say("Culling leaves {left} of {all} fragments.", "left"_a = left, "all"_a = all)
                            : say("Culling leaves {left} of {all} polygons.", "left"_a = left, "all"_a = all);
    }
    if (steps) text += std::string(" ") + tr("Shadow and mirror are not drawn while you step through the method.");
    // The text has a varying number of lines; keep everything below in place.
    const float top = ImGui::GetCursorPosY();
    widgets::Note(text.c_str());
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + 4.0F * ImGui::GetTextLineHeight()));
}

/// Draws only the controls that the state lists; these may include the step bar.
void draw_listed(HiddenPanelState& state, Params& params, const HiddenStatus& hidden) {
    draw_options(hidden_method(params.visibility.method), params);
    control(params, "visibility.numbers", {.label = marked("Numbers")});
    control(params, "visibility.compare_with",
            {.width = choice_width, .names = method_names(), .label = marked("compare")});
    const HiddenResult* result = hidden.answer ? hidden.answer->camera.get() : nullptr;
    if (result && widgets::IsListed(target_of("visibility.step"))) {
        widgets::StepBar("steps", params.visibility.step, result->step_count, state.player, ImGui::GetIO().DeltaTime);
        widgets::MarkTarget(target_of("visibility.step"));
    }
    state.left_step = params.visibility.step;
}

}  // namespace

void draw_hidden_panel(HiddenPanelState& state, Session& session, const HiddenStatus& hidden) {
    Params& params = session.params;
    const VisibilityMethod method = params.visibility.method;
    const bool is_open = !is_drawn_by_gl_alone(method) || params.view.shows == Shows::difference ||
                         params.visibility.step >= 0 || params.visibility.numbers;
    if (widgets::IsListing()) return draw_listed(state, params, hidden);
    if (!is_open) {
        behind(widgets::SmallButtonWidth("Steps"));
        if (widgets::SmallButton("Steps")) params.visibility.step = 0;
        widgets::Tooltip("Steps", "Draws the scene polygon by polygon, in the order GL receives them.");
        return;
    }
    // Use the same height for every method, so that the steps below stay in place while methods are compared.
    const float top = ImGui::GetCursorPosY(), rows = 3.0F * ImGui::GetFrameHeightWithSpacing();
    draw_options(hidden_method(method), params);
    const HiddenResult* result = hidden.answer ? hidden.answer->camera.get() : nullptr;
    if (result && hidden_method(method).sorts_by_key) draw_failure_finder(state.failure, session, *result);
    ImGui::SetCursorPosY(std::max(top + rows, ImGui::GetCursorPosY()));
    control(params, "visibility.numbers", {.label = marked("Numbers")});
    cancel_button(state, hidden);
    if (is_drawn_by_gl_alone(method))
        ImGui::Dummy({0.0F, ImGui::GetFrameHeight()});
    else
        draw_raster_row(params);
    control(params, "visibility.compare_with",
            {.width = choice_width, .names = method_names(), .label = marked("compare")});
    if (!result) return;
    widgets::StepBar("steps", params.visibility.step, result->step_count, state.player, ImGui::GetIO().DeltaTime);
    widgets::MarkTarget(target_of("visibility.step"));
    const int by_bar = params.visibility.step;
    draw_step_rows(params, *result);
    if (params.visibility.step != by_bar) state.player.playing = false;
    if (result->newell && result->newell->steps_left_out > 0) {
        const std::string note =
            say("You can step through only the first {count} of {all} comparisons.",
                "count"_a = grouped_number(result->step_count), "all"_a = grouped_number(result->counters.comparisons));
        widgets::Note(note.c_str());
    }
    state.left_step = params.visibility.step;
    counters(*result, hidden.shows_time);
    culling_counts(*result, is_taken_apart(params.visibility));
}

void stop_at_other_step(HiddenPanelState& state, const Session& session) {
    if (session.params.visibility.step != state.left_step) state.player.playing = false;
    state.left_step = session.params.visibility.step;
}

}  // namespace viewing
