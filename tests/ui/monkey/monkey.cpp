// A monkey for the whole interface, without a window: it drives the studio and its input queue as the main loop does.
// After each action, it checks that GL has reported no error and that the state reads back unchanged. After each
// episode of a hundred actions, it checks that the camera's picture equals the snapshot of its state, that undo leads
// back to the start, and that redo leads to the end again. Episodes begin in presets, lessons, exercises or on the
// start page. In every second episode, background work runs as on screen. The other episodes wait for it, so they are
// exactly reproducible.
//
//   monkey [--seed S] [--events N | --minutes N] [--episode K]    writes into the working folder
//   monkey --script WIDTH HEIGHT WINDOW SEED COUNT STATE           actions for monkey_window
//   monkey --confined COMMAND…                                     writes only into the working folder
//
// The exit status is 1 if the monkey found an error; monkey.log then ends with the actions that led to it.
#include <imgui.h>

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "app/desktop/imgui_window.h"
#include "app/picture.h"
#include "app/studio.h"
#include "gl/debug.h"
#include "gl/egl_context.h"
#include "lesson/exercise.h"
#include "state/file/state_json.h"
#include "ui/desk.h"
#include "ui/monkey/confined.h"
#include "ui/monkey/hands.h"

namespace viewing::test {
namespace {

namespace fs = std::filesystem;

struct Finding : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void require(bool holds, const std::string& what) {
    if (!holds) throw Finding(what);
}

/// Returns the fields that differ, for a message.
std::string difference(const Params& a, const Params& b) {
    std::string text;
    for (const std::string& path : differing_fields(a, b)) text += " " + path;
    return text;
}

constexpr int deeds_an_episode = 100;

/// A simulated window: size, time, clipboard, input.
class Window {
public:
    Window(Renderer& renderer, const LoadedState& state, bool waits, gl::DebugLog& log)
        : studio(renderer, opened(state)), renderer_(renderer), log_(log), waits_(waits) {
        map_imgui_keys();
        ImGuiIO& io = ImGui::GetIO();
        io.ClipboardUserData = this;
        io.SetClipboardTextFn = [](void* window, const char* text) { static_cast<Window*>(window)->clipboard_ = text; };
        io.GetClipboardTextFn = [](void* window) { return static_cast<const Window*>(window)->clipboard_.c_str(); };
        studio.workbench.widgets.record = true;
        queue_.push(PointerMoved{}, now());
    }

    Studio studio;
    glm::ivec2 size_px{800, 600};
    std::size_t events = 0, frames = 0;

    const std::vector<RecordedItem>& items() const { return studio.workbench.widgets.recorded; }

    /// Performs an action. If `bursts`, all events of the action arrive before its first frame, as on a busy machine.
    void take(const Deed& deed, bool bursts) {
        for (const Touch& touch : deed.touches) {
            std::visit([this](const auto& one) { feel(one); }, touch);
            if (!bursts) drain();
        }
        drain();
        frame();
    }
    void tap(const char* key, bool ctrl = false, bool shift = false) {
        const auto push = [this](const char* name, bool down, bool with_ctrl, bool with_shift) {
            queue_.push(changed(key_named(name), down, with_ctrl, with_shift), now());
        };
        if (ctrl) push("ctrl", true, false, false);
        if (shift) push("shift", true, ctrl, false);
        push(key, true, ctrl, shift);
        push(key, false, ctrl, shift);
        if (shift) push("shift", false, ctrl, false);
        if (ctrl) push("ctrl", false, false, false);
        drain();
    }

    /// Exits lessons and dialogs, stops playback and motion, and runs until no frame is due.
    void come_to_rest() {
        feel(InputEvent(PointerMoved{}));
        feel(InputEvent(FocusChanged{false}));
        feel(InputEvent(FocusChanged{true}));
        drain();
        for (int i = 0; i < 4; ++i) tap("Escape");
        Workbench& bench = studio.workbench;
        bench.presenter.end();
        bench.guide.close();
        bench.start_page.close();
        bench.exercises.page.close();
        for (int i = 0; i < 4; ++i) tap("Escape");
        bench.replay.stop();
        bench.recorder.end();
        bench.views.pass_player.playing = bench.views.call_player.playing = false;
        studio.session.finish_loading();
        waits_ = true;
        for (int i = 0; i < 900; ++i) {
            frame();
            studio.session.finish_loading();
            const bool works = bench.exercises.desk.is_open() && !bench.exercises.desk.is_ready();
            if (i > 5 && !works && !studio.session.is_moving() && studio.redraw_in_s() != 0.0) return;
        }
        throw Finding("the window does not come to rest");
    }

    void frame() {
        now_s_ += 1.0 / 60.0;
        const InputFrame& input = queue_.next_frame(now_s_);
        feed_imgui(input, 1.0F);
        const Requests requests =
            studio.frame({.size_px = size_px, .device_scale = 1.0, .shows_time = !waits_, .input = input.input});
        if (waits_) studio.session.finish_loading();
        ++frames;
        const std::vector<std::string>& errors = log_.errors();
        require(errors.empty(), errors.empty() ? "" : "GL: " + errors.front());
    }

    Image camera_picture() { return renderer_.read(studio.camera_view()); }

private:
    static Session opened(const LoadedState& state) {
        Result<Session> session = Session::make(state);
        if (!session) throw std::runtime_error(session.error());
        return *std::move(session);
    }
    InputQueue::Time now() const { return {now_s_, now_s_}; }

    void feel(const InputEvent& event) {
        ++events;
        queue_.push(event, now());
    }
    void feel(const Typed& typed) {
        for (const char letter : typed.text) {
            const auto code = static_cast<std::size_t>(static_cast<unsigned char>(letter));
            const std::size_t upper = letter >= 'a' && letter <= 'z' ? code - 32 : code;
            feel(InputEvent(KeyChanged{.code = upper, .kind = KeyKind::prints, .key = key_of(letter), .down = true}));
            feel(InputEvent(CharacterTyped{static_cast<unsigned>(code)}));
            feel(InputEvent(KeyChanged{.code = upper, .kind = KeyKind::prints, .key = key_of(letter), .down = false}));
        }
    }
    void feel(const WindowResized& resized) {
        ++events;
        size_px = resized.size_px;
    }
    void feel(const ClipboardFilled& filled) {
        ++events;
        std::ifstream file(filled.file, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        clipboard_ = text.c_str();  // the text ends at its first zero byte
    }
    void feel(const Paused& paused) {
        drain();
        now_s_ += paused.seconds;
        frame();
    }
    static std::optional<Key> key_of(char letter) {
        const char name[] = {letter, '\0'};
        const bool has_key = std::strchr("wasdqerfmcvzyobglxnphit012349", letter) != nullptr;
        return has_key ? key_named(name).key : std::nullopt;
    }
    void drain() {
        do {
            frame();
        } while (!queue_.is_empty());
    }

    Renderer& renderer_;
    gl::DebugLog& log_;
    bool waits_;
    InputQueue queue_;
    double now_s_ = 1.0;
    std::string clipboard_;
};

void require_it_reads_back(const Session& session) {
    const std::string text = write_state(session.params);
    const Result<Params> back = parse_state(text, "state");
    require(static_cast<bool>(back), back ? "" : "the state cannot be read back: " + back.error());
    require(*back == session.params, "the state reads back differently:" + difference(*back, session.params));
}

class Monkey {
public:
    Monkey(std::uint32_t seed, Renderer& renderer, gl::DebugLog& log)
        : seed_(seed), renderer_(renderer), log_(log), home_(fs::current_path()), journal_("monkey.log") {
        make_things(home_ / "things");
        for (const NamedFile& preset : presets()) presets_.push_back(preset.name);
        for (const LessonFile& lesson : lessons()) lessons_.push_back(lesson.id);
        for (const Result<Exercise>& exercise : exercises())
            if (exercise) exercises_.push_back(exercise->id);
    }

    std::size_t events = 0, frames = 0, deeds = 0, pictures = 0, undone = 0;

    void live_through(int episode) {
        Hands hands(seed_ * 100003U + static_cast<std::uint32_t>(episode), home_ / "things");
        const bool waits = episode % 2 == 1;
        const std::string preset = presets_[hands.pick(presets_.size())];
        journal_ << "episode " << episode << " of seed " << seed_ << ": " << preset << std::endl;
        const Result<LoadedState> state = load_state(preset);
        require(static_cast<bool>(state), state ? "" : state.error());
        Window window(renderer_, *state, waits, log_);
        static constexpr glm::ivec2 sizes[] = {{640, 480}, {800, 600}};  // small, since drawing takes most of the time
        window.size_px = sizes[hands.pick(std::size(sizes))];
        window.frame();
        const Params start = window.studio.session.params;
        begin(window, hands);
        for (int deed = 0; deed < deeds_an_episode; ++deed) act(window, hands);
        window.come_to_rest();
        check_picture(window, "at the end");
        check_history(window, start);
        events += window.events;
        frames += window.frames;
    }

private:
    void begin(Window& window, Hands& hands) {
        Studio& studio = window.studio;
        switch (hands.pick(6)) {
            case 0: {
                const std::string& id = lessons_[hands.pick(lessons_.size())];
                const Result<Lesson> lesson = load_lesson(id);
                require(static_cast<bool>(lesson), lesson ? "" : lesson.error());
                const std::size_t step = hands.pick(lesson->steps.size());
                const bool presents = hands.pick(2) == 0;
                journal_ << "lesson " << id << ", step " << step << (presents ? ", on a stage" : "") << std::endl;
                studio.workbench.guide.begin(*lesson, step, studio.session);
                if (presents) studio.workbench.presenter.begin();
                break;
            }
            case 1: {
                const std::string& id = exercises_[hands.pick(exercises_.size())];
                journal_ << "exercise " << id << std::endl;
                fs::create_directories(home_ / "answers");
                studio.workbench.exercises.desk.keep_in(home_ / "answers", "0.0");
                studio.workbench.exercises.desk.sit_down({"viewing-2026", std::to_string(hands.pick(9)), "Kim"});
                studio.workbench.exercises.desk.open();
                studio.workbench.exercises.go_to(id, false);
                break;
            }
            case 2:
                studio.workbench.start_page.open();
                break;
            default:
                break;
        }
    }

    void act(Window& window, Hands& hands) {
        const Deed deed = hands.next(window.items(), window.size_px);
        journal_ << deed.what << std::endl;
        window.take(deed, hands.pick(2) == 0);
        ++deeds;
        require_it_reads_back(window.studio.session);
        require(fs::current_path() == home_, "the working folder has changed");
    }

    void check_picture(Window& window, const std::string& when) {
        Session& session = window.studio.session;
        session.params.view.layout = {};  // the layout must show the camera's view
        window.studio.workbench.arrangement = {};
        window.size_px = {800, 600};
        window.come_to_rest();
        const Image shown = window.camera_picture();
        const Result<Params> params = parse_state(session.text(), "state");
        require(static_cast<bool>(params), params ? "" : "the whole state cannot be read back: " + params.error());
        // Without a clear, the picture also depends on earlier frames, which the state does not contain.
        if (!params->depth.clear || !params->depth.write_while_clearing) return;
        const LoadedState state{*params, {}};
        const Result<Scene> scene = load_scene(params->scene, {}, params->coplanar);
        if (!scene) {
            // If the scene's file is gone or is not a mesh, the previous scene stays on screen.
            require(session.message.is_error, "the scene cannot be read, and no message says so: " + scene.error());
            return;
        }
        const Result<Image> drawn =
            draw_picture(renderer_, state, *scene, {PictureView::camera, {shown.width, shown.height}, std::nullopt});
        if (!drawn) {
            require(session.message.is_error, "the snapshot cannot be drawn, and no message says so: " + drawn.error());
            return;
        }
        if (!(shown == *drawn)) {
            std::ofstream("state.json") << session.text();
            const bool kept = write_png("shown.png", shown) && write_png("drawn.png", *drawn);
            throw Finding("the picture " + when + " is not the snapshot of its state" +
                          (kept ? " (shown.png, drawn.png, state.json)" : ""));
        }
        ++pictures;
    }

    void check_history(Window& window, const Params& start) {
        Session& session = window.studio.session;
        const Params end = session.params;
        constexpr int most_steps = 500;  // the size of the history
        int steps = 0;
        for (; session.can_undo() && steps <= most_steps; ++steps) {
            window.tap("z", true);
            session.finish_loading();
        }
        require(!session.can_undo(), "undo comes to no end");
        window.frame();
        if (steps < most_steps) {
            Params first = session.params;
            first.ui.language = start.ui.language;
            require(first == start, "undo does not lead to the start:" + difference(first, start));
            require_it_reads_back(session);
        }
        for (int step = 0; step < steps; ++step) {  // not all redos: if the last action was an undo, there are more
            window.tap("z", true, true);
            session.finish_loading();
        }
        require(session.params == end, "redo does not lead to the end:" + difference(session.params, end));
        check_picture(window, "after undo and redo");
        undone += static_cast<std::size_t>(steps);
    }

    std::uint32_t seed_;
    Renderer& renderer_;
    gl::DebugLog& log_;
    fs::path home_;
    std::ofstream journal_;
    std::vector<std::string> presets_, lessons_, exercises_;
};

struct Wish {
    std::uint32_t seed = 1;
    std::size_t events = 3000;
    double minutes = 0.0;
    int episode = -1;
};

template <typename Number>
Number number(const char* text) {
    Number value{};
    const char* const end = text + std::strlen(text);
    if (std::from_chars(text, end, value).ptr != end) throw std::runtime_error(std::string(text) + " is no number");
    return value;
}

Wish wish_of(int argc, char** argv) {
    Wish wish;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string_view option = argv[i];
        if (option == "--seed")
            wish.seed = number<std::uint32_t>(argv[i + 1]);
        else if (option == "--events")
            wish.events = number<std::size_t>(argv[i + 1]);
        else if (option == "--minutes")
            wish.minutes = number<double>(argv[i + 1]);
        else if (option == "--episode")
            wish.episode = number<int>(argv[i + 1]);
        else
            throw std::runtime_error("unknown option " + std::string(option));
    }
    return wish;
}

int live(const Wish& wish) {
    if (!confine_to(fs::current_path())) {
        std::cout << "skipped: this system cannot prevent the monkey from writing elsewhere (Landlock)\n";
        return 77;
    }
    gl::prefer_quick_start();
    Result<gl::EglContext> context = gl::EglContext::make();
    if (!context) throw std::runtime_error(context.error());
    gl::DebugLog log;
    Result<Renderer> renderer = Renderer::make();
    if (!renderer) throw std::runtime_error(renderer.error());
    Monkey monkey(wish.seed, *renderer, log);
    const auto begun = std::chrono::steady_clock::now();
    const auto is_over = [&] {
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
        return wish.minutes > 0.0 ? passed.count() > 60.0 * wish.minutes : monkey.events >= wish.events;
    };
    int episode = std::max(wish.episode, 0);
    try {
        do {
            monkey.live_through(episode++);
        } while (wish.episode < 0 && !is_over());
    } catch (const std::exception& finding) {
        std::cout << "FOUND in episode " << episode - 1 << " of seed " << wish.seed << ": " << finding.what() << '\n';
        return 1;
    }
    std::cout << "seed " << wish.seed << ": " << episode << " episodes, " << monkey.deeds << " actions, "
              << monkey.events << " events, " << monkey.frames << " frames, " << monkey.pictures
              << " pictures equal to their snapshots, " << monkey.undone << " steps undone; nothing found\n";
    return 0;
}

int write_script(char** argv) {
    const glm::ivec2 size_px(number<int>(argv[2]), number<int>(argv[3]));
    const auto seed = number<std::uint32_t>(argv[5]);
    const Result<LoadedState> state = load_state(argv[7]);
    const bool is_whole = state && Session::make(*state);  // false if a file that the state names is gone
    Desk desk({static_cast<float>(size_px.x), static_cast<float>(size_px.y)}, is_whole ? argv[7] : "opening");
    const fs::path things = fs::current_path() / "things";
    if (!fs::exists(things)) make_things(things);
    Hands hands(seed, things);
    for (int i = 0; i < number<int>(argv[6]); ++i)
        std::cout << as_script(hands.next(desk.recorded(), size_px), argv[4]);
    return 0;
}

int run_confined(char** command) {
    if (!confine_to(fs::current_path())) return 77;
    execvp(*command, command);
    throw std::runtime_error(std::string(*command) + " cannot be run");
}

}  // namespace
}  // namespace viewing::test

int main(int argc, char** argv) {
    try {
        if (argc == 8 && std::string_view(argv[1]) == "--script") return viewing::test::write_script(argv);
        if (argc > 2 && std::string_view(argv[1]) == "--confined") return viewing::test::run_confined(argv + 2);
        return viewing::test::live(viewing::test::wish_of(argc, argv));
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
