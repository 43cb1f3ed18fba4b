// Reads and writes a session's files in the background: the old state stays until the new one is loaded. Read
// platform/background.h for the background tasks.
#include <algorithm>

#include "platform/file.h"
#include "session/session.h"
#include "state/file/link.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"

namespace viewing {
namespace {

/// Most scenes load quickly, so a short wait avoids a frame with the old scene.
constexpr double a_moment_s = 0.02;

/// Whether two scenes look the same, so that nothing needs to be redrawn.
bool is_same(const Scene& a, const Scene& b) {
    return a.made_from == b.made_from &&
           std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                      [](const SceneObject& one, const SceneObject& other) {
                          return one.mesh == other.mesh && one.description == other.description;
                      });
}

}  // namespace

Result<Session> Session::begin(const LoadedState& state, double patience_s) {
    LoadedState opening;
    opening.params.ui = state.params.ui;
    Result<Scene> scene = load_scene(opening.params.scene, {}, opening.params.coplanar);
    if (!scene) return Error{scene.error()};
    Session session(opening, *std::move(scene));
    session.start_reading({.state = state, .is_whole = true, .is_first = true});
    session.reading_.wait(patience_s);
    session.has_just_begun_ = false;
    session.update_scene();
    if (const std::optional<Status> outcome = session.take_outcome(); outcome && !*outcome)
        return Error{outcome->error()};
    return session;
}

void Session::start_reading(Wanted wanted) {
    wanted_ = std::move(wanted);
    question_.reset();
    if (wanted_->is_whole) outcome_.reset();  // drops the outcome of the previous open()
    const LoadedState& known = wanted_->state;
    const bool is_there = wanted_->argument.empty() && known.params.scene == loaded_source_ &&
                          (known.base == loaded_base_ || scene_.read.empty());
    if (is_there) {
        reading_.drop();
        return end_reading(Arrived{known, scene_, {}});
    }
    has_just_begun_ = true;
    reading_.start([wanted = *wanted_, allowed = allowed_](WorkProgress& progress) -> Result<Arrived> {
        Arrived arrived{wanted.state, {}, {}};
        if (!wanted.argument.empty()) {
            Result<LoadedState> state = load_state(wanted.argument);
            if (!state) return Error{state.error()};
            arrived.state = *std::move(state);
        }
        FileReach reach = arrived.state.reach;
        reach.add(allowed);
        const Params& read = arrived.state.params;
        Result<Scene> scene = load_scene(
            read.scene, arrived.state.base, read.coplanar,
            {.progress = &progress, .origin = arrived.state.scene_origin, .reach = reach, .outside = &arrived.outside});
        if (!arrived.outside.empty()) return arrived;
        if (!scene) return Error{scene.error()};
        arrived.scene = *std::move(scene);
        return arrived;
    });
}

void Session::update_scene() {
    take_written();
    if (question_) return;
    const bool awaits = awaits_scene();
    const bool is_overtaken = wanted_ && (wanted_->is_whole ? awaits
                                                            : !awaits || wanted_->state.params.scene != params.scene ||
                                                                  wanted_->state.base != base_);
    if (is_overtaken) {
        wanted_.reset();
        reading_.drop();
    }
    if (!wanted_ && awaits) {
        LoadedState state;
        state.params = params;
        state.base = base_;
        state.reach = {false, {}};
        start_reading({.state = std::move(state)});
    }
    if (!wanted_) {
        steps_back_ = 0;
        return remake_scene();
    }
    if (std::exchange(has_just_begun_, false)) reading_.wait(a_moment_s);
    if (std::optional<Result<Arrived>> arrived = reading_.take()) end_reading(*std::move(arrived));
}

void Session::end_reading(Result<Arrived> result) {
    if (result && !result->outside.empty()) {
        const std::string& origin = result->state.scene_origin;  // "room.json: scene"
        question_ = OutsideFile{result->outside, origin.substr(0, origin.rfind(": "))};
        outcome_ = Status(std::monostate{});
        return;
    }
    const Wanted wanted = *std::exchange(wanted_, std::nullopt);
    if (!result) {
        message = {result.error(), true};
        if (wanted.is_whole)
            outcome_ = Status(Error{result.error()});
        else
            keep_scene();
        return;
    }
    for (const std::filesystem::path& file : result->scene.read) allowed_.add(file);
    if (wanted.is_whole) {
        take_over_looks(result->state.params, wanted.may_be_silent);
        params = result->state.params;
        flight_ = result->state.flight;
        preset_ = result->state.preset;
        base_ = result->state.base;
        begin_here();
        motion_ = {};
        outcome_ = Status(std::monostate{});
    }
    if (wanted.told) message = {*wanted.told, false};
    if (const std::vector<std::string>& notes = result->scene.notes; !notes.empty())
        message = {fmt::format("{}", fmt::join(notes, "; ")), false};
    steps_back_ = 0;
    loaded_source_ = params.scene;
    loaded_base_ = base_;
    scene_.file = result->scene.file;
    if (!is_same(scene_, result->scene)) {
        scene_ = std::move(result->scene);
        ++scene_version_;
    }
    if (wanted.is_first && !history_.can_undo()) {
        history_ = History(now());
        at_rest_ = before_ = params;
    }
}

UiParams Session::own_looks() const {
    const auto is_shown = [this](UiParams looks) {
        looks.language = params.ui.language;
        return looks == params.ui;
    };
    // Appearance settings chosen since the state was opened are the user's own.
    UiParams own = lent_looks_ && is_shown(lent_looks_->shown) ? lent_looks_->own : params.ui;
    own.language = params.ui.language;
    return own;
}

void Session::take_over_looks(Params& opened, bool may_be_silent) {
    const UiParams own = own_looks();
    if (may_be_silent && opened.ui == UiParams{}) opened.ui = own;
    opened.ui.language = own.language;
    lent_looks_.reset();
    if (opened.ui != own) lent_looks_ = {opened.ui, own};
    if (may_be_silent && opened.view.layout == LayoutParams{}) opened.view.layout = params.view.layout;
}

void Session::answer(bool may_read) {
    if (!question_) return;
    const std::filesystem::path file = std::exchange(question_, std::nullopt)->file;
    if (may_read) {
        allowed_.add(file.parent_path());
        return start_reading(*std::exchange(wanted_, std::nullopt));
    }
    if (!std::exchange(wanted_, std::nullopt)->is_whole) keep_scene();
    message = {say("{file} was not read: nothing changed", "file"_a = file.string()), false};
}

void Session::take_written() {
    const std::optional<Result<std::monostate>> written = writing_.take();
    if (!written) return;
    message = *written ? StatusMessage{written_, false} : StatusMessage{written->error(), true};
    outcome_ = *written;
}

void Session::keep_scene() {
    wanted_.reset();
    reading_.drop();
    for (; steps_back_ > 0; --steps_back_)
        if (const std::optional<Step> later = history_.redo()) take_over(*later);
    for (; steps_back_ < 0; ++steps_back_)
        if (const std::optional<Step> earlier = history_.undo()) take_over(*earlier);
    params.scene = loaded_source_;
    base_ = loaded_base_;
}

void Session::finish_loading() {
    writing_.wait(-1.0);
    update_scene();
    while (reading_.is_running()) {
        reading_.wait(-1.0);
        update_scene();
    }
}

std::optional<float> Session::loading_fraction() const {
    if (!reading_.is_running()) return std::nullopt;
    return reading_.fraction();
}

std::string Session::loading_name() const {
    if (!wanted_) return {};
    if (!wanted_->argument.empty()) return wanted_->argument;
    if (const auto* name = std::get_if<std::string>(&wanted_->state.params.scene)) return *name;
    const SceneDescription& scene = std::get<SceneDescription>(wanted_->state.params.scene);
    return scene.objects.empty() ? tr("scene") : scene.objects.front().name;
}

void Session::cancel_loading() {
    if (!wanted_) return;
    if (wanted_->is_whole) {
        wanted_.reset();
        reading_.drop();
        outcome_ = Status(std::monostate{});
    } else {
        keep_scene();
    }
    message = {tr("loading canceled: the scene is unchanged"), false};
}

void Session::replace(const LoadedState& state) {
    start_reading({.state = state, .is_whole = true});
}

void Session::open(const std::string& argument) {
    if (is_obj_file(argument)) {
        params.scene = std::filesystem::absolute(argument).string();
        allowed_.add(argument);
        return;
    }
    start_reading({.argument = argument,
                   .is_whole = true,
                   .may_be_silent = true,
                   .told = say("opened {file}", "file"_a = argument)});
}

const std::string& Session::opening() const {
    static const std::string nothing;
    return wanted_ ? wanted_->argument : nothing;
}

Status Session::paste(const std::string& text) {
    const std::string told = tr("state pasted from the clipboard");
    if (is_link(text)) {
        Result<LoadedState> linked = load_state(text);
        if (!linked) return Error{linked.error()};
        start_reading({.state = *std::move(linked), .is_whole = true, .may_be_silent = true, .told = told});
        return std::monostate{};
    }
    Result<StateDocument> pasted = parse_state_document(text, "clipboard");
    if (!pasted) return Error{pasted.error()};
    LoadedState state;
    state.params = std::move(pasted->params);
    state.flight = std::move(pasted->flight);
    state.scene_origin = "clipboard: scene";
    state.reach = {false, {}};
    start_reading({.state = std::move(state), .is_whole = true, .told = told});
    return std::monostate{};
}

Params Session::portable(Params own) const {
    // A path relative to the state's folder means nothing elsewhere. The names of built-in scenes stay as they are.
    const auto from_root = [this](const std::filesystem::path& file) {
        return std::filesystem::absolute(base_ / file).lexically_normal().string();
    };
    if (auto* name = std::get_if<std::string>(&own.scene)) {
        if (!awaits_scene() && !scene_.file.empty())
            *name = std::filesystem::absolute(scene_.file).lexically_normal().string();
    } else {
        for (ObjectDescription& object : std::get<SceneDescription>(own.scene).objects)
            if (object.shape == ShapeKind::mesh) object.file = from_root(object.file);
    }
    return own;
}

std::string Session::text() const {
    return write_state(portable(params));
}

void Session::write(std::function<Status()> work, std::string told) {
    written_ = std::move(told);
    outcome_.reset();
    writing_.start([work = std::move(work)](WorkProgress&) { return work(); });
}

void Session::save(const std::filesystem::path& file) {
    write([file, whole = text()] { return write_file(file, whole); }, say("saved {file}", "file"_a = file.string()));
}

}  // namespace viewing
