// Everything of the one page, for the two files that page.js calls: page.cpp has events, frames and what a person is
// shown, requests.cpp what is asked by name.
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
    std::string pasted;    ///< the clipboard, as the page brought it
    std::string returned;  ///< the latest text given to the page
    int frames_due = 0;
    bool any = true;  ///< something happened
    gl::Fence drawn;  ///< behind the latest frame
    double drawn_s = 0.0;

    OpenPage(Renderer made, WindowMemory remembered, Session session)
        : renderer(std::move(made)), memory(std::move(remembered)), studio(renderer, std::move(session)) {}
};

/// Null until there is something to be drawn.
extern std::unique_ptr<OpenPage> page;

/// Where the page keeps what is to be read, and what was written before it is handed over.
inline constexpr const char* page_folder = "/files";

double page_now_s();

/// Hands an event to the next frame, which comes at once.
void push(InputEvent event);

/// The text as page.js reads it: it stays until the next call.
const char* given(std::string text);

/// Why a text of so many bytes is not taken, one sentence with its size and the limit; "": it is. Every text that comes
/// into the page from outside is checked with it twice: by page.js before it is copied, and where it arrives.
std::string text_trouble(std::size_t bytes);

/// Whether the text is taken; else the window says why not.
bool takes(const char* text);

/// A page has the files alone that were given to it: there is nothing else that a state could read with a yes.
void refuse_what_is_not_there();

}  // namespace viewing
