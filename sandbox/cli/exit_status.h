// The exit statuses, which are the same for every command, and the exception that ends a command with one of them.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "text/message.h"
#include "text/result.h"

namespace viewing {

enum class ExitStatus {
    done = 0,
    different = 1,
    bad_input = 2,
    no_context = 3,
    gl_error = 4,
    nan_or_blank = 5,
    reference_missing = 6,
    not_repeatable = 7,
    out_of_time = 8,
    internal_error = 9
};

/// Returns the meaning of a status, as --help lists it.
inline const char* meaning(ExitStatus status) {
    switch (status) {
        case ExitStatus::done:
            return "done, or equal";
        case ExitStatus::different:
            return "compared and different";
        case ExitStatus::bad_input:
            return "bad usage, a bad state, a file that cannot be read or written";
        case ExitStatus::no_context:
            return "no GL context: no display for the window, or no OpenGL 3.3 at all";
        case ExitStatus::gl_error:
            return "GL reported an error";
        case ExitStatus::nan_or_blank:
            return "NaN in the picture, or a blank one with --fail-if-blank";
        case ExitStatus::reference_missing:
            return "the --compare reference is missing";
        case ExitStatus::not_repeatable:
            return "the --repeat pictures are not byte-identical";
        case ExitStatus::out_of_time:
            return "--timeout expired";
        case ExitStatus::internal_error:
            return "an internal error";
    }
    return "";
}

/// The message for std::bad_alloc.
inline constexpr const char* not_enough_memory = "internal error: out of memory";

/// Ends a command with a status and one sentence for the user. Thrown inside cli/ and caught by run_command_line.
struct Failure : std::runtime_error {
    Failure(ExitStatus status_of_failure, const std::string& sentence)
        : std::runtime_error(sentence), status(status_of_failure) {}
    ExitStatus status;
};

/// Returns the value of a result; an error ends the command.
template <typename T>
T value_or_end(Result<T> result, ExitStatus status = ExitStatus::bad_input) {
    if (!result) throw Failure(status, result.error());
    return *std::move(result);
}

/// Ends the command if there is a refusal.
inline void end_if(const Message& refusal) {
    if (!refusal.empty()) throw Failure(ExitStatus::bad_input, say(refusal));
}

}  // namespace viewing
