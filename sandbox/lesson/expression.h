// The expressions of lesson files: one value, computed by Lua from names of a closed list alone. No files, no libraries
// but the mathematics here, no functions and loops of its own, and an end to time and memory: a file from somebody else
// can do no harm.
// Read names.h for what there is to be named, lesson.h for where expressions stand.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "state/file/document.h"
#include "text/result.h"

namespace viewing {

/// What the names stand for that are not mathematics.
struct Surroundings {
    /// The value of a name of expression_names() of kind `value` or `measured`; `arguments` are those of a function.
    /// Asked only for the names that the expression comes to. The error becomes the expression's.
    std::function<Result<Json>(const std::string& name, std::span<const double> arguments)> look_up;
    Json answer;     ///< what was typed; null before
    Json constants;  ///< an object of names that stand for values, before all others; or null
};

/// What an expression may cost, its value's way out of Lua included.
struct ExpressionLimits {
    int instructions = 1'000'000;  ///< its bytes, memory that is filled and entries of the value count as some, too
    std::size_t memory_bytes = 8U << 20U;
    int measured_call = 20'000;  ///< instructions that each call of a measured name counts as
    bool closed_list = true;     ///< false: statements, functions and any words; only the other limits end it
};

/// The value: a number, a text in UTF-8, true or false, null, or a list of those; vectors are lists, matrices lists of
/// rows. What check_expression refuses has none. The error is one sentence without the expression: no such name, a
/// wrong argument, too long, too much memory.
Result<Json> evaluate(const std::string& expression, const Surroundings& surroundings,
                      const ExpressionLimits& limits = {});

/// The same for what must be true or false.
Result<bool> holds(const std::string& expression, const Surroundings& surroundings,
                   const ExpressionLimits& limits = {});

/// Whether it can be evaluated at all: its syntax, and that its words (by Lua's own tokens, whatever stands in comments
/// and texts) are names that there are. No value is computed.
Status check_expression(const std::string& expression, std::span<const std::string> constants = {});

/// Whether it names something that is measured, which may take a second.
bool is_measured(const std::string& expression);

/// Whether a word can stand for a constant: a letter, then letters, digits and _; no word of Lua's own and no name of
/// the mathematics.
bool is_constant_name(const std::string& word);

}  // namespace viewing
