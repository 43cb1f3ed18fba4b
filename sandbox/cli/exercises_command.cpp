// exercises: prints the list, prints a student's sheet, and runs the exercises' own tests. Read lesson/exercise.h next.
#include <algorithm>
#include <array>

#include "app/picture.h"
#include "app/step_on_screen.h"
#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/state_arguments.h"
#include "grading/exercise_check.h"
#include "grading/state_numbers.h"
#include "image/compare.h"
#include "lesson/exercise.h"
#include "lesson/notes.h"
#include "state/file/state_json.h"
#include "text/catalogue.h"
#include "text/words.h"

namespace viewing {
namespace {

/// The options as typed.
struct TypedExercises {
    std::vector<std::string> files;
    std::optional<std::string> student, course, set, format, language, device;
    bool solutions = false, test = false, deploy = false;
};

// ---- the list ------------------------------------------------------------------------------------------------------

std::string list_of(const std::vector<Exercise>& exercises) {
    std::string lines;
    int points = 0;
    for (const Exercise& exercise : exercises) {
        points += exercise.points;
        const std::string slides =
            exercise.slides.empty() ? "" : say("slides {slides}", "slides"_a = joined(exercise.slides)) + "; ";
        lines += exercise.id + " — " + exercise.title.shown() + " (" + joined(exercise.sets) + "; " + slides +
                 points_text(exercise.points) + "; " +
                 say_count(std::ssize(exercise.variants), "1 variant", "{count} variants") + ")\n";
    }
    return lines + say_count(std::ssize(exercises), "1 exercise", "{count} exercises") + ", " + points_text(points) +
           "\n";
}

// ---- a student's sheet ---------------------------------------------------------------------------------------------

/// One exercise on a sheet.
struct Question {
    const Sheet::Item& item;
    const LessonStep& step;
    std::string solution;  ///< "" unless requested
};

std::string as_text(const Question& question) {
    const Ask& ask = question.step.ask;
    std::string text =
        question.item.exercise + " · " + question.item.title.shown() + " · " + points_text(question.item.points) + "\n";
    text += wrapped(question.step.say.shown(), 2);
    text += wrapped(ask.question.shown(), 2);
    for (std::size_t i = 0; i < ask.choices.size(); ++i)
        text += wrapped(std::string(1, static_cast<char>('A' + i)) + ". " + ask.choices[i].say.shown(), 4);
    for (const LessonText& item : ask.items) text += wrapped("· " + item.shown(), 4);
    if (!question.solution.empty()) text += wrapped("→ " + question.solution, 2);
    return text + "\n";
}

Json question_as_json(const Question& question) {
    const Ask& ask = question.step.ask;
    Json json = {{"exercise", question.item.exercise}, {"variant", question.item.variant},
                 {"points", question.item.points},     {"values", constants_of(ask)},
                 {"say", question.step.say.shown()},   {"question", ask.question.shown()}};
    for (const LessonChoice& choice : ask.choices) json["choices"].push_back(choice.say.shown());
    for (const LessonText& item : ask.items) json["items"].push_back(item.shown());
    if (!question.solution.empty()) json["solution"] = question.solution;
    return json;
}

void print_sheet(const Options& options, const TypedExercises& typed, const std::vector<Exercise>& exercises) {
    constexpr std::array formats{"text", "json"};
    const bool is_json = choice_option(options, "--format", typed.format.value_or("text"), formats) == 1;
    Headless headless(device_option(options, typed.device));
    const NumbersAt numbers_at = numbers_at_start(&headless.renderer());
    const Lesson made = value_or_end(sheet(exercises, typed.course.value_or(""), *typed.student, numbers_at));
    std::string text;
    Json json = {{"course", made.sheet->course}, {"student", made.sheet->student}, {"exercises", Json::array()}};
    for (std::size_t i = 0; i < made.steps.size(); ++i) {
        const LessonStep& step = made.steps[i];
        const std::string solution =
            typed.solutions ? answer_in_words(step.ask, value_or_end(numbers_at(step.start))) : "";
        const Question question{made.sheet->items[i], step, solution};
        if (is_json)
            json["exercises"].push_back(question_as_json(question));
        else
            text += as_text(question);
    }
    headless.require_no_errors();
    print(is_json ? print_document(json) + "\n" : text);
}

// ---- the exercises' own tests --------------------------------------------------------------------------------------

Image camera_picture(Headless& headless, const LoadedState& state) {
    PictureRequest request;
    request.view = PictureView::camera;
    request.size_px = {640, 360};
    request.samples = 0;
    return headless.drawn(draw_picture(headless.renderer(), state, scene_of(state), request));
}

/// Checks that every fault is visible: if all faults but one are fixed, the picture must still differ from the correct
/// one.
LessonFindings check_visible(const Exercise& exercise, const LessonStep& step, Headless& headless) {
    LessonFindings findings;
    const auto with = [&](const std::vector<std::string>& settings) {
        LoadedState state = step.start;
        state.params = value_or_end(apply_settings(state.params, settings));
        return camera_picture(headless, state);
    };
    const Image right = with(step.ask.model);
    for (std::size_t fault = 0; fault < step.ask.model.size(); ++fault) {
        std::vector<std::string> others = step.ask.model;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(fault));
        const std::int64_t different_px = compare_images(right, with(others)).different;
        if (different_px < exercise.visible_px)
            findings.push_back(exercise.id + ", step " + step.id + ": " + step.ask.model[fault] + " alone fixes " +
                               std::to_string(different_px) + " pixels, fewer than " +
                               std::to_string(exercise.visible_px));
    }
    return findings;
}

ExitStatus test(const std::vector<Exercise>& exercises, const std::string& device) {
    Headless headless(device);
    const Measurer measurer(&headless.renderer());
    const bool is_english = spoken_language() == Language::en;
    std::string lines;
    std::int64_t variants = 0, failures = 0;
    for (const Exercise& exercise : exercises) {
        std::string found;
        int wrong_answers = 0;
        std::int64_t failed = 0;
        for (std::size_t variant = 0; variant < exercise.variants.size(); ++variant) {
            VariantCheck check = check_variant(exercise, variant, measurer);
            if (exercise.visible_px > 0 && check.findings.empty())
                check.findings = check_visible(exercise, *check.step, headless);
            if (is_english && check.findings.empty())  // check_screen() searches English texts
                check.findings = check_screen(exercise.id, *check.step, measurer);
            headless.require_no_errors();
            for (const std::string& finding : check.findings) found += finding + "\n";
            wrong_answers += check.wrong_answers;
            failed += check.findings.empty() ? 0 : 1;
        }
        lines += found + exercise.id + ": " + std::to_string(exercise.variants.size()) + " deployed, " +
                 counted(wrong_answers, "wrong answer") + " distinguished, " +
                 counted(failed, "variant fails", "variants fail") + "\n";
        variants += std::ssize(exercise.variants);
        failures += failed;
    }
    print(lines);
    if (failures > 0)
        throw Failure(ExitStatus::different,
                      "exercises --test: " + counted(failures, "variant fails", "variants fail"));
    print(counted(variants, "variant") + ": right answers accepted, wrong ones refused and distinguished\n");
    return ExitStatus::done;
}

/// Prints the variants to store in each exercise file, so that later versions of the program produce the same sheets.
void print_deployed(const TypedExercises& typed) {
    for (const std::string& file : typed.files) {
        const std::string text = value_or_end(read_text_file(file));
        const std::vector<std::string> all = value_or_end(combinations(text, one_line(file)));
        std::string lines;
        for (std::size_t i = 0; i < std::min(all.size(), most_deployed); ++i)
            lines += (i == 0 ? "\n    " : ",\n    ") + all[i];
        print("  \"deployed\": [" + lines + "\n  ]\n");
    }
}

ExitStatus run_exercises(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedExercises typed;
    options.group("Exercises");
    options.positionals("FILE|DIR", typed.files, "Your own exercises; default: the program's");
    options.text("--set", "NAME|ID,…", typed.set,
                 "Only the exercises listed, by id or by set: camera, hidden, depth, shadow, mirror");
    options.group("A student's sheet");
    options.text("--student", "ID", typed.student, "Prints this student's questions, each with its own numbers");
    options.text("--course", "C", typed.course, "The course; a different course gives different numbers");
    options.flag("--solutions", typed.solutions, "Adds model answers, for the lecturer");
    options.text("--format", "text|json", typed.format, "Format of the sheet; default text");
    options.text("--language", "en|ko", typed.language,
                 "Language of the sheet, or of the texts that --test checks; default en");
    options.group("For authors");
    options.flag("--test", typed.test,
                 "Tests every deployed variant: the model answer is accepted, each listed wrong one is refused and "
                 "distinguished, each fault is visible and, in English, no answer can be read beforehand; exits with "
                 "0, or 1 and a line per failure");
    options.flag("--deploy", typed.deploy,
                 "Prints the variants to store in FILE, so that later versions give the same sheets");
    add_device_option(options, typed.device);
    if (!options.parse(arguments)) return ExitStatus::done;

    if (typed.test + typed.deploy + typed.student.has_value() > 1)
        options.refuse("give only one of --student, --test and --deploy");
    if (!typed.student && (typed.solutions || typed.course || typed.format))
        options.refuse("--solutions, --course and --format need --student ID");
    if (typed.deploy) {
        if (typed.files.empty()) options.refuse("--deploy needs FILE");
        print_deployed(typed);
        return ExitStatus::done;
    }
    speak_option(options, typed.language);
    const std::vector<Exercise> exercises =
        value_or_end(of_set(value_or_end(load_exercises(typed.files)), typed.set.value_or("")));
    if (typed.test) return test(exercises, device_option(options, typed.device));
    if (typed.student)
        print_sheet(options, typed, exercises);
    else
        print(list_of(exercises));
    return ExitStatus::done;
}

}  // namespace

constinit const Command exercises_command{
    "exercises",
    "[FILE|DIR…] [--set NAME] [--student ID [--course C] [--solutions]] [--test]",
    "lists self-checking exercises, prints a student's sheet, runs their tests",
    "Each student has their own numbers, derived only from the student number, the course and the exercise: the same "
    "command always gives the same sheet, and grade derives the same numbers again.",
    "exercises\n"
    "exercises --student 32201234 --course viewing-2026 --set shadow\n"
    "exercises --student 32201234 --course viewing-2026 --solutions --format json\n"
    "exercises --test\n"
    "exercises mine.json --test",
    "0123489",
    run_exercises};

}  // namespace viewing
