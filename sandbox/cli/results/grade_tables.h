// Grades as tables: for a terminal, for a spreadsheet, for another program. Texts of hand-ins are shown as printable()
// has them. Read report/grading.h for what a grade is.
#pragma once

#include <string>
#include <vector>

#include "cli/results/hand_in_files.h"
#include "report/grading.h"

namespace viewing {

/// A line for each student, a column for each exercise by its short id; a file that cannot be read is its sentence.
std::string grades_as_text(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);
/// "M04 last column of V taken for the eye: 41 % of 87 students, 12 % at the last attempt", a line each.
std::string tags_as_text(const std::vector<TagCount>& tags);

/// RFC 4180; what a spreadsheet would take for a formula has an apostrophe before it. Missing is an empty cell.
std::string grades_as_csv(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades);
std::string tags_as_csv(const std::vector<TagCount>& tags);

/// Everything, ended by a newline.
std::string grades_as_json(const std::vector<Exercise>& exercises, const std::vector<StudentGrade>& grades,
                           const std::vector<TagCount>& tags, const HandInFiles& files);

/// "12 files judged, 1 not read, 3 skipped: 2 not JSON, 1 a link": what there is of these, without a full stop.
std::string files_in_words(const std::vector<StudentGrade>& grades, const HandInFiles& files);

/// Of 0 … 1; 0 where nobody was.
double share(int students, int of);

}  // namespace viewing
