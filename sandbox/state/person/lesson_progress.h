// A user's progress in each lesson, remembered between runs of the program.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace viewing {

struct LessonProgress {
    std::size_t step = 0;           ///< the last step visited, counted from 0
    std::vector<std::size_t> done;  ///< steps whose question was answered correctly, in ascending order
    bool operator==(const LessonProgress&) const = default;
};

/// A student who does exercises; the course and the student number determine the numbers in the exercises.
struct Student {
    std::string course, number, name;
    bool operator==(const Student&) const = default;
};

/// Keyed by the lessons' ids.
using LessonsProgress = std::map<std::string, LessonProgress>;

}  // namespace viewing
