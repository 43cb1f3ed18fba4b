// open: the window on screen.
#include "cli/commands.h"
#include "cli/options.h"
#include "cli/state_arguments.h"
#include "cli/window_commands.h"

namespace viewing {
namespace {

ExitStatus run(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    bool is_fresh = false;
    options.group("Window");
    options.flag("--fresh", is_fresh,
                 "Forgets the theme, the scale and the window's size and place of the last time, which are remembered "
                 "in $XDG_CONFIG_HOME/viewing-sandbox/window.json (~/.config where that is not set)");
    if (!options.parse(arguments)) return ExitStatus::done;

    LoadedState state = state_arguments.load();
    WindowMemory memory(remembered_file(), is_fresh);
    memory.dress(state.params);
    WindowStart start;
    start.shows_lessons = memory.is_first_time() && !state_arguments.are_given();
    // What is wrong with the scene is said before there is a window, unless it takes long to find out.
    constexpr double patience_s = 0.5;
    Session session = value_or_end(Session::begin(state, patience_s));
    return show_window(std::move(session), start, memory);
}

}  // namespace

constinit const Command open_command{"open",
                                     "[STATE] [--set PATH=VALUE]… [--fresh]",
                                     "the window: panel, views, matrices (what happens without a command)",
                                     "Opens the window with a state. The word open may be left out.",
                                     "\n"
                                     "open mine.json\n"
                                     "--set camera.navigation=walk --set scene=walkthrough\n"
                                     "bunny.obj",
                                     "023489",
                                     run};

}  // namespace viewing
