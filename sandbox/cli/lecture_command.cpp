// lecture: opens the window in a lecture, which leads through lessons, single steps and presets; or, without a window,
// checks its file, prints its plan, or writes a handout.
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/opened_window.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/lesson_handout.h"
#include "lesson/lesson.h"
#include "text/words.h"

namespace viewing {
namespace {

/// The options as typed.
struct TypedLecture {
    std::vector<std::string> lectures;
    std::optional<std::string> device, step, notes, handout, language, base;
    bool check = false, list = false, presents = false, answers = false;
};

/// Returns the lecture's plan, a line for each part: when it begins, how long it takes, its steps and its title.
std::string plan_of(const Lesson& lecture) {
    std::string lines;
    int from_min = 0;
    for (const Lecture::Part& part : lecture.lecture->parts) {
        lines += fmt::format("{:>4} min  {:>3} min  ", from_min, part.minutes) +
                 (part.lesson.empty() ? "preset" : counted(static_cast<std::int64_t>(part.count), "step")) + "  " +
                 part.title.in_english() + "\n";
        from_min += part.minutes;
    }
    return lines + counted(std::ssize(lecture.lecture->parts), "part") + ", " +
           counted(std::ssize(lecture.steps), "step") + ", " + counted(from_min, "minute") + "\n";
}

/// Returns a lecture; refuses a lesson's name or file.
Lesson lecture_at(const std::string& argument) {
    Lesson lecture = value_or_end(load_lesson(argument));
    if (!lecture.lecture)
        throw Failure(ExitStatus::bad_input, one_line(argument) +
                                                 ": is a lesson, not a lecture: use viewing-sandbox "
                                                 "lesson");
    return lecture;
}

ExitStatus check_lecture(const std::string& argument) {
    const std::vector<std::string> mistakes = value_or_end(lecture_mistakes(argument));
    for (const std::string& mistake : mistakes) print(mistake + "\n");
    if (!mistakes.empty())
        throw Failure(ExitStatus::bad_input, "lecture --check: " + counted(std::ssize(mistakes), "mistake"));
    print(plan_of(lecture_at(argument)));
    return ExitStatus::done;
}

ExitStatus write_lecture_handout(const Options& options, const TypedLecture& typed, const std::string& argument,
                                 std::span<const FileArgument> files) {
    const FileArgument handout_file{"--handout", *typed.handout};
    check_outputs(options, {&handout_file, 1}, files);
    check_page_name(options, "--handout", *typed.handout);
    write_handout(lecture_at(argument), *typed.handout, typed.answers, device_option(options, typed.device),
                  language_option(options, typed.language).value_or(Language::en));
    return ExitStatus::done;
}

ExitStatus show_lecture(const Options& options, const TypedLecture& typed, const std::string& argument,
                        std::span<const FileArgument> files) {
    const FileArgument notes{"--notes", typed.notes.value_or("")};
    check_apart(options, {&notes, 1}, files);
    Lesson lecture = lecture_at(argument);
    const int count = static_cast<int>(lecture.steps.size());
    const int step = typed.step ? whole_option(options, "--step", *typed.step, 1, count) : 1;
    WindowMemory memory(remembered_file(), false);
    WindowStart start;
    start.link_address = address_option(options, "--base", typed.base);
    LoadedState state = lecture.steps[step - 1].start;
    start.lesson = LessonPicture{std::move(lecture), static_cast<std::size_t>(step - 1), false, typed.presents, true};
    start.notes = typed.notes.value_or("");
    memory.dress(state.params);
    if (const auto language = language_option(options, typed.language)) state.params.ui.language = *language;
    return show_window(state, start, memory);
}

ExitStatus run_lecture(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedLecture typed;
    options.group("Lecture");
    options.positionals("ID|FILE", typed.lectures,
                        "A lecture's name (--list) or your own file; default: the lecture of 75 minutes");
    options.text("--step", "N", typed.step, "Step to begin with, counted from 1 through all parts");
    options.flag("--present", typed.presents, "For a lecture room: full screen, large type, a clicker's keys");
    options.text("--notes", "terminal|window|FILE", typed.notes,
                 "Shows the lecturer's notes, with the part, its planned minutes and the clock: in this terminal, in a "
                 "separate window, or in a file rewritten at each change");
    options.text("--language", "en|ko", typed.language,
                 "Language of the window or the handout; default: the one last chosen, English for a handout");
    options.text("--base", "ADDRESS", typed.base, base_help);
    options.group("Without a window");
    options.text("--handout", "OUT.html", typed.handout,
                 "Writes the lecture for printing, a page per step; - for standard output");
    options.flag("--answers", typed.answers, "Adds the answers");
    options.flag("--check", typed.check,
                 "Names every mistake in the file; if there is none, prints the parts with their times and the total "
                 "of minutes");
    options.flag("--list", typed.list, "Prints the lectures that come with the program, one per line");
    add_device_option(options, typed.device);
    if (!options.parse(arguments)) return ExitStatus::done;

    if (typed.check && typed.list) options.refuse("give only one of --check and --list");
    if (typed.lectures.size() > 1) options.refuse("give only one lecture");
    const std::vector<LessonFile> own = lectures();
    if (typed.list) {
        speak_option(options, typed.language);
        std::string lines;
        for (const LessonFile& file : own)
            lines += file.id + " — " + file.title.shown() + " (" + std::to_string(file.minutes) + " min)\n";
        print(lines);
        return ExitStatus::done;
    }
    check_handout(options, typed.handout, typed.answers, typed.presents || typed.step || typed.notes);
    if (typed.lectures.empty() && own.empty())
        throw Failure(ExitStatus::bad_input, "there are no lectures: " + assets_problem());
    const std::string argument = typed.lectures.empty() ? own.front().id : typed.lectures.front();
    std::vector<FileArgument> files;
    if (!typed.lectures.empty()) add_file_if_there(files, "the lecture", argument);
    if (typed.check) return check_lecture(argument);
    if (typed.handout) return write_lecture_handout(options, typed, argument, files);
    return show_lecture(options, typed, argument, files);
}

}  // namespace

constinit const Command lecture_command{
    "lecture",
    "[ID|FILE] [--present] [--notes terminal|window|FILE] [OPTIONS]",
    "opens the window in a lecture: lessons, steps and presets one after another",
    "A lecture is a JSON file that lists parts, each with its minutes: a lesson, some of a lesson's steps, or a "
    "preset. Page Down leads from its beginning to its end; after a lesson, a card says what was seen and what comes "
    "next.",
    "lecture --present --notes window\n"
    "lecture mine.json\n"
    "lecture --check mine.json\n"
    "lecture --handout lecture.html --answers --language ko\n"
    "lecture --list",
    "0123489",
    run_lecture};

}  // namespace viewing
