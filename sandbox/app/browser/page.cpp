#include "app/browser/page.h"

#include <emscripten.h>
#include <emscripten/html5.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "app/browser/keys.h"
#include "app/browser/open_page.h"
#include "app/pictures_to_files.h"
#include "platform/browser/standstill.h"
#include "state/file/link.h"
#include "state/person/language.h"
#include "text/catalogue.h"
#include "text/numbers.h"
#include "topics/matrices/numbers/matrix_text.h"

EM_JS(void, page_tell_trouble, (const char* text), { page.tellTrouble(UTF8ToString(text)); });
EM_JS(void, page_wake, (), { page.wake(); });
EM_JS(void, page_copy, (const char* text), { page.copy(UTF8ToString(text)); });
EM_JS(void, page_full_screen, (int wanted), { page.fullScreen(wanted); });
EM_JS(void, page_prepare_gl, (), { page.prepareGl(GLctx); });
// Returns the time of the event being handled, which is earlier than now if the page was busy.
EM_JS(double, page_event_ms, (), { return window.event ? window.event.timeStamp : performance.now(); });

namespace viewing {
namespace {

/// Creates the WebGL 2 context. Returns why that failed; "" on success.
std::string make_context() {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.alpha = wanted.depth = wanted.stencil = wanted.antialias = false;
    wanted.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
    const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context("#view", &wanted);
    if (context <= 0) return "This browser does not support WebGL 2, which the sandbox needs.";
    emscripten_webgl_make_context_current(context);
    page_prepare_gl();
    return "";
}

void obey(const Requests& requests) {
    if (requests.snapshot) write_snapshot(page->renderer, page->studio, page_folder);
    if (requests.view_picture) write_view_picture(page->renderer, page->studio, requests.view_picture->file);
    if (requests.toggle_full_screen) page_full_screen(-1);
    if (requests.full_screen) page_full_screen(*requests.full_screen ? 1 : 0);
    page->any |= requests.snapshot || requests.view_picture.has_value();
}

/// Opens a link, given as the fragment of the page's address.
void open_link(const std::string& text) {
    Session& session = page->studio.session;
    const Result<Link> link = read_link(text);
    if (!link) return session.report(Error{link.error()});
    if (link->kind == Link::Kind::lesson) return page->studio.workbench.guide.open(*link);
    link->kind == Link::Kind::preset ? session.open(link->text) : session.report(session.paste(text));
}

/// Returns the fragment for the most recently opened state or lesson; "" for the state at startup.
std::string opened_fragment() {
    const Workbench& workbench = page->studio.workbench;
    if (const LessonRun* const run = workbench.guide.is_shown() ? workbench.guide.run() : nullptr;
        run && !workbench.guide.is_sheet())
        return lesson_fragment(run->lesson().id, run->index() + 1);
    const OpenPreset* const preset = page->studio.session.preset();
    return preset && preset->name != "opening" ? "#preset=" + preset->name : "";
}

bool departs_from_opened() {
    const Session& session = page->studio.session;
    if (session.preset()) return session.departs_from_preset();
    return session.params != session.in_own_looks(Params{});
}

/// Whether an unanswered lesson step covers something on screen that must therefore not be read aloud.
bool hides_something() {
    const Guide& guide = page->studio.workbench.guide;
    return guide.is_shown() && !guide.run()->is_revealed() && !guide.run()->step().cover.empty();
}

/// Returns the text that screen readers get instead of the picture: the lesson's question, the preset's description,
/// problems and messages.
std::string told_text() {
    const Studio& studio = page->studio;
    std::vector<std::string> lines;
    const Workbench& workbench = studio.workbench;
    if (const LessonRun* const run = workbench.guide.is_shown() ? workbench.guide.run() : nullptr) {
        const LessonStep& step = run->step();
        lines.push_back(run->lesson().title.shown() + " " + std::to_string(run->index() + 1) + " / " +
                        std::to_string(run->lesson().steps.size()));
        lines.push_back(step.say.shown());
        lines.push_back(step.ask.question.shown());
        if (const std::optional<Verdict>& verdict = run->verdict()) lines.push_back(verdict->say.shown());
        if (run->is_revealed()) lines.push_back(run->reveal_say().shown());
    } else if (const OpenPreset* const preset = studio.session.preset()) {
        for (const NamedFile& file : page->presets)
            if (file.name == preset->name)
                lines.push_back(std::string(tr(file.title.c_str())) + ". " + tr(file.about.c_str()));
    }
    if (!hides_something())
        for (const Problem& problem : studio.shown().problems) lines.push_back(say(problem.sentence));
    lines.push_back(studio.session.message.text);
    std::string text;
    for (const std::string& line : lines)
        if (!line.empty()) text += line + "\n";
    return text;
}

/// Returns the lecture's four matrices, one row per line.
std::string matrices_text() {
    if (hides_something()) return "";
    const Derived& derived = page->studio.shown().derived;
    std::string text;
    constexpr int digits = 4;
    for (const auto& [name, matrix] :
         {std::pair<const char*, glm::dmat4>{"S", derived.chosen_shadow().shadowed_world_from_world},
          {"R", derived.chosen_plane().mirrored_world_from_world},
          {"V", derived.view_from_world},
          {"P", derived.clip_from_view}})
        text += matrix_text(name, matrix, MatrixFormat::text, digits);
    return text;
}

/// Whether reading a pixel back would block until all queued drawing is done. If so, the page delays its next frame
/// instead.
bool waits_for_gl() {
    constexpr double patience_s = 0.25;
    return page->studio.reads_back() && !page->drawn.has_passed() && page_now_s() - page->drawn_s < patience_s;
}

/// Freezes shorter than this go unnoticed.
constexpr double noticed_ms = 500.0;

/// Reports a freeze only in the frame after the slow one. Otherwise, the slow frame's length would count as part of the
/// message's time on screen.
void tell_standstill() {
    const double ms = take_standstill_ms();
    StatusMessage& message = page->studio.session.message;
    if (ms < noticed_ms || message.is_error) return;
    message = {
        say("This took {time} s, and the page froze: this browser cannot suspend WebAssembly. Chrome, Edge and Firefox "
            "can.",
            "time"_a = figures(ms / 1000.0))};
    page->any = true;
}

/// Whether the sandbox uses this key when embedded. All keys belong to the host page, with two exceptions: any key
/// while the user types or chooses from a list, and the flying keys while the pointer is over the picture.
bool uses_embedded(const KeyChanged& change) {
    constexpr std::array flying{Key::w, Key::a, Key::s, Key::d, Key::q, Key::e, Key::r, Key::f};
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return true;
    const bool is_over = ImGui::IsMousePosValid() && page->studio.workbench.views.hovered == ViewName::camera;
    return is_over && !change.ctrl && change.key &&
           std::find(flying.begin(), flying.end(), *change.key) != flying.end();
}

/// Reports a status. Call after drawing the frame that it belongs to.
void report(const Status& status) {
    page->studio.session.report(status);
    page->any |= !status;
}

}  // namespace

std::unique_ptr<OpenPage> page;

double page_now_s() {
    return emscripten_get_now() / 1000.0;
}

void push(InputEvent event) {
    page->any = true;
    const double happened_s = std::min(page_event_ms() / 1000.0, page_now_s());
    page->queue.push(std::move(event), {happened_s, happened_s});
    page_wake();
}

const char* given(std::string text) {
    page->returned = std::move(text);
    return page->returned.c_str();
}

void open_page() {
    if (const std::string trouble = make_context(); !trouble.empty()) return page_tell_trouble(trouble.c_str());
    std::filesystem::create_directories(page_folder);
    std::filesystem::current_path(page_folder);
    Result<Renderer> renderer = Renderer::make();
    if (!renderer) return page_tell_trouble(renderer.error().c_str());
    WindowMemory memory(remembered_file(), false);
    LoadedState state;
    memory.dress(state.params);
    Result<Session> session = Session::begin(state, 0.0);
    if (!session) return page_tell_trouble(session.error().c_str());
    page = std::make_unique<OpenPage>(*std::move(renderer), std::move(memory), *std::move(session));
    page->memory.restore(page->studio.workbench, true);
    if (!page->memory.trouble().empty()) page->studio.session.message = {page->memory.trouble(), true};
    name_imgui_keys();
    ImGuiIO& io = ImGui::GetIO();
    io.GetClipboardTextFn = [](void*) -> const char* { return page->pasted.c_str(); };
    io.SetClipboardTextFn = [](void*, const char* text) {
        page->pasted = text;
        page_copy(text);
    };
    wake_when_work_ends([] {
        page->any = true;
        page_wake();
    });
}

}  // namespace viewing

// Functions called by page.js. Texts are UTF-8; returned texts stay valid until the next call.
extern "C" {
using namespace viewing;

/// Returns 1 once there is something to draw.
EMSCRIPTEN_KEEPALIVE int page_is_open() {
    return page ? 1 : 0;
}

/// Draws a frame of this size in pixels; `scale` is the number of pixels per CSS pixel. Returns the number of seconds
/// until the next frame is due if no event comes; 0 means immediately, and a negative number means never.
EMSCRIPTEN_KEEPALIVE double page_frame(int width_px, int height_px, double scale) {
    if (waits_for_gl()) return 0.0;
    constexpr int frames_after_an_event = 2;
    page->frames_due = std::exchange(page->any, false) ? frames_after_an_event : std::max(page->frames_due - 1, 0);
    refuse_what_is_not_there();
    const InputFrame& frame = page->queue.next_frame(page_now_s());
    feed_imgui(frame, static_cast<float>(scale));
    ImGui::GetIO().DisplayFramebufferScale = {1.0F, 1.0F};
    const glm::ivec2 size_px(width_px, height_px);
    const Requests requests = page->studio.frame({size_px, scale, true, frame.input});
    obey(requests);
    tell_standstill();
    report(page->memory.follow(requests, page->studio.workbench, true));
    page->studio.present();
    page->drawn = page->studio.reads_back() ? gl::Fence::after_all_so_far() : gl::Fence();
    page->drawn_s = page_now_s();
    return page->frames_due > 0 || page->any || !page->queue.is_empty() ? 0.0 : page->studio.redraw_in_s();
}

/// Writes unsaved settings and answers now, because the page may be closed for good.
EMSCRIPTEN_KEEPALIVE void page_keep() {
    report(page->studio.workbench.exercises.desk.finish());
    report(page->memory.finish());
}

/// Call when another tab has written settings or answers. Merges them with this page's, and writes the result now.
EMSCRIPTEN_KEEPALIVE void page_read_again() {
    page->memory.read_again(page->studio.workbench);
    page_keep();
    page->any = true;
    page_wake();
}

EMSCRIPTEN_KEEPALIVE void page_event() {
    page->any = true;
}

/// Moves the pointer. `x` and `y` are in CSS pixels; `is_inside` is 0 if the pointer has left.
EMSCRIPTEN_KEEPALIVE void page_pointer(double x, double y, int is_inside) {
    push(is_inside ? PointerMoved{glm::vec2(x, y)} : PointerMoved{});
}

/// Presses or releases a button: 0 is left, 1 right, 2 middle; a drag with two fingers holds both 1 and 3.
EMSCRIPTEN_KEEPALIVE void page_button(int button, int is_down) {
    if (button >= 0 && button < 5) push(ButtonChanged{static_cast<std::size_t>(button), is_down != 0});
}

/// Call when a finger has been held still. In the camera's picture this asks "Why this pixel?", as a right click does;
/// elsewhere it does nothing, because a right click there resets a slider.
EMSCRIPTEN_KEEPALIVE void page_long_touch() {
    if (!page->studio.workbench.views.hovered_pixel) return;
    page_button(1, 1);
    page_button(1, 0);
}

/// Turns the wheel by a number of lines; left and up are positive.
EMSCRIPTEN_KEEPALIVE void page_wheel(double x, double y) {
    push(WheelTurned{glm::vec2(x, y)});
}

/// Returns 1 if the sandbox uses this key. When embedded, uses_embedded() alone decides.
EMSCRIPTEN_KEEPALIVE int page_key(const char* code, const char* key, int is_down, int ctrl, int shift) {
    const std::optional<KeyChanged> changed = key_changed(code, key, is_down != 0, ctrl != 0, shift != 0);
    if (!changed) return 0;
    const bool is_used = !page->studio.workbench.arrangement.embedded || uses_embedded(*changed);
    // Forward every release, because its press may have been used, and every modifier, because modifiers also change
    // mouse actions.
    if (is_used || !changed->down || changed->kind == KeyKind::modifier) push(*changed);
    return is_used ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE void page_character(unsigned code_point) {
    push(CharacterTyped{code_point});
}

EMSCRIPTEN_KEEPALIVE void page_focus(int is_focused) {
    push(FocusChanged{is_focused != 0});
}

EMSCRIPTEN_KEEPALIVE void page_drop(const char* file) {
    push(FilesDropped{{file}});
}

/// Receives the clipboard's text. Call before the keys that paste it.
EMSCRIPTEN_KEEPALIVE void page_paste(const char* text) {
    page->pasted = takes(text) ? text : "";
}

EMSCRIPTEN_KEEPALIVE void page_open_link(const char* text) {
    if (!takes(text)) return;
    open_link(text);
    push(FocusChanged{true});
}

/// Returns the CSS name of the pointer's shape.
EMSCRIPTEN_KEEPALIVE const char* page_cursor() {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            return "text";
        case ImGuiMouseCursor_ResizeAll:
            return "move";
        case ImGuiMouseCursor_ResizeNS:
            return "ns-resize";
        case ImGuiMouseCursor_ResizeEW:
            return "ew-resize";
        case ImGuiMouseCursor_ResizeNESW:
            return "nesw-resize";
        case ImGuiMouseCursor_ResizeNWSE:
            return "nwse-resize";
        case ImGuiMouseCursor_Hand:
            return "pointer";
        case ImGuiMouseCursor_NotAllowed:
            return "not-allowed";
        default:
            return "default";
    }
}

/// Returns 1 while a text field has the keyboard focus.
EMSCRIPTEN_KEEPALIVE int page_wants_text() {
    return ImGui::GetIO().WantTextInput ? 1 : 0;
}

/// Returns a link to the state or lesson that was opened, as the fragment of an address.
EMSCRIPTEN_KEEPALIVE const char* page_opened() {
    return given(opened_fragment());
}

/// Returns a link to the current state, as the fragment of an address.
EMSCRIPTEN_KEEPALIVE const char* page_link() {
    const Session& session = page->studio.session;
    return given(link_fragment(session.portable(session.params)));
}

/// Returns 1 if the state has changed since it was opened.
EMSCRIPTEN_KEEPALIVE int page_departs() {
    return departs_from_opened() ? 1 : 0;
}

/// page_told() returns the text to read aloud, in the current language; page_matrices_text() returns the matrices.
EMSCRIPTEN_KEEPALIVE const char* page_told() {
    return given(told_text());
}
EMSCRIPTEN_KEEPALIVE const char* page_matrices_text() {
    return given(matrices_text());
}

/// Returns the code of the window's language, such as "en".
EMSCRIPTEN_KEEPALIVE const char* page_language() {
    return given(std::string(name_of(spoken_language())));
}

/// Returns 1 once everything requested is on screen. A blinking caret or a running clock does not matter.
EMSCRIPTEN_KEEPALIVE int page_rests() {
    const Studio& studio = page->studio;
    constexpr double soon_s = 0.2;
    const double next_s = studio.redraw_in_s();
    return page->queue.is_empty() && (next_s < 0.0 || next_s >= soon_s) && !studio.session.awaits_scene() &&
                   studio.session.opening().empty()
               ? 1
               : 0;
}

/// Makes the sandbox part of a host page: no toolbars, and no keys of its own.
EMSCRIPTEN_KEEPALIVE void page_embed() {
    page->studio.workbench.arrangement.embedded = true;
}

/// Turns motion on (1), or off (0) for users who find it disturbing.
EMSCRIPTEN_KEEPALIVE void page_move(int moves) {
    page->studio.workbench.guide.moves = moves != 0;
}

/// For tests: records the rectangles of all controls from the next frame on. page_places() returns them as JSON,
/// {"name": [x, y, width, height]}, in pixels.
EMSCRIPTEN_KEEPALIVE void page_note_places() {
    page->studio.workbench.widgets.record = true;
    push(FocusChanged{true});
}
EMSCRIPTEN_KEEPALIVE const char* page_places() {
    Json places = Json::object();
    for (const widgets::RecordedItem& item : page->studio.workbench.widgets.recorded)
        places[item.window + "/" + item.label] = {item.min.x, item.min.y, item.max.x - item.min.x,
                                                  item.max.y - item.min.y};
    return given(places.dump());
}
}
