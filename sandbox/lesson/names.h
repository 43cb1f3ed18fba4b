// The closed list of names for expressions in lesson files; `lesson --names` prints it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

enum class NameKind {
    value,       ///< known immediately
    measured,    ///< a function whose value may take a second
    mathematics  ///< a function that depends only on its arguments
};

struct ExpressionName {
    std::string name;
    NameKind kind = NameKind::value;
    std::string form;  ///< "apply(M, p)"
    std::string help;
};

/// Returns the state's paths first, by group, then matrices, measurements and mathematics.
const std::vector<ExpressionName>& expression_names();

/// Returns text for a terminal, one name per line.
std::string expression_names_as_text();

}  // namespace viewing
