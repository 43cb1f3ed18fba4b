// An exercise: a lesson step with parameters, so that each student gets different numbers. variant_step() turns a
// variant into a plain step, which is then presented and judged like any lesson step. See variants.h for how variants
// are assigned to students, and hand_in.h for the file that is handed in.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lesson/formulas/expression.h"
#include "lesson/lesson.h"

namespace viewing {

struct Exercise {
    std::string id;
    LessonText title;
    std::vector<std::string> sets;  ///< the sets it belongs to: "shadow"
    std::vector<int> slides;
    int points = 1;
    int visible_px = 0;  ///< number of pixels that each mistake alone must change at 640 × 360; 0: not checked
    std::vector<std::pair<std::string, LessonText>> tags;
    std::vector<std::string> variants;  ///< the deployed variants, each with the constants' values as a JSON object
    std::string pattern;                ///< the step as JSON, with placeholders for the constants
    std::string source;                 ///< begins every error message: "E16-shadow-matrix.json"
    std::filesystem::path file;

    bool is_in(const std::string& set) const;
    /// Returns "E16" for "E16-shadow-matrix".
    std::string short_id() const { return id.substr(0, id.find('-')); }
};

/// Returns the exercises of the assets directory in order of file name, with an error in place of each unreadable one.
std::vector<Result<Exercise>> exercises();

/// Returns the title of one of the program's exercises, by its id; empty if there is none.
LessonText exercise_title(const std::string& id);

/// Loads exercises from these files and folders (in a folder, in order of file name); if `files` is empty, loads those
/// of the assets directory. Fails with the first error.
Result<std::vector<Exercise>> load_exercises(const std::vector<std::string>& files);

/// Returns the index of the exercise with that id or short id; the error suggests the nearest one.
Result<std::size_t> find_exercise(const std::vector<Exercise>& exercises, const std::string& name);

/// Selects the exercises in a comma-separated list of sets and ids, in its order; "" selects all. The error lists the
/// sets.
Result<std::vector<Exercise>> of_set(std::vector<Exercise> exercises, const std::string& set);

/// Returns the JSON Schema of exercise files.
std::string exercise_schema();

/// Reads an exercise from a string. Errors begin with `source`; file names in its scenes are relative to `folder`.
Result<Exercise> parse_exercise(std::string_view json, const std::string& source, const std::filesystem::path& folder);

/// The maximum number of an exercise's variants that students get. These variants are its first combinations.
inline constexpr std::size_t most_deployed = 16;

/// Returns all combinations of values that pass `require`, in shuffled order. Students get the first
/// most_deployed of them. Fails if an expression fails, or if there are too many combinations or none.
Result<std::vector<std::string>> combinations(std::string_view json, const std::string& source);

/// A function that returns the values of names in a state. The returned value keeps alive everything that it refers to.
using NumbersAt = std::function<Result<Surroundings>(const LoadedState& start)>;

/// Returns a variant as a step, with its constants filled in and its expressions computed in the step's starting state.
/// The error is one sentence.
Result<LessonStep> variant_step(const Exercise& exercise, std::size_t variant, const NumbersAt& numbers_at);

/// Make an empty sheet for a student, and add an exercise to a sheet.
Lesson empty_sheet(const std::string& course, const std::string& student);
void add_to_sheet(Lesson& sheet, const Exercise& exercise, std::size_t variant, const LessonStep& step);

/// Makes a student's sheet: one step per exercise, in order, each in the student's variant.
Result<Lesson> sheet(const std::vector<Exercise>& exercises, const std::string& course, const std::string& student,
                     const NumbersAt& numbers_at);

}  // namespace viewing
