#include "ui/monkey/hands.h"

#include <fmt/format.h>
#include <sys/stat.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "image/png.h"
#include "state/file/link.h"
#include "state/file/state_json.h"
#include "state/presets.h"

namespace viewing::test {
namespace {

namespace fs = std::filesystem;

constexpr KeyOnBoard keys[] = {{"w", GLFW_KEY_W, KeyKind::prints, Key::w},
                               {"a", GLFW_KEY_A, KeyKind::prints, Key::a},
                               {"s", GLFW_KEY_S, KeyKind::prints, Key::s},
                               {"d", GLFW_KEY_D, KeyKind::prints, Key::d},
                               {"q", GLFW_KEY_Q, KeyKind::prints, Key::q},
                               {"e", GLFW_KEY_E, KeyKind::prints, Key::e},
                               {"r", GLFW_KEY_R, KeyKind::prints, Key::r},
                               {"f", GLFW_KEY_F, KeyKind::prints, Key::f},
                               {"m", GLFW_KEY_M, KeyKind::prints, Key::m},
                               {"c", GLFW_KEY_C, KeyKind::prints, Key::c},
                               {"v", GLFW_KEY_V, KeyKind::prints, Key::v},
                               {"z", GLFW_KEY_Z, KeyKind::prints, Key::z},
                               {"y", GLFW_KEY_Y, KeyKind::prints, Key::y},
                               {"o", GLFW_KEY_O, KeyKind::prints, Key::o},
                               {"b", GLFW_KEY_B, KeyKind::prints, Key::b},
                               {"g", GLFW_KEY_G, KeyKind::prints, Key::g},
                               {"l", GLFW_KEY_L, KeyKind::prints, Key::l},
                               {"x", GLFW_KEY_X, KeyKind::prints, Key::x},
                               {"n", GLFW_KEY_N, KeyKind::prints, Key::n},
                               {"p", GLFW_KEY_P, KeyKind::prints, Key::p},
                               {"h", GLFW_KEY_H, KeyKind::prints, Key::h},
                               {"i", GLFW_KEY_I, KeyKind::prints, Key::i},
                               {"t", GLFW_KEY_T, KeyKind::prints, Key::t},
                               {"0", GLFW_KEY_0, KeyKind::prints, Key::zero},
                               {"1", GLFW_KEY_1, KeyKind::prints, Key::one},
                               {"2", GLFW_KEY_2, KeyKind::prints, Key::two},
                               {"3", GLFW_KEY_3, KeyKind::prints, Key::three},
                               {"4", GLFW_KEY_4, KeyKind::prints, Key::four},
                               {"9", GLFW_KEY_9, KeyKind::prints, Key::nine},
                               {"equal", GLFW_KEY_EQUAL, KeyKind::prints, Key::plus},
                               {"minus", GLFW_KEY_MINUS, KeyKind::prints, Key::minus},
                               {"period", GLFW_KEY_PERIOD, KeyKind::prints, Key::period},
                               {"comma", GLFW_KEY_COMMA, KeyKind::prints, Key::comma},
                               {"space", GLFW_KEY_SPACE, KeyKind::prints, Key::space},
                               {"Left", GLFW_KEY_LEFT, KeyKind::edits, Key::left},
                               {"Right", GLFW_KEY_RIGHT, KeyKind::edits, Key::right},
                               {"Up", GLFW_KEY_UP, KeyKind::edits, Key::up},
                               {"Down", GLFW_KEY_DOWN, KeyKind::edits, Key::down},
                               {"Home", GLFW_KEY_HOME, KeyKind::edits, Key::home},
                               {"End", GLFW_KEY_END, KeyKind::edits, std::nullopt},
                               {"Prior", GLFW_KEY_PAGE_UP, KeyKind::edits, Key::page_up},
                               {"Next", GLFW_KEY_PAGE_DOWN, KeyKind::edits, Key::page_down},
                               {"BackSpace", GLFW_KEY_BACKSPACE, KeyKind::edits, Key::backspace},
                               {"Delete", GLFW_KEY_DELETE, KeyKind::edits, std::nullopt},
                               {"Return", GLFW_KEY_ENTER, KeyKind::leaves, Key::enter},
                               {"Tab", GLFW_KEY_TAB, KeyKind::leaves, std::nullopt},
                               {"Escape", GLFW_KEY_ESCAPE, KeyKind::leaves, Key::escape},
                               {"F1", GLFW_KEY_F1, KeyKind::leaves, Key::f1},
                               {"F2", GLFW_KEY_F2, KeyKind::leaves, Key::f2},
                               {"F3", GLFW_KEY_F3, KeyKind::leaves, Key::f3},
                               {"F5", GLFW_KEY_F5, KeyKind::leaves, Key::f5},
                               {"F6", GLFW_KEY_F6, KeyKind::leaves, Key::f6},
                               {"F9", GLFW_KEY_F9, KeyKind::leaves, Key::f9},
                               {"F11", GLFW_KEY_F11, KeyKind::leaves, Key::f11},
                               {"F12", GLFW_KEY_F12, KeyKind::leaves, Key::f12},
                               {"shift", GLFW_KEY_LEFT_SHIFT, KeyKind::modifier, Key::shift},
                               {"ctrl", GLFW_KEY_LEFT_CONTROL, KeyKind::modifier, Key::ctrl},
                               {"alt", GLFW_KEY_LEFT_ALT, KeyKind::modifier, std::nullopt}};

void write(const fs::path& file, std::string_view text) {
    std::ofstream(file, std::ios::binary) << text;
}

std::string name_of(std::size_t code) {
    for (const KeyOnBoard& key : keys)
        if (key.code == code) return key.name;
    throw std::logic_error("a key without a name");
}

std::string in_window(const InputEvent& event, const std::string& id) {
    if (const auto* moved = std::get_if<PointerMoved>(&event)) {
        const glm::vec2 place = moved->place.value_or(glm::vec2(5000.0F));
        return fmt::format("mousemove --window {} {:.0f} {:.0f}", id, place.x, place.y);
    }
    if (const auto* button = std::get_if<ButtonChanged>(&event)) {
        static constexpr int of_x[] = {1, 3, 2};
        return fmt::format("mouse{} {}", button->down ? "down" : "up", of_x[button->button]);
    }
    if (const auto* wheel = std::get_if<WheelTurned>(&event))
        return fmt::format("click {}", wheel->lines.y > 0 ? 4 : wheel->lines.y < 0 ? 5 : wheel->lines.x > 0 ? 7 : 6);
    if (const auto* key = std::get_if<KeyChanged>(&event))
        return fmt::format("key{} {}", key->down ? "down" : "up", name_of(key->code));
    if (const auto* dropped = std::get_if<FilesDropped>(&event)) {
        std::string line = "drop";
        for (const fs::path& file : dropped->files) line += " " + file.string();
        return line;
    }
    return "";  // the display has only one window, which keeps the focus
}

}  // namespace

const KeyOnBoard& key_named(std::string_view name) {
    for (const KeyOnBoard& key : keys)
        if (key.name == name) return key;
    throw std::logic_error("no key " + std::string(name));
}

KeyChanged changed(const KeyOnBoard& key, bool down, bool ctrl, bool shift) {
    return {.code = key.code, .kind = key.kind, .key = key.key, .down = down, .ctrl = ctrl, .shift = shift};
}

Hands::Hands(std::uint32_t seed, fs::path things) : random_(seed) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(things)) things_.push_back(entry.path());
    std::sort(things_.begin(), things_.end());
}

fs::path Hands::thing() {
    return things_[pick(things_.size())];
}

glm::vec2 Hands::place_in(const widgets::RecordedItem& item) {
    const auto share = [this] { return 0.02F + 0.96F * static_cast<float>(pick(100)) / 100.0F; };
    return {item.min.x + share() * (item.max.x - item.min.x), item.min.y + share() * (item.max.y - item.min.y)};
}

glm::vec2 Hands::somewhere(const Items& items, glm::ivec2 size_px, std::string& what) {
    if (items.empty() || chance(8)) {
        const glm::vec2 place(static_cast<float>(pick(static_cast<std::size_t>(size_px.x))),
                              static_cast<float>(pick(static_cast<std::size_t>(size_px.y))));
        what += fmt::format(" at ({}, {})", place.x, place.y);
        return place;
    }
    const widgets::RecordedItem& item = items[pick(items.size())];
    what += " " + item.label;
    return place_in(item);
}

void Hands::tap(Deed& deed, const char* name, bool ctrl, bool shift) {
    const KeyOnBoard& key = key_named(name);
    if (ctrl) deed.touches.emplace_back(changed(key_named("ctrl"), true));
    if (shift) deed.touches.emplace_back(changed(key_named("shift"), true, ctrl));
    deed.touches.emplace_back(changed(key, true, ctrl, shift));
    deed.touches.emplace_back(changed(key, false, ctrl, shift));
    if (shift) deed.touches.emplace_back(changed(key_named("shift"), false, ctrl));
    if (ctrl) deed.touches.emplace_back(changed(key_named("ctrl"), false));
}

void Hands::click(Deed& deed, std::size_t button, int times) {
    for (int i = 0; i < times; ++i) {
        deed.touches.emplace_back(ButtonChanged{button, true});
        deed.touches.emplace_back(ButtonChanged{button, false});
    }
}

void Hands::drag(Deed& deed, glm::vec2 from, glm::ivec2 size_px) {
    const std::size_t button = chance(4) ? 1 + pick(2) : 0;
    const bool far = chance(3);
    const auto by = [&](int size) {
        const int most = far ? size : 60;
        return static_cast<float>(pick(static_cast<std::size_t>(2 * most + 1))) - static_cast<float>(most);
    };
    const glm::vec2 way(by(size_px.x), by(size_px.y));
    const char* const held = chance(4) ? (chance(2) ? "shift" : "alt") : nullptr;
    if (held) deed.touches.emplace_back(changed(key_named(held), true));
    deed.touches.emplace_back(ButtonChanged{button, true});
    const int steps = 2 + static_cast<int>(pick(6));
    for (int i = 1; i <= steps; ++i)
        deed.touches.emplace_back(PointerMoved{from + way * (static_cast<float>(i) / static_cast<float>(steps))});
    // Sometimes the hands give up in the middle of a drag.
    if (chance(10)) tap(deed, "Escape");
    if (chance(20)) tap(deed, "z", true);
    deed.touches.emplace_back(ButtonChanged{button, false});
    if (held) deed.touches.emplace_back(changed(key_named(held), false));
}

void Hands::type_number(Deed& deed) {
    static constexpr const char* texts[] = {"0",    "-5",        "1e300", "1e-12", "90",  "nan",   "inf",
                                            "-2,5", "abc",       "720",   "0.001", "1/3", "180/7", "sqrt(2)",
                                            "-0",   "999999999", "",      "  ",    "w",   "--",    "1e-320"};
    const char* const text = texts[pick(std::size(texts))];
    deed.what += std::string(", type \"") + text + "\"";
    click(deed, 0, 2);
    deed.touches.emplace_back(Typed{text});
    static constexpr const char* ends[] = {"Return", "Tab", "Escape", "Down"};
    tap(deed, ends[pick(std::size(ends))], false, chance(6));
}

void Hands::press_a_key(Deed& deed) {
    const KeyOnBoard& key = keys[pick(std::size(keys))];
    const bool ctrl = chance(4), shift = chance(8);
    deed.what = fmt::format("key {}{}{}", ctrl ? "ctrl+" : "", shift ? "shift+" : "", key.name);
    if (!chance(3)) return tap(deed, key.name, ctrl, shift);
    deed.what += " held";
    deed.touches.emplace_back(changed(key, true));
    deed.touches.emplace_back(Paused{0.05 + 0.01 * static_cast<double>(pick(60))});
    deed.touches.emplace_back(changed(key, false));
}

void Hands::take_from_presets(Deed& deed) {
    static const std::vector<NamedFile> all = presets();
    std::string name = all[pick(all.size())].name;
    if (chance(4)) name.resize(1 + pick(name.size()));
    deed.what = "the preset " + name;
    tap(deed, "p", true);
    deed.touches.emplace_back(Typed{name});
    tap(deed, chance(8) ? "Escape" : "Return");
}

void Hands::use_files(Deed& deed) {
    const fs::path file = thing();
    switch (pick(4)) {
        case 0: {
            deed.what = "open " + file.filename().string();
            tap(deed, "o", true);
            deed.touches.emplace_back(Typed{"things/" + file.filename().string()});
            tap(deed, "Return");
            break;
        }
        case 1: {
            static constexpr const char* names[] = {"a.json", "b.json", "no/such/folder.json",
                                                    "things", "c",      "../d.json"};
            const char* const name = names[pick(std::size(names))];
            deed.what = std::string("save as ") + name;
            tap(deed, "s", true);
            deed.touches.emplace_back(Typed{name});
            tap(deed, "Return");
            if (chance(2)) tap(deed, "Return");
            break;
        }
        default: {
            FilesDropped dropped{{file}};
            if (chance(5)) dropped.files.push_back(thing());
            deed.what = "drop " + file.filename().string();
            deed.touches.emplace_back(dropped);
            if (chance(2)) deed.touches.emplace_back(Paused{0.3});
        }
    }
    if (chance(2)) tap(deed, "Escape");
}

void Hands::use_clipboard(Deed& deed) {
    const fs::path file = thing();
    std::error_code is_a_loop;
    if (!fs::is_regular_file(file, is_a_loop) || chance(4)) {
        deed.what = "copy, paste";
        tap(deed, "c", true);
        tap(deed, "v", true);
        return;
    }
    deed.what = "paste " + file.filename().string();
    deed.touches.emplace_back(ClipboardFilled{file});
    tap(deed, "v", true);
}

Deed Hands::next(const Items& items, glm::ivec2 size_px) {
    Deed deed;
    const std::size_t kind = pick(100);
    if (kind < 62) {  // by mouse
        std::string where;
        const glm::vec2 place = somewhere(items, size_px, where);
        deed.touches.emplace_back(PointerMoved{place});
        if (kind < 26) {
            deed.what = "click" + where;
            const bool ctrl = chance(12);
            if (ctrl) deed.touches.emplace_back(changed(key_named("ctrl"), true));
            click(deed);
            if (ctrl) deed.touches.emplace_back(changed(key_named("ctrl"), false));
        } else if (kind < 40) {
            deed.what = "drag" + where;
            drag(deed, place, size_px);
        } else if (kind < 50) {
            deed.what = "in" + where;
            type_number(deed);
        } else if (kind < 54) {
            deed.what = "right-click" + where;
            click(deed, 1);
        } else if (kind < 59) {
            deed.what = "wheel over" + where;
            const float lines = chance(2) ? 1.0F : -1.0F;
            for (std::size_t i = 0; i <= pick(5); ++i)
                deed.touches.emplace_back(chance(6) ? WheelTurned{{lines, 0.0F}} : WheelTurned{{0.0F, lines}});
        } else {
            deed.what = "rest on" + where;
            deed.touches.emplace_back(Paused{1.0});
        }
    } else if (kind < 80) {
        press_a_key(deed);
    } else if (kind < 85) {
        deed.what = "undo";
        for (std::size_t i = 0; i <= pick(4); ++i) tap(deed, chance(3) ? "y" : "z", true);
    } else if (kind < 89) {
        take_from_presets(deed);
    } else if (kind < 93) {
        use_files(deed);
    } else if (kind < 96) {
        use_clipboard(deed);
    } else if (kind < 98) {
        static constexpr glm::ivec2 sizes[] = {{480, 360}, {640, 480}, {800, 600}, {1280, 720}, {500, 700}};
        const glm::ivec2 size = sizes[pick(std::size(sizes))];
        deed.what = fmt::format("resize to {}x{}", size.x, size.y);
        deed.touches.emplace_back(WindowResized{size});
    } else {
        deed.what = "look elsewhere";
        deed.touches.emplace_back(PointerMoved{});
        deed.touches.emplace_back(FocusChanged{false});
        deed.touches.emplace_back(Paused{0.2});
        deed.touches.emplace_back(FocusChanged{true});
    }
    return deed;
}

void make_things(const fs::path& folder) {
    fs::create_directories(folder / "folder.json");
    write(folder / "empty.json", "");
    write(folder / "near.json", R"({"projection": {"near": 0.25}, "camera": {"yaw": 3}})");
    write(folder / "wrong.json", R"({"projection": {"naer": 0.25}})");
    write(folder / "beyond.json", R"({"projection": {"near": -1}})");
    write(folder / "cut.json", R"({"camera": {"position": [1, 2)");
    write(folder / "deep.json", std::string(5000, '['));
    write(folder / "numbers.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
    write(folder / "number.txt", "0.5");
    write(folder / "bytes.txt", std::string_view("\xff\xfe\x00{\x01\xc3\x28", 7));
    write(folder / "korean.txt",
          "가나다 그림자 \u202E"
          "abc");
    write(folder / "junk-link.txt", "#1abc");
    write(folder / "preset-link.txt", "https://example.org/viewing-sandbox.html#preset=room");
    write(folder / "link.txt", link_fragment(Params{}));
    write(folder / "tetrahedron.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    write(folder / "broken.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3\n");
    write(folder / "flat.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n");
    write(folder / "mesh.json",
          R"({"scene": {"objects": [{"name": "m", "shape": "mesh", "file": "tetrahedron.obj"}]}})");
    write(folder / "outside.json",
          R"({"scene": {"objects": [{"name": "m", "shape": "mesh", "file": "/usr/share/m.obj"}]}})");
    write(folder / "gone.json", R"({"scene": {"objects": [{"name": "m", "shape": "mesh", "file": "gone.obj"}]}})");
    write(folder / "none.json", R"({"scene": {"objects": []}})");
    write(folder / "pipe-scene.json", R"({"scene": "pipe.json"})");
    mkfifo((folder / "pipe.json").c_str(), 0600);
    mkfifo((folder / "pipe.obj").c_str(), 0600);
    write(folder / "flight.json", R"({"version": 1, "kind": "flight", "seconds": 0.4, "state": {}, "frames": [)"
                                  R"({"t": 0.1, "set": {"camera.yaw": 31}}, {"t": 0.2, "set": {"camera.yaw": 33}}]})");
    write(
        folder / "hand-in.json",
        R"({"answers": 1, "program": "0.1.0", "course": "viewing-2026", "student": "1", "name": "Kim", "items": []})");
    const Image dot{2, 2, std::vector<std::uint8_t>(16, 200)};
    const std::vector<std::uint8_t> figure = encode_png(dot, write_state(Params{}));
    write(folder / "figure.png", {reinterpret_cast<const char*>(figure.data()), figure.size()});
    write(folder / "cut.png", {reinterpret_cast<const char*>(figure.data()), figure.size() / 2});
    const std::vector<std::uint8_t> plain = encode_png(dot);
    write(folder / "plain.png", {reinterpret_cast<const char*>(plain.data()), plain.size()});
    std::error_code ignored;
    fs::create_symlink("loop.json", folder / "loop.json", ignored);
}

std::string as_script(const Deed& deed, const std::string& id) {
    std::string script = "# " + deed.what + "\n";
    for (const Touch& touch : deed.touches) {
        std::string line;
        if (const auto* event = std::get_if<InputEvent>(&touch)) line = in_window(*event, id);
        if (const auto* typed = std::get_if<Typed>(&touch); typed && !typed->text.empty())
            line = fmt::format("type --delay 1 '{}'", typed->text);
        if (const auto* resized = std::get_if<WindowResized>(&touch))
            line = fmt::format("resize {} {}", resized->size_px.x, resized->size_px.y);
        if (const auto* filled = std::get_if<ClipboardFilled>(&touch)) line = "clipboard " + filled->file.string();
        if (const auto* paused = std::get_if<Paused>(&touch)) line = fmt::format("sleep {:.2f}", paused->seconds * 0.2);
        if (!line.empty()) script += line + "\n";
    }
    return script;
}

}  // namespace viewing::test
