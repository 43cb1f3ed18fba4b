// The closed list of names that expressions in lesson files may use; `lesson --names` prints it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

enum class NameKind {
    value,       ///< known at once
    measured,    ///< a function whose value may take a second
    mathematics  ///< a function of its arguments alone
};

struct ExpressionName {
    std::string name;
    NameKind kind = NameKind::value;
    std::string form;  ///< "apply(M, p)"
    std::string help;
};

/// Paths of the state first, by their groups, then matrices, measures and mathematics.
const std::vector<ExpressionName>& expression_names();

/// As a text for a terminal, a name a line.
std::string expression_names_as_text();

}  // namespace viewing
