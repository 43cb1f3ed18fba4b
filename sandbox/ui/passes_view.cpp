#include "ui/passes_view.h"

#include <algorithm>
#include <cmath>

#include "ui/look.h"
#include "ui/view_parts.h"
#include "widgets/diagrams.h"

namespace viewing {
namespace {

/// Between the pictures: a part of the height, since pictures are sized before there is a frame to ask for its scale.
float gap_in(const Rect& rect) {
    return std::round(0.02F * rect.height());
}

constexpr const char* buffer_names[] = {"colour", "depth", "stencil"};

/// Passes as steps from 1 on; a frame that stops nowhere is at its last one.
void steps(Session& session, int count, StepPlayer& player) {
    int& pass = session.params.view.pass;
    int step = pass < 0 ? -1 : std::min(pass + 1, count);
    const int before = step;
    widgets::StepBar("passes", step, count, player.playing, player.steps_per_s, ImGui::GetIO().DeltaTime,
                     player.carry_steps);
    if (step == before) return;
    pass = step >= count || step < 0 ? -1 : std::max(step - 1, 0);
}

/// One pass: its headline stops the frame after it, or lets it go on.
void entry(Session& session, const Pass& pass, int number, int count) {
    const widgets::Context& context = widgets::CurrentContext();
    int& stop = session.params.view.pass;
    const bool is_stop = stop == number;
    const bool is_drawn = stop < 0 || number <= stop;
    ImGui::PushID(number);
    if (!is_drawn) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.45F);
    ImGui::PushFont(context.fonts.heading);
    const std::string title = std::to_string(number + 1) + "  " + pass.name;
    if (ImGui::Selectable(title.c_str(), is_stop)) stop = is_stop || number + 1 == count ? -1 : number;
    widgets::Record(title.c_str());
    ImGui::PopFont();
    widgets::Tooltip(pass.name.c_str(),
                     is_stop ? "Click to draw the whole frame again." : "Click to stop the frame after this pass.");
    widgets::Note(pass.reason.c_str());
    ImGui::PushFont(context.fonts.small_number);
    ImGui::Indent(px(12.0F));
    for (const std::string& call : gl_calls(pass)) ImGui::TextWrapped("%s", call.c_str());
    ImGui::Unindent(px(12.0F));
    ImGui::PopFont();
    if (!is_drawn) ImGui::PopStyleVar();
    ImGui::Dummy({0.0F, px(4.0F)});
    ImGui::PopID();
}

void list(Session& session, const FramePlan& plan, const Rect& rect) {
    ImGui::SetCursorScreenPos(rect.min);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().raised);
    ImGui::BeginChild("passes", {rect.width(), rect.height()}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    const int count = static_cast<int>(plan.passes.size());
    for (int number = 0; number < count; ++number) {
        if (number == session.params.view.pass && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY(0.1F);
        entry(session, plan.passes[static_cast<std::size_t>(number)], number, count);
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

}  // namespace

glm::ivec2 pass_picture_size(const Rect& rect, double aspect) {
    // One below the other, and never more than half of the width.
    const double height = std::min((rect.height() - 2.0 * gap_in(rect)) / 3.0, 0.5 * rect.width() / aspect);
    return glm::max(glm::ivec2(static_cast<int>(height * aspect), static_cast<int>(height)), 1);
}

void draw_passes_view(Session& session, const FramePlan& plan, const Rect& rect, const PassPictures& pictures,
                      double aspect, StepPlayer& player) {
    player.drawn = true;
    const glm::ivec2 size = pass_picture_size(rect, aspect);
    const ImVec2 size_px(static_cast<float>(size.x), static_cast<float>(size.y));
    const float left = rect.max.x - size_px.x;
    for (std::size_t buffer = 0; buffer < pictures.size(); ++buffer) {
        const float top = rect.min.y + static_cast<float>(buffer) * (size_px.y + gap_in(rect));
        const Rect place{{left, top}, {rect.max.x, top + size_px.y}};
        draw_picture(place, pictures[buffer]);
        widgets::HaloText(ImGui::GetWindowDrawList(), {left + px(6.0F), top + px(3.0F)}, palette().text,
                          buffer_names[buffer]);
    }
    const float right = left - gap_in(rect);
    ImGui::SetCursorScreenPos(rect.min);
    ImGui::BeginChild("steps", {right - rect.min.x, ImGui::GetFrameHeight()}, false,
                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    steps(session, static_cast<int>(plan.passes.size()), player);
    ImGui::EndChild();
    list(session, plan, {{rect.min.x, rect.min.y + ImGui::GetFrameHeight() + gap_in(rect)}, {right, rect.max.y}});
}

}  // namespace viewing
