// lesson: opens the window in a lesson; or, without a window, prints handouts, runs the lessons' tests, or lists the
// names that expressions may use.
#include <algorithm>

#include "app/picture.h"
#include "app/step_on_screen.h"
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/opened_window.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/lesson_handout.h"
#include "grading/lesson_check.h"
#include "lesson/formulas/names.h"
#include "lesson/lesson.h"
#include "platform/file.h"
#include "state/scene.h"
#include "text/catalogue.h"
#include "text/words.h"

namespace viewing {
namespace {

/// The options as typed.
struct TypedLesson {
    std::vector<std::string> lessons;
    std::optional<std::string> device, step, notes, base, handout, language;
    bool check = false, names = false, list = false, presents = false, answers = false;
};

std::string list_of_lessons() {
    std::string lines;
    for (const LessonFile& file : lessons()) {
        lines += file.id + " — " + file.title.shown() + " (" +
                 say("slides {slides}; {minutes} min; {steps}", "slides"_a = joined(file.slides),
                     "minutes"_a = file.minutes, "steps"_a = say_count(file.steps, "one step", "{count} steps")) +
                 ")\n";
    }
    return lines;
}

/// Tests that both pictures of a step can be drawn, before and after the answer.
LessonFindings draw_step(const Lesson& lesson, const LessonStep& step, Headless& headless) {
    LessonFindings findings;
    for (const Params* const params : {&step.start.params, &step.revealed}) {
        LoadedState state = step.start;
        state.params = *params;
        const Result<Scene> scene = load_scene(state.params.scene, state.base, state.params.coplanar,
                                               {.origin = state.scene_origin, .reach = state.reach});
        if (!scene) return findings;  // check_step has reported the error
        PictureRequest request;
        request.view = PictureView::camera;
        request.size_px = {640, 360};
        const Result<Image> drawn = draw_picture(headless.renderer(), state, *scene, request);
        if (!drawn) findings.push_back(lesson.id + ", step " + step.id + ": " + drawn.error());
    }
    headless.require_no_errors();
    return findings;
}

ExitStatus check(const TypedLesson& typed, const std::string& device) {
    std::vector<std::string> wanted = typed.lessons;
    if (wanted.empty())
        for (const LessonFile& file : lessons()) wanted.push_back(file.path.string());
    std::vector<Lesson> read;
    std::vector<std::string> broken;
    for (const std::string& argument : wanted) {
        Result<Lesson> lesson = load_lesson(argument);
        if (lesson) {
            read.push_back(*std::move(lesson));
            continue;
        }
        std::vector<std::string> mistakes;
        if (const Result<std::string> text = read_text_file(argument))
            mistakes = lesson_mistakes(*text, argument, std::filesystem::path(argument).parent_path());
        if (mistakes.empty()) mistakes.push_back(lesson.error());
        broken.insert(broken.end(), mistakes.begin(), mistakes.end());
    }
    if (broken.size() == 1) throw Failure(ExitStatus::bad_input, broken.front());
    if (!broken.empty()) {
        for (const std::string& mistake : broken) print(mistake + "\n");
        throw Failure(ExitStatus::bad_input, "lesson --check: " + counted(std::ssize(broken), "mistake"));
    }
    Headless headless(device);
    const Measurer measurer(&headless.renderer());
    std::string findings;
    std::int64_t steps = 0;
    for (const Lesson& lesson : read) {
        for (const LessonStep& step : lesson.steps) {
            for (const std::string& found : check_step(lesson, step, measurer)) findings += found + "\n";
            for (const std::string& found : draw_step(lesson, step, headless)) findings += found + "\n";
            for (const std::string& found : check_screen(lesson.id, step, measurer)) findings += found + "\n";
            headless.require_no_errors();
        }
        steps += std::ssize(lesson.steps);
    }
    if (findings.empty()) {
        print(counted(std::ssize(read), "lesson") + ", " + counted(steps, "step") +
              ": claims hold, answers are judged correctly and cannot be read beforehand, every step can be drawn\n");
        return ExitStatus::done;
    }
    print(findings);
    const auto count = std::count(findings.begin(), findings.end(), '\n');
    throw Failure(ExitStatus::different, "lesson --check: " + counted(count, "finding"));
}

/// Returns the lessons given as files, without the built-in ones.
std::vector<FileArgument> lesson_files(const TypedLesson& typed) {
    std::vector<FileArgument> files;
    for (const std::string& lesson : typed.lessons) add_file_if_there(files, "the lesson", lesson);
    return files;
}

ExitStatus write_lesson_handout(const Options& options, const TypedLesson& typed) {
    if (typed.lessons.size() != 1) options.refuse("--handout needs one lesson");
    const FileArgument handout_file{"--handout", *typed.handout};
    check_outputs(options, {&handout_file, 1}, lesson_files(typed));
    check_page_name(options, "--handout", *typed.handout);
    write_handout(value_or_end(load_lesson(typed.lessons.front())), *typed.handout, typed.answers,
                  device_option(options, typed.device),
                  language_option(options, typed.language).value_or(Language::en));
    return ExitStatus::done;
}

/// Opens the window in the lesson, or on the page of all lessons if none is named.
ExitStatus show_lesson(const Options& options, const TypedLesson& typed) {
    if (typed.lessons.size() > 1) options.refuse("the window shows one lesson; --check takes several");
    WindowMemory memory(remembered_file(), false);
    WindowStart start;
    start.link_address = address_option(options, "--base", typed.base);
    LoadedState state = value_or_end(load_state(""));
    if (typed.lessons.empty()) {
        if (typed.presents || typed.step || typed.notes) options.refuse("--present, --step and --notes need a lesson");
        start.shows_lessons = true;
    } else {
        const FileArgument notes{"--notes", typed.notes.value_or("")};
        check_apart(options, {&notes, 1}, lesson_files(typed));
        Lesson lesson = value_or_end(load_lesson(typed.lessons.front()));
        const LessonsProgress& progress = memory.remembered().lessons;
        const auto known = progress.find(lesson.id);
        const int count = static_cast<int>(lesson.steps.size());
        std::size_t step = known == progress.end() || typed.presents ? 0 : known->second.step;
        if (typed.step) step = static_cast<std::size_t>(whole_option(options, "--step", *typed.step, 1, count) - 1);
        step = std::min(step, lesson.steps.size() - 1);
        state = lesson.steps[step].start;
        start.lesson = LessonPicture{std::move(lesson), step, false, typed.presents, true};
        start.notes = typed.notes.value_or("");
    }
    memory.dress(state.params);
    if (const auto language = language_option(options, typed.language)) state.params.ui.language = *language;
    return show_window(state, start, memory);
}

ExitStatus run_lesson(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedLesson typed;
    options.group("Lesson");
    options.positionals("ID|FILE", typed.lessons, "A lesson's name (--list) or your own file; --check takes several");
    options.text("--step", "N", typed.step, "Step to begin with, counted from 1; default: where you left off");
    options.flag("--present", typed.presents, "For a lecture room: full screen, large type, a clicker's keys");
    options.text("--notes", "terminal|window|FILE", typed.notes,
                 "Shows the lecturer's notes while the audience sees the step: in this terminal, in a separate window, "
                 "or in a file rewritten at each change");
    options.text("--base", "ADDRESS", typed.base, base_help);
    options.text("--language", "en|ko", typed.language,
                 "Language of the window or the handout; default: the one last chosen, English for a handout");
    options.group("Without a window");
    options.text("--handout", "OUT.html", typed.handout,
                 "Writes the lesson for printing, a page per step; - for standard output");
    options.flag("--answers", typed.answers, "Adds the answers");
    options.flag(
        "--check", typed.check,
        "Tests the named lessons, or all of the program's: claims, model answers, wrong answers, that no answer can be "
        "read beforehand, and that every step can be drawn; exits with 0, or 1 and a line per failure");
    options.flag("--names", typed.names, "Prints the names that expressions may use");
    options.flag("--list", typed.list, "Prints the lessons that come with the program, one per line");
    add_device_option(options, typed.device);
    if (!options.parse(arguments)) return ExitStatus::done;

    if (typed.check + typed.names + typed.list > 1) options.refuse("give only one of --check, --names and --list");
    if (typed.names) {
        print(expression_names_as_text());
        return ExitStatus::done;
    }
    if (typed.list) {
        speak_option(options, typed.language);
        print(list_of_lessons());
        return ExitStatus::done;
    }
    if (typed.check) return check(typed, device_option(options, typed.device));
    check_handout(options, typed.handout, typed.answers, typed.presents || typed.step || typed.notes);
    if (typed.handout) return write_lesson_handout(options, typed);
    return show_lesson(options, typed);
}

}  // namespace

constinit const Command lesson_command{"lesson",
                                       "[ID|FILE] [--step N] [--present] [--notes terminal|window|FILE] [OPTIONS]",
                                       "opens the window in a guided lesson: each step asks before it shows",
                                       "A lesson is a JSON file of steps, each with a full state, a question, the "
                                       "answers that people give, and what to show afterwards.",
                                       "lesson view-is-the-inverse\n"
                                       "lesson depth-fighting --present\n"
                                       "lesson --list\n"
                                       "lesson --check mine.json\n"
                                       "lesson --names",
                                       "0123489",
                                       run_lesson};

}  // namespace viewing
