#include "app/window_memory.h"

#include <utility>

#include "state/language.h"
#include "text/catalogue.h"

namespace viewing {

WindowMemory::WindowMemory(std::filesystem::path file, bool is_fresh) : file_(std::move(file)) {
    std::error_code unknown;
    is_first_time_ = is_fresh || !std::filesystem::exists(file_, unknown);
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
    if (now == remembered_) return std::monostate{};
    remembered_ = now;
    return write_remembered(file_, now);
}

}  // namespace viewing
