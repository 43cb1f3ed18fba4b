// The closed list of names for expressions in lesson files; `lesson --names` prints it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewing {

enum class NameKind {
    value,       ///< known immediately
    measured,    ///< a function whose value may take a second to compute
    mathematics  ///< a constant, or a function that depends only on its arguments
};

struct ExpressionName {
    std::string name;
    NameKind kind = NameKind::value;
    std::string form;  ///< "apply(M, p)"
    std::string help;
};

/// Returns all names: first those of the state's fields and groups, then those of matrices, measurements and
/// mathematics.
const std::vector<ExpressionName>& expression_names();

/// Returns text for a terminal, one name per line.
std::string expression_names_as_text();

}  // namespace viewing
