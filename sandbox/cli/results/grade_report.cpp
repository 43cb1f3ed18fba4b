#include "cli/results/grade_report.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/picture.h"
#include "cli/option_values.h"
#include "cli/results/grade_tables.h"
#include "cli/state_arguments.h"
#include "image/png.h"
#include "lesson/questions/typed_matrix.h"
#include "state/person/language.h"
#include "text/catalogue.h"
#include "text/html.h"
#include "text/words.h"

namespace viewing {
namespace {

constexpr const char* report_style = R"(
@page { size: A4; margin: 16mm }
body { font: 11pt/1.4 Inter, "NanumBarunGothic", "Noto Sans KR", "DejaVu Sans", sans-serif; color: #15181d;
       max-width: 190mm; margin: 8mm auto; padding: 0 4mm }
h1 { font-size: 18pt; margin: 0 }
h2 { font-size: 13pt; margin: 9mm 0 2mm }
p { margin: 1mm 0; color: #5a6470 }
svg { display: block; font-size: 11px }
table { border-collapse: collapse; width: 100% }
th { text-align: left; font-weight: 600; color: #5a6470 }
th, td { padding: 1mm 3mm 1mm 0; border-bottom: 0.2mm solid #dde2e8; vertical-align: top }
.number { text-align: right; font-variant-numeric: tabular-nums }
table.matrix { width: auto; border-left: 0.3mm solid #8a94a0; border-right: 0.3mm solid #8a94a0 }
.matrix td { border: 0; padding: 0 2mm; text-align: right; font-variant-numeric: tabular-nums }
details { border-bottom: 0.2mm solid #dde2e8; padding: 1.5mm 0 }
summary { cursor: pointer }
summary b { display: inline-block; min-width: 28mm }
.swatch { display: inline-block; width: 10px; height: 10px; vertical-align: middle }
.pair { display: flex; flex-wrap: wrap; gap: 4mm; margin: 4mm 0; break-inside: avoid }
figure { margin: 0 }
figcaption { font-size: 9pt; color: #5a6470 }
img { display: block; border: 0.3mm solid #c5ccd4; border-radius: 1mm }
)";

/// Makes text from a hand-in safe to show: escapes markup, and characters that change the writing direction.
std::string foreign(const std::string& text) {
    return escaped(printable(text));
}

std::string heading(const char* text) {
    return "<h2>" + std::string(tr(text)) + "</h2>\n";
}

std::vector<const StudentGrade*> read_ones(const std::vector<StudentGrade>& grades) {
    std::vector<const StudentGrade*> read;
    for (const StudentGrade& grade : grades)
        if (grade.error.empty()) read.push_back(&grade);
    return read;
}

std::string title(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades,
                  const std::string& files) {
    std::set<std::string> courses, students;
    for (const StudentGrade* const grade : read_ones(grades)) {
        courses.insert(grade->hand_in.course);
        students.insert(grade->hand_in.student);
    }
    std::string of_courses;
    for (const std::string& course : courses)
        if (!course.empty()) of_courses += (of_courses.empty() ? "" : ", ") + foreign(course);
    int points = 0;
    for (const Exercise& exercise : exercises) points += exercise.points;
    std::string text = "<h1>" + std::string(tr("Exercises")) + (of_courses.empty() ? "" : ": " + of_courses) +
                       "</h1>\n<p>" + say_count(std::ssize(students), "1 student", "{count} students") + ", " +
                       say_count(std::ssize(exercises), "1 exercise", "{count} exercises") + ", " +
                       points_text(points) + "</p>\n<p>" + escaped(files) + "</p>\n";
    for (const StudentGrade& grade : grades)
        if (!grade.error.empty()) text += "<p>" + say("Not read: {error}", "error"_a = foreign(grade.error)) + "</p>\n";
    return text;
}

// ---- points --------------------------------------------------------------------------------------------------------

/// The distribution of the students' points; each bar covers a range of `width` points.
struct Histogram {
    int width = 1;
    std::vector<int> bars;

    std::string label(std::size_t bar) const {
        const int first = static_cast<int>(bar) * width;
        return std::to_string(first) + (width == 1 ? "" : "–" + std::to_string(first + width - 1));
    }
};

Histogram histogram_of(const std::vector<const StudentGrade*>& grades) {
    constexpr int most_bars = 16;
    int of = 0;
    for (const StudentGrade* const grade : grades) of = std::max(of, grade->of());
    Histogram histogram;
    histogram.width = of / most_bars + 1;
    histogram.bars.assign(static_cast<std::size_t>(of / histogram.width + 1), 0);
    for (const StudentGrade* const grade : grades) ++histogram.bars[grade->points() / histogram.width];
    return histogram;
}

std::string points_chart(const std::vector<StudentGrade>& grades) {
    constexpr double width = 680.0, height = 150.0, top = 18.0, below = 38.0, gap = 3.0;
    const Histogram histogram = histogram_of(read_ones(grades));
    const int most = std::max(1, *std::max_element(histogram.bars.begin(), histogram.bars.end()));
    const double step = width / static_cast<double>(histogram.bars.size());
    std::string svg = fmt::format(
        "<svg class=\"histogram\" role=\"img\" aria-label=\"{2}\" "
        "viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
        "text-anchor=\"middle\">\n",
        width, top + height + below, tr("Students by points"));
    for (std::size_t bar = 0; bar < histogram.bars.size(); ++bar) {
        const int count = histogram.bars[bar];
        const double tall = height * count / most, middle = (static_cast<double>(bar) + 0.5) * step;
        svg += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#2f7de1\"/>",
                           middle - step / 2 + gap / 2, top + height - tall, step - gap, tall);
        if (count > 0)
            svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", middle, top + height - tall - 4.0, count);
        svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"#5a6470\">{}</text>\n", middle, top + height + 15.0,
                           histogram.label(bar));
    }
    svg += fmt::format("<path d=\"M0 {0:g}H{1:g}\" stroke=\"#8a94a0\"/>\n", top + height, width);
    return svg + fmt::format("<text x=\"{:g}\" y=\"{:g}\" fill=\"#5a6470\">{}</text>\n</svg>\n", width / 2,
                             top + height + 33.0, tr("points"));
}

// ---- misconceptions ------------------------------------------------------------------------------------------------

std::string share_cell(int students, int of) {
    constexpr double width = 110.0;
    const double part = share(students, of);
    return fmt::format(
        "<td><svg width=\"{0:g}\" height=\"12\"><rect width=\"{0:g}\" height=\"12\" fill=\"#eef2f6\"/>"
        "<rect width=\"{1:.1f}\" height=\"12\" fill=\"#cf5a3c\"/></svg>{2}</td>",
        width, width * part, escaped(percent(part, 0)));
}

std::string misconceptions(const std::vector<TagCount>& tags) {
    if (tags.empty()) return "<p>" + std::string(tr("No misconceptions were found.")) + "</p>\n";
    std::string table =
        fmt::format("<table>\n<tr><th></th><th>{}</th><th>{}</th><th>{}</th><th class=\"number\">{}</th></tr>\n",
                    tr("misconception"), tr("shown by"), tr("on the last attempt"), tr("of students"));
    for (const TagCount& tag : tags)
        table += "<tr><td>" + escaped(tag.tag) + "</td><td>" + escaped(tag.text.shown()) + "</td>" +
                 share_cell(tag.students, tag.students_of) + share_cell(tag.at_last, tag.students_of) +
                 "<td class=\"number\">" + std::to_string(tag.students_of) + "</td></tr>\n";
    return table + "</table>\n";
}

// ---- exercises -----------------------------------------------------------------------------------------------------

/// A student's result in an exercise, as one of the kinds that the bars distinguish.
enum class AnswerOutcome { at_once, later, partly, wrong, set_aside, missing };
struct OutcomeLook {
    const char *name, *color;
};
constexpr std::array<OutcomeLook, 6> outcome_looks{{{marked("right on first try"), "#2e7d4f"},
                                                    {marked("right later"), "#86bf9a"},
                                                    {marked("partly right"), "#e3b341"},
                                                    {marked("wrong"), "#cf5a3c"},
                                                    {marked("not judged"), "#8a63b8"},
                                                    {marked("missing"), "#d5dae0"}}};
using OutcomeCounts = std::array<int, outcome_looks.size()>;

AnswerOutcome outcome_of(const ItemGrade& item) {
    switch (item.standing) {
        case Standing::right:
            return item.at_first_try ? AnswerOutcome::at_once : AnswerOutcome::later;
        case Standing::partly:
            return AnswerOutcome::partly;
        case Standing::wrong:
            return AnswerOutcome::wrong;
        case Standing::missing:
            return AnswerOutcome::missing;
        case Standing::other_variant:
        case Standing::not_judged:
            break;
    }
    return AnswerOutcome::set_aside;
}

std::string stacked_bar(const OutcomeCounts& counts, std::size_t students) {
    constexpr double width = 190.0;
    std::string svg = fmt::format("<svg width=\"{:g}\" height=\"12\">", width);
    double x = 0.0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double part = width * share(counts[i], static_cast<int>(students));
        if (counts[i] > 0)
            svg += fmt::format("<rect x=\"{:.1f}\" width=\"{:.1f}\" height=\"12\" fill=\"{}\"/>", x, part,
                               outcome_looks[i].color);
        x += part;
    }
    return svg + "</svg>";
}

std::string exercises_table(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades) {
    const std::vector<const StudentGrade*> read = read_ones(grades);
    std::string table = "<table>\n<tr><th>" + std::string(tr("exercise")) + "</th><th></th>";
    for (const OutcomeLook& look : outcome_looks)
        table += fmt::format(
            "<th class=\"number\"><svg class=\"swatch\"><rect width=\"10\" height=\"10\" "
            "fill=\"{}\"/></svg> {}</th>",
            look.color, tr(look.name));
    table += "</tr>\n";
    for (std::size_t i = 0; i < exercises.size(); ++i) {
        OutcomeCounts counts{};
        for (const StudentGrade* const grade : read) ++counts[static_cast<std::size_t>(outcome_of(grade->items[i]))];
        table += "<tr><td>" + escaped(exercises[i].short_id()) + " " + escaped(exercises[i].title.shown()) +
                 "</td><td>" + stacked_bar(counts, read.size()) + "</td>";
        for (const int count : counts) table += "<td class=\"number\">" + std::to_string(count) + "</td>";
        table += "</tr>\n";
    }
    return table + "</table>\n";
}

// ---- answers -------------------------------------------------------------------------------------------------------

constexpr int answer_digits = 6;

std::string matrix_table(const std::vector<double>& numbers, std::size_t columns) {
    std::string table = "<table class=\"matrix\">";
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (i % columns == 0) table += i == 0 ? "<tr>" : "</tr><tr>";
        table += "<td>" + figures(numbers[i], answer_digits) + "</td>";
    }
    return table + "</tr></table>";
}

std::string list_of(const std::vector<double>& numbers) {
    std::string list;
    for (const double number : numbers) list += (list.empty() ? "" : ", ") + figures(number, answer_digits);
    return numbers.size() == 1 ? list : "(" + list + ")";
}

std::string names_of_items(const Answer& answer, const Ask& ask) {
    std::string list;
    for (const int item : answer.items) {
        const auto at = static_cast<std::size_t>(item);
        const LessonText& text = ask.choices.empty() ? ask.items[at] : ask.choices[at].say;
        list += (list.empty() ? "" : " | ") + escaped(text.shown());
    }
    return list;
}

/// Returns the answer in readable form, or as plain numbers if the question is unknown or the answer does not fit it.
std::string answer_cell(const Attempt& attempt, const Ask* ask) {
    if (attempt.is_goal) {
        std::string lines;
        for (const std::string& setting : attempt.settings) lines += (lines.empty() ? "" : "<br>") + foreign(setting);
        return lines.empty() ? tr("nothing changed") : lines;
    }
    if (!attempt.answer) return "";
    const std::optional<Answer> answer = ask ? answer_in(attempt, *ask) : std::nullopt;
    if (answer && !answer->items.empty()) return names_of_items(*answer, *ask);
    if (answer && ask->columns > 1) return matrix_table(answer->numbers, static_cast<std::size_t>(ask->columns));
    return list_of(*attempt.answer);
}

std::string told_cell(const Verdict& verdict) {
    if (verdict.right) return tr("correct");
    std::string text = verdict.points > 0 ? std::string(tr("partly right")) + ". " : "";
    text += verdict.say.empty() ? tr("wrong") : escaped(verdict.say.shown());
    return verdict.tag.empty() ? text : text + " (" + escaped(verdict.tag) + ")";
}

// ---- students ------------------------------------------------------------------------------------------------------

/// Returns the question that was answered; null if no answer was judged, for example because the variant was another
/// student's.
const LessonStep* step_of(Grader& grader, const ItemGrade& item, std::size_t exercise) {
    if (item.judged() == 0) return nullptr;
    const Result<LessonStep>& step = grader.step(exercise, item.variant);
    return step ? &*step : nullptr;
}

/// Returns the text that is shown if there is no verdict.
std::string why_not_judged(const ItemGrade& item) {
    if (item.standing == Standing::other_variant) return tr("not this student's variant");
    return item.trouble.empty() ? tr("not judged") : tr("not judged") + (": " + foreign(item.trouble));
}

std::string attempts_rows(Grader& grader, const StudentGrade& grade, std::size_t exercise) {
    const ItemGrade& item = grade.items[exercise];
    const HandInItem* const handed_in = grade.hand_in.find(item.exercise);
    const std::string begin = "<tr><td>" + escaped(item.exercise) + "</td><td class=\"number\">";
    if (!handed_in || handed_in->attempts.empty())
        return begin + "</td><td></td><td></td><td>" + (item.trouble.empty() ? tr("missing") : why_not_judged(item)) +
               "</td></tr>\n";
    const LessonStep* const step = step_of(grader, item, exercise);
    std::string rows;
    std::size_t answers = 0;
    for (const Attempt& attempt : handed_in->attempts) {
        rows += begin + std::to_string(handed_in->variant) + "</td><td>" + foreign(attempt.at) + "</td><td>";
        if (attempt.hint > 0) {
            rows += "</td><td>" + say("hint {number}", "number"_a = attempt.hint) + "</td></tr>\n";
            continue;
        }
        rows += answer_cell(attempt, step ? &step->ask : nullptr) + "</td><td>";
        const bool is_judged = answers < item.verdicts.size() && item.verdicts[answers];
        rows += is_judged ? told_cell(*item.verdicts[answers]) : why_not_judged(item);
        rows += "</td></tr>\n";
        ++answers;
    }
    return rows;
}

std::string student_details(Grader& grader, const StudentGrade& grade) {
    std::string text = "<details><summary><b>" + foreign(grade.hand_in.student) + "</b> " +
                       foreign(grade.hand_in.name) +
                       say(" · {points}/{of} points · {first}/{tried} on the first try · {hints}",
                           "points"_a = grade.points(), "of"_a = grade.of(), "first"_a = grade.at_first_try(),
                           "tried"_a = grade.tried(), "hints"_a = say_count(grade.hints(), "1 hint", "{count} hints"));
    text += "</summary>\n<p>" + escaped(grade.file) + "</p>\n";
    for (const std::string& note : grade.notes)
        text += "<p>" + say("Note: {note}", "note"_a = foreign(note)) + "</p>\n";
    text += fmt::format("<table>\n<tr><th>{}</th><th class=\"number\">{}</th><th>{}</th><th>{}</th><th>{}</th></tr>\n",
                        tr("exercise"), tr("variant"), tr("time"), tr("answer"), tr("verdict"));
    for (std::size_t exercise = 0; exercise < grade.items.size(); ++exercise)
        text += attempts_rows(grader, grade, exercise);
    return text + "</table>\n</details>\n";
}

// ---- what the wrong matrices do ------------------------------------------------------------------------------------

constexpr std::size_t most_pictures = 24;
constexpr glm::ivec2 answer_picture_px{320, 180};

/// A wrong answer whose matrix can be used for drawing.
struct WrongMatrix {
    std::size_t exercise = 0, variant = 0;
    std::vector<double> numbers;
    auto operator<=>(const WrongMatrix&) const = default;
};
struct Givers {
    Verdict verdict;
    std::set<std::string> students;
};
using WrongMatrices = std::map<WrongMatrix, Givers>;

void collect(Grader& grader, const StudentGrade& grade, std::size_t exercise, WrongMatrices& found) {
    const ItemGrade& item = grade.items[exercise];
    const HandInItem* const handed_in = grade.hand_in.find(item.exercise);
    if (!handed_in) return;
    const LessonStep* const step = step_of(grader, item, exercise);
    if (!step || step->ask.shows_as.empty() || step->ask.rows * step->ask.columns != 16) return;
    std::size_t answers = 0;
    for (const Attempt& attempt : handed_in->attempts) {
        if (attempt.hint > 0 || answers == item.verdicts.size()) continue;
        const std::optional<Verdict>& verdict = item.verdicts[answers++];
        const std::optional<Answer> answer = answer_in(attempt, step->ask);
        if (!verdict || verdict->right || !answer) continue;
        Givers& givers = found[{exercise, item.variant, answer->numbers}];
        givers.verdict = *verdict;
        givers.students.insert(grade.hand_in.student);
    }
}

/// Returns the wrong matrices, those entered by the most students first.
std::vector<std::pair<WrongMatrix, Givers>> wrong_matrices(Grader& grader, const std::vector<StudentGrade>& grades) {
    WrongMatrices found;
    for (const StudentGrade* const grade : read_ones(grades))
        for (std::size_t exercise = 0; exercise < grade->items.size(); ++exercise)
            collect(grader, *grade, exercise, found);
    std::vector<std::pair<WrongMatrix, Givers>> sorted(found.begin(), found.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second.students.size() > b.second.students.size(); });
    return sorted;
}

std::string answer_picture(Headless& headless, LoadedState state) {
    state.params.ui.theme = Theme::light;  // for printing
    PictureRequest request;
    request.view = PictureView::camera;
    request.size_px = answer_picture_px;
    const Image image = headless.drawn(draw_picture(headless.renderer(), state, scene_of(state), request));
    return fmt::format("<img alt=\"\" width=\"{}\" height=\"{}\" src=\"data:image/png;base64,{}\">",
                       answer_picture_px.x, answer_picture_px.y, base64(encode_png(image)));
}

std::string captioned(const std::string& picture, const std::string& caption) {
    return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>";
}

std::string matrix_pictures(Headless& headless, Grader& grader, const std::vector<StudentGrade>& grades) {
    std::string section;
    std::size_t count = 0;
    for (const auto& [wrong, givers] : wrong_matrices(grader, grades)) {
        if (count == most_pictures) break;
        const Exercise& exercise = grader.exercises()[wrong.exercise];
        const LessonStep& step = *grader.step(wrong.exercise, wrong.variant);
        const Result<LoadedState> typed = with_typed_matrix(step, matrix_of_rows(wrong.numbers));
        if (!typed) continue;  // the exercise's field rejects such numbers
        ++count;
        section +=
            "<div class=\"pair\">" +
            captioned(answer_picture(headless, *typed),
                      say_count(std::ssize(givers.students), "{exercise}, variant {variant}: entered by 1 student",
                                "{exercise}, variant {variant}: entered by {count} students",
                                "exercise"_a = escaped(exercise.short_id()), "variant"_a = wrong.variant)) +
            captioned(answer_picture(headless, with_right_matrix(step)), tr("the correct matrix")) + "<div>" +
            matrix_table(wrong.numbers, 4) + "<p>" + told_cell(givers.verdict) + "</p></div></div>\n";
    }
    return section.empty() ? "" : heading(marked("Effects of wrong matrices")) + section;
}

}  // namespace

std::string grade_report(Headless& headless, Grader& grader, const std::vector<StudentGrade>& grades,
                         const std::vector<TagCount>& tags, const std::string& files) {
    std::string page = "<!DOCTYPE html>\n<html lang=\"" + std::string(name_of(spoken_language())) +
                       "\">\n<meta charset=\"utf-8\">\n<title>" + tr("Graded exercises") + "</title>\n<style>" +
                       std::string(report_style) + "</style>\n";
    page += title(grader.exercises(), grades, files);
    page += heading(marked("Points")) + points_chart(grades);
    page += heading(marked("Misconceptions")) + misconceptions(tags);
    page += heading(marked("Exercises")) + exercises_table(grader.exercises(), grades);
    page += matrix_pictures(headless, grader, grades);
    page += heading(marked("Students"));
    for (const StudentGrade* const grade : read_ones(grades)) page += student_details(grader, *grade);
    return page + "</html>\n";
}

}  // namespace viewing
