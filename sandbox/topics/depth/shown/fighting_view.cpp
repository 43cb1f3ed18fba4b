#include "topics/depth/shown/fighting_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "text/catalogue.h"
#include "topics/depth/numbers/depth_precision.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

constexpr float bar_room = 30.0F;  ///< design pixels

enum FightingColumn { names, distance, gap, step, onset, predicted, jittered_mean, counted, pixels, fighting_columns };

struct ColumnText {
    const char *title, *explanation;
    const char* target;  ///< the column's name in lessons
};
constexpr std::array<ColumnText, fighting_columns> columns = {{
    {marked("pair"),
     marked("Two flat surfaces that are nearly coplanar. For each pair, the formulas' prediction is listed next to the "
            "number of pixels where GL and exact visibility show different surfaces."),
     "column:fighting.pair"},
    {marked("z"), marked("Eye distance at the center of the surfaces' overlap."), "column:fighting.z"},
    {marked("gap"), marked("Distance between the two surfaces along their normal."), "column:fighting.gap"},
    {marked("width Δz"), marked("Δz, the code width at the overlap's center, in eye distance."),
     "column:fighting.step"},
    {marked("safe gap"),
     marked("The gap along the normal below which depth fighting is predicted: one code width plus the float32 "
            "arithmetic error. Red if the pair's gap is narrower."),
     "column:fighting.safe_gap"},
    {marked("predicted"),
     marked("The predicted range for the pair's fraction of wrong pixels, whatever errors float32 arithmetic makes "
            "before the depth is stored. ≈ marks the range that the 12 jittered cameras count instead: with 24 bits or "
            "a float, the arithmetic is as coarse as the codes, and the formulas predict nothing."),
     "column:fighting.predicted"},
    {marked("jittered"),
     marked("The mean and the range of the fraction of wrong pixels over 12 cameras, each jittered by a thousandth of "
            "the target's distance. One camera says little, since pixels hit codes at random."),
     "column:fighting.trembling"},
    {marked("counted"),
     marked("The fraction of the pair's pixels that show the wrong surface. The slide calls the wrong pixels random, "
            "but they are not: the same frame rounds to the same codes, and only motion changes them."),
     "column:fighting.counted"},
    {marked("wrong pixels"),
     marked("Pixels that show the wrong surface, out of all the pixels that the pair covers, not counting its edges."),
     "column:fighting.wrong_pixels"},
}};

struct PairRow {
    std::array<std::string, fighting_columns> texts;
    float counted_share = 0.0F;
    bool is_below_onset = false, fights = false, has_prediction = false;
};

/// Joins two names, writing their common part only once: "back / front quad at 4".
std::string pair_name(const std::string& first, const std::string& second) {
    const std::size_t at = first.find(' '), other = second.find(' ');
    if (at != std::string::npos && other != std::string::npos && first.substr(at) == second.substr(other))
        return first.substr(0, at) + " / " + second;
    return first + " / " + second;
}

/// Returns "29.0% – 71.0%", or "0.0%" if both ends look the same.
std::string percents(double least, double most) {
    const std::string low = percent(least), high = percent(most);
    return low == high ? low : say("{least} – {most}", "least"_a = low, "most"_a = high);
}

/// Returns the range that the jittered cameras count, for pairs without a prediction: "≈ 3 – 62%".
std::string counted_range(const ShareSpread& spread) {
    if (spread.cameras < 2) return "–";
    const long low = std::lround(100.0 * spread.least), high = std::lround(100.0 * spread.most);
    return low == high ? fmt::format("≈ {}%", low) : fmt::format("≈ {} – {}%", low, high);
}

PairRow row_of(const FightingReport::Row& row, const CountedPair& counted_pair) {
    const FightingOnset& gap_needed = row.predicted.onset;
    const double needed = gap_needed.gap() * row.predicted.slant;
    PairRow made;
    made.is_below_onset = !gap_needed.is_reachable || counted_pair.pair.gap() < needed;
    made.fights = counted_pair.wrong > 0;
    made.has_prediction = row.predicted.wrong_share.has_value();
    made.counted_share = static_cast<float>(counted_pair.wrong_fraction());
    const auto& share = row.predicted.wrong_share;
    const ShareSpread& spread = row.spread;
    made.texts = {pair_name(object_text(row.first), object_text(row.second)),
                  number_text(row.predicted.distance, 2),
                  figures(counted_pair.pair.gap()),
                  figures(row.predicted.step),
                  gap_needed.is_reachable ? figures(needed) : "–",
                  share ? percents(share->least, share->most) : counted_range(spread),
                  spread.cameras > 0 ? say("{mean} ({range})", "mean"_a = percent(spread.mean()),
                                           "range"_a = percents(spread.least, spread.most))
                                     : "–",
                  counted_pair.pixels > 0 ? percent(counted_pair.wrong_fraction()) : "–",
                  say("{wrong} of {all}", "wrong"_a = grouped_number(counted_pair.wrong),
                      "all"_a = grouped_number(counted_pair.pixels))};
    return made;
}

bool is_covered(FightingColumn column) {
    return widgets::IsCovered(columns[column].target);
}

/// Whether any count is covered. If one is, the others must be covered too, since each of them would give it away.
bool is_count_covered() {
    return is_covered(counted) || is_covered(pixels) || is_covered(jittered_mean);
}

/// Hides covered values, and the colors that would give them away.
void cover(PairRow& row) {
    for (std::size_t c = 0; c < columns.size(); ++c)
        if (widgets::IsCovered(columns[c].target)) row.texts[c] = "?";
    if (is_covered(onset) || is_covered(step)) row.is_below_onset = false;
    if (!is_count_covered()) return;
    row.fights = false;
    row.counted_share = 0.0F;
    if (!row.has_prediction) row.texts[predicted] = "–";
}

std::vector<PairRow> rows_of(const FightingReport& report) {
    std::vector<PairRow> rows;
    for (std::size_t i = 0; i < report.rows.size(); ++i) {
        rows.push_back(row_of(report.rows[i], report.counts.pairs[i]));
        cover(rows.back());
    }
    return rows;
}

using FightingWidths = ColumnWidths<fighting_columns>;

/// Whether a lesson's step names the column.
bool is_named(FightingColumn column) {
    return widgets::IsHighlighted(columns[column].target) || is_covered(column);
}

/// Returns the column widths. If space is short, drops columns: first the names, because the distance still identifies
/// the row; last, those that a lesson names.
FightingWidths widths_of(const std::vector<PairRow>& rows, float room) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    FightingWidths widths{};
    for (std::size_t c = 0; c < widths.size(); ++c) {
        widths[c] = width_of(tr(columns[c].title), fonts.note);
        for (const PairRow& row : rows)
            widths[c] = std::max(widths[c], width_of(row.texts[c], c == names ? fonts.note : fonts.small_number));
        widths[c] = std::ceil(widths[c]) + 1.0F;
    }
    widths[counted] = std::max(widths[counted], width_of("100.0%", fonts.small_number)) + px(bar_room);
    for (const bool drops_named : {false, true})
        for (const FightingColumn left_out : {names, pixels, step, jittered_mean, predicted, gap, onset})
            if (widths.sum() > room && is_named(left_out) == drops_named) widths[left_out] = 0.0F;
    return widths;
}

/// Draws the fraction as a bar in front of its number.
void draw_bar(float share, ImU32 color) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = ImGui::GetTextLineHeight(), width = px(bar_room - 6.0F);
    const float top = at.y + std::round(0.3F * height), bottom = at.y + std::round(0.7F * height);
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled({at.x, top}, {at.x + width, bottom}, palette().field, px(1.0F));
    const float filled = share > 0.0F ? std::max(share * width, 1.0F) : 0.0F;
    if (filled > 0.0F) draw->AddRectFilled({at.x, top}, {at.x + filled, bottom}, color, px(1.0F));
    ImGui::Dummy({width, height});
    ImGui::SameLine(0.0F, 0.0F);
}

/// Counted values are gray while they belong to an earlier state; values given by a formula always belong to the
/// current one.
ImU32 color_of(const PairRow& row, std::size_t column, bool is_behind) {
    if (column == predicted && !row.has_prediction) return is_behind ? palette().quiet : palette().text;
    if (column == counted || column == pixels || column == jittered_mean)
        return is_behind ? palette().quiet : row.fights ? palette().trouble : palette().text;
    if (column == onset && row.is_below_onset) return palette().trouble;
    return palette().text;
}

void draw_row(const PairRow& row, const FightingWidths& widths, bool is_behind) {
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    ImGui::TableNextRow();
    for (std::size_t c = 0; c < widths.size(); ++c) {
        if (widths[c] <= 0.0F) continue;
        ImGui::TableNextColumn();
        const ImU32 color = color_of(row, c, is_behind);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::PushFont(c == names ? fonts.note : fonts.small_number);
        if (c == counted) draw_bar(row.counted_share, color);
        if (c == names)
            ImGui::TextUnformatted(row.texts[c].c_str());
        else
            text_at_right(row.texts[c]);
        widgets::MarkTarget(columns[c].target);
        if (c == distance || c == counted || (c == predicted && !row.has_prediction))
            widgets::Record((row.texts[names] + ": " + row.texts[c]).c_str());
        if (c == distance) widgets::Tooltip("Pair", row.texts[names].c_str());
        ImGui::PopFont();
        ImGui::PopStyleColor();
    }
}

void draw_fighting_titles(const FightingWidths& widths) {
    ImGui::TableNextRow();
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    for (std::size_t c = 0; c < widths.size(); ++c) {
        if (widths[c] <= 0.0F) continue;
        ImGui::TableNextColumn();
        if (c == names)
            ImGui::TextUnformatted(tr(columns[c].title));
        else
            text_at_right(tr(columns[c].title));
        widgets::Record(columns[c].title);
        widgets::MarkTarget(columns[c].target);
        widgets::Tooltip(columns[c].title, columns[c].explanation);
    }
    ImGui::PopStyleColor();
}

void draw_table(const std::vector<PairRow>& rows, bool is_behind) {
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    const ImVec2 room = ImGui::GetContentRegionAvail();
    constexpr int lines_below = 3;  // the totals
    const float height = room.y - static_cast<float>(lines_below) * ImGui::GetTextLineHeightWithSpacing();
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding,
                        {px(cell_padding_x), padding_to_fill(static_cast<int>(rows.size()) + 1, height)});
    const FightingWidths widths = widths_of(rows, room.x);
    const int shown =
        static_cast<int>(std::count_if(widths.begin(), widths.end(), [](float width) { return width > 0.0F; }));
    if (ImGui::BeginTable("pairs", shown, 0, {widths.sum(), 0.0F})) {
        for (std::size_t c = 0; c < widths.size(); ++c)
            if (widths[c] > 0.0F)
                ImGui::TableSetupColumn(columns[c].title, ImGuiTableColumnFlags_WidthFixed, widths[c]);
        draw_fighting_titles(widths);
        for (const PairRow& row : rows) draw_row(row, widths, is_behind);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

struct LinePart {
    std::string text;
    ImU32 color;
};

/// Draws the parts in one or more lines. Wraps within a part only if that part is wider than a line.
void draw_parts(const std::vector<LinePart>& parts) {
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    const float left = ImGui::GetCursorScreenPos().x, right = left + ImGui::GetContentRegionAvail().x;
    const float between = px(14.0F);
    float end = left - between;
    ImGui::PushTextWrapPos(0.0F);
    for (const auto& [text, color] : parts) {
        if (text.empty()) continue;
        const float width = ImGui::CalcTextSize(text.c_str()).x;
        const bool goes_on = end > left && end + between + width <= right;
        if (goes_on) ImGui::SameLine(0.0F, between);
        end = (goes_on ? end + between : left) + width;
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(goes_on ? text.c_str() : widgets::BrokenAtBlanks(text, right - left).c_str());
        ImGui::PopStyleColor();
        widgets::Record(text.c_str());
    }
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

/// Returns a part of a line, in the trouble color if something is wrong.
LinePart told(std::string text, bool is_wrong) {
    return {std::move(text), is_wrong ? palette().trouble : palette().text};
}

/// Reports wrong pixels outside the pairs. If some of them show a surface through a nearer one, reports only those.
LinePart elsewhere(const FightingCounts& counts) {
    if (counts.bleeding_elsewhere > 0)
        return told(say_count(counts.bleeding_elsewhere, "elsewhere: {count} bleeds through",
                              "elsewhere: {count} bleed through"),
                    true);
    return told(say_count(counts.wrong_elsewhere, "elsewhere: {count} wrong pixel", "elsewhere: {count} wrong pixels"),
                counts.wrong_elsewhere > 0);
}

void draw_totals(const FightingReport& report, bool is_brief) {
    const FightingCounts& counts = report.counts;
    ImGui::Dummy({0.0F, px(2.0F)});
    if (report.counts_are_behind) {
        draw_parts({{tr("counting…"), palette().quiet}});
    } else if (!is_count_covered()) {
        const std::int64_t vanished = counts.vanished();
        draw_parts({told(say("all pairs: {percent} wrong", "percent"_a = percent(counts.wrong_fraction())),
                         counts.wrong_fraction() > 0.0),
                    elsewhere(counts),
                    vanished > 0 ? told(say("{count} show the background", "count"_a = grouped_number(vanished)), true)
                                 : LinePart{},
                    is_brief ? LinePart{}
                             : LinePart{say("at {width} × {height} pixels", "width"_a = report.size_px.x,
                                            "height"_a = report.size_px.y),
                                        palette().quiet}});
    }
    if (is_brief) {
        // No lesson step needs the minimum gap.
    } else if (is_covered(onset) || is_covered(step)) {
        // The line would give the covered values away.
    } else if (report.gap_is_behind || !report.minimum_gap) {
        draw_parts({{tr("searching for the minimum gap…"), palette().quiet}});
    } else {
        const MinimumGap& found = *report.minimum_gap;
        draw_parts(
            {told(say("minimum gap at the target, z {z}", "z"_a = number_text(found.distance, 2)), false),
             told(say("predicted {gap}", "gap"_a = found.predicted.is_reachable ? figures(found.predicted.gap()) : "–"),
                  false),
             told(say("counted {gap}", "gap"_a = found.gap ? figures(*found.gap) : "–"), false)});
        if (!found.problem.empty()) widgets::Note(found.problem.c_str());
    }
    if (!report.problem.empty()) draw_parts({told(report.problem, true)});
}

/// Draws a cure's button and, below it, the counts with that cure: the fraction of wrong pixels in the pairs, and the
/// number of wrong pixels elsewhere.
void draw_cure(Session& session, const FightingReport::Cured& cured, float width, bool is_behind) {
    const Cure& cure = cured.cure;
    const std::string name = say(cure.name);
    const std::optional<FightingCounts>& counts = cured.counts;
    const bool is_so = cure.params == session.params;
    ImGui::BeginGroup();
    const float left = ImGui::GetCursorPosX();
    const auto number = [&](const std::string& text, ImU32 color) {
        ImGui::SetCursorPosX(left + std::floor(0.5F * (width - ImGui::CalcTextSize(text.c_str()).x)));
        ImGui::PushStyleColor(ImGuiCol_Text, is_behind ? palette().quiet : color);
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopStyleColor();
        widgets::Record((name + ": " + text).c_str());
    };
    if (!widgets::OffersButton(name.c_str()))
        number(name, palette().text);
    else if (widgets::SmallButton(name.c_str(), !is_so, tr("Already applied.")))
        session.params = cure.params;
    widgets::Tooltip(name.c_str(), say(cure.explanation).c_str());
    ImGui::PushFont(widgets::CurrentContext().fonts.small_number);
    if (!counts) {
        number("…", palette().quiet);
    } else {
        const double share = counts->wrong_fraction();
        number(percent(share), share > 0.0 ? palette().trouble : palette().text);
        if (counts->wrong_elsewhere > 0) number("+" + grouped_number(counts->wrong_elsewhere), palette().trouble);
    }
    ImGui::PopFont();
    ImGui::EndGroup();
}

/// Draws the cures side by side, as many per line as fit.
void draw_cures(Session& session, const FightingReport& report) {
    if (report.cured.empty() || is_count_covered() || widgets::IsCovered("advice")) return;
    const widgets::Fonts& fonts = widgets::CurrentContext().fonts;
    ImGui::Dummy({0.0F, px(2.0F)});
    ImGui::PushFont(fonts.note);
    draw_parts({{tr("with each change alone: wrong pixels in the pairs and elsewhere"), palette().quiet}});
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x, between = px(5.0F);
    float end = right;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {between, px(2.0F)});
    for (const FightingReport::Cured& cured : report.cured) {
        const float width = widgets::SmallButtonWidth(say(cured.cure.name).c_str());
        const float room = std::max(width, width_of("100.0%", fonts.small_number));
        if (end + between + room <= right) ImGui::SameLine(0.0F, between + end - ImGui::GetItemRectMax().x);
        end = ImGui::GetCursorScreenPos().x + room;
        draw_cure(session, cured, width, report.counts_are_behind);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
}

}  // namespace

void draw_fighting_view(Session& session, const FightingReport* report, const Rect& rect) {
    const ViewWindow view("fighting view", rect);
    const widgets::Group group("fighting");
    if (!report) {
        offer("Counting…");
        return;
    }
    if (report->rows.empty() && report->problem.empty() && !report->counts_are_behind) {
        if (offer("No two flat surfaces in this scene are nearly coplanar, so there is no depth fighting.",
                  "Open coplanar"))
            session.params.scene = std::string("coplanar");
        return;
    }
    draw_table(rows_of(*report), report->counts_are_behind);
    // When presenting, show only the parts that lesson steps refer to, in larger type.
    const bool is_brief = widgets::HasPlainTitles();
    draw_totals(*report, is_brief);
    if (!is_brief) draw_cures(session, *report);
}

}  // namespace viewing
