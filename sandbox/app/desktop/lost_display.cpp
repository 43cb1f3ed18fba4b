#include "app/desktop/lost_display.h"

#include <dlfcn.h>
#include <unistd.h>

#include <string_view>

namespace viewing {
namespace {

int status_when_lost = 0;

[[noreturn]] void end_saying(std::string_view sentence) {
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    ::_exit(status_when_lost);
}

/// Exits, because Xlib does not allow its handler to return, and without the display neither GL nor GLFW can be closed.
int on_lost_display(void*) {
    end_saying("the window's display is gone\n");
}

/// Exits with one sentence; Xlib's own handler would print five lines and exit with 1. If another program destroys the
/// window, the display also counts as lost.
int on_x_error(void* /*display*/, void* /*event*/) {
    end_saying("the window is gone: the display no longer accepts its drawing\n");
}

/// Installs a handler with Xlib's function `setter`, which takes the new handler and returns the old one.
template <typename Handler>
void set_handler(void* xlib, const char* setter, Handler handler) {
    if (const auto set = reinterpret_cast<Handler (*)(Handler)>(::dlsym(xlib, setter))) set(handler);
}

}  // namespace

void end_when_display_is_lost(int exit_status) {
    // GLFW loads Xlib itself; linking it here would require it on systems without X.
    void* xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (!xlib) return;
    status_when_lost = exit_status;
    set_handler(xlib, "XSetIOErrorHandler", on_lost_display);
    set_handler(xlib, "XSetErrorHandler", on_x_error);
    ::dlclose(xlib);  // GLFW's own reference keeps it loaded
}

}  // namespace viewing
