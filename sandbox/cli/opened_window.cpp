#include "cli/opened_window.h"

#include <cstdlib>

#include "cli/headless.h"

namespace viewing {

ExitStatus show_window(const LoadedState& state, const WindowStart& start, WindowMemory& memory) {
    constexpr double patience_s = 0.5;
    Session session = value_or_end(Session::begin(state, patience_s));
    require_threads();
    // For tests: a context that checks every call is slower, so this is not the default.
    const bool checks_gl = std::getenv("VIEWING_SANDBOX_CHECK_GL") != nullptr;
    std::vector<std::string> gl_errors;
    value_or_end(run_window(std::move(session), start, memory, static_cast<int>(ExitStatus::no_context),
                            checks_gl ? &gl_errors : nullptr),
                 ExitStatus::no_context);
    if (!gl_errors.empty()) throw Failure(ExitStatus::gl_error, "GL error: " + gl_errors.front());
    return ExitStatus::done;
}

}  // namespace viewing
