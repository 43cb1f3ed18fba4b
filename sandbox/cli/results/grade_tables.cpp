#include "cli/results/grade_tables.h"

#include <algorithm>
#include <map>

#include "cli/results/csv.h"
#include "state/file/document.h"
#include "text/numbers.h"
#include "text/per_enum.h"
#include "text/words.h"

namespace viewing {
namespace {

using Row = std::vector<std::string>;

/// Returns the cell of a table: "3", "p1", "w:M33", "-".
std::string cell(const ItemGrade& item) {
    switch (item.standing) {
        case Standing::right:
            return std::to_string(item.points);
        case Standing::partly:
            return "p" + std::to_string(item.points);
        case Standing::wrong:
            return item.last_tag().empty() ? "w" : "w:" + item.last_tag();
        case Standing::missing:
            return "-";
        case Standing::other_variant:
            return "v!";
        case Standing::not_judged:
            return "?";
    }
    return "";
}

const char* name_of(Standing standing) {
    constexpr auto names = per_enum<Standing>("right", "partly", "wrong", "missing", "other_variant", "not_judged");
    return names[standing];
}

/// Returns the notes, and the reasons why exercises could not be judged.
std::vector<std::string> remarks(const StudentGrade& grade) {
    std::vector<std::string> all;
    for (const std::string& note : grade.notes) all.push_back(printable(note));
    std::vector<std::pair<std::string, std::string>> names_by_trouble;  // in the order of the exercises
    for (const ItemGrade& item : grade.items) {
        if (item.trouble.empty()) continue;
        if (names_by_trouble.empty() || names_by_trouble.back().first != item.trouble)
            names_by_trouble.emplace_back(item.trouble, item.exercise);
        else
            names_by_trouble.back().second += ", " + item.exercise;
    }
    for (const auto& [trouble, names] : names_by_trouble) all.push_back(names + " not judged: " + printable(trouble));
    return all;
}

std::string remarks_in_one(const StudentGrade& grade) {
    std::string text;
    for (const std::string& remark : remarks(grade)) text += (text.empty() ? "" : "; ") + remark;
    return text;
}

struct FileCounts {
    int judged = 0, cut = 0, not_read = 0;
};

FileCounts counts_of(const std::vector<StudentGrade>& grades) {
    FileCounts counts;
    for (const StudentGrade& grade : grades)
        ++(!grade.error.empty() ? counts.not_read : grade.is_cut ? counts.cut : counts.judged);
    return counts;
}

// ---- for a terminal ------------------------------------------------------------------------------------------------

/// Returns the rows as text, with all columns right-aligned except the first and the last. A row with one cell is a
/// sentence that spans the columns.
std::string aligned(const std::vector<Row>& rows) {
    const std::size_t columns = rows.front().size();
    std::vector<std::size_t> widths(columns, 0);
    for (const Row& row : rows)
        for (std::size_t i = 0; row.size() == columns && i < columns; ++i)
            widths[i] = std::max(widths[i], character_count(row[i]));
    const auto gap = [columns](std::size_t column) {
        constexpr std::size_t wide = 3;  // the last columns, which contain several words
        return column == 0 ? "" : column == 1 || column + wide >= columns ? "  " : " ";
    };
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const bool is_text = i == 0 || i + 1 == columns;
            const std::string blanks(row.size() < columns ? 0 : widths[i] - character_count(row[i]), ' ');
            line += gap(i) + (is_text ? row[i] + blanks : blanks + row[i]);
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

Row text_row(const StudentGrade& grade) {
    if (!grade.error.empty()) return {printable(grade.error)};
    Row row{excerpt(grade.name())};
    for (const ItemGrade& item : grade.items) row.push_back(cell(item));
    row.push_back(std::to_string(grade.points()) + "/" + std::to_string(grade.of()));
    row.push_back(std::to_string(grade.at_first_try()) + "/" + std::to_string(grade.tried()));
    row.push_back(std::to_string(grade.hints()));
    row.push_back(remarks_in_one(grade));
    return row;
}

// ---- for a spreadsheet ---------------------------------------------------------------------------------------------

std::string csv_cell(std::string text) {
    constexpr const char* beginnings_of_formulas = "=+-@";
    if (text.find_first_of(beginnings_of_formulas) == 0) text.insert(0, 1, '\'');
    return csv_quoted(text);
}

std::string csv_line(const Row& row) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : ",") + csv_cell(row[i]);
    return line + "\r\n";
}

Row csv_row(const std::vector<Exercise>& exercises, const StudentGrade& grade) {
    if (!grade.error.empty()) {
        Row row(exercises.size() + 8);
        row[2] = grade.file;
        row.back() = printable(grade.error);
        return row;
    }
    Row row{printable(grade.hand_in.student), printable(grade.hand_in.name), grade.file};
    for (const ItemGrade& item : grade.items) row.push_back(item.standing == Standing::missing ? "" : cell(item));
    for (const int number : {grade.points(), grade.of(), grade.at_first_try(), grade.hints()})
        row.push_back(std::to_string(number));
    row.push_back(remarks_in_one(grade));
    return row;
}

// ---- for a program -------------------------------------------------------------------------------------------------

Json item_as_json(const ItemGrade& item) {
    Json json = {{"exercise", item.exercise},
                 {"variant", item.variant},
                 {"standing", name_of(item.standing)},
                 {"points", item.points},
                 {"of", item.of},
                 {"tries", item.tries},
                 {"hints", item.hints},
                 {"at_first_try", item.at_first_try},
                 {"tags", Json::array()},
                 {"right", Json::array()},
                 {"told", Json::array()},
                 {"trouble", printable(item.trouble)}};
    for (const std::optional<Verdict>& verdict : item.verdicts) {
        json["tags"].push_back(verdict ? Json(verdict->tag) : Json());
        json["right"].push_back(verdict ? Json(verdict->right) : Json());
        json["told"].push_back(verdict ? verdict->say.in_english() : "not judged");
    }
    return json;
}

Json student_as_json(const StudentGrade& grade) {
    if (!grade.error.empty()) return {{"file", grade.file}, {"error", printable(grade.error)}};
    Json json = {{"file", grade.file},
                 {"student", grade.hand_in.student},
                 {"name", grade.hand_in.name},
                 {"course", grade.hand_in.course},
                 {"points", grade.points()},
                 {"of", grade.of()},
                 {"first_try", grade.at_first_try()},
                 {"hints", grade.hints()},
                 {"notes", remarks(grade)},
                 {"items", Json::array()}};
    for (const ItemGrade& item : grade.items) json["items"].push_back(item_as_json(item));
    return json;
}

}  // namespace

std::string grades_as_text(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades) {
    Row header{"student"};
    for (const Exercise& exercise : exercises) header.push_back(exercise.short_id());
    header.insert(header.end(), {"points", "first try", "hints", "notes"});
    std::vector<Row> rows{std::move(header)};
    for (const StudentGrade& grade : grades) rows.push_back(text_row(grade));
    return aligned(rows);
}

std::string tags_as_text(const std::vector<TagCount>& tags) {
    std::string text;
    for (const TagCount& tag : tags)
        text += tag.tag + " " + tag.text.in_english() + ": " + percent(share(tag.students, tag.students_of), 0) +
                " of " + counted(tag.students_of, "student") + ", " + percent(share(tag.at_last, tag.students_of), 0) +
                " on the last attempt\n";
    return text;
}

std::string grades_as_csv(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades) {
    Row header{"student", "name", "file"};
    for (const Exercise& exercise : exercises) header.push_back(exercise.id);
    header.insert(header.end(), {"points", "of", "first_try", "hints", "notes"});
    std::string text = csv_line(header);
    for (const StudentGrade& grade : grades) text += csv_line(csv_row(exercises, grade));
    return text;
}

std::string tags_as_csv(const std::vector<TagCount>& tags) {
    std::string text = csv_line({"tag", "text", "students", "at_last", "students_of"});
    for (const TagCount& tag : tags)
        text += csv_line({tag.tag, tag.text.in_english(), std::to_string(tag.students), std::to_string(tag.at_last),
                          std::to_string(tag.students_of)});
    return text;
}

std::string grades_as_json(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades,
                           const std::vector<TagCount>& tags, const HandInFiles& files) {
    const FileCounts counts = counts_of(grades);
    Json json = {{"exercises", Json::array()},
                 {"students", Json::array()},
                 {"tags", Json::array()},
                 {"files",
                  {{"judged", counts.judged},
                   {"not_read", counts.not_read},
                   {"out_of_time", counts.cut},
                   {"skipped", Json::array()}}}};
    for (const auto& [file, why] : files.skipped)
        json["files"]["skipped"].push_back({{"file", one_line(file.string())}, {"why", name_of(why)}});
    for (const Exercise& exercise : exercises)
        json["exercises"].push_back({{"id", exercise.id}, {"points", exercise.points}});
    for (const StudentGrade& grade : grades) json["students"].push_back(student_as_json(grade));
    for (const TagCount& tag : tags)
        json["tags"].push_back({{"tag", tag.tag},
                                {"text", tag.text.in_english()},
                                {"students", tag.students},
                                {"at_last", tag.at_last},
                                {"students_of", tag.students_of}});
    return print_document(json) + "\n";
}

std::string files_in_words(const std::vector<StudentGrade>& grades, const HandInFiles& files) {
    const FileCounts counts = counts_of(grades);
    std::string text = counted(counts.judged, "file judged", "files judged");
    if (counts.cut > 0) text += ", " + std::to_string(counts.cut) + " not fully judged";
    if (counts.not_read > 0) text += ", " + std::to_string(counts.not_read) + " not read";
    if (files.skipped.empty()) return text;
    std::map<WhySkipped, int> by_reason;
    for (const auto& [file, why] : files.skipped) ++by_reason[why];
    std::string reasons;
    for (const auto& [why, count] : by_reason)
        reasons += (reasons.empty() ? "" : ", ") + std::to_string(count) + " " +
                   (why == WhySkipped::link && count > 1 ? "links" : name_of(why));
    return text + ", " + std::to_string(files.skipped.size()) + " skipped: " + reasons;
}

std::string not_json_in_lines(const HandInFiles& files) {
    constexpr std::size_t most = 20;
    std::vector<std::string> names;
    for (const auto& [file, why] : files.skipped)
        if (why == WhySkipped::not_json) names.push_back(one_line(file.string()));
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) text += "  not JSON: " + names[i] + "\n";
    return names.size() <= most ? text : text + "  … and " + std::to_string(names.size() - most) + " more\n";
}

double share(int students, int of) {
    return of > 0 ? std::min(1.0, static_cast<double>(students) / of) : 0.0;
}

}  // namespace viewing
