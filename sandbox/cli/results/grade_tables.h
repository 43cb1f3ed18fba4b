// Grades as tables: for a terminal, for a spreadsheet, or for another program. Text from hand-ins goes through
// printable(). Read grading/grading.h first.
#pragma once

#include <string>
#include <vector>

#include "cli/results/hand_in_files.h"
#include "grading/grading.h"

namespace viewing {

/// Returns a line for each student, with a column for each exercise under its short id. If a file cannot be read, its
/// line is the error.
std::string grades_as_text(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);
/// Returns a line for each tag: "M04 last column of V taken for the eye: 41% of 87 students, 12% on the last attempt".
std::string tags_as_text(const std::vector<TagCount>& tags);

/// Return comma-separated values (RFC 4180); an apostrophe precedes text that a spreadsheet would take for a formula.
/// The cell of a missing answer is empty.
std::string grades_as_csv(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);
std::string tags_as_csv(const std::vector<TagCount>& tags);

/// Returns all data about the grades, with a newline at the end.
std::string grades_as_json(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades,
                           const std::vector<TagCount>& tags, const HandInFiles& files);

/// Returns, for example, "12 files judged, 1 not read, 3 skipped: 2 not JSON, 1 a link", without a period. Leaves out
/// all counts that are 0 except the first.
std::string files_in_words(const std::vector<StudentGrade>& grades, const HandInFiles& files);

/// Returns a line for each skipped file that is not JSON, such as a hand-in in an archive; at most 20 of them by name.
std::string not_json_in_lines(const HandInFiles& files);

/// Returns students / of, clamped to 0 … 1; 0 if `of` is 0.
double share(int students, int of);

}  // namespace viewing
