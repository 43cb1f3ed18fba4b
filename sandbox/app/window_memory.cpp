#include "app/window_memory.h"

#include <utility>

#include "platform/file.h"
#include "state/person/language.h"
#include "text/catalogue.h"

namespace viewing {

WindowMemory::WindowMemory(std::filesystem::path file, bool is_fresh) : file_(std::move(file)) {
    is_first_time_ = is_fresh || !is_there(file_);
    if (is_fresh) {
        std::error_code failed;
        if (!file_.empty()) std::filesystem::remove(file_, failed);
        if (failed) trouble_ = file_.string() + ": " + failed.message();
        return;
    }
    if (Result<Remembered> read = read_remembered(file_))
        remembered_ = *read;
    else
        trouble_ = say("{error}; the window starts as the first time", "error"_a = read.error());
}

void WindowMemory::dress(Params& params) const {
    if (params.ui != UiParams{}) return;
    params.ui.language = remembered_.language.value_or(system_language());
    params.ui.theme = remembered_.theme.value_or(params.ui.theme);
    params.ui.scale = remembered_.scale.value_or(params.ui.scale);
}

Status WindowMemory::remember(const Remembered& now) {
    const std::optional<Status> ended = writing_.take();
    is_written_ &= now == remembered_;
    remembered_ = now;
    if (!is_written_ && !writing_.is_running()) {
        is_written_ = true;
        writing_.start([file = file_, now](WorkProgress&) { return write_remembered(file, now); });
    }
    return ended.value_or(std::monostate{});
}

Status WindowMemory::follow(const Requests& requests, const Workbench& workbench, bool keeps_answers) {
    Remembered now = remembered_;
    if (requests.chosen_theme) now.theme = requests.chosen_theme;
    if (requests.chosen_language) now.language = requests.chosen_language;
    if (requests.chosen_scale) now.scale = requests.chosen_scale;
    now.lessons = workbench.progress;
    now.recent = workbench.recent;
    if (keeps_answers) now.student = workbench.exercises.student();
    return remember(now);
}

void WindowMemory::restore(Workbench& workbench, bool keeps_answers) const {
    workbench.progress = remembered_.lessons;
    workbench.recent = remembered_.recent;
    if (!keeps_answers) return;
    const std::filesystem::path file = remembered_file();
    workbench.exercises.keep_in(file.empty() ? file : file.parent_path() / "answers", VIEWING_SANDBOX_VERSION);
    workbench.exercises.sit_down(remembered_.student);
}

Status WindowMemory::finish() {
    writing_.wait(-1.0);
    Status last = writing_.take().value_or(std::monostate{});
    if (!std::exchange(is_written_, true)) last = write_remembered(file_, remembered_);
    return last;
}

}  // namespace viewing
