// The drawing order of the polygons, linked with the pictures. The view also shows what the method does at the current
// step: Newell's ladder, the depth buffer's comparison, or a ray's hits. Read polygon_table.h and step_text.h first.
#include "topics/hidden/shown/order_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "text/catalogue.h"
#include "topics/hidden/numbers/hidden_method.h"
#include "topics/hidden/shown/polygon_names.h"
#include "topics/hidden/shown/polygon_table.h"
#include "topics/hidden/shown/step_rows.h"
#include "topics/hidden/shown/step_text.h"
#include "ui/parts/look.h"
#include "ui/parts/table_parts.h"
#include "ui/parts/view_window.h"

namespace viewing {
namespace {

/// Draws the order. While steps are shown, a click on a row goes to the step that draws its polygon.
void draw_list(OrderViewState& state, PolygonLinks& links, Params& params, const HiddenResult& result, ImVec2 size) {
    const OrderRows rows(result, links.tree);
    PolygonTable table(links, result, "order", rows.detail_title(), rows.count(), size);
    if (!table.is_open()) return;
    // Scroll only once to each new target: the place that the step reaches, or a polygon selected elsewhere.
    if (rows.current() != std::exchange(state.current, rows.current()) && rows.current() >= 0)
        table.scroll_to(rows.current());
    const int selected = links.now.selected_fragment;
    if (selected != std::exchange(state.revealed, selected) && selected >= 0)
        if (const int place = place_of(result, selected); place >= 0) table.scroll_to(place);
    ImGuiListClipper clipper;
    clipper.Begin(rows.count(), table.row_height());
    while (clipper.Step())
        for (int place = clipper.DisplayStart; place < clipper.DisplayEnd; ++place)
            if (table.row(place + 1, rows.row(place))) {
                state.revealed = links.next.selected_fragment;
                if (params.visibility.step >= 0 && state.revealed >= 0)
                    params.visibility.step = result.order_steps[place];
            }
}

void draw_hits(PolygonLinks& links, const HiddenResult& result) {
    recorded_note(ray_sentence(result));
    const std::vector<RayHitRow> hits = ray_rows(result);
    if (hits.empty()) return;
    PolygonTable table(links, result, "hits", marked("distance"), static_cast<int>(hits.size()),
                       {0.0F, std::max(ImGui::GetContentRegionAvail().y, px(40.0F))});
    if (!table.is_open()) return;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(hits.size()), table.row_height());
    while (clipper.Step())
        for (int number = clipper.DisplayStart; number < clipper.DisplayEnd; ++number) {
            const RayHitRow& hit = hits[number];
            const std::string distance = number_text(hit.distance, 3);
            OrderRow row = row_of_polygon(result, hit.fragment, hit.source);
            row.detail = number == 0 ? say("{distance} seen", "distance"_a = distance) : distance;
            row.is_reached = row.is_current = number == 0;
            table.row(number + 1, row);
        }
}

/// Returns the fragment's depth at the followed pixel and whether it was written or hidden; says "written" only for the
/// software depth buffer.
std::string detail_of(const HiddenResult& result, const RasterStep& fragment) {
    const std::string depth = number_text(fragment.depth, 4);
    if (!result.compare && fragment.written) return depth;
    return fragment.written ? say("{depth} written", "depth"_a = depth) : say("{depth} hidden", "depth"_a = depth);
}

/// Draws the fragments of the followed pixel in drawing order; a click on one goes to its step.
void draw_touches(PolygonLinks& links, Params& params, const HiddenResult& result, ImVec2 size) {
    const glm::ivec2 pixel = *result.request.visibility.pixel;
    const float top = ImGui::GetCursorPosY();
    recorded_note(say_count(static_cast<std::int64_t>(result.touches.size()), "pixel ({x}, {y}): one fragment",
                            "pixel ({x}, {y}): {count} fragments", "x"_a = pixel.x, "y"_a = pixel.y));
    size.y = std::max(size.y - (ImGui::GetCursorPosY() - top), px(40.0F));
    PolygonTable table(links, result, "touches", marked("depth"), static_cast<int>(result.touches.size()), size);
    if (!table.is_open()) return;
    const int reached = result.step < 0 ? result.step_count : result.step;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(result.touches.size()), table.row_height());
    while (clipper.Step())
        for (int number = clipper.DisplayStart; number < clipper.DisplayEnd; ++number) {
            const PixelTouch& touch = result.touches[number];
            const int source = (*result.fragments)[touch.fragment.polygon].source;
            OrderRow row = row_of_polygon(result, touch.fragment.polygon, source);
            row.detail = detail_of(result, touch.fragment);
            row.is_reached = touch.step <= reached;
            row.is_current = touch.step == result.step;
            if (table.row(number + 1, row)) params.visibility.step = touch.step;
        }
}

/// Crosses out every line of a text whose top left corner is `corner`.
void cross_out(std::string_view lines, ImVec2 corner) {
    const float height = ImGui::GetTextLineHeight();
    for (float middle = std::round(corner.y + 0.55F * height); !lines.empty(); middle += height) {
        const std::string_view line = lines.substr(0, lines.find('\n'));
        const float width = ImGui::CalcTextSize(line.data(), line.data() + line.size()).x;
        ImGui::GetWindowDrawList()->AddLine({corner.x, middle}, {corner.x + width, middle}, palette().quiet, px(1.0F));
        lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    }
}

/// Draws one test of the ladder: crossed out if it failed, highlighted if it decided.
void draw_rung(const char* text, RungState rung) {
    const bool decided = rung == RungState::decided;
    ImGui::PushStyleColor(ImGuiCol_Text, decided ? palette().accent : palette().quiet);
    ImGui::TextUnformatted(rung == RungState::failed ? "✗" : decided ? "✓" : " ");
    ImGui::SameLine(px(24.0F));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string lines = widgets::BrokenAtBlanks(tr(text), ImGui::GetContentRegionAvail().x);
    ImGui::TextUnformatted(lines.c_str());
    if (rung == RungState::failed) cross_out(lines, at);
    ImGui::PopStyleColor();
    widgets::Record((std::string(rung == RungState::failed ? "failed: "
                                 : decided                 ? "decided: "
                                                           : "untried: ") +
                     text)
                        .c_str());
}

void named_polygon(const char* letter, const std::string& name, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(letter);
    ImGui::PopStyleColor();
    ImGui::SameLine(px(24.0F));
    shortened_text(name, ImGui::GetContentRegionAvail().x);
}

/// Draws the ladder. Its outcome is above the tests, so that even a short view shows it.
void draw_ladder(const Ladder& ladder) {
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    named_polygon("A", ladder.p, palette().light);
    if (!ladder.q.empty()) named_polygon("B", ladder.q, palette().mirror);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(
        widgets::BrokenAtBlanks(ladder.action, std::max(ImGui::GetContentRegionAvail().x, 1.0F)).c_str());
    ImGui::PopTextWrapPos();
    widgets::Record(ladder.action.c_str());
    if (!ladder.q.empty())
        for (std::size_t rung = 0; rung < ladder.rungs.size(); ++rung)
            draw_rung(newell_test_text(static_cast<NewellTest>(rung)), ladder.rungs[rung]);
    ImGui::PopFont();
}

/// Draws the number of pairs that each test decided, summed over all steps.
void draw_decided(const NewellCounters& counters) {
    ImGui::PushFont(widgets::CurrentContext().fonts.note);
    ImGui::PushStyleColor(ImGuiCol_Text, palette().quiet);
    ImGui::TextUnformatted(tr("pairs decided by each test"));
    ImGui::PopStyleColor();
    for (std::size_t test = 0; test < counters.decided.size(); ++test) {
        const std::string count = grouped_number(counters.decided[test]);
        const float right = ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(count.c_str()).x;
        const char* text = newell_test_text(static_cast<NewellTest>(test));
        const float room = right - ImGui::GetCursorPosX() - px(8.0F);
        ImGui::TextUnformatted(widgets::BrokenAtBlanks(tr(text), room).c_str());
        widgets::Record((std::string(text) + ": " + count).c_str());
        ImGui::SameLine(right);
        ImGui::TextUnformatted(count.c_str());
    }
    ImGui::PopFont();
}

/// Returns the height of the ladder down to the test that decides, so that its answer is in sight.
float height_of(const Ladder& ladder, float width) {
    const ImFont& font = *widgets::CurrentContext().fonts.note;
    std::string lines =
        ladder.p + "\n" + (ladder.q.empty() ? "" : "B\n") + widgets::BrokenAtBlanks(ladder.action, width, font);
    for (std::size_t rung = 0; rung < ladder.rungs.size() && ladder.rungs[rung] != RungState::untried; ++rung)
        lines += "\n" +
                 widgets::BrokenAtBlanks(tr(newell_test_text(static_cast<NewellTest>(rung))), width - px(24.0F), font);
    const auto count = static_cast<float>(std::count(lines.begin(), lines.end(), '\n') + 1);
    return count * (font.FontSize + ImGui::GetStyle().ItemSpacing.y) + font.FontSize;  // fades below
}

/// Draws the ladder beside the list if it fits, otherwise above it.
void draw_newell(OrderViewState& state, PolygonLinks& links, Params& params, const HiddenResult& result) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x >= px(360.0F);
    const float gap = px(10.0F), list_width = beside ? std::floor(room.x * 0.5F) : room.x;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const std::optional<Ladder> ladder = newell_ladder(result);
    const float least_list = px(76.0F), half = std::floor(room.y * 0.5F);
    const float wanted = ladder ? std::max(height_of(*ladder, room.x), half) : half;
    const float ladder_height = beside ? room.y : std::max(std::min(wanted, room.y - gap - least_list), half);
    ImGui::SetCursorScreenPos(beside ? ImVec2(from.x + list_width + gap, from.y) : from);
    ImGui::BeginChild("ladder", {beside ? room.x - list_width - gap : room.x, ladder_height});
    if (ladder)
        draw_ladder(*ladder);
    else if (result.step < 0)
        draw_decided(result.newell->counters);
    else
        recorded_note("The polygons are sorted by farthest vertex; no pair has been compared yet.");
    widgets::CountScrolled();
    ImGui::EndChild();
    ImGui::SetCursorScreenPos(beside ? from : ImVec2(from.x, from.y + ladder_height + gap));
    draw_list(state, links, params, result,
              {list_width, std::max(beside ? room.y : room.y - ladder_height - gap, px(40.0F))});
}

void draw_pixels_of(const HiddenResult& result) {
    const std::string compare = compare_sentence(result);
    recorded_note(
        compare.empty()
            ? tr("The polygons are drawn in scene order; at each pixel, the depth buffer decides which one is visible.")
            : compare);
    recorded_note(say("pixels: {tested} tested, {written} written",
                      "tested"_a = grouped_number(std::max<std::int64_t>(result.counters.pixels_tested, 0)),
                      "written"_a = grouped_number(std::max<std::int64_t>(result.counters.pixels_written, 0))));
}

/// Draws the order, and the followed pixel's fragments beside it or, in a narrow view, above it. A view that is both
/// narrow and short shows only the fragments.
void draw_lists(OrderViewState& state, PolygonLinks& links, Params& params, const HiddenResult& result) {
    const ImVec2 from = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
    const float least = px(40.0F), gap = px(10.0F);
    const auto& pixel = result.request.visibility.pixel;
    if (!pixel || result.image.ids.empty())
        return draw_list(state, links, params, result, {0.0F, std::max(room.y, least)});
    const bool beside = room.x >= px(360.0F);
    if (!beside && room.y < px(170.0F)) return draw_touches(links, params, result, {0.0F, std::max(room.y, least)});
    constexpr float share = 0.54F;  // the fragments' details are long
    const ImVec2 each = beside ? ImVec2(std::floor(share * (room.x - gap)), std::max(room.y, least))
                               : ImVec2(room.x, std::max(std::floor(0.5F * (room.y - gap)), least));
    ImGui::BeginChild("pixel", each);
    draw_touches(links, params, result, {0.0F, each.y});
    ImGui::EndChild();
    ImGui::SetCursorScreenPos(beside ? ImVec2(from.x + each.x + gap, from.y) : ImVec2(from.x, from.y + each.y + gap));
    draw_list(state, links, params, result, {beside ? room.x - gap - each.x : each.x, each.y});
}

void draw_result(OrderViewState& state, PolygonLinks& links, Params& params, const HiddenResult& result) {
    const VisibilityMethod method = result.request.visibility.method;
    if (is_drawn_by_gl_alone(method))
        recorded_note("GL receives the polygons in scene order.");
    else
        draw_step_line(params, result);
    if (result.newell) return draw_newell(state, links, params, result);
    if (hidden_method(method).casts_rays) return draw_hits(links, result);
    if (result.compare) draw_pixels_of(result);
    if (result.order.empty()) {
        offer("Nothing to draw.");
        return;
    }
    draw_lists(state, links, params, result);
}

}  // namespace

void draw_order_view(OrderViewState& state, PolygonLinks& links, Session& session, const HiddenStatus& hidden,
                     const Rect& rect) {
    const ViewWindow view("order view", rect);
    const std::shared_ptr<const HiddenResult>& result = shown_result(hidden);
    if (result) {
        links.tree.follow(result);
        return draw_result(state, links, session.params, *result);
    }
    if (!is_drawn_by_gl_alone(session.params.visibility.method)) return tell_waiting(hidden);
    if (offer("GL draws the polygons in scene order.", "Show their numbers")) session.params.visibility.numbers = true;
}

}  // namespace viewing
