#include "ui/lesson/presenter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "text/catalogue.h"
#include "ui/lesson/cards.h"
#include "ui/parts/look.h"

namespace viewing {
namespace {

/// The page that ink is drawn on: the lesson's step, or one extra page for all states without a lesson.
std::size_t page_of(const Guide& guide) {
    return guide.is_shown() ? guide.run()->index() : std::numeric_limits<std::size_t>::max();
}

bool is_modifier(Key key) {
    return key == Key::shift || key == Key::ctrl || key == Key::alt || key == Key::super;
}

/// Puts an empty window over a part of the window, which then gets neither clicks nor the wheel.
void keep_mouse_from(const Rect& part) {
    ImGui::SetNextWindowPos(part.min);
    ImGui::SetNextWindowSize({part.width(), part.height()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::Begin("over the views", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton(
        "mouse", {part.width(), part.height()},
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace

void PresenterMode::begin() {
    if (is_on_) return;
    is_on_ = true;
    wants_full_screen_ = true;
    presented_s_ = 0.0;
}

void PresenterMode::end() {
    is_on_ = has_lesson_ = is_frozen_ = shows_overview_ = shows_code_ = inks_ = clock_runs_ = false;
    blank_ = Blank::none;
    pointer_ = Pointer::none;
    votes_.close();
    shown_step_.reset();
    wants_full_screen_ = false;
}

void PresenterMode::show_overview(const Guide& guide) {
    shows_overview_ = true;
    typed_.clear();
    choice_ = guide.run() ? static_cast<int>(guide.run()->index()) : 0;
}

std::string PresenterMode::clock() const {
    if (clock_s_ == 0.0 && !clock_runs_) return "";
    const auto seconds = static_cast<int>(clock_s_);
    return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

bool PresenterMode::take_in_overview(const KeyPress& press, Guide& guide, Session& session) {
    const int last = static_cast<int>(guide.run()->lesson().steps.size()) - 1;
    const int row = card_columns();
    const auto move = [&](int by) { choice_ = std::clamp(choice_ + by, 0, last); };
    switch (press.key) {
        case Key::left:
        case Key::page_up:
            move(-1);
            break;
        case Key::right:
        case Key::page_down:
            move(1);
            break;
        case Key::up:
            move(-row);
            break;
        case Key::down:
            move(row);
            break;
        case Key::o:
        case Key::escape:
            shows_overview_ = false;
            break;
        case Key::enter:
        case Key::space:
            shows_overview_ = false;
            guide.go_to(static_cast<std::size_t>(choice_), session);
            break;
        default:
            if (const int digit = digit_of(press.key); digit >= 0 && typed_.size() < 3) {
                typed_ += static_cast<char>('0' + digit);
                choice_ = std::clamp(std::atoi(typed_.c_str()) - 1, 0, last);
            }
    }
    return true;
}

void PresenterMode::toggle_ink(const Guide& guide) {
    inks_ = !inks_;
    if (!inks_) ink_.erase(page_of(guide));
}

void PresenterMode::next_pointer() {
    pointer_ = static_cast<Pointer>((static_cast<int>(pointer_) + 1) % 3);
}

void PresenterMode::leave_by_escape(const Guide& guide) {
    if (!inks_ && !shows_code_ && !guide.is_shown())
        end();
    else if (!std::exchange(shows_code_, false))
        inks_ = false;
}

bool PresenterMode::take(const KeyPress& press, Guide& guide, Session& session) {
    if (is_modifier(press.key)) return false;
    if (shows_overview_ && guide.is_shown()) return take_in_overview(press, guide, session);
    if (!is_on_) return false;
    if (blank_ != Blank::none) {  // any key only restores the picture
        blank_ = Blank::none;
        return true;
    }
    if (guide.is_shown() && votes_.take(press, *guide.run())) return true;
    const bool undoes_ink = inks_ && press.ctrl && press.key == Key::z;
    if (!undoes_ink) return false;
    if (std::vector<Stroke>& strokes = ink_[page_of(guide)]; !strokes.empty()) strokes.pop_back();
    return true;
}

void PresenterMode::update(const FrameInput& input, Guide& guide, Session& session) {
    const bool holds = input.is_down(Key::x) && !takes_letters();
    if (guide.is_shown()) guide.hold_before(holds, session);
    const bool holds_freely = is_on_ && holds && !guide.is_shown();
    if (holds_freely && !held_)
        held_ = std::exchange(session.params, session.in_own_looks(session.before_latest_edit()));
    else if (!holds_freely && held_)
        session.params = session.in_own_looks(*std::exchange(held_, std::nullopt));
    if (!is_on_) return;
    const std::pair now(page_of(guide), guide.is_shown() && guide.run()->is_revealed());
    const auto before = std::exchange(shown_step_, now);
    if (before && *before != now) {  // the votes and the QR code would hide the answer
        votes_.close();
        shows_code_ = false;
    }
    presented_s_ += input.dt_s;
    if (clock_runs_) clock_s_ += input.dt_s;
    if (std::exchange(has_lesson_, guide.is_shown()) && !guide.is_shown()) end();
}

void PresenterMode::draw_ink(std::size_t step) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 size = io.DisplaySize;
    std::vector<Stroke>& strokes = ink_[step];
    if (inks_ && ImGui::IsMousePosValid()) {
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) strokes.emplace_back();
        const ImVec2 here(io.MousePos.x / size.x, io.MousePos.y / size.y);
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left) && !strokes.empty() &&
            (strokes.back().empty() || strokes.back().back().x != here.x || strokes.back().back().y != here.y))
            strokes.back().push_back(here);
    }
    ImDrawList* draw = ImGui::GetForegroundDrawList();
    const float width = std::max(px(3.0F), size.y / 240.0F);
    for (const Stroke& stroke : strokes) {
        std::vector<ImVec2> points;
        for (const ImVec2& point : stroke) points.push_back({point.x * size.x, point.y * size.y});
        if (points.size() == 1) draw->AddCircleFilled(points.front(), width, palette().point);
        draw->AddPolyline(points.data(), static_cast<int>(points.size()), palette().point, 0, width);
    }
    if (inks_ && ImGui::IsMousePosValid()) draw->AddCircleFilled(io.MousePos, width, with_alpha(palette().point, 160));
}

void PresenterMode::draw_pointer(const Rect& room) {
    if (pointer_ == Pointer::none || !ImGui::IsMousePosValid()) return;
    const ImVec2 at = ImGui::GetIO().MousePos, size = ImGui::GetIO().DisplaySize;
    ImDrawList* draw = ImGui::GetForegroundDrawList();
    if (pointer_ == Pointer::spot) {
        draw->AddCircleFilled(at, size.y / 60.0F, with_alpha(palette().trouble, 150), 48);
        draw->AddCircle(at, size.y / 60.0F, palette().text, 48, px(1.5F));
        return;
    }
    // A ring thick enough to darken everything outside the spotlight, except the question.
    const float radius = size.y / 7.0F, reach = std::hypot(size.x, size.y);
    draw->PushClipRect(room.min, room.max);
    draw->AddCircle(at, radius + reach * 0.5F, IM_COL32(0, 0, 0, 170), 96, reach);
    draw->PopClipRect();
}

void PresenterMode::draw(const Guide& guide, const Rect& room) {
    if (!is_on_) return;
    if (guide.is_shown()) votes_.draw(*guide.run(), room);
    if (takes_mouse()) keep_mouse_from(is_blank() ? Rect{{0.0F, 0.0F}, ImGui::GetIO().DisplaySize} : room);
    draw_ink(page_of(guide));
    draw_pointer(room);
    ImDrawList* draw = ImGui::GetForegroundDrawList();
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (is_frozen_) draw->AddRect({0.0F, 0.0F}, size, palette().accent, 0.0F, 0, px(4.0F));
    if (blank_ != Blank::none)
        draw->AddRectFilled({0.0F, 0.0F}, size, blank_ == Blank::black ? IM_COL32_BLACK : IM_COL32_WHITE);
}

}  // namespace viewing
