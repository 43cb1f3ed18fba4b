// Drops files onto a window, as a file manager does (XDND): `drop-files WINDOW FILE…`. The exit status is 1 if
// the window does not accept them.
#include <poll.h>
#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace {

class Source {
public:
    Source(Display* display, Window target, std::string files)
        : display_(display), target_(target), files_(std::move(files)) {
        own_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
        XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
    }

    bool drop() {
        tell("XdndEnter", 5L << 24, static_cast<long>(list_));
        constexpr long middle = 300L << 16 | 300L;
        tell("XdndPosition", 0, middle, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
        if (!hears("XdndStatus")) return false;
        tell("XdndDrop", 0, CurrentTime);
        return hears("XdndFinished");
    }

private:
    Atom atom(const char* name) { return XInternAtom(display_, name, False); }

    void tell(const char* what, long second, long third = 0, long fourth = 0, long fifth = 0) {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(what);
        event.xclient.format = 32;
        const long data[] = {static_cast<long>(own_), second, third, fourth, fifth};
        for (int i = 0; i < 5; ++i) event.xclient.data.l[i] = data[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    /// Waits for the window's answer and sends the files if the window requests them.
    bool hears(const char* what) {
        for (int waits = 0; waits < 60;) {
            if (XPending(display_) == 0) {
                pollfd connection{ConnectionNumber(display_), POLLIN, 0};
                constexpr int second_ms = 1000;
                if (poll(&connection, 1, second_ms) == 0) ++waits;
                continue;
            }
            XEvent event;
            XNextEvent(display_, &event);
            if (event.type == SelectionRequest) give(event.xselectionrequest);
            if (event.type == ClientMessage && event.xclient.message_type == atom(what)) return true;
        }
        return false;
    }

    void give(const XSelectionRequestEvent& asked) {
        XChangeProperty(display_, asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(files_.data()), static_cast<int>(files_.size()));
        XEvent event{};
        event.xselection.type = SelectionNotify;
        event.xselection.requestor = asked.requestor;
        event.xselection.selection = asked.selection;
        event.xselection.target = asked.target;
        event.xselection.property = asked.property;
        event.xselection.time = asked.time;
        XSendEvent(display_, asked.requestor, False, NoEventMask, &event);
        XFlush(display_);
    }

    Display* display_;
    Window target_, own_ = 0;
    std::string files_;
    Atom list_ = atom("text/uri-list");
};

}  // namespace

int main(int argc, char** argv) {
    Display* display = XOpenDisplay(nullptr);
    if (!display || argc < 3) {
        std::fprintf(stderr, "usage: DISPLAY=… drop-files WINDOW FILE…\n");
        return 2;
    }
    std::string files;
    for (int i = 2; i < argc; ++i) files += "file://" + std::filesystem::absolute(argv[i]).string() + "\r\n";
    const bool is_taken = Source(display, std::strtoul(argv[1], nullptr, 0), files).drop();
    XCloseDisplay(display);
    return is_taken ? 0 : 1;
}
