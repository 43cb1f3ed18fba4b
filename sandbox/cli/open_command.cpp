// open: opens the window on screen.
#include "cli/commands.h"
#include "cli/opened_window.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/state_arguments.h"
#include "lesson/exercise.h"

namespace viewing {
namespace {

/// Opens the window with the sheet of the student whose hand-in was given as STATE.
ExitStatus show_hand_in(const Options& options, const StateArguments& arguments, const std::string& exercise,
                        bool replays, WindowMemory& memory) {
    if (arguments.as_typed().empty()) options.refuse("--exercise needs a hand-in as STATE");
    WindowStart start;
    start.hand_in = value_or_end(load_hand_in(arguments.as_typed()));
    const std::vector<Exercise> all = value_or_end(load_exercises({}));
    start.exercise = all[value_or_end(find_exercise(all, exercise))].id;
    start.replays = replays;
    LoadedState state = value_or_end(load_state(""));
    state.params.ui = arguments.looks();
    memory.dress(state.params);
    return show_window(state, start, memory);
}

ExitStatus run_open(const Command& self, const Arguments& arguments) {
    Options options(self);
    const StateArguments state_arguments(options);
    bool is_fresh = false;
    options.group("Window");
    options.flag("--fresh", is_fresh,
                 "Forgets the last theme, scale, language, window size and position, which are remembered in "
                 "$XDG_CONFIG_HOME/viewing-sandbox/window.json (~/.config if that is not set); keeps lesson progress, "
                 "recent files and the student");
    std::optional<std::string> base, exercise;
    options.text("--base", "ADDRESS", base, base_help);
    bool replays = false;
    options.group("Exercise");
    options.text("--exercise", "ID", exercise, "For a hand-in as STATE: shows the student's work on this exercise");
    options.flag("--replay", replays, "Also plays the changes that led there");
    if (!options.parse(arguments)) return ExitStatus::done;

    if (replays && !exercise) options.refuse("--replay needs --exercise ID");
    WindowMemory memory(remembered_file(), is_fresh);
    if (exercise) return show_hand_in(options, state_arguments, *exercise, replays, memory);
    LoadedState state = state_arguments.load();
    memory.dress(state.params);
    WindowStart start;
    start.link_address = address_option(options, "--base", base);
    if (std::optional<LinkedStep> linked = state_arguments.linked_step()) {
        if (!state_arguments.say_only_looks())
            options.refuse(
                "a lesson's step has its own state, so --mesh is not allowed and --set takes only ui.… fields");
        start.lesson = LessonPicture{std::move(linked->lesson), linked->step, false, false, true};
    }
    start.shows_lessons = memory.is_first_time() && !state_arguments.are_given();
    return show_window(state, start, memory);
}

}  // namespace

constinit const Command open_command{
    "open",
    "[STATE] [--set PATH=VALUE]… [--fresh] [--base ADDRESS] [--exercise ID [--replay]]",
    "opens the window with panel, views and matrices (the default command)",
    "Opens the window with a state. The word open may be left out.",
    "\n"
    "open mine.json\n"
    "--set camera.navigation=walk --set scene=walkthrough\n"
    "bunny.obj\n"
    "open 32201234.json --exercise E18 --replay",
    "023489",
    run_open};

}  // namespace viewing
