// The input queue: each frame gets one change, in order and with the time when it happened, however late the window
// receives it. Further tests send the whole user interface bursts of events like those of a busy machine.
#include "ui/parts/input_queue.h"

#include "desk.h"

namespace viewing::test {
namespace {

using Place = std::optional<glm::vec2>;
constexpr std::size_t left = 0, right = 1;

KeyChanged key_event(char letter, bool down) {
    return {.code = static_cast<std::size_t>(letter), .kind = KeyKind::prints, .key = {}, .down = down};
}
KeyChanged leaving(std::size_t code, bool down) {
    return {.code = code, .kind = KeyKind::leaves, .key = {}, .down = down};
}

class Queue : public ::testing::Test {
protected:
    InputQueue queue;
    template <typename... Events>
    void push(Events... events) {
        (queue.push(events, {}), ...);
    }
    const InputFrame& next(double now_s = 1.0) { return queue.next_frame(now_s); }
};

TEST_F(Queue, APressAndItsReleaseTakeSeparateFrames) {
    push(PointerMoved{glm::vec2(5, 6)}, PointerMoved{glm::vec2(7, 8)}, ButtonChanged{left, true},
         ButtonChanged{left, false}, PointerMoved{glm::vec2(300, 8)});
    EXPECT_EQ(next().pointer, Place(glm::vec2(7, 8)));
    EXPECT_TRUE(next().buttons[left]);
    const InputFrame released = next();
    EXPECT_FALSE(released.buttons[left]);
    EXPECT_EQ(released.pointer, Place(glm::vec2(7, 8))) << "where it happened";
    EXPECT_EQ(next().pointer, Place(glm::vec2(300, 8)));
    EXPECT_TRUE(queue.is_empty());
}

TEST_F(Queue, OneButtonPerFrame) {
    push(ButtonChanged{left, true}, ButtonChanged{right, true}, ButtonChanged{right, false});
    const auto buttons = [this] {
        const InputFrame& frame = next();
        return std::pair(frame.buttons[left], frame.buttons[right]);
    };
    EXPECT_EQ(buttons(), std::pair(true, false));
    EXPECT_EQ(buttons(), std::pair(true, true));
    EXPECT_EQ(buttons(), std::pair(true, false));
    EXPECT_TRUE(queue.is_empty());
}

TEST_F(Queue, TheWheelTurnsAtThePointersPosition) {
    push(PointerMoved{glm::vec2(1, 1)}, WheelTurned{{0, 1}}, WheelTurned{{0, 2}}, PointerMoved{glm::vec2(9, 9)});
    const InputFrame turned = next();
    EXPECT_EQ(turned.pointer, Place(glm::vec2(1, 1)));
    EXPECT_EQ(turned.wheel, glm::vec2(0, 3));
    const InputFrame moved = next();
    EXPECT_EQ(moved.pointer, Place(glm::vec2(9, 9)));
    EXPECT_EQ(moved.wheel, glm::vec2(0)) << "the wheel turned once";
}

TEST_F(Queue, ATappedKeyIsDownForOneFrame) {
    KeyChanged tap{.code = 87, .kind = KeyKind::prints, .key = Key::w, .down = true};
    push(tap);
    tap.down = false;
    push(tap);
    EXPECT_TRUE(next().input.is_down(Key::w));
    const InputFrame up = next();
    EXPECT_FALSE(up.input.is_down(Key::w));
    EXPECT_FALSE(up.keys[87]);
    EXPECT_TRUE(up.input.pressed.empty()) << "the key went down once";
}

TEST_F(Queue, TypingKeepsItsOrder) {
    const std::size_t enter = 257;
    push(key_event('A', true), CharacterTyped{'a'}, key_event('B', true), CharacterTyped{'b'}, leaving(enter, true),
         key_event('A', false), key_event('C', true), CharacterTyped{'c'});
    const InputFrame first = next();
    EXPECT_EQ(first.characters, (std::vector<unsigned>{'a', 'b'}));
    EXPECT_TRUE(first.keys[enter]) << "text fields take characters before keys";
    EXPECT_TRUE(first.keys['A']);
    int frames = 1;
    while (!queue.is_empty()) {
        EXPECT_LT(++frames, 8);
        if (const InputFrame& later = next(); !later.characters.empty()) {
            EXPECT_TRUE(later.keys['C'] && !later.keys['A']);
            EXPECT_EQ(later.characters, std::vector<unsigned>{'c'});
        }
    }
    EXPECT_GT(frames, 2) << "Enter arrives after its target is ready";
}

TEST_F(Queue, AShortcutKeepsItsModifier) {
    const KeyChanged ctrl{.code = 341, .kind = KeyKind::modifier, .key = Key::ctrl, .down = true};
    const KeyChanged z{.code = 90, .kind = KeyKind::prints, .key = Key::z, .down = true, .ctrl = true};
    KeyChanged ctrl_up = ctrl;
    ctrl_up.down = false;
    push(ctrl, z, ctrl_up);
    const InputFrame both = next();
    EXPECT_TRUE(both.input.is_down(Key::ctrl) && both.input.is_down(Key::z));
    ASSERT_FALSE(both.input.pressed.empty());
    EXPECT_TRUE(both.input.pressed.back().key == Key::z && both.input.pressed.back().ctrl);
    while (!queue.is_empty()) next();
    EXPECT_FALSE(next().input.is_down(Key::ctrl));
}

TEST_F(Queue, LosingTheFocusReleasesAllKeys) {
    push(KeyChanged{.code = 87, .kind = KeyKind::prints, .key = Key::w, .down = true}, FocusChanged{false});
    EXPECT_TRUE(next().input.is_down(Key::w));
    const InputFrame gone = next();
    EXPECT_EQ(gone.focus, std::optional(false));
    EXPECT_FALSE(gone.input.is_down(Key::w) || gone.keys[87]);
    EXPECT_FALSE(next().focus);
}

TEST_F(Queue, TimeIsThatOfTheShownEvent) {
    queue.push(ButtonChanged{left, true}, {1.0, 1.5});
    queue.push(ButtonChanged{left, false}, {1.1, 1.6});
    queue.push(ButtonChanged{left, true}, {1.2, 1.7});
    double time_s = next(5.0).input.dt_s;
    EXPECT_NEAR(time_s, 1.0, 1e-3) << "not 5, because more events are waiting";
    time_s += next(6.0).input.dt_s;
    EXPECT_NEAR(time_s, 1.1, 1e-3);
    time_s += next(7.0).input.dt_s;
    EXPECT_NEAR(time_s, 7.0, 1e-3) << "no event is waiting";
    EXPECT_NEAR(next(7.5).input.dt_s, 0.5, 1e-9);
    EXPECT_GT(next(7.5).input.dt_s, 0.0);
}

TEST_F(Queue, AKeyActsAsLongAsItIsHeld) {
    KeyChanged w{.code = 87, .kind = KeyKind::prints, .key = Key::w, .down = true};
    queue.push(w, {2.0, 2.0});
    EXPECT_TRUE(next(2.0).input.is_down(Key::w));
    w.down = false;
    queue.push(w, {2.0, 2.8});  // received late by a busy window
    const InputFrame held = next(2.8);
    EXPECT_TRUE(held.input.is_down(Key::w));
    EXPECT_NEAR(held.input.dt_s, 0.4, 1e-9) << "as far as is known";
    const InputFrame up = next(2.9);
    EXPECT_FALSE(up.input.is_down(Key::w));
    EXPECT_NEAR(up.input.dt_s, 0.5, 1e-9);
}

TEST_F(Queue, NothingIsLostOrReordered) {
    // The frames' changes, one by one, equal the pushed events; only consecutive wheel events may be joined.
    std::vector<std::string> pushed, shown;
    unsigned seed = 5;
    std::array<bool, 3> down{};
    for (int i = 0; i < 2000; ++i) {
        seed = seed * 1664525U + 1013904223U;
        const unsigned which = (seed >> 16U) % 5U;
        if (which < 3) {
            down[which] = !down[which];
            push(ButtonChanged{which, down[which]});
            pushed.push_back((down[which] ? "press " : "release ") + std::to_string(which));
        } else if (which == 3) {
            push(CharacterTyped{static_cast<unsigned>(i)});
            pushed.push_back("type " + std::to_string(i));
        } else {
            push(WheelTurned{{0, static_cast<float>(i)}});
            pushed.push_back("wheel");
        }
    }
    std::array<bool, 3> before{};
    for (int frame = 0; !queue.is_empty(); ++frame) {
        ASSERT_LT(frame, 20'000);
        const InputFrame& now = next();
        for (std::size_t button = 0; button < 3; ++button) {
            if (now.buttons[button] != before[button])
                shown.push_back((now.buttons[button] ? "press " : "release ") + std::to_string(button));
            before[button] = now.buttons[button];
        }
        for (const unsigned character : now.characters) shown.push_back("type " + std::to_string(character));
        if (now.wheel.y > 0.0F) shown.push_back("wheel");
    }
    const auto joined = [](std::vector<std::string> all) {  // consecutive wheel events count as one
        all.erase(std::unique(all.begin(), all.end(),
                              [](const auto& a, const auto& b) { return a == "wheel" && b == "wheel"; }),
                  all.end());
        return all;
    };
    EXPECT_EQ(joined(shown), joined(pushed));
}

// ---- a whole interface ------------------------------------------------------------------------------

class Burst : public UiTest {
protected:
    InputQueue queue;
    double now_s = 10.0;

    /// Pushes an event as part of a burst: a busy window receives all events of a burst at the same time.
    void push(InputEvent event) { queue.push(std::move(event), {now_s, now_s}); }
    void click_at(const RecordedItem& item) {
        push(PointerMoved{glm::vec2((item.min.x + item.max.x) * 0.5F, (item.min.y + item.max.y) * 0.5F)});
        push(ButtonChanged{left, true});
        push(ButtonChanged{left, false});
    }
    void type(const char* text) {
        for (; *text; ++text) {
            push(key_event(*text, true));
            push(CharacterTyped{static_cast<unsigned>(*text)});
            push(key_event(*text, false));
        }
    }
    void enter(ImGuiKey key) {
        const auto code = static_cast<std::size_t>(ImGui::GetIO().KeyMap[key]);
        push(leaving(code, true));
        push(leaving(code, false));
    }
    /// Runs frames of half a second each until all events are shown.
    void show() {
        for (int settled = 0; settled < 5; settled = queue.is_empty() ? settled + 1 : 0) {
            now_s += 0.5;
            const InputFrame& frame = queue.next_frame(now_s);
            feed_imgui(frame, 1.0F);
            desk.input = frame.input;
            ui.frame(static_cast<float>(frame.input.dt_s));
        }
    }
};

TEST_F(Burst, HandlesADoubleClickAndTyping) {
    desk.reveal("projection/fovy");
    const RecordedItem fovy = ui.find("projection/fovy");
    click_at(fovy);
    click_at(fovy);
    type("55");
    enter(ImGuiKey_Enter);
    push(PointerMoved{glm::vec2(fovy.max.x + 400.0F, fovy.max.y)});
    show();
    EXPECT_EQ(params.projection.fovy, 55.0);
}

TEST_F(Burst, TabMovesTypingToTheNextField) {
    desk.reveal("projection/z-near");
    const RecordedItem near = ui.find("projection/z-near");
    click_at(near);
    click_at(near);
    type("2");
    enter(ImGuiKey_Tab);
    type("44");
    enter(ImGuiKey_Enter);
    show();
    EXPECT_EQ(params.projection.near, 2.0);
    EXPECT_EQ(params.projection.far, 44.0);
}

TEST_F(Burst, ADragEndsWhereTheHandStopped) {
    const Rect rect = desk.layout().camera;
    const glm::vec2 from((rect.min.x + rect.max.x) * 0.5F - 250.0F, (rect.min.y + rect.max.y) * 0.5F - 120.0F);
    desk.drag_from({from.x, from.y}, 100.0F, 0.0F);
    const double yaw = params.camera.yaw;
    EXPECT_LT(yaw, Params{}.camera.yaw - 10.0);
    desk.undo();
    push(PointerMoved{from});
    push(ButtonChanged{left, true});
    for (int i = 1; i <= 10; ++i) push(PointerMoved{from + glm::vec2(10.0F * static_cast<float>(i), 0.0F)});
    push(ButtonChanged{left, false});
    push(PointerMoved{from + glm::vec2(0.0F, 300.0F)});
    show();
    EXPECT_NEAR(params.camera.yaw, yaw, 1e-6) << "like a drag by a slow hand";
}

}  // namespace
}  // namespace viewing::test
