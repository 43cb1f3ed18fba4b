// Judges answers and picks the feedback. Pure, except for values that the surroundings look up.
#pragma once

#include <string>
#include <vector>

#include "lesson/formulas/expression.h"
#include "lesson/lesson.h"

namespace viewing {

/// What is right about an answer that matches no known mistake.
enum class Near {
    nothing,      ///< nothing to report
    factor,       ///< all numbers are right except for one common factor
    sign,         ///< only the signs at `places` are wrong
    half,         ///< the number is half of the right one
    twice,        ///< the number is twice the right one
    reciprocal,   ///< the number is 1 divided by the right one
    radians,      ///< the number is right as an angle in radians, but it has to be in degrees
    degrees,      ///< the number is right as an angle in degrees, but it has to be in radians
    decimal,      ///< only the decimal point is in the wrong place, by up to three places
    right_parts,  ///< the rows or entries at `places` are right, the others are not
    first_items,  ///< this many tiles at the beginning are right
    first_wrong,  ///< the first tile is wrong
    no_items,     ///< none of the chosen tiles is right
    some_items,   ///< this many chosen tiles are right; others are not, and some are missing
    incomplete,   ///< every chosen tile is right, but some are missing
    too_many      ///< all right tiles are chosen, and others too
};

struct Verdict {
    bool right = false;
    LessonText say = {};                     ///< why the answer is wrong; empty if it is right or not a known mistake
    std::string tag = {};                    ///< the misconception
    int points = 0;                          ///< in an exercise: points earned although the answer is not right
    Near near = Near::nothing;               ///< for an unknown mistake
    std::vector<int> places = {};            ///< for `near`: rows or entries, counted from 1, or a number of tiles
    int other_row = 0;                       ///< from 1: a wrong row that is right for another plane or light; 0: none
    std::vector<double> other_plane = {};    ///< (a, b, c, d) of that plane, with a unit normal; empty: it is a light
    std::vector<double> other_light = {};    ///< (x, y, z, w) of that light
    std::vector<std::string> progress = {};  ///< of a goal: see progress_of()
    bool operator==(const Verdict&) const = default;
};

/// Returns the names that the step defines, as an object; empty if there are none.
Json constants_of(const Ask& ask);
/// Returns the surroundings with the step's names as constants.
Surroundings with_constants(const Ask& ask, Surroundings surroundings);

/// Whether judging an answer needs a measurement, which may take a second.
bool is_measured(const Ask& ask);

/// Computes the right answer in these surroundings; the result is empty for a goal. Fails with the expression's error.
Result<Answer> model_answer(const Ask& ask, const Surroundings& surroundings);

/// Judges an answer; for a goal, ignores `answer` and judges whether the goal is reached. Fills in
/// `surroundings.answer` itself. Reports the first known wrong answer that matches. Fails with an expression's error.
Result<Verdict> judge(const Ask& ask, const Answer& answer, Surroundings surroundings);

}  // namespace viewing
