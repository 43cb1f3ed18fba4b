#include "ui/parts/input_queue.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <utility>

namespace viewing {
namespace {

/// The number of frames until a text field accepts input after a click or Tab.
constexpr int frames_to_take_effect = 3;

/// Whether the key may change how later events are handled.
bool acts(const KeyChanged& event) {
    return event.down && event.kind != KeyKind::modifier && (event.kind != KeyKind::prints || event.ctrl);
}

}  // namespace

void InputQueue::push(InputEvent event, Time time) {
    const bool is_key = std::holds_alternative<KeyChanged>(event);
    events_.push_back({std::move(event), is_key ? 0.5 * (time.earliest_s + time.latest_s) : time.earliest_s});
}

bool InputQueue::lets_held_keys_act() const {
    constexpr double usual_frame_s = 1.0 / 60.0;
    const auto& down = frame_.input.down;
    return std::holds_alternative<KeyChanged>(events_.front().event) &&
           events_.front().time_s > clock_s_ + usual_frame_s &&
           std::any_of(down.begin(), down.end(), [](bool held) { return held; });
}

const InputFrame& InputQueue::next_frame(double now_s) {
    taken_ = {};
    frame_.wheel = {};
    frame_.characters.clear();
    frame_.focus.reset();
    frame_.input.loses_focus = false;
    frame_.input.pressed.clear();
    frame_.input.dropped_files.clear();
    keyboard_waits_ = std::max(keyboard_waits_ - 1, 0);

    const double before_s = clock_s_;
    while (!events_.empty()) {
        const Waiting& next = events_.front();
        if (lets_held_keys_act()) {
            clock_s_ = next.time_s;
            break;
        }
        if (!std::visit([this](const auto& event) { return fits(event); }, next.event)) break;
        std::visit([this](const auto& event) { apply(event); }, next.event);
        clock_s_ = std::max(clock_s_, next.time_s);
        events_.pop_front();
    }
    if (events_.empty()) clock_s_ = std::max(clock_s_, now_s);
    frame_.input.dt_s = std::max(clock_s_ - before_s, 1e-4);
    return frame_;
}

bool InputQueue::is_nothing_taken() const {
    return !taken_.pointer && !taken_.wheel && !taken_.keyboard && !taken_.alone;
}

bool InputQueue::fits(const PointerMoved&) const {
    return !taken_.wheel && !taken_.keyboard && !taken_.alone;
}
bool InputQueue::fits(const ButtonChanged&) const {
    return is_nothing_taken();
}
bool InputQueue::fits(const WheelTurned&) const {
    return !taken_.keyboard && !taken_.alone;
}
bool InputQueue::fits(const KeyChanged& event) const {
    if (taken_.pointer || taken_.wheel || taken_.alone || keyboard_waits_ > 0) return false;
    const bool is_its_second = std::find(taken_.codes.begin(), taken_.codes.end(), event.code) != taken_.codes.end();
    const bool bends_what_was_pressed = event.kind == KeyKind::modifier && taken_.pressed;
    return !is_its_second && !taken_.acted && !bends_what_was_pressed;
}
bool InputQueue::fits(const CharacterTyped&) const {
    return !taken_.pointer && !taken_.wheel && !taken_.alone && !taken_.acted && keyboard_waits_ == 0;
}
bool InputQueue::fits(const FocusChanged&) const {
    return is_nothing_taken();
}
bool InputQueue::fits(const FilesDropped&) const {
    return is_nothing_taken();
}

void InputQueue::apply(const PointerMoved& event) {
    taken_.pointer = true;
    frame_.pointer = event.place;
}

void InputQueue::apply(const ButtonChanged& event) {
    taken_.alone = true;
    if (event.button >= frame_.buttons.size()) return;
    frame_.buttons[event.button] = event.down;
    keyboard_waits_ = frames_to_take_effect;
}

void InputQueue::apply(const WheelTurned& event) {
    taken_.wheel = true;
    frame_.wheel += event.lines;
}

void InputQueue::apply(const KeyChanged& event) {
    taken_.keyboard = true;
    taken_.codes.push_back(event.code);
    taken_.pressed |= event.down && event.kind != KeyKind::modifier;
    taken_.acted |= acts(event);
    if (acts(event) && event.kind != KeyKind::edits) keyboard_waits_ = frames_to_take_effect;
    if (event.code < frame_.keys.size()) frame_.keys[event.code] = event.down;
    if (!event.key) return;
    frame_.input.down[*event.key] = event.down;
    if (event.down) frame_.input.pressed.push_back({*event.key, event.ctrl, event.shift});
}

void InputQueue::apply(const CharacterTyped& event) {
    taken_.keyboard = true;
    frame_.characters.push_back(event.code_point);
}

void InputQueue::apply(const FocusChanged& event) {
    taken_.alone = true;
    frame_.focus = event.focused;
    frame_.input.loses_focus = !event.focused;
    if (event.focused) return;
    frame_.keys.fill(false);  // a window without focus gets no key releases
    frame_.input.down.fill(false);
}

void InputQueue::apply(const FilesDropped& event) {
    taken_.alone = true;
    frame_.input.dropped_files = event.files;
}

void feed_imgui(const InputFrame& frame, float pixels_per_unit) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = frame.pointer ? ImVec2(frame.pointer->x * pixels_per_unit, frame.pointer->y * pixels_per_unit)
                                : ImVec2(-FLT_MAX, -FLT_MAX);
    std::copy(frame.buttons.begin(), frame.buttons.end(), std::begin(io.MouseDown));
    std::copy(frame.keys.begin(), frame.keys.end(), std::begin(io.KeysDown));
    io.MouseWheelH = frame.wheel.x;
    io.MouseWheel = frame.wheel.y;
    io.KeyCtrl = frame.input.is_down(Key::ctrl);
    io.KeyShift = frame.input.is_down(Key::shift);
    io.KeyAlt = frame.input.is_down(Key::alt);
    io.KeySuper = frame.input.is_down(Key::super);
    for (const unsigned code_point : frame.characters) io.AddInputCharacter(code_point);
    if (frame.focus) io.AddFocusEvent(*frame.focus);
}

}  // namespace viewing
