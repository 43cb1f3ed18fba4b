#include "app/desktop/lost_display.h"

#include <dlfcn.h>
#include <unistd.h>

#include <string_view>

namespace viewing {
namespace {

int status_when_lost = 0;

/// Xlib does not allow its handler to return, and nothing of GL or GLFW can be closed without the display.
int on_lost_display(void*) {
    constexpr std::string_view sentence = "the display of the window is gone\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    ::_exit(status_when_lost);
}

/// Xlib's own would print five lines and end with 1. Whose window another program has destroyed has lost it.
int on_x_error(void* /*display*/, void* /*event*/) {
    constexpr std::string_view sentence = "the window is gone: the display refuses what is drawn into it\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    ::_exit(status_when_lost);
}

}  // namespace

void end_when_display_is_lost(int exit_status) {
    using Handler = int (*)(void* display);
    using SetHandler = Handler (*)(Handler);
    // GLFW loads Xlib itself; linking it here would demand it on systems without X.
    void* xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (!xlib) return;
    status_when_lost = exit_status;
    if (const auto set_handler = reinterpret_cast<SetHandler>(::dlsym(xlib, "XSetIOErrorHandler")))
        set_handler(on_lost_display);
    using ErrorHandler = int (*)(void* display, void* event);
    using SetErrorHandler = ErrorHandler (*)(ErrorHandler);
    if (const auto set_handler = reinterpret_cast<SetErrorHandler>(::dlsym(xlib, "XSetErrorHandler")))
        set_handler(on_x_error);
    ::dlclose(xlib);  // GLFW's own hold on it stays
}

}  // namespace viewing
