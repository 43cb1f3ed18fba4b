// grade: hand-ins judged again, as a table, a page, or for a program. Read report/grading.h for how.
#include <algorithm>
#include <array>
#include <cstdio>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/grade_report.h"
#include "cli/results/grade_tables.h"
#include "cli/results/hand_in_files.h"
#include "cli/time_limit.h"
#include "cli/values.h"
#include "platform/file.h"
#include "platform/heap.h"
#include "report/grading.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> grade_formats{"text", "csv", "json"};
enum class Format { text, csv, json };

/// The options as they were typed.
struct TypedGrade {
    std::vector<std::string> files, exercises;
    std::optional<std::string> format, set, course, html, output, device;
    bool tags = false;
};

void declare(Options& options, TypedGrade& typed) {
    options.group("Hand-ins");
    options.positionals("FILE|DIR", typed.files,
                        "What students handed in, or folders of it: the .json files in them and in their folders, "
                        "by their paths; links are not followed, hidden ones are skipped");
    options.text("--course", "C", typed.course,
                 "The course that students were given their numbers by, in place of what each file says: a file that "
                 "names another is noted");
    options.group("Exercises");
    options.text("--set", "NAME|ID,ID", typed.set,
                 "Only those of a set (camera, hidden, depth, shadow, mirror), or these; what is not asked for does "
                 "not count");
    options.texts("--exercises", "FILE|DIR", typed.exercises,
                  "A lecturer's own exercises in place of the program's; may be given several times");
    options.group("Output");
    options.text("--format", "FORMAT", typed.format, "text (default), csv or json");
    options.flag("--tags", typed.tags,
                 "How many students showed which misconception: below the text's table, in place of the csv's");
    options.text("-o,--output", "OUT", typed.output, "Where the table goes; default -, standard output");
    options.text("--html", "REPORT.html", typed.html,
                 "Writes a page for the lecturer: points, misconceptions, every attempt, and pictures of what wrong "
                 "shadow and mirror matrices do");
    add_device_option(options, typed.device);
}

/// The .json files of a folder by name, or the argument itself.
std::vector<fs::path> files_of(const std::string& argument) {
    std::error_code error;
    if (!fs::is_directory(argument, error)) return {argument};
    return files_in(argument, ".json");
}

std::vector<FileArgument> inputs_of(const TypedGrade& typed, const HandInFiles& found) {
    std::vector<FileArgument> inputs;
    for (const fs::path& file : found.files) inputs.push_back({"a hand-in", file.string()});
    for (const std::string& argument : typed.exercises)
        for (const fs::path& file : files_of(argument)) inputs.push_back({"--exercises", file.string()});
    return inputs;
}

StudentGrade not_read(const std::string& file, const std::string& why) {
    StudentGrade grade;
    grade.file = file;
    grade.error = why;
    return grade;
}

std::vector<StudentGrade> graded(const TypedGrade& typed, const HandInFiles& found, Grader& grader) {
    std::vector<StudentGrade> grades;
    for (const std::string& trouble : found.troubles) grades.push_back(not_read(trouble, trouble));
    for (const fs::path& path : found.files) {
        const std::string file = one_line(path.string());
        Result<HandIn> hand_in = load_hand_in(path);
        grades.push_back(hand_in ? grader.grade(*std::move(hand_in), file, typed.course)
                                 : not_read(file, hand_in.error()));
    }
    compare_hand_ins(grades);
    return grades;
}

std::string table(Format format, bool with_tags, const std::vector<Exercise>& exercises,
                  const std::vector<StudentGrade>& grades, const std::vector<TagCount>& tags,
                  const HandInFiles& found) {
    if (format == Format::json) return grades_as_json(exercises, grades, tags, found);
    if (format == Format::csv) return with_tags ? tags_as_csv(tags) : grades_as_csv(exercises, grades);
    return grades_as_text(exercises, grades) + (with_tags && !tags.empty() ? "\n" + tags_as_text(tags) : "") +
           (found.has_folders ? "\n" + files_in_words(grades, found) + "\n" : "");
}

bool is_cut(const StudentGrade& grade) {
    return grade.is_cut;
}

bool is_all_right(const StudentGrade& grade) {
    return grade.is_all_right();
}

/// "3 of 12 hand-ins are"
std::string how_many(const std::vector<StudentGrade>& grades, bool (*are)(const StudentGrade&)) {
    return std::to_string(std::count_if(grades.begin(), grades.end(), are)) + " of " + std::to_string(grades.size()) +
           " hand-ins are";
}

/// Throws Failure unless everything was judged, read and is right. `skipped`: "", or how many files were, and why.
void end_by(const std::vector<StudentGrade>& grades, const std::string& skipped) {
    const std::string behind = skipped.empty() ? "" : "; " + skipped;
    if (std::any_of(grades.begin(), grades.end(), is_cut))
        throw Failure(ExitStatus::out_of_time, TimeLimit::sentence() + "; " + how_many(grades, is_cut) +
                                                   " not judged to the end, and marked" + behind);
    const auto is_broken = [](const StudentGrade& grade) { return !grade.error.empty(); };
    const auto first = std::find_if(grades.begin(), grades.end(), is_broken);
    if (first != grades.end()) {
        const auto more = std::count_if(std::next(first), grades.end(), is_broken);
        throw Failure(ExitStatus::bad_input,
                      first->error +
                          (more > 0 ? "; " + std::to_string(more) + " more cannot be read, as the table says" : "") +
                          behind);
    }
    if (!std::all_of(grades.begin(), grades.end(), is_all_right))
        throw Failure(ExitStatus::different, "grade: " + how_many(grades, is_all_right) + " all right" + behind);
}

ExitStatus run_grade(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedGrade typed;
    declare(options, typed);
    constexpr unsigned grace_s = 30;
    options.keep_what_is_done(grace_s,
                              "Judges no further answer after so many seconds, writes what there is, marks the rest "
                              "as not judged, and exits 8: within 30 seconds more");
    if (!options.parse(arguments)) return ExitStatus::done;

    if (typed.files.empty()) options.refuse("a hand-in is missing: " + std::string(self.synopsis));
    const auto format =
        static_cast<Format>(choice_option(options, "--format", typed.format.value_or("text"), grade_formats));
    const std::string output = typed.output.value_or("-");
    std::vector<FileArgument> outputs{{"-o", output}};
    if (typed.html) outputs.push_back({"--html", *typed.html});
    const HandInFiles found = hand_in_files(typed.files);
    check_outputs(options, outputs, inputs_of(typed, found));
    std::vector<Exercise> exercises = value_or_end(load_exercises(typed.exercises));
    std::vector<std::string> known;
    for (const Exercise& exercise : exercises) known.push_back(exercise.id);
    exercises = value_or_end(of_set(std::move(exercises), typed.set.value_or("")));

    give_large_blocks_back();
    Headless headless(device_option(options, typed.device));
    Grader grader(std::move(exercises), headless.renderer());
    grader.also_know(std::move(known));
    grader.stop_when(TimeLimit::has_run_out, "the time of --timeout ran out");
    const std::vector<StudentGrade> grades = graded(typed, found, grader);
    headless.require_no_errors();
    const std::vector<TagCount> tags = count_tags(grader.exercises(), grades);
    const std::string files = files_in_words(grades, found);
    Outputs results;
    results.add(output, table(format, typed.tags, grader.exercises(), grades, tags, found));
    if (typed.html) results.add(*typed.html, grade_report(headless, grader, grades, tags, files));
    results.write();
    const std::string skipped = found.skipped.empty() ? "" : files;
    end_by(grades, skipped);
    if (format == Format::csv && !skipped.empty())  // the other forms have it in themselves
        std::fprintf(stderr, "grade: %s\n", skipped.c_str());
    return ExitStatus::done;
}

}  // namespace

constinit const Command grade_command{
    "grade",
    "FILE|DIR… [--format text|csv|json] [--set NAME] [--tags] [--html REPORT.html] [OPTIONS]",
    "hand-ins judged again: points, misconceptions, every attempt",
    "Trusts a hand-in's student number, answers and changes only: the student's variants are picked again, and every "
    "answer is judged again. A cell is the points of a right answer, p1 for one that is partly right, w or w:M33 for a "
    "wrong one and the misconception it shows, - where there is none, v! where it is the answer to a variant that is "
    "not this student's, ? where it could not be judged. first try counts the exercises that were right at once, of "
    "those that were tried. Notes are what somebody might look at, and judge nothing: the same times of attempts or "
    "the same changes in two files, all right within seconds, another student's variant. A file that cannot be read "
    "costs its own line alone, and one with more answers than one file may cost has the last, the first and the latest "
    "of the others judged, which its notes say. In csv, first_try is a number and a missing answer an empty cell. The "
    "exit status is 0 "
    "when everybody has everything right, 1 when somebody has not, 2 when a file cannot be read.",
    "grade hand-ins\n"
    "grade hand-ins --set shadow --tags\n"
    "grade hand-ins --course viewing-2026 --format csv -o grades.csv --html report.html\n"
    "grade 32201234.json --exercises mine.json --format json",
    "0123489",
    run_grade};

}  // namespace viewing
