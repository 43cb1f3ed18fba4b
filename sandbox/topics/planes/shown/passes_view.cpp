#include "topics/planes/shown/passes_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lesson/target_names.h"
#include "text/catalogue.h"
#include "text/words.h"
#include "ui/parts/look.h"
#include "ui/parts/view_parts.h"

namespace viewing {
namespace {

constexpr const char* buffer_names[] = {marked("color"), marked("depth"), marked("stencil")};
constexpr const char* whole_frame =
    marked("This hidden-surface method always draws the whole frame: it cannot stop after a pass.");

/// Returns the gap between pictures, relative to the view's size: pictures are sized before any frame sets a scale.
float gap_in(const Rect& rect) {
    return std::round(0.02F * std::min(rect.width(), rect.height()));
}

/// Whether the pictures form a column beside the list; otherwise they form a row below it.
bool is_wide(const Rect& rect) {
    return rect.width() >= 1.4F * rect.height();
}

/// The rectangles of the list, which includes the step bar, and of the three buffers' pictures.
struct Places {
    Rect list;
    std::array<Rect, 3> pictures;
};

Places places_in(const Rect& rect, double aspect) {
    const glm::ivec2 picture_px = pass_picture_size(rect, aspect);
    const ImVec2 size(static_cast<float>(picture_px.x), static_cast<float>(picture_px.y));
    const float gap = gap_in(rect);
    const bool wide = is_wide(rect);
    const ImVec2 first = wide ? ImVec2(rect.max.x - size.x, rect.min.y) : ImVec2(rect.min.x, rect.max.y - size.y);
    // Spread over the view's whole height or width.
    const ImVec2 step =
        wide ? ImVec2(0.0F, 0.5F * (rect.height() - size.y)) : ImVec2(0.5F * (rect.width() - size.x), 0.0F);
    Places places;
    places.list = {rect.min, wide ? ImVec2(first.x - gap, rect.max.y) : ImVec2(rect.max.x, first.y - gap)};
    for (std::size_t buffer = 0; buffer < places.pictures.size(); ++buffer) {
        const auto number = static_cast<float>(buffer);
        const ImVec2 min(std::round(first.x + number * step.x), std::round(first.y + number * step.y));
        places.pictures[buffer] = {min, {min.x + size.x, min.y + size.y}};
    }
    return places;
}

/// Draws the step bar. Its steps are the passes, counted from 1; a frame that does not stop early is at the last step.
/// Returns true when the step changed. In a narrow view, the bar has less height, which also makes its buttons
/// narrower. If even this low bar does not fit, no bar is drawn; clicks on passes still work.
bool steps(Session& session, int count, widgets::StepPlayer& player) {
    constexpr float whole_bar = 256.0F, low_bar = 215.0F;
    const float room = ImGui::GetContentRegionAvail().x;
    if (room < px(low_bar)) return false;
    int& pass = session.params.view.pass;
    int step = pass < 0 ? -1 : pass + 1;
    const int before = step;
    const bool is_narrow = room < px(whole_bar);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {ImGui::GetStyle().FramePadding.x, is_narrow ? 0.0F : ImGui::GetStyle().FramePadding.y});
    widgets::StepBar("passes", step, count, player, ImGui::GetIO().DeltaTime);
    ImGui::PopStyleVar();
    if (count < 2) player.playing = false;  // a single pass has no next step to play
    if (step == before) return false;
    const int reached = std::max(step, 1);
    pass = step < 0 || reached >= count ? -1 : reached - 1;
    return true;
}

/// Whether the frame can stop after a pass, which is possible only if GL alone draws it.
bool can_stop(const Session& session) {
    return is_drawn_by_gl_alone(session.params.visibility.method);
}

/// Returns four rows of numbers, laid out like a matrix.
std::string rows_text(const glm::dmat4& matrix) {
    std::string text;
    for (int row = 0; row < 4; ++row) {
        text += row > 0 ? "\n" : "";
        for (int column = 0; column < 4; ++column) {
            const std::string entry = number_text(matrix[column][row], 3);
            text.append(std::size_t{10} - std::min(character_count(entry), std::size_t{10}), ' ').append(entry);
        }
    }
    return text;
}

/// The named calls whose first line has been drawn in this frame.
using MarkedCalls = std::array<bool, std::size(named_calls)>;

/// Marks the last item as a named call if it is that call's first line.
void mark_call(const std::string& call, MarkedCalls& done) {
    for (std::size_t i = 0; i < done.size(); ++i)
        if (call.starts_with(named_calls[i]) && !std::exchange(done[i], true))
            widgets::MarkLine(std::string("call:") + named_calls[i]);
}

/// Draws a list of calls. `uploaded`: the matrix product that these calls upload, which a tooltip shows.
void call_lines(const std::vector<Message>& calls, MarkedCalls& done, const glm::dmat4* uploaded = nullptr) {
    ImGui::PushFont(widgets::CurrentContext().fonts.small_number);
    ImGui::Indent(px(12.0F));
    for (const Message& one : calls) {
        const std::string call = say(one);
        ImGui::TextWrapped("%s", call.c_str());
        mark_call(call, done);
        if (!uploaded || !call.starts_with("glUniformMatrix4fv")) continue;
        widgets::Record(call.c_str());
        if (widgets::IsPartCovered("matrix")) continue;
        widgets::Tooltip("The uploaded product", "", "", rows_text(*uploaded).c_str());
    }
    ImGui::Unindent(px(12.0F));
    ImGui::PopFont();
}

/// Draws one pass. A click on its heading stops the frame after this pass or, if this is the last pass or the frame
/// already stops here, removes the stop.
void entry(Session& session, const FramePlan& plan, int number, MarkedCalls& done) {
    const widgets::Context& context = widgets::CurrentContext();
    const Pass& pass = plan.passes[number];
    int& stop = session.params.view.pass;
    const bool is_last = number + 1 == std::ssize(plan.passes);
    const bool goes_on = is_last || stop == number;
    const bool is_drawn = plan.limit.pass < 0 || number <= plan.limit.pass;
    ImGui::PushID(number);
    if (!is_drawn) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 0.45F);
    ImGui::PushFont(context.fonts.heading);
    const std::string pass_number = std::to_string(number + 1);
    const std::string title = pass_number + "  " + say(pass.name) + "###headline";
    const bool stops = can_stop(session);
    const ImGuiSelectableFlags flags = stops ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    if (ImGui::Selectable(title.c_str(), stops && stop == number, flags)) stop = goes_on ? -1 : number;
    widgets::Record(("pass " + pass_number).c_str());
    ImGui::PopFont();
    widgets::Tooltip(say(pass.name).c_str(), !stops    ? whole_frame
                                             : goes_on ? marked("Click to draw the whole frame.")
                                                       : marked("Click to stop the frame after this pass."));
    widgets::Note(say(pass.reason).c_str());
    const Pass before = number == 0 ? first_gl_state() : plan.passes[number - 1];
    const glm::dmat4 uploaded = pass.clip_from_world * pass.world_from_scene;
    call_lines(gl_calls(plan, pass, before), done, &uploaded);
    if (!is_drawn) ImGui::PopStyleVar();
    ImGui::Dummy({0.0F, px(4.0F)});
    ImGui::PopID();
}

/// Draws the list of passes, which fills the rest of the window. `follows`: whether to scroll to the pass where the
/// frame stops.
void list(Session& session, const FramePlan& plan, bool follows) {
    if (widgets::IsCovered("code:passes")) {
        widgets::Plate("list", ImGui::GetContentRegionAvail());
        return widgets::MarkTarget("code:passes");
    }
    ImGui::PushStyleColor(ImGuiCol_ChildBg, palette().raised);
    ImGui::BeginChild("list", {}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    MarkedCalls done{};
    call_lines(clear_calls(plan), done);
    for (int number = 0; number < std::ssize(plan.passes); ++number) {
        const bool is_stop = number == session.params.view.pass;
        if (is_stop && (follows || ImGui::IsWindowAppearing())) ImGui::SetScrollHereY(0.1F);
        entry(session, plan, number, done);
    }
    widgets::CountScrolled();
    ImGui::EndChild();
    widgets::MarkTarget("code:passes");
    ImGui::PopStyleColor();
}

}  // namespace

glm::ivec2 pass_picture_size(const Rect& rect, double aspect) {
    // Three pictures in a row or column, which takes at most half of the view's width or height.
    const double gap = gap_in(rect);
    const double height = is_wide(rect) ? std::min((rect.height() - 2.0 * gap) / 3.0, 0.5 * rect.width() / aspect)
                                        : std::min((rect.width() - 2.0 * gap) / 3.0 / aspect, 0.5 * rect.height());
    return glm::max(glm::ivec2(static_cast<int>(height * aspect), static_cast<int>(height)), 1);
}

void draw_passes_view(Session& session, const FramePlan& plan, const Rect& rect, const PassPictures& pictures,
                      double aspect, widgets::StepPlayer& player) {
    const Places places = places_in(rect, aspect);
    for (std::size_t buffer = 0; buffer < pictures.size(); ++buffer) {
        const Rect& place = places.pictures[buffer];
        picture_item(buffer_names[buffer], place, pictures[buffer]);
        widgets::PlateText(ImGui::GetWindowDrawList(), {place.min.x + px(6.0F), place.min.y + px(3.0F)}, palette().text,
                           tr(buffer_names[buffer]));
    }
    ImGui::SetCursorScreenPos(rect.min);
    const ImVec2 room(std::max(places.list.width(), 1.0F), std::max(places.list.height(), 1.0F));
    ImGui::BeginChild("passes", room, false, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    bool is_stepped = false;
    if (can_stop(session))
        is_stepped = steps(session, static_cast<int>(plan.passes.size()), player);
    else
        widgets::Note(whole_frame);
    list(session, plan, is_stepped);
    ImGui::EndChild();
}

}  // namespace viewing
