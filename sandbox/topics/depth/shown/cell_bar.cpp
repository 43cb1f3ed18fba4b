#include "topics/depth/shown/cell_bar.h"

#include <algorithm>
#include <cmath>

#include "text/catalogue.h"
#include "topics/depth/shown/draw_steps.h"
#include "topics/hidden/methods/growth.h"
#include "ui/parts/look.h"
#include "widgets/diagrams.h"

namespace viewing {
namespace {

constexpr float cell_gap = 2.0F;

/// The width in pixels of a button with one symbol, which is the same for all symbols.
float button_width() {
    return std::round(1.15F * ImGui::GetFrameHeight());
}

/// The width in pixels of a button with two symbols.
float touch_width() {
    return std::round(1.6F * ImGui::GetFrameHeight());
}

bool arrow(const char* sign, bool enabled, const char* title, const char* explanation,
           const char* why_not = marked("Already there."), float width = button_width()) {
    ImGui::BeginDisabled(!enabled);
    const bool clicked = ImGui::Button(sign, {width, 0.0F});
    widgets::GoOnWhileHeld();
    widgets::Record(sign);
    ImGui::EndDisabled();
    widgets::Tooltip(title, enabled ? explanation : why_not);
    return clicked;
}

/// Returns the call's title, or "…" if the call is unknown: for one frame after a scene change, the calls still belong
/// to the old scene.
std::string title_of(const DrawCall& call, const FramePlan& plan, const Scene& scene) {
    const bool is_known = call.pass < plan.passes.size() && call.object < std::ssize(scene.objects);
    return is_known ? say(name_of(call, plan, scene)) : "…";
}

/// Draws a list from which to choose one call or all of them. Choosing changes `limit`.
void choose_call(DrawLimit& limit, const std::vector<DrawCall>& calls, const FramePlan& plan, const Scene& scene,
                 float width) {
    const auto title = [&](int call) { return title_of(calls[call], plan, scene); };
    const int count = static_cast<int>(calls.size());
    const std::string all = say("all {count} calls", "count"_a = count);
    const bool shows_all = limit.call < 0 || limit.call >= count;
    const bool has_room = ImGui::CalcTextSize(all.c_str()).x + px(34.0F) < width;
    const std::string chosen = !shows_all ? title(limit.call) : has_room ? all : say("all {count}", "count"_a = count);
    if (widgets::BeginChoice("##call", chosen.c_str(), width)) {
        for (int call = -1; call < count; ++call) {
            ImGui::PushID(call);
            const std::string name = call < 0 ? all : std::to_string(call + 1) + "  " + title(call);
            if (ImGui::Selectable(name.c_str(), call < 0 ? shows_all : call == limit.call)) limit = {call, -1};
            widgets::Record(name.c_str());
            ImGui::PopID();
        }
        widgets::EndChoice();
    } else {
        widgets::Tooltip("Draw call",
                         say("The last draw call sent to GL, out of {count} in the frame.", "count"_a = count).c_str());
    }
}

/// Draws buttons that go to the previous and the next triangle at the pixel.
void touch_buttons(DrawLimit& limit, const DepthData& data) {
    const char* const why_not =
        data.pixel ? marked("No more triangles touch this pixel.") : marked("Click a pixel of the picture first.");
    const auto previous = previous_of(data.touches, limit, data.calls), next = next_of(data.touches, limit, data.calls);
    if (arrow("←□", previous.has_value(), marked("Back at this pixel"),
              marked("Goes to the previous triangle that touches the pixel."), why_not, touch_width()))
        limit = *previous;
    ImGui::SameLine(0.0F, px(cell_gap));
    if (arrow("□→", next.has_value(), marked("Next at this pixel"),
              marked("Goes to the next triangle that touches the pixel."), why_not, touch_width()))
        limit = *next;
}

void call_row(DrawLimit& limit, const DepthData& data, const FramePlan& plan, const Scene& scene, const Rect& rect) {
    const std::vector<DrawCall>& calls = data.calls;
    const float buttons = 2.0F * (button_width() + touch_width() + 2.0F * px(cell_gap));

    const widgets::Group group("calls");
    ImGui::SetCursorScreenPos(rect.min);
    const bool is_nothing = limit.call == 0 && limit.triangles == 0;
    if (arrow("←", !is_nothing, marked("Previous call"), marked("Goes back one draw call.")))
        limit = previous_call(limit, calls);
    ImGui::SameLine(0.0F, px(cell_gap));
    choose_call(limit, calls, plan, scene, std::max(rect.width() - buttons, px(40.0F)));
    ImGui::SameLine(0.0F, px(cell_gap));
    if (arrow("→", limit.call >= 0, marked("Next call"), marked("Advances one draw call.")))
        limit = next_call(limit, calls);
    ImGui::SameLine(0.0F, px(cell_gap));
    touch_buttons(limit, data);
}

void play_button(int& step, int count, widgets::StepPlayer& player) {
    if (ImGui::Button(player.playing ? "■##play" : "▶##play", {button_width(), 0.0F})) {
        player = {.playing = !player.playing, .steps_per_s = player.steps_per_s};
        if (player.playing && (step < 0 || step >= count)) step = 0;
    }
    widgets::Record("play");
    widgets::Tooltip(player.playing ? marked("Stop") : marked("Play"),
                     player.playing ? marked("Stops at this triangle.")
                                    : marked("Plays triangle by triangle; at the end, starts over."));
}

/// Draws a short step bar for narrow views: a back button, the step number, a next button, and a play button.
void short_bar(int& step, int count, widgets::StepPlayer& player, const Rect& rect) {
    player.shown = true;
    widgets::PlaySteps(step, count, player, ImGui::GetIO().DeltaTime);
    if (player.playing) widgets::AskForRedraw(0.0F);
    const int before = step;
    int reached = step < 0 ? count : step;
    ImGui::PushButtonRepeat(true);
    if (arrow("←", reached > 0, marked("Back"), marked("Goes back one triangle; hold to repeat."))) step = reached - 1;
    ImGui::SameLine(0.0F, px(cell_gap));
    double value = reached;
    const std::string of = " / " + std::to_string(count);
    const float room = rect.width() - 3.0F * (button_width() + px(cell_gap));
    if (widgets::Number("##triangle", value,
                        {.min = 0.0,
                         .max = static_cast<double>(count),
                         .step = std::clamp(count / 400.0, 0.02, 100.0),
                         .decimals = 0,
                         .unit = of.c_str(),
                         .integer = true,
                         .default_value = static_cast<double>(count)},
                        std::max(room, px(40.0F))))
        step = static_cast<int>(std::lround(value));
    widgets::Tooltip("Triangle", "Sets how many triangles are drawn. Double-click to type, drag to change.");
    ImGui::SameLine(0.0F, px(cell_gap));
    if (arrow("→", reached < count, marked("Next"), marked("Advances one triangle; hold to repeat.")))
        step = reached + 1;
    ImGui::PopButtonRepeat();
    if (step != before) player.playing = false;
    ImGui::SameLine(0.0F, px(cell_gap));
    play_button(step, count, player);
}

}  // namespace

void choose_cells(std::optional<glm::ivec2>& cells, float width) {
    static constexpr glm::ivec2 offered[] = {{4, 4}, {8, 6}, {12, 8}, {16, 12}, {24, 16}};
    const auto name_of_size = [](const std::optional<glm::ivec2>& size) {
        return size ? std::to_string(size->x) + " × " + std::to_string(size->y) : std::string(tr("auto"));
    };
    if (!widgets::BeginChoice("##cells", name_of_size(cells).c_str(), width)) {
        widgets::Tooltip("Cells", "Columns and rows of the block: as many as are legible, or a fixed size.");
        return;
    }
    const auto offer_size = [&](const std::optional<glm::ivec2>& size) {
        const std::string name = name_of_size(size);
        if (ImGui::Selectable(name.c_str(), size == cells)) cells = size;
        widgets::Record(size ? name.c_str() : "auto");
    };
    offer_size(std::nullopt);
    for (const glm::ivec2& size : offered) offer_size(size);
    widgets::EndChoice();
}

void draw_cell_bar(Session& session, const DepthData& data, const FramePlan& plan, const CellLayout& layout,
                   widgets::StepPlayer& player) {
    const std::vector<DrawCall>& calls = data.calls;
    ViewParams& view = session.params.view;
    DrawLimit limit{view.call, view.triangle};
    const int count = step_count(calls);
    int step = step_of(limit, calls);
    const int before = step;

    ImGui::SetCursorScreenPos(layout.steps.min);
    if (layout.has_step_bar) {
        widgets::StepBar("steps", step, count, player, ImGui::GetIO().DeltaTime);
    } else {
        const widgets::Group group("steps");
        short_bar(step, count, player, layout.steps);
    }
    if (step != before) limit = limit_of(step, calls);

    if (layout.has_calls) {
        const DrawLimit by_step = limit;
        call_row(limit, data, plan, session.scene(), layout.calls);
        if (limit != by_step) player.playing = false;
    }
    view.call = limit.call;
    view.triangle = limit.triangles;
}

}  // namespace viewing
