// The bar that steps through a method: buttons, a track, the step as a number, and the speed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "text/catalogue.h"
#include "widgets/area.h"
#include "widgets/diagrams.h"

namespace widgets {

namespace {

using inner::Px;
using inner::Shown;

constexpr int all_steps = -1;
constexpr const char* no_steps = viewing::marked("No steps to go through.");

/// Resolves `step` to 0…count: −1 means all steps.
int Reached(int step, int count) {
    return step < 0 ? count : std::min(step, count);
}

// ---- buttons ---------------------------------------------------------------------------------------

float ButtonWidth() {
    return std::round(ImGui::GetFrameHeight() * 1.15F);
}

enum class Icon { first, back, play, pause, forward, last };

void DrawIcon(ImDrawList* draw, ImVec2 center, float r, Icon icon, ImU32 color) {
    const float line = std::max(Px(2), r * 0.36F);
    const auto bar = [&](float x) {
        draw->AddRectFilled(ImVec2(x - 0.5F * line, center.y - r), ImVec2(x + 0.5F * line, center.y + r), color);
    };
    // `side`: +1 points to the right, −1 to the left.
    const auto triangle = [&](float x, float side, float reach) {
        draw->AddTriangleFilled(ImVec2(x - side * reach, center.y - r), ImVec2(x + side * reach, center.y),
                                ImVec2(x - side * reach, center.y + r), color);
    };
    const auto chevron = [&](float side) {
        const ImVec2 points[] = {ImVec2(center.x - side * 0.35F * r, center.y - 0.85F * r),
                                 ImVec2(center.x + side * 0.5F * r, center.y),
                                 ImVec2(center.x - side * 0.35F * r, center.y + 0.85F * r)};
        draw->AddPolyline(points, 3, color, 0, line);
    };
    switch (icon) {
        case Icon::first:
            bar(center.x - 0.8F * r);
            triangle(center.x + 0.3F * r, -1.0F, 0.75F * r);
            break;
        case Icon::back:
            chevron(-1.0F);
            break;
        case Icon::play:
            triangle(center.x + 0.1F * r, 1.0F, 0.9F * r);
            break;
        case Icon::pause:
            bar(center.x - 0.5F * r);
            bar(center.x + 0.5F * r);
            break;
        case Icon::forward:
            chevron(1.0F);
            break;
        case Icon::last:
            bar(center.x + 0.8F * r);
            triangle(center.x - 0.3F * r, 1.0F, 0.75F * r);
            break;
    }
}

/// `id` is "##" followed by a name.
bool IconButton(const char* id, Icon icon, bool enabled, const char* tip) {
    const bool bar_is_disabled = inner::IsDisabled();
    ImGui::BeginDisabled(!enabled);
    const float side = ImGui::GetFrameHeight();
    const bool clicked = ImGui::Button(id, ImVec2(ButtonWidth(), side));
    GoOnWhileHeld();
    const ImVec2 min = ImGui::GetItemRectMin(), max = ImGui::GetItemRectMax();
    DrawIcon(ImGui::GetWindowDrawList(), ImVec2(std::round(0.5F * (min.x + max.x)), std::round(0.5F * (min.y + max.y))),
             std::round(side * 0.23F), icon, Shown(CurrentContext().palette.text));
    inner::RecordRect(id, min, max);
    ImGui::EndDisabled();
    if (!bar_is_disabled) Tooltip(id + 2, enabled ? tip : "Already there.");
    ImGui::SameLine(0.0F, Px(2));
    return clicked;
}

/// Returns the step after this frame's button presses. Sets `playing`.
int UseButtons(int step, int count, bool& playing) {
    const int reached = Reached(step, count);
    int next = step;
    bool by_hand = false;
    const auto move = [&](int to) {
        next = to;
        by_hand = true;
    };
    if (IconButton("##First", Icon::first, count > 0 && step != 0, "Rewinds to the start.")) move(0);
    ImGui::PushButtonRepeat(true);
    if (IconButton("##Back", Icon::back, count > 0 && reached > 0, "Goes back one step; hold to repeat."))
        move(reached - 1);
    ImGui::PopButtonRepeat();
    if (IconButton(playing ? "##Pause" : "##Play", playing ? Icon::pause : Icon::play, count > 0,
                   playing ? viewing::marked("Stops at this step.")
                           : viewing::marked("Plays step by step; at the end, starts over."))) {
        playing = !playing;
        if (playing && reached >= count) next = 0;
    }
    ImGui::PushButtonRepeat(true);
    if (IconButton("##Forward", Icon::forward, count > 0 && reached < count, "Advances one step; hold to repeat.")) {
        move(reached + 1);
    }
    ImGui::PopButtonRepeat();
    if (IconButton("##All", Icon::last, count > 0 && step != all_steps, "Shows the final result.")) move(all_steps);
    if (by_hand) playing = false;
    return next;
}

// ---- the track -------------------------------------------------------------------------------------

void DrawTrack(ImDrawList* draw, ImVec2 min, ImVec2 max, float begin, float end, int reached, int count) {
    const Palette& palette = CurrentContext().palette;
    const float middle = std::floor(0.5F * (min.y + max.y)) + 0.5F, half = Px(2), length = end - begin;
    const auto x_of = [&](int step) {
        return count > 0 ? begin + length * static_cast<float>(step) / static_cast<float>(count) : begin;
    };
    const float knob = x_of(reached);
    draw->AddRectFilled(ImVec2(begin - half, middle - half), ImVec2(end + half, middle + half), Shown(palette.border),
                        half);
    draw->AddRectFilled(ImVec2(begin - half, middle - half), ImVec2(knob, middle + half), Shown(palette.accent), half);
    const bool has_ticks = count > 0 && length / static_cast<float>(count) >= Px(7);
    for (int step = 0; has_ticks && step <= count; ++step) {
        const float x = std::floor(x_of(step)) + 0.5F;
        draw->AddLine(ImVec2(x, middle + Px(5)), ImVec2(x, middle + Px(8)), Shown(palette.quiet), Px(1));
    }
    const bool held = ImGui::IsItemHovered() || ImGui::IsItemActive();
    draw->AddCircleFilled(ImVec2(knob, middle), Px(held ? 7 : 6), Shown(palette.accent));
    if (held) draw->AddCircleFilled(ImVec2(knob, middle), Px(3), Shown(inner::InkOn(palette.accent)));
}

/// Returns the step after this frame's mouse actions on the track. A Ctrl-click sets `type`, so that the user can type
/// the number.
int UseTrack(int step, int count, float width, bool& type) {
    Editing& editing = CurrentContext().editing;
    const ImGuiIO& io = ImGui::GetIO();
    const inner::WheelArea area("track", ImVec2(width, ImGui::GetFrameHeight()));
    const float begin = area.min.x + Px(8), end = std::max(area.max.x - Px(8), begin + 1.0F);
    const int reached = Reached(step, count);
    const double share = count > 0 ? static_cast<double>(reached) / count : 0.0;
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton("track", ImVec2(width, ImGui::GetFrameHeight()));
    inner::RecordRect("track", area.min, area.max, std::to_string(reached));

    int next = step;
    const auto drag_to = [&](double to) { next = static_cast<int>(std::lround(std::clamp(to, 0.0, 1.0) * count)); };
    if (ImGui::IsItemHovered() && io.MouseWheel != 0.0F) {
        next = std::clamp(reached + (io.MouseWheel > 0.0F ? 1 : -1), 0, count);
    }
    if (ImGui::IsItemActivated()) {
        editing.drag_value = share;
        const bool on_knob = std::abs(io.MousePos.x - (begin + share * (end - begin))) <= Px(7);
        if (!on_knob && !io.KeyCtrl) {
            editing.drag_value = (io.MousePos.x - begin) / (end - begin);
            drag_to(editing.drag_value);
        }
    } else if (ImGui::IsItemActive() && io.MouseDelta.x != 0.0F && !io.KeyCtrl) {
        editing.drag_value += io.MouseDelta.x / (end - begin) * (io.KeyAlt ? 0.01 : 1.0);
        drag_to(editing.drag_value);
    }
    type = ImGui::IsItemDeactivated() && io.KeyCtrl;
    if (count == 0) Tooltip("", no_steps);
    DrawTrack(ImGui::GetWindowDrawList(), area.min, area.max, begin, end, Reached(next, count), count);
    return next;
}

// ---- the number ------------------------------------------------------------------------------------

void Word(std::string_view word, float width, bool to_right = false) {
    const inner::Face face = inner::FaceOf(nullptr);
    const ImVec2 min = ImGui::GetCursorScreenPos();
    ImGui::Dummy(ImVec2(width, ImGui::GetFrameHeight()));
    const float left = to_right ? min.x + width - face.Measure(word).x : min.x;
    face.Draw(ImGui::GetWindowDrawList(),
              ImVec2(std::floor(left), std::floor(min.y + 0.5F * (ImGui::GetFrameHeight() - face.size))),
              Shown(CurrentContext().palette.quiet), word);
}

/// The text "step 12 of 340" or "all 340 steps". Its number is editable and stays in place when the words change. If
/// the words do not fit, the text is "12 / 340".
struct StepText {
    const char *step_word, *all_word, *steps_word;
    std::string of;
    float word, box, rest;

    StepText(int count, float room) : step_word(tr("step")), all_word(tr("all")), steps_word(tr("steps")) {
        const std::string slash = say("/ {count}", "count"_a = count);
        of = count < 10'000 ? say("of {count}", "count"_a = count) : slash;
        box = std::ceil(inner::FaceOf(CurrentContext().fonts.number).Measure(std::to_string(std::max(count, 100))).x +
                        Px(14));
        Measure();
        if (Width() <= room) return;
        step_word = all_word = "";
        of = slash;
        steps_word = of.c_str();
        Measure();
    }
    StepText(const StepText&) = delete;
    StepText& operator=(const StepText&) = delete;
    void Measure() {
        const inner::Face face = inner::FaceOf(nullptr);
        word = std::ceil(std::max(face.Measure(step_word).x, face.Measure(all_word).x));
        rest = std::ceil(std::max(face.Measure(of).x, face.Measure(steps_word).x));
    }
    /// Returns the ImGui id of this number's NumberBox.
    static ImGuiID BoxId() {
        ImGui::PushID("step");
        const ImGuiID id = ImGui::GetID("##box");
        ImGui::PopID();
        return id;
    }
    float Width() const { return word + box + rest + Px(12); }

    int Show(int step, int count) const {
        const bool all = step < 0;
        const ImVec2 min = ImGui::GetCursorScreenPos();
        Word(all ? all_word : step_word, word, true);
        ImGui::SameLine(0.0F, Px(6));
        double value = Reached(step, count);
        const NumberStyle style{.min = 0.0,
                                .max = static_cast<double>(count),
                                .step = std::clamp(count / 400.0, 0.02, 100.0),
                                .decimals = 0,
                                .integer = true,
                                .default_value = static_cast<double>(count)};
        const bool edited = inner::NumberBox("step", value, style, box);
        Tooltip("Step", "Double-click to type, drag to change.");
        ImGui::SameLine(0.0F, Px(6));
        Word(all ? steps_word : of, rest);
        const std::string text =
            all ? say_count(count, "the only step", "all {count} steps")
                : say("step {step} of {count}", "step"_a = Reached(step, count), "count"_a = count);
        inner::RecordRect("text", min, ImGui::GetItemRectMax(), text);
        return edited ? static_cast<int>(std::lround(value)) : step;
    }
};

void Speed(float& steps_per_s, float width) {
    double speed = std::isfinite(steps_per_s) ? static_cast<double>(steps_per_s) : 10.0;
    const NumberStyle style{
        .min = 0.5, .max = 5000.0, .decimals = 1, .unit = "/s", .logarithmic = true, .default_value = 10.0};
    if (Slider("##speed", speed, style, width)) steps_per_s = static_cast<float>(speed);
    Tooltip("Speed", "Steps per second during playback.");
}

/// Returns the seconds until the next step, at most 0.5.
float NextStepIn(double steps_per_s, double carry) {
    return static_cast<float>(steps_per_s > 0.0 ? std::clamp((1.0 - carry) / steps_per_s, 0.0, 0.5) : 0.5);
}

}  // namespace

void PlaySteps(int& step, int count, StepPlayer& player, double dt_s) {
    if (count <= 0) player.playing = false;
    if (!player.playing) return;
    const int reached = Reached(step, count);
    if (reached == count) {
        step = 0;
        player.carry_steps = 0.0;
        return;
    }
    const double added = dt_s * static_cast<double>(player.steps_per_s);
    // Due to rounding, frame times that should add up to whole steps may fall slightly short.
    constexpr double rounding = 1e-9;
    if (std::isfinite(added) && added > 0.0) player.carry_steps += added;
    const double whole = std::floor(player.carry_steps + rounding);
    if (whole >= count - reached) {
        step = count;
        player.playing = false;
        player.carry_steps = 0.0;
        return;
    }
    if (whole < 1.0) return;
    step = reached + static_cast<int>(whole);
    player.carry_steps = std::max(player.carry_steps - whole, 0.0);
}

void StopUnlessShown(StepPlayer& player) {
    if (!std::exchange(player.shown, false)) player.playing = false;
}

bool StepBar(const char* id, int& step, int count, StepPlayer& player, double dt_s) {
    if (CurrentContext().printed) return false;
    const Group group(id);
    player.shown = true;
    count = std::max(count, 0);
    int next = step;
    PlaySteps(next, count, player, dt_s);

    ImGui::BeginGroup();
    ImGui::BeginDisabled(count == 0);
    const float room = ImGui::GetContentRegionAvail().x, gap = Px(8);
    const float buttons = 5.0F * (ButtonWidth() + Px(2));
    const StepText text(count, room - buttons - gap);
    const bool has_speed = Offers("speed");
    const float speed = has_speed ? gap + Px(92) * CurrentContext().palette.type_scale : 0.0F, least_track = Px(150);
    const bool in_one_row = buttons + text.Width() + speed + least_track + 2.0F * gap <= room;

    const bool was_playing = player.playing;
    next = UseButtons(next, count, player.playing);
    ImGui::SameLine(0.0F, gap);
    bool type = false;
    const auto track = [&](float width) {
        const int before = next;
        next = UseTrack(next, count, std::max(width, Px(60)), type);
        if (next != before) player.playing = false;
    };
    if (in_one_row) {
        track(room - buttons - text.Width() - speed - 2.0F * gap);
        ImGui::SameLine(0.0F, gap);
    }
    const int typed = text.Show(next, count);
    if (typed != next) player.playing = false;
    next = typed;
    if (!in_one_row) track(room - speed);
    if (has_speed) {
        ImGui::SameLine(0.0F, gap);
        Speed(player.steps_per_s, speed - gap);
    }
    if (type) CurrentContext().editing.type_next = StepText::BoxId();
    ImGui::EndDisabled();
    ImGui::EndGroup();
    if (count == 0) Tooltip("", no_steps);

    if (player.playing && !was_playing) player.carry_steps = 0.0;
    if (player.playing) AskForRedraw(NextStepIn(static_cast<double>(player.steps_per_s), player.carry_steps));
    const bool changed = next != step;
    step = next;
    return changed;
}

}  // namespace widgets
