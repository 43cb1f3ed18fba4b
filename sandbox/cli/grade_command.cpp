// grade: regrades hand-ins, and writes a table, a page, or JSON. Read grading/grading.h next.
#include <algorithm>
#include <array>
#include <cstdio>

#include "cli/commands.h"
#include "cli/headless.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/results/grade_report.h"
#include "cli/results/grade_tables.h"
#include "cli/results/hand_in_files.h"
#include "cli/time_limit.h"
#include "grading/grading.h"
#include "platform/file.h"
#include "platform/heap.h"
#include "text/words.h"

namespace viewing {
namespace {

namespace fs = std::filesystem;

constexpr std::array<const char*, 3> grade_formats{"text", "csv", "json"};
enum class Format { text, csv, json };

/// The options as typed.
struct TypedGrade {
    std::vector<std::string> files, exercises;
    std::optional<std::string> format, set, course, html, output, device, language;
    bool tags = false, bom = false;
};

void declare(Options& options, TypedGrade& typed) {
    options.group("Hand-ins");
    options.positionals("FILE|DIR", typed.files,
                        "Hand-ins, or folders of hand-ins: all .json files in them and their subfolders, sorted by "
                        "path; links are not followed, hidden files are skipped");
    options.text("--course", "C", typed.course,
                 "The course from which the students' numbers were derived, instead of the one in each file; a file "
                 "that names another gets a note");
    options.group("Exercises");
    options.text("--set", "NAME|ID,…", typed.set,
                 "Only the exercises listed, by id or by set (camera, hidden, depth, shadow, mirror); others do not "
                 "count");
    options.texts("--exercises", "FILE|DIR", typed.exercises,
                  "Your own exercises instead of the program's; repeatable");
    options.group("Output");
    options.text("--format", "FORMAT", typed.format, "text (default), csv or json");
    options.flag("--tags", typed.tags,
                 "Counts the students with each misconception: below the text table, instead of the csv table");
    options.flag("--bom", typed.bom, "Begins csv with a byte order mark: Excel then reads names as UTF-8");
    options.text("--language", "en|ko", typed.language, "Language of the page, titles and feedback; default en");
    options.text("-o,--output", "OUT", typed.output, "File for the table; default -, standard output");
    options.text("--html", "REPORT.html", typed.html,
                 "Writes a page for the lecturer: points, misconceptions, every attempt, and pictures of what wrong "
                 "shadow and mirror matrices do");
    add_device_option(options, typed.device);
}

/// Returns the .json files in a folder, sorted by name, or the argument itself if it is not a folder.
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
        Result<ReadableHandIn> handed_in = load_readable_hand_in(path);
        grades.push_back(handed_in ? grader.grade(*std::move(handed_in), file, typed.course)
                                   : not_read(file, handed_in.error()));
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
           (found.has_folders ? "\n" + files_in_words(grades, found) + "\n" + not_json_in_lines(found) : "");
}

bool is_cut(const StudentGrade& grade) {
    return grade.is_cut;
}

bool is_all_right(const StudentGrade& grade) {
    return grade.is_all_right();
}

/// Returns, for example, "3 of 12 hand-ins are".
std::string how_many(const std::vector<StudentGrade>& grades, bool (*are)(const StudentGrade&)) {
    return std::to_string(std::count_if(grades.begin(), grades.end(), are)) + " of " + std::to_string(grades.size()) +
           " hand-ins are";
}

/// Throws Failure unless all hand-ins could be read, were fully judged and are correct. `skipped` says how many files
/// were skipped and why, or is "".
void end_by(const std::vector<StudentGrade>& grades, const std::string& skipped) {
    const std::string behind = skipped.empty() ? "" : "; " + skipped;
    if (std::any_of(grades.begin(), grades.end(), is_cut))
        throw Failure(ExitStatus::out_of_time, TimeLimit::sentence() + "; " + how_many(grades, is_cut) +
                                                   " not fully judged, and marked as such" + behind);
    const auto is_broken = [](const StudentGrade& grade) { return !grade.error.empty(); };
    const auto first = std::find_if(grades.begin(), grades.end(), is_broken);
    if (first != grades.end()) {
        const auto more = std::count_if(std::next(first), grades.end(), is_broken);
        throw Failure(ExitStatus::bad_input,
                      first->error +
                          (more > 0 ? "; " + std::to_string(more) + " more cannot be read (see the table)" : "") +
                          behind);
    }
    if (!std::all_of(grades.begin(), grades.end(), is_all_right))
        throw Failure(ExitStatus::different, "grade: " + how_many(grades, is_all_right) + " fully correct" + behind);
}

ExitStatus run_grade(const Command& self, const Arguments& arguments) {
    Options options(self);
    TypedGrade typed;
    declare(options, typed);
    constexpr unsigned grace_s = 30;
    options.keep_what_is_done(grace_s,
                              "Stops judging after S seconds, writes the results so far, marks the rest as not judged, "
                              "and exits with status 8 within another 30 seconds");
    if (!options.parse(arguments)) return ExitStatus::done;

    if (typed.files.empty()) options.refuse("no hand-in given: " + std::string(self.synopsis));
    const auto format =
        static_cast<Format>(choice_option(options, "--format", typed.format.value_or("text"), grade_formats));
    if (typed.bom && format != Format::csv) options.refuse("--bom needs --format csv");
    speak_option(options, typed.language);
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
    Grader grader(std::move(exercises), &headless.renderer());
    grader.also_know(std::move(known));
    grader.stop_when(TimeLimit::has_run_out, "--timeout expired");
    const std::vector<StudentGrade> grades = graded(typed, found, grader);
    headless.require_no_errors();
    const std::vector<TagCount> tags = count_tags(grader.exercises(), grades);
    const std::string files = files_in_words(grades, found);
    Outputs results;
    results.add(output,
                (typed.bom ? "\xEF\xBB\xBF" : "") + table(format, typed.tags, grader.exercises(), grades, tags, found));
    if (typed.html) results.add(*typed.html, grade_report(headless, grader, grades, tags, files));
    results.write();
    const std::string skipped = found.skipped.empty() ? "" : files;
    end_by(grades, skipped);
    if (format == Format::csv && !skipped.empty())  // the other formats report the skipped files
        std::fprintf(stderr, "grade: %s\n", skipped.c_str());
    return ExitStatus::done;
}

}  // namespace

constinit const Command grade_command{
    "grade",
    "FILE|DIR… [--format text|csv|json] [--set NAME] [--tags] [--html REPORT.html] [OPTIONS]",
    "judges hand-ins again: points, misconceptions, every attempt",
    "Trusts only the student number, answers and changes in a hand-in: derives the student's variants again, and "
    "judges every answer again. A cell shows the points for a right answer, p1 for a partly right one, w or w:M33 for "
    "a wrong one and the misconception it shows, - for a missing one, v! for an answer to a variant that is not this "
    "student's, ? for one that could not be judged. first try counts the exercises that were right on the first "
    "attempt, out of those tried. Notes point out answers that may deserve a look, without a judgment: the same times "
    "of attempts or the same changes in two files, everything right within seconds, another student's variant. A file "
    "that cannot be read costs only its own line, and an answer that cannot be read only itself: a note names its "
    "place in the file. In a file with too many answers, the last, the first and the latest "
    "that the file marks as right are judged, and its notes say so. In csv, first_try is a number and a missing answer "
    "an empty cell. The exit status is 0 if everybody has everything right, 1 if somebody does not, 2 if a file cannot "
    "be read.",
    "grade hand-ins\n"
    "grade hand-ins --set shadow --tags\n"
    "grade hand-ins --course viewing-2026 --format csv -o grades.csv --html report.html\n"
    "grade 32201234.json --exercises mine.json --format json",
    "0123489",
    run_grade};

}  // namespace viewing
