// An exercise: a step of a lesson with parameters, so that each student has numbers of their own. A variant is made a
// plain step (variant_step), and everything that leads, asks and judges in lessons does so here. Read variants.h for
// who gets which variant, hand_in.h for what is handed in.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lesson/expression.h"
#include "lesson/lesson.h"

namespace viewing {

struct Exercise {
    std::string id;
    LessonText title;
    std::vector<std::string> sets;  ///< that it belongs to: "shadow"
    std::vector<int> slides;
    int points = 1;
    int visible_px = 0;  ///< that each fault alone must change at 640 × 360; 0: not asked for
    std::vector<std::pair<std::string, LessonText>> tags;
    std::vector<std::string> variants;  ///< the deployed ones: the values of its constants, JSON objects
    std::string pattern;                ///< the step, JSON, with places for the constants
    std::string source;                 ///< what messages open with: "E16-shadow-matrix.json"
    std::filesystem::path file;

    bool is_in(const std::string& set) const;
    /// "E16" of "E16-shadow-matrix".
    std::string short_id() const { return id.substr(0, id.find('-')); }
};

/// The exercises of the assets directory by their files' names, each with the error of one that cannot be read.
std::vector<Result<Exercise>> exercises();

/// The exercises of these files and folders, by their files' names; of the assets directory where there are none. The
/// error is the first one's.
Result<std::vector<Exercise>> load_exercises(const std::vector<std::string>& files);

/// The place of the exercise with that id or short id; the error has the nearest.
Result<std::size_t> find_exercise(const std::vector<Exercise>& exercises, const std::string& name);

/// Those of a set, or of a list of ids with commas between; all for "". The error names the sets that there are.
Result<std::vector<Exercise>> of_set(std::vector<Exercise> exercises, const std::string& set);

/// Of a text; `source` opens every message, `folder` is what its scenes' files are relative to.
Result<Exercise> parse_exercise(std::string_view json, const std::string& source, const std::filesystem::path& folder);

/// How many variants of an exercise students get: the first ones of its combinations.
inline constexpr std::size_t most_deployed = 16;

/// All combinations of its lists that pass `require`, shuffled: the first ones are those to be deployed. The error is
/// that of an expression, or that there are too many or none.
Result<std::vector<std::string>> combinations(std::string_view json, const std::string& source);

/// What the names of a state stand for; what it refers to lives as long as the copies of the function.
using NumbersAt = std::function<Result<Surroundings>(const LoadedState& start)>;

/// A variant as a step: its constants put in, what it computes computed at its own start. The error is one sentence.
Result<LessonStep> variant_step(const Exercise& exercise, std::size_t variant, const NumbersAt& numbers_at);

/// A student's sheet without anything on it yet, and one exercise more on it.
Lesson empty_sheet(const std::string& course, const std::string& student);
void add_to_sheet(Lesson& sheet, const Exercise& exercise, std::size_t variant, const LessonStep& step);

/// A student's sheet: one step for each exercise, in their order, in the variant that is theirs.
Result<Lesson> sheet(const std::vector<Exercise>& exercises, const std::string& course, const std::string& student,
                     const NumbersAt& numbers_at);

}  // namespace viewing
