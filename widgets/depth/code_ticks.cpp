// Two rows of ticks joined by lines: depth codes and the eye distances that they represent.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "text/numbers.h"
#include "widgets/area.h"
#include "widgets/depth.h"
#include "widgets/depth/depth_inner.h"

namespace widgets {

namespace {

using inner::Px;
using inner::Shown;

struct Rows {
    float left, right;  ///< of both rows
    float upper, lower;
    double near, far;

    /// Returns whether a code's eye distance is inside near…far, apart from rounding errors.
    bool Holds(double z) const {
        const double rounding = 1e-6 * (far - near);
        return z >= near - rounding && z <= far + rounding;
    }
    float AtZ(double z) const { return At(std::clamp((z - near) / (far - near), 0.0, 1.0)); }
    float At(double share) const { return static_cast<float>(left + share * (right - left)); }
};

struct CodeTick {
    std::size_t index;
    float upper_x, lower_x;
    bool is_joined;
};

/// Returns every n-th tick, so that the ticks in the upper row stay apart, and always the last tick.
std::vector<CodeTick> ReadableTicks(const Rows& rows, std::span<const double> eye_distances) {
    const std::size_t last = eye_distances.size() - 1;
    const std::size_t most = std::max<std::size_t>(static_cast<std::size_t>((rows.right - rows.left) / Px(6)), 1);
    const std::size_t stride = std::max<std::size_t>((last + most - 1) / most, 1);
    std::vector<CodeTick> ticks;
    const auto add = [&](std::size_t index) {
        const double share = last > 0 ? static_cast<double>(index) / static_cast<double>(last) : 0.0;
        const double z = eye_distances[index];
        const bool is_joined = rows.Holds(z);
        ticks.push_back({index, rows.At(share), is_joined ? rows.AtZ(z) : 0.0F, is_joined});
    };
    for (std::size_t index = 0; index < last; index += stride) add(index);
    add(last);
    return ticks;
}

/// Returns the tick whose line is nearest to the pointer; null if no line is close.
const CodeTick* TickAt(const Rows& rows, std::span<const CodeTick> ticks, ImVec2 pointer) {
    if (pointer.y < rows.upper - Px(10) || pointer.y > rows.lower + Px(10)) return nullptr;
    const float share = std::clamp((pointer.y - rows.upper) / (rows.lower - rows.upper), 0.0F, 1.0F);
    const CodeTick* nearest = nullptr;
    float nearest_px = Px(8);
    for (const CodeTick& tick : ticks) {
        if (!tick.is_joined && share > 0.2F) continue;
        const float x = tick.is_joined ? tick.upper_x + share * (tick.lower_x - tick.upper_x) : tick.upper_x;
        if (const float away = std::abs(pointer.x - x); away < nearest_px) {
            nearest_px = away;
            nearest = &tick;
        }
    }
    return nearest;
}

void DrawTicks(ImDrawList* draw, const Rows& rows, std::span<const CodeTick> ticks, const CodeTick* pointed) {
    const Palette& palette = CurrentContext().palette;
    const float line = Px(1) * palette.stroke, tick_px = Px(6);
    const ImU32 axis = Shown(inner::Mix(palette.border, palette.quiet, 0.5F));
    for (const float y : {rows.upper, rows.lower}) {
        draw->AddLine(ImVec2(rows.left, y), ImVec2(rows.right, y), axis, line);
    }
    const auto draw_tick = [&](const CodeTick& tick, ImU32 color, ImU32 joint, float width) {
        const ImVec2 above(tick.upper_x, rows.upper), below(tick.lower_x, rows.lower);
        draw->AddLine(ImVec2(above.x, above.y - tick_px), above, color, width);
        if (!tick.is_joined) return;
        draw->AddLine(above, below, joint, width);
        draw->AddLine(below, ImVec2(below.x, below.y + tick_px), color, width);
    };
    for (const CodeTick& tick : ticks) {
        const ImU32 color = tick.is_joined ? palette.text : palette.quiet;
        draw_tick(tick, Shown(color), Shown(inner::Mix(palette.view_ground, palette.camera, 0.65F)), line);
    }
    if (pointed) draw_tick(*pointed, Shown(palette.accent), Shown(palette.accent), Px(2.5F) * palette.stroke);
}

/// Draws text at both ends of a row, and its title between them if it fits.
void DrawRowTexts(ImDrawList* draw, const Rows& rows, float y, const std::string& first, const std::string& last,
                  const char* title) {
    const Palette& palette = CurrentContext().palette;
    const inner::Face face = inner::FaceOf(CurrentContext().fonts.note);
    const float first_end = rows.left + face.Measure(first).x, last_begin = rows.right - face.Measure(last).x;
    face.Draw(draw, ImVec2(rows.left, y), Shown(palette.text), first);
    if (last_begin >= first_end + Px(4)) face.Draw(draw, ImVec2(std::floor(last_begin), y), Shown(palette.text), last);
    const float width = face.Measure(title).x, left = std::floor(0.5F * (rows.left + rows.right - width));
    if (left < first_end + Px(10) || left + width > last_begin - Px(10)) return;
    face.Draw(draw, ImVec2(left, y), Shown(palette.quiet), title);
}

void DrawReadout(ImDrawList* draw, const inner::Box& area, ImVec2 at, const CodeTick& tick,
                 std::span<const double> eye_distances, const CodeTicksStyle& style) {
    const std::size_t i = tick.index, count = eye_distances.size();
    const std::string heading = i < style.codes.size()
                                    ? say("code {code}", "code"_a = style.codes[i])
                                    : say("{number} of {count}", "number"_a = i + 1, "count"_a = count);
    std::vector<std::string> lines{say("z: {z}", "z"_a = viewing::steady_figures(eye_distances[i]))};
    if (i + 1 < count) {
        lines.push_back(say("to the next: {distance}",
                            "distance"_a = viewing::steady_figures(std::abs(eye_distances[i + 1] - eye_distances[i]))));
    }
    inner::DrawReadoutBox(draw, area, at, heading, lines);
}

}  // namespace

int CodeTicks(const char* id, std::span<const double> eye_distances, double near, double far,
              const CodeTicksStyle& style) {
    const ImVec2 size = inner::AreaSize(style.size, ImVec2(180, 120));
    const Group group(id);
    ImGui::InvisibleButton("ticks", size);
    Record("ticks");
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax(), pointer = ImGui::GetIO().MousePos;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->PushClipRect(min, max, true);
    draw->AddRectFilled(min, max, Shown(CurrentContext().palette.view_ground), Px(4));

    int hovered = -1;
    const bool has_range = std::isfinite(near) && std::isfinite(far) && near < far;
    if (!has_range || eye_distances.empty()) {
        inner::DrawHint(draw, min, max,
                        has_range ? marked("No codes to show.") : marked("Near must be less than far."));
    } else {
        const float text = inner::FaceOf(CurrentContext().fonts.note).size;
        const Rows rows{.left = min.x + Px(14),
                        .right = max.x - Px(14),
                        .upper = std::floor(min.y + text + Px(18)) + 0.5F,
                        .lower = std::floor(max.y - text - Px(18)) + 0.5F,
                        .near = near,
                        .far = far};
        const std::vector<CodeTick> ticks = ReadableTicks(rows, eye_distances);
        const CodeTick* pointed = ImGui::IsItemHovered() ? TickAt(rows, ticks, pointer) : nullptr;
        DrawTicks(draw, rows, ticks, pointed);
        DrawRowTexts(draw, rows, min.y + Px(6), style.first_depth, style.last_depth, style.depth_title);
        DrawRowTexts(draw, rows, max.y - text - Px(6), say("near {z}", "z"_a = viewing::steady_figures(near)),
                     style.ends_at_far ? say("far {z}", "z"_a = viewing::steady_figures(far))
                                       : say("z = {z}", "z"_a = viewing::steady_figures(far)),
                     style.z_title);
        for (const CodeTick& tick : ticks) {
            inner::RecordRect(("tick/" + std::to_string(tick.index)).c_str(), ImVec2(tick.upper_x, rows.upper),
                              ImVec2(tick.is_joined ? tick.lower_x : tick.upper_x, rows.lower),
                              viewing::steady_figures(eye_distances[tick.index]));
        }
        if (pointed) {
            hovered = static_cast<int>(pointed->index);
            DrawReadout(draw, {min, max}, pointer, *pointed, eye_distances, style);
        }
    }
    draw->PopClipRect();
    return hovered;
}

}  // namespace widgets
