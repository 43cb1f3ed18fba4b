// Grades as one HTML page for a lecturer: what the class has, what it misunderstands, and every attempt.
#pragma once

#include <string>
#include <vector>

#include "cli/headless.h"
#include "report/grading.h"

namespace viewing {

/// `grader` is the one that made the grades. Texts are in English. Throws Failure where GL does not draw.
std::string grade_report(Headless& headless, Grader& grader, const std::vector<StudentGrade>& grades,
                         const std::vector<TagCount>& tags, const std::string& files);

}  // namespace viewing
