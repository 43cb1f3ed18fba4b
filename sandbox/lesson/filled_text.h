// Texts with {expressions}: "t = {light.position[1]} / 2.7".
#pragma once

#include <functional>
#include <string>

#include "lesson/formulas/expression.h"
#include "lesson/lesson.h"

namespace viewing {

/// Whether a text has a placeholder for a value.
bool has_places(const LessonText& text);

/// Replaces each {expression} with its value as written in a sentence: a number with `digits` significant digits, "−3",
/// "(0, 1, 0, 0)". The error is that of the first expression that has no value.
Result<std::string> filled(const std::string& text, const std::function<Result<Json>(const std::string&)>& value_of,
                           int digits);

/// Fills a text of a lesson in every language, with four digits.
Result<LessonText> filled(const LessonText& text, const Surroundings& surroundings);

/// Returns the filled text, or the text itself if it cannot be filled.
LessonText filled_or_same(const LessonText& text, const Surroundings& surroundings);

}  // namespace viewing
