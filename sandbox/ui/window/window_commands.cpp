// The commands of the window that the search offers, with their keys.
#include "text/catalogue.h"
#include "ui/window/search_entries.h"

namespace viewing {
namespace {

constexpr unsigned bit_of(Place place) {
    return 1U << static_cast<unsigned>(place);
}
constexpr unsigned in_free = bit_of(Place::window), in_lesson = bit_of(Place::lesson),
                   on_free_stage = bit_of(Place::stage), on_lesson_stage = bit_of(Place::lesson_on_stage);
constexpr unsigned in_any_window = in_free | in_lesson, on_any_stage = on_free_stage | on_lesson_stage,
                   anywhere = in_any_window | on_any_stage;

constexpr KeyPress with_ctrl(Key key, bool shift = false) {
    return {key, true, shift};
}

}  // namespace

std::span<const WindowCommand> window_commands() {
    static constexpr WindowCommand all[] = {
        {marked("Undo"), "Ctrl+Z", with_ctrl(Key::z), anywhere},
        {marked("Redo"), "Ctrl+Shift+Z", with_ctrl(Key::z, true), anywhere},
        {marked("Go on stage"), "F5", KeyPress{Key::f5}, in_any_window},
        {marked("Lessons"), "", MenuCommand::lessons, in_any_window},
        {marked("Leave the lesson"), "", MenuCommand::leave_lesson, in_lesson},
        {marked("Exercises"), "", MenuCommand::exercises, in_any_window},
        {marked("Open…"), "Ctrl+O", with_ctrl(Key::o), in_any_window},
        {marked("Save…"), "Ctrl+S", with_ctrl(Key::s), in_any_window},
        {marked("Save as step…"), "", MenuCommand::save_as_step, in_any_window},
        {marked("Edit this step"), "", MenuCommand::edit_step, in_lesson},
        {marked("Copy state"), "Ctrl+C", with_ctrl(Key::c), in_any_window},
        {marked("Copy link"), "", MenuCommand::copy_link, in_any_window},
        {marked("Paste state"), "Ctrl+V", with_ctrl(Key::v), in_any_window},
        {marked("Snapshot"), "F12", KeyPress{Key::f12}, anywhere},
        {marked("Record a flight"), "F9", KeyPress{Key::f9}, in_any_window},
        {marked("Reset all"), "", MenuCommand::reset_all, in_free},
        {marked("Compare with the state before the last edit"), "", MenuCommand::compare_before_edit,
         in_free | on_free_stage},
        {marked("Compare with the preset"), "", MenuCommand::compare_preset, in_free | on_free_stage},
        {marked("Compare with the fixed state"), "", MenuCommand::compare_fixed, in_free | on_free_stage},
        {marked("Only one picture"), "", MenuCommand::one_picture, in_free | on_free_stage},
        {marked("Full screen"), "F11", KeyPress{Key::f11}, anywhere},
        {marked("Keys"), "F1", KeyPress{Key::f1}, in_any_window},
        {marked("Fold the controls"), "F2", KeyPress{Key::f2}, in_any_window},
        {marked("Fold the matrices"), "F3", KeyPress{Key::f3}, in_any_window},
        {marked("Maximize the view"), "M", KeyPress{Key::m}, in_any_window},
        {marked("Handles and labels"), "H", KeyPress{Key::h}, in_any_window},
        {marked("The preset's description"), "C", KeyPress{Key::c}, in_any_window},
        {marked("Starting view"), "Home", KeyPress{Key::home}, in_free},
        {marked("The whole scene"), "G", KeyPress{Key::g}, in_any_window},
        {marked("Level: no roll"), "L", KeyPress{Key::l}, in_any_window},
        {marked("Look along x"), "X", KeyPress{Key::x}, in_free},
        {marked("Look along y"), "Y", KeyPress{Key::y}, in_any_window},
        {marked("Look along z"), "Z", KeyPress{Key::z}, in_any_window},
        {marked("Next navigation mode"), "N", KeyPress{Key::n}, in_any_window},
        {marked("Next preset"), "Page down", KeyPress{Key::page_down}, in_free | on_free_stage},
        {marked("Previous preset"), "Page up", KeyPress{Key::page_up}, in_free | on_free_stage},
        {marked("Larger"), "Ctrl+plus", with_ctrl(Key::plus), anywhere},
        {marked("Smaller"), "Ctrl+minus", with_ctrl(Key::minus), anywhere},
        {marked("Default size"), "Ctrl+0", with_ctrl(Key::zero), anywhere},
        {marked("Restore the step's state"), "Home", KeyPress{Key::home}, in_lesson | on_lesson_stage},
        {marked("Overview of the steps"), "O", KeyPress{Key::o}, on_lesson_stage},
        {marked("Black screen"), "B", KeyPress{Key::b}, on_any_stage},
        {marked("White screen"), ",", KeyPress{Key::comma}, on_any_stage},
        {marked("Freeze the picture"), "P", KeyPress{Key::p}, on_any_stage},
        {marked("Pointer, then spotlight"), "L", KeyPress{Key::l}, on_any_stage},
        {marked("Ink"), "I", KeyPress{Key::i}, on_any_stage},
        {marked("Timer"), "T", KeyPress{Key::t}, on_any_stage},
        {marked("Next theme"), "F6", KeyPress{Key::f6}, on_any_stage},
        {marked("Leave the stage"), "Shift+Esc", KeyPress{Key::escape, false, true}, on_any_stage},
    };
    return all;
}

}  // namespace viewing
