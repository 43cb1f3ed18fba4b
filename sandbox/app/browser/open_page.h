// The state of the page, shared by the two files that page.js calls into: page.cpp handles events, frames and the text
// that the user sees; requests.cpp handles requests by name.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/studio.h"
#include "app/window_memory.h"
#include "gl/fence.h"
#include "state/presets.h"
#include "ui/parts/input_queue.h"

namespace viewing {

/// Lives as long as the page.
struct OpenPage {
    Renderer renderer;
    WindowMemory memory;
    Studio studio;
    InputQueue queue;
    std::vector<NamedFile> presets = viewing::presets();
    std::string pasted;    ///< the clipboard, as the page sent it
    std::string returned;  ///< the latest text returned to the page
    int frames_due = 0;
    bool any = true;  ///< something has happened since the last frame
    gl::Fence drawn;  ///< signaled once the latest frame has been drawn
    double drawn_s = 0.0;

    OpenPage(Renderer made, WindowMemory remembered, Session session)
        : renderer(std::move(made)), memory(std::move(remembered)), studio(renderer, std::move(session)) {}
};

/// Null until there is something to draw.
extern std::unique_ptr<OpenPage> page;

/// The folder for input files, and for output files until the page delivers them to the user.
inline constexpr const char* page_folder = "/files";

double page_now_s();

/// Queues an event and wakes the page, so that the next frame comes immediately.
void push(InputEvent event);

/// Returns the text in the form that page.js reads. It stays valid until the next call.
const char* given(std::string text);

/// Returns why a text of this size is rejected, as one sentence with the size and the limit; "" if it is accepted.
/// Every text from outside is checked twice: by page.js before it is copied, and on arrival.
std::string text_trouble(std::size_t bytes);

/// Returns whether the text is accepted; if not, the window says why.
bool takes(const char* text);

/// Refuses a state's request to read a file that the page does not have. A page has only the files that it was given,
/// so asking the user for permission would not help.
void refuse_what_is_not_there();

}  // namespace viewing
