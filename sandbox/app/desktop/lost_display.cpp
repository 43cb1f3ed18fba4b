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

/// Xlib does not allow its handler to return, and nothing of GL or GLFW can be closed without the display.
int on_lost_display(void*) {
    end_saying("the display of the window is gone\n");
}

/// Xlib's own would print five lines and end with 1. Whose window another program has destroyed has lost it.
int on_x_error(void* /*display*/, void* /*event*/) {
    end_saying("the window is gone: the display refuses what is drawn into it\n");
}

/// By Xlib's function of this name, which takes and gives back a handler.
template <typename Handler>
void set_handler(void* xlib, const char* setter, Handler handler) {
    if (const auto set = reinterpret_cast<Handler (*)(Handler)>(::dlsym(xlib, setter))) set(handler);
}

}  // namespace

void end_when_display_is_lost(int exit_status) {
    // GLFW loads Xlib itself; linking it here would demand it on systems without X.
    void* xlib = ::dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
    if (!xlib) return;
    status_when_lost = exit_status;
    set_handler(xlib, "XSetIOErrorHandler", on_lost_display);
    set_handler(xlib, "XSetErrorHandler", on_x_error);
    ::dlclose(xlib);  // GLFW's own hold on it stays
}

}  // namespace viewing
