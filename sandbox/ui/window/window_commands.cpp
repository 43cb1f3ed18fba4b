#include "ui/window/window_commands.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "state/fields.h"
#include "state/file/beside.h"
#include "text/catalogue.h"
#include "ui/panel/beside_panel.h"
#include "ui/window/clipboard.h"
#include "ui/window/window_layout.h"
#include "ui/window/workbench.h"

namespace viewing {
namespace {

constexpr unsigned bit_of(Place place) {
    return 1U << static_cast<unsigned>(place);
}
constexpr unsigned in_free = bit_of(Place::window), in_lesson = bit_of(Place::lesson),
                   on_free_stage = bit_of(Place::stage), on_lesson_stage = bit_of(Place::lesson_on_stage);
constexpr unsigned in_any_window = in_free | in_lesson, on_any_stage = on_free_stage | on_lesson_stage,
                   without_lesson = in_free | on_free_stage, with_lesson = in_lesson | on_lesson_stage,
                   anywhere = in_any_window | on_any_stage;

constexpr KeyPress with_ctrl(Key key, bool shift = false) {
    return {key, true, shift};
}
constexpr KeyPress with_shift(Key key) {
    return {key, false, true};
}
constexpr std::nullopt_t no_key = std::nullopt;

using Context = const CommandContext&;

void compare_with(OtherState which, Context context) {
    Session& session = context.session;
    if (const std::optional<Params> other = other_state(which, session, context.problems))
        show_beside(session.params, *other);
    else
        session.report(Error{why_no_other(which)});
}

void toggle_fold(Session& session, std::string_view column) {
    fold(session.params, column, !is_folded(session.params, column));
}

void choose_scale(Context context, double scale) {
    double& chosen = context.session.params.ui.scale;
    chosen = std::clamp(std::round(scale * 10.0) / 10.0, 0.5, 3.0);
    context.requests.chosen_scale = chosen;
}

template <int by>
void change_scale(Workbench&, Context context) {
    choose_scale(context, context.session.params.ui.scale + 0.1 * by);
}

template <typename Enum>
void advance(Enum& value) {
    value = static_cast<Enum>((static_cast<std::size_t>(value) + 1) % names_of<Enum>().size());
}

template <int axis>
void look_along(Workbench&, Context context) {
    context.session.look_along(axis);
}

/// Maximizes the view under the pointer, otherwise the camera's, or shows all views again.
void toggle_big(Workbench& window, Context context) {
    ViewName& big = context.session.params.view.layout.big;
    const ViewName hovered = window.views.hovered;
    big = big != ViewName::none ? ViewName::none : hovered == ViewName::none ? ViewName::camera : hovered;
}

/// Takes back the first of these that there is: the lesson's end, a replay, a maximized view, a followed point.
void take_back(Workbench& window, Context context) {
    Session& session = context.session;
    if (window.guide.is_shown() && window.guide.run()->shows_end())
        window.guide.previous(session);
    else if (window.replay.is_playing())
        window.replay.stop();
    else if (session.params.view.layout.big != ViewName::none)
        session.params.view.layout.big = ViewName::none;
    else
        session.params.follow.reset();
}

}  // namespace

std::span<const WindowCommand> window_commands() {
    using W = Workbench;
    using C = Context;
    constexpr auto redo = [](W&, C c) { c.session.redo(); };
    constexpr auto return_to_step = [](W& w, C c) { w.guide.return_to_step(c.session); };
    constexpr auto next_step = [](W& w, C c) { w.guide.next(c.session); };
    constexpr auto previous_step = [](W& w, C c) { w.guide.previous(c.session); };
    constexpr auto end_stage = [](W& w, C) { w.presenter.end(); };
    constexpr auto black = [](W& w, C) { w.presenter.show_blank(PresenterMode::Blank::black); };
    static constexpr WindowCommand all[] = {
        {marked("Undo"), with_ctrl(Key::z), anywhere, [](W&, C c) { c.session.undo(); }, Open::list,
         marked("undo, redo")},
        {marked("Redo"), with_ctrl(Key::z, true), anywhere, redo, Open::list, ""},
        {"", with_ctrl(Key::y), anywhere, redo, Open::list},
        {marked("Go on stage"), KeyPress{Key::f5}, in_any_window, [](W& w, C) { w.presenter.begin(); }, Open::text,
         marked("go on stage; F5 or Esc returns")},
        {"", KeyPress{Key::f5}, on_free_stage, end_stage, Open::text},
        {marked("Lessons"), no_key, in_any_window, [](W& w, C) { w.start_page.open(); }},
        {marked("Leave the lesson"), no_key, in_lesson, [](W& w, C c) { w.leave_lesson(c.session); }},
        {marked("Exercises"), no_key, in_any_window, [](W& w, C) { w.exercises.open_page(); }},
        {marked("Open…"), with_ctrl(Key::o), anywhere, [](W& w, C) { w.file_dialog_.show(FileDialog::Purpose::open); },
         Open::list, marked("open, save"), FilePart::files},
        {marked("Save…"), with_ctrl(Key::s), anywhere, [](W& w, C) { w.file_dialog_.show(FileDialog::Purpose::save); },
         Open::list, "", FilePart::files},
        {marked("Save as step…"), no_key, in_any_window, [](W& w, C) { w.save_as_step(); }, Open::nothing, nullptr,
         FilePart::files},
        {marked("Edit this step"), no_key, in_lesson, [](W& w, C c) { w.open_step_editor(c.session); }},
        {marked("Copy state"), with_ctrl(Key::c), anywhere, [](W&, C c) { copy(c.session); }, Open::list,
         marked("copy, paste the whole state"), FilePart::copies},
        {marked("Paste state"), with_ctrl(Key::v), anywhere,
         [](W& w, C c) { paste(w.guide, w.matrix_dialog_, c.session); }, Open::list, "", FilePart::pastes},
        {marked("Copy link"), no_key, in_any_window, [](W& w, C c) { copy_link(w.guide, c.session, w.link_address); },
         Open::nothing, nullptr, FilePart::copies},
        {marked("Snapshot"), KeyPress{Key::f12}, anywhere, [](W&, C c) { c.requests.snapshot = true; }, Open::dialog,
         marked("snapshot of the camera view"), FilePart::others},
        {marked("Record a flight"), KeyPress{Key::f9}, anywhere, [](W& w, C c) { w.recorder.toggle(c.session); },
         Open::dialog, marked("start or stop recording a flight; Esc stops playback"), FilePart::others,
         marked("Stop recording")},
        {marked("Reset all"), no_key, in_free, [](W&, C c) { c.session.reset(); }, Open::nothing, nullptr,
         FilePart::others},
        {marked("Compare with the state before the last edit"), no_key, without_lesson,
         [](W&, C c) { compare_with(OtherState::before_edit, c); }},
        {marked("Compare with the preset"), no_key, without_lesson,
         [](W&, C c) { compare_with(OtherState::preset, c); }},
        {marked("Compare with the fixed state"), no_key, without_lesson,
         [](W&, C c) { compare_with(OtherState::fixed, c); }},
        {marked("Only one picture"), no_key, without_lesson,
         [](W&, C c) { c.session.params.view.beside.shows = Beside::nothing; }},
        {marked("Full screen"), KeyPress{Key::f11}, anywhere, [](W&, C c) { c.requests.toggle_full_screen = true; },
         Open::dialog, marked("full screen")},
        {marked("Keys"), KeyPress{Key::f1}, in_any_window, [](W& w, C) { w.help_.toggle(); }, Open::dialog,
         marked("this list")},
        {marked("Fold the controls"), KeyPress{Key::f2}, anywhere, [](W&, C c) { toggle_fold(c.session, "panel"); },
         Open::dialog, marked("fold the controls, the matrices")},
        {marked("Fold the matrices"), KeyPress{Key::f3}, anywhere, [](W&, C c) { toggle_fold(c.session, "matrices"); },
         Open::dialog, ""},
        {"", with_ctrl(Key::p), anywhere, [](W& w, C) { w.search_.open(); }, Open::list,
         marked("search everything, including a setting with its value: near 0.01")},
        {marked("Maximize the view"), KeyPress{Key::m}, anywhere, toggle_big, Open::nothing,
         marked("maximize the view under the pointer")},
        {marked("Handles and labels"), KeyPress{Key::h}, anywhere, [](W& w, C) { w.views.handles = !w.views.handles; },
         Open::nothing, marked("toggle handles and labels")},
        {marked("The preset's description"), KeyPress{Key::c}, anywhere,
         [](W& w, C c) { w.caption_fold_ = !w.layout(ImGui::GetIO().DisplaySize, c.session).caption_is_folded; },
         Open::nothing, marked("fold or unfold the preset's description")},
        {"", KeyPress{Key::escape}, in_any_window, take_back},

        {marked("Starting view"), KeyPress{Key::home}, without_lesson, [](W&, C c) { c.session.go_home(); },
         Open::nothing, marked("starting view · whole scene")},
        {marked("The whole scene"), KeyPress{Key::g}, anywhere, [](W&, C c) { c.session.frame_all(c.aspect); },
         Open::nothing, ""},
        {marked("Level: no roll"), KeyPress{Key::l}, in_any_window, [](W&, C c) { c.session.level(); }, Open::nothing,
         marked("level: no roll")},
        {marked("Look along x"), KeyPress{Key::x}, in_free, look_along<0>, Open::nothing,
         marked("look along an axis; press again: other side")},
        {marked("Look along y"), KeyPress{Key::y}, anywhere, look_along<1>, Open::nothing, ""},
        {marked("Look along z"), KeyPress{Key::z}, anywhere, look_along<2>, Open::nothing, ""},
        {marked("Next navigation mode"), KeyPress{Key::n}, anywhere,
         [](W&, C c) { advance(c.session.params.camera.navigation); }, Open::nothing, marked("next navigation mode")},
        {marked("Previous preset"), KeyPress{Key::page_up}, without_lesson,
         [](W& w, C c) { w.presets_.turn(-1, c.session); }, Open::nothing, marked("previous preset, next preset")},
        {marked("Next preset"), KeyPress{Key::page_down}, without_lesson,
         [](W& w, C c) { w.presets_.turn(1, c.session); }, Open::nothing, ""},
        {marked("Larger"), with_ctrl(Key::plus), anywhere, change_scale<1>, Open::list,
         marked("larger, smaller, default size")},
        {marked("Smaller"), with_ctrl(Key::minus), anywhere, change_scale<-1>, Open::list, ""},
        {marked("Default size"), with_ctrl(Key::zero), anywhere, [](W&, C c) { choose_scale(c, 1.0); }, Open::list, ""},

        {marked("Restore the step's state"), KeyPress{Key::home}, with_lesson, return_to_step, Open::list},
        {"", KeyPress{Key::page_down}, with_lesson, next_step, Open::text},
        {"", KeyPress{Key::page_up}, with_lesson, previous_step, Open::text},
        {"", KeyPress{Key::space}, on_lesson_stage, next_step, Open::list},
        {"", with_shift(Key::space), on_lesson_stage, previous_step, Open::list},
        {"", KeyPress{Key::backspace}, on_lesson_stage, [](W& w, C c) { w.guide.go_back(c.session); }, Open::list},
        {marked("Overview of the steps"), KeyPress{Key::o}, on_lesson_stage,
         [](W& w, C) { w.presenter.show_overview(w.guide); }, Open::list},
        {marked("Black screen"), KeyPress{Key::b}, on_any_stage, black, Open::list},
        {"", KeyPress{Key::period}, on_any_stage, black, Open::list},
        {marked("White screen"), KeyPress{Key::comma}, on_any_stage,
         [](W& w, C) { w.presenter.show_blank(PresenterMode::Blank::white); }, Open::list},
        {marked("Freeze the picture"), KeyPress{Key::p}, on_any_stage, [](W& w, C) { w.presenter.toggle_freeze(); },
         Open::list},
        {marked("Pointer, then spotlight"), KeyPress{Key::l}, on_any_stage, [](W& w, C) { w.presenter.next_pointer(); },
         Open::list},
        {marked("Ink"), KeyPress{Key::i}, on_any_stage, [](W& w, C) { w.presenter.toggle_ink(w.guide); }, Open::list},
        {"", KeyPress{Key::q}, on_any_stage, [](W& w, C) { w.presenter.toggle_code(); }, Open::list},
        {marked("Timer"), KeyPress{Key::t}, on_any_stage, [](W& w, C) { w.presenter.toggle_clock(); }, Open::list},
        {"", with_shift(Key::t), on_any_stage, [](W& w, C) { w.presenter.reset_clock(); }, Open::list},
        {marked("Next theme"), KeyPress{Key::f6}, on_any_stage, [](W&, C c) { advance(c.session.params.ui.theme); },
         Open::text},
        {"", KeyPress{Key::escape}, on_any_stage, [](W& w, C) { w.presenter.leave_by_escape(w.guide); }, Open::list},
        {marked("Leave the stage"), with_shift(Key::escape), on_any_stage, end_stage, Open::list},
    };
    return all;
}

const WindowCommand* command_of(const KeyPress& press, Place place) {
    const WindowCommand* best = nullptr;
    for (const WindowCommand& command : window_commands()) {
        if (!command.key || !command.is_in(place)) continue;
        const auto& [key, ctrl, shift] = *command.key;
        if (key != press.key || ctrl != press.ctrl || (shift && !press.shift)) continue;
        if (!best || shift == press.shift) best = &command;
    }
    return best;
}

std::string key_text(const std::optional<KeyPress>& press) {
    if (!press) return "";
    return std::string(press->ctrl ? "Ctrl+" : "") + (press->shift ? "Shift+" : "") + key_names[press->key];
}

}  // namespace viewing
