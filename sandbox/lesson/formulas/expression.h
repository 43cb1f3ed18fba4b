// The expressions of lesson files. Lua computes one value from a closed list of names. An expression has no access to
// files or libraries except the mathematics here, cannot define functions or loops, and has limited time and memory, so
// that a stranger's file can do no harm. See names.h for the names, and lesson.h for the fields that contain
// expressions.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "state/file/document.h"
#include "text/result.h"

namespace viewing {

/// The values of the names that are not mathematical functions or constants.
struct Surroundings {
    /// Returns the value of a name in expression_names() whose kind is `value` or `measured`; `arguments` are those of
    /// a function. Called only for names that the evaluation reaches. Its error becomes the expression's.
    std::function<Result<Json>(const std::string& name, std::span<const double> arguments)> look_up;
    Json answer;     ///< the entered answer; null before there is one
    Json constants;  ///< an object of names and values that take precedence over all others; or null
};

/// Limits of an expression, including the conversion of its value to JSON.
struct ExpressionLimits {
    int instructions = 1'000'000;  ///< also spent on source bytes, entries of the value, and filling memory
    std::size_t memory_bytes = 8U << 20U;
    int measured_call = 20'000;  ///< instructions that each call of a measured name costs
    bool closed_list = true;     ///< false: allows statements, functions and any words, within the other limits
};

/// Returns the value: a number, a string in UTF-8, true or false, null, or a list of those; vectors are lists, and
/// matrices are lists of rows. Fails if check_expression() does, if an argument is wrong, or if the expression takes
/// too much time or memory. The error is one sentence, which does not repeat the expression.
Result<Json> evaluate(const std::string& expression, const Surroundings& surroundings,
                      const ExpressionLimits& limits = {});

/// Evaluates an expression that must be true or false.
Result<bool> holds(const std::string& expression, const Surroundings& surroundings,
                   const ExpressionLimits& limits = {});

/// Checks the syntax, and that all words are known names. Splits the source into tokens as Lua does, so words in
/// comments and strings do not count. Computes no value.
Status check_expression(const std::string& expression, std::span<const std::string> constants = {});

/// Whether an expression names a measurement, which may take a second.
bool is_measured(const std::string& expression);

/// Whether a word can name a constant: it has the form of a name, and is neither a keyword of Lua nor the name of a
/// mathematical function or constant.
bool is_constant_name(const std::string& word);

}  // namespace viewing
