// How far one person is in each lesson: kept from one time to the next beside what the window remembers.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace viewing {

struct LessonProgress {
    std::size_t step = 0;           ///< where one was last, from 0 on
    std::vector<std::size_t> done;  ///< steps whose question was answered rightly, in rising order
    bool operator==(const LessonProgress&) const = default;
};

/// Who does exercises here: the number and the course say which numbers they have.
struct Student {
    std::string course, number, name;
    bool operator==(const Student&) const = default;
};

/// By the lessons' ids.
using LessonsProgress = std::map<std::string, LessonProgress>;

}  // namespace viewing
