#include "topics/planes/shown/derivation_flow.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "topics/planes/shown/derivation_text.h"
#include "ui/parts/look.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

using Lines = std::vector<DerivationLine>;

constexpr float least_column = 236.0F;  ///< width, in design pixels
constexpr float least_figure = 60.0F;   ///< height, in design pixels

/// Measures lines at a given font scale. Restores the style at the end of its scope.
class Measure {
public:
    Measure(float font_scale, float line_gap_px) {
        ImGui::SetWindowFontScale(font_scale);
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(6.0F), px(line_gap_px)});
    }
    ~Measure() {
        ImGui::PopStyleVar();
        ImGui::SetWindowFontScale(1.0F);
    }
    Measure(const Measure&) = delete;
    Measure& operator=(const Measure&) = delete;

    /// Height of a line with the space below it, in pixels.
    static float of(const DerivationLine& line, float width, bool is_small) {
        const float below = ImGui::GetStyle().ItemSpacing.y;
        switch (line.kind) {
            case DerivationLine::Kind::equation:
                return equation_height(line.parts, width, is_small) + below;
            case DerivationLine::Kind::heading:
                return heading_height(line.parts.front().c_str(), width, is_small) + below;
            case DerivationLine::Kind::note:
                return note_height(tr(line.parts.front().c_str()), width) + below;
            case DerivationLine::Kind::trouble:
                break;
        }
        return widgets::TroubleHeight(line.parts.front().c_str(), width) + below;
    }
    float of(const Lines& lines, float width, bool only_results) const {
        float height = 0.0F;
        for (const DerivationLine& line : lines)
            if (!only_results || !line.is_step) height += of(line, width, false);
        return height;
    }
    /// Height of a line in a column of the flow; 0 for a step if the flow omits steps.
    static float in_column(const DerivationFlow& flow, const DerivationLine& line) {
        return flow.is_short && line.is_step ? 0.0F : of(line, flow.column.x, true);
    }
};

/// Fills columns from the last line up. The first column gets the remaining lines, below the figure and its controls.
/// Returns whether the figure has at least `least_height`, which is 0 if there is no figure.
bool fill_columns(DerivationFlow& flow, const Lines& lines, int count, float controls, float least_height) {
    flow.columns.assign(static_cast<std::size_t>(count), 0);
    std::size_t end = lines.size();
    for (int column = count - 1; column > 0; --column) {
        float height = 0.0F;
        while (end > 0) {
            height += Measure::in_column(flow, lines[end - 1]);
            if (height > flow.column.y) break;
            --end;
        }
        // Keep a heading together with the line below it.
        while (end < lines.size() && end > 0 && lines[end - 1].kind == DerivationLine::Kind::heading) ++end;
        flow.columns[column] = end;
    }
    float first = 0.0F;
    for (std::size_t i = 0; i < end; ++i) first += Measure::in_column(flow, lines[i]);
    const float rest = std::floor(flow.column.y - controls - first - px(4.0F));
    flow.figure = {flow.column.x, least_height > 0.0F ? rest : 0.0F};
    return rest >= least_height;
}

}  // namespace

DerivationFlow flow_of(const Lines& lines, ImVec2 room, int control_rows, bool may_be_short) {
    const widgets::Context& context = widgets::CurrentContext();
    const bool is_stage = widgets::HasPlainTitles();
    DerivationFlow flow;
    // On stage, lines are longer: in a narrow view, text beside the figure would be cut off unless the view is at least
    // twice as wide as it is high.
    const float least_aspect = is_stage && room.x < px(520.0F) ? 2.0F : 1.3F;
    flow.is_wide = room.x >= px(420.0F) && room.x >= least_aspect * room.y;
    const float width = flow.is_wide ? std::floor(room.x * 0.43F) : std::max(room.x, 1.0F);
    const bool has_bar = !is_stage && !context.printed;
    const auto height_of = [&](int rows) {
        return has_bar ? static_cast<float>(rows) * (ImGui::GetFrameHeight() + px(DerivationFlow::control_gap)) : 0.0F;
    };
    const float controls = height_of(control_rows);
    flow.control_rows = control_rows;
    flow.has_controls =
        flow.is_wide && has_bar && width >= px(DerivationFlow::least_bar) && room.y - controls >= px(least_figure);
    const float wide = room.y - (flow.has_controls ? controls : 0.0F);
    flow.figure = {width, flow.is_wide ? std::max(wide, 1.0F) : std::max(std::floor(room.y * 0.5F), px(60.0F))};

    room.x -= ImGui::GetStyle().ScrollbarSize + 2.0F * px(DerivationFlow::padding);
    const float text = flow.is_wide ? room.x - width - px(DerivationFlow::gap) : room.x;
    const float height = (flow.is_wide ? room.y : room.y - flow.figure.y) - (flow.has_controls ? 0.0F : controls);
    if (is_stage) {
        flow.is_short = may_be_short && room.y < px(420.0F);
        return flow;
    }
    if (Measure(1.0F, 3.0F).of(lines, text, false) <= height) return flow;

    // In the small number font, an em of 9 pixels makes a line 12 pixels high, without the theme's type scale.
    const float least_scale =
        std::min(1.0F, 12.0F * context.scale / (context.palette.type_scale * context.fonts.small_number->FontSize));
    constexpr float step = 0.04F;
    const auto for_scales = [&](const auto& fits) {
        float scale = 1.0F;
        while (!fits(scale) && scale > least_scale) scale = std::max(scale - step, least_scale);
    };
    const DerivationFlow beside = flow;
    bool is_done = false;
    const auto try_columns = [&](int rows, float least_height) {
        const float controls_px = height_of(rows);
        for_scales([&](float scale) {
            for (int count = 2; count <= 4 && !is_done; ++count) {
                const Measure measure(scale, 1.0F);
                const float gaps = static_cast<float>(count - 1) * px(DerivationFlow::gap);
                flow.font_scale = scale;
                flow.control_rows = rows;
                flow.column = {std::floor((room.x - gaps) / static_cast<float>(count)),
                               room.y - px(DerivationFlow::foot)};
                flow.has_controls = has_bar && rows > 0;
                is_done =
                    flow.column.x >= px(least_column) && fill_columns(flow, lines, count, controls_px, least_height);
            }
            return is_done;
        });
    };
    constexpr int step_bar_rows = 2;
    const auto fill_view = [&] {
        try_columns(control_rows, px(least_figure));
        if (!is_done) try_columns(step_bar_rows, px(least_figure));
        if (!is_done) try_columns(step_bar_rows, 0.0F);
        if (!is_done && may_be_short) try_columns(0, 0.0F);
    };
    fill_view();
    if (is_done) return flow;
    flow = beside;
    flow.is_short = may_be_short;
    bool is_beside = false;
    for_scales([&](float scale) {
        flow.font_scale = scale;
        return is_beside = Measure(scale, flow.line_gap()).of(lines, text, flow.is_short) <= height;
    });
    if (is_beside || !may_be_short) return flow;
    const DerivationFlow scrolling = flow;
    fill_view();
    return is_done ? flow : scrolling;
}

void write_line(const DerivationLine& line, bool is_small) {
    const char* const text = line.parts.front().c_str();
    switch (line.kind) {
        case DerivationLine::Kind::equation:
            return equation(line.parts, 0.0F, is_small);
        case DerivationLine::Kind::heading:
            return derivation_heading(text, is_small);
        case DerivationLine::Kind::note:
            return widgets::Note(text);
        case DerivationLine::Kind::trouble:
            return widgets::Trouble(text);
    }
}

}  // namespace viewing
