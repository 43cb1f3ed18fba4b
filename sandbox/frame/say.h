// Builds the sentences of problems. Part of problems.h.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "frame/problems.h"
#include "text/message.h"

namespace viewing {

/// A problem's sentence. The singular and the plural of a sentence share an id.
struct Sentence {
    std::string_view id;
    Message message;
};

/// Makes the message as message() does. The id is part of the program's output: never change or reuse one.
template <typename... Values>
Sentence sentence(std::string_view id, fmt::format_string<Values...> english, Values&&... values) {
    return {id, message(english, std::forward<Values>(values)...)};
}

/// Adds problems that concern one group of fields.
class Sayer {
public:
    Sayer(std::vector<Problem>& problems, std::string_view group) : problems_(problems), group_(group) {}

    /// Adds a fact that the user should know, and the setting that changes it; "" if there is none.
    void operator()(bool is_so, Sentence said, std::string_view changed_by = "") {
        add(is_so, std::move(said), ProblemKind::worth_knowing, changed_by);
    }
    /// Adds the reason why a switch breaks the picture. `fixed_by` is the fix: a field whose default value fixes the
    /// picture, or else a complete setting; "" if there is none.
    void broken(bool is_so, Sentence said, std::string_view fixed_by = "") {
        add(is_so, std::move(said), ProblemKind::wrong, fixed_by);
    }
    /// Adds the reason why the window does not show the whole picture.
    void window(bool is_so, Sentence said, std::string_view fixed_by = "") {
        add(is_so, std::move(said), ProblemKind::about_window, fixed_by);
    }

private:
    void add(bool is_so, Sentence said, ProblemKind kind, std::string_view fixed_by);

    std::vector<Problem>& problems_;
    std::string_view group_;
};

/// Returns the setting that moves the near plane without changing the picture: "projection.near=0.5", or one of the
/// whole frustum, with its edges rounded to six digits.
std::string near_setting(ProjectionParams projection, double near);

// Names of lights and planes in a sentence. The parameters count them from 0, the names from 1; `count` is their total
// number.

/// Returns "the light" or "light 2".
Message light_name(std::size_t light, std::size_t count);
/// Returns "the plane", "plane 2" or "planes 2, 3".
Message planes_name(std::span<const std::size_t> planes, std::size_t count);
/// Returns "2, 3".
std::string numbers_name(std::span<const std::size_t> indices);

}  // namespace viewing
