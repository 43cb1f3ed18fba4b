// A page of grades for a lecturer, in HTML: points, misconceptions, and every attempt.
#pragma once

#include <string>
#include <vector>

#include "cli/headless.h"
#include "grading/grading.h"

namespace viewing {

/// Returns the page in the current language. `grader` is the one that made the grades. Throws Failure if GL fails.
std::string grade_report(Headless& headless, Grader& grader, const std::vector<StudentGrade>& grades,
                         const std::vector<TagCount>& tags, const std::string& files);

}  // namespace viewing
