#include "app/window_memory.h"

#include <utility>

#include "platform/file.h"
#include "state/person/language.h"
#include "text/catalogue.h"

namespace viewing {

WindowMemory::WindowMemory(std::filesystem::path file, bool is_fresh) : file_(std::move(file)) {
    is_first_time_ = is_fresh || !is_there(file_);
    Result<Remembered> read = read_remembered(file_);
    if (is_fresh) {
        if (read) {
            remembered_.lessons = read->lessons;
            remembered_.recent = read->recent;
            remembered_.student = read->student;
        }
        known_ = remembered_;
        std::error_code failed;
        if (!file_.empty()) std::filesystem::remove(file_, failed);
        if (failed) trouble_ = file_.string() + ": " + failed.message();
        if (failed || remembered_ == Remembered{}) return;
        if (const Status written = write_remembered(file_, remembered_); !written) trouble_ = written.error();
        return;
    }
    if (read)
        known_ = remembered_ = *read;
    else
        trouble_ = say("{error}; the window starts with its defaults", "error"_a = read.error());
}

void WindowMemory::dress(Params& params) const {
    if (params.ui != UiParams{}) return;
    params.ui.language = remembered_.language.value_or(system_language());
    params.ui.theme = remembered_.theme.value_or(params.ui.theme);
    params.ui.scale = remembered_.scale.value_or(params.ui.scale);
}

Status WindowMemory::take_written() {
    const std::optional<Result<Remembered>> ended = writing_.take();
    if (!ended) return std::monostate{};
    if (!*ended) return Error{ended->error()};
    // Adopt changes by other windows, but not their appearance or their student. If both windows remember a step of the
    // same lesson, keep this window's step: two windows that copied each other's step would never settle.
    Remembered written = **ended;
    for (auto& [id, progress] : written.lessons)
        if (const auto own = sent_.lessons.find(id); own != sent_.lessons.end()) progress.step = own->second.step;
    const Remembered now = merged(written, sent_, remembered_);
    has_news_ |= now.lessons != remembered_.lessons || now.recent != remembered_.recent;
    remembered_.lessons = now.lessons;
    remembered_.recent = now.recent;
    known_ = sent_;
    known_.lessons = std::move(written.lessons);
    known_.recent = std::move(written.recent);
    return std::monostate{};
}

Status WindowMemory::remember(const Remembered& now) {
    is_written_ &= now == remembered_;
    remembered_ = now;
    Status ended = take_written();
    if (!is_written_ && !writing_.is_running()) {
        is_written_ = true;
        sent_ = remembered_;
        writing_.start(
            [file = file_, known = known_, now = sent_](WorkProgress&) { return merge_remembered(file, known, now); });
    }
    return ended;
}

Status WindowMemory::follow(const Requests& requests, Workbench& workbench, bool keeps_answers) {
    Remembered now = remembered_;
    if (requests.chosen_theme) now.theme = requests.chosen_theme;
    if (requests.chosen_language) now.language = requests.chosen_language;
    if (requests.chosen_scale) now.scale = requests.chosen_scale;
    now.mouse = workbench.views.mouse;
    now.lessons = workbench.past.progress;
    now.lesson = workbench.past.last_lesson;
    now.recent = workbench.past.recent;
    if (keeps_answers) now.student = workbench.exercises.desk.student();
    Status status = remember(now);
    if (std::exchange(has_news_, false)) {
        workbench.past.progress = remembered_.lessons;
        workbench.past.recent = remembered_.recent;
    }
    return status;
}

void WindowMemory::read_again(Workbench& workbench) {
    is_written_ = false;  // the next write merges with the content of the file
    workbench.exercises.desk.read_again();
}

void WindowMemory::restore(Workbench& workbench, bool keeps_answers) const {
    workbench.past.progress = remembered_.lessons;
    workbench.past.last_lesson = remembered_.lesson;
    workbench.past.recent = remembered_.recent;
    workbench.views.mouse = remembered_.mouse;
    if (!keeps_answers) return;
    const std::filesystem::path file = remembered_file();
    workbench.exercises.desk.keep_in(file.empty() ? file : file.parent_path() / "answers", VIEWING_SANDBOX_VERSION);
    workbench.exercises.desk.sit_down(remembered_.student);
}

Status WindowMemory::finish() {
    writing_.wait(-1.0);
    Status last = take_written();
    if (is_written_ && remembered_ == known_) return last;  // otherwise, values have changed or writing has failed
    const Result<Remembered> written = merge_remembered(file_, known_, remembered_);
    is_written_ = false;  // if the window stays open, follow() adopts what other windows have added
    if (!written) return Error{written.error()};
    Remembered known = remembered_;
    known.lessons = std::move(known_.lessons);
    known.recent = std::move(known_.recent);
    known_ = std::move(known);
    return last;
}

}  // namespace viewing
